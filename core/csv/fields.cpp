// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/fields.h"

#include "core/csv/cells.h"
#include "core/text/utf8.h"

namespace axiscomp {

char csvSeparator(std::string_view headerLine)
{
    // A ';' inside a quoted name separates nothing.
    bool atStart = true;
    bool quoted = false;
    for (const char c : headerLine) {
        if (c == ';' && !quoted)
            return ';';
        if (c == '"' && (quoted || atStart))
            quoted = !quoted;
        else if (!quoted && c != ' ' && c != '\t')
            atStart = c == ',';
    }
    return ',';
}

bool isCsvComment(std::string_view line)
{
    const std::string_view text = trimmed(line);
    return text.empty() || text.starts_with("//");
}

std::vector<std::string> csvFields(std::string_view line, char separator, std::size_t maximum)
{
    // A line by itself: in a file that is not UTF-8 most lines are ASCII all the same.
    const auto encoding =
        findInvalidUtf8(line) == std::string_view::npos ? Encoding::Utf8 : Encoding::Windows1252;
    if (isCsvComment(line))
        return {toUtf8(line, encoding)};
    std::vector<csv::Cell> cells;
    csv::splitCells(line, separator, maximum, cells);
    std::vector<std::string> fields;
    fields.reserve(cells.size());
    for (const csv::Cell& cell : cells)
        fields.push_back(csv::cellText(cell, encoding));
    return fields;
}

} // namespace axiscomp
