// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensation_setup.h"
#include "core/grid.h"

#include <QString>

#include <span>
#include <string>

namespace axiscomp::ui {

struct AxisEntry;

// Numbers in the words of QLocale().

/// Seven digits at most, without trailing zeros.
[[nodiscard]] QString numberText(double value);
/// "+0.0021", "0", "-0.0021"
[[nodiscard]] QString signedNumberText(double value);
[[nodiscard]] QString countText(std::size_t count);
/// "3:12"
[[nodiscard]] QString durationText(int seconds);

/// The symbol of a drive's PositionUnit: "mm" for Millimeter; other names stay as they are.
[[nodiscard]] QString unitSymbol(const std::string& positionUnit);
/// A small length in a unit that suits it: +0.0012 of a millimetre is "+1.2 µm". positionUnit as
/// the drive names it.
[[nodiscard]] QString smallValueText(double value, const std::string& positionUnit);

/// "X · PositionController/MasterPosition", "Application/Variables/Floats[3]"
[[nodiscard]] QString registerName(const std::string& path, std::span<const AxisEntry> axesOfDrive);
/// "5 × 4 points, X 0 … 40, Y 0 … 30"
[[nodiscard]] QString gridText(const Grid& grid);
/// The name of a dimension: the file's, or "Dim 2".
[[nodiscard]] QString dimensionName(const Grid& grid, std::size_t dimension);

} // namespace axiscomp::ui
