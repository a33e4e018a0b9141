// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/json.h"
#include "core/base/error.h"
#include "core/csv/calibration_csv.h"
#include "core/text/diagnostic.h"

namespace axiscomp::app {

// The documents of --json: stable, described in docs/cli.md. Numbers are exact.

/// Indented, with a line end. Text that is not UTF-8 is repaired rather than refused.
[[nodiscard]] std::string dump(const Json& json);

[[nodiscard]] std::vector<std::string> englishOf(const std::vector<Text>& texts);
/// null where there is none
[[nodiscard]] Json textOrNull(const std::string& text);

/// {"code", "line", "column", "message"}
[[nodiscard]] Json toJson(const Diagnostic& diagnostic);
/// [{"name", "unit", "start", "distance", "size"}]
[[nodiscard]] Json toJson(const Grid& grid);
/// [[2, 0], ...]: the points that were made up, by their indices in each dimension, from 0
[[nodiscard]] Json filledJson(
    const std::vector<std::uint32_t>& filled, const std::vector<std::size_t>& sizes);
/// {"name", "target", "unit", "min", "max", "rms", "filled"}
[[nodiscard]] Json toJson(const CompensationTable& table);
/// {"code", "message", "context", "diagnostics"}
[[nodiscard]] Json toJson(const Error& error, const Json& diagnostics);

} // namespace axiscomp::app
