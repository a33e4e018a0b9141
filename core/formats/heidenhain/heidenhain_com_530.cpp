// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/heidenhain/heidenhain_file.h"

namespace axiscomp::heidenhain_com_530 {

namespace {

constexpr auto layout = heidenhain::Layout::EvenPositions;

constexpr std::array<std::string_view, 2> extensions{".com", ".v"};
constexpr std::array settings{heidenhain::movingAxis, heidenhain::compensatedAxis,
    FormatSetting{.key = "any-distance",
        .kind = FormatSetting::Kind::YesNo,
        .meaning = AXISCOMP_TEXT(
            "Error", "also distances that are no power of two times 0.0001, for an iTNC 530"),
        .standard = "no",
        .forWriting = true}};

constexpr std::array<std::string_view, 8> rules{
    "BEGIN AXIS-Y.COM DATUM:-90.0000 DISTANCE:+6.5536, then headers NR and a letter for each axis "
    "(20 and 11 characters wide), a line for each position with signs and four decimals. [END] may "
    "be missing, which is a warning here, since the file could be cut off.",
    "Line NR is the position DATUM + NR * DISTANCE, which it also says; others are refused.",
    "DISTANCE is a power of two times 0.0001 mm, and values of neighbouring lines differ by at "
    "most DISTANCE / 64 (TNC 407).",
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
    "Positions and values are in mm.",
    "The rule of the iTNC 530 for DISTANCE was not found, and the public writer for it does not "
    "keep that of the TNC 407: any-distance=yes writes other distances.",
};

std::vector<NeutralTable> parse(TextReading& reading)
{
    return heidenhain::parseFile(reading, layout);
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    return readText(heidenhain_com_530::format().facts, text, options, parse);
}

Recognition recognise(std::string_view text)
{
    return heidenhain::recogniseFile(text, layout);
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    return heidenhain::writeFile(
        heidenhain_com_530::format(), layout, tables.front(), options.settings);
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{.facts = {.name = "heidenhain-com-530",
                                        .controller = "Heidenhain iTNC 530, TNC 4xx",
                                        .description = AXISCOMP_TEXT("Error",
                                            "compensation-value table (.COM) with even positions"),
                                        .extensions = extensions,
                                        .knots = KnotRule::Even,
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

} // namespace axiscomp::heidenhain_com_530
