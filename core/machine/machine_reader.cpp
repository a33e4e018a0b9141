// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"
#include "core/io/local_file.h"
#include "core/machine/machine_file.h"
#include "core/table/position_unit.h"
#include "core/text/edit_distance.h"
#include "core/text/number_text.h"
#include "core/text/token_scanner.h"
#include "core/text/utf8.h"

// No exception leaves a part, and none is needed.
#define TOML_EXCEPTIONS 0
#define TOML_HEADER_ONLY 1
#include <toml++/toml.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <span>

namespace axiscomp {

namespace {

constexpr std::size_t mostProblems = 100;
constexpr std::int64_t machineVersion = 1;

std::string shownWord(std::string_view text)
{
    return shownText(text);
}

/// The value as people wrote it, near enough to be found.
std::string writtenText(const toml::node& node)
{
    if (const auto text = node.value_exact<std::string>())
        return shownWord(*text);
    if (const auto number = node.value_exact<std::int64_t>())
        return std::to_string(*number);
    if (const auto number = node.value_exact<double>())
        return toText(*number);
    if (const auto flag = node.value_exact<bool>())
        return *flag ? "true" : "false";
    return node.is_array() ? "[...]" : node.is_table() ? "{...}" : "...";
}

/// One table of the file: its entries are asked for by their keys, and what was not asked for is
/// an error at the end.
class Entries {
public:
    Entries(const toml::table& table, DiagnosticList& problems)
        : m_table(table)
        , m_problems(problems)
    {
    }

    [[nodiscard]] const toml::node* find(std::string_view key)
    {
        m_known.push_back(key);
        return m_table.get(key);
    }
    [[nodiscard]] const toml::node* need(std::string_view key)
    {
        const toml::node* node = find(key);
        if (!node)
            error(m_table, {}, AXISCOMP_TEXT("Problem", "an entry {key}").with("key", key));
        return node;
    }
    void error(const toml::node& place, std::string found, Text expected)
    {
        const toml::source_position begin = place.source().begin;
        m_problems.error(DiagnosticCode::Syntax, begin.line, begin.column,
            found.empty() ? Text() : Text(Verbatim{std::move(found)}), std::move(expected));
    }
    void wrong(const toml::node& node, Text expected)
    {
        error(node, writtenText(node), std::move(expected));
    }
    void contradiction(const toml::node& node, Text found)
    {
        const toml::source_position begin = node.source().begin;
        m_problems.error(
            DiagnosticCode::Contradiction, begin.line, begin.column, std::move(found), {});
    }

    /// Not empty, without control characters.
    [[nodiscard]] std::optional<std::string> textOf(const toml::node* node)
    {
        if (!node)
            return std::nullopt;
        auto text = node->value_exact<std::string>();
        const auto isControl = [](char c) { return (c >= 0 && c < ' ') || c == '\x7f'; };
        if (text && !text->empty() && std::ranges::none_of(*text, isControl))
            return text;
        wrong(*node, AXISCOMP_TEXT("Problem", "a text in quotation marks"));
        return std::nullopt;
    }
    [[nodiscard]] std::string text(std::string_view key)
    {
        return textOf(find(key)).value_or(std::string());
    }
    [[nodiscard]] std::optional<bool> flag(std::string_view key)
    {
        const toml::node* node = find(key);
        if (!node)
            return std::nullopt;
        const auto value = node->value_exact<bool>();
        if (!value)
            wrong(*node, AXISCOMP_TEXT("Problem", "true or false"));
        return value;
    }
    /// A name, or a number that may stand without quotation marks.
    [[nodiscard]] std::string nameOrNumber(const toml::node* node)
    {
        if (!node)
            return {};
        const auto number = node->value_exact<std::int64_t>();
        if (number && *number >= 0)
            return std::to_string(*number);
        if (number) {
            wrong(*node, AXISCOMP_TEXT("Problem", "a name or a number"));
            return {};
        }
        return textOf(node).value_or(std::string());
    }
    [[nodiscard]] std::string choice(
        std::string_view key, std::span<const std::string_view> choices)
    {
        const toml::node* node = find(key);
        const auto value = textOf(node);
        if (!value || std::ranges::find(choices, *value) != choices.end())
            return value.value_or(std::string());
        wrong(*node,
            AXISCOMP_TEXT("Problem", "one of {known}")
                .with("known", std::vector<std::string>(choices.begin(), choices.end())));
        return {};
    }
    /// The tables of [[key]].
    [[nodiscard]] std::vector<const toml::table*> tables(std::string_view key, std::size_t most)
    {
        const toml::node* node = need(key);
        if (!node)
            return {};
        std::vector<const toml::table*> found;
        if (const toml::array* array = node->as_array())
            for (const toml::node& element : *array)
                if (const toml::table* table = element.as_table())
                    found.push_back(table);
        const toml::array* array = node->as_array();
        if (found.empty() || found.size() != array->size())
            wrong(*node,
                AXISCOMP_TEXT("Problem", "sections that begin with [[{key}]]").with("key", key));
        if (found.size() > most) {
            error(*found[most], std::to_string(found.size()),
                AXISCOMP_TEXT("Problem", "at most {count} of them").with("count", most));
            found.resize(most);
        }
        return found;
    }

    /// Refuses what nobody asked for.
    void end()
    {
        for (auto&& [key, node] : m_table) {
            const std::string_view word = key.str();
            if (std::ranges::find(m_known, word) != m_known.end())
                continue;
            const auto nearest = std::ranges::min_element(
                m_known, {}, [&](std::string_view known) { return editDistance(word, known); });
            const toml::source_position begin = key.source().begin;
            m_problems.error(DiagnosticCode::Syntax, begin.line, begin.column,
                Verbatim{shownWord(word)},
                AXISCOMP_TEXT("Problem", "a known key; the nearest is {key}")
                    .with("key", *nearest));
        }
    }

private:
    const toml::table& m_table;
    DiagnosticList& m_problems;
    std::vector<std::string_view> m_known;
};

class MachineReader {
public:
    [[nodiscard]] MachineReading read(std::string_view text);

private:
    void readTop(const toml::table& table);
    void readDrive(const toml::table& table);
    void readAxis(const toml::table& table, MachineDrive& drive);
    void readSources(Entries& entries, MachineAxis& axis);
    void readSettings(Entries& entries, MachineAxis& axis);
    void readChoices(Entries& entries, MachineAxis& axis);
    void readTolerance(Entries& entries, MachineAxis& axis);
    void checkTable(Entries& entries, const toml::table& table, const MachineAxis& axis);
    /// That nothing else has this; place: where it is said again.
    void claim(Entries& entries, const toml::node* node, const std::string& what,
        std::map<std::string, std::size_t, std::less<>>& owners, const TextPattern& twice);

    using Owners = std::map<std::string, std::size_t, std::less<>>; ///< lines
    DiagnosticList m_problems{mostProblems};
    MachineFile m_machine;
    Owners m_endpoints;
    Owners m_serialNumbers;
    Owners m_axes; ///< of the drive that is being read
    Owners m_slots; ///< likewise
};

void MachineReader::claim(Entries& entries, const toml::node* node, const std::string& what,
    Owners& owners, const TextPattern& twice)
{
    if (!node || what.empty())
        return;
    const auto [owner, isNew] = owners.emplace(what, node->source().begin.line);
    if (!isNew)
        entries.contradiction(*node, twice.with("name", what).with("line", owner->second));
}

MachineReading MachineReader::read(std::string_view text)
{
    if (!isReadableText(text, maximumMachineFile, m_problems))
        return {std::nullopt, m_problems.take(), m_problems.suppressed()};
    const toml::parse_result parsed = toml::parse(text);
    if (parsed) {
        readTop(parsed.table());
    } else {
        const toml::source_position begin = parsed.error().source().begin;
        m_problems.error(DiagnosticCode::Syntax, begin.line, begin.column, {},
            AXISCOMP_TEXT("Problem", "valid TOML ({reason})")
                .with("reason", shownWord(parsed.error().description())));
    }
    MachineReading reading;
    if (!m_problems.hasErrors())
        reading.machine = std::move(m_machine);
    reading.suppressed = m_problems.suppressed();
    reading.diagnostics = m_problems.take();
    return reading;
}

void MachineReader::readTop(const toml::table& table)
{
    Entries entries(table, m_problems);
    if (const toml::node* version = entries.need("version"))
        if (version->value_exact<std::int64_t>() != machineVersion)
            entries.wrong(*version,
                AXISCOMP_TEXT("Problem", "{number}, the version of this format")
                    .with("number", machineVersion));
    m_machine.name = entries.text("name");
    for (const toml::table* drive : entries.tables("drive", mostMachineDrives))
        readDrive(*drive);
    entries.end();
}

void MachineReader::readDrive(const toml::table& table)
{
    Entries entries(table, m_problems);
    MachineDrive drive;
    drive.line = table.source().begin.line;
    m_axes.clear();
    m_slots.clear();
    const toml::node* endpoint = entries.need("endpoint");
    drive.endpoint = entries.textOf(endpoint).value_or(std::string());
    claim(entries, endpoint, drive.endpoint, m_endpoints,
        AXISCOMP_TEXT("Problem", "{name} is a drive in line {line} already"));
    if (const toml::node* serial = entries.need("serial")) {
        const auto number = serial->value_exact<std::int64_t>();
        if (!number || *number < std::numeric_limits<std::int32_t>::min()
            || *number > std::numeric_limits<std::int32_t>::max()) {
            entries.wrong(
                *serial, AXISCOMP_TEXT("Problem", "the serial number of the drive, as a number"));
        } else {
            drive.serialNumber = static_cast<std::int32_t>(*number);
            claim(entries, serial, std::to_string(*number), m_serialNumbers,
                AXISCOMP_TEXT("Problem", "serial number {name} is in line {line} already"));
        }
    }
    for (const toml::table* axis : entries.tables("axis", mostMachineAxes))
        readAxis(*axis, drive);
    entries.end();
    m_machine.drives.push_back(std::move(drive));
}

void MachineReader::readSources(Entries& entries, MachineAxis& axis)
{
    const toml::node* node = entries.find("sources");
    if (!node)
        return;
    constexpr std::size_t mostDimensions = 3;
    const toml::array* array = node->as_array();
    if (!array || array->size() > mostDimensions) {
        entries.wrong(*node, AXISCOMP_TEXT("Problem", "a list of one to three registers"));
        return;
    }
    axis.sources.emplace();
    for (const toml::node& element : *array) {
        // A dimension without a source, which only an axis without a table may have.
        const bool isGap = element.value_exact<std::string>() == std::string();
        axis.sources->push_back(
            isGap ? std::string() : entries.textOf(&element).value_or(std::string()));
    }
}

void MachineReader::readSettings(Entries& entries, MachineAxis& axis)
{
    const toml::node* node = entries.find("settings");
    if (!node)
        return;
    const toml::table* settings = node->as_table();
    if (!settings) {
        entries.wrong(*node,
            AXISCOMP_TEXT("Problem", "settings as {example}")
                .with("example", Verbatim{"{ key = \"value\" }"}));
        return;
    }
    for (auto&& [key, value] : *settings) {
        const bool isSimple = value.is_string() || value.is_integer() || value.is_floating_point()
            || value.is_boolean();
        if (!isSimple)
            entries.wrong(value, AXISCOMP_TEXT("Problem", "a text, a number, true or false"));
        else if (const auto text = value.value_exact<std::string>())
            axis.choices.settings[std::string(key.str())] = *text;
        else
            axis.choices.settings[std::string(key.str())] = writtenText(value);
    }
}

void MachineReader::readChoices(Entries& entries, MachineAxis& axis)
{
    static constexpr std::string_view signs[] = {"feedback", "command"};
    static constexpr std::string_view directions[] = {"mean", "positive", "negative"};
    std::vector<std::string_view> formats;
    for (const TableFormat* format : tableFormats())
        if (format->read || isTriamec(*format))
            formats.push_back(format->facts.name);
    if (const std::string name = entries.choice("format", formats); !name.empty())
        if (const auto format = formatNamed(name))
            axis.choices.format = *format;
    axis.choices.target = entries.text("target");
    if (const std::string sign = entries.choice("sign", signs); !sign.empty())
        axis.choices.sign = sign == signs[0] ? SignConvention::Feedback : SignConvention::Command;
    if (const std::string direction = entries.choice("direction", directions); !direction.empty())
        axis.choices.direction = direction == directions[0] ? DirectionChoice::Mean
            : direction == directions[1]                    ? DirectionChoice::Positive
                                                            : DirectionChoice::Negative;
    readSettings(entries, axis);
}

void MachineReader::readTolerance(Entries& entries, MachineAxis& axis)
{
    const toml::node* node = entries.find("tolerance");
    const auto text = entries.textOf(node);
    if (!text)
        return;
    const std::size_t blank = text->find(' ');
    const auto number = numberOf(text->substr(0, blank));
    const std::string unit = blank == std::string::npos ? "" : text->substr(blank + 1);
    if (number && std::isfinite(*number) && *number >= 0.0 && isPositionUnit(unit))
        axis.tolerance = ValueTolerance{*number, unit};
    else
        entries.wrong(*node,
            AXISCOMP_TEXT("Problem", "a number and its unit, such as {example}")
                .with("example", Verbatim{"0.1 um"}));
}

/// A table, or none: what is left out must not decide that.
void MachineReader::checkTable(Entries& entries, const toml::table& table, const MachineAxis& axis)
{
    const toml::node* none = table.get("no-table");
    if (axis.file.empty() && !table.contains("file")) {
        if (!none || !none->value_or(false))
            entries.error(table, {},
                AXISCOMP_TEXT("Problem",
                    "an entry file, or no-table = true for an axis that shall have none"));
        for (const std::string_view key :
            {"column", "format", "settings", "target", "sign", "direction", "value-unit",
                "position-unit", "persistent", "slot", "tolerance", "accept-large"})
            if (const toml::node* node = table.get(key))
                entries.contradiction(*node,
                    AXISCOMP_TEXT("Problem", "{key} of an axis without a table").with("key", key));
        if (const toml::node* active = table.get("active"); active && active->value_or(false))
            entries.contradiction(*active,
                AXISCOMP_TEXT("Problem", "{key} of an axis without a table")
                    .with("key", std::string_view("active")));
        return;
    }
    if (none && none->value_or(false))
        entries.contradiction(*none, AXISCOMP_TEXT("Problem", "no-table beside file"));
    if (!table.contains("sources") || (axis.sources && axis.sources->empty()))
        entries.error(table, {},
            AXISCOMP_TEXT("Problem",
                "an entry sources, with the register that looks the table up for each of its "
                "dimensions"));
}

void MachineReader::readAxis(const toml::table& table, MachineDrive& drive)
{
    Entries entries(table, m_problems);
    MachineAxis axis;
    axis.line = table.source().begin.line;
    const toml::node* name = entries.need("axis");
    axis.axis = entries.nameOrNumber(name);
    claim(entries, name, axis.axis, m_axes,
        AXISCOMP_TEXT("Problem", "axis {name} of this drive is in line {line} already"));
    axis.file = entries.text("file");
    static_cast<void>(entries.flag("no-table"));
    axis.column = entries.nameOrNumber(entries.find("column"));
    readSources(entries, axis);
    readChoices(entries, axis);
    axis.valueUnit = entries.text("value-unit");
    axis.positionUnit = entries.text("position-unit");
    if (entries.flag("persistent").value_or(false))
        axis.persistency = Persistency::Persistent;
    const toml::node* slot = entries.find("slot");
    axis.slot = entries.textOf(slot).value_or(std::string());
    std::string letters = axis.slot;
    std::ranges::transform(letters, letters.begin(),
        [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    claim(entries, slot, letters, m_slots,
        AXISCOMP_TEXT("Problem", "slot {name} is taken by the axis in line {line}"));
    axis.isActive = entries.flag("active");
    readTolerance(entries, axis);
    axis.acceptsLarge = entries.flag("accept-large").value_or(false);
    checkTable(entries, table, axis);
    entries.end();
    drive.axes.push_back(std::move(axis));
}

} // namespace

MachineReading readMachine(std::string_view text)
{
    return MachineReader().read(text);
}

Result<MachineReading> loadMachine(const std::filesystem::path& file)
{
    AXISCOMP_TRY(const auto bytes, loadFile(file, maximumMachineFile));
    return readMachine(asText(bytes));
}

Error machineError(const std::string& file, const MachineReading& reading)
{
    const auto errors =
        std::ranges::count(reading.diagnostics, Severity::Error, &Diagnostic::severity);
    return {ErrorCode::InvalidConfiguration,
        {{"file", Verbatim{file}}, {"machine", Verbatim{file}},
            {"count", static_cast<std::size_t>(errors) + reading.suppressed}},
        {}};
}

} // namespace axiscomp
