// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp::app {

/// Lines of cells with aligned columns, as wide as their content.
class TextTable {
public:
    /// A heading that begins with '>' aligns its column to the right.
    explicit TextTable(const std::vector<std::string>& headings);

    /// As many cells as headings.
    void add(std::vector<std::string> cells);
    [[nodiscard]] std::string text(std::string_view indent = "  ") const;

private:
    std::vector<bool> m_alignRight;
    std::vector<std::vector<std::string>> m_lines;
};

/// "Compensation  Active": names in a column, values beside them. A value's further lines are
/// indented.
[[nodiscard]] std::string labelled(
    const std::vector<std::pair<std::string, std::string>>& lines, std::string_view indent = "");

} // namespace axiscomp::app
