// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/phrase_book.h"

#include <QtGlobal>

namespace axiscomp::ui {

namespace {

// What core says of plans, drives and proofs.
constexpr const char* planPhraseList[] = {
    QT_TRANSLATE_NOOP("Error", "axis {axis} is named twice"),
    QT_TRANSLATE_NOOP("Error",
        "together these writes cost {cost} flash operations, and {left} are possible now; write "
        "them volatile, or fewer at a time"),
    QT_TRANSLATE_NOOP("Error", "the axis must be homed first"),
    QT_TRANSLATE_NOOP("Error", "the axis has no table; write one first"),
    QT_TRANSLATE_NOOP("Error", "the number of sources must equal the table's dimensions"),
    QT_TRANSLATE_NOOP("Error", "a source is not a Single or Double register of this drive"),
    QT_TRANSLATE_NOOP("Error", "the drive cannot use the table; write it again"),
    QT_TRANSLATE_NOOP("Error", "see the drive's manual"),
    QT_TRANSLATE_NOOP("Error", "it did not become {state} in time"),
    QT_TRANSLATE_NOOP(
        "Error", "the drive has restarted, or somebody else has switched the compensation"),
    QT_TRANSLATE_NOOP("Error", "only an active or an evaluating compensation can be proved"),
    QT_TRANSLATE_NOOP("Error",
        "No other slot is free: the table in {slot} is overwritten. A copy is kept in the backup."),
    QT_TRANSLATE_NOOP(
        "Error", "What {slot} holds now is overwritten. A copy is kept in the backup."),
    QT_TRANSLATE_NOOP("Error",
        "The new table is volatile: after a reboot the axis has the old, persistent one again."),
    QT_TRANSLATE_NOOP("Error",
        "The parameters of all axes are saved, but the table of {axis} in {slot} is volatile: "
        "after a reboot that axis has no table."),
    QT_TRANSLATE_NOOP("Error",
        "The new table is volatile and covers an older one that flash holds in {slot}: after a "
        "reboot the axis may have that one again, until the parameters are saved, which deletes "
        "it."),
    QT_TRANSLATE_NOOP("Error",
        "After a reboot the drive would look for another table in {slot}: the parameters are saved "
        "once before the new one goes into flash. When the write is interrupted then, the axis may "
        "have no table after a reboot."),
    QT_TRANSLATE_NOOP("Error",
        "Flash may hold an older table in {slot}: it is deleted before the parameters are saved."),
    QT_TRANSLATE_NOOP("Error",
        "The file says that the values are in {unit}, but {axis} counts in {other}: the numbers "
        "are written as they are, not converted."),
    QT_TRANSLATE_NOOP("Error",
        "The file says that the values are in {unit}, but {axis} counts in {other}: the numbers "
        "are written as they are, not converted, {factor} times too large."),
    QT_TRANSLATE_NOOP("Error",
        "The file says that the values are in {unit}, but {axis} counts in {other}: the numbers "
        "are written as they are, not converted, {factor} times too small."),
    QT_TRANSLATE_NOOP("Error", "the settings of {axis}"),
    QT_TRANSLATE_NOOP("Error", "the settings of axis {axis}"),
    QT_TRANSLATE_NOOP("Error", "axis {axis}"),
    QT_TRANSLATE_NOOP("Error", "axis {axis} ({name})"),
    QT_TRANSLATE_NOOP("Error", "axis {axis} after a reboot"),
    QT_TRANSLATE_NOOP("Error", "the cogging compensation of axis {axis}"),
    QT_TRANSLATE_NOOP("Error", "{slot} holds only {size} bytes"),
    QT_TRANSLATE_NOOP("Error", "{slot} is used by {user}"),
    QT_TRANSLATE_NOOP("Error", "{slot} holds a table that is not this axis's"),
    QT_TRANSLATE_NOOP("Error", "no table"),
    QT_TRANSLATE_NOOP("Error", "{table} (CRC {crc}), persistent"),
    QT_TRANSLATE_NOOP("Error", "{table} (CRC {crc}), volatile"),
    QT_TRANSLATE_NOOP("Error", "{table} (CRC {crc}), {sources}, persistent"),
    QT_TRANSLATE_NOOP("Error", "{table} (CRC {crc}), {sources}, volatile"),
    QT_TRANSLATE_NOOP("Error", "{path} at offset {offset}"),
    QT_TRANSLATE_NOOP("Error", "nothing"),
    QT_TRANSLATE_NOOP("Error", "the output"),
    QT_TRANSLATE_NOOP("Error", "the index of dimension {dimension}"),
    QT_TRANSLATE_NOOP("Error", "the dimensionality is 1, 2 or 3"),
    QT_TRANSLATE_NOOP("Error", "; a URI is written tam://mc/<drive>/<path>"),
    QT_TRANSLATE_NOOP("Error", "; an address is written 0x and 1 to 8 hex digits"),
    QT_TRANSLATE_NOOP("Error", ": no register has this address"),
    QT_TRANSLATE_NOOP("Error", "; the nearest are {names}"),
    QT_TRANSLATE_NOOP("Error", "there is no backup that differs from what the axis has now"),
    QT_TRANSLATE_NOOP("Error", "the program is ending"),
    QT_TRANSLATE_NOOP("Error", "the backup"),
    QT_TRANSLATE_NOOP("Error", "slot {slot}"),
    QT_TRANSLATE_NOOP("Error", "the table in {slot}"),
    QT_TRANSLATE_NOOP("Error", "empty"),
    QT_TRANSLATE_NOOP("Error", "{size} bytes"),
    QT_TRANSLATE_NOOP("Error", "{count} values (CRC {crc}), persistent"),
    QT_TRANSLATE_NOOP("Error", "{count} values (CRC {crc}), volatile"),
    QT_TRANSLATE_NOOP("Error", "empty, used by {user}"),
    QT_TRANSLATE_NOOP("Error", "{count} values (CRC {crc}), persistent, used by {user}"),
    QT_TRANSLATE_NOOP("Error", "{count} values (CRC {crc}), volatile, used by {user}"),
    QT_TRANSLATE_NOOP("Error", "the unfinished write to axis {axis}"),
    QT_TRANSLATE_NOOP("Error", "it is not of axis {axis} of this drive"),
    QT_TRANSLATE_NOOP("Error", "the name of a file beside the journal is expected"),
    QT_TRANSLATE_NOOP("Error", "it is not the table that was kept there: its size or CRC differs"),
    QT_TRANSLATE_NOOP("Error", "axis {axis} has no Table register"),
    QT_TRANSLATE_NOOP("Error", "axis {axis} is named twice"),
    QT_TRANSLATE_NOOP("Error",
        "together these writes cost {count} flash operations, and {left} are possible now; write "
        "them volatile, or fewer at a time"),
};

} // namespace

std::span<const char* const> planPhrases()
{
    return planPhraseList;
}

} // namespace axiscomp::ui
