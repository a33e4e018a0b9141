// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/value_scale.h"

#include "core/table/position_unit.h"
#include "ui/text/value_text.h"

#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>

namespace axiscomp::ui {

namespace {

/// A unit that numbers are shown in, from its first size on.
struct ShownUnit {
    const char* symbol;
    const char* base; ///< a unit that unitFactor knows
    double perBase; ///< how many of it are one base unit
    double from; ///< the smallest largest value for which it is taken, in itself
};
// What is below one unit is shown in the next smaller one, down to the last.
constexpr std::array lengths{ShownUnit{"m", "m", 1.0, 1.0}, ShownUnit{"mm", "m", 1e3, 1.0},
    ShownUnit{"µm", "m", 1e6, 0.01}, ShownUnit{"nm", "m", 1e9, 0.0}};
constexpr std::array degrees{ShownUnit{"°", "deg", 1.0, 1.0}, ShownUnit{"m°", "deg", 1e3, 0.0}};
constexpr std::array radians{ShownUnit{"rad", "rad", 1.0, 1.0}, ShownUnit{"µrad", "rad", 1e6, 0.0}};

std::span<const ShownUnit> unitsFor(const std::string& unit)
{
    if (unitFactor(unit, "m"))
        return lengths;
    if (isSameUnit(unit, "deg") || isSameUnit(unit, "mdeg"))
        return degrees;
    for (const char* known : {"rad", "mrad", "urad"})
        if (isSameUnit(unit, known))
            return radians;
    return {}; // arc seconds are shown as such
}

/// Trailing zeros of a number's digits, at most so many.
int trailingZeros(std::int64_t number, int most)
{
    int zeros = 0;
    constexpr std::int64_t ten = 10;
    while (zeros < most && number % ten == 0) {
        number /= ten;
        ++zeros;
    }
    return zeros;
}

double largestOf(std::span<const float> values)
{
    float largest = 0.0F;
    for (const float value : values)
        largest = std::max(largest, std::abs(value));
    return static_cast<double>(largest);
}

} // namespace

ValueScale::ValueScale(const std::string& unit, std::span<const float> values, double noise)
    : ValueScale(unit, largestOf(values), values, noise)
{
}

ValueScale::ValueScale(
    const std::string& unit, double largest, std::span<const float> values, double noise)
    : m_unit(unit)
{
    chooseUnit(largest);
    chooseDecimals(largest, values, noise);
}

ValueScale ValueScale::beside(std::span<const float> values, double noise) const
{
    ValueScale scale = *this;
    scale.chooseDecimals(largestOf(values), values, noise);
    return scale;
}

void ValueScale::chooseDecimals(double largest, std::span<const float> values, double noise)
{
    m_decimals = 0;
    if (!(largest > noise))
        return;
    constexpr int mostDigits = 5;
    constexpr int mostDecimals = 12;
    const auto place = [](double number) {
        return static_cast<int>(std::floor(std::log10(number)));
    };
    int most = mostDigits - 1 - place(largest * m_factor);
    if (noise > 0.0)
        most = std::min(most, -1 - place(noise * m_factor));
    most = std::clamp(most, 0, mostDecimals);
    const double perLast = m_factor * std::pow(10.0, most);
    int unneeded = most;
    for (const float value : values) {
        if (unneeded == 0)
            break;
        unneeded = std::min(
            unneeded, trailingZeros(std::llround(static_cast<double>(value) * perLast), unneeded));
    }
    m_decimals = most - unneeded;
}

void ValueScale::chooseUnit(double largest)
{
    const std::string own = m_unit;
    constexpr double rounding = 1.0 - 1e-6;
    for (const ShownUnit& shown : unitsFor(own)) {
        m_unit = shown.symbol;
        m_factor = unitFactor(own, shown.base).value_or(1.0) * shown.perBase;
        if (largest * m_factor >= shown.from * rounding)
            break;
    }
}

QString ValueScale::digits(double value) const
{
    QLocale locale;
    locale.setNumberOptions(QLocale::OmitGroupSeparator);
    // No "-0.00": it is nothing that can be seen.
    const double shown = value * m_factor;
    const bool isZero = std::abs(shown) * std::pow(10.0, m_decimals) < 0.5;
    return locale.toString(isZero ? 0.0 : shown, 'f', m_decimals);
}

QString ValueScale::text(double value) const
{
    const QString text = digits(value);
    const bool isPositive =
        value > 0.0 && std::ranges::any_of(text, [](QChar c) { return c >= u'1' && c <= u'9'; });
    return isPositive ? u'+' + text : text;
}

QByteArray ValueScale::plain(float value) const
{
    if (m_factor == 1.0)
        return plainValue(value);
    // The shortest digits of the float with their decimal point moved: 0.0021 mm are 2.1 µm.
    const double asRead = plainValue(value).toDouble();
    constexpr int digitsOfFloat = 9;
    return QByteArray::number(asRead * m_factor, 'g', digitsOfFloat);
}

QString ValueScale::textWithUnit(double value) const
{
    return text(value) + unitSuffix(m_unit);
}

QString ValueScale::sizeWithUnit(double value) const
{
    return digits(value) + unitSuffix(m_unit);
}

} // namespace axiscomp::ui
