// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/phrase_book.h"

#include <QtGlobal>

namespace axiscomp::ui {

namespace {

// Core: the files of machine tools and printers.
constexpr const char* machinePhraseList[] = {
    // ISG kernel
    QT_TRANSLATE_NOOP(
        "Error", "the position {position} is the same as the one before when it is rounded"),
    QT_TRANSLATE_NOOP("Error", "the position {position} is beyond the 32 bits of its numbers"),
    QT_TRANSLATE_NOOP("Error", "the value {value} is beyond the 32 bits of its numbers"),
    QT_TRANSLATE_NOOP("Error", "master axis {number}"),
    QT_TRANSLATE_NOOP("Error", "ascending setpoints"),
    QT_TRANSLATE_NOOP("Error", "{number} at the end"),
    QT_TRANSLATE_NOOP("Error", "{number}, as at the beginning"),
    QT_TRANSLATE_NOOP("Error", "activate it in the axis list of axis {axis}: {parameter} 1"),
    QT_TRANSLATE_NOOP("Error", "QUADRATIC or RECTANGULAR"),
    QT_TRANSLATE_NOOP("Error", "different values at both ends"),
    QT_TRANSLATE_NOOP("Error", "different values at both ends of master axis {number}"),
    QT_TRANSLATE_NOOP("Error", "the same values: a modulo axis is at the same place there"),
    QT_TRANSLATE_NOOP("Error", "the same values, since modulo is 1"),
    QT_TRANSLATE_NOOP(
        "Error", "the distance of {distance} along master {axis} is no whole number of {step}"),
    QT_TRANSLATE_NOOP("Error", "resample it with such a distance"),
    QT_TRANSLATE_NOOP("Error", "it takes one distance for both sources, and these are different"),
    QT_TRANSLATE_NOOP("Error", "numbers of 0.1 um or 0.0001 deg"),
    QT_TRANSLATE_NOOP("Error", "increments for one mm or degree"),
    QT_TRANSLATE_NOOP(
        "Error", "the setting {key}, linear or rotary; linear is assumed, so that it is mm"),
    QT_TRANSLATE_NOOP("Error", "numbers in encoder increments"),
    QT_TRANSLATE_NOOP(
        "Error", "the setting increments-per-unit, where millimetres or degrees matter"),
    QT_TRANSLATE_NOOP("Error", "the setting increments-per-unit is not above 0"),
    QT_TRANSLATE_NOOP("Error",
        "numbers in mm or degrees become increments only with the setting increments-per-unit"),
    QT_TRANSLATE_NOOP("Error", "an index from 0 such as [3], at most two of them"),
    QT_TRANSLATE_NOOP("Error", "a table kw.{name} besides kw.{other}"),
    QT_TRANSLATE_NOOP("Error", "the format isg-{format} to read it; it is left out here"),
    QT_TRANSLATE_NOOP("Error", "nothing after End"),
    QT_TRANSLATE_NOOP("Error", "a value behind the name and a blank"),
    QT_TRANSLATE_NOOP("Error", "a point kw.{point} with one index"),
    QT_TRANSLATE_NOOP("Error", "a point kw.{point} with two indices"),
    QT_TRANSLATE_NOOP("Error", "a table kw.{name}, of which there is no entry"),
    QT_TRANSLATE_NOOP("Error", "the entry {name}, which is missing"),
    QT_TRANSLATE_NOOP("Error", "a whole number, {range}"),
    QT_TRANSLATE_NOOP("Error", "no entry {name}"),
    QT_TRANSLATE_NOOP("Error", "0 or 1; 0 is assumed"),
    QT_TRANSLATE_NOOP("Error", "0 or 1; 1 is assumed"),
    QT_TRANSLATE_NOOP("Error", "the logical number of the axis, from 1"),
    QT_TRANSLATE_NOOP("Error", "at most {number}, which is {name}"),
    QT_TRANSLATE_NOOP("Error", "at most {number}, which is the standard value of {name}"),
    QT_TRANSLATE_NOOP("Error", "indices within the size that the list says"),
    QT_TRANSLATE_NOOP("Error", "no kw.{name}"),
    QT_TRANSLATE_NOOP("Error", "{number} of them; there are {number2}"),
    QT_TRANSLATE_NOOP("Error", "0, or a distance above 0"),
    QT_TRANSLATE_NOOP("Error", "{entry} and setpoints of each point"),
    QT_TRANSLATE_NOOP("Error", "an interval of 0 with setpoints, or an interval without"),
    QT_TRANSLATE_NOOP("Error", "values neg without bilateral 1"),
    QT_TRANSLATE_NOOP("Error", "values pos only; neg is left out"),
    // SINUMERIK
    QT_TRANSLATE_NOOP("Error", "the index of a table, 0 to {number}"),
    QT_TRANSLATE_NOOP("Error", "each variable once"),
    QT_TRANSLATE_NOOP("Error", "each variable once; the first is in line {line}"),
    QT_TRANSLATE_NOOP("Error", "tables {name} besides {other}"),
    QT_TRANSLATE_NOOP("Error", "one index: [table]"),
    QT_TRANSLATE_NOOP("Error", "two indices: [table,point]"),
    QT_TRANSLATE_NOOP("Error", "two indices: [encoder,axis]"),
    QT_TRANSLATE_NOOP("Error", "three indices: [encoder,point,axis]"),
    QT_TRANSLATE_NOOP("Error", "0, 1 or -1"),
    QT_TRANSLATE_NOOP("Error", "{variable} of {curve}, which is missing"),
    QT_TRANSLATE_NOOP("Error", "a product with another table"),
    QT_TRANSLATE_NOOP("Error", "a table by itself; the product is left out"),
    QT_TRANSLATE_NOOP("Error", "variables {name}, of which there are none"),
    QT_TRANSLATE_NOOP("Error", "there is no table {number}"),
    QT_TRANSLATE_NOOP("Error", "choose fewer tables, or another first-table"),
    QT_TRANSLATE_NOOP("Error",
        "table {index} needs $MN_MM_CEC_MAX_POINTS[{same}] (MD18342) of at least {count}; switch "
        "it on with $SN_CEC_TABLE_ENABLE[{again}] (SD41300) 1 and $MA_CEC_ENABLE (MD32710) 1 of "
        "axis {axis}"),
    QT_TRANSLATE_NOOP("Error", "the measuring system, 0 or 1"),
    QT_TRANSLATE_NOOP("Error", "measuring system {number} of axis {axis}"),
    QT_TRANSLATE_NOOP("Error", "0 or 1, and the name of an axis, at most {number} of them"),
    QT_TRANSLATE_NOOP("Error", "axis {axis}, encoder {number}"),
    QT_TRANSLATE_NOOP("Error", "its positions and values are not both lengths or both angles"),
    QT_TRANSLATE_NOOP("Error",
        "axis {axis} needs $MA_MM_ENC_COMP_MAX_POINTS (MD38000) of at least {count}; load the file "
        "with $MA_ENC_COMP_ENABLE (MD32700) 0, then set it to 1"),
    QT_TRANSLATE_NOOP("Error", "an index in [ ] behind the name"),
    QT_TRANSLATE_NOOP("Error", "an index that ends in ]"),
    QT_TRANSLATE_NOOP("Error", "= and a value behind the index"),
    QT_TRANSLATE_NOOP("Error", "a value behind ="),
    QT_TRANSLATE_NOOP("Error", "nothing behind the end of the program, M17"),
    QT_TRANSLATE_NOOP("Error", "an assignment such as $NAME[0,1]=0.5, CHANDATA(1) or M17"),
    QT_TRANSLATE_NOOP("Error", "{variable} of {curve} a second time"),
    QT_TRANSLATE_NOOP("Error", "the number of a point, from 0"),
    QT_TRANSLATE_NOOP("Error", "a compensation value"),
    QT_TRANSLATE_NOOP("Error", "MIN {min}, MAX {max} and STEP {step} of {curve}"),
    QT_TRANSLATE_NOOP("Error", "a STEP above 0 and a MAX above MIN"),
    QT_TRANSLATE_NOOP("Error", "a whole number of steps from MIN to MAX"),
    QT_TRANSLATE_NOOP("Error", "point {number} of {curve}"),
    QT_TRANSLATE_NOOP("Error", "point {number} of {curve} a second time"),
    QT_TRANSLATE_NOOP("Error", "points up to {number}, which MIN, MAX and STEP give"),
    QT_TRANSLATE_NOOP("Error", "no point {number} of {curve}"),
    QT_TRANSLATE_NOOP(
        "Error", "{number} points, which MIN, MAX and STEP give; there are {number2}"),
    QT_TRANSLATE_NOOP("Error", "no ${variable} of {curve}"),
    QT_TRANSLATE_NOOP("Error", "{number} at MAX of {curve}"),
    QT_TRANSLATE_NOOP("Error", "{number}, as at MIN, which follows it"),
    QT_TRANSLATE_NOOP("Error",
        "\"{axis}\" is no axis name for the format {format}, such as X1; give the setting {key}"),
    // LinuxCNC
    QT_TRANSLATE_NOOP("Error",
        "three numbers: nominal forward reverse; the controller stops reading here without a "
        "message"),
    QT_TRANSLATE_NOOP("Error", "{text} after three numbers"),
    QT_TRANSLATE_NOOP("Error", "nothing; it is left out, as the controller does"),
    QT_TRANSLATE_NOOP("Error", "at most 256; the controller leaves out the others"),
    QT_TRANSLATE_NOOP("Error", "a measured position that does not increase"),
    QT_TRANSLATE_NOOP("Error", "increasing ones; if these are trims, the setting type=1"),
    QT_TRANSLATE_NOOP("Error", "measured positions (COMP_FILE_TYPE 0)"),
    QT_TRANSLATE_NOOP("Error", "the setting type=0, or type=1 if these are trims"),
    QT_TRANSLATE_NOOP("Error", "increasing ones; perhaps these are trims (type=1)"),
    QT_TRANSLATE_NOOP("Error", "trims that change by {change}"),
    QT_TRANSLATE_NOOP(
        "Error", "less than the positions do; perhaps these are measured positions (type=0)"),
    QT_TRANSLATE_NOOP("Error", "a measured position at {position} is beyond what a number can be"),
    QT_TRANSLATE_NOOP("Error", "check the unit of positions and values"),
    QT_TRANSLATE_NOOP("Error",
        "in the section [JOINT_n] of the INI file: COMP_FILE = {file} and COMP_FILE_TYPE = {type}"),
    QT_TRANSLATE_NOOP("Error",
        "in the section [JOINT_n] of the INI file: COMP_FILE = the file and COMP_FILE_TYPE = "
        "{type}"),
    QT_TRANSLATE_NOOP("Error", "BACKLASH of the joint is not used any more"),
    // heights of printers' beds
    QT_TRANSLATE_NOOP("Error", "a second section for the profile {name}"),
    QT_TRANSLATE_NOOP("Error", "each profile once"),
    QT_TRANSLATE_NOOP("Error", "an entry such as min_x = 10"),
    QT_TRANSLATE_NOOP("Error", "each entry once in a section"),
    QT_TRANSLATE_NOOP("Error", "an entry {key} in this section"),
    QT_TRANSLATE_NOOP("Error", "version {version}"),
    QT_TRANSLATE_NOOP("Error", "1; the firmware does not use other versions"),
    QT_TRANSLATE_NOOP("Error", "a height in mm"),
    QT_TRANSLATE_NOOP("Error", "a position in mm"),
    QT_TRANSLATE_NOOP("Error", "an offset in mm"),
    QT_TRANSLATE_NOOP("Error", "{number} lines of points"),
    QT_TRANSLATE_NOOP("Error", "max_{maximum} after min_{minimum}"),
    QT_TRANSLATE_NOOP("Error", "a maximum above the minimum"),
    QT_TRANSLATE_NOOP("Error", "a section [bed_mesh NAME] with the points of a mesh"),
    QT_TRANSLATE_NOOP(
        "Error", "{axis} from {number} to {number2} by {number3} in {number4} points"),
    QT_TRANSLATE_NOOP("Error", "at least 2 along each axis"),
    QT_TRANSLATE_NOOP("Error", "as many points as lie between minimum and maximum"),
    QT_TRANSLATE_NOOP("Error", "the axes \"{first}\" and \"{second}\""),
    QT_TRANSLATE_NOOP("Error", "two different letters"),
    QT_TRANSLATE_NOOP("Error", "a point that was not probed at {position}, {other}"),
    QT_TRANSLATE_NOOP("Error", "a height with decimals"),
    QT_TRANSLATE_NOOP("Error", "a further line after {number}"),
    QT_TRANSLATE_NOOP("Error", "{number} lines of heights"),
    QT_TRANSLATE_NOOP("Error", "the line {line}"),
    QT_TRANSLATE_NOOP("Error", "the line {line}, or {other}"),
};

} // namespace

std::span<const char* const> machinePhrases()
{
    return machinePhraseList;
}

} // namespace axiscomp::ui
