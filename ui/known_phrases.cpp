// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/phrase_book.h"

#include <QCoreApplication>

namespace axiscomp::ui {

namespace {

constexpr const char* phrases[] = {
    // core/error.cpp
    QT_TRANSLATE_NOOP("Error", "{reason}"),
    QT_TRANSLATE_NOOP("Error", "stopped by the user"),
    QT_TRANSLATE_NOOP("Error", "{file} cannot be read: {reason}"),
    QT_TRANSLATE_NOOP("Error", "{file} cannot be written: {reason}"),
    QT_TRANSLATE_NOOP(
        "Error", "{file} has {size} bytes, more than the {limit} that such a file can have"),
    QT_TRANSLATE_NOOP("Error", "{file} is not a valid calibration file: {count} problem(s)"),
    QT_TRANSLATE_NOOP("Error",
        "this is not a valid TAM table: {field} at offset {offset} is {found}, "
        "expected {expected}"),
    QT_TRANSLATE_NOOP("Error", "the drive profile {file} is wrong at {path}: {reason}"),
    QT_TRANSLATE_NOOP("Error", "the TAM configuration {file} is wrong in line {line}: {reason}"),
    QT_TRANSLATE_NOOP("Error", "{file} is not a valid backup: {reason}"),
    QT_TRANSLATE_NOOP("Error", "the format of {file} is not known; name one of: {known}"),
    QT_TRANSLATE_NOOP("Error", "there is no table {table} in the file; it has: {known}"),
    QT_TRANSLATE_NOOP("Error", "{endpoint} is not the address of a drive: {reason}"),
    QT_TRANSLATE_NOOP("Error", "no connection to {endpoint}: {reason}"),
    QT_TRANSLATE_NOOP("Error", "the connection to {endpoint} was lost: {reason}"),
    QT_TRANSLATE_NOOP("Error", "{endpoint} did not answer within {seconds} s"),
    QT_TRANSLATE_NOOP("Error",
        "{endpoint} did not answer as a drive does: expected {expected}, got "
        "{quote}"),
    QT_TRANSLATE_NOOP("Error",
        "{endpoint} asks for a user name and a password; give them as "
        "http://user:password@host"),
    QT_TRANSLATE_NOOP("Error", "the certificate of {endpoint} cannot be trusted: {reason}"),
    QT_TRANSLATE_NOOP("Error", "the drive refused: {reason}"),
    QT_TRANSLATE_NOOP("Error", "the drive has no register {path}"),
    QT_TRANSLATE_NOOP("Error", "the drive has no file {path}"),
    QT_TRANSLATE_NOOP("Error", "the drive does not allow this now: {reason}"),
    QT_TRANSLATE_NOOP("Error", "the table does not fit: {reason}"),
    QT_TRANSLATE_NOOP("Error", "the drive refused the table: {reason}"),
    QT_TRANSLATE_NOOP("Error",
        "too many flash operations in a short time; wait {seconds} s, or write "
        "volatile"),
    QT_TRANSLATE_NOOP("Error", "the compensation of axis {axis} is in error {error}: {hint}"),
    QT_TRANSLATE_NOOP("Error", "the drive has no axis {axis}; it has: {known}"),
    QT_TRANSLATE_NOOP("Error", "several axes are named {axis}: give the index, one of {matches}"),
    QT_TRANSLATE_NOOP("Error", "axis {axis} of this drive has no compensation registers"),
    QT_TRANSLATE_NOOP("Error", "the source of dimension {dimension} is missing"),
    QT_TRANSLATE_NOOP("Error",
        "there is a source for dimension {dimension}, but only {dimensions} "
        "dimension(s)"),
    QT_TRANSLATE_NOOP("Error", "the drive has no register {source}{nearest}"),
    QT_TRANSLATE_NOOP(
        "Error", "{source} is of type {type}; a dimension source must be one of {allowed}"),
    QT_TRANSLATE_NOOP("Error",
        "{source} is a register of the drive {other}; a source must be on the "
        "drive itself, {drive}"),
    QT_TRANSLATE_NOOP(
        "Error", "{source} is the source of both dimension {first} and dimension {second}"),
    QT_TRANSLATE_NOOP("Error", "the table has {table} dimension(s), but {chosen} are chosen"),
    QT_TRANSLATE_NOOP("Error",
        "the table needs {size} bytes, but the largest slot that may be taken, "
        "{slot}, holds {largest}"),
    QT_TRANSLATE_NOOP("Error", "the drive has no slot {slot}; it has: {known}"),
    QT_TRANSLATE_NOOP("Error", "slot {slot} is in use by {user}"),
    QT_TRANSLATE_NOOP("Error",
        "no slot is free for a table of {size} bytes: {slots}; name one to "
        "overwrite it"),
    QT_TRANSLATE_NOOP("Error", "axis {axis} has no table on the drive; write one first"),
    QT_TRANSLATE_NOOP("Error", "axis {axis} already has all of this; there is nothing to write"),
    QT_TRANSLATE_NOOP("Error", "the compensation of axis {axis} is active; deactivate it first"),
    QT_TRANSLATE_NOOP("Error", "axis {axis} must be homed first"),
    QT_TRANSLATE_NOOP(
        "Error", "this is another drive: expected serial number {expected}, found {found}"),
    QT_TRANSLATE_NOOP("Error",
        "somebody else changed {what} from {before} to {now}; nothing was "
        "written, look again"),
    QT_TRANSLATE_NOOP("Error", "{what} read back as {found}, but {expected} was written"),
    QT_TRANSLATE_NOOP("Error",
        "the drive does not add what it should: {what} at {position} is {found}, "
        "expected {expected}"),
    QT_TRANSLATE_NOOP("Error",
        "{reason}. The drive holds the complete old or the complete new state; "
        "ask for the status when it answers again. The old state is kept in "
        "{backup}"),
    QT_TRANSLATE_NOOP("Error",
        "{reason}; putting the old state back failed too ({rollback}). Do not "
        "activate the axis; restore it from {backup}"),
    // Parts of them, and the warnings of a plan
    QT_TRANSLATE_NOOP("Error", "the axis must be homed first"),
    QT_TRANSLATE_NOOP("Error", "the axis has no table; write one first"),
    QT_TRANSLATE_NOOP("Error", "the number of sources must equal the table's dimensions"),
    QT_TRANSLATE_NOOP("Error", "a source is not a Single or Double register of this drive"),
    QT_TRANSLATE_NOOP("Error", "the drive cannot use the table; write it again"),
    QT_TRANSLATE_NOOP("Error", "see the drive's manual"),
    QT_TRANSLATE_NOOP("Error", "it did not become {state} in time"),
    QT_TRANSLATE_NOOP("Error", "only an active or an evaluating compensation can be proved"),
    QT_TRANSLATE_NOOP("Error",
        "No other slot is free: the table in {slot} is overwritten. A copy is "
        "kept in the backup."),
    QT_TRANSLATE_NOOP(
        "Error", "What {slot} holds now is overwritten. A copy is kept in the backup."),
    QT_TRANSLATE_NOOP("Error",
        "The new table is volatile: after a reboot the axis has the old, "
        "persistent one again."),
    QT_TRANSLATE_NOOP("Error",
        "The parameters of all axes are saved, but the table of {axis} in {slot} "
        "is volatile: after a reboot that axis has no table."),
    QT_TRANSLATE_NOOP("Error", "the settings of {axis}"),
    QT_TRANSLATE_NOOP("Error", "axis {axis}"),
    QT_TRANSLATE_NOOP("Error", "axis {axis} ({name})"),
    QT_TRANSLATE_NOOP("Error", "the cogging compensation of axis {axis}"),
    QT_TRANSLATE_NOOP("Error", "the output"),
    QT_TRANSLATE_NOOP("Error", "the index of dimension {dimension}"),
    QT_TRANSLATE_NOOP("Error", "it was closed before the reply was complete"),
    QT_TRANSLATE_NOOP("Error",
        "nothing listens there; is the drive switched on, and is the address "
        "right?"),
    QT_TRANSLATE_NOOP("Error", "the network does not know the name {name}"),
    QT_TRANSLATE_NOOP("Error", "there is no https; try http://, or another port"),
    QT_TRANSLATE_NOOP("Error",
        "write http://host[:port], https://host[:port], serial:/dev/ttyUSB0 or "
        "demo:"),
    QT_TRANSLATE_NOOP("Error", "it does not exist"),
    QT_TRANSLATE_NOOP("Error", "no permission"),
    QT_TRANSLATE_NOOP("Error", "the disk is full"),
    QT_TRANSLATE_NOOP("Error", "the disk quota is used up"),
    QT_TRANSLATE_NOOP("Error", "the file system is read-only"),
    QT_TRANSLATE_NOOP("Error", "it is a folder"),
    QT_TRANSLATE_NOOP("Error", "a part of the path is not a folder"),
    QT_TRANSLATE_NOOP("Error", "the name is too long"),
    QT_TRANSLATE_NOOP("Error", "the disk reports an error"),
    QT_TRANSLATE_NOOP("Error", "another program is using it; try again when that one has finished"),
    QT_TRANSLATE_NOOP("Error", "it does not read back as it was written"),
    QT_TRANSLATE_NOOP("Error", "; a URI is written tam://mc/<drive>/<path>"),
    QT_TRANSLATE_NOOP("Error", "; an address is written 0x and 1 to 8 hex digits"),
    QT_TRANSLATE_NOOP("Error", ": no register has this address"),
    QT_TRANSLATE_NOOP("Error", "; the nearest are {names}"),
    QT_TRANSLATE_NOOP("Error", "there is no backup that differs from what the axis has now"),
    QT_TRANSLATE_NOOP("Error", "the program is ending"),
};

} // namespace

std::span<const char* const> knownPhrases()
{
    return phrases;
}

} // namespace axiscomp::ui
