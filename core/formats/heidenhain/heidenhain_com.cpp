// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/heidenhain/heidenhain_file.h"

namespace axiscomp::heidenhain_com {

namespace {

constexpr auto layout = heidenhain::Layout::Positions;

constexpr std::array<std::string_view, 2> extensions{".com", ".v"};
constexpr std::array settings{heidenhain::movingAxis, heidenhain::compensatedAxis};

constexpr std::array<std::string_view, 6> rules{
    "BEGIN AXIS_Y.COM MM, then headers NR, AXISPOS, BACKLASH and a letter for each axis (5 and 14 "
    "characters wide), a line for each position with signs and four decimals, [END].",
    heidenhain::endRule,
    heidenhain::columnRule,
    heidenhain::limitRule,
    heidenhain::curveRule,
    heidenhain::useRule,
};
constexpr std::array<std::string_view, 6> assumptions{
    heidenhain::signAssumption,
    heidenhain::outsideAssumption,
    heidenhain::rotaryAssumption,
    heidenhain::limitAssumption,
    "INCH in the first line is accepted and means inches; MM is what is written.",
    "BACKLASH holds what was measured in negative direction. Whether these are whole values or "
    "differences is not published: they are left out with a warning, and none are written.",
};

std::vector<NeutralTable> parse(TextReading& reading)
{
    return heidenhain::parseFile(reading, layout);
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    return readText(heidenhain_com::format().facts, text, options, parse);
}

Recognition recognise(std::string_view text)
{
    return heidenhain::recogniseFile(text, layout);
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    return heidenhain::writeFile(
        heidenhain_com::format(), layout, tables.front(), options.settings);
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "heidenhain-com",
            .controller = "Heidenhain TNC 640, MANUALplus 620",
            .description = AXISCOMP_TEXT(
                "Error", "compensation-value table (.COM) with the position in each line"),
            .extensions = extensions,
            .knots = KnotRule::Any,
            .mostPoints = heidenhain::mostRows,
            .mostColumns = heidenhain::axisLetters.size(),
            .holdsNames = true,
            .holdsUnits = true,
            .numbers = "decimal text with 4 decimals",
            .sign = SignConvention::Feedback,
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

} // namespace axiscomp::heidenhain_com
