// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/lookup_frame.h"

#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axiscomp {

namespace {

Result<void> checkTable(const ActiveTable& active, std::size_t dimensions)
{
    if (!active.table)
        return {};
    const Grid& grid = active.table->grid;
    const bool isConsistent = grid.axes.size() == dimensions
        && active.table->values.size() == grid.pointCount()
        && std::ranges::all_of(grid.axes, [](const GridAxis& axis) { return axis.size >= 2; });
    if (!isConsistent)
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "the table that was active has other sources than the table that is made")}});
    return {};
}

/// Along its own axis a position and its correction together must increase, or one target would
/// have several places.
Result<void> checkIncreasing(const ActiveTable& active, std::size_t axis)
{
    if (!active.table)
        return {};
    const Grid& grid = active.table->grid;
    std::size_t stride = 1;
    for (std::size_t n = 0; n < axis; ++n)
        stride *= grid.axes[n].size;
    const GridAxis& along = grid.axes[axis];
    for (std::size_t i = 0; i < active.table->values.size(); ++i) {
        const std::size_t knot = i / stride % along.size;
        if (knot + 1 == along.size)
            continue;
        const double change = active.factor
            * (static_cast<double>(active.table->values[i + stride])
                - static_cast<double>(active.table->values[i]));
        if (along.distance + change > 0.0)
            continue;
        const auto place = [&](std::size_t n) {
            return Quantity{roundedText(along.position(n)), along.unit};
        };
        return fail(ErrorCode::SignNotConvertible,
            {{"position", place(knot)},
                {"reason",
                    AXISCOMP_TEXT("Error",
                        "from there to {place} the correction changes by {change}, so that "
                        "positions would change their order; check the unit of the values")
                        .with("place", place(knot + 1))
                        .with("change", Quantity{roundedText(change), along.unit})}});
    }
    return {};
}

} // namespace

LookupFrame::Correction::Correction(const ActiveTable& active) : factor(active.factor)
{
    if (!active.table)
        return;
    lookup.emplace(*active.table, active.outside);
    const auto [least, most] = std::ranges::minmax(active.table->values);
    lowest = std::min(factor * static_cast<double>(least), factor * static_cast<double>(most));
    highest = std::max(factor * static_cast<double>(least), factor * static_cast<double>(most));
}

LookupFrame::LookupFrame(
    LookupAt lookupAt, const std::vector<ActiveTable>& movers, const ActiveTable& corrected)
    : m_lookupAt(lookupAt)
    , m_corrected(corrected)
{
    for (const ActiveTable& mover : movers)
        m_movers.emplace_back(mover);
}

Result<LookupFrame> LookupFrame::make(
    LookupAt lookupAt, std::vector<ActiveTable> movers, ActiveTable corrected)
{
    if (movers.empty() || movers.size() > 3)
        return fail(ErrorCode::InvalidArgument,
            {{"reason", AXISCOMP_TEXT("Error", "a table has one to three dimensions")}});
    AXISCOMP_CHECK(checkTable(corrected, movers.size()));
    for (std::size_t axis = 0; axis < movers.size(); ++axis) {
        AXISCOMP_CHECK(checkTable(movers[axis], movers.size()));
        if (lookupAt == LookupAt::Encoder)
            AXISCOMP_CHECK(checkIncreasing(movers[axis], axis));
    }
    return LookupFrame(lookupAt, movers, corrected);
}

/// Moves one axis so that it stands on its target, while the others stay: regula falsi (Illinois)
/// between the largest and the smallest correction, exact as soon as both ends lie in one cell.
void LookupFrame::settle(std::span<double> position, std::size_t axis, double target) const
{
    const Correction& mover = m_movers[axis];
    const auto excess = [&](double place) {
        position[axis] = place;
        return place - target + mover.at(position);
    };
    double low = target - mover.highest;
    double high = target - mover.lowest;
    double lowExcess = excess(low);
    double highExcess = excess(high);
    if (!(lowExcess < 0.0)) {
        excess(low);
        return;
    }
    int lastSide = 0;
    for (int step = 0; step < 200 && highExcess > 0.0; ++step) {
        const double place = low - lowExcess * (high - low) / (highExcess - lowExcess);
        const double rest = excess(place);
        const double rounding =
            2.0 * std::numeric_limits<double>::epsilon() * (std::abs(place) + std::abs(target));
        if (std::abs(rest) <= rounding)
            return;
        const int side = rest < 0.0 ? -1 : 1;
        if (side < 0) {
            low = place;
            lowExcess = rest;
            highExcess *= lastSide == side ? 0.5 : 1.0;
        } else {
            high = place;
            highExcess = rest;
            lowExcess *= lastSide == side ? 0.5 : 1.0;
        }
        lastSide = side;
    }
}

Result<std::array<double, 3>> LookupFrame::rawPosition(std::span<const double> target) const
{
    std::array<double, 3> raw{};
    std::ranges::copy(target, raw.begin());
    const std::span position(raw.data(), m_movers.size());
    if (m_lookupAt == LookupAt::Set) {
        for (std::size_t axis = 0; axis < m_movers.size(); ++axis)
            raw[axis] -= m_movers[axis].at(target);
        return raw;
    }
    constexpr int mostRounds = 200;
    for (int round = 0; round < mostRounds; ++round) {
        double change = 0.0;
        double size = 0.0;
        for (std::size_t axis = 0; axis < m_movers.size(); ++axis) {
            const double before = raw[axis];
            settle(position, axis, target[axis]);
            change = std::max(change, std::abs(raw[axis] - before));
            size = std::max(size, std::abs(raw[axis]) + std::abs(target[axis]));
        }
        const bool isOneAxis = m_movers.size() == 1;
        if (isOneAxis || change <= 4.0 * std::numeric_limits<double>::epsilon() * size)
            return raw;
    }
    return fail(ErrorCode::NotConverged,
        {{"reason",
            AXISCOMP_TEXT("Error",
                "the tables that were active move their axes too much for their raw position to "
                "be found; check the unit of their values")}});
}

Result<LookupFrame::Point> LookupFrame::atTarget(
    std::span<const double> target, double deviation, std::span<const double> moved) const
{
    Point point;
    if (m_lookupAt == LookupAt::Set) {
        for (std::size_t axis = 0; axis < m_movers.size(); ++axis)
            point.knot[axis] = target[axis] + (moved.empty() ? 0.0 : moved[axis]);
        point.value = m_corrected.at(target) + deviation;
        return point;
    }
    AXISCOMP_TRY(point.knot, rawPosition(target));
    point.value =
        m_corrected.at(std::span<const double>(point.knot.data(), m_movers.size())) + deviation;
    return point;
}

LookupFrame::Point pointOfReading(LookupAt lookupAt, std::span<const double> reading,
    std::span<const double> reference, double value)
{
    LookupFrame::Point point;
    point.value = value;
    std::ranges::copy(lookupAt == LookupAt::Encoder ? reading : reference, point.knot.begin());
    return point;
}

} // namespace axiscomp
