// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/isg/isg_list.h"

#include "core/text/text_file.h"

#include <algorithm>

namespace axiscomp::isg {

namespace {

constexpr std::string_view axisKeys[] = {"kopf.achs_nr", "kopf.log_achs_nr"};
constexpr std::string_view nameKey = "kopf.log_achs_name";
constexpr std::string_view sections[] = {"crosscomp", "crosscomp2", "ssfk"};
constexpr char blanks[] = " \t";
constexpr std::string_view bodyPrefix = "kw.";

Verbatim quoted(std::string_view text)
{
    return {excerpt(text, Encoding::Utf8)};
}

/// "crosscomp" of "kw.crosscomp.unit"; empty for other entries.
std::string_view sectionOf(std::string_view path)
{
    if (!path.starts_with(bodyPrefix))
        return {};
    path.remove_prefix(bodyPrefix.size());
    return path.substr(0, path.find('.'));
}

constexpr std::string_view pointsKey = "table";

} // namespace

/// Empty also where an index is part of the section.
std::string_view List::Name::section() const
{
    const std::string_view found = sectionOf(base);
    const bool isWhole = indices == 0 || base.find('.', bodyPrefix.size()) != base.npos;
    return isWhole ? found : std::string_view();
}

std::string List::path(std::string_view key) const
{
    return "kw." + std::string(m_section.name) + '.' + std::string(key);
}

bool List::readName(const Token& line, Name& name) const
{
    const std::string_view text = line.text;
    name.indices = 0;
    const auto plainEnd = [&](std::size_t begin) {
        constexpr CharacterSet ends(" \t[");
        return begin + ends.findIn(text.substr(begin), line.readableEnd());
    };
    std::size_t i = plainEnd(0);
    name.base = text.substr(0, i);
    std::size_t behindPoint = std::string_view::npos;
    bool isAdjacent = true; // each index follows the base or another index
    while (i < text.size() && text[i] == '[') {
        const std::size_t end = text.find(']', i);
        const auto inside = end == std::string_view::npos
            ? std::string_view()
            : trimmed(text.substr(i + 1, end - i - 1));
        const auto index = wholeNumberOf(inside);
        if (!index || *index < 0 || name.indices == name.index.size()) {
            m_diagnostics.error(DiagnosticCode::Syntax, line.line, line.column + i,
                quoted(text.substr(i)),
                AXISCOMP_TEXT("Error", "an index from 0 such as [3], at most two of them"));
            return false;
        }
        name.index[name.indices++] = *index;
        i = end + 1;
        if (isAdjacent && name.indices == m_section.indices)
            behindPoint = i;
        if (i < text.size() && text[i] == '[')
            continue;
        isAdjacent = false;
        i = plainEnd(i);
    }
    name.whole = line.part(0, i);
    name.behindPoint = name.whole.text.substr(std::min(behindPoint, i));
    return true;
}

void List::takeForeign(std::string_view sectionName, const Token& name)
{
    const std::string section(sectionName);
    const bool isSection = std::ranges::find(sections, section) != std::end(sections);
    if (!isSection) {
        m_diagnostics.warning(
            DiagnosticCode::UnknownKey, name.line, name.column, quoted(name.text), {});
        return;
    }
    if (std::ranges::find(m_foreign, section) != m_foreign.end())
        return;
    m_foreign.push_back(section);
    m_diagnostics.warning(DiagnosticCode::Assumption, name.line, name.column,
        AXISCOMP_TEXT("Error", "a table kw.{name} besides kw.{other}")
            .with("name", section)
            .with("other", m_section.name),
        AXISCOMP_TEXT("Error", "the format {format} to read it; it is left out here")
            .with("format", "isg-" + section));
}

void List::takeCell(std::string_view field, const Name& name, const Token& value)
{
    if (field == "sollw") // the older name
        field = "setpoint";
    const auto found = std::ranges::find(m_section.fields, field);
    if (found == m_section.fields.end()) {
        m_diagnostics.warning(DiagnosticCode::UnknownKey, name.whole.line, name.whole.column,
            quoted(name.whole.text), {});
        return;
    }
    Cell& cell = m_cells.emplace_back();
    cell.field = static_cast<std::size_t>(found - m_section.fields.begin());
    cell.index =
        m_section.indices == 2 ? name.index : std::array<std::int64_t, 2>{0, name.index[0]};
    cell.name = name.whole;
    cell.value = value;
}

void List::takeLine(const Token& line, Name& name)
{
    if (!readName(line, name))
        return;
    const Token value = trimmedToken(line.part(name.whole.text.size()));
    const auto syntaxError = [&](Text expected) {
        m_diagnostics.error(DiagnosticCode::Syntax, line.line, line.column, quoted(name.whole.text),
            std::move(expected));
    };
    const bool hasIndex = name.indices > 0;
    if (m_hasEnded) {
        syntaxError(AXISCOMP_TEXT("Error", "nothing after End"));
        m_hasEnded = false;
        return;
    }
    if (!hasIndex && sameLetters(name.base, "end")) {
        m_hasEnded = true;
        return;
    }
    const bool isHead = !hasIndex
        && (name.base == nameKey || std::ranges::find(axisKeys, name.base) != std::end(axisKeys));
    const bool isOwn = name.section() == m_section.name;
    if (!isHead && !isOwn) {
        takeForeign(name.section(), name.whole);
        return;
    }
    if (!value) {
        syntaxError(AXISCOMP_TEXT("Error", "a value behind the name and a blank"));
        return;
    }
    std::string_view key = name.base;
    if (isOwn)
        key.remove_prefix(std::min(key.size(), bodyPrefix.size() + m_section.name.size() + 1));
    if (!isOwn || !hasIndex)
        takeEntry(key, {name.whole, value}, isHead);
    else if (key != pointsKey)
        takeForeign({}, name.whole);
    else if (name.behindPoint.starts_with('.'))
        takeCell(name.behindPoint.substr(1), name, value);
    else
        syntaxError(
            (m_section.indices == 2 ? AXISCOMP_TEXT("Error", "a point kw.{point} with two indices")
                                    : AXISCOMP_TEXT("Error", "a point kw.{point} with one index"))
                .with("point",
                    std::string(m_section.name)
                        + (m_section.indices == 2 ? ".table[][]." : ".table[].")));
}

void List::takeEntry(std::string_view key, const Entry& entry, bool isHead)
{
    if (!isHead && std::ranges::find(m_section.keys, key) == m_section.keys.end()) {
        takeForeign({}, entry.name);
        return;
    }
    const auto [place, isNew] = m_entries.emplace(key, entry);
    if (!isNew)
        m_diagnostics.error(DiagnosticCode::Contradiction, entry.name.line, entry.name.column,
            AXISCOMP_TEXT("Error", "{what} a second time").with("what", entry.name.text),
            AXISCOMP_TEXT("Error", "each entry once; the first is in line {line}")
                .with("line", place->second.name.line));
}

bool List::parse(std::string_view text, const std::stop_token& stop)
{
    TextLines lines(text);
    Name name;
    while (const auto whole = lines.next()) {
        const Token line = trimmedToken(*whole);
        if (!line)
            continue;
        if (stop.stop_requested())
            return false;
        if (line.text.front() != '#')
            takeLine(line, name);
        else if (const auto note = line.text.find_first_not_of("#* \t"); note != line.text.npos)
            keepNote(m_notes, line.text.substr(note));
    }
    const bool isEmpty = m_cells.empty() && std::ranges::none_of(m_entries, [](const auto& entry) {
        return !entry.first.starts_with("kopf.");
    });
    if (isEmpty)
        m_diagnostics.error(DiagnosticCode::Syntax, 0, 0, {},
            AXISCOMP_TEXT("Error", "a table kw.{name}, of which there is no entry")
                .with("name", m_section.name));
    return !isEmpty;
}

const List::Entry* List::find(std::string_view key) const
{
    const auto found = m_entries.find(key);
    return found == m_entries.end() ? nullptr : &found->second;
}

bool List::has(std::string_view key) const
{
    return find(key) != nullptr;
}

bool List::hasField(std::string_view field) const
{
    return std::ranges::any_of(
        m_cells, [&](const Cell& cell) { return m_section.fields[cell.field] == field; });
}

std::size_t List::line(std::string_view key) const
{
    const Entry* const entry = find(key);
    return entry ? entry->name.line : 0;
}

std::string List::text(std::string_view key) const
{
    const Entry* const entry = find(key);
    if (!entry)
        return {};
    const std::string_view value = entry->value.text;
    return toUtf8(trimmed(value.substr(0, value.find('('))), Encoding::Utf8);
}

void List::missing(std::string_view key) const
{
    m_diagnostics.error(DiagnosticCode::Syntax, 0, 0, {},
        AXISCOMP_TEXT("Error", "the entry {name}, which is missing").with("name", path(key)));
}

std::optional<std::int64_t> List::whole(
    std::string_view key, std::int64_t least, std::int64_t most) const
{
    const Entry* const entry = find(key);
    if (!entry) {
        missing(key);
        return std::nullopt;
    }
    const Text range =
        AXISCOMP_TEXT("Error", "{number} to {number2}").with("number", least).with("number2", most);
    const Token word = firstToken(entry->value, blanks);
    const auto number = readWholeNumber(word,
        AXISCOMP_TEXT("Error", "a whole number, {range}").with("range", range), m_diagnostics);
    if (!number || (*number >= least && *number <= most))
        return number;
    m_diagnostics.error(DiagnosticCode::LimitExceeded, word.line, word.column,
        Verbatim{path(key) + ' ' + std::to_string(*number)}, range);
    return std::nullopt;
}

std::optional<double> List::number(std::string_view key) const
{
    const Entry* const entry = find(key);
    if (entry)
        return readNumber(firstToken(entry->value, blanks),
            AXISCOMP_TEXT("Error", "the number of {key}").with("key", path(key)), m_diagnostics);
    missing(key);
    return std::nullopt;
}

std::optional<bool> List::flag(std::string_view key, bool standard) const
{
    if (!has(key)) {
        m_diagnostics.warning(DiagnosticCode::Assumption, 0, 0,
            AXISCOMP_TEXT("Error", "no entry {name}").with("name", path(key)),
            standard ? AXISCOMP_TEXT("Error", "0 or 1; 1 is assumed")
                     : AXISCOMP_TEXT("Error", "0 or 1; 0 is assumed"));
        return standard;
    }
    const auto number = whole(key, 0, 1);
    return number ? std::optional(*number == 1) : std::nullopt;
}

std::string List::axisNumber() const
{
    const Entry* const first = find(axisKeys[0]);
    const Entry* const second = find(axisKeys[1]);
    const Entry* const entry = first ? first : second;
    if (!entry)
        return {};
    const Token word = firstToken(entry->value, blanks);
    const auto number = readWholeNumber(
        word, AXISCOMP_TEXT("Error", "the logical number of the axis, from 1"), m_diagnostics);
    if (first && second && word.text != firstToken(second->value, blanks).text)
        m_diagnostics.error(DiagnosticCode::Contradiction, second->name.line, 0,
            Verbatim{"kopf.log_achs_nr " + quoted(firstToken(second->value, blanks).text).text},
            AXISCOMP_TEXT("Error", "{value}, as {key} says")
                .with("value", quoted(word.text))
                .with("key", axisKeys[0]));
    return number ? std::to_string(*number) : std::string();
}

bool List::checkMostPoints(std::size_t points, std::size_t standard) const
{
    auto most = static_cast<std::int64_t>(standard);
    if (has("max_points")) {
        const auto given = whole("max_points", 0, 2147483647);
        if (!given)
            return false;
        if (*given > 0) // 0 means the standard value
            most = *given;
    }
    if (points <= static_cast<std::size_t>(most))
        return true;
    m_diagnostics.error(DiagnosticCode::LimitExceeded, line("max_points"), 0,
        AXISCOMP_COUNTED("Error", "{count} points", "1 point").with("count", points),
        (has("max_points")
                ? AXISCOMP_TEXT("Error", "at most {number}, which is {name}")
                : AXISCOMP_TEXT("Error", "at most {number}, which is the standard value of {name}"))
            .with("number", most)
            .with("name", path("max_points")));
    return false;
}

std::optional<Field> List::field(std::string_view name, std::array<std::size_t, 2> sizes) const
{
    const auto at = static_cast<std::size_t>(
        std::ranges::find(m_section.fields, name) - m_section.fields.begin());
    const std::size_t total = sizes[0] * sizes[1];
    const auto given = static_cast<std::size_t>(std::ranges::count(m_cells, at, &Cell::field));
    // No more than the file has is ever allocated: one of the first given + 1 points is missing.
    const std::size_t seenSize = std::min(total, given + 1);
    std::vector<bool> seen(seenSize, false);
    Field field;
    field.numbers.resize(seenSize);
    field.lines.resize(seenSize);
    bool isGood = true;
    for (const Cell& cell : m_cells) {
        if (cell.field != at)
            continue;
        const auto j = static_cast<std::size_t>(cell.index[0]);
        const auto i = static_cast<std::size_t>(cell.index[1]);
        const std::size_t offset = j * sizes[1] + i;
        const bool isBeyond = j >= sizes[0] || i >= sizes[1];
        if (isBeyond || (offset < seenSize && seen[offset])) {
            isGood = false;
            m_diagnostics.error(
                isBeyond ? DiagnosticCode::Contradiction : DiagnosticCode::DuplicatePoint,
                cell.name.line, cell.name.column,
                isBeyond ? Text(quoted(cell.name.text))
                         : AXISCOMP_TEXT("Error", "{what} a second time")
                               .with("what", quoted(cell.name.text)),
                isBeyond ? AXISCOMP_TEXT("Error", "indices within the size that the list says")
                         : AXISCOMP_TEXT("Error", "each point once"));
            continue;
        }
        const auto number = readNumber(
            firstToken(cell.value, blanks), AXISCOMP_TEXT("Error", "a number"), m_diagnostics);
        isGood = isGood && number;
        if (offset >= seenSize)
            continue;
        seen[offset] = true;
        field.numbers[offset] = number.value_or(0.0);
        field.lines[offset] = cell.name.line;
    }
    const auto hole = std::ranges::find(seen, false);
    if (hole == seen.end())
        return isGood ? std::optional(std::move(field)) : std::nullopt;
    const auto offset = static_cast<std::size_t>(hole - seen.begin());
    const std::string j =
        m_section.indices == 2 ? '[' + std::to_string(offset / sizes[1]) + ']' : "";
    m_diagnostics.error(DiagnosticCode::MissingPoint, 0, 0,
        AXISCOMP_TEXT("Error", "no {name}")
            .with("name",
                path("table") + j + '[' + std::to_string(offset % sizes[1]) + "]."
                    + std::string(name)),
        AXISCOMP_TEXT("Error", "{number} of them; there are {number2}")
            .with("number", total)
            .with("number2", given));
    return std::nullopt;
}

std::vector<NeutralTable> readSection(
    const TextReading& reading, const Section& section, Build build)
{
    List list(section, reading.diagnostics);
    if (!list.parse(reading.text, reading.options.stop))
        return {};
    auto table = build(list, reading.settings);
    if (!table)
        return {};
    table->name = list.text(nameKey);
    table->notes = list.takeNotes();
    for (const std::string_view key : keptKeys)
        if (list.has(key))
            table->notes.push_back(std::string(key) + ' ' + list.text(key));
    return {std::move(*table)};
}

Recognition recogniseList(const Section& section, std::string_view text)
{
    bool hasOwn = false;
    bool hasOther = false;
    TextLines lines(text);
    while (const auto whole = lines.next()) {
        const std::string_view name = sectionOf(trimmedToken(*whole).text);
        if (name == section.name)
            hasOwn = true;
        else if (std::ranges::find(sections, name) != std::end(sections))
            hasOther = true;
    }
    if (!hasOwn)
        return Recognition::No;
    return hasOther ? Recognition::Possible : Recognition::Certain;
}

} // namespace axiscomp::isg
