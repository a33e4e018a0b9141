// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/sign_conversion.h"
#include "core/conversion/conversion_errors.h"

#include "core/conversion/line_inversion.h"
#include "core/conversion/shared_lines.h"
#include "core/neutral/table_motion.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>

namespace axiscomp {

namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();
class SignConverter {
public:
    SignConverter(const NeutralTable& source, const TableBehaviour& behaviour)
        : m_source(source)
        , m_behaviour(behaviour)
        , m_ends{.outside = behaviour.outside == Outside::Extrapolate ? Outside::Extrapolate
                                                                      : Outside::Hold}
    {
        m_result.table = source;
    }

    [[nodiscard]] Result<SignConversion> run(SignConvention to, ConvertedKnots knots);

private:
    [[nodiscard]] bool mayMoveKnots(ConvertedKnots knots) const;
    /// Whether it was possible, and was done.
    [[nodiscard]] Result<bool> moveKnots(ConvertedKnots knots);
    [[nodiscard]] Result<void> convert(Direction direction);
    void negate(const std::vector<std::size_t>& columns);
    void convertLines(const Mover& mover, const std::vector<std::size_t>& columns);
    [[nodiscard]] Result<void> convertJointly(
        const std::vector<Mover>& movers, const std::vector<std::size_t>& columns);
    /// mostNeeded: raised to the number of iterations that it took.
    [[nodiscard]] Result<Position> fixedPoint(const Motion& motion, const SlopeMatrix& slopes,
        const Position& knot, int& mostNeeded) const;
    /// Whether a place is where the source's controller applies nothing.
    [[nodiscard]] bool needsHeldEnds(std::size_t axis, double place) const;
    [[nodiscard]] Result<double> largestResidual() const;
    /// On one line.
    [[nodiscard]] double residualAlong(const ControllerLookup& applied, std::size_t column,
        const std::vector<Mover>& movers, const TableLines& lines, std::size_t line) const;

    const NeutralTable& m_source;
    TableBehaviour m_behaviour;
    /// What the source says between and beyond its knots: where its controller applies nothing out
    /// there, the ends are held.
    TableBehaviour m_ends;
    SignConversion m_result;
};

bool SignConverter::mayMoveKnots(ConvertedKnots knots) const
{
    return knots != ConvertedKnots::Same && m_source.axes.size() == 1 && !m_source.axes[0].wrap
        && std::ranges::all_of(m_source.columns,
            [](const CompensationColumn& column) { return column.direction == Direction::Both; });
}

Result<bool> SignConverter::moveKnots(ConvertedKnots knots)
{
    if (!mayMoveKnots(knots))
        return false;
    AXISCOMP_TRY(const auto movers, moversOf(m_source, ownAxesOf(m_source), Direction::Both));
    if (movers.size() != 1)
        return false;
    AXISCOMP_CHECK(checkInvertible(m_source, movers.front()));
    const LineInversion line(m_source, movers.front(), 0);
    SourceAxis moved = m_source.axes[0];
    moved.step = 0.0;
    for (std::size_t i = 0; i < moved.knots.size(); ++i)
        moved.knots[i] = line.sum(i);
    if (knots == ConvertedKnots::ExactIfEven && !isEven(moved))
        return false;
    m_result.table.axes[0] = std::move(moved);
    std::vector<std::size_t> all(m_source.columns.size());
    std::iota(all.begin(), all.end(), std::size_t{0});
    negate(all);
    return true;
}

Result<SignConversion> SignConverter::run(SignConvention to, ConvertedKnots knots)
{
    AXISCOMP_CHECK(checkConsistent(m_source));
    if (m_source.sign == to)
        return std::move(m_result);
    AXISCOMP_CHECK(checkTargets(m_source));
    AXISCOMP_TRY(const bool isMoved, moveKnots(knots));
    if (!isMoved)
        for (const Direction direction :
            {Direction::Both, Direction::Positive, Direction::Negative})
            AXISCOMP_CHECK(convert(direction));
    m_result.table.sign = to;
    AXISCOMP_TRY(const auto residual, largestResidual());
    m_result.residual = residual;
    return std::move(m_result);
}

Result<void> SignConverter::convert(Direction direction)
{
    std::vector<std::size_t> columns;
    for (std::size_t i = 0; i < m_source.columns.size(); ++i)
        if (m_source.columns[i].direction == direction)
            columns.push_back(i);
    AXISCOMP_TRY(const auto movers, moversOf(m_source, ownAxesOf(m_source), direction));
    if (columns.empty())
        return {};
    if (movers.empty()) {
        negate(columns);
        return {};
    }
    for (const Mover& mover : movers)
        if (auto fine = checkInvertible(m_source, mover); !fine)
            return fine;
    if (movers.size() > 1)
        return convertJointly(movers, columns);
    convertLines(movers.front(), columns);
    return {};
}

void SignConverter::negate(const std::vector<std::size_t>& columns)
{
    for (const std::size_t column : columns)
        for (double& value : m_result.table.columns[column].values)
            value = 0.0 - value; // no negative zero
}

bool SignConverter::needsHeldEnds(std::size_t axis, double place) const
{
    const SourceAxis& source = m_source.axes[axis];
    const double rounding = 8.0 * epsilon * std::abs(place);
    const bool isBefore = place < source.knots.front() - rounding;
    const bool isBehind = place > source.knots.back() + rounding;
    const bool needsZero = m_behaviour.outside == Outside::Zero;
    return !source.wrap
        && ((isBefore && (needsZero || m_behaviour.startsAtFirst)) || (isBehind && needsZero));
}

void SignConverter::convertLines(const Mover& mover, const std::vector<std::size_t>& columns)
{
    const SourceAxis& axis = m_source.axes[mover.axis];
    const bool isClosed = isFullTurn(axis);
    const TableLines lines(m_source, mover.axis);
    std::atomic<bool> usesHeldEnds = false;
    const auto convertLine = [&](std::size_t first) {
        const LineInversion line(m_source, mover, first, m_ends.outside);
        bool heldEnds = false;
        for (std::size_t i = 0; i < lines.length; ++i) {
            const LineInversion::Place place =
                line.placeOf(axis.knots[isClosed ? i % (lines.length - 1) : i]);
            heldEnds = heldEnds || needsHeldEnds(mover.axis, place.position);
            for (const std::size_t column : columns)
                m_result.table.columns[column].values[first + i * lines.stride] =
                    0.0 - line.valueAt(m_source.columns[column].values, place);
        }
        if (heldEnds)
            usesHeldEnds = true;
    };
    shareLines(lines, [&](std::size_t, std::size_t line) { convertLine(lines.first(line)); });
    m_result.usesHeldEnds = m_result.usesHeldEnds || usesHeldEnds;
}

Result<Position> SignConverter::fixedPoint(
    const Motion& motion, const SlopeMatrix& slopes, const Position& knot, int& mostNeeded) const
{
    constexpr int mostIterations = 5000;
    const std::size_t dimensions = m_source.axes.size();
    Position place = knot;
    for (int iteration = 1; iteration <= mostIterations; ++iteration) {
        const Position offset = motion.offset(std::span(place).first(dimensions));
        bool isSettled = true;
        for (std::size_t n = 0; n < dimensions; ++n) {
            const double next = knot[n] - offset[n];
            double size = std::abs(knot[n]) + std::abs(offset[n]);
            for (std::size_t m = 0; m < dimensions; ++m)
                size += slopes[n][m] * (std::abs(knot[m]) + std::abs(offset[m]));
            const double rounding = 4.0 * epsilon * size;
            isSettled = isSettled && std::abs(next - place[n]) <= rounding;
            place[n] = next;
        }
        mostNeeded = std::max(mostNeeded, iteration);
        if (isSettled)
            return place;
    }
    return notConvertible(m_source, knot,
        AXISCOMP_TEXT("Error",
            "the corrections are so steep that {count} steps do not find the place that belongs to "
            "it; check the unit of the values")
            .with("count", mostIterations));
}

Result<void> SignConverter::convertJointly(
    const std::vector<Mover>& movers, const std::vector<std::size_t>& columns)
{
    AXISCOMP_TRY(const auto slopes, checkContraction(m_source, movers, m_ends.outside));
    const Motion motion(m_source, m_ends, movers);
    std::vector<ControllerLookup> applied;
    for (const std::size_t column : columns)
        applied.emplace_back(m_source, column, m_ends);
    struct Part {
        int iterations = 0;
        bool usesHeldEnds = false;
        std::optional<Error> error;
    };
    const auto convertPoint = [&](std::size_t index, Part& part) {
        const auto place =
            fixedPoint(motion, slopes, knotPosition(m_source, index), part.iterations);
        if (!place) {
            part.error = place.error();
            return;
        }
        for (const Mover& mover : movers)
            part.usesHeldEnds =
                part.usesHeldEnds || needsHeldEnds(mover.axis, (*place)[mover.axis]);
        for (std::size_t i = 0; i < columns.size(); ++i)
            m_result.table.columns[columns[i]].values[index] =
                0.0 - applied[i].at(std::span(*place).first(m_source.axes.size()));
    };
    const TableLines lines(m_source, 0);
    std::vector<Part> parts(lines.parts());
    shareLines(lines, [&](std::size_t part, std::size_t line) {
        for (std::size_t i = 0; i < lines.length && !parts[part].error; ++i)
            convertPoint(lines.first(line) + i, parts[part]);
    });
    for (const Part& part : parts) {
        if (part.error)
            return tl::unexpected(*part.error);
        m_result.iterations = std::max(m_result.iterations, part.iterations);
        m_result.usesHeldEnds = m_result.usesHeldEnds || part.usesHeldEnds;
    }
    return {};
}

double SignConverter::residualAlong(const ControllerLookup& applied, std::size_t column,
    const std::vector<Mover>& movers, const TableLines& lines, std::size_t line) const
{
    const NeutralTable& table = m_result.table;
    const std::size_t axis = movers.empty() ? 0 : movers.front().axis;
    const std::size_t first = lines.first(line);
    Position place = knotPosition(table, first);
    const auto used = std::span<const double>(place).first(table.axes.size());
    const ControllerLookup::Line source = applied.along(axis, used);
    double largest = 0.0;
    for (std::size_t i = 0; i < lines.length; ++i) {
        const std::size_t index = first + i * lines.stride;
        place = movers.size() > 1 ? knotPosition(table, index) : place;
        place[axis] = table.axes[axis].knots[i];
        for (const Mover& mover : movers)
            for (const Mover::Part& part : mover.parts)
                place[mover.axis] += part.factor * table.columns[part.column].values[index];
        const double found = movers.size() > 1 ? applied.at(used) : source.at(place[axis]);
        largest = std::max(largest, std::abs(table.columns[column].values[index] + found));
    }
    return largest;
}

/// Found in another way than the values are: by applying both tables.
Result<double> SignConverter::largestResidual() const
{
    const OwnAxes ownAxes = ownAxesOf(m_source);
    double largest = 0.0;
    for (std::size_t i = 0; i < m_result.table.columns.size(); ++i) {
        AXISCOMP_TRY(
            const auto movers, moversOf(m_source, ownAxes, m_result.table.columns[i].direction));
        const ControllerLookup applied(m_source, i, m_ends);
        const TableLines lines(m_result.table, movers.empty() ? 0 : movers.front().axis);
        std::vector<double> residuals(lines.parts());
        shareLines(lines, [&](std::size_t part, std::size_t line) {
            residuals[part] =
                std::max(residuals[part], residualAlong(applied, i, movers, lines, line));
        });
        largest = std::max(largest, std::ranges::max(residuals));
    }
    return largest;
}

} // namespace

Result<SignConversion> convertSign(const NeutralTable& table, SignConvention to,
    const TableBehaviour& behaviour, ConvertedKnots knots)
{
    return SignConverter(table, behaviour).run(to, knots);
}

} // namespace axiscomp
