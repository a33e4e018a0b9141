// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/phrase_book.h"

#include <QtGlobal>

namespace axiscomp::ui {

namespace {

// Core: what the registry of formats says about each of them.
constexpr const char* formatPhraseList[] = {
    QT_TRANSLATE_NOOP("Error", "leadscrew compensation of one source (DEFINE COMP)"),
    QT_TRANSLATE_NOOP("Error", "compensation of a motor by two others (DEFINE COMP)"),
    QT_TRANSLATE_NOOP(
        "Error", "encoder counts for one unit, of every motor without a setting of its own"),
    QT_TRANSLATE_NOOP("Error", "encoder counts for one unit; without it tables are in counts"),
    QT_TRANSLATE_NOOP(
        "Error", "position of the sources that counts: desired (written with D) or actual"),
    QT_TRANSLATE_NOOP("Error", "encoder counts for one unit of the positions"),
    QT_TRANSLATE_NOOP("Error", "encoder counts for one unit of the values"),
    QT_TRANSLATE_NOOP("Error", "encoder counts for one unit of the row motor"),
    QT_TRANSLATE_NOOP("Error", "encoder counts for one unit of the column motor"),
    QT_TRANSLATE_NOOP("Error", "number of the motor whose position counts, 1 to 32"),
    QT_TRANSLATE_NOOP("Error", "number of the motor that is compensated, 1 to 32"),
    QT_TRANSLATE_NOOP("Error", "number of the motor along a row of entries, 1 to 32"),
    QT_TRANSLATE_NOOP("Error", "number of the motor from row to row, 1 to 32"),
    QT_TRANSLATE_NOOP("Error", "number of the axis that changes along a line, from 1"),
    QT_TRANSLATE_NOOP("Error", "number of the axis that changes from line to line, from 1"),
    QT_TRANSLATE_NOOP("Error", "number of the axis of the first corrections, from 1"),
    QT_TRANSLATE_NOOP("Error", "number of the axis of the second corrections, from 1"),
    QT_TRANSLATE_NOOP("Error", "number of the axis of the third corrections, from 1"),
    QT_TRANSLATE_NOOP("Error", "number of the axis, from 1, instead of the table's name for it"),
    QT_TRANSLATE_NOOP("Error", "calibration file of single axes (:START)"),
    QT_TRANSLATE_NOOP("Error", "calibration file of two axes (:START2D)"),
    QT_TRANSLATE_NOOP(
        "Error", "numbers of the axes for which METRIC means degrees, such as 4,5; all others mm"),
    QT_TRANSLATE_NOOP("Error", "what PRIMARY, SECONDARY or COUNTS stand for, such as mm"),
    QT_TRANSLATE_NOOP("Error",
        "METRIC (mm and degrees), or PRIMARY: the table's own units are those of the axes"),
    QT_TRANSLATE_NOOP("Error", "[bed_mesh NAME] sections of printer.cfg: heights of the bed"),
    QT_TRANSLATE_NOOP("Error", "heightmap.csv, version 2: heights of the bed"),
    QT_TRANSLATE_NOOP("Error",
        "names of the axes in degrees, such as C,B; all others are in mm, and modulo axes in "
        "degrees anyway"),
    QT_TRANSLATE_NOOP("Error", "calibration file: reference positions and compensation values"),
    QT_TRANSLATE_NOOP("Error", "table file of the drive, laid out as the drive profile says"),
    QT_TRANSLATE_NOOP("Error", "CSV file of positions and offsets"),
    QT_TRANSLATE_NOOP("Error", "cross compensation in a compensation list (kw.crosscomp)"),
    QT_TRANSLATE_NOOP("Error", "plane compensation in a compensation list (kw.crosscomp2)"),
    QT_TRANSLATE_NOOP("Error", "leadscrew error compensation in a compensation list (kw.ssfk)"),
    QT_TRANSLATE_NOOP("Error", "compensation file of a joint: nominal forward reverse"),
    QT_TRANSLATE_NOOP("Error", "CSV file of this program with the table of a compensator"),
    QT_TRANSLATE_NOOP("Error", "C++ header with the table of a compensator"),
    QT_TRANSLATE_NOOP("Error", "sag and angularity compensation ($AN_CEC)"),
    QT_TRANSLATE_NOOP("Error", "encoder and leadscrew error compensation ($AA_ENC_COMP)"),
    QT_TRANSLATE_NOOP("Error", "text table of positions and corrections"),
    QT_TRANSLATE_NOOP("Error", "MC-BASIC assignments to SourceData and TargetData"),
    QT_TRANSLATE_NOOP(
        "Error", "of a rotary axis: the range after which its position begins again, such as 360"),
    QT_TRANSLATE_NOOP(
        "Error", "logical number of the axis whose position counts, for master_ax_nr"),
    QT_TRANSLATE_NOOP("Error", "cycles over which switching is smoothed, for n_cycles"),
    QT_TRANSLATE_NOOP(
        "Error", "the master is a modulo axis: the first and the last point are one place"),
    QT_TRANSLATE_NOOP("Error", "whether the master axis is linear (mm) or rotary (deg)"),
    QT_TRANSLATE_NOOP("Error", "whether the compensated axis is linear (mm) or rotary (deg)"),
    QT_TRANSLATE_NOOP("Error", "logical number of master axis {number}, for {key}"),
    QT_TRANSLATE_NOOP("Error", "whether master axis {number} is linear (mm) or rotary (deg)"),
    QT_TRANSLATE_NOOP("Error", "master axis {number} is a modulo axis: its ends are one place"),
    QT_TRANSLATE_NOOP("Error", "whether the axis is linear (mm) or rotary (deg)"),
    QT_TRANSLATE_NOOP("Error", "metric: 0.1 um and 0.0001 deg; increments: of the encoder"),
    QT_TRANSLATE_NOOP("Error", "encoder increments for one mm or degree, of a list in increments"),
    QT_TRANSLATE_NOOP("Error", "write numbers with decimals, which only newer kernels take"),
    QT_TRANSLATE_NOOP("Error", "logical number of the axis that is compensated, for kopf.achs_nr"),
    QT_TRANSLATE_NOOP(
        "Error", "COMP_FILE_TYPE: 0 for measured positions, 1 for trims; 0 is assumed"),
    QT_TRANSLATE_NOOP("Error", "COMP_FILE_TYPE: 0 for measured positions, 1 for trims"),
    QT_TRANSLATE_NOOP("Error", "raw counts of the output axis for one unit of the values"),
    QT_TRANSLATE_NOOP("Error", "the same, where the file does not say it"),
    QT_TRANSLATE_NOOP("Error", "unit of the positions, the user unit of the input axes"),
    QT_TRANSLATE_NOOP("Error",
        "unit of the values, the user unit of the output axis; otherwise that of the positions"),
    QT_TRANSLATE_NOOP("Error", "namespace of the constants, a C++ name"),
    QT_TRANSLATE_NOOP("Error", "unit of the positions, where the file does not say it"),
    QT_TRANSLATE_NOOP("Error", "unit of the values, where the file does not say it"),
    QT_TRANSLATE_NOOP("Error", "index of the first table that is written"),
    QT_TRANSLATE_NOOP(
        "Error", "name of the axis whose position counts, instead of the table's name for it"),
    QT_TRANSLATE_NOOP(
        "Error", "name of the axis that is compensated, instead of the table's name for it"),
    QT_TRANSLATE_NOOP(
        "Error", "name of the machine axis, such as X1, instead of the table's name for it"),
    QT_TRANSLATE_NOOP("Error", "measuring system of the axis"),
    QT_TRANSLATE_NOOP("Error", "name of the compensation table in the MC-BASIC program"),
    QT_TRANSLATE_NOOP("Error", "the drive stores the table in its flash"),
};

/// The keys of settings, with blanks, and what can be chosen.
constexpr const char* settingNames[] = {
    QT_TRANSLATE_NOOP("Setting", "column axis"),
    QT_TRANSLATE_NOOP("Setting", "row axis"),
    QT_TRANSLATE_NOOP("Setting", "output axis 1"),
    QT_TRANSLATE_NOOP("Setting", "output axis 2"),
    QT_TRANSLATE_NOOP("Setting", "output axis 3"),
    QT_TRANSLATE_NOOP("Setting", "source counts per unit"),
    QT_TRANSLATE_NOOP("Setting", "target counts per unit"),
    QT_TRANSLATE_NOOP("Setting", "column counts per unit"),
    QT_TRANSLATE_NOOP("Setting", "source motor"),
    QT_TRANSLATE_NOOP("Setting", "target motor"),
    QT_TRANSLATE_NOOP("Setting", "row motor"),
    QT_TRANSLATE_NOOP("Setting", "column motor"),
    QT_TRANSLATE_NOOP("Setting", "position"),
    QT_TRANSLATE_NOOP("Setting", "desired"),
    QT_TRANSLATE_NOOP("Setting", "actual"),
    QT_TRANSLATE_NOOP("Setting", "counts per unit"),
    QT_TRANSLATE_NOOP("Setting", "position unit"),
    QT_TRANSLATE_NOOP("Setting", "value unit"),
    QT_TRANSLATE_NOOP("Setting", "wrap range"),
    QT_TRANSLATE_NOOP("Setting", "master axis"),
    QT_TRANSLATE_NOOP("Setting", "master1 axis"),
    QT_TRANSLATE_NOOP("Setting", "master2 axis"),
    QT_TRANSLATE_NOOP("Setting", "n cycles"),
    QT_TRANSLATE_NOOP("Setting", "master kind"),
    QT_TRANSLATE_NOOP("Setting", "master1 kind"),
    QT_TRANSLATE_NOOP("Setting", "master2 kind"),
    QT_TRANSLATE_NOOP("Setting", "axis kind"),
    QT_TRANSLATE_NOOP("Setting", "modulo"),
    QT_TRANSLATE_NOOP("Setting", "modulo1"),
    QT_TRANSLATE_NOOP("Setting", "modulo2"),
    QT_TRANSLATE_NOOP("Setting", "list unit"),
    QT_TRANSLATE_NOOP("Setting", "increments per unit"),
    QT_TRANSLATE_NOOP("Setting", "decimals"),
    QT_TRANSLATE_NOOP("Setting", "axis"),
    QT_TRANSLATE_NOOP("Setting", "type"),
    QT_TRANSLATE_NOOP("Setting", "name"),
    QT_TRANSLATE_NOOP("Setting", "first table"),
    QT_TRANSLATE_NOOP("Setting", "input axis"),
    QT_TRANSLATE_NOOP("Setting", "output axis"),
    QT_TRANSLATE_NOOP("Setting", "encoder"),
    QT_TRANSLATE_NOOP("Setting", "persistent"),
    QT_TRANSLATE_NOOP("Setting", "rotary axes"),
    QT_TRANSLATE_NOOP("Setting", "primary unit"),
    QT_TRANSLATE_NOOP("Setting", "units"),
    QT_TRANSLATE_NOOP("Setting", "primary"),
    QT_TRANSLATE_NOOP("Setting", "metric"),
    QT_TRANSLATE_NOOP("Setting", "increments"),
    QT_TRANSLATE_NOOP("Setting", "linear"),
    QT_TRANSLATE_NOOP("Setting", "rotary"),
};

} // namespace

std::span<const char* const> formatPhrases()
{
    return formatPhraseList;
}

std::span<const char* const> settingPhrases()
{
    return settingNames;
}

} // namespace axiscomp::ui
