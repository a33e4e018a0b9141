// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/phrase_book.h"

#include <QtGlobal>

namespace axiscomp::ui {

namespace {

// Core/error.cpp: the sentence of each error.
constexpr const char* errorPhraseList[] = {
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
    QT_TRANSLATE_NOOP(
        "Error", "{file} can be one of several formats: {candidates}; say which one it is"),
    QT_TRANSLATE_NOOP("Error", "the format {format} cannot hold this table: {reason}; {wayOut}"),
    QT_TRANSLATE_NOOP("Error", "the sign cannot be converted at {position}: {reason}"),
    QT_TRANSLATE_NOOP("Error", "the table cannot be resampled: {reason}"),
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
    QT_TRANSLATE_NOOP("Error",
        "the certificate of {endpoint} cannot be trusted: {reason}. Its SHA-256 fingerprint is "
        "{fingerprint}; trust it under Connections, or with --trust-certificate, if the drive has "
        "the same"),
    QT_TRANSLATE_NOOP("Error", "the drive refused: {reason}"),
    QT_TRANSLATE_NOOP("Error", "the drive has no register {path}"),
    QT_TRANSLATE_NOOP("Error", "the drive has no file {path}"),
    QT_TRANSLATE_NOOP("Error", "the drive does not allow this now: {reason}"),
    QT_TRANSLATE_NOOP("Error", "the table does not fit: {reason}"),
    QT_TRANSLATE_NOOP("Error", "the drive refused the table: {reason}"),
    QT_TRANSLATE_NOOP("Error",
        "too many flash operations in a short time; wait {seconds} s, or write "
        "volatile"),
    QT_TRANSLATE_NOOP("Error",
        "the flash operations that are left would do for the change, but not for putting "
        "everything back if it fails; wait {seconds} s, or write volatile"),
    QT_TRANSLATE_NOOP("Error",
        "the record of this drive's flash operations was damaged, so all of them count as used "
        "up; write volatile, or reset the count with 'axiscomp status --reset-flash-count'"),
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
    QT_TRANSLATE_NOOP(
        "Error", "no write to axis {axis} is unfinished; there is nothing to finish or to undo"),
    QT_TRANSLATE_NOOP("Error",
        "the new table of the unfinished write to axis {axis} was not kept on this computer: write "
        "it again, or undo the write"),
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
};

} // namespace

std::span<const char* const> errorPhrases()
{
    return errorPhraseList;
}

} // namespace axiscomp::ui
