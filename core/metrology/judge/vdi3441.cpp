// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/judge/vdi3441.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace axiscomp {

std::optional<Vdi3441Figures> vdi3441Figures(const Iso230Figures& figures)
{
    if (!figures[Iso230Figure::A].value || !figures[Iso230Figure::M].value)
        return std::nullopt;
    Vdi3441Figures result;
    result.pa = *figures[Iso230Figure::M].value;
    double highest = -std::numeric_limits<double>::infinity();
    double lowest = std::numeric_limits<double>::infinity();
    const auto count = static_cast<double>(figures.targets.size());
    for (const TargetFigures& target : figures.targets) {
        const double u = std::abs(*target.reversal);
        const double ps = 3.0 * (*target.up.s + *target.down.s);
        highest = std::max(highest, *target.mean + (u + ps) / 2.0);
        lowest = std::min(lowest, *target.mean - (u + ps) / 2.0);
        result.uMax = std::max(result.uMax, u);
        result.psMax = std::max(result.psMax, ps);
        result.uMean += u / count;
        result.psMean += ps / count;
    }
    result.p = highest - lowest;
    return result;
}

} // namespace axiscomp
