// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/phrase_book.h"

#include <QtGlobal>

namespace axiscomp::ui {

namespace {

// Core: directions, sign, comparison and grid of a table.
constexpr const char* gridPhraseList[] = {
    // a table by itself
    QT_TRANSLATE_NOOP("Error", "{axis} has fewer than two positions"),
    QT_TRANSLATE_NOOP("Error", "the positions of {axis} do not increase strictly"),
    QT_TRANSLATE_NOOP("Error",
        "the period of {axis}, {period}, is shorter than the range of its positions, {range}"),
    QT_TRANSLATE_NOOP("Error", "a table has 1 to 3 source axes, this has {count}"),
    QT_TRANSLATE_NOOP("Error", "the table has no values"),
    QT_TRANSLATE_NOOP("Error", "{number} values for {column}, for {points} points"),
    QT_TRANSLATE_NOOP("Error", "a value for {column} is not a finite number"),
    QT_TRANSLATE_NOOP("Error",
        "columns {first} and {second} both correct {axis} in the same direction; keep one of them"),
    QT_TRANSLATE_NOOP("Error", "values for {column}"),
    QT_TRANSLATE_NOOP("Error", "values for {axis} to {target}"),
    QT_TRANSLATE_NOOP("Error", "{column}, positive"),
    QT_TRANSLATE_NOOP("Error", "{column}, negative"),
    QT_TRANSLATE_NOOP("Error", "{place}, {axis} = {position}"),
    QT_TRANSLATE_NOOP("Error", "table {number} of {count}:"),
    // directions of motion
    QT_TRANSLATE_NOOP("Error", "the target without a name"),
    QT_TRANSLATE_NOOP(
        "Error", "there are two columns for {target} in positive direction; keep one of them"),
    QT_TRANSLATE_NOOP(
        "Error", "there are two columns for {target} in negative direction; keep one of them"),
    QT_TRANSLATE_NOOP("Error",
        "for {target} there are values for both directions and others for one; keep one of them"),
    QT_TRANSLATE_NOOP("Error",
        "{target} has values for the positive direction only, so that there is no mean; choose the "
        "positive direction"),
    QT_TRANSLATE_NOOP("Error",
        "{target} has values for the positive direction only, so that there is no negative one; "
        "choose the positive direction"),
    QT_TRANSLATE_NOOP("Error",
        "{target} has values for the negative direction only, so that there is no mean; choose the "
        "negative direction"),
    QT_TRANSLATE_NOOP("Error",
        "{target} has values for the negative direction only, so that there is no positive one; "
        "choose the negative direction"),
    // the sign
    QT_TRANSLATE_NOOP("Error",
        "a full turn of {axis} begins with the correction {begin} and ends with {end}; make both "
        "the same, or leave the modulo out"),
    QT_TRANSLATE_NOOP("Error", "the numbers are too large to be added to each other"),
    QT_TRANSLATE_NOOP("Error",
        "from there to {place} the correction changes by {change}, so that positions would change "
        "their order; check the unit of the values"),
    QT_TRANSLATE_NOOP("Error",
        "the correction of {axis} changes by {change} for each unit of the way, too much for "
        "several axes that are corrected together; check the unit of the values"),
    QT_TRANSLATE_NOOP("Error",
        "the corrections are so steep that {count} steps do not find the place that belongs to it; "
        "check the unit of the values"),
    // a comparison
    QT_TRANSLATE_NOOP("Error", "the second table has no column for {column}"),
    QT_TRANSLATE_NOOP("Error", "the second table has no column for {axis} to {target}"),
    QT_TRANSLATE_NOOP(
        "Error", "a table of {count} source axes cannot be compared with one of {other}"),
    QT_TRANSLATE_NOOP("Error",
        "compared at {count} positions, each by its controller's rules ({axis} to {target}): "
        "{difference}"),
    // another grid
    QT_TRANSLATE_NOOP("Error",
        "a deviation of {deviation} takes more than {count} points along {axis}; with {most} it is "
        "{found}; allow more points or a larger deviation"),
    QT_TRANSLATE_NOOP("Error",
        "a deviation of {deviation} takes more points than allowed; with {sizes} points it is "
        "{found}; allow more points or a larger deviation"),
    QT_TRANSLATE_NOOP("Error",
        "a deviation of {deviation} takes more points than allowed; it takes at least {sizes} "
        "points; allow more points or a larger deviation"),
    QT_TRANSLATE_NOOP("Error", "the wanted deviation must be a number of 0 or more"),
    QT_TRANSLATE_NOOP("Error", "limits for {count} axes are given, the table has {axes}"),
    QT_TRANSLATE_NOOP("Error", "a grid has at least two points along each axis; allow as many"),
    QT_TRANSLATE_NOOP("Error",
        "a full turn of {axis} begins with {begin} and ends with {end}; make both the same, or "
        "leave the modulo out"),
    QT_TRANSLATE_NOOP("Error", "the values for {column} are too large to be interpolated"),
    QT_TRANSLATE_NOOP(
        "Error", "the values for {axis} to {target} are too large to be interpolated"),
    QT_TRANSLATE_NOOP("Error", "grids for {count} axes are given, the table has {axes}"),
    QT_TRANSLATE_NOOP("Error",
        "the points along {axis} would be so close that positions cannot tell them apart; take "
        "fewer"),
    QT_TRANSLATE_NOOP("Error", "for {axis} both a number of points and a distance are given"),
    QT_TRANSLATE_NOOP(
        "Error", "the grid along {axis} must end above its start, not go from {from} to {to}"),
    QT_TRANSLATE_NOOP("Error", "{count} points along {axis} are more than {most}"),
    QT_TRANSLATE_NOOP("Error", "for a part of {axis} a number of points or a distance is needed"),
    QT_TRANSLATE_NOOP("Error", "the grid along {axis} must be one full turn, from {from} to {to}"),
    QT_TRANSLATE_NOOP("Error",
        "the grid along {axis} begins at {from}, before the data at {data}; stay within the data, "
        "or let the end values be held"),
    QT_TRANSLATE_NOOP("Error",
        "the grid along {axis} ends at {to}, behind the data at {data}; stay within the data, or "
        "let the end values be held"),
    QT_TRANSLATE_NOOP(
        "Error", "a distance of {distance} along {axis} makes more than {count} points"),
};

} // namespace

std::span<const char* const> gridPhrases()
{
    return gridPhraseList;
}

} // namespace axiscomp::ui
