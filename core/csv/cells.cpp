// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/cells.h"

#include "core/text/token_scanner.h"

#include <algorithm>

namespace axiscomp::csv {

Cell takeCell(std::string_view& line, char separator, bool& more)
{
    std::size_t first = 0;
    while (first < line.size() && (line[first] == ' ' || line[first] == '\t'))
        ++first;
    if (first == line.size() || line[first] != '"') {
        const std::size_t end = line.find(separator);
        const Cell cell{trimmed(line.substr(0, end)), Quoting::None};
        more = end != std::string_view::npos;
        line.remove_prefix(more ? end + 1 : line.size());
        return cell;
    }
    line.remove_prefix(first + 1);
    std::size_t close = line.find('"');
    while (close != std::string_view::npos && line.substr(close + 1).starts_with('"'))
        close = line.find('"', close + 2);
    more = false;
    if (close == std::string_view::npos)
        return {line, Quoting::NotClosed};
    const std::size_t end = line.find(separator, close);
    const bool clean = trimmed(line.substr(close + 1, end - close - 1)).empty();
    const Cell cell{
        line.substr(0, clean ? close : end), clean ? Quoting::Quoted : Quoting::TextBehind};
    more = end != std::string_view::npos;
    line.remove_prefix(more ? end + 1 : line.size());
    return cell;
}

bool takeShortNumber(std::string_view& line, const CellFormat& format, const char* textEnd,
    Cell& cell, Number& number, bool& more)
{
    const char* const lineEnd = line.data() + line.size();
    const auto behindBlanks = [&format, lineEnd](const char* p) {
        while (p != lineEnd && (*p == ' ' || *p == '\t') && *p != format.separator)
            ++p;
        return p;
    };
    const char* const first = behindBlanks(line.data());
    // The first number with a decimal sign decides what the sign is; after that most are short.
    if (format.decimal == '\0' || first == lineEnd
        || static_cast<std::size_t>(textEnd - first) < shortNumberReach)
        return false;
    const char* const end = parseShortNumber(first, format.decimal, number);
    if (end == nullptr || end > lineEnd)
        return false;
    const char* const next = behindBlanks(end);
    if (next != lineEnd && *next != format.separator)
        return false;
    more = next != lineEnd;
    cell = {{first, static_cast<std::size_t>(end - first)}, Quoting::None};
    line.remove_prefix(static_cast<std::size_t>(next - line.data()) + (more ? 1 : 0));
    return true;
}

void RowLines::add(std::size_t row, std::size_t line)
{
    if (m_runs.empty() || line - row != std::size_t{m_runs.back().line} - m_runs.back().row)
        m_runs.push_back({static_cast<std::uint32_t>(row), static_cast<std::uint32_t>(line)});
}

std::size_t RowLines::lineOf(std::size_t row) const
{
    const auto after = std::ranges::upper_bound(m_runs, row, {}, &Run::row);
    if (after == m_runs.begin())
        return 0;
    const Run& run = *(after - 1);
    return run.line + (row - run.row);
}

std::size_t splitCells(
    std::string_view line, char separator, std::size_t maximum, std::vector<Cell>& cells)
{
    cells.clear();
    std::size_t count = 0;
    for (bool more = true; more; ++count) {
        const Cell cell = takeCell(line, separator, more);
        if (count < maximum)
            cells.push_back(cell);
    }
    return count;
}

bool isNoValue(std::string_view cell)
{
    const std::string_view text = trimmed(cell);
    return text.empty() || sameLetters(text, "nan") || sameLetters(text, "#N/A");
}

std::string cellText(const Cell& cell, Encoding encoding)
{
    std::string text = toUtf8(cell.text, encoding);
    // Nobody sees a byte-order mark that stands elsewhere than first, as in files put together.
    constexpr std::string_view mark = "\xEF\xBB\xBF";
    for (std::size_t at = 0; (at = text.find(mark, at)) != std::string::npos;)
        text.erase(at, mark.size());
    if (cell.quoting != Quoting::Quoted)
        return text;
    for (std::size_t at = 0; (at = text.find("\"\"", at)) != std::string::npos; ++at)
        text.erase(at, 1);
    return text;
}

} // namespace axiscomp::csv
