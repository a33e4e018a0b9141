// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/table_choice.h"

#include "core/text/token_scanner.h"

#include <algorithm>
#include <optional>

namespace axiscomp {

namespace {

using Index = std::optional<std::size_t>;

/// By name, or as the list of them shows it. Errors: TableAmbiguous.
Result<Index> indexNamed(std::span<const TableName> tables, std::string_view asked)
{
    for (const auto words : {&TableName::name, &TableName::text}) {
        if (std::ranges::count(tables, asked, words) > 1)
            return fail(
                ErrorCode::TableAmbiguous, {{"table", asked}, {"alike", tableList(tables)}});
        const auto found = std::ranges::find(tables, asked, words);
        if (found != tables.end())
            return static_cast<std::size_t>(found - tables.begin());
    }
    return std::nullopt;
}

Index indexNumbered(std::span<const TableName> tables, std::string_view text)
{
    const auto number = wholeNumberOf(text);
    if (!number || *number < 1 || static_cast<std::size_t>(*number) > tables.size())
        return std::nullopt;
    return static_cast<std::size_t>(*number - 1);
}

} // namespace

std::string tableList(std::span<const TableName> tables)
{
    std::string list;
    for (std::size_t i = 0; i < tables.size(); ++i)
        list += (i == 0 ? "" : ", ") + std::to_string(i + 1) + " (" + tables[i].text + ")";
    return list;
}

Result<std::size_t> chooseTable(std::span<const TableName> tables, std::string_view asked)
{
    constexpr std::string_view namePrefix = "name:";
    AXISCOMP_TRY(const Index named, indexNamed(tables, asked));
    const Index numbered = indexNumbered(tables, asked);
    if (named && numbered && named != numbered)
        return fail(ErrorCode::TableAmbiguous,
            {{"table", asked}, {"named", *named + 1}, {"numbered", *numbered + 1}});
    Index found = named ? named : numbered;
    if (!found && asked.starts_with(namePrefix)) {
        AXISCOMP_TRY(found, indexNamed(tables, asked.substr(namePrefix.size())));
    } else if (!found && asked.starts_with('#')) {
        found = indexNumbered(tables, asked.substr(1));
    }
    if (!found)
        return fail(ErrorCode::TableNotFound, {{"table", asked}, {"known", tableList(tables)}});
    return *found;
}

} // namespace axiscomp
