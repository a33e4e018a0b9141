// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/output/drive_json.h"
#include "app/cli/output/status_text.h"
#include "app/cli/session/command_session.h"
#include "app/common/number_text.h"
#include "core/compensator/drive_summary.h"
#include "core/metrology/record/kept_figures.h"

namespace axiscomp::app {

namespace {

struct StatusOptions {
    DriveOptions drive;
    bool resetsFlashCount = false;
};

Result<ExitCode> runStatus(
    Environment& environment, CommandSession& session, int axis, bool resetsFlashCount)
{
    if (resetsFlashCount)
        AXISCOMP_CHECK(session.compensator().resetFlashCount(session.operation()));
    AXISCOMP_TRY(const auto settled, shownStatus(environment, session, axis));
    const auto& problem = settled.settlingProblem;
    if (problem && (isLinkFailure(problem->code) || problem->code == ErrorCode::Cancelled))
        return fail(*problem);
    const auto flash = session.compensator().flashUse(session.operation());
    // It is kept where the journal is.
    const bool isLost = !settled.isJournalKnown() && !flash && flash.error().code == problem->code;
    if (!flash && !isLost)
        return fail(flash.error());

    Json json = toJson(settled.status);
    json["flash"] = flash ? toJson(*flash) : Json(nullptr);
    if (settled.isBeingWritten)
        json["isBeingWritten"] = true;
    if (settled.settled)
        json["unfinishedWrite"] =
            unfinishedToJson(settled.settled->entry, settled.settled->outcome);
    const auto measured = measuredWith(settled.status, session.profile(), session.storeRoot());
    if (measured)
        json["measured"] = toJson(*measured);
    environment.document(json);
    environment.print(statusText(settled.status, session.profile()));
    if (measured)
        environment.print("\nWith this table: " + measuredFiguresText(*measured).english() + "\n");
    if (measured && !measured->units)
        environment.console().note("note: an older program kept what was measured without the unit "
                                   "of the axis; it holds as long as that is the same");
    environment.print("\n" + (flash ? flashText(*flash) : "Flash: not known\n"));
    return ExitCode::Done;
}

} // namespace

void addStatusCommand(CommandLine& line)
{
    auto options = std::make_shared<StatusOptions>();
    options->drive.command = commandName("status");
    CLI::App* command = line.add("status", driveCommands,
        AXISCOMP_HELP(
            "Help", "Show the compensation of an axis, and the outcome of an interrupted write"),
        [options](Environment& environment) {
            return withAxis(environment, options->drive,
                [options](Environment& inside, CommandSession& session, int axis) {
                    return runStatus(inside, session, axis, options->resetsFlashCount);
                });
        });
    addDriveOptions(*command, options->drive);
    addAxisOption(*command, options->drive);
    command->add_flag("--reset-flash-count", options->resetsFlashCount,
        AXISCOMP_HELP("Help",
            "Count the drive's flash operations again after their record was damaged; first wait "
            "as long as the drive counts them"));
}

} // namespace axiscomp::app
