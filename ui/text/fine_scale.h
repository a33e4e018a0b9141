// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/fine_quantity.h"

#include <QString>

namespace axiscomp::ui {

/// How deviations of a measurement are shown: in the unit that suits them, with two decimals and
/// the signs of the language.
class FineScale {
public:
    explicit FineScale(const FineUnit& unit) : m_unit(unit) { }

    [[nodiscard]] QString symbol() const; ///< "µm", "nm", "″"
    /// value: in mm or deg; "93.20", "-0.31"
    [[nodiscard]] QString text(double value) const;
    /// "93.20 µm"
    [[nodiscard]] QString textWithUnit(double value) const;

private:
    FineUnit m_unit;
};

/// "93.20 µm": a value in mm or deg that stands alone.
[[nodiscard]] QString fineText(double value, bool isAngular);

} // namespace axiscomp::ui
