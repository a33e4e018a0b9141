// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/fanuc/pitch_data.h"
#include "core/formats/formats.h"
#include "core/formats/wrap_range.h"

#include <array>

namespace axiscomp::fanuc {

namespace {

constexpr std::array<std::string_view, 1> extensions{".txt"};
constexpr std::array settings{
    FormatSetting{.key = referenceNumberKey,
        .kind = FormatSetting::Kind::WholeNumber,
        .meaning = AXISCOMP_TEXT("Error", "number of the reference point, parameter 3620"),
        .forReading = true,
        .forWriting = true,
        .isNeeded = true},
    FormatSetting{.key = intervalKey,
        .kind = FormatSetting::Kind::Number,
        .meaning = AXISCOMP_TEXT(
            "Error", "interval of the points, parameter 3624, in the unit of the positions"),
        .forReading = true,
        .isNeeded = true},
    FormatSetting{.key = detectionUnitKey,
        .kind = FormatSetting::Kind::Number,
        .meaning = AXISCOMP_TEXT(
            "Error", "detection unit of the axis, in the unit of the positions, such as 0.001"),
        .forReading = true,
        .forWriting = true,
        .isNeeded = true},
    FormatSetting{.key = magnificationKey,
        .kind = FormatSetting::Kind::WholeNumber,
        .meaning = AXISCOMP_TEXT("Error", "magnification of the values, parameter 3623"),
        .standard = "1",
        .forReading = true,
        .forWriting = true},
    FormatSetting{.key = referencePositionKey,
        .kind = FormatSetting::Kind::Number,
        .meaning = AXISCOMP_TEXT("Error", "position of the reference point"),
        .standard = "0",
        .forReading = true,
        .forWriting = true},
    FormatSetting{.key = firstNumberKey,
        .kind = FormatSetting::Kind::WholeNumber,
        .meaning = AXISCOMP_TEXT("Error",
            "lowest number of the axis, parameter 3621, instead of the lowest one in the file"),
        .forReading = true},
    FormatSetting{.key = lastNumberKey,
        .kind = FormatSetting::Kind::WholeNumber,
        .meaning = AXISCOMP_TEXT("Error",
            "highest number of the axis, parameter 3622, instead of the highest one in the file"),
        .forReading = true},
    FormatSetting{.key = firstRecordKey,
        .kind = FormatSetting::Kind::WholeNumber,
        .meaning = AXISCOMP_TEXT("Error", "what N of a line is for number 0"),
        .standard = "10000",
        .forReading = true,
        .forWriting = true},
    FormatSetting{.key = largestStepKey,
        .kind = FormatSetting::Kind::WholeNumber,
        .meaning = AXISCOMP_TEXT("Error", "largest value that the controller takes for a number"),
        .standard = "7",
        .forWriting = true},
    wrapRangeSetting};

constexpr std::array<std::string_view, 6> rules{
    "Lines such as N10033P2, number and value, between two lines %. Parameters may stand in the "
    "same file; ; ends a line as well.",
    "Each number stands for a section of the axis, one interval long; its value is the change of "
    "the correction over it, in increments of magnification x detection unit.",
    "Parameter 3620 is the number of the reference point, 3621 and 3622 are the outermost numbers, "
    "3623 is the magnification, 3624 the interval, 3625 the travel of one turn.",
    "With R the number of the reference point, a rotary axis has the numbers R + 1 to R + turn / "
    "interval, whose values add up to 0; number R has the value of the last one.",
    "Bit 0 of parameter 3605, with 3626 and 3627, switches to values for each direction of motion.",
    "New values count after power off and on and a return to the reference point; alarm PW1102 "
    "says "
    "that numbers do not fit.",
};
constexpr std::array<std::string_view, 9> assumptions{
    "Nothing tells such a file from one of parameters, so it is never recognised: it must be named "
    "(--from fanuc).",
    "With R the number of the reference point, number R + k (k from 1) is the section that ends k "
    "intervals above it, and number R - k (k from 0) the one that ends k + 1 intervals below it, "
    "as "
    "in the published example. At the reference point the correction is 0.",
    "Parameters 3620 to 3625 of the file must be those of one axis that the settings describe; "
    "3624 "
    "and 3625 without a decimal point, whose unit is not known, are a warning. Others are passed "
    "over.",
    "A value is put out to the axis as pulses, as an offset that is added to the commanded "
    "position. Nobody has published the sign.",
    "The line of number 0 is N10000, which first-record changes; numbers are 0 to 9999, and lines "
    "above are left out with a warning.",
    "A value is at most 7, which largest-step changes, since later controls take more.",
    "Where within its section a value is put out is not published: the correction is taken to be "
    "linear over the section, and its place is in doubt by half an interval. Outside of the points "
    "it is held.",
    "Values for each direction of motion are refused, and so is a file with a parameter 3605 whose "
    "bit 0 is 1: how their lines are numbered was not found.",
    "More than 128 points of an axis are a warning: only one source, and not the manual, says that "
    "limit.",
};

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    return readFile(fanuc::format(), text, options);
}

Recognition recognise(std::string_view)
{
    return Recognition::No;
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    return writeFile(fanuc::format(), tables.front(), options.settings);
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "fanuc",
            .controller = "Fanuc",
            .description = AXISCOMP_TEXT("Error", "stored pitch error data of an axis (N10033P2)"),
            .extensions = extensions,
            .knots = KnotRule::Even,
            .mostPoints = static_cast<std::size_t>(mostNumbers) + 1,
            .holdsWrap = true,
            .numbers = "whole numbers of detection units",
            .sign = SignConvention::Command,
            .signEvidence = Evidence::Assumed,
            .behaviour = {.outside = Outside::Hold},
            .outsideEvidence = Evidence::Assumed,
            .settings = settings,
            .rules = rules,
            .assumptions = assumptions},
        .recognise = recognise,
        .read = read,
        .write = write};
    return format;
}

} // namespace axiscomp::fanuc
