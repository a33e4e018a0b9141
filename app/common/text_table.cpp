// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/text_table.h"

#include "app/common/console.h"

#include <algorithm>
#include <cassert>

namespace axiscomp::app {

namespace {

constexpr std::string_view gap = "  ";

/// Columns on the screen: one per UTF-8 character.
std::size_t widthOf(std::string_view text)
{
    return static_cast<std::size_t>(std::ranges::count_if(
        text, [](char c) { return (static_cast<unsigned char>(c) & 0xc0) != 0x80; }));
}

} // namespace

TextTable::TextTable(const std::vector<std::string>& headings)
{
    std::vector<std::string> line;
    for (const std::string& heading : headings) {
        m_alignRight.push_back(heading.starts_with('>'));
        line.push_back(m_alignRight.back() ? heading.substr(1) : heading);
    }
    m_lines.push_back(std::move(line));
}

void TextTable::add(std::vector<std::string> cells)
{
    assert(cells.size() == m_alignRight.size());
    for (std::string& cell : cells)
        cell = singleLine(cell);
    m_lines.push_back(std::move(cells));
}

std::string TextTable::text(std::string_view indent) const
{
    std::vector<std::size_t> widths(m_alignRight.size(), 0);
    for (const auto& line : m_lines) {
        for (std::size_t i = 0; i < line.size(); ++i)
            widths[i] = std::max(widths[i], widthOf(line[i]));
    }
    std::string result;
    for (const auto& line : m_lines) {
        std::string row(indent);
        for (std::size_t i = 0; i < line.size(); ++i) {
            const std::string padding(widths[i] - widthOf(line[i]), ' ');
            row.append(i == 0 ? "" : gap);
            row.append(m_alignRight[i] ? padding + line[i] : line[i] + padding);
        }
        row.erase(row.find_last_not_of(' ') + 1);
        result.append(row).push_back('\n');
    }
    return result;
}

std::string labelled(
    const std::vector<std::pair<std::string, std::string>>& lines, std::string_view indent)
{
    std::size_t width = 0;
    for (const auto& [label, value] : lines)
        width = std::max(width, widthOf(label));
    std::string result;
    for (const auto& [label, value] : lines) {
        std::string row(indent);
        row.append(label).append(width - widthOf(label), ' ').append(gap).append(singleLine(value));
        row.erase(row.find_last_not_of(' ') + 1);
        result.append(row).push_back('\n');
    }
    return result;
}

} // namespace axiscomp::app
