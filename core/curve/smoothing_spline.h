// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/curve/curve_samples.h"
#include "core/curve/fitted_curve.h"

#include <optional>

namespace axiscomp {

/// The natural cubic spline through the means at the positions; periodic on a modulo axis. Errors:
/// InvalidArgument, also for fewer than 2 positions.
[[nodiscard]] Result<FittedCurve> interpolatingSpline(
    const CurveSamples& samples, std::optional<double> wrap = {});

/// Straight lines through the same.
[[nodiscard]] Result<FittedCurve> straightLines(
    const CurveSamples& samples, std::optional<double> wrap = {});

/// The monotone cubic through the same.
[[nodiscard]] Result<FittedCurve> monotoneCubic(
    const CurveSamples& samples, std::optional<double> wrap = {});

struct SmoothingRequest {
    /// L / r, without a unit; none: by generalised cross-validation.
    std::optional<double> smoothness = {};
    std::optional<double> wrap = {}; ///< the period of a modulo axis
    KnownPeriods periods = {}; ///< fitted together with the spline, without a penalty
};

struct SmoothedCurve {
    FittedCurve curve;
    double smoothness = 0.0; ///< L / r
    double penalty = 0.0; ///< L, in (number of values) * position^3
    double parameters = 0.0; ///< trace of the matrix that makes fitted values of values
    double crossValidation = 0.0; ///< of one value, as estimated (root of the score)
    double residualRms = 0.0; ///< of the means at the positions, weighted
    double residualLargest = 0.0;
    double noise = 0.0; ///< sigma of one value: sqrt(sum w r^2 / (m - parameters))
};

/// The f that makes sum w_i (y_i - f(x_i))^2 + L integral f''(x)^2 dx smallest: a natural cubic
/// spline with the m different positions x_i as knots, y_i the means there and w_i their weights
/// (Reinsch 1967); with periods, f is the spline plus their terms, and the integral is that of the
/// spline.
///
/// L / r, with r = trace(W) / trace(K) and K the matrix of the integral, depends neither on the
/// unit of the positions nor on that of the values. Without it, it is the one from 1e-10 to 1e10
/// (with m above 10 000, to m^4 / 1e6) for which generalised cross-validation (Craven and Wahba
/// 1979) is smallest, with the trace counted 1.1 times so that no rough curve is taken:
///     m sum w_i r_i^2 / (m - 1.1 trace)^2
/// Errors: InvalidArgument, also for fewer than 8 positions, or fewer than 8 and two for each
/// harmonic of each period; PeriodNotResolved.
[[nodiscard]] Result<SmoothedCurve> smoothingSpline(
    const CurveSamples& samples, const SmoothingRequest& request = {});

} // namespace axiscomp
