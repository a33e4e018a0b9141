// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <cstddef>
#include <span>
#include <string>
#include <vector>

namespace axiscomp {

/// Periods that are known beforehand: the lead of a screw, the pitch of a grating, one turn.
struct KnownPeriods {
    std::vector<double> periods; ///< > 0, in the unit of the positions
    int harmonics = 1; ///< >= 1: p, p/2, ... p/harmonics of each

    [[nodiscard]] std::size_t parameterCount() const
    {
        return 2 * periods.size() * static_cast<std::size_t>(harmonics);
    }
    /// Of an even grid over `length`, with 20 points for the shortest harmonic: straight lines
    /// between them lose 1.2 % of its amplitude. periods is not empty.
    [[nodiscard]] std::size_t pointsOver(double length) const;

    friend bool operator==(const KnownPeriods&, const KnownPeriods&) = default;
};

/// One harmonic of one period: cosine cos(2 pi k x / p) + sine sin(2 pi k x / p), which is
/// amplitude sin(2 pi k x / p + phase).
struct PeriodicTerm {
    double period = 1.0; ///< p
    int harmonic = 1; ///< k
    double cosine = 0.0; ///< in the unit of the values, as is sine
    double sine = 0.0;
    double standardError = 0.0; ///< of the amplitude; 0: not known

    [[nodiscard]] double amplitude() const;
    [[nodiscard]] double phase() const; ///< rad, -pi to pi
    [[nodiscard]] double at(double position) const;
};

/// By the variances and the covariance of cosine and sine: that of their length along their
/// direction.
[[nodiscard]] double amplitudeError(
    const PeriodicTerm& term, double cosineVariance, double covariance, double sineVariance);

/// The terms of all harmonics, their cosines and sines 0.
[[nodiscard]] std::vector<PeriodicTerm> termsOf(const KnownPeriods& periods);

/// Whether these positions can tell the terms: of max(8, 4 K) classes of the phase (x mod p) / p,
/// max(5, 2 K + 1) must be filled, K the number of harmonics. Errors: PeriodNotResolved;
/// InvalidArgument for periods that make no sense, or twice the same term. unit: of the positions.
[[nodiscard]] Result<void> checkResolved(
    const KnownPeriods& periods, std::span<const double> positions, const std::string& unit);

} // namespace axiscomp
