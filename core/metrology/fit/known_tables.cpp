// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/known_tables.h"

#include "core/table/position_unit.h"
#include "core/table/table_units.h"
#include "core/table/tam_table.h"

#include <algorithm>
#include <iterator>

namespace axiscomp {

Result<void> addTable(KnownTables& known, const CompensationTable& table,
    std::optional<std::uint32_t> crc, const std::string& unit, const TableLayout& layout,
    std::vector<Text>* remarks)
{
    TableUnits units{unit, std::vector<std::string>(table.grid.axes.size(), unit)};
    for (std::size_t n = 0; n < units.positions.size(); ++n)
        if (!table.grid.axes[n].unit.empty() && !isPositionUnit(table.grid.axes[n].unit))
            units.positions[n].clear();
    AXISCOMP_TRY(auto converted, inDriveUnits(table, units));
    if (remarks)
        std::ranges::move(converted.remarks, std::back_inserter(*remarks));
    if (!crc) {
        AXISCOMP_TRY(crc, elementCrc(converted.table, layout));
    }
    known.tables.push_back(std::move(converted.table));
    known.crcs.push_back(*crc);
    return {};
}

Result<TablesOfFile> tablesOfFile(const std::string& name, const CalibrationData& data,
    const std::string& unit, const TableLayout& layout, std::optional<LookupAt> lookupAt)
{
    AXISCOMP_CHECK(lookupOfTable(data.notes, lookupAt));
    TablesOfFile made;
    made.tables.name = Verbatim{name};
    for (const CompensationTable& table : data.tables)
        AXISCOMP_CHECK(addTable(made.tables, table, std::nullopt, unit, layout, &made.remarks));
    return made;
}

} // namespace axiscomp
