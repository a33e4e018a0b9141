// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output/machine_output.h"

#include "app/cli/output/json_output.h"
#include "app/common/number_text.h"

namespace axiscomp::app {

namespace {

Json problemJson(const std::optional<Error>& problem)
{
    return problem ? toJson(*problem, Json::array()) : Json(nullptr);
}

Json switchJson(const std::optional<Switch>& switches)
{
    if (!switches)
        return nullptr;
    return *switches == Switch::Activate ? "activate" : "deactivate";
}

} // namespace

std::string differenceWords(const AxisPlan& axis)
{
    if (axis.problem)
        return "problem";
    if (!axis.differs())
        return "has all of this";
    std::string fields;
    for (const PlannedChange& change : axis.plan.changes)
        fields += (fields.empty() ? "" : ", ") + change.field;
    if (axis.isUnfinished)
        fields += (fields.empty() ? "" : ", ") + std::string("unfinished write");
    if (axis.switches)
        fields += (fields.empty() ? "" : ", ") + std::string("Activation");
    return "differs: " + fields;
}

std::string outcomeWords(const AxisPlan& axis, const AxisOutcome& outcome)
{
    if (outcome.problem)
        return "failed";
    if (outcome.report)
        return outcome.activation ? "written and switched" : "written";
    if (outcome.activation)
        return "switched";
    if (outcome.isAttempted || !axis.writes())
        return "nothing to do";
    return "not written";
}

std::string heldWords(const AxisStatus& status)
{
    if (status.setup.slot.empty())
        return "no table";
    if (!status.table)
        return status.setup.slot + ", empty";
    return status.setup.slot + (status.table->persistent ? ", persistent" : ", volatile") + ", CRC "
        + hexText(status.table->crc);
}

Json toJson(const AxisPlan& axis)
{
    return {{"name", axis.name}, {"axis", axis.axis}, {"differs", axis.differs()},
        {"plan", axis.problem ? Json(nullptr) : toJson(axis.plan)},
        {"switch", switchJson(axis.switches)}, {"unfinished", axis.isUnfinished},
        {"obstacle", problemJson(axis.obstacle)}, {"problem", problemJson(axis.problem)}};
}

Json toJson(const AxisOutcome& outcome)
{
    Json proof = nullptr;
    if (outcome.activation && outcome.activation->proof && *outcome.activation->proof) {
        const auto& table = outcome.activation->status.table;
        proof = toJson(**outcome.activation->proof, table ? table->grid.dimensions() : 0);
    }
    return {{"written", outcome.report.has_value()},
        {"backup", outcome.report ? Json(outcome.report->backup.string()) : Json(nullptr)},
        {"proof", std::move(proof)}, {"problem", problemJson(outcome.problem)},
        {"status", outcome.now ? toJson(*outcome.now) : Json(nullptr)}};
}

} // namespace axiscomp::app
