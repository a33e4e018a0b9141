// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"
#include "core/formats/softmc/softmc_targets.h"
#include "core/formats/units.h"
#include "core/text/number_text.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>

namespace axiscomp::softmc_basic {

namespace {

constexpr std::array<std::string_view, 2> extensions{".prg", ".lib"};
constexpr std::array settings{
    FormatSetting{.key = "name",
        .kind = FormatSetting::Kind::Text,
        .meaning = AXISCOMP_TEXT("Error", "name of the compensation table in the MC-BASIC program"),
        .standard = "Comp1",
        .forWriting = true},
};
constexpr std::array<std::string_view, 6> rules{
    "Assignments NAME.SourceData[axis][point] = position and NAME.TargetData[axis][point] = "
    "correction; both indices begin at 1.",
    "The axis of TargetData is the number of a target axis in the table.",
    "TargetData is added to the position command of the axis; between two SourceData points it is "
    "interpolated.",
    "Positions are in source user units, corrections in target user units.",
    "The table must not be in use (CompActive = 0) while TargetData is written.",
    "The compensation takes effect once every source has reached its first value.",
};
constexpr std::array<std::string_view, 3> assumptions{
    "The point is the number of the row in the text table, the first source fastest: every point "
    "has a position of each source.",
    "Above the last value the last correction is held.",
    "The fragment assigns to a table that the program has defined before, with as many sources and "
    "points. A name is letters, digits and _, beginning with a letter.",
};

bool isBasicName(std::string_view name)
{
    const auto isLetter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const auto isInner = [&](char c) { return isLetter(c) || (c >= '0' && c <= '9') || c == '_'; };
    return !name.empty() && isLetter(name.front()) && std::ranges::all_of(name, isInner);
}

std::string assignment(const std::string& array, std::size_t axis, std::size_t point, double value)
{
    return array + '[' + std::to_string(axis + 1) + "][" + std::to_string(point + 1)
        + "] = " + toText(value) + '\n';
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    AXISCOMP_TRY(
        const auto values, SettingValues::of(softmc_basic::format().facts, options.settings, true));
    const std::string name = values.text("name");
    if (!isBasicName(name))
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "the setting name is \"{name}\", expected letters, digits and _, beginning "
                    "with a letter")
                    .with("name", name)}});
    WrittenTables written;
    AXISCOMP_TRY(auto table, inSettingUnits(tables.front(), values, written.remarks));
    AXISCOMP_CHECK(checkOneUnit(softmc_basic::format().facts, unitContradiction(table)));
    std::string& text = written.bytes;
    const bool hasOneAxis = table.axes.size() == 1;
    text = "' Compensation table " + name + ": " + sizeText(knotCounts(table))
        + (hasOneAxis ? " points\n" : " points, the first source fastest\n");
    for (std::size_t point = 0; point < table.pointCount(); ++point) {
        std::size_t rest = point;
        for (std::size_t n = 0; n < table.axes.size(); ++n) {
            const std::vector<double>& knots = table.axes[n].knots;
            text += assignment(name + ".SourceData", n, point, knots[rest % knots.size()]);
            rest /= knots.size();
        }
        for (std::size_t n = 0; n < table.columns.size(); ++n)
            text += assignment(name + ".TargetData", n, point, table.columns[n].values[point]);
    }
    written.remarks.push_back((hasOneAxis
            ? AXISCOMP_TEXT("Error",
                "the table {name} must be defined in the program, with {count} points, and not be "
                "in use (CompActive = 0) while the lines run")
            : AXISCOMP_TEXT("Error",
                "the table {name} must be defined in the program, with {count} points, the first "
                "source fastest, and not be in use (CompActive = 0) while the lines run"))
                                  .with("name", name)
                                  .with("count", sizeText(knotCounts(table))));
    softmc::remarkTargets(table, written.remarks);
    written.held.push_back(std::move(table));
    return written;
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "softmc-basic",
            .controller = "softMC (Danaher, Servotronix, Kollmorgen)",
            .description =
                AXISCOMP_TEXT("Error", "MC-BASIC assignments to SourceData and TargetData"),
            .extensions = extensions,
            .mostDimensions = 3,
            .knots = KnotRule::Even,
            .mostPoints = 4'000'000,
            .mostColumns = 0,
            .numbers = "decimal text",
            .sign = SignConvention::Command,
            .signEvidence = Evidence::Published,
            .behaviour = {.outside = Outside::Hold, .startsAtFirst = true},
            .outsideEvidence = Evidence::Assumed,
            .settings = settings,
            .rules = rules,
            .assumptions = assumptions},
        .write = write};
    return format;
}

} // namespace axiscomp::softmc_basic
