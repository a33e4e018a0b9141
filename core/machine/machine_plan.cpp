// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/machine/machine_plan.h"

#include "core/axis/axis_reader.h"
#include "core/axis/shown_grid.h"
#include "core/compensator/axis_operations.h"
#include "core/compensator/multi_axis_write.h"
#include "core/drive/axis_target.h"
#include "core/table/position_unit.h"
#include "core/table/table_units.h"
#include "core/write/lookup_side.h"
#include "core/write/write_planner.h"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <functional>
#include <map>
#include <numeric>
#include <utility>

namespace axiscomp {

namespace {

bool endsPlan(const Error& error)
{
    return isLinkFailure(error.code) || error.code == ErrorCode::Cancelled;
}

/// Errors: those of AxisCompensator::identify, OtherDrive.
Result<DriveIdentity> identifyAs(
    AxisCompensator& compensator, std::int32_t serialNumber, const OperationOptions& options)
{
    AXISCOMP_TRY(auto drive, compensator.identify(options));
    if (drive.serialNumber != serialNumber)
        return fail(
            ErrorCode::OtherDrive, {{"expected", serialNumber}, {"found", drive.serialNumber}});
    return drive;
}

/// Plans the axes of one drive.
class DrivePlanner {
public:
    DrivePlanner(AxisCompensator& compensator, const DriveProfile& profile,
        const MachineContext& context, const OperationOptions& options)
        : m_compensator(compensator)
        , m_profile(profile)
        , m_context(context)
        , m_options(options)
    {
        m_options.progress = {};
    }

    [[nodiscard]] Result<DrivePlan> plan(
        const MachineDrive& drive, std::span<const MachineTable> tables);

private:
    [[nodiscard]] Result<std::vector<AxisPlan>> foundAxes(const MachineDrive& drive);
    [[nodiscard]] Result<void> planAxis(
        const MachineAxis& axis, const MachineTable& table, AxisPlan& plan);
    [[nodiscard]] Result<MachineTable> settledTable(
        const MachineAxis& axis, const MachineTable& table, AxisPlan& plan);
    [[nodiscard]] Result<void> keepTable(WriteRequest& request, AxisPlan& plan);
    [[nodiscard]] Result<bool> isWithinTolerance(
        const ValueTolerance& tolerance, const AxisPlan& plan);
    void findObstacle(AxisPlan& plan) const;
    void planActivation(const MachineAxis& axis, AxisPlan& plan) const;
    void checkFlash(DrivePlan& plan) const;
    void checkNamedOnce(DrivePlan& plan) const;

    AxisCompensator& m_compensator;
    const DriveProfile& m_profile;
    const MachineContext& m_context;
    OperationOptions m_options;
};

/// Tables with a slot of their own first, so that no chosen slot is one of those.
std::vector<std::size_t> inOrderOfWriting(
    std::size_t count, const std::function<bool(std::size_t)>& hasSlot)
{
    std::vector<std::size_t> order(count);
    std::iota(order.begin(), order.end(), std::size_t{0});
    std::stable_partition(order.begin(), order.end(), hasSlot);
    return order;
}

Result<DrivePlan> DrivePlanner::plan(
    const MachineDrive& drive, std::span<const MachineTable> tables)
{
    DrivePlan result;
    AXISCOMP_TRY(result.drive, identifyAs(m_compensator, drive.serialNumber, m_options));
    std::map<std::string, Text> taken;
    for (const auto& [slot, axis] : drive.reservedSlots)
        taken.emplace(
            slot, AXISCOMP_TEXT("Error", "axis {axis} of the machine file").with("axis", axis));
    const auto hasSlot = [&](std::size_t n) { return !drive.axes[n].slot.empty(); };
    AXISCOMP_TRY(result.axes, foundAxes(drive));
    WriteSequence sequence(std::move(taken));
    for (std::size_t n = 0; n < drive.axes.size(); ++n)
        sequence.expect(result.axes[n].axis,
            !drive.axes[n].file.empty() && drive.axes[n].persistency == Persistency::Persistent);
    for (const std::size_t n : inOrderOfWriting(drive.axes.size(), hasSlot)) {
        AxisPlan& plan = result.axes[n];
        if (plan.problem)
            continue;
        sequence.begin(plan.axis, plan.request);
        auto planned = planAxis(drive.axes[n], tables[n], plan);
        if (!planned && endsPlan(planned.error()))
            return fail(std::move(planned).error());
        if (!planned)
            plan.problem = std::move(planned).error();
        else
            sequence.add(plan.plan);
    }
    checkNamedOnce(result);
    checkFlash(result);
    return result;
}

/// Their plans, which know no more than this.
Result<std::vector<AxisPlan>> DrivePlanner::foundAxes(const MachineDrive& drive)
{
    std::vector<AxisPlan> plans;
    for (const MachineAxis& axis : drive.axes) {
        AxisPlan& plan = plans.emplace_back();
        plan.name = axis.axis;
        auto found = m_compensator.findAxis(axis.axis, m_options);
        if (!found && endsPlan(found.error()))
            return fail(std::move(found).error());
        if (found)
            plan.axis = *found;
        else
            plan.problem = std::move(found).error();
    }
    return plans;
}

/// A table whose numbers depend on the axis's sources is read with these.
Result<MachineTable> DrivePlanner::settledTable(
    const MachineAxis& axis, const MachineTable& table, AxisPlan& plan)
{
    if (!table.isOpen)
        return table.table ? Result<MachineTable>(table) : fail(*table.problem);
    std::vector<std::string> paths;
    if (!axis.sources)
        paths = sourcePaths(plan.before.setup);
    for (const std::string& source : axis.sources.value_or(std::vector<std::string>{})) {
        AXISCOMP_TRY(auto resolved, m_compensator.resolveSource(source, m_options));
        paths.push_back(std::move(resolved.path));
    }
    const AxisPlace place{
        axisTarget(m_profile, plan.axis, paths), lookupAtSources(m_profile, plan.axis, paths)};
    MachineTable again =
        readMachineTable(axis, m_context.folder, m_profile.layout, place, m_options.stop);
    plan.fileProblems = again.problems;
    plan.fileReport = again.report;
    if (!again.table)
        return fail(*std::move(again.problem));
    return again;
}

Result<void> DrivePlanner::planAxis(
    const MachineAxis& axis, const MachineTable& table, AxisPlan& plan)
{
    AXISCOMP_TRY(
        const auto now, settledStatus(m_compensator, m_context.storeRoot, plan.axis, m_options));
    plan.before = now.status;
    AXISCOMP_CHECK(checkIsSettled(now));
    plan.isUnfinished = plan.before.unfinishedWrite.has_value();
    WriteRequest& request = plan.request;
    if (axis.sources)
        request.sources =
            axis.sources->empty() ? std::vector<std::string>{std::string()} : *axis.sources;
    if (axis.file.empty()) {
        request.withoutTable = true;
        request.leavesEmptySlot = true;
        request.dimensionality = static_cast<int>(std::max<std::size_t>(1,
            axis.sources ? request.sources.size()
                         : static_cast<std::size_t>(plan.before.setup.dimensionality)));
    } else {
        AXISCOMP_TRY(auto settled, settledTable(axis, table, plan));
        request.table = std::move(settled.table);
        request.lookupAt = settled.lookupAt;
        request.measuredDrive = settled.measuredDrive;
        request.unstatedUnit = unstatedUnit(axis.choices.units.values);
        request.dimensionality = request.table->grid.dimensions();
        request.persistency = axis.persistency;
        request.acceptsLarge = axis.acceptsLarge;
        if (!axis.slot.empty())
            request.slot = axis.slot;
    }
    AXISCOMP_TRY(plan.plan, m_compensator.compare(plan.axis, request, m_options));
    if (axis.tolerance && plan.plan.table && !plan.plan.changes.empty()) {
        AXISCOMP_TRY(const bool isSame, isWithinTolerance(*axis.tolerance, plan));
        if (isSame)
            AXISCOMP_CHECK(keepTable(request, plan));
    }
    expectAsPlanned(request, plan.plan);
    planActivation(axis, plan);
    findObstacle(plan);
    return {};
}

/// Where the sources change to another unit, the table is written all the same.
Result<void> DrivePlanner::keepTable(WriteRequest& request, AxisPlan& plan)
{
    auto table = std::exchange(request.table, std::nullopt);
    auto kept = m_compensator.compare(plan.axis, request, m_options);
    if (kept)
        plan.plan = *std::move(kept);
    else if (kept.error().code == ErrorCode::UnitMismatch)
        request.table = std::move(table);
    else
        return fail(kept.error());
    return {};
}

/// Whether the drive's table is that of the file but for this much, and in the slot that is named.
Result<bool> DrivePlanner::isWithinTolerance(const ValueTolerance& tolerance, const AxisPlan& plan)
{
    if (const auto& slot = plan.request.slot; slot && *slot != plan.before.setup.slot)
        return false;
    const CompensationTable& wanted = *plan.plan.table;
    const auto& header = plan.before.table;
    if (!header || !isShownAs(header->grid, wanted.grid))
        return false;
    const auto factor = unitFactor(tolerance.unit, plan.before.axis.unit);
    if (!factor)
        return fail(ErrorCode::UnitMismatch,
            {{"what", AXISCOMP_TEXT("Error", "values of the tolerance")}, {"unit", tolerance.unit},
                {"other", unitSymbol(plan.before.axis.unit)}});
    AXISCOMP_TRY(const auto held, m_compensator.readTable(plan.before, m_options));
    if (!sameSpans(held.grid, wanted.grid))
        return false;
    const double most = tolerance.value * *factor;
    return std::ranges::equal(held.values, wanted.values, [most](float a, float b) {
        return std::abs(static_cast<double>(a) - static_cast<double>(b)) <= most;
    });
}

void DrivePlanner::planActivation(const MachineAxis& axis, AxisPlan& plan) const
{
    if (!axis.isActive || *axis.isActive == plan.before.isOn())
        return;
    plan.switches = *axis.isActive ? Switch::Activate : Switch::Deactivate;
}

void DrivePlanner::findObstacle(AxisPlan& plan) const
{
    const bool isSwitchedOff =
        m_context.activates && plan.switches == std::optional(Switch::Deactivate);
    const bool activates = m_context.activates && plan.switches == std::optional(Switch::Activate);
    if (plan.writes() && plan.before.isOn() && !isSwitchedOff) {
        plan.obstacle = compensationActive(plan.before);
    } else if (auto accepted = checkLargeAccepted(plan.plan, plan.request);
               plan.writes() && !accepted) {
        plan.obstacle = std::move(accepted).error();
        // There and nowhere else.
        plan.obstacle->context.set("machineAxis", Verbatim{plan.name});
    } else if (activates && !plan.before.axis.isHomed) {
        plan.obstacle = Error{ErrorCode::NotHomed, {{"axis", plan.axis}}, {}};
    }
}

/// By its index and by its name.
void DrivePlanner::checkNamedOnce(DrivePlan& plan) const
{
    for (std::size_t n = 1; n < plan.axes.size(); ++n) {
        AxisPlan& axis = plan.axes[n];
        const auto before = std::span(plan.axes).first(n);
        if (!axis.problem && std::ranges::any_of(before, [&](const AxisPlan& other) {
                return !other.problem && other.axis == axis.axis;
            }))
            axis.problem = Error{ErrorCode::InvalidArgument,
                {{"reason",
                    AXISCOMP_TEXT("Error", "axis {axis} is named twice").with("axis", axis.axis)}},
                {}};
    }
}

void DrivePlanner::checkFlash(DrivePlan& plan) const
{
    FlashSum flash;
    for (const AxisPlan& axis : plan.axes)
        if (!axis.problem)
            flash.add(axis.plan.flashOperations, axis.plan.flashReserve);
    if (auto fits = flash.check(m_compensator, m_options); !fits && !plan.obstacle)
        plan.obstacle = std::move(fits).error();
}

/// Carries out one plan.
class DriveApplication {
public:
    DriveApplication(AxisCompensator& compensator, const DrivePlan& plan,
        const MachineContext& context, const OperationOptions& options)
        : m_compensator(compensator)
        , m_plan(plan)
        , m_context(context)
        , m_options(options)
        , m_outcomes(plan.axes.size())
    {
        for (std::size_t n = 0; n < m_outcomes.size(); ++n) {
            m_outcomes[n].awaitsWrite = plan.axes[n].writes();
            m_outcomes[n].awaitsSwitch = context.activates && plan.axes[n].switches.has_value();
        }
    }

    [[nodiscard]] std::vector<AxisOutcome> run()
    {
        // Up to the first that fails.
        static_cast<void>(
            switchAll(Switch::Deactivate) && writeAll() && switchAll(Switch::Activate));
        readAll();
        return std::move(m_outcomes);
    }

private:
    [[nodiscard]] Result<Activation> switchOne(const AxisPlan& axis, Switch wanted);
    [[nodiscard]] bool switchAll(Switch wanted);
    [[nodiscard]] bool writeAxis(std::size_t index);
    [[nodiscard]] bool writeAll();
    void readAll();

    AxisCompensator& m_compensator;
    const DrivePlan& m_plan;
    const MachineContext& m_context;
    OperationOptions m_options;
    std::vector<AxisOutcome> m_outcomes;
};

/// An axis that was just written has been looked at by that.
Result<Activation> DriveApplication::switchOne(const AxisPlan& axis, Switch wanted)
{
    if (wanted == Switch::Activate && !axis.writes()) {
        AXISCOMP_TRY(const auto now, m_compensator.status(axis.axis, m_options));
        const PlannedState planned = plannedState(axis.plan);
        AXISCOMP_CHECK(checkAsPlanned(planned, now));
        AXISCOMP_CHECK(checkUnitsAsPlanned(planned, *plannedState(now).units, now));
    }
    return m_compensator.switchTo(axis.axis, wanted, proofSamples, m_options);
}

bool DriveApplication::switchAll(Switch wanted)
{
    for (std::size_t n = 0; n < m_plan.axes.size(); ++n) {
        AxisOutcome& outcome = m_outcomes[n];
        if (!outcome.awaitsSwitch || m_plan.axes[n].switches != std::optional(wanted))
            continue;
        outcome.awaitsSwitch = false;
        auto activation = switchOne(m_plan.axes[n], wanted);
        if (!activation)
            outcome.problem = std::move(activation).error();
        else if (activation->proof && !*activation->proof)
            outcome.problem = activation->proof->error();
        if (activation)
            outcome.activation = *std::move(activation);
        if (outcome.problem)
            return false;
    }
    return true;
}

bool DriveApplication::writeAxis(std::size_t index)
{
    const AxisPlan& axis = m_plan.axes[index];
    AxisOutcome& outcome = m_outcomes[index];
    outcome.awaitsWrite = false;
    auto report = m_compensator.write(axis.axis, axis.request, m_options);
    if (report)
        outcome.report = *std::move(report);
    else if (!holdsNewState(report))
        outcome.problem = std::move(report).error();
    return !outcome.problem;
}

bool DriveApplication::writeAll()
{
    const auto hasSlot = [&](std::size_t n) { return m_plan.axes[n].request.slot.has_value(); };
    return std::ranges::all_of(inOrderOfWriting(m_plan.axes.size(), hasSlot),
        [&](std::size_t n) { return !m_outcomes[n].awaitsWrite || writeAxis(n); });
}

/// Also when the user has stopped the writes.
void DriveApplication::readAll()
{
    OperationOptions quiet = m_options;
    quiet.stop = {};
    quiet.progress = {};
    for (std::size_t n = 0; n < m_outcomes.size(); ++n) {
        auto now = m_compensator.status(m_plan.axes[n].axis, quiet);
        if (!now && isLinkFailure(now.error().code))
            return;
        if (now)
            m_outcomes[n].now = *std::move(now);
    }
}

} // namespace

bool DrivePlan::differs() const
{
    return std::ranges::any_of(axes, &AxisPlan::differs);
}

/// What is not known comes before what is known and in the way.
std::vector<PlanProblem> DriveLook::problems(bool allowsMissing) const
{
    std::vector<PlanProblem> problems;
    if (problem && !(allowsMissing && isMissing()))
        problems.push_back({{}, *problem});
    if (!plan)
        return problems;
    for (std::size_t n = 0; n < plan->axes.size(); ++n)
        if (plan->axes[n].problem)
            problems.push_back({n, *plan->axes[n].problem});
    for (std::size_t n = 0; n < plan->axes.size(); ++n)
        if (plan->axes[n].obstacle)
            problems.push_back({n, *plan->axes[n].obstacle, true});
    if (plan->obstacle)
        problems.push_back({{}, *plan->obstacle, true});
    return problems;
}

bool doesAnyAnswer(std::span<const DriveLook* const> looks)
{
    return std::ranges::any_of(
        looks, [](const DriveLook* look) { return look && !look->isMissing(); });
}

Result<DrivePlan> planDrive(AxisCompensator& compensator, const DriveProfile& profile,
    const MachineDrive& drive, std::span<const MachineTable> tables, const MachineContext& context,
    const OperationOptions& options)
{
    return DrivePlanner(compensator, profile, context, options).plan(drive, tables);
}

Result<std::vector<AxisOutcome>> applyPlan(AxisCompensator& compensator, const DrivePlan& plan,
    const MachineContext& context, const OperationOptions& options)
{
    AXISCOMP_CHECK(identifyAs(compensator, plan.drive.serialNumber, options));
    return DriveApplication(compensator, plan, context, options).run();
}

} // namespace axiscomp
