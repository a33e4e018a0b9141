// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/output/drive_json.h"
#include "app/cli/output/output_file.h"
#include "app/cli/output/write_text.h"
#include "app/cli/session/write_run.h"
#include "app/common/number_text.h"
#include "app/common/text_table.h"
#include "core/io/local_file.h"

#include <algorithm>

namespace axiscomp::app {

namespace {

/// More than any table file of a drive; it has the last word.
constexpr std::uint64_t maximumUpload = 64 * 1024 * 1024;

struct TransferOptions {
    DriveOptions drive;
    std::string file; ///< on this computer
    std::string path; ///< on the drive
};

std::string slotOf(const CommandSession& session, const std::string& path)
{
    const TableSlot* const slot = session.profile().slotOfFile(path);
    return slot ? slot->name : "";
}

Result<ExitCode> runFiles(Environment& environment, CommandSession& session)
{
    AXISCOMP_TRY(const auto files, session.compensator().files(session.operation()));
    TextTable table({"file", "slot", ">size", ">maximum size"});
    Json list = Json::array();
    for (const DriveFile& file : files) {
        table.add({file.path, slotOf(session, file.path),
            file.size == 0 ? "empty" : countText(file.size), countText(file.maximumSize)});
        list.push_back(toJson(file));
    }
    environment.print(table.text(""));
    environment.document({{"files", std::move(list)}});
    return ExitCode::Done;
}

Result<ExitCode> runUpload(Environment& environment, const TransferOptions& options)
{
    AXISCOMP_TRY(const auto bytes, loadFile(pathFromText(options.file), maximumUpload));
    return withDrive(
        environment, options.drive, [&](Environment&, CommandSession& session) -> Result<ExitCode> {
            AXISCOMP_TRY(const auto plan,
                session.compensator().planUpload(options.path, bytes, session.operation()));
            if (plan.flashOperations > 0)
                environment.print(
                    "Flash: " + flashWords(plan.flashOperations, plan.flashBudget) + "\n");
            static_cast<void>(environment.console().flush()); // before it is done
            const WriteInterruption interruption(environment);
            AXISCOMP_TRY(auto uploaded,
                session.compensator().upload(
                    options.path, bytes, session.operation(), plan.drive.serialNumber));
            environment.document(
                {{"input", options.file}, {"path", options.path}, {"bytes", bytes.size()},
                    {"persistent", plan.persistent}, {"flashOperations", plan.flashOperations},
                    {"verified", true}, {"backup", uploaded.string()}});
            if (uploaded.empty())
                environment.print(
                    options.path + " holds exactly this already: nothing was sent.\n");
            else
                environment.report("Uploaded " + options.file + " to " + options.path + ": "
                    + plural(bytes.size(), "byte", "bytes")
                    + ", every one read back and compared.\nBackup of the old file: "
                    + uploaded.string() + "\n");
            return ExitCode::Done;
        });
}

Result<ExitCode> runDownload(Environment& environment, const TransferOptions& options)
{
    const Output output{options.file, options.drive.command};
    AXISCOMP_CHECK(checkOutput(environment, output, false));
    return withDrive(
        environment, options.drive, [&](Environment&, CommandSession& session) -> Result<ExitCode> {
            AXISCOMP_TRY(const auto bytes,
                session.compensator().download(options.path, session.operation()));
            AXISCOMP_CHECK(writeOutput(environment, output, bytes));
            environment.document(
                {{"path", options.path}, {"output", options.file}, {"bytes", bytes.size()}});
            if (!output.isStandardOutput())
                environment.print("Wrote " + options.file + ": " + options.path + ", "
                    + plural(bytes.size(), "byte", "bytes") + ".\n");
            return ExitCode::Done;
        });
}

} // namespace

void addTransferCommands(CommandLine& line)
{
    auto listing = std::make_shared<DriveOptions>();
    listing->command = commandName("files");
    CLI::App* files = line.add("files", driveCommands,
        AXISCOMP_HELP("Help", "List the table files of a drive"),
        [listing](Environment& environment) { return withDrive(environment, *listing, runFiles); });
    addDriveOptions(*files, *listing);

    auto sending = std::make_shared<TransferOptions>();
    sending->drive.command = commandName("upload");
    CLI::App* upload = line.add("upload", driveCommands,
        AXISCOMP_HELP(
            "Help", "Upload a file unchanged and verify it, for drive programs that use tables"),
        [sending](Environment& environment) { return runUpload(environment, *sending); });
    upload->add_option("FILE", sending->file, AXISCOMP_HELP("Help", "File on this computer"))
        ->required();
    upload
        ->add_option("--to", sending->path,
            AXISCOMP_HELP("Help", "Path in the drive, such as tables/small1.TAMtbl"))
        ->option_text("PATH (required)")
        ->required();
    addDriveOptions(*upload, sending->drive);

    auto fetching = std::make_shared<TransferOptions>();
    fetching->drive.command = commandName("download");
    CLI::App* download =
        line.add("download", driveCommands, AXISCOMP_HELP("Help", "Download a file unchanged"),
            [fetching](Environment& environment) { return runDownload(environment, *fetching); });
    download
        ->add_option("PATH", fetching->path,
            AXISCOMP_HELP("Help", "Path in the drive, such as tables/small1.TAMtbl"))
        ->required();
    download
        ->add_option("-o,--output", fetching->file,
            AXISCOMP_HELP("Help", "File to write; standard output without it, or with -"))
        ->option_text("FILE");
    addDriveOptions(*download, fetching->drive);
}

} // namespace axiscomp::app
