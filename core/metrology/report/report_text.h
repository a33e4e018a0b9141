// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"

#include <optional>
#include <string>

namespace axiscomp::report {

/// How deviations and figures are shown: in um, or in arc seconds for angles.
struct FineUnit {
    double factor; ///< from mm or deg
    const char* symbol; ///< of deviations
    const char* positionSymbol; ///< of positions, which stay as they are
};
[[nodiscard]] FineUnit fineUnit(bool isAngular);

/// With this many decimals, and no sign before what is rounded to 0.
[[nodiscard]] std::string fixedDigits(double value, int decimals);
/// As a number in the language of the page, without a unit.
[[nodiscard]] Text numberText(double value, int decimals);
/// With its unit.
[[nodiscard]] Text quantityText(const std::string& digits, const char* unit);
[[nodiscard]] Text notStated();
/// What a file said, made fit for a page, or that it did not say it.
[[nodiscard]] Text statedText(const std::string& text);

} // namespace axiscomp::report
