// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output/machine_output.h"

#include "app/cli/output/drive_json.h"

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

Json toJson(const AxisPlan& axis)
{
    return {{"name", axis.name}, {"axis", axis.axis < 0 ? Json(nullptr) : Json(axis.axis)},
        {"differs", axis.differs()}, {"plan", axis.problem ? Json(nullptr) : toJson(axis.plan)},
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
