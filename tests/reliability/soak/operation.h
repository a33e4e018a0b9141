// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/axis_compensator.h"
#include "drivecomm/virtualdrive/faults.h"
#include "tests/support/faulty_link.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

namespace axiscomp::test {

/// What a program, or somebody at the machine, does.
enum class Action {
    Write,
    SetPersistency,
    RestorePrevious, ///< the backup that the last write of an axis left
    RestoreOld, ///< a backup of the whole drive that was made some time ago
    Upload, ///< the plain file transfer, into a slot of a drive program
    Settle, ///< an unfinished write: which state did it leave?
    Finish, ///< an unfinished write
    Undo, ///< an unfinished write
    Activate,
    Evaluate,
    Deactivate,
    Prove,
    Status,
    Plan,
    Backup,
    Download,
    Reboot, ///< somebody switches the drive off and on
    Home, ///< somebody homes the axes
    PassTime,
};
inline constexpr std::array actionNames{"write", "set persistency", "restore previous",
    "restore old backup", "plain upload", "settle unfinished", "finish unfinished",
    "undo unfinished", "activate", "evaluate", "deactivate", "prove", "status", "plan", "backup",
    "download", "reboot", "home", "pass time"};

/// What goes wrong, at the exchange with this number, or on the wire.
struct Mishap {
    std::optional<LinkFault> fault;
    std::optional<drivecomm::FaultSpec> onTheWire;
    int exchange = 1;
};
[[nodiscard]] std::string mishapName(const Mishap& mishap);

struct Operation {
    Action action = Action::Status;
    std::size_t program = 0;
    int axis = 0;
    WriteRequest request; ///< Write, Plan
    Persistency persistency = Persistency::Volatile; ///< SetPersistency
    std::optional<DriveBackup> backup; ///< RestorePrevious, RestoreOld
    std::optional<JournalEntry> journal; ///< Settle, Finish, Undo
    std::string path; ///< Upload, Download
    Bytes file; ///< Upload; Finish: the table that the journal keeps
    std::chrono::seconds time{0}; ///< PassTime
    std::optional<Mishap> mishap;

    /// "program 1 (web): write to axis 0, ..., reply lost at exchange 12"
    [[nodiscard]] std::string text() const;
    /// It may change the setup of its axis, or of all for a backup of the whole drive.
    [[nodiscard]] bool changesSetup() const;
    [[nodiscard]] bool isRestore() const
    {
        return action == Action::RestorePrevious || action == Action::RestoreOld;
    }
};

/// What came of an operation.
struct Ending {
    bool hasDied = false; ///< the program, in the middle
    bool hasStruck = false; ///< what was to go wrong did go wrong
    std::optional<Error> error;
    std::optional<AxisStatus> status; ///< Status, Activate, Evaluate, Deactivate
    std::vector<WriteReport> reports; ///< of what changes setups
    std::optional<WritePlan> plan;
    std::optional<DriveBackup> backup;
    std::optional<Bytes> file; ///< Download
    std::optional<AxisCompensator::UnfinishedOutcome> settled;

    [[nodiscard]] bool isDone() const { return !hasDied && !error; }
    [[nodiscard]] bool is(ErrorCode code) const { return error && error->code == code; }
    /// The drive was out of reach: the program could not end what it had begun.
    [[nodiscard]] bool isOutOfReach() const
    {
        return is(ErrorCode::ConnectionLost) || is(ErrorCode::Timeout) || is(ErrorCode::Protocol)
            || is(ErrorCode::NotConnected);
    }
    /// Nobody can know what the drive holds now. An undoing that was interrupted leaves the write
    /// unfinished (AxisCompensator::undoUnfinished).
    [[nodiscard]] bool isUncertain(const Operation& operation) const
    {
        return hasDied || is(ErrorCode::OutcomeUnknown) || is(ErrorCode::RollbackFailed)
            || (operation.action == Action::Undo && isOutOfReach());
    }
    /// "done", "died", or the error's name
    [[nodiscard]] std::string name() const;
    [[nodiscard]] std::string text() const;
};

/// Lets a compensator do it; throws ProgramDied when the program does not survive.
void carryOut(const Operation& operation, AxisCompensator& compensator,
    const OperationOptions& options, Ending& ending);

} // namespace axiscomp::test
