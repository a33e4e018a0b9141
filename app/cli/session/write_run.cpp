// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/session/write_run.h"

#include "app/cli/output/drive_json.h"
#include "app/cli/output/status_text.h"
#include "app/cli/output/write_text.h"

#include <vector>

namespace axiscomp::app {

namespace {

/// The step that announces the end is none.
constexpr std::string_view lastStep = "done";
constexpr std::string_view undoStep = "putting back";

/// AxisCompensator::write: after any error but these the drive holds the old state.
std::string_view driveHolds(ErrorCode code)
{
    switch (code) {
    case ErrorCode::OutcomeUnknown:
        return "old or new";
    case ErrorCode::RollbackFailed:
        return "neither";
    case ErrorCode::OtherDrive:
    case ErrorCode::ChangedMeanwhile: // by somebody else, or by a restart
        return "other";
    default:
        return "old";
    }
}

/// Which of several writes one is; of one that is alone there are no names.
struct WriteTurn {
    std::span<const std::string> names;
    std::size_t number = 0;
};

Result<WriteReport> carryOut(Environment& environment, CommandSession& session, int axis,
    const WriteRequest& request, const WriteTurn& turn)
{
    const WriteInterruption interruption(environment);
    StepLog log(environment);
    OperationOptions operation = session.operation();
    operation.progress = [&, progress = operation.progress](const Progress& now) {
        log.show(now);
        progress(now);
    };
    environment.print("\n");
    // Whoever watches reads the plan before it is carried out.
    static_cast<void>(environment.console().flush());
    auto report = session.compensator().write(axis, request, operation);
    environment.console().clearProgress();
    if (report)
        return report;
    if (report.error().code == ErrorCode::NothingToWrite)
        return report;
    log.failed();
    // What is said of the drive depends on what was written before.
    Error error = std::move(report).error();
    if (!turn.names.empty())
        error = ofSeveral(std::move(error), turn.names, turn.number);
    return fail(withHeld(environment, std::move(error)));
}

/// writeAndReport for one of several.
Result<WriteOutcome> writeOne(Environment& environment, CommandSession& session, int axis,
    const WriteRequest& request, bool isDryRun, const WriteTurn& turn)
{
    AXISCOMP_TRY(const auto before, settledStatus(environment, session, axis));
    const auto plan = session.compensator().plan(axis, request, session.operation());
    environment.console().clearProgress();
    if (!plan)
        return fail(plan.error());
    environment.print(planText(*plan, before.status.axis));
    for (const Text& remark : plan->unitRemarks)
        environment.console().note("note: " + remark.english());
    for (const Text& warning : plan->warnings)
        environment.warn(warning.english());
    for (const Text& large : plan->largeCorrections)
        environment.warn(large.english());
    if (isDryRun && !checkLargeAccepted(*plan, request))
        environment.warn("Writing this needs --accept-large. Check the unit of the values first.");
    WriteOutcome outcome{{{"plan", toJson(*plan)}, {"report", nullptr}}, {}};
    if (isDryRun) {
        environment.print("\nNothing was written (--dry-run).\n");
        return outcome;
    }
    AXISCOMP_CHECK(checkLargeAccepted(*plan, request));

    WriteRequest asPlanned = request;
    expectAsPlanned(asPlanned, *plan);
    const auto report = carryOut(environment, session, axis, asPlanned, turn);
    const bool nothingToDo = !report && report.error().code == ErrorCode::NothingToWrite;
    if (!report && !nothingToDo)
        return fail(report.error());
    if (report) {
        environment.report(reportText(*report, session.driveOption(), session.isDemo()));
        outcome.document["report"] = toJson(*report);
        outcome.now = report->now;
    } else {
        environment.print("Nothing had to be written.\n");
        outcome.now = before.status;
    }
    return outcome;
}

} // namespace

Error withHeld(Environment& environment, Error error)
{
    // Without the lock nothing was looked at: who has it is writing.
    const bool isLockedOut = error.context.contains(DriveStore::missingLock);
    const bool isLost = error.context.contains("lost");
    const std::string_view held = isLockedOut || isLost ? "other" : driveHolds(error.code);
    error.context.set("driveHolds", held);
    const bool isFirst = error.context.english("written").empty();
    if (held == "old")
        environment.console().note(isFirst ? "note: the drive holds the complete old state"
                                           : "note: what failed has its complete old state");
    if (isLost)
        environment.console().note("note: all of it was written, but the drive may not hold it any "
                                   "more; see `axiscomp status`");
    else if (held == "other" && isFirst)
        environment.console().note("note: nothing was written; see `axiscomp status` for what the "
                                   "drive holds now");
    return error;
}

void noteWritten(Environment& environment, const Error& error)
{
    const std::string written = error.context.english("written");
    const std::string notWritten = error.context.english("notWritten");
    if (!written.empty())
        environment.console().note("note: written before the error: " + written
            + (notWritten.empty() ? "" : "; not written: " + notWritten));
}

WriteInterruption::WriteInterruption(Environment& environment) : m_environment(environment)
{
    environment.interrupt().setListener([&console = environment.console()](int count) {
        console.note(count == 1 ? "stopping: what was changed is being put back, please wait"
                                : "still putting the old state back, please wait: the drive must "
                                  "not be left in between");
    });
}

WriteInterruption::~WriteInterruption()
{
    m_environment.interrupt().setListener({});
}

StepLog::StepLog(Environment& environment, Undoing undoing)
    : m_environment(environment)
    , m_undoing(undoing)
{
}

void StepLog::show(const Progress& progress)
{
    if (progress.step == m_step)
        return;
    const bool hasFailed = progress.step == undoStep && m_undoing == Undoing::ForFailure;
    end(hasFailed ? "failed" : "ok    ");
    m_step = progress.step == lastStep ? "" : progress.step;
}

void StepLog::failed()
{
    end(m_step == undoStep && m_undoing == Undoing::ForFailure ? "ended " : "failed");
    m_step.clear();
}

void StepLog::end(const char* outcome)
{
    if (m_step.empty())
        return;
    m_environment.print("  " + std::string(outcome) + "  " + stepWords(m_step) + "\n");
    // The lines are for watching, also through a pipe; a broken one is reported at the end.
    static_cast<void>(m_environment.console().flush());
}

Result<WriteOutcome> writeAndReport(Environment& environment, CommandSession& session, int axis,
    const WriteRequest& request, bool isDryRun)
{
    return writeOne(environment, session, axis, request, isDryRun, {});
}

Result<Json> writeSeveral(Environment& environment, CommandSession& session,
    std::span<const AxisWrite> writes, std::span<const std::string> names, bool isDryRun)
{
    AXISCOMP_TRY(
        const auto plans, planMultiAxis(session.compensator(), writes, session.operation()));
    WriteSequence sequence = sequenceOf(writes);
    for (std::size_t n = 0; n < writes.size() && !isDryRun; ++n)
        AXISCOMP_CHECK(checkLargeAccepted(plans[n], writes[n].request));
    Json documents = Json::array();
    for (std::size_t n = 0; n < writes.size(); ++n) {
        if (n > 0)
            environment.print("\n");
        WriteRequest request = writes[n].request;
        sequence.begin(writes[n].axis, request);
        auto outcome =
            writeOne(environment, session, writes[n].axis, request, isDryRun, {names, n});
        if (!outcome && isDryRun)
            return fail(outcome.error());
        if (!outcome) {
            Error error = ofSeveral(outcome.error(), names, n);
            noteWritten(environment, error);
            return fail(std::move(error));
        }
        sequence.add(plans[n]);
        documents.push_back(std::move(outcome->document));
    }
    return documents;
}

Result<ExitCode> runWrite(Environment& environment, CommandSession& session, int axis,
    const WriteRequest& request, bool isDryRun)
{
    AXISCOMP_TRY(const auto outcome, writeAndReport(environment, session, axis, request, isDryRun));
    environment.document(outcome.document);
    return ExitCode::Done;
}

} // namespace axiscomp::app
