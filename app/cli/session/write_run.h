// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/session/command_session.h"
#include "core/compensator/multi_axis_write.h"

#include <optional>
#include <span>
#include <string>

namespace axiscomp::app {

/// Tells on standard error what Ctrl-C does while a drive is being changed.
class WriteInterruption {
public:
    explicit WriteInterruption(Environment& environment);
    WriteInterruption(const WriteInterruption&) = delete;
    WriteInterruption& operator=(const WriteInterruption&) = delete;
    ~WriteInterruption();

private:
    Environment& m_environment;
};

/// The error of a write with what the drive holds (`driveHolds`), of which people get a note.
[[nodiscard]] Error withHeld(Environment& environment, Error error);
/// Which of several were written before an error, as its context has it (core's ofSeveral).
void noteWritten(Environment& environment, const Error& error);

/// Prints a line for every step that has ended.
class StepLog {
public:
    /// Putting back is what is wanted, or what a failed step makes necessary.
    enum class Undoing { Wanted, ForFailure };
    explicit StepLog(Environment& environment, Undoing undoing = Undoing::ForFailure);

    void show(const Progress& progress);
    /// The last step failed.
    void failed();

private:
    void end(const char* outcome);

    Environment& m_environment;
    Undoing m_undoing;
    std::string m_step;
};

/// What a write has come to.
struct WriteOutcome {
    Json document; ///< {"plan", "report"}
    std::optional<AxisStatus> now; ///< of the axis, read back with the write; none: a dry run
};
/// Plans, shows the plan, writes and reports in text; only shows the plan when isDryRun.
[[nodiscard]] Result<WriteOutcome> writeAndReport(Environment& environment, CommandSession& session,
    int axis, const WriteRequest& request, bool isDryRun);
/// Plans all of them before the first is written, then one after the other. names: of their axes,
/// for people. The documents of each.
[[nodiscard]] Result<Json> writeSeveral(Environment& environment, CommandSession& session,
    std::span<const AxisWrite> writes, std::span<const std::string> names, bool isDryRun);
/// The same as writeAndReport, with its document.
[[nodiscard]] Result<ExitCode> runWrite(Environment& environment, CommandSession& session, int axis,
    const WriteRequest& request, bool isDryRun);

} // namespace axiscomp::app
