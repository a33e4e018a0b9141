// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/acs/acs_program.h"
#include "core/formats/formats.h"
#include "core/formats/units.h"
#include "core/table/position_unit.h"
#include "core/text/number_text.h"
#include "core/text/text_file.h"

#include <algorithm>
#include <map>

namespace axiscomp::acs_2d {

namespace {

using acs::Call;

constexpr std::string_view targetKey = "target-axis";
constexpr std::array<std::string_view, 2> sourceKeys{"source-axis-1", "source-axis-2"};

constexpr FormatSetting axisSetting(
    std::string_view key, const TextPattern& meaning, bool isNeeded = true)
{
    return {.key = key,
        .kind = FormatSetting::Kind::WholeNumber,
        .meaning = meaning,
        .forWriting = true,
        .isNeeded = isNeeded};
}
constexpr std::array<std::string_view, 2> extensions{".prg", ".txt"};
constexpr std::array settings{
    axisSetting(sourceKeys[0],
        AXISCOMP_TEXT("Error", "number of the axis of the first source of the table, from 0")),
    axisSetting(sourceKeys[1],
        AXISCOMP_TEXT("Error", "number of the axis of the second source of the table, from 0")),
    axisSetting(targetKey,
        AXISCOMP_TEXT("Error",
            "number of the axis that is compensated, from 0; needed where it is none of the "
            "sources"),
        false),
    acs::arrayName, acs::declaresArray};

constexpr std::array<std::string_view, 7> rules{
    "A program (ACSPL+) gives the elements of an array with two indices, from 0, numbers, and maps "
    "it: CONNECT RPOS(t) = APOS(t) + MAP2(APOS(a), APOS(b), array, base1, step1, base2, step2), "
    "with MFLAGS(t).#DEFCON = 0 before and DEPENDS t, (a,b) behind it. It is read as acs-1d is.",
    "The first index belongs to the second argument (rows), the second index to the first one "
    "(columns): element (i)(j) is the value at base1 + j * step1 of axis a and base2 + i * step2 "
    "of axis b.",
    "t is the axis that is compensated; it may be one of the sources or another one.",
    "The value is added to the commanded position of axis t.",
    "A program with several maps is read as several tables, named after their arrays; one is "
    "written to a file.",
    "Other sums behind CONNECT RPOS(t) = are refused where they have a map.",
    "Positions and values are in user units of the axes, which the program does not say.",
};
constexpr std::array<std::string_view, 4> assumptions{
    "The order of the indices and the place where the value is added are those of one public "
    "program.",
    "Outside of the table the values at its edge are held.",
    "Between the points the value is bilinear.",
    "An array may be declared with more elements than the program gives numbers. The table has "
    "those that it gives; the controller may use the others as they are, which is a warning.",
};

constexpr TextPattern connectWords = AXISCOMP_TEXT("Error",
    "CONNECT RPOS(t) = APOS(t) + MAP2(APOS(a), APOS(b), array, base1, step1, base2, step2)");

/// One axis of a map.
struct Side {
    std::int64_t axis = 0;
    double base = 0.0;
    double step = 0.0;
};

/// The maps of one program.
class MapReader {
public:
    explicit MapReader(TextReading& source)
        : m_diagnostics(source.diagnostics)
        , m_source(source) { }

    [[nodiscard]] std::vector<NeutralTable> tables();

private:
    [[nodiscard]] std::optional<NeutralTable> tableOf(const Call& call);
    [[nodiscard]] std::optional<Side> sideOf(
        const Call& call, const Token& position, const Token& base, const Token& step);
    void warnOfEnd(const Call& map);
    void warnOfOthers(bool hasOwn);

    acs::Program m_program;
    DiagnosticList& m_diagnostics;
    TextReading& m_source;
};

std::optional<Side> MapReader::sideOf(
    const Call& call, const Token& position, const Token& base, const Token& step)
{
    const auto axis = m_program.index(call, position, m_diagnostics);
    const auto first = m_program.number(call, base, m_diagnostics);
    const auto distance = m_program.number(call, step, m_diagnostics);
    if (!axis || !first || !distance)
        return std::nullopt;
    if (*distance > 0.0)
        return Side{*axis, *first, *distance};
    m_diagnostics.error(DiagnosticCode::LimitExceeded, step.line, step.column,
        AXISCOMP_TEXT("Error", "a step of {step}").with("step", Quantity{toText(*distance)}),
        AXISCOMP_TEXT("Error", "a step above 0"));
    return std::nullopt;
}

std::optional<NeutralTable> MapReader::tableOf(const Call& call)
{
    const std::vector<Token>& said = call.arguments;
    std::array<Token, 2> positions;
    for (std::size_t n = 0; n < positions.size(); ++n)
        positions[n] = said.size() == 9 ? acs::axisOfPosition(said[2 + n]) : Token{};
    if (!positions[0] || !positions[1]) {
        acs::refuseForm(call, connectWords, m_diagnostics);
        return std::nullopt;
    }
    const auto target = m_program.index(call, said[0], m_diagnostics);
    const auto added = m_program.index(call, said[1], m_diagnostics);
    const std::array sides{
        sideOf(call, positions[0], said[5], said[6]), sideOf(call, positions[1], said[7], said[8])};
    if (!target || !added || !sides[0] || !sides[1])
        return std::nullopt;
    if (*target != *added || sides[0]->axis == sides[1]->axis) {
        acs::refuseForm(call, connectWords, m_diagnostics);
        return std::nullopt;
    }
    auto elements = m_program.elements(call, said[4], 2, m_diagnostics);
    if (!elements)
        return std::nullopt;
    NeutralTable table;
    table.sign = SignConvention::Command;
    table.name = toUtf8(said[4].text, Encoding::Utf8);
    const std::size_t line = call.statement.line;
    for (std::size_t n = 0; n < sides.size(); ++n) {
        SourceAxis& axis = table.axes.emplace_back();
        axis.name = m_program.axisName(sides[n]->axis);
        axis.knots = evenKnots(sides[n]->base, sides[n]->step, elements->counts[1 - n]);
        if (!checkKnots(axis.knots, std::span(&line, 1),
                AXISCOMP_TEXT("Error", "axis {axis}").with("axis", axis.name), m_diagnostics))
            return std::nullopt;
    }
    CompensationColumn& column = table.columns.emplace_back();
    column.target = m_program.axisName(*target);
    column.values = std::move(elements->values);
    return table;
}

void MapReader::warnOfEnd(const Call& map)
{
    const auto target = m_program.index(map, map.arguments.front(), m_diagnostics);
    const auto isOne = [&](const Call& call, Call::Kind kind) {
        return call.kind == kind && m_program.isOf(call, {target.value_or(0)});
    };
    const Call* const end =
        m_program.endOf([&](const Call& call) { return isOne(call, Call::Kind::Map2); },
            [&](const Call& call) { return isOne(call, Call::Kind::Disconnect); });
    if (end)
        warnOfSwitchedOff(end->statement, m_diagnostics);
}

void MapReader::warnOfOthers(bool hasOwn)
{
    const auto isOther = [](const Call& call) {
        return call.kind == Call::Kind::ErrorMap || call.kind == Call::Kind::Map;
    };
    const auto other = std::ranges::find_if(m_program.calls(), isOther);
    if (other != m_program.calls().end())
        acs::pointTo(acs_1d::format().facts, *other,
            AXISCOMP_TEXT("Error", "a map of one axis ({name})").with("name", other->name.text),
            hasOwn, m_diagnostics);
}

std::vector<NeutralTable> MapReader::tables()
{
    std::vector<std::string> notes;
    if (!m_program.read(m_source, notes))
        return {};
    std::vector<NeutralTable> tables;
    std::vector<const Call*> taken;
    std::map<std::string, std::size_t> firstLines; // of each target
    bool hasOwn = false;
    for (const Call& call : m_program.calls()) {
        if (call.kind == Call::Kind::Unsupported)
            acs::refuseCommand(call, m_diagnostics);
        if (call.kind != Call::Kind::Map2)
            continue;
        hasOwn = true;
        auto table = tableOf(call);
        if (!table)
            continue;
        taken.push_back(&call);
        if (std::ranges::find(tables, *table) != tables.end())
            continue;
        const std::string& target = table->columns.front().target;
        const auto [first, isFirst] = firstLines.emplace(target, call.statement.line);
        if (!isFirst)
            acs::warnOfSecond(call, target, first->second, m_diagnostics);
        tables.push_back(std::move(*table));
        warnOfEnd(call);
    }
    m_program.warnOfSecondNumbers(taken, m_diagnostics);
    warnOfOthers(hasOwn);
    if (!hasOwn && !m_diagnostics.hasErrors())
        m_diagnostics.error(DiagnosticCode::Syntax, 0, 0, {},
            AXISCOMP_TEXT("Error", "a statement CONNECT with MAP2, of which there is none"));
    for (NeutralTable& table : tables) {
        DiagnosticList ignored(0); // once for all tables
        const bool isFirst = &table == &tables.front();
        takeUnits(table, m_source.settings, isFirst ? m_diagnostics : ignored);
        if (auto contradiction = unitContradiction(table))
            m_diagnostics.error(*std::move(contradiction));
    }
    if (!tables.empty())
        tables.front().notes = std::move(notes);
    return tables;
}

std::vector<NeutralTable> parse(TextReading& source)
{
    return MapReader(source).tables();
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    return readText(acs_2d::format().facts, text, options, parse);
}

Recognition recognise(std::string_view text)
{
    return acs::recogniseProgram(text, {Call::Kind::Map2}, {Call::Kind::ErrorMap, Call::Kind::Map});
}

/// The table with the numbers of its axes. Errors: InvalidArgument for numbers that contradict it.
Result<NeutralTable> numbered(NeutralTable table, const SettingValues& given)
{
    const FormatFacts& facts = acs_2d::format().facts;
    const auto refuse = [&](Text reason) {
        return fail(ErrorCode::InvalidArgument, {{"reason", std::move(reason)}});
    };
    const auto own = ownAxis(table, table.columns.front());
    std::array<std::int64_t, 2> sources{};
    for (std::size_t n = 0; n < sources.size(); ++n) {
        AXISCOMP_TRY(sources[n], acs::numberFromZero(facts, given, sourceKeys[n]));
        table.axes[n].name = std::to_string(sources[n]);
    }
    AXISCOMP_CHECK(checkTwoSources(table.axes[0].name, table.axes[1].name, sourceKeys));
    std::int64_t target = own ? sources[*own] : 0;
    if (given.has(targetKey)) {
        AXISCOMP_TRY(target, acs::numberFromZero(facts, given, targetKey));
    } else if (!own) {
        return refuse(AXISCOMP_TEXT("Error",
            "the format {format} needs the setting {key}, since the table corrects none of its "
            "sources")
                          .with("format", facts.name)
                          .with("key", targetKey));
    }
    const bool isSource = target == sources[0] || target == sources[1];
    if (own ? target != sources[*own] : isSource)
        return refuse(AXISCOMP_TEXT("Error",
            "the table goes from {column}, which the settings {key}, {other} and {target} "
            "contradict")
                          .with("column", columnText(table, table.columns.front()))
                          .with("key", sourceKeys[0])
                          .with("other", sourceKeys[1])
                          .with("target", targetKey));
    table.columns.front().target = std::to_string(target);
    return table;
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    const TableFormat& format = acs_2d::format();
    AXISCOMP_TRY(const auto given, SettingValues::of(format.facts, options.settings, true));
    AXISCOMP_TRY(const auto name, acs::nameOfArray(format.facts, given));
    AXISCOMP_CHECK(checkTargets(tables.front()));
    AXISCOMP_TRY(auto named, numbered(tables.front(), given));
    WrittenTables written;
    AXISCOMP_TRY(const auto table, inSettingUnits(named, given, written.remarks));
    const auto own = ownAxis(table, table.columns.front());
    AXISCOMP_CHECK(checkOneUnit(format.facts, unitContradiction(table)));
    const bool isDeclared = given.yes(acs::declaresArray.key);
    const std::string& target = table.columns.front().target;
    const std::array axes{table.axes[0].name, table.axes[1].name};
    written.bytes = acs::arrayLines(table, name, 2, isDeclared) + "MFLAGS(" + target
        + ").#DEFCON = 0\nCONNECT RPOS(" + target + ") = APOS(" + target + ") + MAP2(APOS("
        + axes[0] + "), APOS(" + axes[1] + "), " + name + ", " + acs::gridArguments(table.axes[0])
        + ", " + acs::gridArguments(table.axes[1]) + ")\nDEPENDS " + target + ", (" + axes[0] + ","
        + axes[1] + ")\nSTOP\n";
    FormatSettings reading;
    const std::string& positionUnit = table.axes[own.value_or(0)].unit;
    if (!positionUnit.empty())
        reading["position-unit"] = positionUnit;
    if (!table.columns[0].unit.empty())
        reading["value-unit"] = table.columns[0].unit;
    AXISCOMP_TRY(auto held, readBack(format, written.bytes, std::move(reading)));
    for (std::size_t n = 0; n < 2; ++n) // both have units of their own
        held.front().axes[n].unit = table.axes[n].unit;
    written.held = std::move(held);
    acs::remarkOnArray(name, isDeclared, written.remarks);
    written.remarks.push_back(AXISCOMP_TEXT(
        "Error", "the axes must be referenced; the connection replaces an error map of axis {axis}")
                                  .with("axis", target));
    return written;
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{.facts = {.name = "acs-2d",
                                        .controller = "ACS SPiiPlus",
                                        .description = AXISCOMP_TEXT("Error",
                                            "program with the map of an axis over two (MAP2)"),
                                        .extensions = extensions,
                                        .fewestDimensions = 2,
                                        .mostDimensions = 2,
                                        .knots = KnotRule::Even,
                                        .holdsNotes = true,
                                        .numbers = "decimal text",
                                        .sign = SignConvention::Command,
                                        .signEvidence = Evidence::Code,
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

} // namespace axiscomp::acs_2d
