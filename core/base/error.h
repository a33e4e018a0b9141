// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"

#include <span>
#include <string>
#include <string_view>

namespace axiscomp {

/// What went wrong. The program acts on the code and tests compare it; the sentence a person reads
/// is the code's pattern (errorPattern) with the error's context as its arguments. The comment
/// names the arguments that the pattern uses.
enum class ErrorCode {
    // What was asked for
    InvalidArgument, ///< reason
    Cancelled, ///< -
    // Files on this computer
    FileNotReadable, ///< file, reason
    FileNotWritable, ///< file, reason
    FileTooLarge, ///< file, size, limit
    InvalidCalibration, ///< file, count: the diagnostics are beside it
    InvalidMeasurement, ///< file, count: the diagnostics are beside it
    UnitMissing, ///< file; or positions (their units), of values that have none
    InstrumentScale, ///< file
    NoTargets, ///< file
    InvalidTable, ///< field, offset, found, expected (TAM table, docs/tamtbl.md); or as
    ///< VerifyMismatch
    InvalidProfile, ///< file, path (JSON path), reason
    InvalidConfiguration, ///< file, line, reason (TAM configuration)
    InvalidBackup, ///< file, reason
    InvalidRecord, ///< file, reason (.axcal)
    UnknownFormat, ///< file, known
    TableNotFound, ///< table, known
    FormatAmbiguous, ///< file, candidates
    FormatCannotHold, ///< format, reason, wayOut
    SignNotConvertible, ///< position, reason
    SignNotStated, ///< format, sign (that is assumed), statement (how to state it)
    TargetNotKnown, ///< column, sources: whether the values correct one of these or another axis
    TargetMismatch, ///< table, target, axis, role (what the axis is among the sources), statement;
    ///< kept: of a table on the drive or in a backup; restored by a backup, or recovered: axis,
    ///< target, name
    UnitMismatch, ///< what, unit, other; restored: by a backup; recovered: after a write that did
    ///< not end; recorded: of the table of a record; kept: by the axis; or keptKind, number,
    ///< before, source: a position and a temperature
    LargeCorrection, ///< reason
    TableAmbiguous, ///< table, named, numbered
    ResamplingImpossible, ///< reason
    MeasurementState, ///< reason
    PeriodNotResolved, ///< period, filled, classes, fewest
    NoDataThere, ///< count, region, distances
    NotConverged, ///< reason
    // The way to the drive
    InvalidEndpoint, ///< endpoint, reason
    NotConnected, ///< endpoint, reason: nothing was sent
    ConnectionLost, ///< endpoint, reason: it is not known whether the drive acted
    Timeout, ///< endpoint, seconds
    Protocol, ///< endpoint, expected, quote (the beginning of what came)
    Unauthorized, ///< endpoint; given: a user name or a password was
    CertificateRejected, ///< endpoint, reason, fingerprint (SHA-256)
    // What the drive says
    DriveRejected, ///< reason (malformed request, unsupported, internal)
    UnknownRegister, ///< path, nearest (may be empty)
    UnknownFile, ///< path
    NotAllowedNow, ///< reason
    TooLargeForSlot, ///< reason
    TableRefused, ///< reason
    FlashWear, ///< seconds; reserve (when only what putting back may cost is missing); record (when
    ///< it was damaged)
    CompensationError, ///< axis, error (the drive's own), hint
    // Checks before a write, and its outcome
    AxisNotFound, ///< axis, known
    AxisAmbiguous, ///< axis, matches
    NoCompensation, ///< axis: the drive has no compensation registers for it
    SourceMissing, ///< dimension; ofAxis: of one among several
    SourceSurplus, ///< dimension, dimensions
    SourceNotFound, ///< source, nearest
    SourceWrongType, ///< source, type, allowed
    SourceOtherDrive, ///< source, drive, other
    SourceRepeated, ///< source, first, second
    SourceMismatch, ///< doubt (what speaks against the source of a column); axis (whose position it
    ///< is, when the column is of another one)
    DimensionMismatch, ///< table, chosen
    TableTooLarge, ///< size, largest, slot
    SlotNotFound, ///< slot, known
    SlotInUse, ///< slot, user; imported: the axis to which a table would be moved
    NoFreeSlot, ///< size, slots (each with why not)
    NoTable, ///< axis
    NothingToWrite, ///< axis
    NothingUnfinished, ///< axis
    TableNotKept, ///< axis
    NotUndoable, ///< axis, slot
    CompensationActive, ///< axis
    NotHomed, ///< axis
    OtherDrive, ///< expected, found; measured: of a table, or of residuals
    ChangedMeanwhile, ///< what, before, now
    VerifyMismatch, ///< what, expected, found; or layout, slot, dimension, found,
    ///< expected; or unfinished, half or unread, axis, backup: half of a write
    ProofFailed, ///< axis, what, expected, found, position
    OutcomeUnknown, ///< reason, backup: the drive holds the old or the new state, it cannot be
    ///< asked which
    RollbackFailed, ///< reason (why the write failed), rollback (why it could not be undone),
    ///< backup; unfinished: its journal is open
};

/// What kind of thing went wrong: a column of the table of errors, and what programs branch on.
enum class ErrorClass {
    NothingToDo, ///< there is nothing to write, to finish or to undo
    Stopped, ///< by the user
    Local, ///< on this computer, such as a full disk
    Request, ///< what was asked for cannot be
    InputFile,
    Address, ///< is not one of a drive
    Unauthorized,
    Untrusted, ///< the certificate is
    NotConnected, ///< nothing was sent
    Lost, ///< sent, without an answer that can be read: it may have arrived
    Refused, ///< by the drive, or by a check before a write
    FlashWear,
    Difference, ///< the drive has something else than it should
    OutcomeUnknown,
};
[[nodiscard]] ErrorClass errorClass(ErrorCode code);

/// The drive cannot be reached (any more), or not as it was asked for: the link is made anew.
[[nodiscard]] bool isLinkFailure(ErrorCode code);
/// There is no answer to be had from the drive at the moment.
[[nodiscard]] bool isUnreachable(ErrorCode code);
/// The drive may have got the request and carried it out.
[[nodiscard]] bool mayHaveArrived(ErrorCode code);

/// The arguments of the sentence, and what a program acts on: "seconds" and "count" are whole
/// numbers, "path", "endpoint" and "fingerprint" are names.
using ErrorContext = Arguments;

struct Error {
    ErrorCode code = ErrorCode::InvalidArgument;
    ErrorContext context;
    std::string detail; ///< for the log, never needed to understand the sentence
};

/// "ConnectionLost": what the command line prints after "error: ".
[[nodiscard]] std::string_view errorName(ErrorCode code);

[[nodiscard]] TextPattern errorPattern(ErrorCode code);
/// The complete sentence.
[[nodiscard]] Text textOf(const Error& error);
/// The same in English.
[[nodiscard]] std::string sentence(const Error& error);

/// Every code, for tests and for the translations.
[[nodiscard]] std::span<const ErrorCode> allErrorCodes();

} // namespace axiscomp
