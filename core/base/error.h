// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <map>
#include <span>
#include <string>
#include <string_view>

namespace axiscomp {

/// What went wrong. The program acts on the code and tests compare it; the sentence a person reads
/// is made from the code's template (errorTemplate) and the error's context. The comment names the
/// context keys that the template uses.
enum class ErrorCode {
    // What was asked for
    InvalidArgument, ///< reason
    Cancelled, ///< -
    // Files on this computer
    FileNotReadable, ///< file, reason
    FileNotWritable, ///< file, reason
    FileTooLarge, ///< file, size, limit
    InvalidCalibration, ///< file, count: the diagnostics are beside it
    InvalidTable, ///< field, offset, found, expected (TAM table, docs/tamtbl.md)
    InvalidProfile, ///< file, path (JSON path), reason
    InvalidConfiguration, ///< file, line, reason (TAM configuration)
    InvalidBackup, ///< file, reason
    UnknownFormat, ///< file, known
    TableNotFound, ///< table, known
    FormatAmbiguous, ///< file, candidates
    FormatCannotHold, ///< format, reason, wayOut
    SignNotConvertible, ///< position, reason
    ResamplingImpossible, ///< reason
    // The way to the drive
    InvalidEndpoint, ///< endpoint, reason
    NotConnected, ///< endpoint, reason: nothing was sent
    ConnectionLost, ///< endpoint, reason: it is not known whether the drive acted
    Timeout, ///< endpoint, seconds
    Protocol, ///< endpoint, expected, quote (the beginning of what came)
    Unauthorized, ///< endpoint
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
    SourceMissing, ///< dimension
    SourceSurplus, ///< dimension, dimensions
    SourceNotFound, ///< source, nearest
    SourceWrongType, ///< source, type, allowed
    SourceOtherDrive, ///< source, drive, other
    SourceRepeated, ///< source, first, second
    DimensionMismatch, ///< table, chosen
    TableTooLarge, ///< size, largest, slot
    SlotNotFound, ///< slot, known
    SlotInUse, ///< slot, user
    NoFreeSlot, ///< size, slots (each with why not)
    NoTable, ///< axis
    NothingToWrite, ///< axis
    NothingUnfinished, ///< axis
    TableNotKept, ///< axis
    CompensationActive, ///< axis
    NotHomed, ///< axis
    OtherDrive, ///< expected, found
    ChangedMeanwhile, ///< what, before, now
    VerifyMismatch, ///< what, expected, found
    ProofFailed, ///< axis, what, expected, found, position
    OutcomeUnknown, ///< reason, backup: the drive holds the old or the new state, it cannot be
    ///< asked which
    RollbackFailed, ///< reason (why the write failed), rollback (why it could not be undone),
    ///< backup
};

/// The drive cannot be reached (any more), or not as it was asked for: the link is made anew.
[[nodiscard]] constexpr bool isLinkFailure(ErrorCode code)
{
    switch (code) {
    case ErrorCode::InvalidEndpoint:
    case ErrorCode::NotConnected:
    case ErrorCode::ConnectionLost:
    case ErrorCode::Timeout:
    case ErrorCode::Protocol:
    case ErrorCode::Unauthorized:
    case ErrorCode::CertificateRejected:
        return true;
    default:
        return false;
    }
}

using ErrorContext = std::map<std::string, std::string, std::less<>>;

struct Error {
    ErrorCode code = ErrorCode::InvalidArgument;
    ErrorContext context;
    std::string detail; ///< for the log, never needed to understand the sentence
};

/// "ConnectionLost": what the command line prints after "error: ".
[[nodiscard]] std::string_view errorName(ErrorCode code);

/// The English sentence with {key} placeholders. The window translates this text.
[[nodiscard]] std::string_view errorTemplate(ErrorCode code);
/// The same, where the context asks for another sentence.
[[nodiscard]] std::string_view errorTemplate(const Error& error);

/// Replaces each {key} by its value; a key without a value becomes "?".
[[nodiscard]] std::string fillTemplate(std::string_view text, const ErrorContext& context);

/// The complete English sentence.
[[nodiscard]] std::string sentence(const Error& error);

/// Every code, for tests and for the translations.
[[nodiscard]] std::span<const ErrorCode> allErrorCodes();

} // namespace axiscomp
