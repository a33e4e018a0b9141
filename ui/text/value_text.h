// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/wall_time.h"
#include "core/drive/compensation_setup.h"
#include "core/table/grid.h"

#include <QByteArray>
#include <QString>
#include <QStringList>

#include <span>
#include <string>

namespace axiscomp::ui {

/// text is UTF-8.
[[nodiscard]] QString qString(std::string_view text);

// Numbers in the words of QLocale().

/// Seven digits at most, without trailing zeros.
[[nodiscard]] QString numberText(double value);
/// "+0.0021", "0", "-0.0021"
[[nodiscard]] QString signedNumberText(double value);
[[nodiscard]] QString countText(std::size_t count);
/// A grid point's position with as many digits as tell it from its neighbours.
[[nodiscard]] QString positionText(const GridAxis& axis, std::size_t index);
/// With as many decimals as the position of the same axis that has most of them, so that they stand
/// below each other.
[[nodiscard]] QString alignedPositionText(const GridAxis& axis, std::size_t index);
/// " mm"; nothing without a unit.
[[nodiscard]] QString unitSuffix(const std::string& unit);
/// "X [mm]"; the name alone without a unit.
[[nodiscard]] QString withUnit(const QString& name, const std::string& unit);

// For other programs: decimal point, no sign for positive numbers.

/// A table's value with every digit that its float32 has.
[[nodiscard]] QByteArray plainValue(float value);
/// As positionText.
[[nodiscard]] QByteArray plainPosition(const GridAxis& axis, std::size_t index);
/// "3.4 %": of the whole, rounded down, so that only all of it is 100 %.
[[nodiscard]] QString percentageText(double share);
/// "3:12"
[[nodiscard]] QString durationText(int seconds);
/// "X, Y, Z"
[[nodiscard]] QString listText(const QStringList& items);
/// What a sentence ends with: a full stop.
[[nodiscard]] QString sentenceEnd();

/// Date and time as people here write them.
[[nodiscard]] QString localTimeText(WallTime time);

/// The symbol of a drive's PositionUnit: "mm" for Millimeter; other names stay as they are.
[[nodiscard]] QString unitSymbol(const std::string& positionUnit);
/// A small length in a unit that suits it: +0.0012 of a millimetre is "+1.2 µm". positionUnit as
/// the drive names it.
[[nodiscard]] QString smallValueText(double value, const std::string& positionUnit);

/// "5 × 4 points, X 0 … 40, Y 0 … 30"
[[nodiscard]] QString gridText(const Grid& grid);
/// The name of a dimension: the file's, or "Dim 2".
[[nodiscard]] QString dimensionName(const Grid& grid, std::size_t dimension);

} // namespace axiscomp::ui
