// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"

#include <optional>
#include <span>
#include <string>

namespace axiscomp {

/// How units are spelled: in letters of ASCII, or as on a page.
enum class UnitLetters { Ascii, Page };

/// The unit in which deviations and figures are shown.
struct FineUnit {
    double factor = 1000.0; ///< from mm or deg
    const char* name = "um"; ///< in letters of ASCII
    const char* symbol = "µm"; ///< on a page

    /// value: in mm or deg
    [[nodiscard]] std::string digits(double value, int decimals = 3) const;
};
/// The one that suits values in mm or deg which are read together: um, nm where the largest of them
/// is below 100 nm, and arcsec for angles. Below 5 pm there is only what computing leaves: 0 um.
[[nodiscard]] FineUnit fineUnit(std::span<const std::optional<double>> shown, bool isAngular);

/// In which slopes of deviations, in mm/mm or deg/deg, are shown: um/m, or arcsec/deg.
[[nodiscard]] FineUnit slopeUnit(bool isAngular);

/// Whether one amount is above another, such as a figure above its limit, by more than computing
/// leaves: a billionth of the larger. Figures are differences of positions up to some metres, of
/// which a double has a few femtometres, so that a sum of tenths may end on either side of its
/// limit.
[[nodiscard]] bool isAbove(double amount, double limit);

/// A value in mm or deg that stands alone, in the unit that suits it.
[[nodiscard]] Quantity fineQuantity(double value, bool isAngular);
/// How a figure, its uncertainty and the limit that it is held against are shown side by side.
struct ComparedDigits {
    FineUnit value;
    FineUnit limit;
    FineUnit uncertainty;
    int decimals = 3; ///< of all
};
/// At least these, and as many more as tell the size of the value, and that with the uncertainty or
/// less it, from the limit where they are not the same (isAbove). In mm or deg.
[[nodiscard]] int decimalsApart(
    const FineUnit& unit, double value, double limit, int decimals, double uncertainty = 0.0);
/// Each in the unit that suits it and with these decimals; where they would need more of them
/// (decimalsApart), in one unit with these. In mm or deg.
[[nodiscard]] ComparedDigits comparedDigits(
    double value, double limit, bool isAngular, int decimals = 3, double uncertainty = 0.0);
struct ComparedQuantities {
    Quantity value;
    Quantity limit;
};
[[nodiscard]] ComparedQuantities comparedQuantities(double value, double limit, bool isAngular);

/// A position in mm or deg, to a nanometre, or 1e-7 deg.
[[nodiscard]] Quantity placeOf(double position, bool isAngular);
/// The same with every decimal, so that digits which change stay in their place: "25.310000".
[[nodiscard]] std::string placeDigits(double position, bool isAngular);

} // namespace axiscomp
