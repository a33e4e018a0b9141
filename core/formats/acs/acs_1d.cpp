// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/acs/acs_program.h"
#include "core/formats/formats.h"
#include "core/formats/own_axis.h"
#include "core/text/number_text.h"
#include "core/text/text_file.h"

#include <algorithm>

namespace axiscomp::acs_1d {

namespace {

using acs::Call;

constexpr std::array<std::string_view, 2> extensions{".prg", ".txt"};
constexpr std::string_view connectForm = "connect";
constexpr std::array settings{FormatSetting{.key = "axis",
                                  .kind = FormatSetting::Kind::WholeNumber,
                                  .meaning = AXISCOMP_TEXT("Error", "number of the axis, from 0"),
                                  .forWriting = true,
                                  .isNeeded = true},
    FormatSetting{.key = "zone",
        .kind = FormatSetting::Kind::WholeNumber,
        .meaning = AXISCOMP_TEXT("Error", "number of the zone of the error map, from 0"),
        .standard = "0",
        .forWriting = true},
    acs::arrayName, acs::declaresArray,
    FormatSetting{.key = "form",
        .kind = FormatSetting::Kind::Choice,
        .meaning =
            AXISCOMP_TEXT("Error", "how the array is mapped: ERRORMAP1D, or CONNECT with MAP"),
        .choices = "errormap, connect",
        .standard = "errormap",
        .forWriting = true}};

constexpr std::array<std::string_view, 12> rules{
    "A program (ACSPL+) gives the elements of an array, from 0, numbers, and maps the array to an "
    "axis: ERRORMAP1D axis, zone, base, step, array, switched on by ERRORMAPON axis, zone; or, "
    "the older way, CONNECT RPOS(a) = APOS(a) + MAP(APOS(a), array, base, step) with "
    "MFLAGS(a).#DEFCON = 0 or MFLAGS(a).17 = 0 before it.",
    "! begins a comment, ; separates statements, upper and lower case are the same; everything "
    "else in the program is passed over.",
    "Element i is the value at base + i * step.",
    "Axis, zone, base and step are numbers, or names that got a number before; an axis may be a "
    "name of AXISDEF. Other buffers of a saved program, which lines #5 or #A begin, count as far "
    "as their names are global.",
    "A name that gets two numbers before a map has the last one, with a warning. Of numbers in "
    "other buffers, in ON, or behind a label that only CALL and GOTO lead to, nobody knows which "
    "comes last: they must be the same.",
    "Within IF, ELSE, SWITCH, LOOP, WHILE and ON a number counts for the maps of the same block; "
    "another map that needs it is refused, since only the controller knows whether it counts.",
    "A statement that changes an array behind its elements, or a name before its map, and is no "
    "number for it, such as +=, COPY, READ or a function that has it as an argument, is not "
    "computed, and the map is refused.",
    "CONNECT adds the value to the commanded position, and a program that uses both ways uses the "
    "same array for both; two programs that write ERRORMAP1D from measurements write reference - "
    "actual position.",
    "A program with several maps is read as several tables, named after their arrays; one is "
    "written to a file. A map that the same buffer switches off behind it (ERRORMAPOFF, "
    "ERRORUNMAP, another CONNECT, MFLAGS(a).17 = 1) is a warning.",
    "An element that gets several numbers has the last one, with a warning; one that gets none is "
    "missing, unless all behind it get none either.",
    "ERRORMAPN1D, ERRORMAPA1D, ERRORMAP2D, ERRORMAPN2D, ERRORMAPA2D, MAPN, MAPB and MAPS, whose "
    "arguments are not published, are refused.",
    "Positions and values are in user units of the axis, which the program does not say.",
};
constexpr std::array<std::string_view, 4> assumptions{
    "ERRORMAP1D adds the value to the reference position, as CONNECT does: the programs agree, no "
    "public text says it.",
    "Outside of the table the value at that end is held.",
    "Between the points the value is linear.",
    "An array may be declared with more elements than the program gives numbers. The table has "
    "those that it gives; the controller may use the others as they are, which is a warning.",
};

constexpr TextPattern commandWords =
    AXISCOMP_TEXT("Error", "ERRORMAP1D axis, zone, base, step, array");
constexpr TextPattern connectWords =
    AXISCOMP_TEXT("Error", "CONNECT RPOS(a) = APOS(a) + MAP(APOS(a), array, base, step)");

/// What a call maps.
struct Map {
    std::int64_t axis = 0;
    std::optional<std::int64_t> zone; ///< nothing: by CONNECT
    double base = 0.0;
    double step = 0.0;
    const Call* call = nullptr;
    Token array;

    [[nodiscard]] bool isSame(const Map& other) const
    {
        return axis == other.axis && base == other.base && step == other.step
            && sameLetters(array.text, other.array.text);
    }
};

/// The maps of one program.
class MapReader {
public:
    explicit MapReader(TextReading& source)
        : m_diagnostics(source.diagnostics)
        , m_source(source) { }

    [[nodiscard]] std::vector<NeutralTable> tables();

private:
    [[nodiscard]] std::optional<Map> mapOf(const Call& call);
    [[nodiscard]] std::optional<Map> connectOf(const Call& call, Map map);
    [[nodiscard]] std::optional<NeutralTable> tableOf(const Map& map);
    void takeMaps();
    void checkSwitchedOn();
    [[nodiscard]] const Call* endOf(const Map& map) const;
    void checkSwitchedOff();
    void warnOfOthers();

    acs::Program m_program;
    DiagnosticList& m_diagnostics;
    TextReading& m_source;
    std::vector<Map> m_maps;
    std::vector<std::pair<std::size_t, Map>> m_uses; ///< of m_maps, by index: said once, or again
};

std::optional<Map> MapReader::connectOf(const Call& call, Map map)
{
    const std::vector<Token>& arguments = call.arguments;
    const Token position = arguments.size() == 6 ? acs::axisOfPosition(arguments[2]) : Token{};
    if (!position) {
        acs::refuseForm(call, connectWords, m_diagnostics);
        return std::nullopt;
    }
    const auto target = m_program.index(call, arguments[0], m_diagnostics);
    const auto added = m_program.index(call, arguments[1], m_diagnostics);
    const auto source = m_program.index(call, position, m_diagnostics);
    const auto base = m_program.number(call, arguments[4], m_diagnostics);
    const auto step = m_program.number(call, arguments[5], m_diagnostics);
    if (!target || !added || !source || !base || !step)
        return std::nullopt;
    if (*target != *added || *target != *source) {
        acs::refuseForm(call, connectWords, m_diagnostics);
        return std::nullopt;
    }
    map.axis = *target;
    map.base = *base;
    map.step = *step;
    map.array = arguments[3];
    return map;
}

/// Nothing: an error.
std::optional<Map> MapReader::mapOf(const Call& call)
{
    Map map;
    map.call = &call;
    if (call.kind == Call::Kind::Map)
        return connectOf(call, map);
    if (call.arguments.empty()) {
        acs::refuseForm(call, commandWords, m_diagnostics);
        return std::nullopt;
    }
    const auto axis = m_program.index(call, call.arguments[0], m_diagnostics);
    map.zone = m_program.index(call, call.arguments[1], m_diagnostics);
    const auto base = m_program.number(call, call.arguments[2], m_diagnostics);
    const auto step = m_program.number(call, call.arguments[3], m_diagnostics);
    if (!axis || !map.zone || !base || !step)
        return std::nullopt;
    map.axis = *axis;
    map.base = *base;
    map.step = *step;
    map.array = call.arguments[4];
    return map;
}

/// A program may say the same map twice, in both ways.
void MapReader::takeMaps()
{
    for (const Call& call : m_program.calls()) {
        if (call.kind == Call::Kind::Unsupported)
            acs::refuseCommand(call, m_diagnostics);
        if (call.kind != Call::Kind::ErrorMap && call.kind != Call::Kind::Map)
            continue;
        const auto map = mapOf(call);
        if (!map)
            continue;
        if (!(map->step > 0.0)) {
            m_diagnostics.error(DiagnosticCode::LimitExceeded, call.statement.line,
                call.statement.column,
                AXISCOMP_TEXT("Error", "a step of {step}")
                    .with("step", Quantity{toText(map->step)}),
                AXISCOMP_TEXT("Error", "a step above 0"));
            continue;
        }
        const auto isSame = [&](const Map& other) {
            return other.isSame(*map) && m_program.isOneArray(call, *other.call, map->array);
        };
        const auto same = std::ranges::find_if(m_maps, isSame);
        m_uses.emplace_back(static_cast<std::size_t>(same - m_maps.begin()), *map);
        if (same != m_maps.end())
            continue;
        const auto other = std::ranges::find(m_maps, map->axis, &Map::axis);
        if (other != m_maps.end())
            acs::warnOfSecond(
                call, m_program.axisName(map->axis), other->call->statement.line, m_diagnostics);
        m_maps.push_back(*map);
    }
}

void MapReader::checkSwitchedOn()
{
    for (const Map& map : m_maps) {
        if (!map.zone)
            continue;
        const bool isOn = std::ranges::any_of(m_program.calls(), [&](const Call& call) {
            return call.kind == Call::Kind::SwitchOn && call.arguments.size() == 2
                && m_program.isOf(call, {map.axis, *map.zone});
        });
        if (!isOn)
            m_diagnostics.warning(DiagnosticCode::Assumption, map.call->statement.line,
                map.call->statement.column,
                AXISCOMP_TEXT("Error", "no ERRORMAPON {axis}, {zone}")
                    .with("axis", m_program.axisName(map.axis))
                    .with("zone", *map.zone),
                AXISCOMP_TEXT("Error",
                    "a statement that switches the map on, which may stand in another program"));
    }
}

/// The statement behind which the map does not act any more; null: none.
const Call* MapReader::endOf(const Map& map) const
{
    const auto isOne = [&](const Call& call, Call::Kind kind) {
        return call.kind == kind && m_program.isOf(call, {map.axis});
    };
    const auto isOfZone = [&](const Call& call) {
        return m_program.isOf(call, {map.axis, map.zone.value_or(0)});
    };
    if (!map.zone)
        return m_program.endOf([&](const Call& call) { return isOne(call, Call::Kind::Map); },
            [&](const Call& call) { return isOne(call, Call::Kind::Disconnect); });
    return m_program.endOf(
        [&](const Call& call) {
            return (call.kind == Call::Kind::ErrorMap || call.kind == Call::Kind::SwitchOn)
                && isOfZone(call);
        },
        [&](const Call& call) { return call.kind == Call::Kind::SwitchOff && isOfZone(call); });
}

/// A map that the program says in both ways acts until both are ended.
void MapReader::checkSwitchedOff()
{
    for (std::size_t n = 0; n < m_maps.size(); ++n) {
        const Call* end = nullptr;
        bool acts = false;
        for (const auto& [index, map] : m_uses) {
            const Call* const last = index == n ? endOf(map) : nullptr;
            acts = acts || (index == n && !last);
            end = last ? last : end;
        }
        if (end && !acts)
            warnOfSwitchedOff(end->statement, m_diagnostics);
    }
}

void MapReader::warnOfOthers()
{
    const auto other = std::ranges::find(m_program.calls(), Call::Kind::Map2, &Call::kind);
    if (other != m_program.calls().end())
        acs::pointTo(acs_2d::format().facts, *other,
            AXISCOMP_TEXT("Error", "a map over two axes (MAP2)"), !m_maps.empty(), m_diagnostics);
}

std::optional<NeutralTable> MapReader::tableOf(const Map& map)
{
    const auto elements = m_program.elements(*map.call, map.array, 1, m_diagnostics);
    if (!elements)
        return std::nullopt;
    NeutralTable table;
    table.sign = SignConvention::Command;
    table.name = toUtf8(map.array.text, Encoding::Utf8);
    SourceAxis& axis = table.axes.emplace_back();
    axis.knots = evenKnots(map.base, map.step, elements->values.size());
    const std::size_t line = map.call->statement.line;
    if (!checkKnots(axis.knots, std::span(&line, 1), {}, m_diagnostics))
        return std::nullopt;
    table.columns.emplace_back().values = elements->values;
    takeOneUnit(table, m_source.settings, m_diagnostics);
    axis.name = m_program.axisName(map.axis);
    table.columns.front().target = axis.name;
    return table;
}

std::vector<NeutralTable> MapReader::tables()
{
    std::vector<std::string> notes;
    if (!m_program.read(m_source, notes))
        return {};
    takeMaps();
    warnOfOthers();
    if (m_maps.empty() && !m_diagnostics.hasErrors())
        m_diagnostics.error(DiagnosticCode::Syntax, 0, 0, {},
            AXISCOMP_TEXT(
                "Error", "a statement ERRORMAP1D, or CONNECT with MAP, of which there is none"));
    checkSwitchedOn();
    checkSwitchedOff();
    std::vector<NeutralTable> tables;
    std::vector<const Call*> taken;
    for (std::size_t n = 0; n < m_maps.size(); ++n) {
        auto table = tableOf(m_maps[n]);
        if (!table)
            continue;
        tables.push_back(std::move(*table));
        for (const auto& [index, use] : m_uses)
            if (index == n)
                taken.push_back(use.call);
    }
    m_program.warnOfSecondNumbers(taken, m_diagnostics);
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
    return readText(acs_1d::format().facts, text, options, parse);
}

Recognition recognise(std::string_view text)
{
    return acs::recogniseProgram(text, {Call::Kind::ErrorMap, Call::Kind::Map}, {Call::Kind::Map2});
}

/// The statements that map the array.
std::string mapLines(const NeutralTable& table, const std::string& axis, const std::string& zone,
    const std::string& name, bool isConnected)
{
    const std::string grid = acs::gridArguments(table.axes.front());
    if (isConnected)
        return "MFLAGS(" + axis + ").#DEFCON = 0\nCONNECT RPOS(" + axis + ") = APOS(" + axis
            + ") + MAP(APOS(" + axis + "), " + name + ", " + grid + ")\nDEPENDS " + axis + ", "
            + axis + '\n';
    const std::string map = axis + ", " + zone;
    return "ERRORUNMAP " + map + "\nERRORMAP1D " + map + ", " + grid + ", " + name + "\nERRORMAPON "
        + map + '\n';
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    const TableFormat& format = acs_1d::format();
    AXISCOMP_TRY(const auto given, SettingValues::of(format.facts, options.settings, true));
    AXISCOMP_TRY(const auto axis, acs::numberFromZero(format.facts, given, "axis"));
    AXISCOMP_TRY(const auto zone, acs::numberFromZero(format.facts, given, "zone"));
    AXISCOMP_TRY(const auto name, acs::nameOfArray(format.facts, given));
    const bool isConnected = given.text("form") == connectForm;
    const bool isDeclared = given.yes(acs::declaresArray.key);
    WrittenTables written;
    AXISCOMP_TRY(auto table, asOwnAxisTable(format.facts, tables.front(), given, written.remarks));
    table.notes = tables.front().notes;
    written.bytes = acs::arrayLines(table, name, 1, isDeclared)
        + mapLines(table, std::to_string(axis), std::to_string(zone), name, isConnected) + "STOP\n";
    FormatSettings reading;
    if (!table.axes.front().unit.empty())
        reading["position-unit"] = table.axes.front().unit;
    AXISCOMP_TRY(auto held, readBack(format, written.bytes, std::move(reading)));
    written.held = std::move(held);
    acs::remarkOnArray(name, isDeclared, written.remarks);
    if (isConnected)
        written.remarks.push_back(AXISCOMP_TEXT("Error",
            "the axis must be referenced; the connection replaces an error map of the axis"));
    else
        written.remarks.push_back(AXISCOMP_TEXT("Error",
            "the axis must be referenced, and a map that is on switched off with ERRORMAPOFF "
            "before; ERRORUNMAP {axis}, {zone} removes the map")
                                      .with("axis", axis)
                                      .with("zone", zone));
    return written;
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "acs-1d",
            .controller = "ACS SPiiPlus",
            .description = AXISCOMP_TEXT(
                "Error", "program with the error map of an axis (ERRORMAP1D, or CONNECT with MAP)"),
            .extensions = extensions,
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

} // namespace axiscomp::acs_1d
