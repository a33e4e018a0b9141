// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/phrase_book.h"

#include <QtGlobal>

namespace axiscomp::ui {

namespace {

// Core: calibration files and tables.
constexpr const char* calibrationPhraseList[] = {
    QT_TRANSLATE_NOOP("Error", "{size} bytes"),
    QT_TRANSLATE_NOOP("Error", "at most {size} bytes"),
    QT_TRANSLATE_NOOP("Error", "{count} columns"),
    QT_TRANSLATE_NOOP("Error", "1 column"),
    QT_TRANSLATE_NOOP("Error", "at most {count} columns"),
    QT_TRANSLATE_NOOP("Error", "a line with the names of the columns, not only comments"),
    QT_TRANSLATE_NOOP("Error", "no data lines after the header"),
    QT_TRANSLATE_NOOP("Error", "at least 2 positions in each dimension, one line per grid point"),
    QT_TRANSLATE_NOOP("Error", "the names of the columns, not numbers"),
    QT_TRANSLATE_NOOP("Error",
        "at least {count} for dimensionality {dimensions}, {positions} of positions and 1 of "
        "values"),
    QT_TRANSLATE_NOOP("Error", "{expected} (or is the dimensionality {dimensions}?)"),
    QT_TRANSLATE_NOOP("Error", "{expected}; separate the columns with {separator} instead of tabs"),
    QT_TRANSLATE_NOOP("Error", "{expected}; separate the columns with , or ;"),
    QT_TRANSLATE_NOOP("Error", "{expected}; separate the columns with , or ; instead of tabs"),
    QT_TRANSLATE_NOOP("Error",
        "{expected}; if the commas are decimal commas, separate the columns with ; in every line"),
    QT_TRANSLATE_NOOP("Error",
        "{expected}; the header separates its columns with {separator}, so every line must"),
    QT_TRANSLATE_NOOP("Error", "{expected}; decimal commas need the separator ; in every line"),
    QT_TRANSLATE_NOOP("Error", "{count} as in the header (line {line})"),
    QT_TRANSLATE_NOOP("Error", "a closing \" in the same line"),
    QT_TRANSLATE_NOOP("Error", "a separator after the closing \""),
    QT_TRANSLATE_NOOP("Error", "a separator or the end of the line after the closing \""),
    QT_TRANSLATE_NOOP("Error", "a number such as {example}"),
    QT_TRANSLATE_NOOP("Error", "a finite number such as {example}"),
    QT_TRANSLATE_NOOP("Error", "0 or a number that is not as close to it"),
    QT_TRANSLATE_NOOP("Error", "a value that fits float32 (below 3.4e38)"),
    QT_TRANSLATE_NOOP("Error", "a decimal comma as in line {line}"),
    QT_TRANSLATE_NOOP("Error", "a decimal point as in line {line}"),
    QT_TRANSLATE_NOOP("Error", "no sign between the thousands"),
    QT_TRANSLATE_NOOP("Error", "more than {rows} data lines of {columns} columns"),
    QT_TRANSLATE_NOOP("Error", "at most {cells} cells (lines x columns)"),
    QT_TRANSLATE_NOOP("Error", "positions with a finite range"),
    QT_TRANSLATE_NOOP("Error", "positions whose distance a double can hold"),
    QT_TRANSLATE_NOOP("Error", "{position} (steps of {distance})"),
    QT_TRANSLATE_NOOP("Error", "{position} next to {before}"),
    QT_TRANSLATE_NOOP("Error", "{position} on an even line in steps of {distance}"),
    QT_TRANSLATE_NOOP("Error", "only {position}"),
    QT_TRANSLATE_NOOP("Error", "at least 2 different positions"),
    QT_TRANSLATE_NOOP("Error", "{point} in line {first} and again in line {second}"),
    QT_TRANSLATE_NOOP("Error", "every position once"),
    QT_TRANSLATE_NOOP("Error", "no line for {points} (missing: {missing} of {all} points)"),
    QT_TRANSLATE_NOOP("Error", "every combination of the positions"),
    QT_TRANSLATE_NOOP("Error", "{value} at every point of {table}"),
    QT_TRANSLATE_NOOP("Error", "values that differ"),
    QT_TRANSLATE_NOOP("Error", "a change of {change}"),
    QT_TRANSLATE_NOOP("Error", "at most a millionth of the largest value, {value}"),
    QT_TRANSLATE_NOOP(
        "Error", "a step from {from} to {to} over {distance} in dimension {dimension}"),
    QT_TRANSLATE_NOOP("Error", "at most 0.01 per unit of position"),
    QT_TRANSLATE_NOOP("Error", "UTF-16 text"),
    QT_TRANSLATE_NOOP("Error", "a spreadsheet workbook or ZIP archive"),
    QT_TRANSLATE_NOOP("Error", "an old Excel workbook"),
    QT_TRANSLATE_NOOP("Error", "a PDF document"),
    QT_TRANSLATE_NOOP("Error", "a compressed file (gzip)"),
    QT_TRANSLATE_NOOP("Error", "a picture"),
    QT_TRANSLATE_NOOP("Error", "a TAM table"),
    QT_TRANSLATE_NOOP("Error", "a binary file"),
    QT_TRANSLATE_NOOP("Error", "a NUL byte"),
    QT_TRANSLATE_NOOP("Error", "a text file"),
    QT_TRANSLATE_NOOP("Error", "the byte 0x{byte} ({character})"),
    QT_TRANSLATE_NOOP("Error", "file length"),
    QT_TRANSLATE_NOOP("Error", "element {number}"),
    QT_TRANSLATE_NOOP("Error", "{size} for the header and 4 for each of the {count} elements"),
    QT_TRANSLATE_NOOP("Error", "at least the {size} bytes of the header"),
    QT_TRANSLATE_NOOP("Error", "0 or 1"),
    QT_TRANSLATE_NOOP("Error", "1, 2 or 3"),
    QT_TRANSLATE_NOOP("Error", "2 or more"),
    QT_TRANSLATE_NOOP("Error", "1, because this dimension is not used"),
    QT_TRANSLATE_NOOP("Error", "{count}, the product of the sizes"),
    QT_TRANSLATE_NOOP("Error", "a finite number"),
    QT_TRANSLATE_NOOP("Error", "a finite number above 0"),
    QT_TRANSLATE_NOOP("Error", "one that leads to a finite last position"),
    QT_TRANSLATE_NOOP("Error", "one that tells positions such as {position} apart"),
    QT_TRANSLATE_NOOP("Error", "{crc}, the CRC of the header before it"),
    QT_TRANSLATE_NOOP("Error", "{crc}, the CRC of the elements"),
    QT_TRANSLATE_NOOP(
        "Error", "the size of dimension {dimension} is {value}, at least 2 is needed"),
    QT_TRANSLATE_NOOP(
        "Error", "the start value of dimension {dimension} is {value}, a finite number is needed"),
    QT_TRANSLATE_NOOP("Error",
        "the distance of dimension {dimension} is {value}, a finite number above 0 is needed"),
    QT_TRANSLATE_NOOP("Error",
        "the distance of dimension {dimension} is {value}, too little to tell positions such as "
        "{position} apart"),
    QT_TRANSLATE_NOOP(
        "Error", "the last position of dimension {dimension} is too large to be a number"),
    QT_TRANSLATE_NOOP("Error", "the table has {count} dimensions, 1 to 3 are possible"),
    QT_TRANSLATE_NOOP(
        "Error", "the table has {count} values, which is not the product of its sizes"),
    QT_TRANSLATE_NOOP("Error", "the table has more values than a file can count"),
    QT_TRANSLATE_NOOP("Error", "value {number} is {value}, a finite number is needed"),
    QT_TRANSLATE_NOOP("Error", "the table cannot be kept in this drive's table file: {reason}"),
    QT_TRANSLATE_NOOP(
        "Error", "{value} does not fit into the field {field}, which is of type {type}"),
    QT_TRANSLATE_NOOP("Error",
        "the grid of dimension {dimension}, start {start} and distance {distance}, cannot be held "
        "by fields of the types {first} and {second}"),
};

} // namespace

std::span<const char* const> calibrationPhrases()
{
    return calibrationPhraseList;
}

} // namespace axiscomp::ui
