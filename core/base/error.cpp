// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace axiscomp {

namespace {

struct Row {
    ErrorCode code;
    std::string_view name;
    std::string_view text;
};

constexpr std::array rows{
    Row{ErrorCode::InvalidArgument, "InvalidArgument", "{reason}"},
    Row{ErrorCode::Cancelled, "Cancelled", "stopped by the user"},
    Row{ErrorCode::FileNotReadable, "FileNotReadable", "{file} cannot be read: {reason}"},
    Row{ErrorCode::FileNotWritable, "FileNotWritable", "{file} cannot be written: {reason}"},
    Row{ErrorCode::FileTooLarge, "FileTooLarge",
        "{file} has {size} bytes, more than the {limit} that such a file can have"},
    Row{ErrorCode::InvalidCalibration, "InvalidCalibration",
        "{file} is not a valid calibration file: {count} problem(s)"},
    Row{ErrorCode::InvalidTable, "InvalidTable",
        "this is not a valid TAM table: {field} at offset {offset} is {found}, expected "
        "{expected}"},
    Row{ErrorCode::InvalidProfile, "InvalidProfile",
        "the drive profile {file} is wrong at {path}: {reason}"},
    Row{ErrorCode::InvalidConfiguration, "InvalidConfiguration",
        "the TAM configuration {file} is wrong in line {line}: {reason}"},
    Row{ErrorCode::InvalidBackup, "InvalidBackup", "{file} is not a valid backup: {reason}"},
    Row{ErrorCode::UnknownFormat, "UnknownFormat",
        "the format of {file} is not known; name one of: {known}"},
    Row{ErrorCode::TableNotFound, "TableNotFound",
        "there is no table {table} in the file; it has: {known}"},
    Row{ErrorCode::FormatAmbiguous, "FormatAmbiguous",
        "{file} can be one of several formats: {candidates}; say which one it is"},
    Row{ErrorCode::FormatCannotHold, "FormatCannotHold",
        "the format {format} cannot hold this table: {reason}; {wayOut}"},
    Row{ErrorCode::SignNotConvertible, "SignNotConvertible",
        "the sign cannot be converted at {position}: {reason}"},
    Row{ErrorCode::ResamplingImpossible, "ResamplingImpossible",
        "the table cannot be resampled: {reason}"},
    Row{ErrorCode::InvalidEndpoint, "InvalidEndpoint",
        "{endpoint} is not the address of a drive: {reason}"},
    Row{ErrorCode::NotConnected, "NotConnected", "no connection to {endpoint}: {reason}"},
    Row{ErrorCode::ConnectionLost, "ConnectionLost",
        "the connection to {endpoint} was lost: {reason}"},
    Row{ErrorCode::Timeout, "Timeout", "{endpoint} did not answer within {seconds} s"},
    Row{ErrorCode::Protocol, "Protocol",
        "{endpoint} did not answer as a drive does: expected {expected}, got {quote}"},
    Row{ErrorCode::Unauthorized, "Unauthorized",
        "{endpoint} asks for a user name and a password; give them as http://user:password@host"},
    Row{ErrorCode::CertificateRejected, "CertificateRejected",
        "the certificate of {endpoint} cannot be trusted: {reason}. Its SHA-256 fingerprint is "
        "{fingerprint}; trust it under Connections, or with --trust-certificate, if the drive has "
        "the same"},
    Row{ErrorCode::DriveRejected, "DriveRejected", "the drive refused: {reason}"},
    Row{ErrorCode::UnknownRegister, "UnknownRegister", "the drive has no register {path}"},
    Row{ErrorCode::UnknownFile, "UnknownFile", "the drive has no file {path}"},
    Row{ErrorCode::NotAllowedNow, "NotAllowedNow", "the drive does not allow this now: {reason}"},
    Row{ErrorCode::TooLargeForSlot, "TooLargeForSlot", "the table does not fit: {reason}"},
    Row{ErrorCode::TableRefused, "TableRefused", "the drive refused the table: {reason}"},
    Row{ErrorCode::FlashWear, "FlashWear",
        "too many flash operations in a short time; wait {seconds} s, or write volatile"},
    Row{ErrorCode::CompensationError, "CompensationError",
        "the compensation of axis {axis} is in error {error}: {hint}"},
    Row{ErrorCode::AxisNotFound, "AxisNotFound", "the drive has no axis {axis}; it has: {known}"},
    Row{ErrorCode::AxisAmbiguous, "AxisAmbiguous",
        "several axes are named {axis}: give the index, one of {matches}"},
    Row{ErrorCode::NoCompensation, "NoCompensation",
        "axis {axis} of this drive has no compensation registers"},
    Row{ErrorCode::SourceMissing, "SourceMissing",
        "the source of dimension {dimension} is missing"},
    Row{ErrorCode::SourceSurplus, "SourceSurplus",
        "there is a source for dimension {dimension}, but only {dimensions} dimension(s)"},
    Row{ErrorCode::SourceNotFound, "SourceNotFound", "the drive has no register {source}{nearest}"},
    Row{ErrorCode::SourceWrongType, "SourceWrongType",
        "{source} is of type {type}; a dimension source must be one of {allowed}"},
    Row{ErrorCode::SourceOtherDrive, "SourceOtherDrive",
        "{source} is a register of the drive {other}; a source must be on the drive itself, "
        "{drive}"},
    Row{ErrorCode::SourceRepeated, "SourceRepeated",
        "{source} is the source of both dimension {first} and dimension {second}"},
    Row{ErrorCode::DimensionMismatch, "DimensionMismatch",
        "the table has {table} dimension(s), but {chosen} are chosen"},
    Row{ErrorCode::TableTooLarge, "TableTooLarge",
        "the table needs {size} bytes, but the largest slot that may be taken, {slot}, holds "
        "{largest}"},
    Row{ErrorCode::SlotNotFound, "SlotNotFound", "the drive has no slot {slot}; it has: {known}"},
    Row{ErrorCode::SlotInUse, "SlotInUse", "slot {slot} is in use by {user}"},
    Row{ErrorCode::NoFreeSlot, "NoFreeSlot",
        "no slot is free for a table of {size} bytes: {slots}; name one to overwrite it"},
    Row{ErrorCode::NoTable, "NoTable", "axis {axis} has no table on the drive; write one first"},
    Row{ErrorCode::NothingToWrite, "NothingToWrite",
        "axis {axis} already has all of this; there is nothing to write"},
    Row{ErrorCode::NothingUnfinished, "NothingUnfinished",
        "no write to axis {axis} is unfinished; there is nothing to finish or to undo"},
    Row{ErrorCode::TableNotKept, "TableNotKept",
        "the new table of the unfinished write to axis {axis} was not kept on this computer: write "
        "it again, or undo the write"},
    Row{ErrorCode::CompensationActive, "CompensationActive",
        "the compensation of axis {axis} is active; deactivate it first"},
    Row{ErrorCode::NotHomed, "NotHomed", "axis {axis} must be homed first"},
    Row{ErrorCode::OtherDrive, "OtherDrive",
        "this is another drive: expected serial number {expected}, found {found}"},
    Row{ErrorCode::ChangedMeanwhile, "ChangedMeanwhile",
        "somebody else changed {what} from {before} to {now}; nothing was written, look again"},
    Row{ErrorCode::VerifyMismatch, "VerifyMismatch",
        "{what} read back as {found}, but {expected} was written"},
    Row{ErrorCode::ProofFailed, "ProofFailed",
        "the drive does not add what it should: {what} at {position} is {found}, expected "
        "{expected}"},
    Row{ErrorCode::OutcomeUnknown, "OutcomeUnknown",
        "{reason}. The drive holds the complete old or the complete new state; ask for the status "
        "when it answers again. The old state is kept in {backup}"},
    Row{ErrorCode::RollbackFailed, "RollbackFailed",
        "{reason}; putting the old state back failed too ({rollback}). Do not activate the axis; "
        "restore it from {backup}"},
};

constexpr auto codes = [] {
    std::array<ErrorCode, rows.size()> result{};
    for (std::size_t i = 0; i < rows.size(); ++i)
        result[i] = rows[i].code;
    return result;
}();

const Row& rowOf(ErrorCode code)
{
    const auto row = std::ranges::find(rows, code, &Row::code);
    assert(row != rows.end());
    return *row;
}

} // namespace

std::string_view errorName(ErrorCode code)
{
    return rowOf(code).name;
}

std::string_view errorTemplate(ErrorCode code)
{
    return rowOf(code).text;
}

std::string_view errorTemplate(const Error& error)
{
    if (error.code == ErrorCode::FlashWear && error.context.contains("reserve"))
        return "the flash operations that are left would do for the change, but not for putting "
               "everything back if it fails; wait {seconds} s, or write volatile";
    return errorTemplate(error.code);
}

std::string fillTemplate(std::string_view text, const ErrorContext& context)
{
    std::string result;
    while (true) {
        const std::size_t open = text.find('{');
        const std::size_t close = text.find('}', open);
        if (open == std::string_view::npos || close == std::string_view::npos)
            return result.append(text);
        const auto value = context.find(text.substr(open + 1, close - open - 1));
        result.append(text.substr(0, open)).append(value == context.end() ? "?" : value->second);
        text.remove_prefix(close + 1);
    }
}

std::string sentence(const Error& error)
{
    return fillTemplate(errorTemplate(error), error.context);
}

std::span<const ErrorCode> allErrorCodes()
{
    return codes;
}

} // namespace axiscomp
