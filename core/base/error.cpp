// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cassert>

namespace axiscomp {

namespace {

struct ErrorRow {
    ErrorCode code;
    std::string_view name;
    std::string_view text;
};

constexpr std::array errorRows{
    ErrorRow{ErrorCode::InvalidArgument, "InvalidArgument", "{reason}"},
    ErrorRow{ErrorCode::Cancelled, "Cancelled", "stopped by the user"},
    ErrorRow{ErrorCode::FileNotReadable, "FileNotReadable", "{file} cannot be read: {reason}"},
    ErrorRow{ErrorCode::FileNotWritable, "FileNotWritable", "{file} cannot be written: {reason}"},
    ErrorRow{ErrorCode::FileTooLarge, "FileTooLarge",
        "{file} has {size} bytes, more than the {limit} that such a file can have"},
    ErrorRow{ErrorCode::InvalidCalibration, "InvalidCalibration",
        "{file} is not a valid calibration file: {count} problem(s)"},
    ErrorRow{ErrorCode::InvalidTable, "InvalidTable",
        "this is not a valid TAM table: {field} at offset {offset} is {found}, expected "
        "{expected}"},
    ErrorRow{ErrorCode::InvalidProfile, "InvalidProfile",
        "the drive profile {file} is wrong at {path}: {reason}"},
    ErrorRow{ErrorCode::InvalidConfiguration, "InvalidConfiguration",
        "the TAM configuration {file} is wrong in line {line}: {reason}"},
    ErrorRow{ErrorCode::InvalidBackup, "InvalidBackup", "{file} is not a valid backup: {reason}"},
    ErrorRow{ErrorCode::UnknownFormat, "UnknownFormat",
        "the format of {file} is not known; name one of: {known}"},
    ErrorRow{ErrorCode::TableNotFound, "TableNotFound",
        "there is no table {table} in the file; it has: {known}"},
    ErrorRow{ErrorCode::FormatAmbiguous, "FormatAmbiguous",
        "{file} can be one of several formats: {candidates}; say which one it is"},
    ErrorRow{ErrorCode::FormatCannotHold, "FormatCannotHold",
        "the format {format} cannot hold this table: {reason}; {wayOut}"},
    ErrorRow{ErrorCode::SignNotConvertible, "SignNotConvertible",
        "the sign cannot be converted at {position}: {reason}"},
    ErrorRow{ErrorCode::ResamplingImpossible, "ResamplingImpossible",
        "the table cannot be resampled: {reason}"},
    ErrorRow{ErrorCode::InvalidEndpoint, "InvalidEndpoint",
        "{endpoint} is not the address of a drive: {reason}"},
    ErrorRow{ErrorCode::NotConnected, "NotConnected", "no connection to {endpoint}: {reason}"},
    ErrorRow{ErrorCode::ConnectionLost, "ConnectionLost",
        "the connection to {endpoint} was lost: {reason}"},
    ErrorRow{ErrorCode::Timeout, "Timeout", "{endpoint} did not answer within {seconds} s"},
    ErrorRow{ErrorCode::Protocol, "Protocol",
        "{endpoint} did not answer as a drive does: expected {expected}, got {quote}"},
    ErrorRow{ErrorCode::Unauthorized, "Unauthorized",
        "{endpoint} asks for a user name and a password; give them as http://user:password@host"},
    ErrorRow{ErrorCode::CertificateRejected, "CertificateRejected",
        "the certificate of {endpoint} cannot be trusted: {reason}. Its SHA-256 fingerprint is "
        "{fingerprint}; trust it under Connections, or with --trust-certificate, if the drive has "
        "the same"},
    ErrorRow{ErrorCode::DriveRejected, "DriveRejected", "the drive refused: {reason}"},
    ErrorRow{ErrorCode::UnknownRegister, "UnknownRegister", "the drive has no register {path}"},
    ErrorRow{ErrorCode::UnknownFile, "UnknownFile", "the drive has no file {path}"},
    ErrorRow{
        ErrorCode::NotAllowedNow, "NotAllowedNow", "the drive does not allow this now: {reason}"},
    ErrorRow{ErrorCode::TooLargeForSlot, "TooLargeForSlot", "the table does not fit: {reason}"},
    ErrorRow{ErrorCode::TableRefused, "TableRefused", "the drive refused the table: {reason}"},
    ErrorRow{ErrorCode::FlashWear, "FlashWear",
        "too many flash operations in a short time; wait {seconds} s, or write volatile"},
    ErrorRow{ErrorCode::CompensationError, "CompensationError",
        "the compensation of axis {axis} is in error {error}: {hint}"},
    ErrorRow{
        ErrorCode::AxisNotFound, "AxisNotFound", "the drive has no axis {axis}; it has: {known}"},
    ErrorRow{ErrorCode::AxisAmbiguous, "AxisAmbiguous",
        "several axes are named {axis}: give the index, one of {matches}"},
    ErrorRow{ErrorCode::NoCompensation, "NoCompensation",
        "axis {axis} of this drive has no compensation registers"},
    ErrorRow{ErrorCode::SourceMissing, "SourceMissing",
        "the source of dimension {dimension} is missing"},
    ErrorRow{ErrorCode::SourceSurplus, "SourceSurplus",
        "there is a source for dimension {dimension}, but only {dimensions} dimension(s)"},
    ErrorRow{
        ErrorCode::SourceNotFound, "SourceNotFound", "the drive has no register {source}{nearest}"},
    ErrorRow{ErrorCode::SourceWrongType, "SourceWrongType",
        "{source} is of type {type}; a dimension source must be one of {allowed}"},
    ErrorRow{ErrorCode::SourceOtherDrive, "SourceOtherDrive",
        "{source} is a register of the drive {other}; a source must be on the drive itself, "
        "{drive}"},
    ErrorRow{ErrorCode::SourceRepeated, "SourceRepeated",
        "{source} is the source of both dimension {first} and dimension {second}"},
    ErrorRow{ErrorCode::DimensionMismatch, "DimensionMismatch",
        "the table has {table} dimension(s), but {chosen} are chosen"},
    ErrorRow{ErrorCode::TableTooLarge, "TableTooLarge",
        "the table needs {size} bytes, but the largest slot that may be taken, {slot}, holds "
        "{largest}"},
    ErrorRow{
        ErrorCode::SlotNotFound, "SlotNotFound", "the drive has no slot {slot}; it has: {known}"},
    ErrorRow{ErrorCode::SlotInUse, "SlotInUse", "slot {slot} is in use by {user}"},
    ErrorRow{ErrorCode::NoFreeSlot, "NoFreeSlot",
        "no slot is free for a table of {size} bytes: {slots}; name one to overwrite it"},
    ErrorRow{
        ErrorCode::NoTable, "NoTable", "axis {axis} has no table on the drive; write one first"},
    ErrorRow{ErrorCode::NothingToWrite, "NothingToWrite",
        "axis {axis} already has all of this; there is nothing to write"},
    ErrorRow{ErrorCode::NothingUnfinished, "NothingUnfinished",
        "no write to axis {axis} is unfinished; there is nothing to finish or to undo"},
    ErrorRow{ErrorCode::TableNotKept, "TableNotKept",
        "the new table of the unfinished write to axis {axis} was not kept on this computer: write "
        "it again, or undo the write"},
    ErrorRow{ErrorCode::CompensationActive, "CompensationActive",
        "the compensation of axis {axis} is active; deactivate it first"},
    ErrorRow{ErrorCode::NotHomed, "NotHomed", "axis {axis} must be homed first"},
    ErrorRow{ErrorCode::OtherDrive, "OtherDrive",
        "this is another drive: expected serial number {expected}, found {found}"},
    ErrorRow{ErrorCode::ChangedMeanwhile, "ChangedMeanwhile",
        "somebody else changed {what} from {before} to {now}; nothing was written, look again"},
    ErrorRow{ErrorCode::VerifyMismatch, "VerifyMismatch",
        "{what} read back as {found}, but {expected} was written"},
    ErrorRow{ErrorCode::ProofFailed, "ProofFailed",
        "the drive does not add what it should: {what} at {position} is {found}, expected "
        "{expected}"},
    ErrorRow{ErrorCode::OutcomeUnknown, "OutcomeUnknown",
        "{reason}. The drive holds the complete old or the complete new state; ask for the status "
        "when it answers again. The old state is kept in {backup}"},
    ErrorRow{ErrorCode::RollbackFailed, "RollbackFailed",
        "{reason}; putting the old state back failed too ({rollback}). Do not activate the axis; "
        "restore it from {backup}"},
};

constexpr auto codes = [] {
    std::array<ErrorCode, errorRows.size()> result{};
    for (std::size_t i = 0; i < errorRows.size(); ++i)
        result[i] = errorRows[i].code;
    return result;
}();

const ErrorRow& rowOf(ErrorCode code)
{
    const auto row = std::ranges::find(errorRows, code, &ErrorRow::code);
    assert(row != errorRows.end());
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
    if (error.code == ErrorCode::FlashWear && error.context.contains("record"))
        return "the record of this drive's flash operations was damaged, so all of them count as "
               "used up; write volatile, or reset the count with 'axiscomp status "
               "--reset-flash-count'";
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
