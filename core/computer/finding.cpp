// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/computer/finding.h"

#include "core/text/number_text.h"

#include <array>

namespace axiscomp {

Quantity byteQuantity(std::uint64_t bytes)
{
    constexpr std::array units{"B", "kB", "MB", "GB", "TB"};
    auto value = static_cast<double>(bytes);
    std::size_t unit = 0;
    while (value >= 999.5 && unit + 1 < units.size()) {
        value /= 1000.0;
        ++unit;
    }
    return {fixedDigits(value, unit > 0 && value < 9.95 ? 1 : 0), units[unit]};
}

Verbatim secondText(WallTime time)
{
    return {utcText(std::chrono::floor<std::chrono::seconds>(time))};
}

} // namespace axiscomp
