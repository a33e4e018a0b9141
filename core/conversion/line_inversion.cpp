// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/line_inversion.h"
#include "core/conversion/conversion_errors.h"
#include "core/conversion/shared_lines.h"

#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>

namespace axiscomp {

namespace {

double offsetAt(const NeutralTable& table, const Mover& mover, std::size_t index)
{
    double sum = 0.0;
    for (const Mover::Part& part : mover.parts)
        sum += part.factor * table.columns[part.column].values[index];
    return sum;
}

/// A slope of a mover along an axis.
struct Slope {
    double size = 0.0;
    std::size_t index = 0; ///< the point behind which it is met
};

Slope largestSlope(const NeutralTable& table, const Mover& mover, std::size_t axis)
{
    const std::vector<double>& knots = table.axes[axis].knots;
    const std::size_t stride = strideOf(table, axis);
    Slope largest;
    for (std::size_t index = 0; index < table.pointCount(); ++index) {
        const std::size_t knot = index / stride % knots.size();
        if (knot + 1 == knots.size())
            continue;
        const double rise = offsetAt(table, mover, index + stride) - offsetAt(table, mover, index);
        const double size = std::abs(rise) / (knots[knot + 1] - knots[knot]);
        if (!(size <= largest.size))
            largest = {size, index};
    }
    return largest;
}

/// On a modulo axis a correction must be the same at both ends, but for rounding: it repeats.
Result<void> checkClosed(const NeutralTable& table, const Mover& mover, std::size_t axis)
{
    if (!table.axes[axis].wrap)
        return {};
    const std::size_t stride = strideOf(table, axis);
    const std::size_t count = table.axes[axis].knots.size();
    double largest = 0.0;
    for (std::size_t index = 0; index < table.pointCount(); ++index)
        largest = std::max(largest, std::abs(offsetAt(table, mover, index)));
    constexpr double rounding = 1e-9;
    for (std::size_t first = 0; first < table.pointCount(); ++first) {
        if (first / stride % count != 0)
            continue;
        const double begin = offsetAt(table, mover, first);
        const double end = offsetAt(table, mover, first + (count - 1) * stride);
        if (std::abs(end - begin) <= rounding * largest)
            continue;
        const std::string& unit = table.axes[mover.axis].unit;
        return notConvertible(table, knotPosition(table, first),
            AXISCOMP_TEXT("Error",
                "a full turn of {axis} begins with the correction {begin} and ends with {end}; "
                "make both the same, or treat the axis as linear (--no-wrap, in a machine file "
                "no-wrap = true)")
                .with("axis", axisText(table, axis))
                .with("begin", quantityOf(begin, unit))
                .with("end", quantityOf(end, unit)));
    }
    return {};
}

/// What is wrong with a line that has a fault.
tl::unexpected<Error> faultOf(const NeutralTable& table, const Mover& mover, std::size_t first)
{
    const SourceAxis& axis = table.axes[mover.axis];
    const LineInversion line(table, mover, first);
    const std::size_t knot = line.fault().value_or(0);
    const std::size_t next = (knot + 1) % axis.knots.size();
    const Position position = knotPosition(table, first + knot * strideOf(table, mover.axis));
    if (!std::isfinite(line.sum(knot)) || !std::isfinite(line.sum(next)))
        return notConvertible(table, position,
            AXISCOMP_TEXT("Error", "the numbers are too large to be added to each other"));
    return notConvertible(table, position,
        AXISCOMP_TEXT("Error",
            "from there to {place} the correction changes by {change}, so that positions "
            "would change their order; check the unit of the values")
            .with("place", quantityOf(axis.knots[next], axis.unit))
            .with("change", quantityOf(line.offset(next) - line.offset(knot), axis.unit)));
}

/// By how much a mover moves its axis at most.
double largestOffset(const NeutralTable& table, const Mover& mover)
{
    double largest = 0.0;
    for (std::size_t index = 0; index < table.pointCount(); ++index)
        largest = std::max(largest, std::abs(offsetAt(table, mover, index)));
    return largest;
}

/// The table with a knot more at both ends of each axis that moves, where it goes on linearly.
NeutralTable extended(
    const NeutralTable& table, const std::vector<Mover>& movers, const Position& rooms)
{
    NeutralTable wide = table;
    for (const Mover& mover : movers) {
        std::vector<double>& knots = wide.axes[mover.axis].knots;
        if (wide.axes[mover.axis].wrap)
            continue;
        knots.insert(knots.begin(), knots.front() - rooms[mover.axis]);
        knots.push_back(knots.back() + rooms[mover.axis]);
    }
    for (std::size_t n = 0; n < table.columns.size(); ++n) {
        const ControllerLookup applied(table, n, {.outside = Outside::Extrapolate});
        std::vector<double> values(wide.pointCount());
        for (std::size_t index = 0; index < values.size(); ++index) {
            const Position position = knotPosition(wide, index);
            values[index] = applied.at(std::span(position).first(wide.axes.size()));
        }
        wide.columns[n].values = std::move(values);
    }
    return wide;
}

/// The leading principal minors of 1 - slopes.
bool contracts(const SlopeMatrix& slopes)
{
    SlopeMatrix d{};
    for (std::size_t n = 0; n < 3; ++n)
        for (std::size_t m = 0; m < 3; ++m)
            d[n][m] = (n == m ? 1.0 : 0.0) - slopes[n][m];
    const double second = d[0][0] * d[1][1] - d[0][1] * d[1][0];
    const double third = d[0][0] * (d[1][1] * d[2][2] - d[1][2] * d[2][1])
        - d[0][1] * (d[1][0] * d[2][2] - d[1][2] * d[2][0])
        + d[0][2] * (d[1][0] * d[2][1] - d[1][1] * d[2][0]);
    return d[0][0] > 0.0 && second > 0.0 && third > 0.0;
}

/// With as much beyond the knots as the places of all knots can need: no correction within is
/// larger than the room.
Result<SlopeMatrix> checkBeyondTheKnots(const NeutralTable& table, const std::vector<Mover>& movers)
{
    Position rooms{};
    for (const Mover& mover : movers) {
        const std::vector<double>& knots = table.axes[mover.axis].knots;
        constexpr double little = 1e-3; // of a cell, where nothing moves
        rooms[mover.axis] =
            std::max(2.0 * largestOffset(table, mover), little * (knots[1] - knots[0]));
    }
    constexpr int mostSteps = 40;
    for (int step = 0;; ++step) {
        const NeutralTable wide = extended(table, movers, rooms);
        // Too steep with less room is too steep with more.
        AXISCOMP_TRY(const auto slopes, checkContraction(wide, movers));
        bool isEnough = true;
        for (const Mover& mover : movers) {
            const double needed = largestOffset(wide, mover);
            if (needed <= rooms[mover.axis])
                continue;
            isEnough = false;
            rooms[mover.axis] = 2.0 * needed;
        }
        if (isEnough || step == mostSteps)
            return slopes;
    }
}

} // namespace

LineInversion::LineInversion(
    const NeutralTable& table, const Mover& mover, std::size_t first, Outside outside)
    : m_axis(table.axes[mover.axis])
    , m_first(first)
    , m_stride(strideOf(table, mover.axis))
    , m_goesOn(outside == Outside::Extrapolate && !m_axis.wrap)
    , m_places(m_axis.knots)
{
    const std::size_t count = m_axis.knots.size();
    m_offsets.resize(count);
    m_sums.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        m_offsets[i] = offsetAt(table, mover, first + i * m_stride);
        m_sums[i] = m_places[i] + m_offsets[i];
    }
    if (m_axis.wrap && !isFullTurn(m_axis)) {
        m_places.push_back(m_places.front() + *m_axis.wrap);
        m_sums.push_back(m_places.back() + m_offsets.front());
    }
    m_search.emplace(m_sums);
}

std::optional<std::size_t> LineInversion::fault() const
{
    for (std::size_t i = 0; i + 1 < m_sums.size(); ++i)
        if (!(m_sums[i + 1] > m_sums[i]))
            return i;
    return std::nullopt;
}

LineInversion::Place LineInversion::placeOf(double sum) const
{
    if (m_axis.wrap) {
        const double turns = std::floor((sum - m_sums.front()) / *m_axis.wrap);
        sum -= turns * *m_axis.wrap;
    }
    if (sum <= m_sums.front() && !m_goesOn)
        return {0, 0.0, sum - m_offsets.front()};
    if (sum >= m_sums.back() && !m_goesOn)
        return {m_offsets.size() - 1, 0.0, sum - m_offsets.back()};
    const std::size_t above = m_search->firstAbove(sum);
    const std::size_t i = std::clamp<std::size_t>(above, 1, m_sums.size() - 1) - 1;
    const double fraction = (sum - m_sums[i]) / (m_sums[i + 1] - m_sums[i]);
    return {i, fraction, m_places[i] + fraction * (m_places[i + 1] - m_places[i])};
}

double LineInversion::valueAt(const std::vector<double>& values, const Place& place) const
{
    const double value = values[m_first + place.knot * m_stride];
    const bool isBehindLast = place.knot + 1 >= m_offsets.size(); // between two turns
    if (place.fraction == 0.0 || isBehindLast)
        return value;
    return value + place.fraction * (values[m_first + (place.knot + 1) * m_stride] - value);
}

Result<void> checkInvertible(const NeutralTable& table, const Mover& mover)
{
    if (auto fine = checkClosed(table, mover, mover.axis); !fine)
        return fine;
    // The first line of each part with a fault, and of these the first.
    const TableLines lines(table, mover.axis);
    std::vector<std::optional<std::size_t>> faults(lines.parts());
    shareLines(lines, [&](std::size_t part, std::size_t line) {
        if (!faults[part] && LineInversion(table, mover, lines.first(line)).fault())
            faults[part] = line;
    });
    for (const auto& fault : faults)
        if (fault)
            return faultOf(table, mover, lines.first(*fault));
    return {};
}

Result<SlopeMatrix> checkContraction(
    const NeutralTable& table, const std::vector<Mover>& movers, Outside outside)
{
    if (outside == Outside::Extrapolate) {
        AXISCOMP_CHECK(checkContraction(table, movers));
        return checkBeyondTheKnots(table, movers);
    }
    SlopeMatrix slopes{};
    Slope steepest;
    std::size_t row = 0;
    for (const Mover& mover : movers) {
        for (const Mover& moved : movers) {
            AXISCOMP_CHECK(checkClosed(table, mover, moved.axis));
            const Slope slope = largestSlope(table, mover, moved.axis);
            slopes[mover.axis][moved.axis] = slope.size;
            if (!(slope.size <= steepest.size)) {
                steepest = slope;
                row = mover.axis;
            }
        }
    }
    if (contracts(slopes))
        return slopes;
    return notConvertible(table, knotPosition(table, steepest.index),
        AXISCOMP_TEXT("Error",
            "the correction of {axis} changes by {change} for each unit of the way, too much for "
            "several axes that are corrected together; check the unit of the values")
            .with("axis", axisText(table, row))
            .with("change", Quantity{roundedText(steepest.size)}));
}

} // namespace axiscomp
