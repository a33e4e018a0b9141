// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"
#include "core/table/compensation_table.h"
#include "core/table/table_layout.h"

namespace axiscomp {

/// A .TAMtbl file in memory.
struct TamTable {
    CompensationTable table; ///< axis names and units are not in the file and come back empty
    bool persistent = false;
};

/// Errors: InvalidArgument when the table is inconsistent (sizes, element count, non-finite values,
/// distance not above 0) or a value does not fit the layout's field type.
[[nodiscard]] Result<Bytes> encodeTamTable(
    const CompensationTable& table, bool persistent, const TableLayout& layout);

/// Checks every field before it allocates (docs/tamtbl.md, "Reading"). Errors: InvalidTable with
/// the field, its offset, what was found and what was expected. Never allocates more than
/// bytes.size().
[[nodiscard]] Result<TamTable> decodeTamTable(ByteView bytes, const TableLayout& layout);

/// The CRC-32 of the elements, as a drive shows it for its table. Errors: those of encodeTamTable.
[[nodiscard]] Result<std::uint32_t> elementCrc(
    const CompensationTable& table, const TableLayout& layout);

/// Where the points of a grid lie in a file: rounded where the layout has f32. What encodeTamTable
/// refuses stays as it is.
[[nodiscard]] Grid storedGrid(Grid grid, const TableLayout& layout);

/// The size of the file for a grid.
[[nodiscard]] std::size_t tamTableSize(const Grid& grid, const TableLayout& layout);

/// Changes Persistent in place, as the drive does; nothing where the layout has no such field.
void setPersistent(std::span<std::byte> file, bool persistent, const TableLayout& layout);

/// True when two files are the same table, Persistent left aside.
[[nodiscard]] bool sameTable(ByteView a, ByteView b, const TableLayout& layout);

} // namespace axiscomp
