// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/isg/isg_list.h"

#include "core/formats/units.h"
#include "core/text/number_text.h"
#include "core/text/text_file.h"

#include <algorithm>
#include <cmath>

namespace axiscomp::isg {

namespace {

constexpr double perMetricUnit = 10000.0; // 0.1 um for 1 mm, 0.0001 deg for 1 deg
constexpr std::string_view increments = "increments";

Error wrongSetting(Text reason)
{
    return Error{ErrorCode::InvalidArgument, {{"reason", std::move(reason)}}, {}};
}

bool isInIncrements(const NeutralTable& table)
{
    return std::ranges::all_of(
               table.axes, [](const SourceAxis& axis) { return axis.unit == increments; })
        && std::ranges::all_of(table.columns,
            [](const CompensationColumn& column) { return column.unit == increments; });
}

} // namespace

std::string kindOf(const std::string& unit)
{
    return unit == "deg" ? "rotary" : "linear";
}

std::string Scale::unit(
    const SettingValues& settings, std::string_view kindKey, const List& list) const
{
    if (!isMetric && !isConverted)
        return std::string(increments);
    if (!settings.has(kindKey))
        list.diagnostics().warning(DiagnosticCode::Assumption, list.line("unit"), 0,
            isMetric ? AXISCOMP_TEXT("Error", "numbers of 0.1 um or 0.0001 deg")
                     : AXISCOMP_TEXT("Error", "increments for one mm or degree"),
            AXISCOMP_TEXT(
                "Error", "the setting {key}, linear or rotary; linear is assumed, so that it is mm")
                .with("key", kindKey));
    return settings.text(kindKey) == "rotary" ? "deg" : "mm";
}

std::optional<Scale> scaleOf(const List& list, const SettingValues& settings)
{
    const auto isMetric = list.flag("unit", false);
    if (!isMetric)
        return std::nullopt;
    Scale scale;
    scale.isMetric = *isMetric;
    scale.isConverted = settings.has("increments-per-unit");
    scale.numbers.perUnit = perMetricUnit;
    if (*isMetric)
        return scale;
    scale.numbers.perUnit = scale.isConverted ? settings.number("increments-per-unit") : 1.0;
    if (!scale.isConverted)
        list.diagnostics().warning(DiagnosticCode::UnitNotGiven, list.line("unit"), 0,
            AXISCOMP_TEXT("Error", "numbers in encoder increments"),
            AXISCOMP_TEXT(
                "Error", "the setting increments-per-unit, where millimetres or degrees matter"));
    if (scale.numbers.perUnit > 0.0)
        return scale;
    list.diagnostics().error(DiagnosticCode::LimitExceeded, 0, 0,
        Verbatim{"increments-per-unit " + toText(scale.numbers.perUnit)},
        AXISCOMP_TEXT("Error", "a number above 0"));
    return std::nullopt;
}

Result<Scale> scaleForWriting(const SettingValues& settings)
{
    Scale scale;
    scale.isMetric = settings.text("list-unit") == "metric";
    scale.isConverted = settings.has("increments-per-unit");
    scale.numbers.perUnit = perMetricUnit;
    if (!scale.isMetric)
        scale.numbers.perUnit = scale.isConverted ? settings.number("increments-per-unit") : 1.0;
    scale.numbers.hasDecimals = settings.yes("decimals");
    if (!(scale.numbers.perUnit > 0.0))
        return fail(
            wrongSetting(AXISCOMP_TEXT("Error", "the setting increments-per-unit is not above 0")));
    return scale;
}

std::vector<double> scaled(const Scale& scale, const std::vector<double>& numbers)
{
    std::vector<double> inUnits(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i)
        inUnits[i] = scale.numbers.fromFile(numbers[i]);
    return inUnits;
}

void Draft::add(std::string_view key, std::string_view value)
{
    text.append(section).append(key).append(" ").append(value).append("\n");
}

void Draft::addPoint(std::string_view index, std::string_view field, double inFile)
{
    text.append(section).append("table").append(index).append(".").append(field).append(" ");
    text.append(numberText(inFile)).append("\n");
}

std::string Draft::numberText(double inFile) const
{
    return plainNumber(inFile);
}

namespace {

/// "n_cycles 5" among the notes: an entry of the list that the table itself has no place for.
std::string entryAmong(const std::vector<std::string>& notes, std::string_view key)
{
    for (const std::string& note : notes)
        if (note.starts_with(key) && note.size() > key.size() + 1 && note[key.size()] == ' ')
            if (const std::string value = note.substr(key.size() + 1); wholeNumberOf(value))
                return value;
    return {};
}

/// Of the table that was read: it has more points since.
bool isOutgrown(std::string_view key, std::string_view value, const NeutralTable& table)
{
    const auto most = wholeNumberOf(value);
    return key == "max_points" && most && *most < static_cast<std::int64_t>(table.pointCount());
}

void addKeptEntries(Draft& draft, const SettingValues& settings, std::vector<Text>& remarks)
{
    for (const std::string_view key : keptKeys) {
        const bool isSet = key == "n_cycles" && settings.has("n-cycles");
        const std::string value =
            isSet ? settings.text("n-cycles") : entryAmong(draft.table.notes, key);
        if (isOutgrown(key, value, draft.table))
            remarks.push_back(AXISCOMP_TEXT("Error",
                "max_points {number} of the source is left out: the table has {count} points")
                                  .with("number", value)
                                  .with("count", draft.table.pointCount()));
        else if (!value.empty())
            draft.add(key, value);
        std::erase_if(draft.table.notes,
            [&](const std::string& note) { return note.starts_with(std::string(key) + ' '); });
    }
}

} // namespace

Result<Draft> beginDraft(const Section& section, const NeutralTable& table,
    const SettingValues& settings, std::int64_t axis, std::vector<Text>& remarks)
{
    AXISCOMP_TRY(auto scale, scaleForWriting(settings));
    Draft draft{table, scale, {}, "kw." + std::string(section.name) + '.'};
    const bool needsUnits = scale.isMetric || scale.isConverted;
    if (!needsUnits && !isInIncrements(table))
        return fail(wrongSetting(AXISCOMP_TEXT("Error",
            "numbers in mm or degrees become increments only with the setting "
            "increments-per-unit")));
    if (needsUnits) {
        AXISCOMP_TRY(auto converted, inUnits(table, "mm", "deg", remarks));
        draft.table = std::move(converted);
    }
    std::string entries;
    addKeptEntries(draft, settings, remarks);
    std::swap(entries, draft.text);
    draft.text = noteLines(draft.table, "# ");
    draft.text += "kopf.achs_nr " + std::to_string(axis) + '\n';
    std::string name = draft.table.name;
    std::erase_if(name, [](char c) { return c == '(' || c == '\n' || c == '\r'; });
    if (!trimmed(name).empty())
        draft.text += "kopf.log_achs_name " + name + '\n';
    draft.add("unit", std::size_t{scale.isMetric ? 1U : 0U});
    draft.text += entries;
    return draft;
}

Result<std::vector<double>> inFile(
    const FormatFacts& facts, const Draft& draft, std::span<const double> numbers, Numbers what)
{
    std::vector<double> rounded(numbers.size());
    for (std::size_t i = 0; i < numbers.size(); ++i)
        rounded[i] = draft.scale.numbers.inFile(numbers[i]);
    if (const auto at = beyond32Bits(rounded)) {
        const Quantity number{roundedText(numbers[*at])};
        return cannotHold(facts,
            what == Numbers::Positions
                ? AXISCOMP_TEXT(
                    "Error", "the position {position} is beyond the 32 bits of its numbers")
                      .with("position", number)
                : AXISCOMP_TEXT("Error", "the value {value} is beyond the 32 bits of its numbers")
                      .with("value", number),
            AXISCOMP_TEXT("Error", "check the unit of the table"));
    }
    return rounded;
}

tl::unexpected<Error> roundedTogether(const FormatFacts& facts, double position)
{
    return cannotHold(facts,
        AXISCOMP_TEXT(
            "Error", "the position {position} is the same as the one before when it is rounded")
            .with("position", Quantity{roundedText(position)}),
        AXISCOMP_TEXT("Error", "resample it onto a coarser grid"));
}

Text activation(const Section& section, std::int64_t axis)
{
    return AXISCOMP_TEXT("Error", "activate it in the axis list of axis {axis}: {parameter} 1")
        .with("axis", axis)
        .with("parameter", "lr_param." + std::string(section.name));
}

Result<WrittenTables> finish(const TableFormat& format, Draft draft, const SettingValues& settings,
    FormatSettings readSettings, std::vector<Text> remarks)
{
    draft.text += "End\n";
    if (!draft.scale.isMetric && draft.scale.isConverted)
        readSettings["increments-per-unit"] = settings.text("increments-per-unit");
    AXISCOMP_TRY(auto held, readBack(format, draft.text, std::move(readSettings)));
    return WrittenTables{std::move(draft.text), std::move(held), std::move(remarks)};
}

bool isEvenInFile(double start, double distance, std::span<const double> exact)
{
    for (std::size_t i = 0; i < exact.size(); ++i) {
        const double even = start + static_cast<double>(i) * distance;
        if (!(std::abs(even - exact[i]) <= 0.5 + 1e-6))
            return false;
    }
    return distance > 0.0;
}

} // namespace axiscomp::isg
