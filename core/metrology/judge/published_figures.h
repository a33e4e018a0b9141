// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/judge/iso230.h"

namespace axiscomp {

/// A result that a file carries, beside ours.
struct PublishedComparison {
    Iso230Figure figure = Iso230Figure::A;
    double published = 0.0; ///< in mm or deg
    std::optional<double> computed;
    double tolerance = 0.0; ///< half of its last digit, and what the digits of the values allow
    bool agrees = true;
    std::size_t line = 0;
};

/// What contradicts in the results of a file.
struct PublishedCheck {
    std::vector<PublishedComparison> comparisons;
    /// "the file says E = 0.09065 mm, which is less than its own E, down = 0.09803 mm; computed
    /// from its values: 0.12285 mm"
    std::vector<Text> contradictions;
};

/// Compares the results in a file with those of its values, and with each other: E is never below
/// E up, E down and M, A never below A up, A down, E and R, R never below R up, R down and B.
[[nodiscard]] PublishedCheck checkPublished(
    const Measurement& measurement, const Iso230Figures& figures);

} // namespace axiscomp
