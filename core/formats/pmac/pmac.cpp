// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"
#include "core/formats/pmac/pmac_file.h"

namespace axiscomp::pmac_2d {

namespace {

constexpr std::string_view motors[] = {"row-motor", "column-motor"};
constexpr std::string_view counts[] = {"source-counts-per-unit", "column-counts-per-unit"};
constexpr std::array<std::string_view, 1> extensions{".pmc"};
constexpr std::array settings{pmac::countsForWriting, pmac::countsForReading, pmac::usesActual,
    pmac::countsSetting("source-counts-per-unit", "encoder counts for one unit of the row motor"),
    pmac::countsSetting(
        "column-counts-per-unit", "encoder counts for one unit of the column motor"),
    pmac::countsSetting("target-counts-per-unit", "encoder counts for one unit of the values"),
    pmac::motorSetting("row-motor", "number of the motor along a row of entries, 1 to 32"),
    pmac::motorSetting("column-motor", "number of the motor from row to row, 1 to 32"),
    pmac::motorSetting("target-motor", "number of the motor that is compensated, 1 to 32")};

constexpr std::array<std::string_view, 6> rules{
    "DEFINE COMP rows.columns,#row[D],#column[D],#target,span,span, then (rows + 1) * (columns + "
    "1) - 1 entries, whole numbers of 1/16 count.",
    "Along a row of entries the row motor moves by span / columns, from row to row the column "
    "motor by its span / rows; the entry for zero of both is left out and is 0.",
    "Outside of 0 to span the position of each source rolls over, so entries at both ends should "
    "be the same.",
    "Motors that are not named are the one that is addressed, #1 in front.",
    "D: the desired position of the source counts, otherwise the actual one.",
    "Between the entries the correction is bilinear.",
};

std::vector<NeutralTable> parse(TextReading& reading)
{
    return pmac::readTables(reading, 2);
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    const FamilyFacts& facts = pmac_2d::format().facts;
    if (auto fits = pmac::checkCounts(facts, options.settings); !fits)
        return fail(fits.error());
    return readText(facts, text, options, parse);
}

Recognition recognise(std::string_view text)
{
    return pmac::recogniseFile(text, 2);
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    return pmac::writeTable(pmac_2d::format(), {motors, counts}, tables.front(), options.settings);
}

} // namespace

const TableFamily& format()
{
    static const TableFamily family{
        .facts = {.name = "pmac-2d",
            .controller = "PMAC (Delta Tau, Omron)",
            .description = "compensation of a motor by two others (DEFINE COMP)",
            .extensions = extensions,
            .fewestDimensions = 2,
            .mostDimensions = 2,
            .knots = KnotRule::Even,
            .holdsNotes = true,
            .holdsWrap = true,
            .numbers = "whole numbers of 1/16 count",
            .sign = SignConvention::Command,
            .signEvidence = Evidence::Assumed,
            .behaviour = {.outside = Outside::Hold},
            .outsideEvidence = Evidence::Published,
            .settings = settings,
            .rules = rules,
            .assumptions = pmac::assumptions},
        .recognise = recognise,
        .read = read,
        .write = write};
    return family;
}

} // namespace axiscomp::pmac_2d
