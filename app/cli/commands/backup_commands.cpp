// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/output/drive_json.h"
#include "app/cli/output/output_file.h"
#include "app/cli/output/status_text.h"
#include "app/cli/output/write_text.h"
#include "app/cli/session/write_run.h"
#include "app/common/number_text.h"
#include "app/common/standard_streams.h"
#include "core/io/local_file.h"

namespace axiscomp::app {

namespace {

struct BackupOptions {
    DriveOptions drive;
    std::string file;
    bool force = false;
    bool isDryRun = false;
};

std::size_t fileCount(const DriveBackup& backup)
{
    std::size_t count = backup.otherFiles.size();
    for (const AxisBackup& axis : backup.axes)
        count += axis.files.size();
    return count;
}

Result<ExitCode> runBackup(Environment& environment, const BackupOptions& options)
{
    const Output output{options.file, options.drive.command};
    AXISCOMP_CHECK(checkOutput(environment, output, true));
    return withDrive(
        environment, options.drive, [&](Environment&, CommandSession& session) -> Result<ExitCode> {
            AXISCOMP_TRY(const auto rescue,
                backUpDrive(session.compensator(), session.storeRoot(), session.operation()));
            environment.console().clearProgress();
            for (const Error& doubt : rescue.doubts)
                environment.warn(sentence(doubt));
            const DriveBackup& backup = rescue.backup;
            const std::string text = writeBackup(backup);
            AXISCOMP_CHECK(writeOutput(environment, output, asBytes(text)));
            environment.document({{"output", options.file}, {"axes", backup.axes.size()},
                {"tables", fileCount(backup)}, {"bytes", text.size()}});
            if (!output.isStandardOutput())
                environment.print("Wrote " + options.file + ": "
                    + plural(backup.axes.size(), "axis", "axes") + ", "
                    + plural(fileCount(backup), "table", "tables") + ".\n");
            return ExitCode::Done;
        });
}

Json fileDocument(const PlannedFile& planned)
{
    return {{"slot", planned.file.slot}, {"file", planned.file.path},
        {"tableBytes", planned.file.bytes.size()}, {"persistent", planned.file.persistent},
        {"isThere", planned.isThere}, {"flashOperations", planned.flashOperations}};
}

/// "Small4: 172 bytes, persistent; flash: 1 operation": a file that no axis used.
std::string fileLine(const PlannedFile& planned)
{
    const AxisBackup::File& file = planned.file;
    const auto operations = static_cast<std::size_t>(planned.flashOperations);
    return file.slot + ": " + plural(file.bytes.size(), "byte", "bytes")
        + (file.persistent ? ", persistent" : ", volatile") + "; "
        + (operations == 0 ? "no flash operation"
                           : "flash: " + plural(operations, "operation", "operations"))
        + "\n";
}

/// What will be written of the axes and of the tables that no axis uses, before any of it is.
struct ShownPlans {
    Json plans = Json::array();
    Json files = Json::array();
};

void showFiles(Environment& environment, const RestorePlan& plan, ShownPlans& shown)
{
    std::string lines;
    for (const PlannedFile& file : plan.files) {
        shown.files.push_back(fileDocument(file));
        if (!file.isThere)
            lines += "  " + fileLine(file);
    }
    if (!lines.empty())
        environment.print("\nTables that no axis uses, restored after the axes\n" + lines);
}

Result<ShownPlans> showPlans(
    Environment& environment, CommandSession& session, const DriveBackup& backup, bool force)
{
    AXISCOMP_TRY(
        const auto planned, session.compensator().planRestore(backup, force, session.operation()));
    AXISCOMP_TRY(const auto axes, session.compensator().axes(session.operation()));
    environment.console().clearProgress();
    ShownPlans shown;
    for (const WritePlan& plan : planned.axes) {
        // It may be restored all the same: that ends what did not end.
        if (const auto settled = settledStatus(environment, session, plan.axis); !settled)
            environment.warn(sentence(settled.error()));
        shown.plans.push_back(toJson(plan));
        if (!plan.changes.empty())
            environment.print((shown.plans.size() > 1 ? "\n" : "")
                + planText(plan, axes.at(static_cast<std::size_t>(plan.axis))));
        for (const Text& warning : plan.warnings)
            environment.warn(warning.english());
    }
    showFiles(environment, planned, shown);
    return shown;
}

/// The documents of the writes of the axes.
Json showRestored(Environment& environment, const RestoreReport& done)
{
    Json list = Json::array();
    for (const WriteReport& report : done.axes) {
        environment.report("Restored " + axisWords(report.now.axis) + ": table "
            + (report.now.setup.slot.empty() ? "none" : report.now.setup.slot) + ".\n");
        list.push_back({{"plan", toJson(report.plan)}, {"report", toJson(report)}});
    }
    for (const AxisBackup::File& file : done.files)
        environment.report("Restored " + file.slot + ", which no axis uses.\n");
    if (done.axes.empty() && done.files.empty())
        environment.print("The drive already has all of this; nothing was written.\n");
    return list;
}

Result<DriveBackup> readGivenBackup(Environment& environment, const std::string& file)
{
    if (file == standardStream) {
        AXISCOMP_TRY(
            const auto text, readStandardInput(environment.interrupt(), maximumBackupSize));
        return readBackup(text, "standard input");
    }
    AXISCOMP_TRY(const auto bytes, loadFile(pathFromText(file), maximumBackupSize));
    return readBackup(asText(bytes), file);
}

Result<ExitCode> runRestore(Environment& environment, const BackupOptions& options)
{
    AXISCOMP_TRY(const auto backup, readGivenBackup(environment, options.file));
    return withDrive(
        environment, options.drive, [&](Environment&, CommandSession& session) -> Result<ExitCode> {
            AXISCOMP_TRY(auto shown, showPlans(environment, session, backup, options.force));
            if (options.isDryRun) {
                environment.print("\nNothing was written (--dry-run).\n");
                environment.document({{"input", options.file}, {"plans", std::move(shown.plans)},
                    {"files", std::move(shown.files)}, {"writes", nullptr}});
                return ExitCode::Done;
            }
            environment.print("\n");
            const WriteInterruption interruption(environment);
            const auto done =
                session.compensator().restore(backup, options.force, session.operation());
            environment.console().clearProgress();
            if (!done) {
                Error error = withHeld(environment, done.error());
                noteWritten(environment, error);
                return fail(std::move(error));
            }
            Json list = showRestored(environment, *done);
            environment.document({{"input", options.file}, {"plans", std::move(shown.plans)},
                {"files", std::move(shown.files)}, {"writes", std::move(list)}});
            return ExitCode::Done;
        });
}

} // namespace

void addBackupCommands(CommandLine& line)
{
    auto saving = std::make_shared<BackupOptions>();
    saving->drive.command = commandName("backup");
    CLI::App* backup = line.add("backup", driveCommands,
        AXISCOMP_HELP("Help",
            "Save everything that this program can change on a whole drive, all axes, to one file"),
        [saving](Environment& environment) { return runBackup(environment, *saving); });
    addDriveOptions(*backup, saving->drive);
    backup
        ->add_option("-o,--output", saving->file,
            AXISCOMP_HELP("Help", "File to write; standard output without it, or with -"))
        ->option_text("FILE");

    auto restoring = std::make_shared<BackupOptions>();
    restoring->drive.command = commandName("restore");
    CLI::App* restore = line.add("restore", driveCommands,
        AXISCOMP_HELP("Help",
            "Restore a whole drive from a backup file, with verified writes; all of them are "
            "planned "
            "first"),
        [restoring](Environment& environment) { return runRestore(environment, *restoring); });
    restore
        ->add_option("FILE", restoring->file,
            AXISCOMP_HELP("Help", "File that `axiscomp backup` wrote; - for standard input"))
        ->required();
    addDriveOptions(*restore, restoring->drive);
    restore->add_flag("--force", restoring->force,
        AXISCOMP_HELP(
            "Help", "Restore to a drive with another serial number, such as a replacement"));
    restore->add_flag("--dry-run", restoring->isDryRun,
        AXISCOMP_HELP("Help", "Show what would be written without writing it"));
}

} // namespace axiscomp::app
