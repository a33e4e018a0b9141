// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/metrology/fine_quantity.h"
#include "core/metrology/judge/uncertainty.h"

#include <QString>

namespace axiscomp::ui {

/// How deviations of a measurement are shown: in the unit that suits them, with two decimals and
/// the signs of the language.
class FineScale {
public:
    static constexpr int usualDecimals = 2;

    explicit FineScale(const FineUnit& unit) : m_unit(unit) { }

    [[nodiscard]] QString symbol() const; ///< "µm", "nm", "″"
    /// value: in mm or deg; "93.20", "-0.31"
    [[nodiscard]] QString text(double value, int decimals = usualDecimals) const;
    /// "93.20 µm"
    [[nodiscard]] QString textWithUnit(double value, int decimals = usualDecimals) const;

private:
    FineUnit m_unit;
};

/// A deviation or figure that stands alone, in the unit that suits it: "93.20 µm".
[[nodiscard]] QString fineText(double value, bool isAngular);
/// A figure and its limit, with as many digits as show what was decided (verdictDigits).
struct ComparedTexts {
    QString value; ///< of a figure that is not defined, the limit
    QString limit;
};
[[nodiscard]] ComparedTexts comparedTexts(const Verdict& verdict, bool isAngular);
/// Likewise of two amounts that are held against each other (comparedDigits).
[[nodiscard]] ComparedTexts comparedTexts(double value, double limit, bool isAngular);
/// An amount that a person has said, in mm or deg, as one would write it: "10 µm", "0.5 ″".
[[nodiscard]] QString amountText(double value, bool isAngular);
/// The amount that a person has written, in mm or deg: "10" in um or arcsec, "10 µm", "0,01 mm"
/// with the decimal sign of the language, or the other one where that can be nothing else. Errors:
/// InvalidArgument.
[[nodiscard]] Result<double> amountOf(const QString& text, bool isAngular);

} // namespace axiscomp::ui
