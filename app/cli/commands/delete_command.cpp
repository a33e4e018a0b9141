// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/output/drive_json.h"
#include "app/cli/output/write_text.h"
#include "app/cli/session/write_run.h"

namespace axiscomp::app {

namespace {

struct DeleteOptions {
    DriveOptions drive;
    std::string slot;
    bool isDryRun = false;
};

Result<ExitCode> deleteSlot(
    Environment& environment, CommandSession& session, const DeleteOptions& options)
{
    const std::string slot = slotName(session.profile(), options.slot);
    AXISCOMP_TRY(
        const auto plan, session.compensator().planSlotDeletion(slot, session.operation()));
    environment.print(planText(plan));
    Json document = {{"plan", toJson(plan)}, {"report", nullptr}};
    if (options.isDryRun) {
        environment.print("\nNothing was deleted (--dry-run).\n");
    } else {
        AXISCOMP_TRY(const auto backup,
            session.compensator().deleteSlot(slot, session.operation(), plan.drive.serialNumber));
        environment.report(deletionText(plan, backup, session.driveOption(), session.isDemo()));
        document["report"] = {{"backup", backup.string()}};
    }
    environment.document(document);
    return ExitCode::Done;
}

Result<ExitCode> runDelete(Environment& environment, const DeleteOptions& options)
{
    if (!options.slot.empty())
        return withDrive(
            environment, options.drive, [&](Environment& same, CommandSession& session) {
                return deleteSlot(same, session, options);
            });
    return withAxis(
        environment, options.drive, [&](Environment& same, CommandSession& session, int axis) {
            return runWrite(same, session, axis, deletionRequest(), options.isDryRun);
        });
}

} // namespace

void addDeleteCommand(CommandLine& line)
{
    auto options = std::make_shared<DeleteOptions>();
    options->drive.command = commandName("delete");
    CLI::App* command = line.add("delete", driveCommands,
        AXISCOMP_HELP(
            "Help", "Delete the table of an axis, or one that no axis uses, and free its slot"),
        [options](Environment& environment) { return runDelete(environment, *options); });
    addDriveOptions(*command, options->drive);
    CLI::Option* const axis = addAxisOption(*command, options->drive);
    command
        ->add_option("--slot", options->slot,
            AXISCOMP_HELP("Help",
                "Delete the table in this slot, small1 to small8, large1 or large2, which no axis "
                "uses"))
        ->option_text("SLOT")
        ->excludes(axis);
    command->add_flag("--dry-run", options->isDryRun,
        AXISCOMP_HELP("Help", "Show what would be deleted without deleting it"));
    command->footer(AXISCOMP_HELP("Help",
        "The compensation must be off. The axis then uses no table, also after a reboot; "
        "its sources stay. What is deleted is kept in a backup: `axiscomp restore` brings "
        "it back.") "\n\n" AXISCOMP_HELP("Help",
        "Example:") "\n  axiscomp delete --drive http://192.168.1.20 --axis X --dry-run");
}

} // namespace axiscomp::app
