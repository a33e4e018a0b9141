// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/csv/calibration_csv.h"
#include "core/metrology/fit/measured_state.h"
#include "core/neutral/lookup_note.h"
#include "core/table/compensation_table.h"
#include "core/table/table_layout.h"

#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axiscomp {

// Tables that may have been active while an axis was measured, in the unit of the measurement.

/// As a drive shows a table whose axis is in metres, or in radians where the unit is deg. unit: mm
/// or deg. Errors: UnitMismatch; those of elementCrc.
[[nodiscard]] Result<std::uint32_t> crcInMeters(
    const CompensationTable& table, const std::string& unit, const TableLayout& layout);

/// Adds a table in the unit of the measurement, mm or deg. crc: as the drive has it; nothing: that
/// of a drive with this unit, with the others that it may have (KnownTables::Origin). remarks:
/// takes what is assumed of units, where that is wanted. Errors: UnitMismatch; those of elementCrc.
[[nodiscard]] Result<void> addTable(KnownTables& known, const CompensationTable& table,
    std::optional<std::uint32_t> crc, const std::string& unit, const TableLayout& layout,
    std::vector<Text>* remarks);

struct TablesOfFile {
    KnownTables tables;
    std::vector<Text> remarks; ///< what is assumed of units
};
/// name: of the file, as it is told. unit: of the measurement, mm or deg. lookupAt: where the drive
/// looks them up, as far as that is stated. The CRC of each table is that of a drive with this
/// unit. Errors: InvalidArgument for command values; UnitMismatch; those of elementCrc and
/// lookupOfTable.
[[nodiscard]] Result<TablesOfFile> tablesOfFile(const std::string& name,
    const CalibrationData& data, const std::string& unit, const TableLayout& layout,
    std::optional<LookupAt> lookupAt);

} // namespace axiscomp
