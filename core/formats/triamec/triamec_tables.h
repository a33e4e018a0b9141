// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/csv/calibration_csv.h"
#include "core/formats/table_format.h"
#include "core/neutral/neutral_table.h"

#include <cstddef>
#include <string>
#include <vector>

namespace axiscomp {

// Between the neutral value and what the rest of the program works with: even grids of float32.

/// knots: of the data's axes where they are not even, see CsvReading; empty: even. A column whose
/// name is that of an axis has it as its target.
[[nodiscard]] NeutralTable neutralTable(
    const CalibrationData& data, const std::vector<std::vector<double>>& knots = {});

/// Of the compensation table that a column becomes: its own, else what it corrects, else that of
/// the table; "Table 2" where none of them has one.
[[nodiscard]] std::string nameOfTable(const NeutralTable& table, std::size_t column);

/// Each column becomes a compensation table; values are rounded to float32. Errors:
/// FormatCannotHold for uneven positions, values for one direction of motion, or of the command
/// side, and numbers that no float32 is.
[[nodiscard]] Result<CalibrationData> calibrationData(const NeutralTable& table);

/// What is stated before a calibration file is read: stated, else what the settings position-unit
/// and value-unit say.
[[nodiscard]] StatedUnits statedUnits(const FormatSettings& settings, StatedUnits stated = {});
/// What these settings say, of a table of the drive, whose file holds no units.
void stateUnits(CalibrationData& data, const FormatSettings& settings);
/// Warnings of the units that nobody says (UnitNotGiven), as of a file of another controller. Not
/// of every file that is read: a drive takes such numbers in the units of its axes.
[[nodiscard]] std::vector<Diagnostic> openUnits(const CalibrationData& data);

} // namespace axiscomp
