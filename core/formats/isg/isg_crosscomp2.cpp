// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"
#include "core/formats/isg/isg_list.h"
#include "core/text/number_text.h"
#include "core/text/text_file.h"

namespace axiscomp::isg_crosscomp2 {

namespace {

constexpr std::size_t mostPoints = 10201;

constexpr std::string_view keys[] = {"unit", "grid", "interval", "interval1", "interval2",
    "last_index_master1", "last_index_master2", "start_position_master1", "start_position_master2",
    "master1_ax_nr", "master2_ax_nr", "n_cycles", "max_points"};
constexpr std::string_view fields[] = {"correction"};
constexpr isg::Section section{"crosscomp2", 2, keys, fields};

constexpr std::array<std::string_view, 1> extensions{".lis"};
constexpr FormatSetting masterSetting(std::string_view key, TextPattern meaning)
{
    return {.key = key,
        .kind = FormatSetting::Kind::WholeNumber,
        .meaning = meaning,
        .forWriting = true};
}
constexpr FormatSetting moduloSetting(std::string_view key, TextPattern meaning)
{
    return {.key = key,
        .kind = FormatSetting::Kind::YesNo,
        .meaning = meaning,
        .standard = "no",
        .forReading = true};
}
constexpr std::array<std::string_view, 2> masterKeys{"master1-axis", "master2-axis"};
constexpr std::array settings{isg::listUnit, isg::incrementsPerUnit, isg::decimals,
    isg::axisSetting,
    masterSetting(masterKeys[0],
        AXISCOMP_TEXT("Error", "logical number of master axis 1, for master1_ax_nr")),
    masterSetting(masterKeys[1],
        AXISCOMP_TEXT("Error", "logical number of master axis 2, for master2_ax_nr")),
    masterSetting("n-cycles",
        AXISCOMP_TEXT("Error", "cycles over which switching is smoothed, for n_cycles")),
    isg::kindSetting("master1-kind",
        AXISCOMP_TEXT("Error", "whether master axis 1 is linear (mm) or rotary (deg)")),
    isg::kindSetting("master2-kind",
        AXISCOMP_TEXT("Error", "whether master axis 2 is linear (mm) or rotary (deg)")),
    isg::kindSetting("axis-kind",
        AXISCOMP_TEXT("Error", "whether the compensated axis is linear (mm) or rotary (deg)")),
    moduloSetting("modulo1",
        AXISCOMP_TEXT("Error", "master axis 1 is a modulo axis: its ends are one place")),
    moduloSetting("modulo2",
        AXISCOMP_TEXT("Error", "master axis 2 is a modulo axis: its ends are one place"))};

constexpr std::array<std::string_view, 9> rules{
    "Lines are a name, a blank and a value; # begins a comment line; behind a number anything "
    "after a blank is comment, behind a text what follows '('. A final End is accepted.",
    "The list is that of the compensated (slave) axis, kopf.achs_nr; the positions of two master "
    "axes count.",
    "unit 0: encoder increments; unit 1: 0.1 um or 0.0001 deg.",
    "The points lie at start_position_master1 + i * interval and start_position_master2 + j * "
    "interval: square cells. Newer kernels also have grid RECTANGULAR with interval1 and "
    "interval2, which is read; distances of both kinds in one list are refused.",
    "table[j][i].correction: j counts along master axis 2, i along master axis 1.",
    "There may be max_points points, 10201 without that entry.",
    "Between the points the correction is bilinear; outside, that of the table's margin is held.",
    "When a master is a modulo axis, the values at both ends must be the same.",
    "Newer kernels take decimals: they are read, and written with the setting decimals.",
};
constexpr std::array<std::string_view, 3> assumptions{
    "The correction is added to the commanded position; the documentation gives no sign.",
    "A list without the entry unit is in increments.",
    "The list does not say whether an axis is linear or rotary: linear, unless a setting says "
    "otherwise. Increments are those of one encoder resolution for all axes.",
};

/// A distance of the other kind of grid: nobody knows which of them is meant. One of 0 says
/// nothing.
bool hasOnlyItsDistances(const isg::List& list, bool isSquare)
{
    using Keys = std::vector<std::string_view>;
    for (const std::string_view key :
        isSquare ? Keys{"interval1", "interval2"} : Keys{"interval"}) {
        const auto distance = list.has(key) ? list.number(key) : std::optional(0.0);
        if (distance == 0.0)
            continue;
        if (distance)
            list.diagnostics().error(DiagnosticCode::Contradiction, list.line(key), 0,
                Verbatim{list.path(key) + ' ' + toText(*distance)},
                AXISCOMP_TEXT("Error",
                    "interval of a square grid, or interval1 and interval2 of a grid RECTANGULAR"));
        return false;
    }
    return true;
}

/// The distances along both masters, in numbers of the file.
std::optional<std::array<double, 2>> intervals(const isg::List& list)
{
    const std::string grid = list.text("grid");
    const bool isSquare = grid.empty() || grid == "QUADRATIC";
    if (!isSquare && grid != "RECTANGULAR") {
        list.diagnostics().error(DiagnosticCode::Syntax, list.line("grid"), 0,
            Verbatim{excerpt(grid, Encoding::Utf8)},
            AXISCOMP_TEXT("Error", "QUADRATIC or RECTANGULAR"));
        return std::nullopt;
    }
    if (!hasOnlyItsDistances(list, isSquare))
        return std::nullopt;
    constexpr std::array<std::string_view, 2> own{"interval1", "interval2"};
    std::array<double, 2> distances{};
    for (std::size_t n = 0; n < 2; ++n) {
        const std::string_view key = isSquare ? "interval" : own[n];
        const auto distance = list.number(key);
        if (!distance)
            return std::nullopt;
        distances[n] = *distance;
        if (*distance > 0.0)
            continue;
        list.diagnostics().error(DiagnosticCode::LimitExceeded, list.line(key), 0,
            Verbatim{list.path(key) + ' ' + toText(*distance)},
            AXISCOMP_TEXT("Error", "a distance above 0"));
        return std::nullopt;
    }
    return distances;
}

/// One master axis as the list describes it.
struct Master {
    SourceAxis axis; ///< still without knots
    double start = 0.0;
    double interval = 0.0;
    std::size_t size = 0;
};

std::optional<Master> masterOf(const isg::List& list, const isg::Scale& scale,
    const SettingValues& values, char which, double interval)
{
    const std::string key = std::string("master") + which;
    const auto start = list.number("start_position_" + key);
    const auto last = list.whole("last_index_" + key, 1, 2147483646);
    const auto number = list.whole(key + "_ax_nr", 1, 65535);
    if (!start || !last || !number)
        return std::nullopt;
    Master master{{}, *start, interval, static_cast<std::size_t>(*last) + 1};
    master.axis.name = std::to_string(*number);
    master.axis.unit = scale.unit(values, key + "-kind", list);
    return master;
}

void checkModulo(const isg::List& list, NeutralTable& table, std::size_t n, const SettingValues& s)
{
    if (!s.yes(n == 0 ? "modulo1" : "modulo2"))
        return;
    SourceAxis& axis = table.axes[n];
    axis.wrap = axis.knots.back() - axis.knots.front();
    if (!isClosed(table, n))
        list.diagnostics().error(DiagnosticCode::NotPeriodic, 0, 0,
            AXISCOMP_TEXT("Error", "different values at both ends of master axis {number}")
                .with("number", n + 1),
            AXISCOMP_TEXT("Error", "the same values: a modulo axis is at the same place there"));
}

std::optional<NeutralTable> build(const isg::List& list, const SettingValues& settingValues)
{
    const auto scale = isg::scaleOf(list, settingValues);
    const auto distances = intervals(list);
    if (!scale || !distances)
        return std::nullopt;
    auto master1 = masterOf(list, *scale, settingValues, '1', (*distances)[0]);
    auto master2 = masterOf(list, *scale, settingValues, '2', (*distances)[1]);
    if (!master1 || !master2)
        return std::nullopt;
    if (master1->axis.name == master2->axis.name)
        list.diagnostics().error(DiagnosticCode::Contradiction, list.line("master2_ax_nr"), 0,
            Verbatim{list.path("master2_ax_nr") + ' ' + master2->axis.name},
            AXISCOMP_TEXT("Error", "another axis than that of the first source"));
    if (!list.checkMostPoints(master1->size * master2->size, mostPoints))
        return std::nullopt;
    const auto corrections = list.field("correction", {master2->size, master1->size});
    if (!corrections)
        return std::nullopt;
    NeutralTable table;
    table.sign = SignConvention::Command;
    for (Master* master : {&*master1, &*master2}) {
        SourceAxis& axis = table.axes.emplace_back(std::move(master->axis));
        const std::vector<double> numbers =
            evenKnots(master->start, master->interval, master->size);
        axis.knots = isg::scaled(*scale, numbers);
        axis.step = scale->numbers.stepOf(numbers);
        const Text name = AXISCOMP_TEXT("Error", "master axis {number}").with("number", axis.name);
        if (!checkKnots(axis.knots, {}, name, list.diagnostics()))
            return std::nullopt;
    }
    CompensationColumn& column = table.columns.emplace_back();
    column.target = list.axisNumber();
    column.unit = scale->unit(settingValues, "axis-kind", list);
    column.values = isg::scaled(*scale, corrections->numbers);
    checkModulo(list, table, 0, settingValues);
    checkModulo(list, table, 1, settingValues);
    return table;
}

std::vector<NeutralTable> parse(TextReading& reading)
{
    return isg::readSection(reading, section, build);
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    return readText(isg_crosscomp2::format().facts, text, options, parse);
}

Recognition recognise(std::string_view text)
{
    return isg::recogniseList(section, text);
}

/// The first position and the distance of an axis in numbers of the file, which are whole unless
/// decimals are asked for.
Result<std::array<double, 2>> gridOf(
    const FormatFacts& facts, const isg::Draft& draft, const SourceAxis& axis)
{
    std::vector<double> exact = axis.knots;
    for (double& knot : exact)
        knot *= draft.scale.numbers.perUnit;
    const double distance = (exact.back() - exact.front()) / static_cast<double>(exact.size() - 1);
    const std::array inUnits{axis.knots.front(), distance / draft.scale.numbers.perUnit};
    AXISCOMP_TRY(const auto inFile, isg::inFile(facts, draft, inUnits, isg::Numbers::Positions));
    if (!isg::isEvenInFile(inFile[0], inFile[1], exact))
        return cannotHold(facts,
            AXISCOMP_TEXT("Error",
                "the distance of {distance} along master {axis} is no whole number of {step}")
                .with("distance", Quantity{roundedText(inUnits[1]), axis.unit})
                .with("axis", axis.name)
                .with("step", Quantity{roundedText(1.0 / draft.scale.numbers.perUnit), axis.unit}),
            AXISCOMP_TEXT("Error", "resample it with such a distance"));
    return std::array{inFile[0], inFile[1]};
}

/// A modulo axis must stay closed when its values are rounded.
Result<void> closeEnds(
    const FormatFacts& facts, const isg::Draft& draft, std::vector<double>& values)
{
    const NeutralTable& table = draft.table;
    const std::size_t width = table.axes[0].knots.size();
    for (std::size_t n = 0; n < 2; ++n)
        if (table.axes[n].wrap)
            if (auto fits = checkOnePeriod(facts, table, n, 0.5 / draft.scale.numbers.perUnit);
                !fits)
                return fits;
    for (std::size_t row = 0; table.axes[0].wrap && row < values.size(); row += width)
        values[row + width - 1] = values[row];
    for (std::size_t i = 0; table.axes[1].wrap && i < width; ++i)
        values[values.size() - width + i] = values[i];
    return {};
}

void addHeader(isg::Draft& draft, const std::array<std::array<double, 2>, 2>& grids,
    const std::array<std::int64_t, 2>& masters)
{
    draft.add("interval", draft.numberText(grids[0][1]));
    for (std::size_t n = 0; n < 2; ++n) {
        const std::string key = "master" + std::to_string(n + 1);
        draft.add("last_index_" + key, draft.table.axes[n].knots.size() - 1);
        draft.add("start_position_" + key, draft.numberText(grids[n][0]));
        draft.add(key + "_ax_nr", static_cast<std::size_t>(masters[n]));
    }
}

Result<isg::Draft> draftOf(const NeutralTable& source, const SettingValues& given,
    std::int64_t axis, std::vector<Text>& remarks)
{
    const FormatFacts& facts = isg_crosscomp2::format().facts;
    const auto master1 = axisNumber(facts, given, masterKeys[0], source.axes[0].name);
    const auto master2 = axisNumber(facts, given, masterKeys[1], source.axes[1].name);
    if (!master1 || !master2)
        return fail(master1 ? master2.error() : master1.error());
    AXISCOMP_CHECK(checkTwoSources(std::to_string(*master1), std::to_string(*master2), masterKeys));
    auto draft = isg::beginDraft(section, source, given, axis, remarks);
    if (!draft)
        return fail(draft.error());
    const auto grid1 = gridOf(facts, *draft, draft->table.axes[0]);
    const auto grid2 = gridOf(facts, *draft, draft->table.axes[1]);
    if (!grid1 || !grid2)
        return fail(grid1 ? grid2.error() : grid1.error());
    if ((*grid1)[1] != (*grid2)[1])
        return cannotHold(facts,
            AXISCOMP_TEXT(
                "Error", "it takes one distance for both sources, and these are different"),
            AXISCOMP_TEXT("Error", "resample it with the same distance for each source"));
    AXISCOMP_TRY(auto values,
        isg::inFile(facts, *draft, draft->table.columns[0].values, isg::Numbers::Values));
    AXISCOMP_CHECK(closeEnds(facts, *draft, values));
    addHeader(*draft, {*grid1, *grid2}, {*master1, *master2});
    const std::size_t width = draft->table.axes[0].knots.size();
    for (std::size_t i = 0; i < values.size(); ++i)
        draft->addPoint('[' + std::to_string(i / width) + "][" + std::to_string(i % width) + ']',
            "correction", values[i]);
    return draft;
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    const FormatFacts& facts = isg_crosscomp2::format().facts;
    AXISCOMP_TRY(const auto given, SettingValues::of(facts, options.settings, true));
    AXISCOMP_TRY(const auto axis,
        axisNumber(
            facts, given, "axis", targetName(tables.front(), tables.front().columns.front())));
    std::vector<Text> remarks;
    AXISCOMP_TRY(auto draft, draftOf(tables.front(), given, axis, remarks));
    remarks.push_back(isg::activation(section, axis));
    const NeutralTable& table = draft.table;
    FormatSettings reading{{"axis-kind", isg::kindOf(table.columns[0].unit)}};
    for (std::size_t n = 0; n < 2; ++n) {
        const std::string number = std::to_string(n + 1);
        reading["master" + number + "-kind"] = isg::kindOf(table.axes[n].unit);
        reading["modulo" + number] = table.axes[n].wrap ? "yes" : "no";
    }
    return isg::finish(
        isg_crosscomp2::format(), std::move(draft), given, std::move(reading), std::move(remarks));
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "isg-crosscomp2",
            .controller = "ISG kernel, TwinCAT CNC",
            .description =
                AXISCOMP_TEXT("Error", "plane compensation in a compensation list (kw.crosscomp2)"),
            .extensions = extensions,
            .fewestDimensions = 2,
            .mostDimensions = 2,
            .knots = KnotRule::SquareCells,
            .mostPoints = mostPoints,
            .holdsUnits = true,
            .holdsNotes = true,
            .holdsWrap = true,
            .numbers = "whole numbers of 0.1 um, 0.0001 deg or one increment",
            .sign = SignConvention::Command,
            .signEvidence = Evidence::Assumed,
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

} // namespace axiscomp::isg_crosscomp2
