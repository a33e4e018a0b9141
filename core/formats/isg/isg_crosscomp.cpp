// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"
#include "core/formats/isg/isg_list.h"
#include "core/text/number_text.h"

#include <algorithm>

namespace axiscomp::isg_crosscomp {

namespace {

constexpr std::size_t mostPoints = 1001;
constexpr std::size_t pointsOfOlderKernels = 1000;

constexpr std::string_view keys[] = {
    "unit", "last_index", "master_ax_nr", "n_cycles", "max_points"};
constexpr std::string_view fields[] = {"setpoint", "correction"};
constexpr isg::Section section{"crosscomp", 1, keys, fields};

constexpr std::array<std::string_view, 1> extensions{".lis"};
constexpr std::array settings{isg::listUnit, isg::incrementsPerUnit, isg::decimals,
    isg::axisSetting,
    FormatSetting{.key = "master-axis",
        .kind = FormatSetting::Kind::WholeNumber,
        .meaning = AXISCOMP_TEXT(
            "Error", "logical number of the axis whose position counts, for master_ax_nr"),
        .forWriting = true},
    FormatSetting{.key = "n-cycles",
        .kind = FormatSetting::Kind::WholeNumber,
        .meaning = AXISCOMP_TEXT("Error", "cycles over which switching is smoothed, for n_cycles"),
        .forWriting = true},
    isg::kindSetting("master-kind",
        AXISCOMP_TEXT("Error", "whether the master axis is linear (mm) or rotary (deg)")),
    isg::kindSetting("axis-kind",
        AXISCOMP_TEXT("Error", "whether the compensated axis is linear (mm) or rotary (deg)")),
    FormatSetting{.key = "modulo",
        .kind = FormatSetting::Kind::YesNo,
        .meaning = AXISCOMP_TEXT(
            "Error", "the master is a modulo axis: the first and the last point are one place"),
        .standard = "no",
        .forReading = true}};

constexpr std::array<std::string_view, 8> rules{
    "Lines are a name, a blank and a value; # begins a comment line; behind a number anything "
    "after a blank is comment, behind a text what follows '('. A final End is accepted.",
    "The list is that of the compensated (slave) axis, kopf.achs_nr; master_ax_nr is the axis "
    "whose commanded position counts.",
    "unit 0: encoder increments; unit 1: 0.1 um or 0.0001 deg.",
    "There are last_index + 1 points, fewer than or as many as max_points, 1001 without that "
    "entry; older kernels take 1000.",
    "Setpoints ascend, otherwise the kernel reports error 70245; points that are left out count "
    "as 0 and cause the same error.",
    "Between the points the correction is linear.",
    "When the master is a modulo axis, the values at both ends must be the same.",
    "Newer kernels take decimals: they are read, and written with the setting decimals.",
};
constexpr std::array<std::string_view, 4> assumptions{
    "Outside the points the correction at the nearest end is held.",
    "The correction is added to the commanded position; the documentation gives no sign.",
    "A list without the entry unit is in increments.",
    "The list does not say whether an axis is linear or rotary: linear, unless a setting says "
    "otherwise. Increments are those of one encoder resolution for all axes.",
};

std::optional<NeutralTable> build(const isg::List& list, const SettingValues& settingValues)
{
    const auto scale = isg::scaleOf(list, settingValues);
    const auto last = list.whole("last_index", 1, 2147483646);
    const auto master = list.whole("master_ax_nr", 1, 65535);
    if (!scale || !last || !master)
        return std::nullopt;
    const std::size_t count = static_cast<std::size_t>(*last) + 1;
    if (!list.checkMostPoints(count, mostPoints))
        return std::nullopt;
    const auto setpoints = list.field("setpoint", {1, count});
    const auto corrections = list.field("correction", {1, count});
    if (!setpoints || !corrections)
        return std::nullopt;
    for (std::size_t i = 1; i < count; ++i)
        if (!(setpoints->numbers[i] > setpoints->numbers[i - 1]))
            list.diagnostics().error({.severity = Severity::Error,
                .code = DiagnosticCode::NotMonotonic,
                .line = setpoints->lines[i],
                .column = 0,
                .found = AXISCOMP_TEXT("Error", "{number} after {number2}")
                             .with("number", Quantity{toText(setpoints->numbers[i])})
                             .with("number2", Quantity{toText(setpoints->numbers[i - 1])}),
                .expected = AXISCOMP_TEXT("Error", "ascending setpoints"),
                .controllerError = "70245"});
    if (list.diagnostics().hasErrors())
        return std::nullopt;
    if (count > pointsOfOlderKernels)
        list.diagnostics().warning(DiagnosticCode::LimitExceeded, list.line("last_index"), 0,
            AXISCOMP_COUNTED("Error", "{count} points", "1 point").with("count", count),
            AXISCOMP_TEXT("Error", "at most {most} for older kernels")
                .with("most", pointsOfOlderKernels));
    NeutralTable table;
    table.sign = SignConvention::Command;
    SourceAxis& axis = table.axes.emplace_back();
    axis.name = std::to_string(*master);
    axis.unit = scale->unit(settingValues, "master-kind", list);
    axis.knots = isg::scaled(*scale, setpoints->numbers);
    axis.step = scale->numbers.stepOf(setpoints->numbers);
    if (!checkKnots(axis.knots, setpoints->lines, {}, list.diagnostics()))
        return std::nullopt;
    CompensationColumn& column = table.columns.emplace_back();
    column.target = list.axisNumber();
    column.unit = scale->unit(settingValues, "axis-kind", list);
    column.values = isg::scaled(*scale, corrections->numbers);
    if (settingValues.yes("modulo")) {
        axis.wrap = axis.knots.back() - axis.knots.front();
        if (!isClosed(table, 0))
            list.diagnostics().error(DiagnosticCode::NotPeriodic, corrections->lines.back(), 0,
                AXISCOMP_TEXT("Error", "{number} at the end")
                    .with("number", Quantity{toText(corrections->numbers.back())}),
                AXISCOMP_TEXT("Error", "{number}, as at the beginning")
                    .with("number", Quantity{toText(corrections->numbers.front())}));
    }
    return table;
}

std::vector<NeutralTable> parse(TextReading& reading)
{
    return isg::readSection(reading, section, build);
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    return readText(isg_crosscomp::format().facts, text, options, parse);
}

Recognition recognise(std::string_view text)
{
    return isg::recogniseList(section, text);
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    const FormatFacts& facts = isg_crosscomp::format().facts;
    AXISCOMP_TRY(const auto given, SettingValues::of(facts, options.settings, true));
    const NeutralTable& source = tables.front();
    const auto axis = axisNumber(facts, given, "axis", targetName(source, source.columns.front()));
    const auto master = axisNumber(facts, given, "master-axis", source.axes.front().name);
    if (!axis || !master)
        return fail(axis ? master.error() : axis.error());
    std::vector<Text> remarks;
    AXISCOMP_TRY(auto draft, isg::beginDraft(section, source, given, *axis, remarks));
    const NeutralTable& table = draft.table;
    const auto knots = isg::inFile(facts, draft, table.axes[0].knots, isg::Numbers::Positions);
    auto values = isg::inFile(facts, draft, table.columns[0].values, isg::Numbers::Values);
    if (!knots || !values)
        return fail(knots ? values.error() : knots.error());
    for (std::size_t i = 1; i < knots->size(); ++i)
        if ((*knots)[i] <= (*knots)[i - 1])
            return isg::roundedTogether(facts, table.axes[0].knots[i]);
    if (table.axes[0].wrap) {
        AXISCOMP_CHECK(checkOnePeriod(facts, table, 0, 0.5 / draft.scale.numbers.perUnit));
        values->back() = values->front(); // also when they are rounded apart
    }
    draft.add("last_index", knots->size() - 1);
    draft.add("master_ax_nr", static_cast<std::size_t>(*master));
    for (std::size_t i = 0; i < knots->size(); ++i) {
        const std::string index = '[' + std::to_string(i) + ']';
        draft.addPoint(index, "setpoint", (*knots)[i]);
        draft.addPoint(index, "correction", (*values)[i]);
    }
    if (knots->size() > pointsOfOlderKernels)
        remarks.push_back(AXISCOMP_TEXT(
            "Error", "the table has {count} points; older kernels take at most {most}")
                              .with("count", knots->size())
                              .with("most", pointsOfOlderKernels));
    remarks.push_back(isg::activation(section, *axis));
    FormatSettings reading{{"master-kind", isg::kindOf(table.axes[0].unit)},
        {"axis-kind", isg::kindOf(table.columns[0].unit)}};
    if (table.axes[0].wrap)
        reading["modulo"] = "yes";
    return isg::finish(
        isg_crosscomp::format(), std::move(draft), given, std::move(reading), std::move(remarks));
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "isg-crosscomp",
            .controller = "ISG kernel, TwinCAT CNC",
            .description =
                AXISCOMP_TEXT("Error", "cross compensation in a compensation list (kw.crosscomp)"),
            .extensions = extensions,
            .knots = KnotRule::Any,
            .mostPoints = mostPoints,
            .holdsUnits = true,
            .holdsNotes = true,
            .holdsWrap = true,
            .numbers = "whole numbers of 0.1 um, 0.0001 deg or one increment",
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

} // namespace axiscomp::isg_crosscomp
