// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/resampling/resampling.h"
#include "core/conversion/resampling/resampling_errors.h"
#include "core/neutral/table_motion.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <limits>

namespace axiscomp {

namespace {

/// What rounding makes of computed positions within a range.
double roundingOf(double from, double to)
{
    return 8.0 * std::numeric_limits<double>::epsilon() * std::max(std::abs(from), std::abs(to));
}

/// A grid that meets the source's knots takes them over, so that no number changes.
void takeOverKnots(PlannedAxis& plan, const SourceAxis& axis)
{
    if (plan.knots.size() != axis.knots.size())
        return;
    const double rounding = roundingOf(axis.knots.front(), axis.knots.back());
    for (std::size_t i = 0; i < plan.knots.size(); ++i)
        if (!(std::abs(plan.knots[i] - axis.knots[i]) <= rounding))
            return;
    plan.knots = axis.knots;
    plan.isKept = true;
}

class AxisPlanner {
public:
    AxisPlanner(const NeutralTable& table, std::size_t axis, const AxisRequest& request)
        : m_axis(table.axes[axis])
        , m_name(axisText(table, axis))
        , m_request(request)
        , m_from(request.start.value_or(m_axis.knots.front()))
        , m_to(request.end.value_or(m_axis.wrap ? m_from + *m_axis.wrap : m_axis.knots.back()))
        , m_rounding(roundingOf(m_axis.knots.front(), m_axis.knots.back()))
    {
    }

    [[nodiscard]] Result<PlannedAxis> plan(bool holdsEnds) const
    {
        AXISCOMP_CHECK(checkRequest());
        if (m_request.points == 0 && m_request.distance == 0.0)
            return kept();
        AXISCOMP_CHECK(checkRange(holdsEnds));
        auto planned = m_request.points > 0
            ? Result<PlannedAxis>(planPoints(m_axis, m_from, m_to, m_request.points))
            : byDistance(holdsEnds);
        // as pointsAreDistinct has it: closer points are one place for a controller
        if (planned && !(planned->grid.distance > 4.0 * roundingOf(m_from, m_to)))
            return resamplingImpossible(about(AXISCOMP_TEXT("Error",
                "the points along {axis} would be so close that positions cannot tell them apart; "
                "take fewer")));
        return planned;
    }

private:
    [[nodiscard]] Quantity quantity(double position) const
    {
        return quantityOf(position, m_axis.unit);
    }
    /// With the axis and the wanted grid, of which every sentence says something.
    [[nodiscard]] Text about(const TextPattern& pattern) const
    {
        return pattern.with("axis", m_name)
            .with("from", quantity(m_from))
            .with("to", quantity(m_to))
            .with("distance", quantity(m_request.distance));
    }
    [[nodiscard]] Result<void> checkRequest() const;
    [[nodiscard]] Result<void> checkRange(bool holdsEnds) const;
    [[nodiscard]] Result<PlannedAxis> kept() const;
    [[nodiscard]] Result<PlannedAxis> byDistance(bool holdsEnds) const;
    [[nodiscard]] Result<PlannedAxis> otherEnd(double cells, bool holdsEnds) const;

    const SourceAxis& m_axis;
    Text m_name;
    const AxisRequest& m_request;
    double m_from;
    double m_to;
    double m_rounding;
};

Result<void> AxisPlanner::checkRequest() const
{
    const double distance = m_request.distance;
    if (m_request.points > 0 && distance != 0.0)
        return invalidArgument(about(
            AXISCOMP_TEXT("Error", "for {axis} both a number of points and a distance are given")));
    if (m_request.points == 1)
        return invalidArgument(
            about(AXISCOMP_TEXT("Error", "a grid along {axis} needs at least two points")));
    if (!std::isfinite(distance) || distance < 0.0)
        return invalidArgument(
            about(AXISCOMP_TEXT("Error", "the distance along {axis} must be a number above 0")));
    if (!std::isfinite(m_from) || !std::isfinite(m_to) || !std::isfinite(m_to - m_from)
        || !(m_to - m_from > m_rounding))
        return invalidArgument(about(AXISCOMP_TEXT("Error",
            "the grid along {axis} must end above its start, not go from {from} to {to}")));
    if (m_request.points > mostGridPoints)
        return resamplingImpossible(
            about(AXISCOMP_TEXT("Error", "{count} points along {axis} are more than {most}"))
                .with("count", m_request.points)
                .with("most", mostGridPoints));
    const bool asksRange = m_request.start || m_request.end;
    if (m_request.points == 0 && distance == 0.0 && asksRange)
        return invalidArgument(about(AXISCOMP_TEXT(
            "Error", "for a part of {axis} a number of points or a distance is needed")));
    return {};
}

Result<void> AxisPlanner::checkRange(bool holdsEnds) const
{
    if (m_axis.wrap) {
        if (std::abs(m_to - m_from - *m_axis.wrap) > m_rounding + roundingOf(m_from, m_to))
            return invalidArgument(
                about(AXISCOMP_TEXT("Error",
                          "the grid along {axis} must be one full turn, from {from} to {to}"))
                    .with("to", quantity(m_from + *m_axis.wrap)));
        return {};
    }
    if (!holdsEnds && m_from < m_axis.knots.front() - m_rounding)
        return resamplingImpossible(about(AXISCOMP_TEXT("Error",
                                              "the grid along {axis} begins at {from}, before the "
                                              "data at {data}; stay within the "
                                              "data, or let the end values be held"))
                                        .with("data", quantity(m_axis.knots.front())));
    if (!holdsEnds && m_to > m_axis.knots.back() + m_rounding)
        return resamplingImpossible(about(AXISCOMP_TEXT("Error",
                                              "the grid along {axis} ends at {to}, behind the data "
                                              "at {data}; stay within the data, "
                                              "or let the end values be held"))
                                        .with("data", quantity(m_axis.knots.back())));
    return {};
}

Result<PlannedAxis> AxisPlanner::kept() const
{
    if (!isEven(m_axis))
        return invalidArgument(about(AXISCOMP_TEXT("Error",
            "the positions of {axis} are not evenly spaced; give a number of points or a "
            "distance")));
    const double first = m_axis.knots.front();
    const double last = m_axis.knots.back();
    const std::size_t size = m_axis.knots.size();
    return PlannedAxis{
        {first, evenDistance(first, last, size), size}, m_axis.knots, first, last, true, {}};
}

Result<PlannedAxis> AxisPlanner::byDistance(bool holdsEnds) const
{
    constexpr double allowance = 1e-9; // of a distance
    const double cells = (m_to - m_from) / m_request.distance;
    if (!(cells < static_cast<double>(mostGridPoints)))
        return resamplingImpossible(
            about(AXISCOMP_TEXT("Error",
                      "a distance of {distance} along {axis} makes more than {count} points"))
                .with("count", mostGridPoints));
    const double whole = std::round(cells);
    if (whole < 1.0 || std::abs(cells - whole) > allowance)
        return otherEnd(cells, holdsEnds);
    return planPoints(m_axis, m_from, m_to, static_cast<std::size_t>(whole) + 1);
}

/// The distance does not divide the range.
Result<PlannedAxis> AxisPlanner::otherEnd(double cells, bool holdsEnds) const
{
    if (m_axis.wrap) {
        const double fewer = std::max(1.0, std::floor(cells));
        return resamplingImpossible(about(
            AXISCOMP_TEXT("Error",
                "the full turn of {axis}, {turn}, is no whole multiple of {distance}; possible are "
                "{fewer} or {more}"))
                                        .with("turn", quantity(*m_axis.wrap))
                                        .with("fewer", quantity(*m_axis.wrap / (fewer + 1.0)))
                                        .with("more", quantity(*m_axis.wrap / fewer)));
    }
    const double count = holdsEnds ? std::ceil(cells) : std::floor(cells);
    if (count < 1.0)
        return resamplingImpossible(about(AXISCOMP_TEXT("Error",
            "a distance of {distance} is longer than the range of {axis} from {from} to {to}; take "
            "a shorter one, or let the end values be held")));
    PlannedAxis plan;
    plan.grid = {m_from, m_request.distance, static_cast<std::size_t>(count) + 1};
    for (std::size_t i = 0; i < plan.grid.size; ++i)
        plan.knots.push_back(m_from + static_cast<double>(i) * m_request.distance);
    plan.from = m_from;
    plan.to = m_to;
    const double end = plan.knots.back();
    plan.isShort = !holdsEnds;
    plan.remark = (holdsEnds
            ? AXISCOMP_TEXT("Error", "{range}: the grid ends at {end}, {distance} behind it")
            : AXISCOMP_TEXT("Error", "{range}: the grid ends at {end}, {distance} before its end"))
                      .with("range",
                          about(AXISCOMP_TEXT("Error",
                              "the range of {axis} from {from} to {to} is no whole multiple of "
                              "{distance}")))
                      .with("end", quantity(end))
                      .with("distance", quantity(std::abs(end - m_to)));
    return plan;
}

} // namespace

double evenDistance(double from, double to, std::size_t points)
{
    const auto cells = static_cast<double>(points - 1);
    const double distance = (to - from) / cells;
    // the number that a person would give, where it leads to the same end
    constexpr int digits = 12;
    std::array<char, 32> buffer{};
    const auto written = std::to_chars(
        buffer.data(), buffer.data() + buffer.size(), distance, std::chars_format::general, digits);
    double plain = 0.0;
    std::from_chars(buffer.data(), written.ptr, plain);
    return std::abs(from + cells * plain - to) <= roundingOf(from, to) / 2.0 ? plain : distance;
}

PlannedAxis planPoints(const SourceAxis& axis, double from, double to, std::size_t points)
{
    PlannedAxis plan;
    plan.grid = {from, evenDistance(from, to, points), points};
    plan.from = from;
    plan.to = to;
    for (std::size_t i = 0; i + 1 < points; ++i)
        plan.knots.push_back(from + static_cast<double>(i) * plan.grid.distance);
    plan.knots.push_back(to);
    takeOverKnots(plan, axis);
    return plan;
}

Result<PlannedAxis> planAxis(
    const NeutralTable& table, std::size_t axis, const AxisRequest& request, bool holdsEnds)
{
    return AxisPlanner(table, axis, request).plan(holdsEnds);
}

} // namespace axiscomp
