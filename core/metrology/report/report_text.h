// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/judge/deviation_curves.h"

#include <string>

namespace axiscomp::report {

inline constexpr int figureDecimals = 2; ///< of deviations and figures on a page

/// Of positions on a page.
[[nodiscard]] const char* positionSymbol(bool isAngular);
/// A deviation or figure in mm or deg that stands alone, in the unit that suits it.
[[nodiscard]] Text fineText(double value, bool isAngular);
/// As a number in the language of the page, without a unit.
[[nodiscard]] Text numberText(double value, int decimals);
/// With its unit.
[[nodiscard]] Text quantityText(const std::string& digits, const char* unit);
/// The unit of deviations, and what is 0 among them: "µm, 0 = mean at 15 mm".
[[nodiscard]] Text deviationUnitText(
    const FineUnit& unit, const std::optional<PlacedDeviation>& datum, bool isAngular);
/// With commas between them.
[[nodiscard]] Text listText(std::vector<Text> items);
[[nodiscard]] Text notStated();
/// What a file said, made fit for a page, or that it did not say it.
[[nodiscard]] Text statedText(const std::string& text);

} // namespace axiscomp::report
