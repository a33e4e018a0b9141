// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_status.h"
#include "core/metrology/measuring_plan.h"

#include <optional>
#include <string>

namespace axiscomp {

/// What the plan of a measurement needs to know of an axis.
struct MeasuredAxis {
    std::string name; ///< may be empty
    bool isAngular = false;
    std::optional<Travel> travel; ///< in mm or deg; none: the drive does not say
};
/// An axis whose unit is not known counts as one in mm, and says no travel.
[[nodiscard]] MeasuredAxis measuredAxis(const AxisInfo& axis);

/// First and last target that leave room for the overrun at both ends, in whole thousandths; none
/// where there is no room for that.
struct PlanEnds {
    double from = 0.0;
    double to = 0.0;
};
[[nodiscard]] std::optional<PlanEnds> proposedEnds(const Travel& travel);

/// Empty: the axis gets everywhere, or nothing is known of its travel. travel: in the unit of the
/// plan.
[[nodiscard]] Text travelProblem(const MeasuringPlan& plan, const std::optional<Travel>& travel);

} // namespace axiscomp
