// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"
#include "core/formats/siemens/siemens_program.h"
#include "core/formats/units.h"
#include "core/text/number_text.h"
#include "core/text/text_file.h"

#include <algorithm>

namespace axiscomp::siemens_cec {

namespace {

constexpr std::string_view prefix = "$AN_CEC";
constexpr std::string_view otherPrefix = "$AA_ENC_COMP";
constexpr std::string_view weightName = "$SN_CEC_TABLE_WEIGHT";
constexpr std::string_view scalingName = "$MA_CEC_SCALING_SYSTEM_METRIC";
constexpr std::string_view tableSwitch = "$SN_CEC_TABLE_ENABLE";
constexpr std::string_view axisSwitch = "$MA_CEC_ENABLE";
constexpr std::string_view inputSuffix = "_INPUT_AXIS";
constexpr std::string_view outputSuffix = "_OUTPUT_AXIS";
constexpr std::int64_t mostTables = 1000; // twice as many as a control has axes, and more

constexpr std::array<std::string_view, 3> extensions{".ini", ".mpf", ".spf"};
constexpr std::array settings{siemens::rotaryAxes,
    FormatSetting{.key = "first-table",
        .kind = FormatSetting::Kind::WholeNumber,
        .meaning = AXISCOMP_TEXT("Error", "index of the first table that is written"),
        .standard = "0",
        .forWriting = true},
    FormatSetting{.key = "input-axis",
        .kind = FormatSetting::Kind::Text,
        .meaning = AXISCOMP_TEXT(
            "Error", "name of the axis whose position counts, instead of the table's name for it"),
        .forWriting = true,
        .namedAxis = AxisOfTable::source(0)},
    FormatSetting{.key = "output-axis",
        .kind = FormatSetting::Kind::Text,
        .meaning = AXISCOMP_TEXT(
            "Error", "name of the axis that is compensated, instead of the table's name for it"),
        .forWriting = true,
        .namedAxis = AxisOfTable::target(0)}};

constexpr std::array<std::string_view, 8> rules{
    "A part program assigns $AN_CEC[table,point], with _INPUT_AXIS, _OUTPUT_AXIS, _STEP, _MIN, "
    "_MAX, _DIRECTION, _IS_MODULO and _MULT_BY_TABLE[table]; CHANDATA(1) in front, M17 at the end, "
    "; begins a comment.",
    "Point 0 lies at MIN, the last one at MAX; there are (MAX - MIN) / STEP + 1 of them.",
    "Positions and values are in mm, of rotary axes in degrees.",
    "The value is taken at the commanded position of the input axis and compensates the output "
    "axis, which may be the same.",
    "DIRECTION 0: the table holds for both directions of motion of the input axis, 1: for the "
    "positive one, -1: for the negative one.",
    "Between the points the value is linear; outside, that at the nearest end is held.",
    "IS_MODULO 1: MIN follows MAX, and both values should be the same.",
    "$MA_CEC_SCALING_SYSTEM_METRIC 0 (inches) is refused; $SN_CEC_TABLE_ENABLE or $MA_CEC_ENABLE "
    "that is 0 in the end, and switches a table off, is a warning.",
};
constexpr std::array<std::string_view, 5> assumptions{
    "The value is added to the commanded position of the output axis.",
    "The basic system is metric.",
    "A program without IS_MODULO, DIRECTION or MULT_BY_TABLE has 0.",
    "MULT_BY_TABLE adds a product of two tables, which no single table can say: such a table is "
    "read without it, with a warning.",
    "Two tables that differ only in direction and values are read as one.",
};

struct Entry {
    std::int64_t index = 0;
    siemens::Curve curve;
    std::string input;
    std::string output;
};

/// What the assignments of a program say, table by table.
class Collector {
public:
    explicit Collector(DiagnosticList& diagnostics) : m_diagnostics(diagnostics) { }

    void take(const siemens::Assignment& said);
    void checkSwitches();
    [[nodiscard]] std::map<std::int64_t, Entry>& entries() { return m_entries; }

private:
    void takeOther(const Token& name);
    void takeWeight(const siemens::Assignment& said);
    void takeScaling(const siemens::Assignment& said);
    [[nodiscard]] Entry* entryOf(const Token& index);
    void takeAxis(std::string& axis, const siemens::Assignment& said);

    DiagnosticList& m_diagnostics;
    std::map<std::int64_t, Entry> m_entries;
    siemens::Switches m_switches;
    bool m_hasOther = false;
};

Entry* Collector::entryOf(const Token& index)
{
    const Text expected = AXISCOMP_TEXT("Error", "the index of a table, 0 to {number}")
                              .with("number", mostTables - 1);
    const auto number = readWholeNumber(index, expected, m_diagnostics);
    if (!number)
        return nullptr;
    const Text label = AXISCOMP_TEXT("Error", "table {number}").with("number", *number);
    if (*number < 0 || *number >= mostTables) {
        m_diagnostics.error(
            DiagnosticCode::LimitExceeded, index.line, index.column, label, expected);
        return nullptr;
    }
    Entry& entry = m_entries[*number];
    if (entry.curve.prefix.empty()) {
        entry.index = *number;
        entry.curve.prefix = prefix;
        entry.curve.label = label;
    }
    return &entry;
}

void Collector::takeAxis(std::string& axis, const siemens::Assignment& said)
{
    if (!axis.empty())
        m_diagnostics.error(DiagnosticCode::Contradiction, said.name.line, said.name.column,
            AXISCOMP_TEXT("Error", "{what} a second time").with("what", said.name.text),
            AXISCOMP_TEXT("Error", "each variable once"));
    axis = toUtf8(said.value.text, Encoding::Utf8);
}

void Collector::takeOther(const Token& name)
{
    const bool isOther = name.text.size() >= otherPrefix.size()
        && sameLetters(name.text.substr(0, otherPrefix.size()), otherPrefix);
    if (isOther && !m_hasOther)
        m_diagnostics.warning(DiagnosticCode::Assumption, name.line, name.column,
            AXISCOMP_TEXT("Error", "tables {name} besides {other}")
                .with("name", otherPrefix)
                .with("other", prefix),
            AXISCOMP_TEXT("Error", "the format {format} to read them; they are left out here")
                .with("format", siemens_eec::format().facts.name));
    else if (!isOther)
        m_diagnostics.warning(DiagnosticCode::UnknownKey, name.line, name.column,
            Verbatim{excerpt(name.text, Encoding::Utf8)}, {});
    m_hasOther = m_hasOther || isOther;
}

/// A setting that multiplies the table on the control; 1 unless it is set (SD41310).
void Collector::takeWeight(const siemens::Assignment& said)
{
    if (numberOf(trimmed(said.value.text)) == 1.0)
        return;
    m_diagnostics.error(DiagnosticCode::LimitExceeded, said.name.line, said.name.column,
        AXISCOMP_TEXT("Error", "{name} = {value}, which multiplies the table on the control")
            .with("name", weightName)
            .with("value", Verbatim{excerpt(said.value.text, Encoding::Utf8)}),
        AXISCOMP_TEXT(
            "Error", "1; take the line out, and multiply the values by the number (--scale)"));
}

/// Whether a control whose basic system is metric has the table in mm (MD32711).
void Collector::takeScaling(const siemens::Assignment& said)
{
    if (siemens::yesOrNo(trimmed(said.value.text)) == true)
        return;
    m_diagnostics.error(DiagnosticCode::LimitExceeded, said.name.line, said.name.column,
        AXISCOMP_TEXT(
            "Error", "{name} = {value}, with which the lengths of the table are in inches")
            .with("name", scalingName)
            .with("value", Verbatim{excerpt(said.value.text, Encoding::Utf8)}),
        AXISCOMP_TEXT(
            "Error", "1; take the line out, and multiply positions and values in inches by 25.4"));
}

/// Of the last switches of each table and of the axis that it compensates.
void Collector::checkSwitches()
{
    for (const auto& [index, entry] : m_entries) {
        m_switches.check(tableSwitch, {std::to_string(index)}, m_diagnostics);
        m_switches.check(axisSwitch, {entry.output}, m_diagnostics);
    }
    m_switches.reportOthers(m_diagnostics);
}

void Collector::take(const siemens::Assignment& said)
{
    const std::string_view name = said.name.text;
    if (m_switches.take(said, tableSwitch, 1) || m_switches.take(said, axisSwitch, 1))
        return;
    if (sameLetters(name, weightName)) {
        takeWeight(said);
        return;
    }
    if (sameLetters(name, scalingName)) {
        takeScaling(said);
        return;
    }
    const bool isOwn =
        name.size() >= prefix.size() && sameLetters(name.substr(0, prefix.size()), prefix);
    const std::string_view suffix = isOwn ? name.substr(prefix.size()) : std::string_view();
    const bool isInput = sameLetters(suffix, inputSuffix);
    const bool isOutput = sameLetters(suffix, outputSuffix);
    const bool isPoint = isOwn && suffix.empty();
    const auto variable = siemens::variableOf(suffix);
    if (!isPoint && !isInput && !isOutput && variable == siemens::Curve::variableCount) {
        takeOther(said.name);
        return;
    }
    if (said.arguments.size() != (isPoint ? 2U : 1U)) {
        m_diagnostics.error(DiagnosticCode::Syntax, said.name.line, said.name.column,
            Verbatim{excerpt(name, Encoding::Utf8)},
            isPoint ? AXISCOMP_TEXT("Error", "two indices: [table,point]")
                    : AXISCOMP_TEXT("Error", "one index: [table]"));
        return;
    }
    Entry* const entry = entryOf(said.arguments.front());
    if (!entry)
        return;
    if (isPoint)
        siemens::addPoint(entry->curve, said.arguments[1], said.value, m_diagnostics);
    else if (isInput || isOutput)
        takeAxis(isInput ? entry->input : entry->output, said);
    else
        siemens::setVariable(entry->curve, variable, said, m_diagnostics);
}

std::optional<Direction> directionOf(const siemens::Curve& curve, DiagnosticList& diagnostics)
{
    const double value = curve.value(siemens::Curve::Direction);
    if (value == 0.0)
        return Direction::Both;
    if (value == 1.0 || value == -1.0)
        return value > 0.0 ? Direction::Positive : Direction::Negative;
    diagnostics.error(DiagnosticCode::LimitExceeded, curve.lines[siemens::Curve::Direction], 0,
        Verbatim{"$AN_CEC_DIRECTION " + toText(value)}, AXISCOMP_TEXT("Error", "0, 1 or -1"));
    return std::nullopt;
}

std::optional<NeutralTable> tableOf(const Entry& entry, const TextReading& reading)
{
    DiagnosticList& diagnostics = reading.diagnostics;
    for (const auto& [axis, suffix] :
        {std::pair(&entry.input, inputSuffix), std::pair(&entry.output, outputSuffix)})
        if (axis->empty())
            diagnostics.error(DiagnosticCode::Syntax, 0, 0, {},
                AXISCOMP_TEXT("Error", "{variable} of {curve}, which is missing")
                    .with("variable", std::string(prefix) + std::string(suffix))
                    .with("curve", entry.curve.label));
    const auto direction = directionOf(entry.curve, diagnostics);
    auto sampled = siemens::sample(entry.curve, diagnostics);
    if (!direction || !sampled)
        return std::nullopt;
    if (entry.curve.value(siemens::Curve::MultBy) != 0.0)
        diagnostics.warning(DiagnosticCode::Assumption, entry.curve.lines[siemens::Curve::MultBy],
            0, AXISCOMP_TEXT("Error", "a product with another table"),
            AXISCOMP_TEXT("Error", "a table by itself; the product is left out"));
    NeutralTable table;
    table.sign = SignConvention::Command;
    table.name = entry.curve.label.english();
    SourceAxis& axis = table.axes.emplace_back(std::move(sampled->axis));
    axis.name = entry.input;
    axis.unit = siemens::unitOf(reading.settings, axis.name, axis.wrap.has_value());
    CompensationColumn& column = table.columns.emplace_back();
    column.target = entry.output;
    column.unit = sameLetters(entry.input, entry.output)
        ? axis.unit
        : siemens::unitOf(reading.settings, entry.output, false);
    column.direction = *direction;
    column.values = std::move(sampled->values);
    return table;
}

/// Adds a table, or its column to the one that holds the other direction.
void add(std::vector<NeutralTable>& tables, NeutralTable table)
{
    const Direction direction = table.columns.front().direction;
    for (NeutralTable& other : tables) {
        const bool isPair = direction != Direction::Both && other.columns.size() == 1
            && other.columns.front().direction != Direction::Both
            && other.columns.front().direction != direction && other.axes == table.axes
            && other.columns.front().target == table.columns.front().target;
        if (!isPair)
            continue;
        other.name += ", " + table.name;
        other.columns.push_back(std::move(table.columns.front()));
        if (direction == Direction::Positive)
            std::swap(other.columns[0], other.columns[1]);
        return;
    }
    tables.push_back(std::move(table));
}

/// With a table of one direction each by itself.
std::vector<NeutralTable> parseApart(TextReading& reading)
{
    Collector collector(reading.diagnostics);
    std::vector<std::string> notes;
    if (!siemens::readProgram(
            reading, notes, [&](const siemens::Assignment& said) { collector.take(said); }))
        return {};
    if (collector.entries().empty())
        reading.diagnostics.error(DiagnosticCode::Syntax, 0, 0, {},
            AXISCOMP_TEXT("Error", "variables {name}, of which there are none")
                .with("name", prefix));
    collector.checkSwitches();
    std::vector<NeutralTable> tables;
    for (const auto& [index, entry] : collector.entries())
        if (auto table = tableOf(entry, reading))
            tables.push_back(std::move(*table));
    if (!tables.empty())
        tables.front().notes = std::move(notes);
    return tables;
}

std::vector<NeutralTable> parse(TextReading& reading)
{
    std::vector<NeutralTable> tables;
    for (NeutralTable& table : parseApart(reading))
        add(tables, std::move(table));
    warnOfAddedTables(tables, reading.diagnostics);
    return tables;
}

Result<TableReading> readApart(std::string_view text, const TableReadOptions& options)
{
    return readText(siemens_cec::format().facts, text, options, parseApart);
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    return readText(siemens_cec::format().facts, text, options, parse);
}

Recognition recognise(std::string_view text)
{
    return siemens::recogniseProgram(text, prefix, otherPrefix);
}

/// The lines of one column as the table of this index.
std::string columnLines(const NeutralTable& table, const CompensationColumn& column,
    const std::string& index, const std::string& input, const std::string& output)
{
    constexpr std::string_view directions[] = {"0", "1", "-1"};
    const std::string subject = '[' + index + "]=";
    std::string text;
    for (std::size_t i = 0; i < column.values.size(); ++i)
        text.append(prefix)
            .append('[' + index + ',' + std::to_string(i) + "]=")
            .append(plainNumber(column.values[i]) + '\n');
    const auto add = [&](std::string_view suffix, std::string_view value) {
        text.append(prefix).append(suffix).append(subject).append(value).append("\n");
    };
    add(inputSuffix, '(' + input + ')');
    add(outputSuffix, '(' + output + ')');
    text += siemens::gridLines(table.axes[0], prefix, index);
    add("_DIRECTION", directions[static_cast<std::size_t>(column.direction)]);
    add("_MULT_BY_TABLE", "0");
    return text;
}

/// Collects what the tables of one file become.
class Writer {
public:
    explicit Writer(const SettingValues& given)
        : m_given(given)
        , m_index(given.whole("first-table"))
    {
    }

    [[nodiscard]] Result<void> add(const NeutralTable& source);
    [[nodiscard]] Result<WrittenTables> finish();

private:
    const SettingValues& m_given;
    std::int64_t m_index = 0;
    std::vector<std::size_t> m_columns; ///< of each table
    WrittenTables m_written{.bytes = "CHANDATA(1)\n", .held = {}, .remarks = {}};
    std::string m_rotary;
};

Result<void> Writer::add(const NeutralTable& source)
{
    const FormatFacts& facts = siemens_cec::format().facts;
    if (!m_given.has("output-axis"))
        AXISCOMP_CHECK(checkTargets(source));
    const auto input = siemens::axisName(facts, m_given, "input-axis", source.axes[0].name);
    const auto output = siemens::axisName(
        facts, m_given, "output-axis", targetName(source, source.columns.front()));
    if (!input || !output)
        return fail(input ? output.error() : input.error());
    AXISCOMP_TRY(const auto table, inUnits(source, "mm", "deg", m_written.remarks));
    if (auto fits = siemens::checkModulo(facts, table); !fits)
        return fits;
    if (table.axes[0].unit == "deg")
        m_rotary += *input + ',';
    if (table.columns[0].unit == "deg")
        m_rotary += *output + ',';
    m_written.bytes += noteLines(table, "; ");
    m_columns.push_back(table.columns.size());
    for (const CompensationColumn& column : table.columns) {
        if (m_index < 0 || m_index >= mostTables)
            return cannotHold(facts,
                AXISCOMP_TEXT("Error", "there is no table {number}").with("number", m_index),
                AXISCOMP_TEXT("Error", "choose fewer tables, or another first-table"));
        const std::string index = std::to_string(m_index++);
        m_written.bytes += columnLines(table, column, index, *input, *output);
        m_written.remarks.push_back(AXISCOMP_TEXT("Error",
            "table {index} needs $MN_MM_CEC_MAX_POINTS[{index}] (MD18342) of at least {count}; "
            "switch it on with $SN_CEC_TABLE_ENABLE[{index}] (SD41300) 1 and $MA_CEC_ENABLE "
            "(MD32710) 1 of axis {axis}")
                                        .with("index", index)
                                        .with("count", column.values.size())
                                        .with("axis", *output));
    }
    return {};
}

Result<WrittenTables> Writer::finish()
{
    m_written.bytes += "M17\n";
    FormatSettings reading;
    if (!m_rotary.empty())
        reading["rotary-axes"] = m_rotary;
    // Two tables of different directions are not one because a reader would take them for it.
    TableFormat format = siemens_cec::format();
    format.read = readApart;
    AXISCOMP_TRY(auto apart, readBack(format, m_written.bytes, std::move(reading)));
    std::size_t next = 0;
    for (const std::size_t columns : m_columns) {
        NeutralTable& table = m_written.held.emplace_back(std::move(apart[next++]));
        for (std::size_t n = 1; n < columns; ++n, ++next) {
            table.name += ", " + apart[next].name;
            table.columns.push_back(std::move(apart[next].columns.front()));
        }
    }
    return std::move(m_written);
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    AXISCOMP_TRY(
        const auto given, SettingValues::of(siemens_cec::format().facts, options.settings, true));
    Writer writer(given);
    for (const NeutralTable& table : tables)
        AXISCOMP_CHECK(writer.add(table));
    return writer.finish();
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "siemens-cec",
            .controller = "Siemens SINUMERIK",
            .description = AXISCOMP_TEXT("Error", "sag and angularity compensation ($AN_CEC)"),
            .extensions = extensions,
            .knots = KnotRule::Even,
            .mostTables = 0,
            .addsTables = true,
            .holdsNames = true,
            .holdsUnits = true,
            .holdsNotes = true,
            .holdsDirections = true,
            .holdsWrap = true,
            .numbers = "decimal text",
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

} // namespace axiscomp::siemens_cec
