// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/phrase_book.h"

#include <QtGlobal>

namespace axiscomp::ui {

namespace {

// Core: the files of motion controllers.
constexpr const char* motionPhraseList[] = {
    // Aerotech
    QT_TRANSLATE_NOOP("Error", "the number of one axis, from 1, behind :START"),
    QT_TRANSLATE_NOOP("Error", "SAMPLEDIST= and the distance of the corrections, which is not 0"),
    QT_TRANSLATE_NOOP("Error", "{number} corrections"),
    QT_TRANSLATE_NOOP("Error", "choose a table of an axis for itself"),
    QT_TRANSLATE_NOOP(
        "Error", "there are two tables for axis {axis}, and the controller adds their corrections"),
    QT_TRANSLATE_NOOP("Error", "the number of an axis, from 1"),
    QT_TRANSLATE_NOOP("Error",
        "7 numbers behind :START2D: row axis, column axis, two output axes, distance along rows, "
        "distance along columns, number of columns"),
    QT_TRANSLATE_NOOP("Error", "a distance"),
    QT_TRANSLATE_NOOP("Error", "the number of columns"),
    QT_TRANSLATE_NOOP("Error", "a distance of 0"),
    QT_TRANSLATE_NOOP("Error", "a distance that is not 0"),
    QT_TRANSLATE_NOOP("Error", "axis {number} for rows and columns"),
    QT_TRANSLATE_NOOP("Error", "two axes"),
    QT_TRANSLATE_NOOP("Error", "{number} points of {number2} corrections each in a row"),
    QT_TRANSLATE_NOOP("Error", "{number} corrections in this line, {number2} in all"),
    QT_TRANSLATE_NOOP("Error", "KEY=VALUE"),
    QT_TRANSLATE_NOOP("Error", ":END of the table that begins in line {line}"),
    QT_TRANSLATE_NOOP("Error", "{directive} before :END"),
    QT_TRANSLATE_NOOP("Error", "a table that begins with {directive}"),
    QT_TRANSLATE_NOOP("Error", "a table that begins with {directive} and ends with :END"),
    QT_TRANSLATE_NOOP(
        "Error", "{directive} or :END; tables of one and of two dimensions are in separate files"),
    QT_TRANSLATE_NOOP("Error", "each option once"),
    QT_TRANSLATE_NOOP("Error", "{key}= and a number"),
    QT_TRANSLATE_NOOP(
        "Error", "positions in the coordinates of the axis after homing; it is left out"),
    QT_TRANSLATE_NOOP("Error", "a table without {key}"),
    QT_TRANSLATE_NOOP("Error",
        "{key}=METRIC, ENGLISH, PRIMARY, SECONDARY or COUNTS, perhaps divided by a number as in "
        "METRIC/1000"),
    QT_TRANSLATE_NOOP("Error", "a correction that is too large for its unit"),
    QT_TRANSLATE_NOOP("Error", "another CORUNIT"),
    // iCube
    QT_TRANSLATE_NOOP("Error", "two numbers such as 0.25,0.001: position and offset"),
    QT_TRANSLATE_NOOP("Error", "1 number"),
    QT_TRANSLATE_NOOP("Error", "a position such as 0.25"),
    QT_TRANSLATE_NOOP("Error", "an offset such as 0.001"),
    QT_TRANSLATE_NOOP("Error", "lines of {expected}"),
    QT_TRANSLATE_NOOP("Error", "\"{line}\", which is taken to be a header"),
    QT_TRANSLATE_NOOP("Error", "{expected}, if it is a point"),
    QT_TRANSLATE_NOOP("Error", "position + offset {number} after {number2}"),
    QT_TRANSLATE_NOOP("Error", "1 point"),
    QT_TRANSLATE_NOOP("Error", "strictly decreasing positions"),
    QT_TRANSLATE_NOOP("Error", "strictly increasing positions"),
    QT_TRANSLATE_NOOP("Error", "strictly decreasing values, as the positions are"),
    QT_TRANSLATE_NOOP("Error", "strictly increasing values, as the positions are"),
    QT_TRANSLATE_NOOP("Error", "positions from {first} to {last}"),
    QT_TRANSLATE_NOOP("Error", "a span of exactly {range}, the wrap range"),
    QT_TRANSLATE_NOOP("Error", "the offsets {first} and {last} at the ends"),
    QT_TRANSLATE_NOOP("Error", "the same offset at both ends, which are one place"),
    QT_TRANSLATE_NOOP("Error", "the setting wrap-range is {value}, expected more than 0"),
    QT_TRANSLATE_NOOP(
        "Error", "the setting wrap-range is {value}, and the table repeats after {period}"),
    QT_TRANSLATE_NOOP("Error",
        "at {position} position + offset {sum} after {before} does not increase (error 4900 of the "
        "controller)"),
    QT_TRANSLATE_NOOP("Error", "check the unit of the values, or smooth them"),
    QT_TRANSLATE_NOOP("Error",
        "of a rotary axis it wants {expected}, and this table has {found} (error 4902 of the "
        "controller)"),
    QT_TRANSLATE_NOOP("Error", "add the point that closes the revolution"),
    QT_TRANSLATE_NOOP("Error",
        "the controller looks for the file as {name}PosComp.CSV, unless axis.xml names another "
        "one"),
    QT_TRANSLATE_NOOP("Error",
        "the controller looks for the file as the name of the axis and PosComp.CSV, unless "
        "axis.xml names another one"),
    // PMAC
    QT_TRANSLATE_NOOP("Error", "motor {number}"),
    QT_TRANSLATE_NOOP("Error", "a number of entries"),
    QT_TRANSLATE_NOOP("Error", "the number of a motor, #1 to #32, perhaps with a D"),
    QT_TRANSLATE_NOOP("Error", "DEFINE COMP entries,#source,#target,span"),
    QT_TRANSLATE_NOOP("Error", "DEFINE COMP rows.columns,#row,#column,#target,span,span"),
    QT_TRANSLATE_NOOP("Error", "a span in counts"),
    QT_TRANSLATE_NOOP("Error", "a span of {span}"),
    QT_TRANSLATE_NOOP("Error", "a span of {span} counts"),
    QT_TRANSLATE_NOOP("Error", "at least 1 count"),
    QT_TRANSLATE_NOOP("Error", "motors that are not named"),
    QT_TRANSLATE_NOOP(
        "Error", "the motor that is addressed when the file is loaded; name it with #"),
    QT_TRANSLATE_NOOP("Error", "a table of one dimension"),
    QT_TRANSLATE_NOOP("Error", "a table of two dimensions"),
    QT_TRANSLATE_NOOP("Error", "further entries: {entries}"),
    QT_TRANSLATE_NOOP("Error", "DEFINE COMP in front of them"),
    QT_TRANSLATE_NOOP("Error", "a whole number of 1/16 count"),
    QT_TRANSLATE_NOOP("Error", "DEFINE COMP for a table of one dimension"),
    QT_TRANSLATE_NOOP("Error", "DEFINE COMP for a table of two dimensions"),
    QT_TRANSLATE_NOOP("Error", "a table in counts"),
    QT_TRANSLATE_NOOP("Error", "different entries at 0 and at the span of motor {motor}"),
    QT_TRANSLATE_NOOP("Error", "the same: the table rolls over there"),
    QT_TRANSLATE_NOOP("Error", "entries that are too large in these units"),
    QT_TRANSLATE_NOOP("Error", "another counts-per-unit"),
    QT_TRANSLATE_NOOP(
        "Error", "the setting {key} of the format {format} is {value}, expected a number above 0"),
    QT_TRANSLATE_NOOP(
        "Error", "position 0, where its tables begin, is no point of source {number}"),
    QT_TRANSLATE_NOOP("Error", "resample it with a point at 0"),
    QT_TRANSLATE_NOOP(
        "Error", "its tables begin at position 0, which source {number} does not reach"),
    QT_TRANSLATE_NOOP("Error", "resample it over a range with 0"),
    QT_TRANSLATE_NOOP("Error", "check counts-per-unit and the unit of the positions"),
    QT_TRANSLATE_NOOP("Error", "the value {value} is beyond the 24 bits of an entry"),
    QT_TRANSLATE_NOOP("Error", "check counts-per-unit and the unit of the values"),
    QT_TRANSLATE_NOOP(
        "Error", "its value at position 0 is {value}, and the controller takes it to be 0 there"),
    QT_TRANSLATE_NOOP("Error", "subtract this value from all values"),
    QT_TRANSLATE_NOOP("Error", "there is no motor {number}"),
    QT_TRANSLATE_NOOP("Error", "choose one from 1 to 32"),
    QT_TRANSLATE_NOOP("Error", "switch the table on with I51=1; outside of its span it rolls over"),
    // RapidCode
    QT_TRANSLATE_NOOP("Error", "a line \"# {key} = NUMBER\" before the counts"),
    QT_TRANSLATE_NOOP("Error", "{number} to {number2} by {number3}"),
    QT_TRANSLATE_NOOP("Error", "a maximum above the minimum, and a delta above 0"),
    QT_TRANSLATE_NOOP("Error", "a range that is an integer multiple of the delta"),
    QT_TRANSLATE_NOOP("Error", "the unit {unit}"),
    QT_TRANSLATE_NOOP("Error", "no input.{name}"),
    QT_TRANSLATE_NOOP("Error", "no output.{name}"),
    QT_TRANSLATE_NOOP("Error", "values in counts"),
    QT_TRANSLATE_NOOP(
        "Error", "a line \"# output.counts-per-unit = NUMBER\", or the setting counts-per-unit"),
    QT_TRANSLATE_NOOP("Error", "a number of counts"),
    QT_TRANSLATE_NOOP("Error", "{number} counts per unit"),
    QT_TRANSLATE_NOOP("Error", "a number other than 0"),
    QT_TRANSLATE_NOOP("Error", "{number}, one for each position of the first axis"),
    QT_TRANSLATE_NOOP("Error", "{number}, one for each position of the second axis"),
    QT_TRANSLATE_NOOP("Error", "one line"),
    QT_TRANSLATE_NOOP("Error", "{number} lines of counts"),
    QT_TRANSLATE_NOOP(
        "Error", "the setting name is \"{name}\", expected a C++ name: letters, digits and _"),
    QT_TRANSLATE_NOOP(
        "Error", "the value {value} is {count} counts, and at most 2147483647 can be held"),
    QT_TRANSLATE_NOOP("Error", "the setting counts-per-unit is 0, expected a number of counts"),
    QT_TRANSLATE_NOOP("Error", "counts-per-unit is understood as {count} counts for 1 {unit}"),
    QT_TRANSLATE_NOOP(
        "Error", "counts-per-unit is understood as {count} counts for 1 unit of the values"),
    QT_TRANSLATE_NOOP("Error",
        "an input axis is the output axis: its command position must be the input, the actual "
        "position is not possible"),
    QT_TRANSLATE_NOOP("Error",
        "the inputs are other axes: their command or their actual positions can be the inputs"),
    // softMC
    QT_TRANSLATE_NOOP("Error", "the number of source axes, 1 to 3"),
    QT_TRANSLATE_NOOP("Error", "{number} source axes"),
    QT_TRANSLATE_NOOP("Error", "{number} sizes"),
    QT_TRANSLATE_NOOP("Error", "{number}, one for each source axis"),
    QT_TRANSLATE_NOOP("Error", "the number of points of a source"),
    QT_TRANSLATE_NOOP("Error", "at least 2, and at most {number} rows in all"),
    QT_TRANSLATE_NOOP("Error", "{number} positions and at least one correction"),
    QT_TRANSLATE_NOOP("Error", "{number}, as in the first row"),
    QT_TRANSLATE_NOOP("Error", "a source position"),
    QT_TRANSLATE_NOOP("Error", "{number} for source {number2}"),
    QT_TRANSLATE_NOOP("Error", "{number}: the first source changes fastest"),
    QT_TRANSLATE_NOOP("Error", "positions of source {axis} from {first} to {last}"),
    QT_TRANSLATE_NOOP("Error", "equal distances"),
    QT_TRANSLATE_NOOP("Error", "a header of {sizes} = {number} rows, and {number2} rows"),
    QT_TRANSLATE_NOOP("Error", "as many rows as the header says"),
    QT_TRANSLATE_NOOP("Error",
        "the setting name is \"{name}\", expected letters, digits and _, beginning with a letter"),
    QT_TRANSLATE_NOOP("Error",
        "the table {name} must be defined in the program, with {count} points, and not be in use "
        "(CompActive = 0) while the lines run"),
    QT_TRANSLATE_NOOP("Error",
        "the table {name} must be defined in the program, with {count} points, the first source "
        "fastest, and not be in use (CompActive = 0) while the lines run"),
};

} // namespace

std::span<const char* const> motionPhrases()
{
    return motionPhraseList;
}

} // namespace axiscomp::ui
