// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curve/periodic_terms.h"

#include "core/base/portable_math.h"
#include "core/curve/curve_errors.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace axiscomp {

namespace {

double angleOf(const PeriodicTerm& term, double position)
{
    return 2.0 * std::numbers::pi * term.harmonic * (position / term.period);
}

std::size_t filledClasses(double period, std::size_t classes, std::span<const double> positions)
{
    std::vector<bool> isFilled(classes, false);
    for (const double position : positions) {
        const double phase = position / period - std::floor(position / period);
        const auto number = static_cast<std::size_t>(phase * static_cast<double>(classes));
        isFilled[std::min(number, classes - 1)] = true;
    }
    return static_cast<std::size_t>(std::ranges::count(isFilled, true));
}

Result<void> checkPeriods(const KnownPeriods& periods, const std::string& unit)
{
    if (periods.harmonics < 1)
        return badCurve(AXISCOMP_TEXT("Error", "a period has at least one harmonic"));
    for (const double period : periods.periods)
        if (!(std::isfinite(period) && period > 0.0))
            return badCurve(AXISCOMP_TEXT("Error", "a period must be a number above 0"));
    std::vector<double> lengths;
    for (const PeriodicTerm& term : termsOf(periods))
        lengths.push_back(term.period / term.harmonic);
    std::ranges::sort(lengths);
    for (std::size_t i = 1; i < lengths.size(); ++i)
        if (lengths[i] - lengths[i - 1] <= 1e-9 * lengths[i])
            return badCurve(AXISCOMP_TEXT("Error",
                "the period {period} is wanted twice, by itself or as a harmonic of another; "
                "give each once")
                                .with("period", placeQuantity(lengths[i], unit)));
    return {};
}

} // namespace

std::size_t KnownPeriods::pointsOver(double length) const
{
    const double shortest = std::ranges::min(periods) / static_cast<double>(harmonics);
    return static_cast<std::size_t>(std::ceil(20.0 * length / shortest)) + 1;
}

double PeriodicTerm::amplitude() const
{
    return portable::hypot(cosine, sine);
}

double PeriodicTerm::phase() const
{
    return portable::atan2(cosine, sine);
}

double PeriodicTerm::at(double position) const
{
    const double angle = angleOf(*this, position);
    return cosine * portable::cos(angle) + sine * portable::sin(angle);
}

double amplitudeError(
    const PeriodicTerm& term, double cosineVariance, double covariance, double sineVariance)
{
    const double angle = term.phase();
    const double c = portable::sin(angle);
    const double s = portable::cos(angle);
    const double variance =
        c * c * cosineVariance + 2.0 * c * s * covariance + s * s * sineVariance;
    return std::sqrt(std::max(variance, 0.0));
}

std::vector<PeriodicTerm> termsOf(const KnownPeriods& periods)
{
    std::vector<PeriodicTerm> terms;
    for (const double period : periods.periods)
        for (int harmonic = 1; harmonic <= periods.harmonics; ++harmonic)
            terms.push_back({.period = period, .harmonic = harmonic});
    return terms;
}

Result<void> checkResolved(
    const KnownPeriods& periods, std::span<const double> positions, const std::string& unit)
{
    AXISCOMP_CHECK(checkPeriods(periods, unit));
    const auto harmonics = static_cast<std::size_t>(periods.harmonics);
    const std::size_t classes = std::max<std::size_t>(8, 4 * harmonics);
    const std::size_t fewest = std::max<std::size_t>(5, 2 * harmonics + 1);
    for (const double period : periods.periods) {
        const std::size_t filled = filledClasses(period, classes, positions);
        if (filled < fewest)
            return fail(ErrorCode::PeriodNotResolved,
                {{"period", placeQuantity(period, unit)}, {"filled", filled}, {"classes", classes},
                    {"fewest", fewest}});
    }
    return {};
}

} // namespace axiscomp
