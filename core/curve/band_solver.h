// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <vector>

namespace axiscomp {

/// A symmetric matrix with two bands beside its diagonal, closed to a ring where these lead from
/// its end to its beginning: nextToIt[i] couples i and i + 1, secondNext[i] couples i and i + 2,
/// modulo the size. Of an open matrix the last ones are 0.
struct BandMatrix {
    std::vector<double> diagonal;
    std::vector<double> nextToIt;
    std::vector<double> secondNext;

    explicit BandMatrix(std::size_t size = 0) : diagonal(size), nextToIt(size), secondNext(size) { }
    [[nodiscard]] std::size_t size() const { return diagonal.size(); }
};

/// L D L^T of a positive definite BandMatrix, in a time proportional to its size. The last two rows
/// of a ring are eliminated apart (Schur complement); it needs 5 rows at least.
class BandSolver {
public:
    BandSolver(std::size_t size, bool isRing);

    /// False when the matrix is not positive definite to the precision of doubles.
    [[nodiscard]] bool factorize(const BandMatrix& matrix);
    void solve(std::vector<double>& x) const;
    /// The trace of inverse times other, by the bands of the inverse (Hutchinson and de Hoog 1985).
    [[nodiscard]] double traceOfInverseTimes(const BandMatrix& other);

private:
    [[nodiscard]] bool factorizeOpenPart(const BandMatrix& matrix);
    [[nodiscard]] bool factorizeRing(const BandMatrix& matrix);
    void solveOpenPart(std::vector<double>& x) const;
    void findBandsOfInverse();
    void addRingToInverse();
    /// An element of the inverse of a ring whose row or column is one of the last two.
    [[nodiscard]] double borderInverse(std::size_t row, std::size_t column) const;

    std::size_t m_size;
    std::size_t m_open; ///< rows that are not eliminated apart
    bool m_isRing;
    std::vector<double> m_pivots;
    std::vector<double> m_first; ///< L(i + 1, i)
    std::vector<double> m_second; ///< L(i + 2, i)
    BandMatrix m_inverse;
    std::array<std::vector<double>, 2> m_border; ///< columns of the last two rows
    std::array<std::vector<double>, 2> m_solvedBorder;
    std::array<std::array<double, 2>, 2> m_schurInverse{};
};

} // namespace axiscomp
