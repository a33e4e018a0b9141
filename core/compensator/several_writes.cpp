// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/compensator/several_writes.h"

#include <algorithm>
#include <set>

namespace axiscomp {

namespace {

auto refuse(std::string reason)
{
    return fail(ErrorCode::InvalidArgument, {{"reason", std::move(reason)}});
}

} // namespace

Result<std::vector<WritePlan>> planSeveral(AxisCompensator& compensator,
    std::span<const AxisWrite> writes, const OperationOptions& options)
{
    std::set<int> axes;
    for (const AxisWrite& write : writes)
        if (!axes.insert(write.axis).second)
            return refuse("axis " + std::to_string(write.axis) + " is named twice");
    std::vector<WritePlan> plans;
    int flashOperations = 0;
    int needed = 0; ///< with what putting back the one that fails may cost
    for (const AxisWrite& write : writes) {
        auto plan = compensator.plan(write.axis, write.request, options);
        if (!plan) {
            Error error = plan.error();
            error.context.emplace("ofAxis", std::to_string(write.axis));
            return fail(std::move(error));
        }
        flashOperations += plan->flashOperations;
        needed = std::max(needed, flashOperations + plan->flashReserve);
        plans.push_back(*std::move(plan));
    }
    if (!plans.empty() && needed > plans.front().flashBudget.left)
        return refuse("together these writes cost " + std::to_string(needed)
            + " flash operations, and " + std::to_string(plans.front().flashBudget.left)
            + " are possible now; write them volatile, or fewer at a time");
    return plans;
}

} // namespace axiscomp
