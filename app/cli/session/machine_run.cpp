// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/session/machine_run.h"

#include "app/cli/input/table_input.h"
#include "app/cli/session/drive_search.h"
#include "app/cli/session/write_run.h"
#include "app/common/arguments.h"
#include "core/base/parallel.h"
#include "core/io/local_file.h"

#include <algorithm>
#include <atomic>
#include <filesystem>

namespace axiscomp::app {

namespace {

bool names(const std::string& only, const MachineDrive& drive, const MachineAxis& axis)
{
    return only == axis.axis || only == std::to_string(drive.serialNumber) + "/" + axis.axis;
}

/// Leaves what --only names.
Result<void> select(MachineFile& machine, const MachineOptions& options)
{
    for (const std::string& only : options.only) {
        const bool isKnown = std::ranges::any_of(machine.drives, [&](const MachineDrive& drive) {
            return std::ranges::any_of(
                drive.axes, [&](const MachineAxis& axis) { return names(only, drive, axis); });
        });
        if (!isKnown)
            return wrongUsage("the file has no axis " + only + "; write AXIS or SERIAL/AXIS",
                options.drive.command);
    }
    if (options.only.empty())
        return {};
    for (MachineDrive& drive : machine.drives)
        std::erase_if(drive.axes, [&](const MachineAxis& axis) {
            const bool isLeftOut = std::ranges::none_of(
                options.only, [&](const std::string& only) { return names(only, drive, axis); });
            if (isLeftOut && !axis.slot.empty())
                drive.reservedSlots.emplace(axis.slot, axis.axis);
            return isLeftOut;
        });
    std::erase_if(machine.drives, [](const MachineDrive& drive) { return drive.axes.empty(); });
    return {};
}

/// Errors: those of the first table that is none.
Result<void> reportTables(
    Environment& environment, const MachineOptions& options, const MachineRun& run)
{
    const Error* first = nullptr;
    for (const MachineDriveRun& drive : run.drives)
        for (std::size_t axis = 0; axis < drive.tables.size(); ++axis) {
            const MachineTable& table = drive.tables[axis];
            environment.diagnose(table.file.string(), table.problems);
            for (const Text& line : table.report)
                environment.console().note(table.file.string() + ": " + line.english());
            if (!table.problem || table.isOpen)
                continue;
            environment.console().note(options.file + ":"
                + std::to_string(drive.wanted.axes[axis].line)
                + ": error: " + singleLine(sentence(*table.problem)));
            first = first ? first : &*table.problem;
        }
    return first ? Result<void>(fail(*first)) : Result<void>();
}

/// A session of its own for each drive, on the thread that works with it.
void forEachDrive(Environment& environment, const MachineOptions& options,
    std::vector<MachineDriveRun*> drives, std::string_view step,
    const std::function<Result<void>(MachineDriveRun&, CommandSession&)>& work)
{
    std::atomic<std::size_t> done = 0;
    forEachAtOnce(drives.size(), options.jobs, [&](std::size_t index) {
        MachineDriveRun& drive = *drives[index];
        auto session = environment.stopToken().stop_requested()
            ? Result<std::unique_ptr<CommandSession>>(fail(ErrorCode::Cancelled))
            : CommandSession::open(environment, options.drive, drive.wanted.endpoint);
        auto worked = session ? work(drive, **session) : Result<void>(fail(session.error()));
        if (!worked)
            drive.problem = std::move(worked).error();
        environment.console().progress(
            step, static_cast<double>(++done) / static_cast<double>(drives.size()));
    });
    environment.console().clearProgress();
}

MachineContext contextOf(const MachineOptions& options, const CommandSession& session)
{
    return {pathFromText(options.file).parent_path(), session.storeRoot(), options.activates};
}

} // namespace

bool MachineRun::differs() const
{
    return std::ranges::any_of(
        drives, [](const MachineDriveRun& drive) { return drive.plan && drive.plan->differs(); });
}

Result<MachineRun> beginMachineRun(Environment& environment, const MachineOptions& options)
{
    AXISCOMP_TRY(const auto profile, profileOf(options.drive.profile));
    AXISCOMP_TRY(auto reading, loadMachine(pathFromText(options.file)));
    environment.diagnose(options.file, reading.diagnostics);
    if (!reading.machine)
        return fail(machineError(options.file, reading));
    MachineFile& machine = *reading.machine;
    AXISCOMP_CHECK(select(machine, options));
    auto tables = readMachineTables(
        machine, pathFromText(options.file).parent_path(), profile.layout, environment.stopToken());
    MachineRun run{machine.name, {}};
    for (std::size_t n = 0; n < machine.drives.size(); ++n) {
        MachineDriveRun& drive = run.drives.emplace_back();
        drive.endpoint = shownEndpoint(machine.drives[n].endpoint);
        drive.wanted = std::move(machine.drives[n]);
        drive.tables = std::move(tables[n]);
    }
    AXISCOMP_CHECK(reportTables(environment, options, run));
    return run;
}

void planMachine(Environment& environment, const MachineOptions& options, MachineRun& run)
{
    std::vector<MachineDriveRun*> drives;
    for (MachineDriveRun& drive : run.drives)
        drives.push_back(&drive);
    forEachDrive(environment, options, std::move(drives), "plan",
        [&](MachineDriveRun& drive, CommandSession& session) -> Result<void> {
            AXISCOMP_TRY(drive.plan,
                planDrive(session.compensator(), session.profile(), drive.wanted, drive.tables,
                    contextOf(options, session), session.quietOperation()));
            return {};
        });
    for (const MachineDriveRun& drive : run.drives)
        for (std::size_t n = 0; drive.plan && n < drive.tables.size(); ++n) {
            const std::string file = drive.tables[n].file.string();
            environment.diagnose(file, drive.plan->axes[n].fileProblems);
            for (const Text& line : drive.plan->axes[n].fileReport)
                environment.console().note(file + ": " + line.english());
        }
}

void applyMachine(Environment& environment, const MachineOptions& options, MachineRun& run)
{
    const WriteInterruption interruption(environment);
    std::vector<MachineDriveRun*> drives;
    for (MachineDriveRun& drive : run.drives)
        if (drive.plan)
            drives.push_back(&drive);
    forEachDrive(environment, options, std::move(drives), "write",
        [&](MachineDriveRun& drive, CommandSession& session) -> Result<void> {
            AXISCOMP_TRY(drive.outcomes,
                applyPlan(session.compensator(), *drive.plan, contextOf(options, session),
                    session.quietOperation()));
            return {};
        });
}

} // namespace axiscomp::app
