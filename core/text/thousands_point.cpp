// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/thousands_point.h"

#include "core/text/line_reader.h"
#include "core/text/text_file.h"

#include <algorithm>
#include <vector>

namespace axiscomp {

namespace {

constexpr std::size_t groupDigits = 3;

enum class CellKind {
    Other, ///< no number, or one with a comma
    Whole, ///< up to 999
    Long, ///< a whole number of more digits: its column has nothing between thousands
    Grouped, ///< with three digits behind its point
    Decimal, ///< its point is a decimal one
};

constexpr std::string_view allDigits = "0123456789";

std::string_view withoutQuotesAndSign(std::string_view cell)
{
    constexpr std::string_view around = " \t\"";
    const std::size_t first = cell.find_first_not_of(around);
    if (first == std::string_view::npos)
        return {};
    cell = cell.substr(first, cell.find_last_not_of(around) - first + 1);
    return cell.substr(cell.front() == '-' || cell.front() == '+' ? 1 : 0);
}

CellKind cellKindOf(std::string_view number)
{
    const std::size_t point = number.find('.');
    const std::string_view before = number.substr(0, point);
    if (number.empty() || before.find_first_not_of(allDigits) != std::string_view::npos)
        return CellKind::Other;
    if (point == std::string_view::npos)
        return number.size() > groupDigits ? CellKind::Long : CellKind::Whole;
    const std::string_view behind = number.substr(point + 1);
    const std::size_t digits = std::min(behind.find_first_not_of(allDigits), behind.size());
    if (digits < behind.size() && behind[digits] != 'e' && behind[digits] != 'E')
        return CellKind::Other; // a date, or several groups, which no reader takes for a number
    const bool isGroup = digits == behind.size() && digits == groupDigits && !before.empty()
        && before.size() <= groupDigits && before.front() != '0';
    return isGroup ? CellKind::Grouped : CellKind::Decimal;
}

struct CellColumn {
    std::string_view whole;
    std::optional<ThousandsDoubt> grouped; ///< the first one
    bool isLong = false;
};

} // namespace

std::optional<ThousandsDoubt> thousandsDoubt(
    std::string_view lines, std::size_t firstLine, char separator)
{
    std::vector<CellColumn> columns;
    for (LineReader reader(lines); !reader.atEnd();) {
        const std::size_t line = firstLine + reader.lineNumber() - 1;
        std::string_view rest = reader.next();
        if (trimmed(rest).starts_with("//"))
            continue;
        for (std::size_t n = 0; !rest.empty(); ++n) {
            const std::size_t end = std::min(rest.find(separator), rest.size());
            const std::string_view number = withoutQuotesAndSign(rest.substr(0, end));
            rest.remove_prefix(std::min(end + 1, rest.size()));
            if (n == columns.size())
                columns.emplace_back();
            CellColumn& column = columns[n];
            switch (cellKindOf(number)) {
            case CellKind::Decimal:
                return std::nullopt;
            case CellKind::Whole:
                if (number.size() > column.whole.size()) // the one that says most
                    column.whole = number;
                break;
            case CellKind::Long:
                column.isLong = true;
                break;
            case CellKind::Grouped:
                if (!column.grouped)
                    column.grouped = {line, n + 1, number, {}};
                break;
            case CellKind::Other:
                break;
            }
        }
    }
    for (const CellColumn& column : columns)
        if (column.grouped && !column.whole.empty() && !column.isLong) {
            ThousandsDoubt doubt = *column.grouped;
            doubt.whole = column.whole;
            return doubt;
        }
    return std::nullopt;
}

} // namespace axiscomp
