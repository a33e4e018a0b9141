// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"
#include "core/formats/pmac/pmac_file.h"
#include "core/formats/units.h"

namespace axiscomp::pmac {

namespace {

/// What the formats differ in: words only.
struct Words {
    std::string_view name;
    TextPattern description;
    Keys keys;
    std::span<const FormatSetting> settings;
    std::span<const std::string_view> rules;
};

constexpr std::string_view unnamedMotors =
    "Motors that are not named are the one that is addressed, #1 in front.";
constexpr std::string_view desiredPosition =
    "D: the desired position of the source counts, otherwise the actual one.";

constexpr std::array<std::string_view, 1> motors1d{"source-motor"};
constexpr std::array<std::string_view, 1> counts1d{"source-counts-per-unit"};
constexpr std::array settings1d{countsForWriting("source-counts-per-unit, target-counts-per-unit"),
    countsForReading, usesActual,
    countsSetting(
        counts1d[0], AXISCOMP_TEXT("Error", "encoder counts for one unit of the positions")),
    targetCounts,
    motorSetting(
        motors1d[0], AXISCOMP_TEXT("Error", "number of the motor whose position counts, 1 to 32")),
    targetMotor};
constexpr std::array<std::string_view, 6> rules1d{
    "DEFINE COMP entries,#source[D],#target,span, then the entries, whole numbers of 1/16 count, "
    "with blanks or line ends between.",
    "Entry i is for position i * span / entries in counts of the source motor, from its zero; the "
    "correction at zero is 0 and has no entry.",
    "Outside of 0 to span the position rolls over: the last entry is also that of position zero "
    "and should be 0.",
    unnamedMotors,
    desiredPosition,
    "Between the entries the correction is linear.",
};

constexpr std::array<std::string_view, 2> motors2d{"row-motor", "column-motor"};
constexpr std::array<std::string_view, 2> counts2d{
    "source-counts-per-unit", "column-counts-per-unit"};
constexpr std::array settings2d{
    countsForWriting("source-counts-per-unit, column-counts-per-unit, target-counts-per-unit"),
    countsForReading, usesActual,
    countsSetting(
        counts2d[0], AXISCOMP_TEXT("Error", "encoder counts for one unit of the row motor")),
    countsSetting(
        counts2d[1], AXISCOMP_TEXT("Error", "encoder counts for one unit of the column motor")),
    targetCounts,
    motorSetting(
        motors2d[0], AXISCOMP_TEXT("Error", "number of the motor along a row of entries, 1 to 32")),
    motorSetting(
        motors2d[1], AXISCOMP_TEXT("Error", "number of the motor from row to row, 1 to 32")),
    targetMotor};
constexpr std::array<std::string_view, 6> rules2d{
    "DEFINE COMP rows.columns,#row[D],#column[D],#target,span,span, then (rows + 1) * (columns + "
    "1) - 1 entries, whole numbers of 1/16 count.",
    "Along a row of entries the row motor moves by span / columns, from row to row the column "
    "motor by its span / rows; the entry for zero of both is left out and is 0.",
    "Outside of 0 to span the position of each source rolls over, so entries at both ends should "
    "be the same.",
    unnamedMotors,
    desiredPosition,
    "Between the entries the correction is bilinear.",
};

/// By the number of sources, from 1.
constexpr std::array words{
    Words{"pmac-1d", AXISCOMP_TEXT("Error", "leadscrew compensation of one source (DEFINE COMP)"),
        {motors1d, counts1d}, settings1d, rules1d},
    Words{"pmac-2d", AXISCOMP_TEXT("Error", "compensation of a motor by two others (DEFINE COMP)"),
        {motors2d, counts2d}, settings2d, rules2d}};

constexpr std::array<std::string_view, 1> extensions{".pmc"};

template <std::size_t sources> const TableFormat& formatOf();

template <std::size_t sources> std::vector<NeutralTable> parse(TextReading& reading)
{
    return readTables(reading, sources);
}

template <std::size_t sources>
Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    const FormatFacts& facts = formatOf<sources>().facts;
    AXISCOMP_CHECK(checkCounts(facts, options.settings));
    return readText(facts, text, options, parse<sources>);
}

template <std::size_t sources> Recognition recognise(std::string_view text)
{
    return recogniseFile(text, sources);
}

template <std::size_t sources>
Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    return writeTable(
        formatOf<sources>(), words[sources - 1].keys, tables.front(), options.settings);
}

template <std::size_t sources> const TableFormat& formatOf()
{
    static const TableFormat format{.facts = {.name = words[sources - 1].name,
                                        .controller = "PMAC (Delta Tau, Omron)",
                                        .description = words[sources - 1].description,
                                        .extensions = extensions,
                                        .fewestDimensions = sources,
                                        .mostDimensions = sources,
                                        .knots = KnotRule::Even,
                                        .addsTables = true,
                                        .holdsNotes = true,
                                        .holdsWrap = true,
                                        .numbers = "whole numbers of 1/16 count",
                                        .sign = SignConvention::Command,
                                        .signEvidence = Evidence::Assumed,
                                        .behaviour = {.outside = Outside::Wrap},
                                        .outsideEvidence = Evidence::Published,
                                        .settings = words[sources - 1].settings,
                                        .rules = words[sources - 1].rules,
                                        .assumptions = assumptions},
        .recognise = recognise<sources>,
        .read = read<sources>,
        .write = write<sources>};
    return format;
}

} // namespace

} // namespace axiscomp::pmac

namespace axiscomp {

const TableFormat& pmac_1d::format()
{
    return pmac::formatOf<1>();
}

const TableFormat& pmac_2d::format()
{
    return pmac::formatOf<2>();
}

} // namespace axiscomp
