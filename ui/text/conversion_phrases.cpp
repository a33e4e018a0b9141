// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/phrase_book.h"

#include <QtGlobal>

namespace axiscomp::ui {

namespace {

// Core: what a conversion of tables reports, and why there is none.
constexpr const char* conversionPhraseList[] = {
    QT_TRANSLATE_NOOP("Error", "the numbers of the file are taken as they are"),
    QT_TRANSLATE_NOOP("Error", "sign: {from}; {example}"),
    QT_TRANSLATE_NOOP("Error", "{format} holds feedback values"),
    QT_TRANSLATE_NOOP("Error", "{format} holds command values"),
    QT_TRANSLATE_NOOP("Error", "{format} holds feedback values, as you say"),
    QT_TRANSLATE_NOOP("Error", "{format} holds command values, as you say"),
    QT_TRANSLATE_NOOP("Error", "{from}, {format} holds feedback values"),
    QT_TRANSLATE_NOOP("Error", "{from}, {format} holds command values"),
    QT_TRANSLATE_NOOP("Error", "{from}, {format} holds feedback values, as you say"),
    QT_TRANSLATE_NOOP("Error", "{from}, {format} holds command values, as you say"),
    QT_TRANSLATE_NOOP("Error", "{example}: the feedback file says {value}"),
    QT_TRANSLATE_NOOP("Error", "{example}: the command file says {value}"),
    QT_TRANSLATE_NOOP(
        "Error", "{example}: the feedback file says {value}, the command file {other}"),
    QT_TRANSLATE_NOOP("Error", "all values are 0, in either sign"),
    QT_TRANSLATE_NOOP("Error", "moving in positive direction, {example}"),
    QT_TRANSLATE_NOOP("Error", "moving in negative direction, {example}"),
    QT_TRANSLATE_NOOP("Error", "where the encoder reads {place} the reference says {moved}"),
    QT_TRANSLATE_NOOP(
        "Error", "where the encoders read {place} the reference of {axis} says {moved}"),
    QT_TRANSLATE_NOOP("Error",
        "where the encoder reads {place} the reference of {axis} is {offset} above its encoder"),
    QT_TRANSLATE_NOOP("Error",
        "where the encoder reads {place} the reference of {axis} is {offset} below its encoder"),
    QT_TRANSLATE_NOOP("Error",
        "where the encoders read {place} the reference of {axis} is {offset} above its encoder"),
    QT_TRANSLATE_NOOP("Error",
        "where the encoders read {place} the reference of {axis} is {offset} below its encoder"),
    QT_TRANSLATE_NOOP("Error",
        "commanded to {place}, the controller moves the encoder to {moved}, where the reference "
        "says {reference}"),
    QT_TRANSLATE_NOOP("Error",
        "commanded to {place}, the controller moves the encoder of {axis} to {moved}, where the "
        "reference says {reference}"),
    QT_TRANSLATE_NOOP("Error",
        "commanded to {place}, where the reference of {axis} is {offset} above its encoder, the "
        "controller moves {target} by {value}"),
    QT_TRANSLATE_NOOP("Error",
        "commanded to {place}, where the reference of {axis} is {offset} below its encoder, the "
        "controller moves {target} by {value}"),
    QT_TRANSLATE_NOOP("Error", "the target"),
    QT_TRANSLATE_NOOP("Error", "{axis} = {position}"),
    QT_TRANSLATE_NOOP("Error",
        "resampled from {before} points to {after} points: at the positions of the source it is "
        "off by at most {largest}, {rms} rms"),
    QT_TRANSLATE_NOOP(
        "Error", "one value for both directions of motion, {choice}: they are the same"),
    QT_TRANSLATE_NOOP("Error",
        "one value for both directions of motion, {choice}, for {target}: they are the same"),
    QT_TRANSLATE_NOOP("Error",
        "one value for both directions of motion, {choice}: half their difference is up to {loss}, "
        "at {place}"),
    QT_TRANSLATE_NOOP("Error",
        "one value for both directions of motion, {choice}, for {target}: half their difference is "
        "up to {loss}, at {place}"),
    QT_TRANSLATE_NOOP("Error", "they do not differ"),
    QT_TRANSLATE_NOOP("Error",
        "they differ by at most {largest} at {place}, and not at all where both have values"),
    QT_TRANSLATE_NOOP("Error", "the numbers of the file are rounded: values by up to {value}"),
    QT_TRANSLATE_NOOP("Error",
        "the numbers of the file are rounded: values by up to {value}, positions by up to "
        "{position}"),
    QT_TRANSLATE_NOOP(
        "Error", "compared at {count} positions, each by its controller's rules: {difference}"),
    QT_TRANSLATE_NOOP("Error",
        "compared at {count} positions, each by its controller's rules ({column}): {difference}"),
    QT_TRANSLATE_NOOP("Error", "they differ by at most {largest}"),
    QT_TRANSLATE_NOOP("Error", "they differ by at most {largest} at {place}"),
    QT_TRANSLATE_NOOP("Error",
        "they differ by at most {largest} at {place}, where both have values by at most {inside}"),
    QT_TRANSLATE_NOOP("Error",
        "at the ends of the table the sign was converted with the end values held, where the "
        "controller of the source applies nothing"),
    QT_TRANSLATE_NOOP("Error",
        "that files of the format {format} hold the feedback convention is an assumption: check "
        "one point on the machine"),
    QT_TRANSLATE_NOOP("Error",
        "that files of the format {format} hold the command convention is an assumption: check one "
        "point on the machine"),
    QT_TRANSLATE_NOOP("Error", "the {what} have no unit; they are taken to be {unit}"),
    QT_TRANSLATE_NOOP("Error", "the positions are in {unit}"),
    QT_TRANSLATE_NOOP("Error", "the values are in {unit}"),
    QT_TRANSLATE_NOOP("Error", "positions and values are in {unit}"),
    QT_TRANSLATE_NOOP("Error", "no known unit"),
    QT_TRANSLATE_NOOP("Error", "{range}: the grid ends at {end}, {distance} behind it"),
    QT_TRANSLATE_NOOP("Error", "{range}: the grid ends at {end}, {distance} before its end"),
    QT_TRANSLATE_NOOP(
        "Error", "the range of {axis} from {from} to {to} is no whole multiple of {distance}"),
    QT_TRANSLATE_NOOP("Error", "a number of points is a whole number, at least 2"),
    QT_TRANSLATE_NOOP("Error", "the number for the even grid is missing"),
    QT_TRANSLATE_NOOP(
        "Error", "the even grid needs one number, or one for each of the {count} source axes"),
    QT_TRANSLATE_NOOP("Error", "the format {format} can be written, not read"),
    QT_TRANSLATE_NOOP("Error", "the format {format} needs the setting {key} ({meaning})"),
    QT_TRANSLATE_NOOP("Error", "the setting {key} is \"{value}\", expected {expected} ({meaning})"),
    QT_TRANSLATE_NOOP("Error", "a whole number"),
    QT_TRANSLATE_NOOP("Error", "one of {choices}"),
    QT_TRANSLATE_NOOP("Error", "yes or no"),
    QT_TRANSLATE_NOOP("Error", "the positions of source {number} are not evenly spaced"),
    QT_TRANSLATE_NOOP("Error", "resample it onto an even grid"),
    QT_TRANSLATE_NOOP("Error", "resample it onto a coarser grid"),
    QT_TRANSLATE_NOOP("Error", "it takes one distance for all sources, and these are different"),
    QT_TRANSLATE_NOOP("Error", "resample it with the same distance for each source"),
    QT_TRANSLATE_NOOP("Error", "it has one value for both directions of motion"),
    QT_TRANSLATE_NOOP("Error", "choose the mean, the positive or the negative direction"),
    QT_TRANSLATE_NOOP("Error", "it has {count} source axis, possible are {range}"),
    QT_TRANSLATE_NOOP("Error", "it has {count} source axes, possible are {range}"),
    QT_TRANSLATE_NOOP("Error", "choose another format"),
    QT_TRANSLATE_NOOP(
        "Error", "{count} points are more than the {limit} that the controller takes"),
    QT_TRANSLATE_NOOP("Error", "it has no modulo axes"),
    QT_TRANSLATE_NOOP("Error", "leave the modulo out when the axis stays within one revolution"),
    QT_TRANSLATE_NOOP("Error", "its values are offsets of the command"),
    QT_TRANSLATE_NOOP("Error", "convert the sign"),
    QT_TRANSLATE_NOOP("Error", "a value is beyond what a float32 can be"),
    QT_TRANSLATE_NOOP("Error", "check the unit of the values"),
    QT_TRANSLATE_NOOP("Error", "a grid along {axis} needs at least two points"),
    QT_TRANSLATE_NOOP("Error", "the distance along {axis} must be a number above 0"),
    QT_TRANSLATE_NOOP("Error",
        "the positions of {axis} are not evenly spaced; give a number of points or a distance"),
    QT_TRANSLATE_NOOP("Error",
        "the full turn of {axis}, {turn}, is no whole multiple of {distance}; possible are {fewer} "
        "or {more}"),
    QT_TRANSLATE_NOOP("Error",
        "a distance of {distance} is longer than the range of {axis} from {from} to {to}; take a "
        "shorter one, or let the end values be held"),
    QT_TRANSLATE_NOOP(
        "Error", "the grid would have more than {count} points; take fewer along an axis"),
};

} // namespace

std::span<const char* const> conversionPhrases()
{
    return conversionPhraseList;
}

} // namespace axiscomp::ui
