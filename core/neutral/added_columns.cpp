// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/neutral/added_columns.h"

#include <map>
#include <set>
#include <utility>

namespace axiscomp {

std::vector<AddedColumns> addedColumns(std::span<const NeutralTable> tables)
{
    constexpr unsigned positive = 1;
    constexpr unsigned negative = 2;
    std::map<std::string, unsigned> directionsOf; // of a target over its sources
    std::map<std::string, std::pair<std::string, Text>> firstOf; // of a target, its sources
    std::set<std::string> known;
    std::vector<AddedColumns> added;
    const auto add = [&](const std::string& kind, AddedColumns columns) {
        if (known.insert(kind).second)
            added.push_back(std::move(columns));
    };
    for (const NeutralTable& table : tables)
        for (const CompensationColumn& column : table.columns) {
            std::string sources;
            for (const SourceAxis& axis : table.axes)
                sources += axis.name + '\n';
            const unsigned directions = column.direction == Direction::Both ? positive | negative
                : column.direction == Direction::Positive                   ? positive
                                                                            : negative;
            const Text text = columnText(table, column);
            const std::string target = targetName(table, column);
            unsigned& before = directionsOf[sources + column.target];
            if ((before & directions) != 0)
                add(sources + column.target, {target, {text}});
            before |= directions;
            const auto first = firstOf.try_emplace(target, sources, text).first;
            if (!target.empty() && first->second.first != sources)
                add(target, {target, {first->second.second, text}});
        }
    return added;
}

} // namespace axiscomp
