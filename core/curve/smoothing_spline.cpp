// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curve/smoothing_spline.h"

#include "core/base/portable_math.h"
#include "core/curve/band_solver.h"
#include "core/curve/curve_errors.h"

#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace axiscomp {

namespace {

constexpr double noScore = std::numeric_limits<double>::infinity();
constexpr double traceFactor = 1.1;
constexpr double widestDecade = 10.0; // of L / r, downward

using SplineNumbers = std::vector<double>;

/// The equations of Reinsch: with Q the second differences of values at knots and R the Gram matrix
/// of the hats between them, K = Q R^-1 Q^T, and the second derivatives c of the smoothing spline
/// solve (R + L Q^T W^-1 Q) c = Q^T y; its residuals are L W^-1 Q c. Positions are scaled so that
/// knots are 1 apart on average.
class SplineEquations {
public:
    SplineEquations(const CurveKnots& knots, std::optional<double> wrap);

    [[nodiscard]] std::size_t knotCount() const { return m_weights.size(); }
    [[nodiscard]] const SplineNumbers& weights() const { return m_weights; }
    /// r, of scaled positions.
    [[nodiscard]] double penaltyUnit() const { return m_penaltyUnit; }
    [[nodiscard]] double lengthUnit() const { return m_lengthUnit; }

    /// For the penalty L: false when it cannot be solved in double precision.
    [[nodiscard]] bool usePenalty(double penalty);
    /// What the spline leaves of values at the knots.
    [[nodiscard]] SplineNumbers residuals(const SplineNumbers& values) const;
    /// The trace of the matrix that makes fitted values of values.
    [[nodiscard]] double trace()
    {
        return static_cast<double>(knotCount())
            - m_penalty * m_solver.traceOfInverseTimes(m_roughness);
    }

private:
    [[nodiscard]] std::size_t before(std::size_t knot) const
    {
        return knot == 0 ? knotCount() - 1 : knot - 1;
    }
    [[nodiscard]] std::size_t behind(std::size_t knot) const
    {
        return knot + 1 == knotCount() ? 0 : knot + 1;
    }
    void fillGram();
    void fillRoughness(const SplineNumbers& weights, BandMatrix& matrix) const;

    bool m_isRing;
    std::size_t m_firstKnot; ///< of those with a second derivative
    double m_lengthUnit;
    SplineNumbers m_inverseWidths; ///< of the cell behind each knot
    SplineNumbers m_weights;
    BandMatrix m_gram; ///< R
    BandMatrix m_roughness; ///< Q^T W^-1 Q
    BandMatrix m_matrix;
    BandSolver m_solver;
    double m_penaltyUnit = 0.0;
    double m_penalty = 0.0;
};

SplineEquations::SplineEquations(const CurveKnots& knots, std::optional<double> wrap)
    : m_isRing(wrap.has_value())
    , m_firstKnot(m_isRing ? 0 : 1)
    , m_weights(knots.weights)
    , m_gram(knots.means.size() - 2 * m_firstKnot)
    , m_roughness(m_gram.size())
    , m_matrix(m_gram.size())
    , m_solver(m_gram.size(), m_isRing)
{
    const SplineNumbers& x = knots.positions;
    const std::size_t last = x.size() - 1;
    m_lengthUnit = m_isRing ? *wrap / static_cast<double>(x.size())
                            : (x.back() - x.front()) / static_cast<double>(last);
    for (std::size_t i = 0; i < last; ++i)
        m_inverseWidths.push_back(m_lengthUnit / (x[i + 1] - x[i]));
    m_inverseWidths.push_back(m_isRing ? m_lengthUnit / (x.front() + *wrap - x.back()) : noScore);
    fillGram();
    fillRoughness(SplineNumbers(x.size(), 1.0), m_matrix);
    double weight = 0.0;
    for (const double w : m_weights)
        weight += w;
    if (m_solver.factorize(m_gram))
        m_penaltyUnit = weight / m_solver.traceOfInverseTimes(m_matrix);
    fillRoughness(m_weights, m_roughness);
}

void SplineEquations::fillGram()
{
    for (std::size_t row = 0; row < m_gram.size(); ++row) {
        const std::size_t knot = row + m_firstKnot;
        const double left = 1.0 / m_inverseWidths[before(knot)];
        const double right = 1.0 / m_inverseWidths[knot];
        m_gram.diagonal[row] = (left + right) / 3.0;
        m_gram.nextToIt[row] = m_isRing || row + 1 < m_gram.size() ? right / 6.0 : 0.0;
    }
}

void SplineEquations::fillRoughness(const SplineNumbers& weights, BandMatrix& matrix) const
{
    const std::size_t size = matrix.size();
    for (std::size_t row = 0; row < size; ++row) {
        const std::size_t knot = row + m_firstKnot;
        const std::size_t next = behind(knot);
        const double left = m_inverseWidths[before(knot)];
        const double right = m_inverseWidths[knot];
        matrix.diagonal[row] = left * left / weights[before(knot)]
            + (left + right) * (left + right) / weights[knot] + right * right / weights[next];
        matrix.nextToIt[row] = 0.0;
        matrix.secondNext[row] = 0.0;
        if (!m_isRing && row + 1 >= size)
            continue;
        const double further = m_inverseWidths[next];
        matrix.nextToIt[row] =
            -right * (left + right) / weights[knot] - right * (right + further) / weights[next];
        if (m_isRing || row + 2 < size)
            matrix.secondNext[row] = right * further / weights[next];
    }
}

bool SplineEquations::usePenalty(double penalty)
{
    m_penalty = penalty;
    for (std::size_t i = 0; i < m_matrix.size(); ++i) {
        m_matrix.diagonal[i] = m_gram.diagonal[i] + penalty * m_roughness.diagonal[i];
        m_matrix.nextToIt[i] = m_gram.nextToIt[i] + penalty * m_roughness.nextToIt[i];
        m_matrix.secondNext[i] = penalty * m_roughness.secondNext[i];
    }
    return m_solver.factorize(m_matrix);
}

SplineNumbers SplineEquations::residuals(const SplineNumbers& values) const
{
    SplineNumbers bends(m_matrix.size());
    for (std::size_t row = 0; row < bends.size(); ++row) {
        const std::size_t knot = row + m_firstKnot;
        bends[row] = (values[behind(knot)] - values[knot]) * m_inverseWidths[knot]
            - (values[knot] - values[before(knot)]) * m_inverseWidths[before(knot)];
    }
    m_solver.solve(bends);
    SplineNumbers left(knotCount(), 0.0);
    for (std::size_t row = 0; row < bends.size(); ++row) {
        const std::size_t knot = row + m_firstKnot;
        const double back = bends[row] * m_inverseWidths[before(knot)];
        const double forth = bends[row] * m_inverseWidths[knot];
        left[before(knot)] += back;
        left[knot] -= back + forth;
        left[behind(knot)] += forth;
    }
    for (std::size_t i = 0; i < left.size(); ++i)
        left[i] *= m_penalty / m_weights[i];
    return left;
}

/// One spline with the terms of known periods. The terms T are fitted to what the spline leaves:
/// with A the matrix of the spline alone, T^T W (1 - A) T b = T^T W (1 - A) y.
class SplineFit {
public:
    SplineFit(const CurveKnots& knots, const SmoothingRequest& request);

    struct Solution {
        bool isFound = false;
        double trace = 0.0;
        double square = 0.0; ///< sum w r^2
        double score = noScore; ///< generalised cross-validation
        SplineNumbers residuals; ///< of spline and terms
        Eigen::VectorXd terms; ///< cosine and sine of each
        Eigen::MatrixXd termCovariance; ///< for noise of 1
    };
    /// smoothness: L / r
    [[nodiscard]] Solution solve(double smoothness);
    [[nodiscard]] double bestSmoothness();
    [[nodiscard]] SmoothedCurve curve(double smoothness);

private:
    [[nodiscard]] double scoreAt(double decade) { return solve(portable::pow(10.0, decade)).score; }
    void addTerms(Solution& solution) const;
    void setTerms(const Solution& solution, double noise, FittedCurve& curve) const;

    const CurveKnots& m_knots;
    std::optional<double> m_wrap;
    std::vector<PeriodicTerm> m_terms;
    std::vector<SplineNumbers> m_columns; ///< the terms at the knots
    SplineEquations m_equations;
};

SplineFit::SplineFit(const CurveKnots& knots, const SmoothingRequest& request)
    : m_knots(knots)
    , m_wrap(request.wrap)
    , m_terms(termsOf(request.periods))
    , m_equations(knots, request.wrap)
{
    for (const PeriodicTerm& term : m_terms) {
        for (const bool isSine : {false, true}) {
            PeriodicTerm unit = term;
            (isSine ? unit.sine : unit.cosine) = 1.0;
            SplineNumbers column;
            for (const double position : knots.positions)
                column.push_back(unit.at(position));
            m_columns.push_back(std::move(column));
        }
    }
}

void SplineFit::addTerms(Solution& solution) const
{
    const auto rows = static_cast<Eigen::Index>(m_knots.means.size());
    const auto count = static_cast<Eigen::Index>(m_columns.size());
    const auto column = [rows](const SplineNumbers& numbers) {
        return Eigen::Map<const Eigen::VectorXd>(numbers.data(), rows);
    };
    Eigen::MatrixXd terms(rows, count);
    Eigen::MatrixXd left(rows, count);
    for (Eigen::Index i = 0; i < count; ++i) {
        const SplineNumbers& numbers = m_columns[static_cast<std::size_t>(i)];
        terms.col(i) = column(numbers);
        left.col(i) = column(m_equations.residuals(numbers));
    }
    const auto weights = column(m_equations.weights()).asDiagonal();
    const Eigen::LDLT<Eigen::MatrixXd> normal(terms.transpose() * weights * left);
    const Eigen::MatrixXd twice = left.transpose() * weights * left;
    Eigen::Map<Eigen::VectorXd> residuals(solution.residuals.data(), rows);
    solution.terms = normal.solve(terms.transpose() * weights * residuals);
    residuals -= left * solution.terms;
    const Eigen::MatrixXd share = normal.solve(twice);
    solution.trace += share.trace();
    solution.termCovariance = normal.solve(share.transpose());
    if (normal.info() != Eigen::Success || !solution.terms.allFinite())
        solution.isFound = false;
}

SplineFit::Solution SplineFit::solve(double smoothness)
{
    Solution solution;
    solution.isFound = m_equations.usePenalty(smoothness * m_equations.penaltyUnit());
    if (!solution.isFound)
        return solution;
    solution.trace = m_equations.trace();
    solution.residuals = m_equations.residuals(m_knots.means);
    if (!m_terms.empty())
        addTerms(solution);
    for (std::size_t i = 0; i < solution.residuals.size(); ++i)
        solution.square += m_equations.weights()[i] * solution.residuals[i] * solution.residuals[i];
    const auto count = static_cast<double>(m_knots.means.size());
    const double freedom = count - traceFactor * solution.trace;
    if (solution.isFound && freedom > 0.0 && std::isfinite(solution.square))
        solution.score = count * solution.square / (freedom * freedom);
    return solution;
}

double SplineFit::bestSmoothness()
{
    // the stiffest curves of m knots lie at m^4
    const double highest = std::max(widestDecade,
        std::ceil(4.0 * portable::log10(static_cast<double>(m_knots.means.size())) - 6.0));
    double best = highest;
    double bestScore = noScore;
    for (double decade = -widestDecade; decade <= highest; decade += 1.0) {
        const double score = scoreAt(decade);
        if (score < bestScore) {
            best = decade;
            bestScore = score;
        }
    }
    // golden section around the best decade
    constexpr double share = 1.0 / std::numbers::phi;
    double low = std::max(best - 1.0, -widestDecade);
    double high = std::min(best + 1.0, highest);
    double left = high - share * (high - low);
    double right = low + share * (high - low);
    double leftScore = scoreAt(left);
    double rightScore = scoreAt(right);
    while (high - low > 0.02) {
        if (leftScore <= rightScore) {
            high = right;
            right = left;
            rightScore = leftScore;
            left = high - share * (high - low);
            leftScore = scoreAt(left);
        } else {
            low = left;
            left = right;
            leftScore = rightScore;
            right = low + share * (high - low);
            rightScore = scoreAt(right);
        }
    }
    const double refined = 0.5 * (low + high);
    return portable::pow(10.0, scoreAt(refined) <= bestScore ? refined : best);
}

void SplineFit::setTerms(const Solution& solution, double noise, FittedCurve& curve) const
{
    curve.terms = m_terms;
    const Eigen::MatrixXd covariance = noise * noise * solution.termCovariance;
    Eigen::Index i = 0;
    for (PeriodicTerm& term : curve.terms) {
        term.cosine = solution.terms[i];
        term.sine = solution.terms[i + 1];
        term.standardError =
            amplitudeError(term, covariance(i, i), covariance(i, i + 1), covariance(i + 1, i + 1));
        i += 2;
    }
}

SmoothedCurve SplineFit::curve(double smoothness)
{
    const Solution solution = solve(smoothness);
    SmoothedCurve result;
    const auto count = static_cast<double>(m_knots.means.size());
    double weight = 0.0;
    for (const double w : m_knots.weights)
        weight += w;
    for (const double residual : solution.residuals)
        result.residualLargest = std::max(result.residualLargest, std::abs(residual));
    result.smoothness = smoothness;
    const double unit = m_equations.lengthUnit();
    result.penalty = smoothness * m_equations.penaltyUnit() * unit * unit * unit;
    result.parameters = solution.trace;
    result.crossValidation = std::sqrt(solution.score);
    result.residualRms = std::sqrt(solution.square / weight);
    result.noise = std::sqrt(solution.square / std::max(count - solution.trace, 1.0));
    if (!m_terms.empty())
        setTerms(solution, result.noise, result.curve);

    CubicCurve& base = result.curve.base;
    base.knots = m_knots.positions;
    base.wrap = m_wrap;
    for (std::size_t i = 0; i < base.knots.size(); ++i) {
        double fitted = m_knots.means[i] - solution.residuals[i];
        for (const PeriodicTerm& term : result.curve.terms)
            fitted -= term.at(base.knots[i]);
        base.values.push_back(fitted);
    }
    closeIfWrapped(base);
    base.slopes = splineSlopes(base.knots, base.values, m_wrap.has_value());
    return result;
}

/// On a modulo axis the terms repeat with the turn, or there would be a step at its end.
Result<void> checkPeriodsClose(const SmoothingRequest& request, const std::string& unit)
{
    if (!request.wrap)
        return {};
    for (const double period : request.periods.periods) {
        const double turns = *request.wrap / period;
        if (std::abs(turns - std::round(turns)) > 1e-9 * turns)
            return badCurve(AXISCOMP_TEXT("Error",
                "the period {period} does not divide the turn of {turn}; on a modulo axis it must")
                                .with("period", placeQuantity(period, unit))
                                .with("turn", placeQuantity(*request.wrap, unit)));
    }
    return {};
}

CubicCurve throughMeans(CurveKnots knots, std::optional<double> wrap)
{
    CubicCurve curve{std::move(knots.positions), std::move(knots.means), {}, wrap};
    closeIfWrapped(curve);
    return curve;
}

} // namespace

Result<FittedCurve> interpolatingSpline(const CurveSamples& samples, std::optional<double> wrap)
{
    AXISCOMP_TRY(auto knots, curveKnots(samples, wrap, 2));
    CubicCurve curve = throughMeans(std::move(knots), wrap);
    curve.slopes = splineSlopes(curve.knots, curve.values, wrap.has_value());
    return FittedCurve{std::move(curve)};
}

Result<FittedCurve> straightLines(const CurveSamples& samples, std::optional<double> wrap)
{
    AXISCOMP_TRY(auto knots, curveKnots(samples, wrap, 2));
    return FittedCurve{throughMeans(std::move(knots), wrap)};
}

Result<FittedCurve> monotoneCubic(const CurveSamples& samples, std::optional<double> wrap)
{
    AXISCOMP_TRY(auto knots, curveKnots(samples, wrap, 2));
    CubicCurve curve = throughMeans(std::move(knots), wrap);
    curve.slopes = monotoneSlopes(curve.knots, curve.values, wrap.has_value());
    return FittedCurve{std::move(curve)};
}

Result<SmoothedCurve> smoothingSpline(const CurveSamples& samples, const SmoothingRequest& request)
{
    constexpr std::size_t fewest = 8;
    const double wanted = request.smoothness.value_or(1.0);
    if (!(std::isfinite(wanted) && wanted > 0.0))
        return badCurve(AXISCOMP_TEXT("Error", "the smoothness must be a number above 0"));
    AXISCOMP_TRY(const auto knots, curveKnots(samples, request.wrap, 2));
    AXISCOMP_CHECK(checkPeriodsClose(request, samples.unit));
    AXISCOMP_CHECK(checkResolved(request.periods, knots.positions, samples.unit));
    AXISCOMP_CHECK(curveKnots(samples, request.wrap, fewest + request.periods.parameterCount()));
    SplineFit fit(knots, request);
    const double smoothness = request.smoothness ? *request.smoothness : fit.bestSmoothness();
    if (!fit.solve(smoothness).isFound)
        return badCurve(AXISCOMP_TEXT("Error",
            "a smoothness of {smoothness} cannot be computed for these positions; take a smaller "
            "one")
                            .with("smoothness", Quantity{roundedText(smoothness)}));
    return fit.curve(smoothness);
}

} // namespace axiscomp
