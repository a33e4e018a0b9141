// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/axis_plan.h"

#include "core/table/position_unit.h"

#include <cmath>

namespace axiscomp {

MeasuredAxis measuredAxis(const AxisInfo& axis)
{
    MeasuredAxis planned{axis.name, false, std::nullopt};
    const std::string unit = unitSymbol(axis.unit);
    const auto inMillimetres = unitFactor(unit, "mm");
    const auto inDegrees = unitFactor(unit, "deg");
    planned.isAngular = !inMillimetres && inDegrees;
    const auto factor = planned.isAngular ? inDegrees : inMillimetres;
    if (axis.travel && factor && !unit.empty())
        planned.travel = Travel{axis.travel->low * *factor, axis.travel->high * *factor};
    return planned;
}

std::optional<PlanEnds> proposedEnds(const Travel& travel)
{
    constexpr double share = 0.01; // the most that the usual overrun is of the range
    constexpr double perUnit = 1000.0;
    const double room = share * (travel.high - travel.low);
    const PlanEnds ends{std::ceil((travel.low + room) * perUnit) / perUnit,
        std::floor((travel.high - room) * perUnit) / perUnit};
    const bool isPlan = ends.from < ends.to && std::abs(ends.from) <= largestPlanPosition
        && std::abs(ends.to) <= largestPlanPosition;
    return isPlan ? std::optional(ends) : std::nullopt;
}

Text travelProblem(const MeasuringPlan& plan, const std::optional<Travel>& travel)
{
    const PlanTravel needed = planTravel(plan);
    constexpr double rounding = 0.0005;
    if (!travel
        || (needed.lowest >= travel->low - rounding && needed.highest <= travel->high + rounding))
        return {};
    const auto shown = [&](double position) {
        return Quantity{planPosition(position), plan.isAngular ? "deg" : "mm"};
    };
    return AXISCOMP_TEXT("Error",
        "the axis would move from {lowest} to {highest}, and its travel is {low} to {high}: choose "
        "other ends, or a smaller overrun")
        .with("lowest", shown(needed.lowest))
        .with("highest", shown(needed.highest))
        .with("low", shown(travel->low))
        .with("high", shown(travel->high));
}

} // namespace axiscomp
