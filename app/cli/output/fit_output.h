// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/json.h"
#include "core/drive/drive_profile.h"
#include "core/metrology/fit/measurement_fit.h"

#include <string>
#include <vector>

namespace axiscomp::app {

// What is said of tables that were made of a measurement, for people and as documents of --json
// (docs/cli.md). Documents have mm and degrees, unrounded.

/// State, tables, figures before and foretold, sign, remarks, verdict.
[[nodiscard]] std::string fitText(const Measurement& measurement, const FitSettings& settings,
    const FitReport& report, const std::vector<std::uint32_t>& crcs, const DriveProfile& profile);

/// Everything of it but source, corrections and output, which the command knows. crcs: of the
/// tables.
[[nodiscard]] Json fitJson(const Measurement& measurement, const FitSettings& settings,
    const FitReport& report, const std::vector<std::uint32_t>& crcs);

} // namespace axiscomp::app
