// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/output/drive_json.h"
#include "app/cli/output/status_text.h"
#include "app/cli/session/write_run.h"
#include "app/common/number_text.h"

namespace axiscomp::app {

namespace {

struct RecoverOptions {
    DriveOptions drive;
    bool finishes = false;
    bool undoes = false;
};

using Outcome = AxisCompensator::UnfinishedOutcome;
using Recovery = AxisCompensator::Recovery;

Json errorOrNull(const std::optional<Error>& error)
{
    return error ? toJson(*error, Json::array()) : Json(nullptr);
}

std::string possibilityText(const char* name, const char* option, const std::string& consequence,
    const std::optional<Error>& obstacle)
{
    return std::string("  ") + name
        + (obstacle ? "not possible now: " + sentence(*obstacle)
                    : "`axiscomp recover " + std::string(option) + "` " + consequence)
        + "\n";
}

std::string recoveryText(const Recovery& recovery)
{
    const auto cost = [](const char* costs, int operations) {
        return operations == 0 ? std::string("; it needs no flash")
                               : costs
                + plural(
                    static_cast<std::uint64_t>(operations), "flash operation", "flash operations");
    };
    return "What can be done:\n"
        + possibilityText("Finish: ", "--finish",
            "brings the complete new state about"
                + cost("; it costs ", recovery.finishFlashOperations),
            recovery.finishObstacle)
        + possibilityText("Undo:   ", "--undo",
            "brings the complete old state back"
                + cost("; it costs at most ", recovery.undoFlashOperations),
            recovery.undoObstacle);
}

/// With nothing unfinished and nothing done.
Json recoverDocument()
{
    return {{"unfinishedWrite", nullptr}, {"isBeingWritten", false}, {"finishObstacle", nullptr},
        {"finishFlashOperations", nullptr}, {"undoObstacle", nullptr},
        {"undoFlashOperations", nullptr}, {"doubts", Json::array()}, {"report", nullptr}};
}

void sayDoubts(Environment& environment, const Recovery& recovery, Json& document)
{
    for (const Text& doubt : recovery.doubts)
        environment.warn(doubt.english());
    document["doubts"] = englishOf(recovery.doubts);
}

/// Only says what there is and what is possible.
ExitCode explain(Environment& environment, const SettledWrite& settled)
{
    Json json = recoverDocument();
    json["unfinishedWrite"] = unfinishedToJson(settled.entry, settled.outcome);
    std::string text = outcomeSentence(settled);
    text.front() = 'A';
    environment.print(text + ".\n");
    sayDoubts(environment, settled.recovery, json);
    if (settled.outcome != Outcome::New) {
        json["finishObstacle"] = errorOrNull(settled.recovery.finishObstacle);
        json["undoObstacle"] = errorOrNull(settled.recovery.undoObstacle);
        if (!settled.recovery.finishObstacle)
            json["finishFlashOperations"] = settled.recovery.finishFlashOperations;
        if (!settled.recovery.undoObstacle)
            json["undoFlashOperations"] = settled.recovery.undoFlashOperations;
        environment.print("\n" + recoveryText(settled.recovery));
    }
    environment.document(json);
    return ExitCode::Done;
}

Result<WriteReport> carryOut(
    Environment& environment, CommandSession& session, const JournalEntry& entry, bool finishes)
{
    const WriteInterruption interruption(environment);
    StepLog log(environment, finishes ? StepLog::Undoing::ForFailure : StepLog::Undoing::Wanted);
    OperationOptions operation = session.operation();
    operation.progress = [&, progress = operation.progress](const Progress& now) {
        log.show(now);
        progress(now);
    };
    auto report = finishes ? session.compensator().finishUnfinished(entry, operation)
                           : session.compensator().undoUnfinished(entry, operation);
    environment.console().clearProgress();
    if (report)
        return report;
    log.failed();
    environment.console().note("note: the write is still unfinished; `axiscomp recover` says what "
                               "can be done");
    return report;
}

ExitCode nothingUnfinished(Environment& environment, int axis)
{
    environment.print(sentence({ErrorCode::NothingUnfinished, {{"axis", axis}}, {}}) + "\n");
    environment.document(recoverDocument());
    return ExitCode::Done;
}

Result<ExitCode> explainUnfinished(Environment& environment, CommandSession& session, int axis)
{
    AXISCOMP_TRY(const auto now,
        axiscomp::settledStatus(
            session.compensator(), session.storeRoot(), axis, session.operation()));
    if (now.settlingProblem)
        return fail(*now.settlingProblem);
    if (now.isBeingWritten) {
        environment.print(beingWritten(now.status.axis) + "\n");
        Json document = recoverDocument();
        document["isBeingWritten"] = true;
        environment.document(document);
        return ExitCode::Done;
    }
    return now.settled ? explain(environment, *now.settled) : nothingUnfinished(environment, axis);
}

/// Waits for a program that is writing, and is refused when that one has ended its write.
Result<ExitCode> recoverUnfinished(
    Environment& environment, CommandSession& session, int axis, bool finishes)
{
    AXISCOMP_TRY(const auto status, session.compensator().status(axis, session.operation()));
    if (!status.unfinishedWrite)
        return nothingUnfinished(environment, axis);
    Json document = recoverDocument();
    // Where it is not known, as while another program is writing, what is begun below says why.
    if (const auto recovery =
            session.compensator().recovery(*status.unfinishedWrite, session.operation()))
        sayDoubts(environment, *recovery, document);
    AXISCOMP_TRY(
        const auto report, carryOut(environment, session, *status.unfinishedWrite, finishes));
    environment.report(std::string(finishes ? "\nFinished: the drive holds the complete new state"
                                            : "\nUndone: the drive holds the complete old state")
        + ", read back and compared.\nBackup of what there was before: " + report.backup.string()
        + "\n");
    document["report"] = toJson(report);
    environment.document(document);
    return ExitCode::Done;
}

Result<ExitCode> runRecover(
    Environment& environment, CommandSession& session, int axis, const RecoverOptions& options)
{
    return options.finishes || options.undoes
        ? recoverUnfinished(environment, session, axis, options.finishes)
        : explainUnfinished(environment, session, axis);
}

} // namespace

void addRecoverCommand(CommandLine& line)
{
    auto options = std::make_shared<RecoverOptions>();
    options->drive.command = commandName("recover");
    CLI::App* command = line.add("recover", driveCommands,
        AXISCOMP_HELP("Help",
            "Finish or undo an interrupted write; without an option, say which is possible"),
        [options](Environment& environment) {
            return withAxis(environment, options->drive,
                [options](Environment& sameEnvironment, CommandSession& session, int axis) {
                    return runRecover(sameEnvironment, session, axis, *options);
                });
        });
    addDriveOptions(*command, options->drive);
    addAxisOption(*command, options->drive);
    CLI::Option* finish = command->add_flag("--finish", options->finishes,
        AXISCOMP_HELP("Help", "Bring the complete new state about, from whatever there is now"));
    command
        ->add_flag("--undo", options->undoes,
            AXISCOMP_HELP("Help", "Bring back the complete state before the write"))
        ->excludes(finish);
}

} // namespace axiscomp::app
