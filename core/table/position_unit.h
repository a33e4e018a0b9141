// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

/// The symbol of a drive's PositionUnit: "mm" for Millimeter, nothing for None; other names stay as
/// they are.
[[nodiscard]] std::string unitSymbol(std::string_view positionUnit);

/// The same, or the drive's own word where it has no symbol: "None".
[[nodiscard]] std::string symbolOrWord(std::string_view positionUnit);

/// How many `to` one `from` is: 0.001 for "um" and "mm". Units are symbols as files write them
/// ("µm", "um", "deg", "°") or a drive's PositionUnit, in capital or small letters. Nothing when
/// one of them is not known, or when one is a length and the other an angle.
[[nodiscard]] std::optional<double> unitFactor(std::string_view from, std::string_view to);

/// The same where a unit that is not stated is taken to be the other one, and one that is not known
/// is itself.
[[nodiscard]] std::optional<double> commonUnitFactor(std::string_view from, std::string_view to);

/// A length or an angle, as files write it or a drive names it.
[[nodiscard]] bool isPositionUnit(std::string_view unit);
/// "°C", "degC", "K" ...
[[nodiscard]] bool isTemperatureUnit(std::string_view unit);
/// "°C", "degC" ...: the one that a register of a temperature is taken to be in.
[[nodiscard]] bool isCelsius(std::string_view unit);

/// Whether a text is likely to be a unit, or one misspelled, that nothing here knows: "ft",
/// "milimeter", "µm/m"; not "mean" or "C".
[[nodiscard]] bool looksLikeUnknownUnit(std::string_view text);

/// The same unit, perhaps spelled in another way; units that are not known are compared as texts.
[[nodiscard]] bool isSameUnit(std::string_view a, std::string_view b);
/// Adds a unit to a list that has each once.
void addUnit(std::vector<std::string>& units, const std::string& unit);

} // namespace axiscomp
