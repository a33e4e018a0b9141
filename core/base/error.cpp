// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/error.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <string_view>

namespace axiscomp {

namespace {

struct ErrorRow {
    ErrorCode code;
    std::string_view name;
    ErrorClass errorClass;
    TextPattern pattern;
};

constexpr std::array errorRows{
    ErrorRow{ErrorCode::InvalidArgument, "InvalidArgument", ErrorClass::Request,
        AXISCOMP_TEXT("Error", "{reason}")},
    ErrorRow{ErrorCode::Cancelled, "Cancelled", ErrorClass::Stopped,
        AXISCOMP_TEXT("Error", "stopped by the user")},
    ErrorRow{ErrorCode::FileNotReadable, "FileNotReadable", ErrorClass::InputFile,
        AXISCOMP_TEXT("Error", "{file} cannot be read: {reason}")},
    ErrorRow{ErrorCode::FileNotWritable, "FileNotWritable", ErrorClass::Local,
        AXISCOMP_TEXT("Error", "{file} cannot be written: {reason}")},
    ErrorRow{ErrorCode::FileTooLarge, "FileTooLarge", ErrorClass::InputFile,
        AXISCOMP_TEXT(
            "Error", "{file} has {size} bytes, more than the {limit} that such a file can have")},
    ErrorRow{ErrorCode::InvalidCalibration, "InvalidCalibration", ErrorClass::InputFile,
        AXISCOMP_COUNTED("Error", "{file} is not a valid calibration file: {count} problems",
            "{file} is not a valid calibration file: one problem")},
    ErrorRow{ErrorCode::InvalidMeasurement, "InvalidMeasurement", ErrorClass::InputFile,
        AXISCOMP_COUNTED("Error", "{file} is not a valid measurement: {count} problems",
            "{file} is not a valid measurement: one problem")},
    ErrorRow{ErrorCode::UnitMissing, "UnitMissing", ErrorClass::Request,
        AXISCOMP_TEXT(
            "Error", "{file} does not say its units; state them with --unit and --value-unit")},
    ErrorRow{ErrorCode::InstrumentScale, "InstrumentScale", ErrorClass::InputFile,
        AXISCOMP_TEXT("Error", "the positions in {file} do not follow one another one to one")},
    ErrorRow{ErrorCode::NoTargets, "NoTargets", ErrorClass::InputFile,
        AXISCOMP_TEXT("Error",
            "{file} has no targets; the figures of the standard need a measurement of runs over "
            "targets")},
    ErrorRow{ErrorCode::InvalidTable, "InvalidTable", ErrorClass::InputFile,
        AXISCOMP_TEXT("Error",
            "this is not a valid TAM table: {field} at offset {offset} is {found}, expected "
            "{expected}")},
    ErrorRow{ErrorCode::InvalidProfile, "InvalidProfile", ErrorClass::InputFile,
        AXISCOMP_TEXT("Error", "the drive profile {file} is wrong at {path}: {reason}")},
    ErrorRow{ErrorCode::InvalidConfiguration, "InvalidConfiguration", ErrorClass::InputFile,
        AXISCOMP_TEXT("Error", "the TAM configuration {file} is wrong in line {line}: {reason}")},
    ErrorRow{ErrorCode::InvalidBackup, "InvalidBackup", ErrorClass::InputFile,
        AXISCOMP_TEXT("Error", "{file} is not a valid backup: {reason}")},
    ErrorRow{ErrorCode::InvalidRecord, "InvalidRecord", ErrorClass::InputFile,
        AXISCOMP_TEXT("Error", "{file} is not a valid record: {reason}")},
    ErrorRow{ErrorCode::UnknownFormat, "UnknownFormat", ErrorClass::Request,
        AXISCOMP_TEXT("Error", "the format of {file} is not known; name one of: {known}")},
    ErrorRow{ErrorCode::TableNotFound, "TableNotFound", ErrorClass::Request,
        AXISCOMP_TEXT("Error", "there is no table {table} in the file; it has: {known}")},
    ErrorRow{ErrorCode::FormatAmbiguous, "FormatAmbiguous", ErrorClass::Request,
        AXISCOMP_TEXT(
            "Error", "{file} can be one of several formats: {candidates}; say which one it is")},
    ErrorRow{ErrorCode::FormatCannotHold, "FormatCannotHold", ErrorClass::Request,
        AXISCOMP_TEXT("Error", "the format {format} cannot hold this table: {reason}; {wayOut}")},
    ErrorRow{ErrorCode::SignNotConvertible, "SignNotConvertible", ErrorClass::InputFile,
        AXISCOMP_TEXT("Error", "the sign cannot be converted at {position}: {reason}")},
    ErrorRow{ErrorCode::SignNotStated, "SignNotStated", ErrorClass::Request,
        AXISCOMP_TEXT("Error",
            "nobody has published which sign files of the format {format} have; {sign} is an "
            "assumption. Check one point on the machine, and state feedback or command "
            "{statement}")},
    ErrorRow{ErrorCode::TargetNotKnown, "TargetNotKnown", ErrorClass::Request,
        AXISCOMP_TEXT("Error",
            "it is not stated which axis the values of {column} correct, and the numbers depend on "
            "it; state the target: {sources}")},
    ErrorRow{ErrorCode::TargetMismatch, "TargetMismatch", ErrorClass::Request,
        AXISCOMP_TEXT("Error",
            "the values of {table} correct {target}, but for axis {axis} {role}; choose another "
            "column, axis or source, or, if it is right all the same, state the target as "
            "{statement} when the file is read")},
    ErrorRow{ErrorCode::UnitMismatch, "UnitMismatch", ErrorClass::Request,
        AXISCOMP_TEXT("Error",
            "the {what} are in {unit}, which cannot be converted to {other}, the unit of the "
            "drive; "
            "correct the unit in the file, or state it")},
    ErrorRow{ErrorCode::LargeCorrection, "LargeCorrection", ErrorClass::Request,
        AXISCOMP_TEXT("Error",
            "{reason} Check the unit of the values; if they are right, confirm them in the "
            "preview, or with --accept-large")},
    ErrorRow{ErrorCode::TableAmbiguous, "TableAmbiguous", ErrorClass::Request,
        AXISCOMP_TEXT("Error",
            "{table} is the name of table {named} and the number of table {numbered}; say "
            "name:{table} or #{table}")},
    ErrorRow{ErrorCode::ResamplingImpossible, "ResamplingImpossible", ErrorClass::Request,
        AXISCOMP_TEXT("Error", "the table cannot be resampled: {reason}")},
    ErrorRow{ErrorCode::MeasurementState, "MeasurementState", ErrorClass::Request,
        AXISCOMP_TEXT("Error", "{reason}")},
    ErrorRow{ErrorCode::PeriodNotResolved, "PeriodNotResolved", ErrorClass::Request,
        AXISCOMP_TEXT("Error",
            "these positions cannot tell an error with the period {period}: they lie in {filled} "
            "of {classes} equal parts of the period, and {fewest} are needed; measure at targets "
            "that are spread over the period (axiscomp targets --period), or leave the period "
            "out")},
    ErrorRow{ErrorCode::NoDataThere, "NoDataThere", ErrorClass::Request,
        AXISCOMP_COUNTED("Error",
            "{count} points of the grid, at {region}, are more than {distances} distances away "
            "from any measured point; measure there, take a smaller grid, or let them be filled "
            "(--fill smooth or --fill nearest)",
            "one point of the grid, at {region}, is more than {distances} distances away from any "
            "measured point; measure there, take a smaller grid, or let it be filled "
            "(--fill smooth or --fill nearest)")},
    ErrorRow{ErrorCode::NotConverged, "NotConverged", ErrorClass::Local,
        AXISCOMP_TEXT("Error", "the computation did not come to an end: {reason}")},
    ErrorRow{ErrorCode::InvalidEndpoint, "InvalidEndpoint", ErrorClass::Address,
        AXISCOMP_TEXT("Error", "{endpoint} is not the address of a drive: {reason}")},
    ErrorRow{ErrorCode::NotConnected, "NotConnected", ErrorClass::NotConnected,
        AXISCOMP_TEXT("Error", "no connection to {endpoint}: {reason}")},
    ErrorRow{ErrorCode::ConnectionLost, "ConnectionLost", ErrorClass::Lost,
        AXISCOMP_TEXT("Error", "the connection to {endpoint} was lost: {reason}")},
    ErrorRow{ErrorCode::Timeout, "Timeout", ErrorClass::Lost,
        AXISCOMP_TEXT("Error", "{endpoint} did not answer within {seconds} s")},
    ErrorRow{ErrorCode::Protocol, "Protocol", ErrorClass::Lost,
        AXISCOMP_TEXT("Error",
            "{endpoint} did not answer as a drive does: expected {expected}, got {quote}")},
    ErrorRow{ErrorCode::Unauthorized, "Unauthorized", ErrorClass::Unauthorized,
        AXISCOMP_TEXT("Error",
            "{endpoint} asks for a user name and a password; give them as "
            "http://user:password@host")},
    ErrorRow{ErrorCode::CertificateRejected, "CertificateRejected", ErrorClass::Untrusted,
        AXISCOMP_TEXT("Error",
            "the certificate of {endpoint} cannot be trusted: {reason}. Its SHA-256 fingerprint is "
            "{fingerprint}; trust it under Connections, or with --trust-certificate, if the drive "
            "has the same")},
    ErrorRow{ErrorCode::DriveRejected, "DriveRejected", ErrorClass::Refused,
        AXISCOMP_TEXT("Error", "the drive refused: {reason}")},
    ErrorRow{ErrorCode::UnknownRegister, "UnknownRegister", ErrorClass::Refused,
        AXISCOMP_TEXT("Error", "the drive has no register {path}")},
    ErrorRow{ErrorCode::UnknownFile, "UnknownFile", ErrorClass::Refused,
        AXISCOMP_TEXT("Error", "the drive has no file {path}")},
    ErrorRow{ErrorCode::NotAllowedNow, "NotAllowedNow", ErrorClass::Refused,
        AXISCOMP_TEXT("Error", "the drive does not allow this now: {reason}")},
    ErrorRow{ErrorCode::TooLargeForSlot, "TooLargeForSlot", ErrorClass::Refused,
        AXISCOMP_TEXT("Error", "the table does not fit: {reason}")},
    ErrorRow{ErrorCode::TableRefused, "TableRefused", ErrorClass::Refused,
        AXISCOMP_TEXT("Error", "the drive refused the table: {reason}")},
    ErrorRow{ErrorCode::FlashWear, "FlashWear", ErrorClass::FlashWear,
        AXISCOMP_TEXT("Error",
            "too many flash operations in a short time; wait {seconds} s, or write volatile")},
    ErrorRow{ErrorCode::CompensationError, "CompensationError", ErrorClass::Refused,
        AXISCOMP_TEXT("Error", "the compensation of axis {axis} is in error {error}: {hint}")},
    ErrorRow{ErrorCode::AxisNotFound, "AxisNotFound", ErrorClass::Request,
        AXISCOMP_TEXT("Error", "the drive has no axis {axis}; it has: {known}")},
    ErrorRow{ErrorCode::AxisAmbiguous, "AxisAmbiguous", ErrorClass::Request,
        AXISCOMP_TEXT("Error", "several axes are named {axis}: give the index, one of {matches}")},
    ErrorRow{ErrorCode::NoCompensation, "NoCompensation", ErrorClass::Refused,
        AXISCOMP_TEXT("Error", "axis {axis} of this drive has no compensation registers")},
    ErrorRow{ErrorCode::SourceMissing, "SourceMissing", ErrorClass::Request,
        AXISCOMP_TEXT("Error", "the source of dimension {dimension} is missing")},
    ErrorRow{ErrorCode::SourceSurplus, "SourceSurplus", ErrorClass::Request,
        AXISCOMP_TEXT("Error",
            "there is a source for dimension {dimension}, but the table is {dimensions}D")},
    ErrorRow{ErrorCode::SourceNotFound, "SourceNotFound", ErrorClass::Request,
        AXISCOMP_TEXT("Error", "the drive has no register {source}{nearest}")},
    ErrorRow{ErrorCode::SourceWrongType, "SourceWrongType", ErrorClass::Request,
        AXISCOMP_TEXT(
            "Error", "{source} is of type {type}; a dimension source must be one of {allowed}")},
    ErrorRow{ErrorCode::SourceOtherDrive, "SourceOtherDrive", ErrorClass::Request,
        AXISCOMP_TEXT("Error",
            "{source} is a register of the drive {other}; a source must be on the drive itself, "
            "{drive}")},
    ErrorRow{ErrorCode::SourceRepeated, "SourceRepeated", ErrorClass::Request,
        AXISCOMP_TEXT(
            "Error", "{source} is the source of both dimension {first} and dimension {second}")},
    ErrorRow{ErrorCode::SourceMismatch, "SourceMismatch", ErrorClass::Request,
        AXISCOMP_TEXT(
            "Error", "{doubt} Choose another source or column, or correct the unit in the file")},
    ErrorRow{ErrorCode::DimensionMismatch, "DimensionMismatch", ErrorClass::Request,
        AXISCOMP_TEXT("Error", "the table is {table}D, but {chosen}D is chosen")},
    ErrorRow{ErrorCode::TableTooLarge, "TableTooLarge", ErrorClass::Refused,
        AXISCOMP_TEXT("Error",
            "the table needs {size} bytes, but the largest slot that may be taken, {slot}, holds "
            "{largest}")},
    ErrorRow{ErrorCode::SlotNotFound, "SlotNotFound", ErrorClass::Request,
        AXISCOMP_TEXT("Error", "the drive has no slot {slot}; it has: {known}")},
    ErrorRow{ErrorCode::SlotInUse, "SlotInUse", ErrorClass::Refused,
        AXISCOMP_TEXT("Error", "slot {slot} is in use by {user}")},
    ErrorRow{ErrorCode::NoFreeSlot, "NoFreeSlot", ErrorClass::Refused,
        AXISCOMP_TEXT("Error",
            "no slot is free for a table of {size} bytes: {slots}; name one to overwrite it")},
    ErrorRow{ErrorCode::NoTable, "NoTable", ErrorClass::Refused,
        AXISCOMP_TEXT("Error", "axis {axis} has no table on the drive; write one first")},
    ErrorRow{ErrorCode::NothingToWrite, "NothingToWrite", ErrorClass::NothingToDo,
        AXISCOMP_TEXT("Error", "axis {axis} already has all of this; there is nothing to write")},
    ErrorRow{ErrorCode::NothingUnfinished, "NothingUnfinished", ErrorClass::NothingToDo,
        AXISCOMP_TEXT("Error",
            "no write to axis {axis} is unfinished; there is nothing to finish or to undo")},
    ErrorRow{ErrorCode::TableNotKept, "TableNotKept", ErrorClass::Local,
        AXISCOMP_TEXT("Error",
            "the new table of the unfinished write to axis {axis} was not kept on this computer: "
            "write it again, or undo the write")},
    ErrorRow{ErrorCode::NotUndoable, "NotUndoable", ErrorClass::Refused,
        AXISCOMP_TEXT("Error",
            "the deletion of {slot} for axis {axis} can only be finished: the saved parameters "
            "that would bring its table back after a reboot are not known; the backup has the "
            "table")},
    ErrorRow{ErrorCode::CompensationActive, "CompensationActive", ErrorClass::Refused,
        AXISCOMP_TEXT("Error", "the compensation of axis {axis} is active; deactivate it first")},
    ErrorRow{ErrorCode::NotHomed, "NotHomed", ErrorClass::Refused,
        AXISCOMP_TEXT("Error", "axis {axis} must be homed first")},
    ErrorRow{ErrorCode::OtherDrive, "OtherDrive", ErrorClass::Refused,
        AXISCOMP_TEXT(
            "Error", "this is another drive: expected serial number {expected}, found {found}")},
    ErrorRow{ErrorCode::ChangedMeanwhile, "ChangedMeanwhile", ErrorClass::Difference,
        AXISCOMP_TEXT("Error",
            "somebody else changed {what} from {before} to {now}; nothing was written, look "
            "again")},
    ErrorRow{ErrorCode::VerifyMismatch, "VerifyMismatch", ErrorClass::Difference,
        AXISCOMP_TEXT("Error", "{what} read back as {found}, but {expected} was written")},
    ErrorRow{ErrorCode::ProofFailed, "ProofFailed", ErrorClass::Difference,
        AXISCOMP_TEXT("Error",
            "the drive does not add what it should: {what} at {position} is {found}, expected "
            "{expected}")},
    ErrorRow{ErrorCode::OutcomeUnknown, "OutcomeUnknown", ErrorClass::OutcomeUnknown,
        AXISCOMP_TEXT("Error",
            "{reason}. The drive holds the complete old or the complete new state; ask for the "
            "status when it answers again. The old state is kept in {backup}")},
    ErrorRow{ErrorCode::RollbackFailed, "RollbackFailed", ErrorClass::Difference,
        AXISCOMP_TEXT("Error",
            "{reason}; putting the old state back failed too ({rollback}). Do not activate the "
            "axis; restore it from {backup}")},
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

ErrorClass errorClass(ErrorCode code)
{
    return rowOf(code).errorClass;
}

bool isLinkFailure(ErrorCode code)
{
    const ErrorClass kind = errorClass(code);
    return kind == ErrorClass::Address || kind == ErrorClass::Unauthorized
        || kind == ErrorClass::Untrusted || kind == ErrorClass::NotConnected
        || kind == ErrorClass::Lost;
}

bool isUnreachable(ErrorCode code)
{
    const ErrorClass kind = errorClass(code);
    return kind == ErrorClass::NotConnected || kind == ErrorClass::Lost;
}

bool mayHaveArrived(ErrorCode code)
{
    return errorClass(code) == ErrorClass::Lost;
}

TextPattern errorPattern(ErrorCode code)
{
    return rowOf(code).pattern;
}

namespace {

/// Flash is to be left: writing volatile is what costs the operation.
Text removingText(const Error& error)
{
    if (error.context.contains("record"))
        return {
            AXISCOMP_TEXT("Error",
                "removing a table from flash is a flash operation too, and the record of this "
                "drive's flash operations was damaged, so all of them count as used up; keep the "
                "table persistent, or reset the count with 'axiscomp status --reset-flash-count'"),
            error.context};
    if (error.context.contains("reserve"))
        return {
            AXISCOMP_TEXT("Error",
                "the flash operations that are left would do for removing the table from flash, "
                "but "
                "not for putting everything back if it fails; wait {seconds} s, or keep the table "
                "persistent"),
            error.context};
    return {AXISCOMP_TEXT("Error",
                "removing a table from flash is a flash operation too, and there were too many of "
                "them in a short time; wait {seconds} s, or keep the table persistent"),
        error.context};
}

/// A change that has no volatile form: a deletion, or a table that is to be stored in flash.
Text waitingText(const Error& error)
{
    if (error.context.contains("record"))
        return {
            AXISCOMP_TEXT("Error",
                "the record of this drive's flash operations was damaged, so all of them count as "
                "used up; reset the count with 'axiscomp status --reset-flash-count'"),
            error.context};
    if (error.context.contains("reserve"))
        return {
            AXISCOMP_TEXT("Error",
                "the flash operations that are left would do for the change, but not for putting "
                "everything back if it fails; wait {seconds} s"),
            error.context};
    return {AXISCOMP_TEXT("Error", "too many flash operations in a short time; wait {seconds} s"),
        error.context};
}

/// Several changes, each of which would be possible alone.
Text togetherText(const Error& error)
{
    if (error.context.contains("reserve"))
        return {
            AXISCOMP_TEXT("Error",
                "the flash operations that are left would do for all of these changes, {together}, "
                "but not for putting everything back if one fails; wait {seconds} s, or make fewer "
                "changes at a time"),
            error.context};
    return {AXISCOMP_TEXT("Error",
                "together these changes cost {together} flash operations, more than are possible "
                "now; wait {seconds} s, or make fewer changes at a time"),
        error.context};
}

constexpr TextPattern otherLayout = AXISCOMP_TEXT("Error",
    "the drive does not read the table in {slot} as the layout of the profile has it: of dimension "
    "{dimension} the drive shows {found} where the layout has {expected}. Compare {layout} in the "
    "profile with the drive's table file");

/// The sentence of an error with an argument that not each of its kind has. The first that fits
/// counts.
struct Variant {
    ErrorCode code;
    std::string_view argument;
    TextPattern sentence;
};
constexpr std::array variants{
    Variant{ErrorCode::FlashWear, "reserve",
        AXISCOMP_TEXT("Error",
            "the flash operations that are left would do for the change, but not for putting "
            "everything back if it fails; wait {seconds} s, or write volatile")},
    Variant{ErrorCode::FlashWear, "record",
        AXISCOMP_TEXT("Error",
            "the record of this drive's flash operations was damaged, so all of them count as "
            "used up; write volatile, or reset the count with 'axiscomp status "
            "--reset-flash-count'")},
    Variant{ErrorCode::Unauthorized, "given",
        AXISCOMP_TEXT("Error",
            "{endpoint} refuses the user name or the password that was given; in an address %40 "
            "stands for @, %3A for :, %2F for /, %23 for # and %25 for %")},
    Variant{ErrorCode::AxisAmbiguous, "named",
        AXISCOMP_TEXT("Error",
            "{axis} is the name of axis {named} and the index of axis {numbered}; say "
            "name:{axis} or {index}")},
    Variant{ErrorCode::SourceMissing, "ofAxis",
        AXISCOMP_TEXT("Error", "the source of dimension {dimension} of axis {ofAxis} is missing")},
    Variant{ErrorCode::SourceMismatch, "axis",
        AXISCOMP_TEXT("Error",
            "{doubt} Choose another source or column, or, if it is right all the same, name the "
            "column after axis {axis} in the file")},
    Variant{ErrorCode::TargetNotKnown, "stated",
        AXISCOMP_TEXT("Error",
            "{stated}, stated as the axis that the values of {column} correct, may be one of the "
            "sources or not, since their names do not tell it, and the numbers depend on it; state "
            "the target: {sources}")},
    Variant{ErrorCode::TargetMismatch, "restored",
        AXISCOMP_TEXT("Error",
            "axis {axis} was {target} when the backup was made, and is {name} on the drive "
            "now; give the axes the order or the names that they had, or write the table "
            "from its file")},
    Variant{ErrorCode::TargetMismatch, "recovered",
        AXISCOMP_TEXT("Error",
            "axis {axis} was {target} when the write began, and is {name} on the drive now; give "
            "the axes the order or the names that they had, or write the table from its file")},
    Variant{ErrorCode::TargetMismatch, "kept",
        AXISCOMP_TEXT("Error",
            "the name of the table, {table}, says that its values correct {target}, but for axis "
            "{axis} {role}; choose another table or axis, or, if it is right all the same, write "
            "the table to this axis from its file first, and state the target as {statement} "
            "there")},
    Variant{ErrorCode::TargetMismatch, "suggested",
        AXISCOMP_TEXT("Error",
            "the file does not say what the values of {table} correct. They were converted for "
            "{target}, but for axis {axis} {role}: read the file again with these sources, or "
            "state its target")},
    Variant{ErrorCode::UnitMissing, "positions",
        AXISCOMP_TEXT("Error",
            "the table states no unit for its values, and its positions are in {positions}; "
            "state the unit of the values, in the file or with --value-unit")},
    Variant{ErrorCode::UnitMismatch, "kept",
        AXISCOMP_TEXT("Error",
            "the {what} of the table on the drive are in {unit}, and the new source is in "
            "{other}; write the table from its file, together with the source")},
    Variant{ErrorCode::UnitMismatch, "keptKind",
        AXISCOMP_TEXT("Error",
            "dimension {number} of the table on the drive is one of {before}, and {source} is "
            "something else: one of them is a position, the other a temperature; write the table "
            "from its file, together with the source")},
    Variant{ErrorCode::UnitMismatch, "restored",
        AXISCOMP_TEXT("Error",
            "the {what} are in {unit} in the backup, and the drive has them in {other} "
            "now, so that the same numbers would mean something else; set the unit on the "
            "drive to {unit} again, or write the table from its file")},
    Variant{ErrorCode::UnitMismatch, "recovered",
        AXISCOMP_TEXT("Error",
            "the {what} were in {unit} when the write began, and the drive has them in {other} "
            "now, so that the same numbers would mean something else; set the unit on the drive to "
            "{unit} again, or write the table from its file")},
    Variant{ErrorCode::UnitMismatch, "recorded",
        AXISCOMP_TEXT("Error",
            "the {what} of the record's table were in {unit} when it was written, and the drive "
            "has them in {other} now, so that the same numbers mean something else; set the unit "
            "on the drive to {unit} again, or write the record's table again (`axiscomp write "
            "--record`)")},
    Variant{ErrorCode::OtherDrive, "measured",
        AXISCOMP_TEXT("Error",
            "the line // drive: of the file says that the drive with the serial number {expected} "
            "was measured, and this one has {found}: connect that drive, or, where it was replaced "
            "since, correct the line or remove it")},
    Variant{ErrorCode::VerifyMismatch, "unfinished",
        AXISCOMP_TEXT("Error",
            "a write that did not end has left axis {axis} in neither its old nor its new "
            "state: it is not activated. Finish that write with 'axiscomp recover "
            "--finish', undo it with 'axiscomp recover --undo', or write again. The old "
            "state is kept in {backup}")},
    Variant{ErrorCode::RollbackFailed, "unfinished",
        AXISCOMP_TEXT("Error",
            "{reason}; putting the old state back failed too ({rollback}). Do not activate the "
            "axis: 'axiscomp recover' says how the write can be finished or undone. The old state "
            "is kept in {backup}")},
    Variant{ErrorCode::InvalidTable, "layout", otherLayout},
    Variant{ErrorCode::VerifyMismatch, "layout", otherLayout},
    Variant{ErrorCode::InvalidTable, "kept",
        AXISCOMP_TEXT("Error",
            "the file in {slot} is no table that the profile can read: it is in the backup as it "
            "is, but cannot be restored as the table of an axis")},
    Variant{ErrorCode::VerifyMismatch, "cycles",
        AXISCOMP_TEXT("Error",
            "the drive has taken the command that stores the table in {slot}, but has counted no "
            "flash cycle for it ({cycles} before and after): it is not known to be in flash, and "
            "may be gone after a reboot")},
    Variant{ErrorCode::VerifyMismatch, "half",
        AXISCOMP_TEXT("Error",
            "a write that did not end has left axis {axis} in neither its old nor its new state: "
            "what can be read of it is half of that write. Finish it with 'axiscomp recover "
            "--finish', or undo it with 'axiscomp recover --undo'. The old state is kept in "
            "{backup}")},
    Variant{ErrorCode::VerifyMismatch, "unread",
        AXISCOMP_TEXT("Error",
            "what a write that did not end has left of axis {axis} is not known: the backup of its "
            "old state, {backup}, cannot be read. Write again or restore another backup, which "
            "puts an end to it")},
    Variant{ErrorCode::LargeCorrection, "machineAxis",
        AXISCOMP_TEXT("Error",
            "{reason} Check the unit of the values; if they are right, confirm them with "
            "accept-large = true for axis {machineAxis} in the machine file")},
    Variant{ErrorCode::InvalidConfiguration, "machine",
        AXISCOMP_COUNTED("Error", "{file} is not a valid machine file: {count} problems",
            "{file} is not a valid machine file: one problem")},
    Variant{ErrorCode::NoTable, "configured",
        AXISCOMP_TEXT("Error",
            "the configuration names the table in {slot} for axis {axis}, but the drive has none "
            "there: write the table to the axis from its file and name the slot that it gets in "
            "the configuration, or write it into {slot} with 'axiscomp write --slot {slot}'")},
    Variant{ErrorCode::NoTable, "slot",
        AXISCOMP_TEXT("Error", "{slot} is empty: there is nothing to delete")},
    Variant{ErrorCode::NoTable, "deleting",
        AXISCOMP_TEXT("Error", "axis {axis} uses no table: there is nothing to delete")},
    Variant{ErrorCode::SlotInUse, "imported",
        AXISCOMP_TEXT("Error",
            "slot {slot} is in use by {user}, and an import does not move a table from one axis to "
            "another: write the table to axis {imported} from its file, and name the slot that it "
            "gets there in the configuration")},
    Variant{ErrorCode::SlotInUse, "named",
        AXISCOMP_TEXT("Error",
            "slot {slot} is in use by {user}: name another slot, or none, and a free one is "
            "chosen")},
    Variant{ErrorCode::SlotInUse, "deleting",
        AXISCOMP_TEXT("Error",
            "the table in {slot} is not deleted, because {user} uses it; free it there "
            "first")},
    Variant{ErrorCode::SlotInUse, "removing",
        AXISCOMP_TEXT("Error",
            "the table in {slot} stays in flash, because {user} uses it too; free it there first, "
            "with a persistent write into another slot")},
    Variant{ErrorCode::InvalidCalibration, "positions",
        AXISCOMP_COUNTED("Error", "{file} is not a valid list of positions: {count} problems",
            "{file} is not a valid list of positions: one problem")},
    Variant{ErrorCode::TableAmbiguous, "alike",
        AXISCOMP_TEXT("Error",
            "several tables are called {table}; choose one by its number, such as #1: {alike}")},
    Variant{ErrorCode::UnknownFormat, "utf16",
        AXISCOMP_TEXT("Error", "{file} is UTF-16 text; save it as UTF-8 text")},
    Variant{ErrorCode::UnknownFormat, "measurement",
        AXISCOMP_TEXT("Error",
            "the format of {file} is not known; name one of: {known}; of any other CSV "
            "file, say which column is what")},
    Variant{ErrorCode::UnknownFormat, "measured",
        AXISCOMP_TEXT("Error",
            "{file} is a measurement, not a table; make a table of it with 'axiscomp fit' or on "
            "the pages Measure and Fit; if it is a table all the same, name its format")},
    Variant{ErrorCode::UnknownFormat, "written",
        AXISCOMP_TEXT("Error",
            "the name {file} says no format that can be written; name one with --to: "
            "{known}")},
    Variant{ErrorCode::UnknownFormat, "opened",
        AXISCOMP_TEXT("Error",
            "{file} is no record (.axcal), no machine file (.toml), no TAM configuration "
            "(.TAMcfg), and no table or measurement of a known format; a table whose "
            "format you can name is opened on the tab Write")},
};

} // namespace

Text textOf(const Error& error)
{
    // The password must not be sent in clear.
    if (error.code == ErrorCode::Unauthorized && !error.context.contains("given")
        && error.context.english("endpoint").starts_with("https:"))
        return {AXISCOMP_TEXT("Error",
                    "{endpoint} asks for a user name and a password; give them as "
                    "https://user:password@host"),
            error.context};
    if (error.code == ErrorCode::FlashWear && error.context.contains("together")
        && !error.context.contains("record"))
        return togetherText(error);
    if (error.code == ErrorCode::FlashWear && error.context.contains("removing"))
        return removingText(error);
    if (error.code == ErrorCode::FlashWear && error.context.contains("waiting"))
        return waitingText(error);
    const auto* const variant = std::ranges::find_if(variants, [&](const Variant& row) {
        return row.code == error.code && error.context.contains(row.argument);
    });
    return {
        variant == variants.end() ? errorPattern(error.code) : variant->sentence, error.context};
}

std::string sentence(const Error& error)
{
    return textOf(error).english();
}

std::span<const ErrorCode> allErrorCodes()
{
    return codes;
}

} // namespace axiscomp
