// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curve/curve_samples.h"

#include "core/curve/curve_errors.h"

#include <algorithm>
#include <cmath>
#include <tuple>

namespace axiscomp {

namespace {

struct PlacedSample {
    double position;
    double value;
    double weight;
};

bool areFiniteSamples(std::span<const double> numbers)
{
    return std::ranges::all_of(numbers, [](double number) { return std::isfinite(number); });
}

Result<void> checkSamples(const CurveSamples& samples, std::optional<double> wrap)
{
    const std::size_t count = samples.positions.size();
    const bool isComplete = samples.values.size() == count
        && (samples.weights.empty() || samples.weights.size() == count);
    if (!isComplete)
        return badCurve(AXISCOMP_TEXT("Error", "each position must have one value and one weight"));
    if (!areFiniteSamples(samples.positions) || !areFiniteSamples(samples.values)
        || !areFiniteSamples(samples.weights))
        return badCurve(
            AXISCOMP_TEXT("Error", "positions, values and weights must be finite numbers"));
    if (std::ranges::any_of(samples.weights, [](double weight) { return !(weight > 0.0); }))
        return badCurve(AXISCOMP_TEXT("Error", "weights must be larger than 0"));
    if (wrap && !(std::isfinite(*wrap) && *wrap > 0.0))
        return badCurve(
            AXISCOMP_TEXT("Error", "the period of a modulo axis must be a number above 0"));
    return {};
}

std::vector<PlacedSample> sortedSamples(const CurveSamples& samples, std::optional<double> wrap)
{
    std::vector<PlacedSample> all;
    all.reserve(samples.positions.size());
    for (std::size_t i = 0; i < samples.positions.size(); ++i)
        all.push_back({samples.positions[i], samples.values[i],
            samples.weights.empty() ? 1.0 : samples.weights[i]});
    if (wrap && !all.empty()) {
        const double first = std::ranges::min_element(all, {}, &PlacedSample::position)->position;
        for (PlacedSample& sample : all) {
            sample.position -= std::floor((sample.position - first) / *wrap) * *wrap;
            if (first + *wrap - sample.position <= 1e-9 * *wrap) // the first place again
                sample.position = first;
        }
    }
    std::ranges::sort(all, {}, [](const PlacedSample& sample) {
        return std::tuple(sample.position, sample.value, sample.weight);
    });
    return all;
}

} // namespace

Result<CurveKnots> curveKnots(
    const CurveSamples& samples, std::optional<double> wrap, std::size_t fewest)
{
    AXISCOMP_CHECK(checkSamples(samples, wrap));
    const std::vector<PlacedSample> all = sortedSamples(samples, wrap);
    CurveKnots knots;
    if (!all.empty()) {
        const double range = wrap.value_or(all.back().position - all.front().position);
        for (const PlacedSample& sample : all) {
            const bool isNew =
                knots.positions.empty() || sample.position - knots.positions.back() > 1e-9 * range;
            if (isNew) {
                knots.positions.push_back(sample.position);
                knots.means.push_back(0.0);
                knots.weights.push_back(0.0);
            }
            knots.means.back() += sample.weight * sample.value;
            knots.weights.back() += sample.weight;
        }
    }
    for (std::size_t i = 0; i < knots.means.size(); ++i)
        knots.means[i] /= knots.weights[i];
    if (knots.positions.size() < fewest)
        return badCurve(AXISCOMP_TEXT("Error",
            "there are values at {count} positions; this method needs {fewest}, measure more of "
            "them or choose another method")
                            .with("count", knots.positions.size())
                            .with("fewest", fewest));
    return knots;
}

} // namespace axiscomp
