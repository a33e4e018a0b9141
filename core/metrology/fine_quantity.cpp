// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fine_quantity.h"

#include "core/text/number_text.h"

#include <array>
#include <charconv>
#include <utility>

namespace axiscomp {

Quantity fineQuantity(double value, bool isAngular)
{
    const double factor = isAngular ? 3600.0 : 1000.0;
    std::array<char, 352> buffer{};
    const auto end = std::to_chars(
        buffer.data(), buffer.data() + buffer.size(), value * factor, std::chars_format::fixed, 3);
    std::string digits(buffer.data(), end.ptr);
    if (digits == "-0.000")
        digits.erase(0, 1);
    return {std::move(digits), isAngular ? "arcsec" : "um"};
}

Quantity placeOf(double position, bool isAngular)
{
    return {roundedText(position), isAngular ? "deg" : "mm"};
}

} // namespace axiscomp
