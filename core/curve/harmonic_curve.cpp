// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curve/harmonic_curve.h"

#include "core/base/portable_math.h"
#include "core/curve/curve_errors.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace axiscomp {

namespace {

Eigen::MatrixXd designOf(const std::vector<PeriodicTerm>& terms, const CurveKnots& knots)
{
    const auto rows = static_cast<Eigen::Index>(knots.positions.size());
    Eigen::MatrixXd design(rows, 1 + 2 * static_cast<Eigen::Index>(terms.size()));
    design.col(0).setOnes();
    for (Eigen::Index i = 0; i < rows; ++i) {
        Eigen::Index column = 0;
        for (const PeriodicTerm& term : terms) {
            const double angle = 2.0 * std::numbers::pi * term.harmonic
                * (knots.positions[static_cast<std::size_t>(i)] / term.period);
            design(i, ++column) = portable::cos(angle);
            design(i, ++column) = portable::sin(angle);
        }
    }
    return design;
}

} // namespace

Result<HarmonicFit> fitHarmonics(const CurveSamples& samples, double turn, int harmonics)
{
    if (harmonics < 1 || harmonics > 1000)
        return badCurve(AXISCOMP_TEXT("Error", "the number of harmonics must be 1 to 1000"));
    const KnownPeriods periods{{turn}, harmonics};
    const std::size_t parameters = 1 + periods.parameterCount();
    AXISCOMP_TRY(const auto knots, curveKnots(samples, turn, parameters + 2));
    AXISCOMP_CHECK(checkResolved(periods, knots.positions, samples.unit));

    HarmonicFit fit;
    fit.curve.terms = termsOf(periods);
    const auto count = static_cast<Eigen::Index>(knots.means.size());
    const Eigen::Map<const Eigen::VectorXd> means(knots.means.data(), count);
    const Eigen::VectorXd roots =
        Eigen::Map<const Eigen::VectorXd>(knots.weights.data(), count).cwiseSqrt();
    const Eigen::MatrixXd design = designOf(fit.curve.terms, knots);
    const Eigen::MatrixXd weighted = roots.asDiagonal() * design;
    const Eigen::ColPivHouseholderQR<Eigen::MatrixXd> solver(weighted);
    const Eigen::VectorXd found = solver.solve(roots.cwiseProduct(means));
    const Eigen::VectorXd residuals = means - design * found;
    const double square = roots.cwiseProduct(residuals).squaredNorm();
    fit.residualRms = std::sqrt(square / roots.squaredNorm());
    fit.residualLargest = residuals.cwiseAbs().maxCoeff();
    const double variance = square / static_cast<double>(knots.means.size() - parameters);
    fit.noise = std::sqrt(variance);

    const Eigen::MatrixXd covariance = variance * (weighted.transpose() * weighted).inverse();
    Eigen::Index column = 1;
    for (PeriodicTerm& term : fit.curve.terms) {
        term.cosine = found[column];
        term.sine = found[column + 1];
        term.standardError = amplitudeError(term, covariance(column, column),
            covariance(column, column + 1), covariance(column + 1, column + 1));
        column += 2;
    }
    const double first = knots.positions.front();
    fit.curve.base = {{first, first + turn}, {found[0], found[0]}, {0.0, 0.0}, turn};
    return fit;
}

} // namespace axiscomp
