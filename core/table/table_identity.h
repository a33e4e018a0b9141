// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/grid.h"

#include <cstdint>
#include <optional>

namespace axiscomp {

/// What tells one table from another. The CRC-32 is that of the values alone, and the same values
/// may lie over other positions.
struct TableIdentity {
    std::uint32_t crc = 0; ///< as the drive shows it
    std::optional<Grid> grid = {}; ///< nothing: not known, as of a file that notes the CRC alone
};

/// Whether no position differs by more than single precision may round (largestPointShift).
/// Whatever the names and units.
[[nodiscard]] bool areSamePositions(const GridAxis& a, const GridAxis& b);

/// Whether it is one table, as far as both are known: the same values over the same positions.
[[nodiscard]] bool isSameTable(const TableIdentity& a, const TableIdentity& b);

} // namespace axiscomp
