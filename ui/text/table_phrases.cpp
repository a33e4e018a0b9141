// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/phrase_book.h"

#include <QtGlobal>

namespace axiscomp::ui {

namespace {

// Core: what readers and writers of all formats have in common.
constexpr const char* tablePhraseList[] = {
    // what the readers of all formats say
    QT_TRANSLATE_NOOP("Error", "{number} positions of {axis}"),
    QT_TRANSLATE_NOOP("Error", "{number} positions of the points"),
    QT_TRANSLATE_NOOP("Error", "{number} positions of the joint"),
    QT_TRANSLATE_NOOP("Error", "{number} after {number2}"),
    QT_TRANSLATE_NOOP("Error", "strictly increasing positions of {axis}"),
    QT_TRANSLATE_NOOP("Error", "strictly increasing positions of the points"),
    QT_TRANSLATE_NOOP("Error", "strictly increasing positions of the joint"),
    QT_TRANSLATE_NOOP("Error", "positions of {axis}"),
    QT_TRANSLATE_NOOP("Error", "positions of the axis"),
    QT_TRANSLATE_NOOP(
        "Error", "numbers that a computer can tell from each other; check their size"),
    QT_TRANSLATE_NOOP("Error", "values of {target}"),
    QT_TRANSLATE_NOOP("Error", "values of the table"),
    QT_TRANSLATE_NOOP("Error", "numbers that a computer can hold; check their size"),
    QT_TRANSLATE_NOOP("Error", "axis {number}"),
    QT_TRANSLATE_NOOP("Error", "source {number}"),
    QT_TRANSLATE_NOOP("Error", "{axes}, source {number}"),
    QT_TRANSLATE_NOOP("Error", "table {number}"),
    QT_TRANSLATE_NOOP("Error", "at least 2"),
    QT_TRANSLATE_NOOP("Error", "{number} to {number2}"),
    QT_TRANSLATE_NOOP("Error", "{number} points"),
    QT_TRANSLATE_NOOP("Error", "at most {number} points"),
    QT_TRANSLATE_NOOP("Error", "{number} rows"),
    QT_TRANSLATE_NOOP("Error", "{number} numbers"),
    QT_TRANSLATE_NOOP("Error", "{number} values"),
    QT_TRANSLATE_NOOP("Error", "{number} lines"),
    QT_TRANSLATE_NOOP("Error", "{number} entries"),
    QT_TRANSLATE_NOOP("Error", "{number} heights"),
    QT_TRANSLATE_NOOP("Error", "a number"),
    QT_TRANSLATE_NOOP("Error", "a number above 0"),
    QT_TRANSLATE_NOOP("Error", "a number of points"),
    QT_TRANSLATE_NOOP("Error", "a number for {key}"),
    QT_TRANSLATE_NOOP("Error", "the number of {key}"),
    QT_TRANSLATE_NOOP("Error", "a distance above 0"),
    QT_TRANSLATE_NOOP("Error", "a correction"),
    QT_TRANSLATE_NOOP("Error", "{what} a second time"),
    QT_TRANSLATE_NOOP("Error", "a second {key}"),
    QT_TRANSLATE_NOOP("Error", "each entry once"),
    QT_TRANSLATE_NOOP("Error", "each entry once; the first is in line {line}"),
    QT_TRANSLATE_NOOP("Error", "each point once"),
    QT_TRANSLATE_NOOP("Error", "{value}, as {key} says"),
    QT_TRANSLATE_NOOP("Error", "{value}, as the setting {key} says"),
    QT_TRANSLATE_NOOP("Error", "{number}, one for each position of {axis}"),
    QT_TRANSLATE_NOOP("Error", "the format {format} to read it; it is left out here"),
    QT_TRANSLATE_NOOP("Error", "the format {format} to read them; they are left out here"),
    // units
    QT_TRANSLATE_NOOP("Error", "numbers in {from} cannot be given in {to}"),
    QT_TRANSLATE_NOOP("Error", "a unit that is not said"),
    QT_TRANSLATE_NOOP("Error", "positions without a unit"),
    QT_TRANSLATE_NOOP("Error", "values without a unit"),
    QT_TRANSLATE_NOOP("Error", "numbers without a unit"),
    QT_TRANSLATE_NOOP("Error", "the setting {key}, such as mm, where a unit matters"),
    QT_TRANSLATE_NOOP("Error", "the setting {key}, such as um, where a unit matters"),
    QT_TRANSLATE_NOOP("Error", "the setting {key}, where a unit matters"),
    QT_TRANSLATE_NOOP("Error", "positions"),
    QT_TRANSLATE_NOOP("Error", "values"),
    QT_TRANSLATE_NOOP(
        "Error", "not all units are said: the values are taken to be in the unit of the positions"),
    QT_TRANSLATE_NOOP(
        "Error", "the values were in {before} and are now in {unit}, the unit of the positions"),
    QT_TRANSLATE_NOOP("Error", "positions in {unit} and values in {other}"),
    QT_TRANSLATE_NOOP("Error", "one unit, since the controller adds the values to the positions"),
    QT_TRANSLATE_NOOP("Error", "{units}: the format {format} has one unit for both"),
    QT_TRANSLATE_NOOP(
        "Error", "it corrects an axis by its own position, and this table goes from {axis}"),
    QT_TRANSLATE_NOOP("Error",
        "it corrects an axis by its own position, and this table goes from {axis} to {target}"),
    QT_TRANSLATE_NOOP("Error", "choose a format for cross compensation"),
    QT_TRANSLATE_NOOP("Error", "check the unit of the table"),
    QT_TRANSLATE_NOOP("Error", "check the units of the table"),
    QT_TRANSLATE_NOOP(
        "Error", "the {what} are in {from}, which cannot be given in {to}; correct the units"),
    // settings and limits of formats
    QT_TRANSLATE_NOOP("Error", "a text"),
    QT_TRANSLATE_NOOP("Error", "none"),
    QT_TRANSLATE_NOOP(
        "Error", "the format {format} has no setting {key} for writing; it has: {known}"),
    QT_TRANSLATE_NOOP(
        "Error", "the format {format} has no setting {key} for reading; it has: {known}"),
    QT_TRANSLATE_NOOP("Error", "the format {format} can be read, not written"),
    QT_TRANSLATE_NOOP("Error",
        "the format {format} names its axes by numbers from 1; the setting {key} is {value}"),
    QT_TRANSLATE_NOOP("Error",
        "the format {format} names its axes by numbers from 1 and there is no number in the axis "
        "name \"{name}\"; give the setting {key}"),
    QT_TRANSLATE_NOOP("Error",
        "its positions of source {number} span {span}, and a modulo axis needs exactly one period "
        "of {period}"),
    QT_TRANSLATE_NOOP("Error", "resample it over one whole period"),
    QT_TRANSLATE_NOOP("Error",
        "the values at both ends of the modulo axis, source {number}, differ by {difference}"),
    QT_TRANSLATE_NOOP("Error", "make both ends equal: they are the same place"),
    QT_TRANSLATE_NOOP("Error", "its modulo axis is not rotary"),
    QT_TRANSLATE_NOOP("Error", "leave the modulo out"),
    QT_TRANSLATE_NOOP("Error",
        "it takes a column for both directions of motion, or one for each direction of one axis"),
    QT_TRANSLATE_NOOP("Error", "choose these columns"),
    QT_TRANSLATE_NOOP("Error", "{count} columns are more than the {limit} of one table"),
    QT_TRANSLATE_NOOP("Error", "choose a column, and write the others to files of their own"),
    QT_TRANSLATE_NOOP("Error", "{count} tables are more than the {limit} of one file"),
    QT_TRANSLATE_NOOP("Error", "choose one, and write the others to files of their own"),
    QT_TRANSLATE_NOOP("Error", "choose one of them"),
    QT_TRANSLATE_NOOP("Error", "{size} bytes are more than the {limit} of a file"),
    QT_TRANSLATE_NOOP("Error", "it compensates {target} by the position of {axis}"),
    QT_TRANSLATE_NOOP("Error",
        "it compensates {target} by the position of {axis}, and the format compensates an axis by "
        "its own position"),
    QT_TRANSLATE_NOOP("Error", "write it as {format}"),
    QT_TRANSLATE_NOOP("Error", "there are two tables for axis {axis}"),
    QT_TRANSLATE_NOOP("Error", "a TAM table needs the table layout of a drive profile"),
    QT_TRANSLATE_NOOP("Error", "a calibration file needs the number of its dimensions: 1, 2 or 3"),
    // a problem of a file that a sentence quotes
    QT_TRANSLATE_NOOP("Error", "this line does not have the columns of the header"),
    QT_TRANSLATE_NOOP("Error", "{problem}: found \"{found}\""),
    QT_TRANSLATE_NOOP("Error", "{problem}: found {found}"),
    QT_TRANSLATE_NOOP("Error", "{problem}, expected {expected}"),
    QT_TRANSLATE_NOOP("Error", "{problem}; {wayOut} ({name})"),
    QT_TRANSLATE_NOOP("Error", "{problem} ({name})"),
    QT_TRANSLATE_NOOP("Error", "{problem} ({name}, error {number} of the controller)"),
    QT_TRANSLATE_NOOP("Error", "found an empty cell"),
};

} // namespace

std::span<const char* const> tablePhrases()
{
    return tablePhraseList;
}

} // namespace axiscomp::ui
