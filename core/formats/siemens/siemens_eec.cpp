// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"
#include "core/formats/siemens/siemens_program.h"
#include "core/formats/units.h"
#include "core/text/text_file.h"

#include <algorithm>
#include <set>

namespace axiscomp::siemens_eec {

namespace {

constexpr std::string_view prefix = "$AA_ENC_COMP";
constexpr std::string_view otherPrefix = "$AN_CEC";
constexpr std::string_view axisSwitch = "$MA_ENC_COMP_ENABLE";
constexpr std::string_view encoderWords = ", encoder "; ///< in the name of a table

constexpr std::array<std::string_view, 3> extensions{".ini", ".mpf", ".spf"};
constexpr std::array settings{siemens::rotaryAxes,
    FormatSetting{.key = "axis",
        .kind = FormatSetting::Kind::Text,
        .meaning = AXISCOMP_TEXT(
            "Error", "name of the machine axis, such as X1, instead of the table's name for it"),
        .forWriting = true,
        .namedAxis = AxisOfTable::source(0)},
    FormatSetting{.key = "encoder",
        .kind = FormatSetting::Kind::Choice,
        .meaning = AXISCOMP_TEXT("Error",
            "measuring system of the axis, instead of that of the program that was read, or 0"),
        .choices = "0, 1",
        .forWriting = true}};

constexpr std::array<std::string_view, 8> rules{
    "A part program assigns $AA_ENC_COMP[encoder,point,axis], with _STEP, _MIN, _MAX and "
    "_IS_MODULO[encoder,axis]; CHANDATA(1) in front, M17 at the end, ; begins a comment.",
    "Point 0 lies at MIN, the last one at MAX; there are (MAX - MIN) / STEP + 1 of them.",
    "Positions and values are in mm, of rotary axes in degrees.",
    "A value is added to the actual position: a positive one moves the axis in negative "
    "direction.",
    "Between the points the value is linear; outside, that at the nearest end is held.",
    "IS_MODULO 1: MIN follows MAX, and both values should be the same.",
    "A file may hold the tables of several axes and measuring systems.",
    "$MA_ENC_COMP_ENABLE[encoder,axis] that is 0 in the end switches the table off, which is a "
    "warning.",
};
constexpr std::array<std::string_view, 3> assumptions{
    "The basic system is metric.",
    "A program without IS_MODULO has 0.",
    "Points that a program leaves out keep what the control had there, so they are an error.",
};

struct Owner {
    std::int64_t encoder = 0;
    std::string axis;
};
struct Entry {
    Owner owner;
    siemens::Curve curve;
};

/// What the assignments of a program say, axis by axis.
class Collector {
public:
    explicit Collector(DiagnosticList& diagnostics) : m_diagnostics(diagnostics) { }

    void take(const siemens::Assignment& said);
    void checkSwitches();
    [[nodiscard]] const std::vector<Entry>& entries() const { return m_entries; }

private:
    [[nodiscard]] siemens::Curve* curveOf(const Token& encoder, const Token& axis);

    DiagnosticList& m_diagnostics;
    std::vector<Entry> m_entries;
    siemens::Switches m_switches;
    std::size_t m_latest = 0;
    bool m_hasOther = false;
};

siemens::Curve* Collector::curveOf(const Token& encoder, const Token& axis)
{
    const auto number = readWholeNumber(
        encoder, AXISCOMP_TEXT("Error", "the measuring system, 0 or 1"), m_diagnostics);
    if (!number)
        return nullptr;
    const auto isIt = [&](const Entry& entry) {
        return entry.owner.encoder == *number && sameLetters(entry.owner.axis, axis.text);
    };
    if (m_latest < m_entries.size() && isIt(m_entries[m_latest]))
        return &m_entries[m_latest].curve;
    constexpr std::size_t mostTables = 200; // more axes than any control has
    const auto found = std::ranges::find_if(m_entries, isIt);
    m_latest = static_cast<std::size_t>(found - m_entries.begin());
    if (found != m_entries.end())
        return &found->curve;
    if (*number < 0 || *number > 1 || !axis || m_entries.size() == mostTables) {
        m_diagnostics.error(DiagnosticCode::LimitExceeded, encoder.line, encoder.column,
            AXISCOMP_TEXT("Error", "measuring system {number} of axis {axis}")
                .with("number", *number)
                .with("axis", Verbatim{excerpt(axis.text, Encoding::Utf8)}),
            AXISCOMP_TEXT("Error", "0 or 1, and the name of an axis, at most {number} of them")
                .with("number", mostTables));
        return nullptr;
    }
    Entry entry{{*number, std::string(axis.text)}, {}};
    entry.curve.label = AXISCOMP_TEXT("Error", "axis {axis}, encoder {number}")
                            .with("axis", toUtf8(axis.text, Encoding::Utf8))
                            .with("number", *number);
    entry.curve.prefix = prefix;
    m_entries.push_back(std::move(entry));
    return &m_entries.back().curve;
}

/// Of the last switch of each table: a program begins with 0 and ends with 1.
void Collector::checkSwitches()
{
    for (const Entry& entry : m_entries)
        m_switches.check(
            axisSwitch, {std::to_string(entry.owner.encoder), entry.owner.axis}, m_diagnostics);
    m_switches.reportOthers(m_diagnostics);
}

void Collector::take(const siemens::Assignment& said)
{
    if (m_switches.take(said, axisSwitch, 2))
        return;
    const std::string_view name = said.name.text;
    const bool isOwn =
        name.size() >= prefix.size() && sameLetters(name.substr(0, prefix.size()), prefix);
    const bool isPoint = isOwn && name.size() == prefix.size();
    const auto variable =
        isOwn ? siemens::variableOf(name.substr(prefix.size())) : siemens::Curve::variableCount;
    if (!isPoint && variable > siemens::Curve::IsModulo) {
        const bool isOther = name.size() >= otherPrefix.size()
            && sameLetters(name.substr(0, otherPrefix.size()), otherPrefix);
        if (isOther && !m_hasOther)
            m_diagnostics.warning(DiagnosticCode::Assumption, said.name.line, said.name.column,
                AXISCOMP_TEXT("Error", "tables {name} besides {other}")
                    .with("name", otherPrefix)
                    .with("other", prefix),
                AXISCOMP_TEXT("Error", "the format {format} to read them; they are left out here")
                    .with("format", siemens_cec::format().facts.name));
        else if (!isOther)
            m_diagnostics.warning(DiagnosticCode::UnknownKey, said.name.line, said.name.column,
                Verbatim{excerpt(name, Encoding::Utf8)}, {});
        m_hasOther = m_hasOther || isOther;
        return;
    }
    const std::size_t wanted = isPoint ? 3 : 2;
    if (said.arguments.size() != wanted) {
        m_diagnostics.error(DiagnosticCode::Syntax, said.name.line, said.name.column,
            Verbatim{excerpt(name, Encoding::Utf8)},
            isPoint ? AXISCOMP_TEXT("Error", "three indices: [encoder,point,axis]")
                    : AXISCOMP_TEXT("Error", "two indices: [encoder,axis]"));
        return;
    }
    siemens::Curve* const curve = curveOf(said.arguments.front(), said.arguments.back());
    if (curve && isPoint)
        siemens::addPoint(*curve, said.arguments[1], said.value, m_diagnostics);
    else if (curve)
        siemens::setVariable(*curve, variable, said, m_diagnostics);
}

std::vector<NeutralTable> parse(TextReading& reading)
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
    for (const Entry& entry : collector.entries()) {
        auto sampled = siemens::sample(entry.curve, reading.diagnostics);
        if (!sampled)
            continue;
        NeutralTable table;
        table.sign = SignConvention::Feedback;
        table.name =
            entry.owner.axis + std::string(encoderWords) + std::to_string(entry.owner.encoder);
        SourceAxis& axis = table.axes.emplace_back(std::move(sampled->axis));
        axis.name = entry.owner.axis;
        axis.unit = siemens::unitOf(reading.settings, axis.name, axis.wrap.has_value());
        CompensationColumn& column = table.columns.emplace_back();
        column.target = axis.name;
        column.unit = axis.unit;
        column.values = std::move(sampled->values);
        tables.push_back(std::move(table));
    }
    if (!tables.empty())
        tables.front().notes = std::move(notes);
    return tables;
}

Result<TableReading> read(std::string_view text, const TableReadOptions& options)
{
    return readText(siemens_eec::format().facts, text, options, parse);
}

Recognition recognise(std::string_view text)
{
    return siemens::recogniseProgram(text, prefix, otherPrefix);
}

/// The measuring system that a table was read for, which its name says; not that of a table that
/// was in another file meanwhile.
std::string encoderOf(const NeutralTable& table, const std::string& axis,
    const SettingValues& given, std::vector<Text>& remarks)
{
    if (given.has("encoder"))
        return given.text("encoder");
    for (const char* encoder : {"0", "1"})
        if (table.name.ends_with(std::string(encoderWords) + encoder))
            return encoder;
    remarks.push_back(AXISCOMP_TEXT("Error",
        "nothing says for which measuring system of axis {axis} the table is: it is written for 0; "
        "the setting {key} states another one")
                          .with("axis", axis)
                          .with("key", std::string_view("encoder")));
    return "0";
}

/// The lines of one table; axis: its name in the program.
Result<std::string> tableLines(const NeutralTable& source, const std::string& axis,
    const std::string& encoder, std::vector<Text>& remarks, std::string& rotary)
{
    const FormatFacts& facts = siemens_eec::format().facts;
    AXISCOMP_CHECK(checkOwnAxis(facts, source,
        AXISCOMP_TEXT("Error", "write it as {format}")
            .with("format", siemens_cec::format().facts.name)));
    AXISCOMP_TRY(const auto table, inUnits(source, "mm", "deg", remarks));
    AXISCOMP_CHECK(siemens::checkModulo(facts, table));
    if (table.axes[0].unit != table.columns[0].unit)
        return cannotHold(facts,
            AXISCOMP_TEXT("Error", "its positions and values are not both lengths or both angles"),
            AXISCOMP_TEXT("Error", "check the units of the table"));
    if (table.axes[0].unit == "deg")
        rotary += (rotary.empty() ? "" : ",") + axis;
    std::string text = noteLines(table, "; ");
    const std::vector<double>& values = table.columns[0].values;
    for (std::size_t i = 0; i < values.size(); ++i)
        text.append(prefix)
            .append("[" + encoder + ',' + std::to_string(i) + ',' + axis + "]=")
            .append(plainNumber(values[i]) + '\n');
    text += siemens::gridLines(table.axes[0], prefix, encoder + ',' + axis);
    remarks.push_back(AXISCOMP_TEXT("Error",
        "axis {axis} needs $MA_MM_ENC_COMP_MAX_POINTS (MD38000) of at least {count}; load the file "
        "with $MA_ENC_COMP_ENABLE (MD32700) 0, then set it to 1")
                          .with("axis", axis)
                          .with("count", values.size()));
    return text;
}

Result<WrittenTables> write(std::span<const NeutralTable> tables, const TableWriteOptions& options)
{
    const TableFormat& format = siemens_eec::format();
    AXISCOMP_TRY(const auto given, SettingValues::of(format.facts, options.settings, true));
    WrittenTables written;
    written.bytes = "CHANDATA(1)\n";
    std::set<std::string> owners;
    std::string rotary;
    for (const NeutralTable& table : tables) {
        AXISCOMP_TRY(const auto axis,
            siemens::axisName(format.facts, given, "axis", table.axes.front().name));
        const std::string encoder = encoderOf(table, axis, given, written.remarks);
        if (!owners.insert(encoder + ',' + axis).second)
            return cannotHold(format.facts,
                AXISCOMP_TEXT("Error", "there are two tables for axis {axis}").with("axis", axis),
                AXISCOMP_TEXT("Error", "choose one of them"));
        AXISCOMP_TRY(auto text, tableLines(table, axis, encoder, written.remarks, rotary));
        written.bytes += text;
    }
    written.bytes += "M17\n";
    FormatSettings reading;
    if (!rotary.empty())
        reading["rotary-axes"] = rotary;
    AXISCOMP_TRY(auto held, readBack(format, written.bytes, std::move(reading)));
    written.held = std::move(held);
    return written;
}

} // namespace

const TableFormat& format()
{
    static const TableFormat format{
        .facts = {.name = "siemens-eec",
            .controller = "Siemens SINUMERIK",
            .description =
                AXISCOMP_TEXT("Error", "encoder and leadscrew error compensation ($AA_ENC_COMP)"),
            .extensions = extensions,
            .knots = KnotRule::Even,
            .mostTables = 0,
            .holdsNames = true,
            .holdsUnits = true,
            .holdsNotes = true,
            .holdsWrap = true,
            .numbers = "decimal text",
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

} // namespace axiscomp::siemens_eec
