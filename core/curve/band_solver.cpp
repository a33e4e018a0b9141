// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curve/band_solver.h"

#include <algorithm>

namespace axiscomp {

BandSolver::BandSolver(std::size_t size, bool isRing)
    : m_size(size)
    , m_open(isRing ? size - 2 : size)
    , m_isRing(isRing)
    , m_pivots(m_open)
    , m_first(m_open + 2)
    , m_second(m_open + 2)
    , m_inverse(size)
{
}

bool BandSolver::factorize(const BandMatrix& matrix)
{
    return factorizeOpenPart(matrix) && (!m_isRing || factorizeRing(matrix));
}

bool BandSolver::factorizeOpenPart(const BandMatrix& matrix)
{
    double first = 0.0; // of L, in the row before
    double firstScaled = 0.0;
    double second = 0.0;
    double secondScaled = 0.0; // two rows before
    double smallest = 1.0;
    for (std::size_t i = 0; i < m_open; ++i) {
        const double pivot = matrix.diagonal[i] - first * firstScaled - secondScaled;
        smallest = std::min(smallest, pivot);
        const double inverse = 1.0 / pivot;
        const double nextScaled = i + 1 < m_open ? matrix.nextToIt[i] - firstScaled * second : 0.0;
        const double furtherScaled = i + 2 < m_open ? matrix.secondNext[i] : 0.0;
        secondScaled = second * (i > 0 ? matrix.secondNext[i - 1] : 0.0);
        m_pivots[i] = pivot;
        m_first[i] = nextScaled * inverse;
        m_second[i] = furtherScaled * inverse;
        first = m_first[i];
        firstScaled = nextScaled;
        second = m_second[i];
    }
    return smallest > 0.0;
}

bool BandSolver::factorizeRing(const BandMatrix& matrix)
{
    const std::size_t a = m_size - 2;
    const std::size_t b = m_size - 1;
    for (auto& column : m_border)
        column.assign(m_open, 0.0);
    m_border[0][a - 2] = matrix.secondNext[a - 2];
    m_border[0][a - 1] = matrix.nextToIt[a - 1];
    m_border[0][0] += matrix.secondNext[a];
    m_border[1][a - 1] = matrix.secondNext[a - 1];
    m_border[1][0] += matrix.nextToIt[b];
    m_border[1][1] += matrix.secondNext[b];
    m_solvedBorder = m_border;
    for (auto& column : m_solvedBorder)
        solveOpenPart(column);
    std::array<std::array<double, 2>, 2> schur{
        {{matrix.diagonal[a], matrix.nextToIt[a]}, {matrix.nextToIt[a], matrix.diagonal[b]}}};
    for (std::size_t row = 0; row < 2; ++row)
        for (std::size_t column = 0; column < 2; ++column)
            for (std::size_t i = 0; i < m_open; ++i)
                schur[row][column] -= m_border[row][i] * m_solvedBorder[column][i];
    const double determinant = schur[0][0] * schur[1][1] - schur[0][1] * schur[1][0];
    m_schurInverse = {{{schur[1][1] / determinant, -schur[0][1] / determinant},
        {-schur[1][0] / determinant, schur[0][0] / determinant}}};
    return schur[0][0] > 0.0 && determinant > 0.0;
}

void BandSolver::solveOpenPart(std::vector<double>& x) const
{
    for (std::size_t i = 1; i < m_open; ++i) {
        x[i] -= m_first[i - 1] * x[i - 1];
        if (i > 1)
            x[i] -= m_second[i - 2] * x[i - 2];
    }
    double next = 0.0;
    double further = 0.0;
    for (std::size_t i = m_open; i-- > 0;) {
        x[i] = x[i] / m_pivots[i] - m_first[i] * next - m_second[i] * further;
        further = next;
        next = x[i];
    }
}

void BandSolver::solve(std::vector<double>& x) const
{
    if (!m_isRing) {
        solveOpenPart(x);
        return;
    }
    std::array<double, 2> right{x[m_size - 2], x[m_size - 1]};
    solveOpenPart(x);
    for (std::size_t border = 0; border < 2; ++border)
        for (std::size_t i = 0; i < m_open; ++i)
            right[border] -= m_border[border][i] * x[i];
    for (std::size_t border = 0; border < 2; ++border) {
        const double value =
            m_schurInverse[border][0] * right[0] + m_schurInverse[border][1] * right[1];
        x[m_open + border] = value;
        for (std::size_t i = 0; i < m_open; ++i)
            x[i] -= m_solvedBorder[border][i] * value;
    }
}

void BandSolver::findBandsOfInverse()
{
    double nextDiagonal = 0.0;
    double nextBeside = 0.0;
    double furtherDiagonal = 0.0;
    for (std::size_t i = m_open; i-- > 0;) {
        const double beside = -m_first[i] * nextDiagonal - m_second[i] * nextBeside;
        const double second = -m_first[i] * nextBeside - m_second[i] * furtherDiagonal;
        const double diagonal = 1.0 / m_pivots[i] - m_first[i] * beside - m_second[i] * second;
        m_inverse.nextToIt[i] = beside;
        m_inverse.secondNext[i] = second;
        m_inverse.diagonal[i] = diagonal;
        furtherDiagonal = nextDiagonal;
        nextBeside = beside;
        nextDiagonal = diagonal;
    }
}

double BandSolver::borderInverse(std::size_t row, std::size_t column) const
{
    if (row < m_open)
        std::swap(row, column);
    const auto& schurRow = m_schurInverse[row - m_open];
    if (column >= m_open)
        return schurRow[column - m_open];
    return -schurRow[0] * m_solvedBorder[0][column] - schurRow[1] * m_solvedBorder[1][column];
}

void BandSolver::addRingToInverse()
{
    const auto added = [this](std::size_t i, std::size_t k) {
        double sum = 0.0;
        for (std::size_t row = 0; row < 2; ++row)
            for (std::size_t column = 0; column < 2; ++column)
                sum += m_solvedBorder[row][i] * m_schurInverse[row][column]
                    * m_solvedBorder[column][k];
        return sum;
    };
    for (std::size_t i = 0; i < m_size; ++i) {
        const auto complete = [&](double& element, std::size_t beside) {
            const std::size_t k = (i + beside) % m_size;
            if (i >= m_open || k >= m_open)
                element = borderInverse(i, k);
            else
                element += added(i, k);
        };
        complete(m_inverse.diagonal[i], 0);
        complete(m_inverse.nextToIt[i], 1);
        complete(m_inverse.secondNext[i], 2);
    }
}

double BandSolver::traceOfInverseTimes(const BandMatrix& other)
{
    findBandsOfInverse();
    if (m_isRing)
        addRingToInverse();
    double onDiagonal = 0.0;
    double beside = 0.0;
    for (std::size_t i = 0; i < m_size; ++i) {
        onDiagonal += m_inverse.diagonal[i] * other.diagonal[i];
        beside += m_inverse.nextToIt[i] * other.nextToIt[i]
            + m_inverse.secondNext[i] * other.secondNext[i];
    }
    return onDiagonal + 2.0 * beside;
}

} // namespace axiscomp
