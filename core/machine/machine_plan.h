// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/axis_compensator.h"
#include "core/machine/machine_tables.h"

#include <filesystem>
#include <optional>
#include <span>
#include <vector>

namespace axiscomp {

/// How one axis differs from its machine file, and what brings it there.
struct AxisPlan {
    std::string name; ///< as the machine file has it
    int axis = -1; ///< -1: the drive has none of this name
    AxisStatus before;
    WriteRequest request; ///< what would be written
    WritePlan plan; ///< the axis has all of it when there are no changes
    bool isUnfinished = false; ///< an earlier write did not end: the next one ends it
    std::optional<Switch> switches; ///< the activation is another one than the file says
    std::optional<Error> problem; ///< why there is no plan
    /// Why the plan cannot be carried out now, although it is known what differs.
    std::optional<Error> obstacle;
    // Of a table that was read again (MachineTable::isOpen).
    std::vector<Diagnostic> fileProblems;
    std::vector<Text> fileReport;

    /// What the plan warns of is news: the axis is written, or it has no table and a reboot may
    /// bring one back.
    [[nodiscard]] bool isWarned() const
    {
        return !problem && (!plan.changes.empty() || plan.after.slot.empty());
    }
    [[nodiscard]] bool writes() const { return !plan.changes.empty() || isUnfinished; }
    [[nodiscard]] bool differs() const { return writes() || switches.has_value(); }
};

struct DrivePlan {
    DriveIdentity drive;
    std::vector<AxisPlan> axes; ///< in the order of the file
    /// Why the axes cannot have all of it together.
    std::optional<Error> obstacle;

    [[nodiscard]] bool differs() const;
};

/// Why what a machine file says of a drive cannot be brought about.
struct PlanProblem {
    std::optional<std::size_t> axis; ///< of DrivePlan::axes; none: of the drive
    Error error;
    bool isObstacle = false; ///< it is known what differs, and cannot be written now
};

/// One drive of a machine: how it differs, or why that is not known. Neither: not asked yet.
struct DriveLook {
    std::optional<DrivePlan> plan;
    std::optional<Error> problem;

    /// It does not answer.
    [[nodiscard]] bool isMissing() const { return problem && isUnreachable(problem->code); }
    /// What must not be when the machine is written: a single one of any drive, and nothing is
    /// written to all of them. allowsMissing: a drive that does not answer may be left out.
    [[nodiscard]] std::vector<PlanProblem> problems(bool allowsMissing) const;
};

/// Whether any drive of a machine answers; null: it was not asked. Where none does nothing is
/// known, which is not that nothing differs: then none may be left out.
[[nodiscard]] bool doesAnyAnswer(std::span<const DriveLook* const> looks);

/// What a plan needs besides the drive.
struct MachineContext {
    std::filesystem::path folder; ///< of the machine file
    std::filesystem::path storeRoot;
    bool activates = false; ///< activations are to be switched as the file says
};

/// Reads the drive and compares it with the file; changes nothing. tables: one for each axis of the
/// drive, as readMachineTable gives them with no place. What is wrong with one axis stands at
/// that axis. Errors: those of the link, OtherDrive, Cancelled.
[[nodiscard]] Result<DrivePlan> planDrive(AxisCompensator& compensator, const DriveProfile& profile,
    const MachineDrive& drive, std::span<const MachineTable> tables, const MachineContext& context,
    const OperationOptions& options);

/// What became of one axis.
struct AxisOutcome {
    /// None: it was not written, because nothing had to be, or because an axis before it failed.
    std::optional<WriteReport> report;
    std::optional<Activation> activation;
    std::optional<Error> problem;
    // What was wanted and has not been tried, because something before it failed.
    bool awaitsWrite = false;
    bool awaitsSwitch = false;
    std::optional<AxisStatus> now; ///< none: it cannot be read
};

/// Carries a plan without problems and obstacles out: writes axis after axis, those with a slot of
/// their own first, each as AxisCompensator::write does, up to the first that fails;
/// then switches, when context says so. An axis that somebody has changed since it was planned is
/// neither written nor switched on (ChangedMeanwhile). One outcome for each axis. Errors, with
/// nothing done: those of the link, Cancelled; OtherDrive when another drive has taken the place of
/// the one that was planned.
[[nodiscard]] Result<std::vector<AxisOutcome>> applyPlan(AxisCompensator& compensator,
    const DrivePlan& plan, const MachineContext& context, const OperationOptions& options);

} // namespace axiscomp
