// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/phrase_book.h"

#include <QtGlobal>

namespace axiscomp::ui {

namespace {

// Core: files, folders and documents on this computer.
constexpr const char* filePhraseList[] = {
    QT_TRANSLATE_NOOP("Error", "{text} is not the SHA-256 of a certificate"),
    QT_TRANSLATE_NOOP("Error", "it does not exist"),
    QT_TRANSLATE_NOOP("Error", "no permission"),
    QT_TRANSLATE_NOOP("Error", "the disk is full"),
    QT_TRANSLATE_NOOP("Error", "the disk quota is used up"),
    QT_TRANSLATE_NOOP("Error", "the file system is read-only"),
    QT_TRANSLATE_NOOP("Error", "it is a folder"),
    QT_TRANSLATE_NOOP("Error", "a part of the path is not a folder"),
    QT_TRANSLATE_NOOP("Error", "the name is too long"),
    QT_TRANSLATE_NOOP("Error", "its symbolic links lead in a circle"),
    QT_TRANSLATE_NOOP("Error", "it would be larger than a file may be here"),
    QT_TRANSLATE_NOOP("Error", "the disk reports an error"),
    QT_TRANSLATE_NOOP("Error", "there is not enough memory"),
    QT_TRANSLATE_NOOP("Error", "the folder {folder} does not exist"),
    QT_TRANSLATE_NOOP("Error", "more than {size}"),
    QT_TRANSLATE_NOOP("Error", "another program is using it; try again when that one has finished"),
    QT_TRANSLATE_NOOP("Error", "it cannot be locked: {reason}"),
    QT_TRANSLATE_NOOP("Error", "it does not read back as it was written"),
    QT_TRANSLATE_NOOP("Error", "it is damaged and cannot be moved aside ({reason}); delete it"),
    QT_TRANSLATE_NOOP("Error",
        "it was kept about a write that did not end, but is damaged ({reason}). Look at what the "
        "drive holds, then delete the file"),
    QT_TRANSLATE_NOOP("Error", "it is about axis {axis} of drive {drive}"),
    QT_TRANSLATE_NOOP("Error", "it is damaged"),
    QT_TRANSLATE_NOOP("Error", "it cannot be renamed: {reason}"),
    QT_TRANSLATE_NOOP("Error", "it is not an ordinary file; move it away"),
    QT_TRANSLATE_NOOP("Error", "it is the database of another program; move it away"),
    QT_TRANSLATE_NOOP("Error", "a newer version of this program has written it; use that version"),
    QT_TRANSLATE_NOOP("Error", "the file is read-only"),
    QT_TRANSLATE_NOOP("Error", "the file or its folder is read-only"),
    QT_TRANSLATE_NOOP("Error", "this file system cannot share it between programs"),
    QT_TRANSLATE_NOOP("Error",
        "it is on a network file system, where a database can be damaged; set XDG_STATE_HOME to "
        "a folder on this computer"),
    QT_TRANSLATE_NOOP("Error", "this is not JSON"),
    QT_TRANSLATE_NOOP("Error", "the document"),
    QT_TRANSLATE_NOOP("Error", "line {line}, column {column}"),
    QT_TRANSLATE_NOOP("Error", "{place}: {problem}"),
    QT_TRANSLATE_NOOP("Error", "the member \"{name}\" is there twice in one object"),
    QT_TRANSLATE_NOOP("Error", "the member \"{name}\" is not known"),
    QT_TRANSLATE_NOOP("Error", "it has more than {count} values"),
    QT_TRANSLATE_NOOP("Error", "it is nested deeper than {count} levels"),
    QT_TRANSLATE_NOOP(
        "Error", "it has {size} bytes, more than the {limit} that such a file can have"),
    QT_TRANSLATE_NOOP("Error", "an object is expected, not {found}"),
    QT_TRANSLATE_NOOP("Error", "a list is expected, not {found}"),
    QT_TRANSLATE_NOOP("Error", "a text is expected, not {found}"),
    QT_TRANSLATE_NOOP("Error", "true or false is expected, not {found}"),
    QT_TRANSLATE_NOOP("Error", "a number is expected, not {found}"),
    QT_TRANSLATE_NOOP("Error", "a whole number from {least} to {most} is expected, not {found}"),
    QT_TRANSLATE_NOOP("Error", "a list"),
    QT_TRANSLATE_NOOP("Error", "an object"),
    QT_TRANSLATE_NOOP("Error", "this is missing"),
    QT_TRANSLATE_NOOP("Error", "this is empty"),
    QT_TRANSLATE_NOOP("Error", "this is there twice"),
    QT_TRANSLATE_NOOP("Error", "this is not base64"),
    QT_TRANSLATE_NOOP("Error", "this is too large for a Single"),
    QT_TRANSLATE_NOOP("Error", "a number is expected, or NaN, Infinity, -Infinity as a text"),
    QT_TRANSLATE_NOOP("Error", "the bytes have the CRC-32 {crc}, so they are damaged"),
    QT_TRANSLATE_NOOP("Error", "this file is there twice"),
    QT_TRANSLATE_NOOP("Error", "this axis of the drive is there twice"),
    QT_TRANSLATE_NOOP("Error", "\"{format}\" is expected"),
    QT_TRANSLATE_NOOP("Error",
        "only version {version} can be read; a newer version of this program may have written it"),
    QT_TRANSLATE_NOOP("Error", "one of Boolean, Int32, UInt32, Single, Double, Enum is expected"),
    QT_TRANSLATE_NOOP("Error", "a time such as 2026-11-21T08:02:23Z is expected"),
    QT_TRANSLATE_NOOP("Error", "a CRC-32 of eight hexadecimal digits such as 1c291ca3 is expected"),
};

} // namespace

std::span<const char* const> filePhrases()
{
    return filePhraseList;
}

} // namespace axiscomp::ui
