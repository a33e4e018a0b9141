// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/table/compensation_table.h"
#include "core/table/target_axis.h"

#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

/// In what a drive takes the numbers of a table, as its PositionUnit or as a symbol.
struct TableUnits {
    std::string values; ///< of the axis; empty or None: the drive does not say
    std::vector<std::string> positions; ///< of each source; empty: it is no position of an axis

    friend bool operator==(const TableUnits&, const TableUnits&) = default;
};

/// Numbers of a table that mean something else than before.
struct UnitChange {
    std::optional<std::size_t> dimension; ///< of positions, from 0; nothing: of the values
    std::string before; ///< a symbol, or the drive's own word: "None"
    std::string now; ///< likewise; empty: the drive does not say

    friend bool operator==(const UnitChange&, const UnitChange&) = default;
};
/// Its unit of now, for a sentence.
[[nodiscard]] Text unitNow(const UnitChange& change);
/// The first unit that is another one now, or is not known any more. Nothing is said of one that
/// was not known before.
[[nodiscard]] std::optional<UnitChange> changedUnit(
    const TableUnits& before, const TableUnits& now);

struct TableInUnits {
    CompensationTable table; ///< with these units
    /// What was converted and what is assumed, each with the largest correction that follows.
    std::vector<Text> remarks;
};

/// What values without a unit are in.
enum class UnstatedUnit {
    OfPositions, ///< of those that they correct (AN140 3.1)
    OfDrive, ///< as a person says, whatever the positions are in
};

/// What a person states in place of the unit of values or positions: they are in the drive's own.
inline constexpr std::string_view unitOfDrive = "drive";
/// What a person states in place of the units of a file, before anything is done with its numbers.
/// Empty: as the file says.
struct StatedUnits {
    std::string values; ///< of a length or an angle, or unitOfDrive
    std::string positions; ///< likewise, of all sources

    friend bool operator==(const StatedUnits&, const StatedUnits&) = default;
};
void takeStatedUnit(std::string& unit, const std::string& stated);
void takeStatedUnits(CompensationTable& table, const StatedUnits& stated);
/// What the values are in after that, where they have no unit.
[[nodiscard]] UnstatedUnit unstatedUnit(std::string_view statedForValues);

/// What values without a unit can be in, each unit once: that of the positions which they correct
/// (AN140 3.1), or those of all lengths and angles of a table that corrects another axis or does
/// not say which. positions: the unit of each source. Empty: the table does not say.
[[nodiscard]] std::vector<std::string> unitsForValues(
    std::span<const std::string> positions, const std::optional<TargetAxis>& target);
[[nodiscard]] std::vector<std::string> unitsForValues(const CompensationTable& table);
/// Whether positions and target tell the unit of the axis that the values correct, in which a table
/// of the drive has them without a word.
[[nodiscard]] bool isUnitOfAxisCertain(
    std::span<const std::string> positions, const std::optional<TargetAxis>& target);
[[nodiscard]] bool isUnitOfAxisCertain(const CompensationTable& table);
/// Whether the positions of all dimensions are in the same unit, or none has one.
[[nodiscard]] bool haveOneUnit(const Grid& grid);

/// The same table in the units of the drive. Values without a unit are in that of the positions,
/// where it can be, or of the drive; where nothing has a unit, numbers are taken to be in the
/// drive's, which a remark says, as it does of positions without a unit in a table that states
/// some. Positions of a source without a unit stay as they are. Values are exact to one unit in the
/// last place of a float32. Errors: UnitMismatch for a length on an angle, and for units that are
/// not known; UnitMissing for values that can be in the unit of one position or of another.
[[nodiscard]] Result<TableInUnits> inDriveUnits(const CompensationTable& table,
    const TableUnits& units, UnstatedUnit unstated = UnstatedUnit::OfPositions);
/// The same for an axis whose own position is that dimension; nothing: none is. A table that does
/// not say what it corrects corrects that axis, so that values without a unit have its unit.
[[nodiscard]] Result<TableInUnits> inUnitsOfAxis(const CompensationTable& table,
    const TableUnits& units, std::optional<std::size_t> ownDimension,
    UnstatedUnit unstated = UnstatedUnit::OfPositions);

} // namespace axiscomp
