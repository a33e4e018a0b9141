// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/header.h"

#include "core/csv/fields.h"
#include "core/table/position_unit.h"
#include "core/text/utf8.h"

#include <algorithm>
#include <set>
#include <utility>

namespace axiscomp::csv {

namespace {

/// What a spreadsheet can have; keeps a line of separators from taking all memory.
constexpr std::size_t maximumColumns = 16384;

/// Where a name may say something else: C is an axis there, not a temperature.
bool isUnit(std::string_view text)
{
    return isPositionUnit(text) || (text.size() > 1 && isTemperatureUnit(text));
}

/// "X error (um)", "X error [um] (mean)"
std::optional<ColumnName> withUnitInBrackets(std::string_view text)
{
    for (const auto& [opening, closing] : {std::pair('[', ']'), {'(', ')'}, {'{', '}'}}) {
        const std::size_t close = text.rfind(closing);
        const std::size_t open = text.rfind(opening, close);
        if (close == std::string_view::npos || open == std::string_view::npos)
            continue;
        const std::string_view unit = trimmed(text.substr(open + 1, close - open - 1));
        if (isUnit(unit))
            return ColumnName{
                std::string(trimmed(text.substr(0, open))) + std::string(text.substr(close + 1)),
                std::string(unit)};
    }
    return std::nullopt;
}

/// With ( and ) for the full-width brackets of Japanese and Chinese texts.
std::string withPlainBrackets(std::string_view text)
{
    std::string plain(text);
    for (const auto& [wide, narrow] : {std::pair<std::string_view, char>("\uff08", '('),
             {"\uff09", ')'}, {"\uff3b", '('}, {"\uff3d", ')'}, {"\u3010", '('}, {"\u3011", ')'}})
        for (std::size_t at = plain.find(wide); at != std::string::npos; at = plain.find(wide, at))
            plain.replace(at, wide.size(), 1, narrow);
    return plain;
}

/// "x / mm" (ISO 80000-1), "X error in um"
std::optional<ColumnName> withUnitBehind(std::string_view text)
{
    for (const std::string_view word : {"/", " in "}) {
        const std::size_t at = text.rfind(word);
        if (at == std::string_view::npos)
            continue;
        const std::string_view unit = trimmed(text.substr(at + word.size()));
        if (isUnit(unit))
            return ColumnName{std::string(trimmed(text.substr(0, at))), std::string(unit)};
    }
    return std::nullopt;
}

/// What stands in brackets at the end of a name: "furlong" of "X (furlong)".
std::string_view lastBrackets(std::string_view plain)
{
    const std::size_t open = plain.find_last_of("({");
    if (open == std::string_view::npos || !(plain.ends_with(')') || plain.ends_with('}')))
        return {};
    return trimmed(plain.substr(open + 1, plain.size() - open - 2));
}

/// Numbers in a unit that is not known would be taken in that of the axis.
void warnOfUnknownUnits(const Header& header, std::size_t lineNumber, DiagnosticList& diagnostics)
{
    for (std::size_t i = 0; i < header.columns.size(); ++i) {
        const ColumnName& column = header.columns[i];
        if (!column.unit.empty())
            continue;
        const std::string plain = withPlainBrackets(column.name);
        const std::string_view text = lastBrackets(plain);
        if (!text.empty() && looksLikeUnknownUnit(text))
            diagnostics.warning(DiagnosticCode::Assumption, lineNumber, i + 1,
                AXISCOMP_TEXT("Error", "\"{name}\", which is taken to be a name without a unit")
                    .with("name", Verbatim{column.name}),
                AXISCOMP_TEXT("Error",
                    "a unit such as mm, um, inch, deg or arcsec, if {unit} is meant as one")
                    .with("unit", Verbatim{std::string(text)}));
    }
}

bool isNumber(const Cell& cell)
{
    Number number;
    return parseNumber(cell.text, '.', number) != NumberFault::NotANumber
        || parseNumber(cell.text, ',', number) != NumberFault::NotANumber;
}

/// An empty or repeated name becomes "Table n": n is the table's own number unless another table
/// already has that name.
void nameTables(std::vector<ColumnName>& columns, std::size_t dimensions)
{
    std::set<std::string, std::less<>> taken;
    std::vector<std::size_t> nameless;
    for (std::size_t i = dimensions; i < columns.size(); ++i)
        if (columns[i].name.empty() || !taken.insert(columns[i].name).second)
            nameless.push_back(i);
    std::size_t next = columns.size() - dimensions + 1;
    for (const std::size_t i : nameless) {
        columns[i].name = "Table " + std::to_string(i - dimensions + 1);
        while (!taken.insert(columns[i].name).second)
            columns[i].name = "Table " + std::to_string(next++);
    }
}

Text withTooFewHint(Text expected, std::string_view line, std::size_t count)
{
    if (line.find('\t') != std::string_view::npos)
        return AXISCOMP_TEXT(
            "Error", "{expected}; separate the columns with , or ; instead of tabs")
            .with("expected", std::move(expected));
    if (count == 1 && line.find('|') != std::string_view::npos)
        return AXISCOMP_TEXT("Error", "{expected}; separate the columns with , or ;")
            .with("expected", std::move(expected));
    return withDimensionalityHint(std::move(expected), static_cast<int>(count) - 1);
}

bool checkQuotes(const std::vector<Cell>& cells, std::size_t lineNumber, Encoding encoding,
    DiagnosticList& diagnostics)
{
    for (std::size_t i = 0; i < cells.size(); ++i) {
        if (cells[i].quoting == Quoting::None || cells[i].quoting == Quoting::Quoted)
            continue;
        diagnostics.error(DiagnosticCode::UnterminatedQuote, lineNumber, i + 1,
            Verbatim{excerpt(cells[i].text, encoding)},
            cells[i].quoting == Quoting::NotClosed
                ? AXISCOMP_TEXT("Error", "a closing \" in the same line")
                : AXISCOMP_TEXT("Error", "a separator after the closing \""));
        return false;
    }
    return true;
}

} // namespace

ColumnName columnName(std::string_view header)
{
    const std::string_view all = trimmed(header);
    const std::size_t open = all.ends_with(']') ? all.rfind('[') : std::string_view::npos;
    if (open != std::string_view::npos)
        return {shownText(trimmed(all.substr(0, open))),
            shownText(trimmed(all.substr(open + 1, all.size() - open - 2)))};
    auto found = withUnitInBrackets(all);
    if (!found)
        found = withUnitInBrackets(withPlainBrackets(all));
    if (!found)
        found = withUnitBehind(all);
    return found ? ColumnName{shownText(found->name), shownText(found->unit)}
                 : ColumnName{shownText(all), ""};
}

Text withDimensionalityHint(Text expected, int dimensions)
{
    if (dimensions < 1 || dimensions > 3)
        return expected;
    return AXISCOMP_TEXT("Error", "{expected} (or is the dimensionality {dimensions}?)")
        .with("expected", std::move(expected))
        .with("dimensions", dimensions);
}

std::optional<Header> readColumnNames(
    std::string_view line, std::size_t lineNumber, Encoding encoding, DiagnosticList& diagnostics)
{
    Header header{csvSeparator(line), {}};
    std::vector<Cell> cells;
    const std::size_t count = splitCells(line, header.separator, maximumColumns, cells);
    if (!checkQuotes(cells, lineNumber, encoding, diagnostics))
        return std::nullopt;
    if (count > maximumColumns) {
        diagnostics.error(DiagnosticCode::TooLarge, lineNumber, 0,
            AXISCOMP_COUNTED("Error", "{count} columns", "1 column").with("count", count),
            AXISCOMP_TEXT("Error", "at most {count} columns").with("count", maximumColumns));
        return std::nullopt;
    }
    if (std::ranges::all_of(cells, isNumber)) {
        diagnostics.error(DiagnosticCode::NoHeader, lineNumber, 0,
            Verbatim{excerpt(line, encoding)},
            AXISCOMP_TEXT("Error", "the names of the columns, not numbers"));
        return std::nullopt;
    }
    for (const Cell& cell : cells)
        header.columns.push_back(columnName(cellText(cell, encoding)));
    return header;
}

std::optional<Header> readHeader(std::string_view line, std::size_t lineNumber, int dimensions,
    Encoding encoding, DiagnosticList& diagnostics)
{
    std::optional<Header> header = readColumnNames(line, lineNumber, encoding, diagnostics);
    if (!header)
        return std::nullopt;
    const auto positions = static_cast<std::size_t>(dimensions);
    const std::size_t count = header->columns.size();
    if (count < positions + 1) {
        diagnostics.error(DiagnosticCode::TooFewColumns, lineNumber, 0,
            AXISCOMP_COUNTED("Error", "{count} columns", "1 column").with("count", count),
            withTooFewHint(AXISCOMP_TEXT("Error",
                               "at least {count} for dimensionality {dimensions}, {positions} of "
                               "positions and 1 of values")
                               .with("count", positions + 1)
                               .with("dimensions", dimensions)
                               .with("positions", dimensions),
                line, count));
        return std::nullopt;
    }
    warnOfUnknownUnits(*header, lineNumber, diagnostics);
    nameTables(header->columns, positions);
    return header;
}

} // namespace axiscomp::csv
