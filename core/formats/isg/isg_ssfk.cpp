// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"
#include "core/formats/isg/isg_list.h"
#include "core/text/number_text.h"

namespace axiscomp::isg_ssfk {

namespace {

constexpr std::size_t mostPoints = 1500;

constexpr std::string_view keys[] = {"unit", "interval", "kw_startpos", "kw_nr_max", "bilateral",
    "modulo", "n_cycles", "max_points"};
constexpr std::string_view fields[] = {"setpoint", "pos", "neg"};
constexpr isg::Section section{"ssfk", 1, keys, fields};

constexpr std::array<std::string_view, 1> extensions{".lis"};
constexpr std::array settings{isg::listUnit, isg::incrementsPerUnit, isg::decimals,
    isg::axisSetting,
    isg::kindSetting(
        "axis-kind", AXISCOMP_TEXT("Error", "whether the axis is linear (mm) or rotary (deg)"))};

constexpr std::array<std::string_view, 8> rules{
    "Lines are a name, a blank and a value; # begins a comment line; behind a number anything "
    "after a blank is comment, behind a text what follows '('. A final End is accepted.",
    "A value is the measured position less the commanded one, by which the commanded position is "
    "corrected: +e.",
    "unit 0: encoder increments; unit 1: 0.1 um or 0.0001 deg.",
    "There are kw_nr_max points, at most max_points, 1500 without that entry.",
    "interval above 0: the points lie at kw_startpos + i * interval; interval 0: each point has a "
    "setpoint of its own, ascending.",
    "bilateral 1: pos holds for motion in positive, neg in negative direction.",
    "modulo 1: the values at both ends must be the same.",
    "Between the points the correction is linear; outside, that at the nearest end is held. Newer "
    "kernels take decimals: they are read, and written with the setting decimals.",
};
constexpr std::array<std::string_view, 4> assumptions{
    "bilateral 0: pos holds for both directions, and neg is left out.",
    "A list without the entries unit, bilateral or modulo has 0 there.",
    "The list does not say whether the axis is linear or rotary: linear, unless a setting says "
    "otherwise.",
    "The period of a modulo axis is from its first to its last point.",
};

/// The positions in numbers of the file.
std::optional<isg::Field> positions(const isg::List& list, std::size_t count)
{
    const auto interval = list.number("interval");
    if (!interval)
        return std::nullopt;
    if (*interval == 0.0)
        return list.field("setpoint", {1, count});
    if (*interval < 0.0) {
        list.diagnostics().error(DiagnosticCode::LimitExceeded, list.line("interval"), 0,
            Verbatim{list.path("interval") + ' ' + toText(*interval)},
            AXISCOMP_TEXT("Error", "0, or a distance above 0"));
        return std::nullopt;
    }
    if (list.hasField("setpoint"))
        list.diagnostics().error(DiagnosticCode::Contradiction, list.line("interval"), 0,
            AXISCOMP_TEXT("Error", "{entry} and setpoints of each point")
                .with("entry", list.path("interval") + ' ' + toText(*interval)),
            AXISCOMP_TEXT("Error", "an interval of 0 with setpoints, or an interval without"));
    const auto start = list.number("kw_startpos");
    if (!start)
        return std::nullopt;
    return isg::Field{evenKnots(*start, *interval, count), {list.line("interval")}};
}

void addColumn(NeutralTable& table, const isg::Field& field, const isg::Scale& scale,
    Direction direction, const std::string& axis)
{
    CompensationColumn& column = table.columns.emplace_back();
    column.target = axis;
    column.unit = table.axes.front().unit;
    column.direction = direction;
    column.values = isg::scaled(scale, field.numbers);
}

std::optional<NeutralTable> build(const isg::List& list, const SettingValues& settingValues)
{
    const auto scale = isg::scaleOf(list, settingValues);
    const auto size = list.whole("kw_nr_max", 2, 2147483647);
    const auto isBilateral = list.flag("bilateral", false);
    const auto isModulo =
        list.has("modulo") ? list.flag("modulo", false) : std::optional<bool>(false);
    if (!scale || !size || !isBilateral || !isModulo)
        return std::nullopt;
    const auto count = static_cast<std::size_t>(*size);
    if (!list.checkMostPoints(count, mostPoints))
        return std::nullopt;
    const auto positive = list.field("pos", {1, count});
    const auto negative =
        *isBilateral && positive ? list.field("neg", {1, count}) : std::optional<isg::Field>();
    if (!positive || (*isBilateral && !negative))
        return std::nullopt;
    if (!*isBilateral && list.hasField("neg"))
        list.diagnostics().warning(DiagnosticCode::Assumption, list.line("bilateral"), 0,
            AXISCOMP_TEXT("Error", "values neg without bilateral 1"),
            AXISCOMP_TEXT("Error", "values pos only; neg is left out"));
    const auto knots = positions(list, count);
    if (!knots)
        return std::nullopt;
    NeutralTable table;
    table.sign = SignConvention::Feedback;
    SourceAxis& axis = table.axes.emplace_back();
    axis.name = list.axisNumber();
    axis.unit = scale->unit(settingValues, "axis-kind", list);
    axis.knots = isg::scaled(*scale, knots->numbers);
    axis.step = scale->numbers.stepOf(knots->numbers);
    if (!checkKnots(axis.knots, knots->lines, {}, list.diagnostics()))
        return std::nullopt;
    addColumn(
        table, *positive, *scale, *isBilateral ? Direction::Positive : Direction::Both, axis.name);
    if (negative)
        addColumn(table, *negative, *scale, Direction::Negative, axis.name);
    if (*isModulo) {
        table.axes[0].wrap = table.axes[0].knots.back() - table.axes[0].knots.front();
        if (!isClosed(table, 0))
            list.diagnostics().error(DiagnosticCode::NotPeriodic, positive->lines.back(), 0,
                AXISCOMP_TEXT("Error", "different values at both ends"),
                AXISCOMP_TEXT("Error", "the same values, since modulo is 1"));
    }
    return table;
}

std::vector<NeutralTable> parse(TextReading& reading)
{
    return isg::readSection(reading, section, build);
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    return readText(isg_ssfk::format().facts, text, options, parse);
}

Recognition recognise(std::string_view text)
{
    return isg::recogniseList(section, text);
}

/// The numbers of one direction; a modulo axis stays closed when they are rounded.
Result<std::vector<double>> valuesOf(const isg::Draft& draft, const CompensationColumn& column)
{
    auto values = isg::inFile(isg_ssfk::format().facts, draft, column.values, isg::Numbers::Values);
    if (values && draft.table.axes[0].wrap)
        values->back() = values->front();
    return values;
}

/// The head and the positions: an interval where they are even in the file, otherwise setpoints.
Result<void> addPositions(isg::Draft& draft)
{
    const FormatFacts& facts = isg_ssfk::format().facts;
    const SourceAxis& axis = draft.table.axes[0];
    AXISCOMP_TRY(const auto knots, isg::inFile(facts, draft, axis.knots, isg::Numbers::Positions));
    for (std::size_t i = 1; i < knots.size(); ++i)
        if (knots[i] <= knots[i - 1])
            return isg::roundedTogether(facts, axis.knots[i]);
    std::vector<double> exact = axis.knots;
    for (double& knot : exact)
        knot *= draft.scale.numbers.perUnit;
    const double distance = knots[1] - knots[0];
    const bool hasInterval = isg::isEvenInFile(knots[0], distance, exact);
    draft.add("interval", hasInterval ? draft.numberText(distance) : "0");
    draft.add("kw_startpos", draft.numberText(knots[0]));
    draft.add("kw_nr_max", knots.size());
    for (std::size_t i = 0; !hasInterval && i < knots.size(); ++i)
        draft.addPoint('[' + std::to_string(i) + ']', "setpoint", knots[i]);
    return {};
}

Result<void> addTable(isg::Draft& draft, const DirectionPair& pair)
{
    const auto positive = valuesOf(draft, *pair.positive);
    const auto negative = pair.negative ? valuesOf(draft, *pair.negative) : positive;
    if (!positive || !negative)
        return fail(positive ? negative.error() : positive.error());
    draft.add("bilateral", std::size_t{pair.negative ? 1U : 0U});
    draft.add("modulo", std::size_t{draft.table.axes[0].wrap ? 1U : 0U});
    if (auto added = addPositions(draft); !added)
        return added;
    for (std::size_t i = 0; i < positive->size(); ++i) {
        const std::string index = '[' + std::to_string(i) + ']';
        draft.addPoint(index, "pos", (*positive)[i]);
        if (pair.negative)
            draft.addPoint(index, "neg", (*negative)[i]);
    }
    return {};
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    const FormatFacts& facts = isg_ssfk::format().facts;
    AXISCOMP_TRY(const auto given, SettingValues::of(facts, options.settings, true));
    const NeutralTable& source = tables.front();
    AXISCOMP_CHECK(checkOwnAxis(facts, source,
        AXISCOMP_TEXT("Error", "write it as {format}")
            .with("format", isg_crosscomp::format().facts.name)));
    AXISCOMP_TRY(const auto axis, axisNumber(facts, given, "axis", source.axes[0].name));
    std::vector<Text> remarks;
    AXISCOMP_TRY(auto draft, isg::beginDraft(section, source, given, axis, remarks));
    AXISCOMP_TRY(const auto pair, directionPair(facts, draft.table));
    if (draft.table.axes[0].wrap)
        AXISCOMP_CHECK(checkOnePeriod(facts, draft.table, 0, 0.5 / draft.scale.numbers.perUnit));
    AXISCOMP_CHECK(addTable(draft, pair));
    remarks.push_back(isg::activation(section, axis));
    const std::string kind = isg::kindOf(draft.table.axes[0].unit);
    return isg::finish(
        isg_ssfk::format(), std::move(draft), given, {{"axis-kind", kind}}, std::move(remarks));
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "isg-ssfk",
            .controller = "ISG kernel, TwinCAT CNC",
            .description = AXISCOMP_TEXT(
                "Error", "leadscrew error compensation in a compensation list (kw.ssfk)"),
            .extensions = extensions,
            .knots = KnotRule::Any,
            .mostPoints = mostPoints,
            .holdsUnits = true,
            .holdsNotes = true,
            .holdsDirections = true,
            .holdsWrap = true,
            .numbers = "whole numbers of 0.1 um, 0.0001 deg or one increment",
            .sign = SignConvention::Feedback,
            .signEvidence = Evidence::Published,
            .behaviour = {.outside = Outside::Hold},
            .outsideEvidence = Evidence::Published,
            .settings = settings,
            .rules = rules,
            .assumptions = assumptions},
        .recognise = recognise,
        .read = read,
        .write = write};
    return format;
}

} // namespace axiscomp::isg_ssfk
