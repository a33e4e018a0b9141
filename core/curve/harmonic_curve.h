// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/curve/curve_samples.h"
#include "core/curve/fitted_curve.h"

namespace axiscomp {

struct HarmonicFit {
    FittedCurve curve; ///< a_0 is its base, held over the whole turn
    double residualRms = 0.0; ///< of the means at the positions, weighted
    double residualLargest = 0.0;
    double noise = 0.0; ///< sigma of one value: sqrt(sum w r^2 / (m - 2 K - 1))
};

/// a_0 + sum over k = 1..K of a_k cos(2 pi k x / turn) + b_k sin(2 pi k x / turn), by weighted
/// least squares. turn: > 0; harmonics K: 1 at least. Errors: InvalidArgument, also for values at
/// fewer than 2 K + 3 positions of the turn; PeriodNotResolved when they cover too little of it.
[[nodiscard]] Result<HarmonicFit> fitHarmonics(
    const CurveSamples& samples, double turn, int harmonics);

} // namespace axiscomp
