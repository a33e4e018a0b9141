// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/known_tables.h"

#include "core/neutral/sign_note.h"
#include "core/table/position_unit.h"
#include "core/table/table_units.h"
#include "core/table/tam_table.h"

#include <algorithm>
#include <iterator>
#include <utility>

namespace axiscomp {

Result<std::uint32_t> crcInMeters(
    const CompensationTable& table, const std::string& unit, const TableLayout& layout)
{
    AXISCOMP_TRY(const auto converted, inDriveUnits(table, {unit == "mm" ? "m" : "rad", {}}));
    return elementCrc(converted.table, layout);
}

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
    KnownTables::Origin origin;
    if (!crc) {
        AXISCOMP_TRY(crc, elementCrc(converted.table, layout));
        AXISCOMP_TRY(const auto inFile, elementCrc(table, layout));
        AXISCOMP_TRY(const auto inMeters, crcInMeters(table, unit, layout));
        origin.otherCrcs = {inFile, inMeters};
        origin.isUnitStated = !unitsForValues(table).empty();
    }
    known.origins.push_back(std::move(origin));
    known.tables.push_back(std::move(converted.table));
    known.crcs.push_back(*crc);
    return {};
}

Result<TablesOfFile> tablesOfFile(const std::string& name, const CalibrationData& data,
    const std::string& unit, const TableLayout& layout, std::optional<LookupAt> lookupAt)
{
    AXISCOMP_TRY(const auto sign, signOfTable(data.notes, std::nullopt));
    if (sign == SignConvention::Command)
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "{file} says sign: command, and a table that was active holds feedback values: "
                    "convert the file first, and take what is written")
                    .with("file", Verbatim{name})}});
    AXISCOMP_CHECK(lookupOfTable(data.notes, lookupAt));
    TablesOfFile made;
    made.tables.name = Verbatim{name};
    for (const CompensationTable& table : data.tables)
        AXISCOMP_CHECK(addTable(made.tables, table, std::nullopt, unit, layout, &made.remarks));
    return made;
}

} // namespace axiscomp
