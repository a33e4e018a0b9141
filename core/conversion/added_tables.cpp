// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/added_tables.h"

#include "core/formats/format_writer.h"
#include "core/neutral/added_columns.h"

#include <algorithm>
#include <set>

namespace axiscomp {

namespace {

/// Without the numbers, and without the columns that a format adds behind those of the table.
NeutralTable withoutNumbers(const NeutralTable& table, std::size_t columns)
{
    NeutralTable names;
    for (const SourceAxis& axis : table.axes)
        names.axes.emplace_back().name = axis.name;
    for (std::size_t n = 0; n < std::min(columns, table.columns.size()); ++n) {
        CompensationColumn& column = names.columns.emplace_back();
        column.target = table.columns[n].target;
        column.direction = table.columns[n].direction;
    }
    return names;
}

} // namespace

Result<void> checkAddedTables(const FormatFacts& from, const FormatFacts& to,
    std::span<const NeutralTable> given, std::span<const NeutralTable> held)
{
    if (from.addsTables || !to.addsTables)
        return {};
    std::vector<NeutralTable> names;
    for (std::size_t t = 0; t < std::min(given.size(), held.size()); ++t)
        names.push_back(withoutNumbers(held[t], given[t].columns.size()));
    const std::vector<AddedColumns> added = addedColumns(names);
    if (added.empty())
        return {};
    return cannotHold(to,
        AXISCOMP_TEXT("Error",
            "there are two tables for axis {axis}, and the controller adds their corrections")
            .with("axis", added.front().target),
        AXISCOMP_TEXT("Error", "choose one of them"));
}

std::vector<Text> signRemarksOfAdded(std::span<const NeutralTable> tables)
{
    std::set<std::string> sources;
    for (const NeutralTable& table : tables)
        for (const SourceAxis& axis : table.axes)
            sources.insert(axis.name);
    std::vector<Text> remarks;
    for (const AddedColumns& added : addedColumns(tables))
        if (sources.contains(added.target))
            remarks.push_back(AXISCOMP_TEXT("Error",
                "the controller adds the tables for {axis}: the sign of each is converted, and "
                "each is compared, as if it were alone")
                                  .with("axis", added.target));
    return remarks;
}

} // namespace axiscomp
