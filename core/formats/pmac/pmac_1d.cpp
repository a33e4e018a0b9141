// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"
#include "core/formats/pmac/pmac_file.h"

namespace axiscomp::pmac_1d {

namespace {

constexpr std::string_view motors[] = {"source-motor"};
constexpr std::string_view counts[] = {"source-counts-per-unit"};
constexpr std::array<std::string_view, 1> extensions{".pmc"};
constexpr std::array settings{pmac::countsForWriting, pmac::countsForReading, pmac::usesActual,
    pmac::countsSetting("source-counts-per-unit", "encoder counts for one unit of the positions"),
    pmac::countsSetting("target-counts-per-unit", "encoder counts for one unit of the values"),
    pmac::motorSetting("source-motor", "number of the motor whose position counts, 1 to 32"),
    pmac::motorSetting("target-motor", "number of the motor that is compensated, 1 to 32")};

constexpr std::array<std::string_view, 6> rules{
    "DEFINE COMP entries,#source[D],#target,span, then the entries, whole numbers of 1/16 count, "
    "with blanks or line ends between.",
    "Entry i is for position i * span / entries in counts of the source motor, from its zero; the "
    "correction at zero is 0 and has no entry.",
    "Outside of 0 to span the position rolls over: the last entry is also that of position zero "
    "and should be 0.",
    "Motors that are not named are the one that is addressed, #1 in front.",
    "D: the desired position of the source counts, otherwise the actual one.",
    "Between the entries the correction is linear.",
};

std::vector<NeutralTable> parse(TextReading& reading)
{
    return pmac::readTables(reading, 1);
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    const FamilyFacts& facts = pmac_1d::format().facts;
    if (auto fits = pmac::checkCounts(facts, options.settings); !fits)
        return fail(fits.error());
    return readText(facts, text, options, parse);
}

Recognition recognise(std::string_view text)
{
    return pmac::recogniseFile(text, 1);
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    return pmac::writeTable(pmac_1d::format(), {motors, counts}, tables.front(), options.settings);
}

} // namespace

const TableFamily& format()
{
    static const TableFamily family{
        .facts = {.name = "pmac-1d",
            .controller = "PMAC (Delta Tau, Omron)",
            .description = "leadscrew compensation of one source (DEFINE COMP)",
            .extensions = extensions,
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

} // namespace axiscomp::pmac_1d
