// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curve/fitted_curve.h"

#include <algorithm>

namespace axiscomp {

double FittedCurve::at(double position) const
{
    if (!base.wrap)
        position = std::clamp(position, base.knots.front(), base.knots.back());
    double sum = base.at(position);
    for (const PeriodicTerm& term : terms)
        sum += term.at(position);
    return sum;
}

} // namespace axiscomp
