// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fine_quantity.h"

#include "core/text/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace axiscomp {

std::string FineUnit::digits(double value, int decimals) const
{
    return fixedDigits(value * factor, decimals);
}

FineUnit fineUnit(std::span<const std::optional<double>> shown, bool isAngular)
{
    if (isAngular)
        return {3600.0, "arcsec", "″"};
    constexpr double smallestInUm = 100e-6; // mm
    constexpr double nothing = 5e-9; // mm
    double largest = 0.0;
    for (const auto& value : shown)
        largest = std::max(largest, std::abs(value.value_or(0.0)));
    const bool suitsNm = largest < smallestInUm && largest >= nothing;
    return suitsNm ? FineUnit{1e6, "nm", "nm"} : FineUnit{};
}

FineUnit slopeUnit(bool isAngular)
{
    return isAngular ? FineUnit{3600.0, "arcsec/deg", "″/°"} : FineUnit{1e6, "um/m", "µm/m"};
}

bool isAbove(double amount, double limit)
{
    constexpr double rounding = 1e-9;
    return amount - limit > rounding * std::max(std::abs(amount), std::abs(limit));
}

Quantity fineQuantity(double value, bool isAngular)
{
    const std::optional<double> shown[] = {value};
    const FineUnit unit = fineUnit(shown, isAngular);
    return {unit.digits(value), unit.name};
}

int decimalsApart(
    const FineUnit& unit, double value, double limit, int decimals, double uncertainty)
{
    const double size = std::abs(value);
    const std::array amounts{size, size + uncertainty, size - uncertainty};
    const auto areToldApart = [&](int places) {
        return std::ranges::none_of(amounts, [&](double amount) {
            return (isAbove(amount, limit) || isAbove(limit, amount))
                && unit.digits(amount, places) == unit.digits(limit, places);
        });
    };
    constexpr int mostDecimals = 20; // more than a double has
    for (int needed = decimals; needed < mostDecimals; ++needed)
        if (areToldApart(needed))
            return needed;
    return decimals;
}

ComparedDigits comparedDigits(
    double value, double limit, bool isAngular, int decimals, double uncertainty)
{
    const std::optional<double> shown[] = {value, limit, uncertainty};
    const auto suiting = [&shown, isAngular](std::size_t first, std::size_t count) {
        return fineUnit(std::span(shown).subspan(first, count), isAngular);
    };
    const FineUnit unit = suiting(0, 2);
    const int needed = decimalsApart(unit, value, limit, decimals, uncertainty);
    if (needed > decimals)
        return {unit, unit, unit, needed};
    return {suiting(0, 1), suiting(1, 1), suiting(2, 1), decimals};
}

ComparedQuantities comparedQuantities(double value, double limit, bool isAngular)
{
    const ComparedDigits shown = comparedDigits(value, limit, isAngular);
    return {{shown.value.digits(value, shown.decimals), shown.value.name},
        {shown.limit.digits(limit, shown.decimals), shown.limit.name}};
}

Quantity placeOf(double position, bool isAngular)
{
    const double finest = isAngular ? 1e7 : 1e6;
    return {roundedText(std::round(position * finest) / finest), isAngular ? "deg" : "mm"};
}

std::string placeDigits(double position, bool isAngular)
{
    constexpr int decimals = 6;
    constexpr int angularDecimals = 7;
    return fixedDigits(position, isAngular ? angularDecimals : decimals);
}

} // namespace axiscomp
