// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/json.h"
#include "core/metrology/judge/deviation_curves.h"
#include "core/metrology/record/comparison.h"

#include <string>

namespace axiscomp::app {

// What is said of a machine before and after a compensation, for people and as documents of --json
// (docs/cli.md). Documents have mm and degrees, unrounded. after: the second measurement.

/// Figures side by side, what was promised, what is left at the targets from a datum, hints,
/// verdict.
[[nodiscard]] std::string comparisonText(const Measurement& after, const Comparison& comparison,
    const std::optional<PlacedDeviation>& datum);

/// Everything of it but sources and uncertainty, which the command knows.
[[nodiscard]] Json comparisonJson(const Measurement& after, const Comparison& comparison);

} // namespace axiscomp::app
