// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/table/compensation_table.h"

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

struct TableInUnits {
    CompensationTable table; ///< with these units
    /// What was converted and what is assumed, each with the largest correction that follows.
    std::vector<Text> remarks;
};

/// In place of the unit of values: they are in that of the drive, whatever the positions are in.
inline constexpr std::string_view unitOfDrive = "drive";

/// What a person states in place of the units of a file, each of which may be empty or unitOfDrive.
void takeStatedUnits(
    CompensationTable& table, const std::string& values, const std::string& positions);

/// Of the positions that the values correct: of the own axis, or of the first source of a table
/// that corrects another one. Empty: the table does not say.
[[nodiscard]] const std::string& correctedUnit(const CompensationTable& table);

/// The same table in the units of the drive. Values without a unit are in that of the positions
/// (AN140 3.1), and numbers without any unit are taken to be in the drive's, which a remark says;
/// positions of a source without a unit stay as they are. Values are exact to
/// one unit in the last place of a float32. Errors: UnitMismatch for a length on an angle, and for
/// units that are not known.
[[nodiscard]] Result<TableInUnits> inDriveUnits(
    const CompensationTable& table, const TableUnits& units);

} // namespace axiscomp
