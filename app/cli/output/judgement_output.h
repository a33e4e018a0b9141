// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/json.h"
#include "core/metrology/judge/judgement.h"

#include <string>

namespace axiscomp::app {

// What is said of a measurement, for people and as documents of --json (docs/cli.md). Documents
// have mm and degrees, unrounded; targets and runs count from 1.

/// "9 targets from -20 to 20 mm, 5 runs up, 5 runs down"
[[nodiscard]] std::string measurementSummary(const Measurement& measurement);

/// Figures, targets, drift, outliers, conditions, verdict.
[[nodiscard]] std::string judgementText(const Measurement& measurement, const Judgement& judgement);

/// {"B", "Bmean", "M", "EUp", ...}; null: not defined.
[[nodiscard]] Json axisFiguresJson(const Iso230Figures& figures);
/// Everything of a judgement but source, corrections and uncertainty, which the command knows.
[[nodiscard]] Json judgementJson(const Measurement& measurement, const Judgement& judgement);

} // namespace axiscomp::app
