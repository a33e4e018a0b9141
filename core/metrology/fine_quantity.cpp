// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fine_quantity.h"

#include "core/text/number_text.h"

#include <algorithm>
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

Quantity fineQuantity(double value, bool isAngular)
{
    const std::optional<double> shown[] = {value};
    const FineUnit unit = fineUnit(shown, isAngular);
    return {unit.digits(value), unit.name};
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
