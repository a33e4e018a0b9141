// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/json.h"
#include "core/metrology/judge/deviation_curves.h"
#include "core/metrology/judge/judgement.h"

#include <string>

namespace axiscomp::app {

// What is said of a measurement, for people and as documents of --json (docs/cli.md). Documents
// have mm and degrees, unrounded; targets and runs count from 1.

/// "A", "A up"
[[nodiscard]] std::string shortFigureName(Iso230Figure figure);

/// "9 targets from -20 to 20 mm, 5 runs up, 5 runs down"
[[nodiscard]] std::string measurementSummary(const Measurement& measurement);

/// ", 0 = mean at 15 mm"; empty without a datum.
[[nodiscard]] std::string datumPhrase(const std::optional<PlacedDeviation>& datum, bool isAngular);

/// Figures, targets, drift, outliers, conditions, verdict. datum: position that was stated.
[[nodiscard]] std::string judgementText(const Measurement& measurement, const Judgement& judgement,
    const std::optional<double>& datum = {});

/// {"B", "Bmean", "M", "EUp", ...}; null: not defined.
[[nodiscard]] Json axisFiguresJson(const Iso230Figures& figures);
inline constexpr const char* verdictOfAllValuesHeading = "Verdict of all values";
/// A table of them with a heading; empty without any.
[[nodiscard]] std::string verdictsText(const Measurement& measurement,
    const std::vector<Verdict>& verdicts, const std::string& heading = "Verdict");
/// [{"figure", "value", "tolerance", "U", "result"}]
[[nodiscard]] Json verdictsJson(const std::vector<Verdict>& verdicts);
/// [{"direction", "target", "run"}]
[[nodiscard]] Json excludedJson(const Measurement& measurement);
/// [{"code", "message"}]
[[nodiscard]] Json warningsJson(const std::vector<JudgeWarning>& warnings);
/// Everything of a judgement but source, corrections and uncertainty, which the command knows.
[[nodiscard]] Json judgementJson(const Measurement& measurement, const Judgement& judgement);

} // namespace axiscomp::app
