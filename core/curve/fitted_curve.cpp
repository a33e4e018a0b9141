// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curve/fitted_curve.h"

#include <algorithm>

namespace axiscomp {

double FittedCurve::at(double position) const
{
    Pieces pieces;
    return at(position, pieces);
}

double FittedCurve::at(double position, Pieces& pieces) const
{
    const double before = onto ? onto->at(position, pieces.onto) : 0.0;
    if (!base.wrap)
        position = std::clamp(position, base.knots.front(), base.knots.back());
    double sum = base.at(position, pieces.base);
    for (const PeriodicTerm& term : terms)
        sum += term.at(position);
    return before + sum;
}

} // namespace axiscomp
