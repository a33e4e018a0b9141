// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/fine_quantity.h"
#include "core/metrology/judge/compliance.h"
#include "core/metrology/judge/drift.h"
#include "core/metrology/judge/outliers.h"
#include "core/metrology/judge/published_figures.h"
#include "core/metrology/judge/uncertainty.h"
#include "core/metrology/judge/vdi3441.h"

namespace axiscomp {

struct JudgeOptions {
    OutlierRule outlierRule = OutlierRule::PooledMad;
    std::vector<Tolerance> tolerances;
    std::optional<double> uncertainty; ///< U with k = 2, in mm or deg
    std::optional<double> period; ///< of the axis, for the conditions of the standard
    bool wantsVdi = false;
};

struct JudgeWarning {
    std::string_view name; ///< "DriftSuspected"
    Text text;
};

/// "9 values excluded, not an evaluation by ISO 230-2"
[[nodiscard]] Text excludedText(std::size_t count);

/// "OtherMachine" and "OtherSerial" of joined files that state different ones: what people write of
/// a machine is no proof that it is another one.
[[nodiscard]] std::vector<JudgeWarning> otherMachines(const Measurement& measurement);

/// A tolerance that only the values in use meet is met by what was chosen: "OtherVerdict" for each
/// of which all values say otherwise. Both lists are of the same tolerances.
[[nodiscard]] std::vector<JudgeWarning> otherVerdicts(std::span<const Verdict> inUse,
    std::span<const Verdict> ofAllValues, bool isAngular, UnitLetters letters = UnitLetters::Ascii);

/// Everything that is said of a measurement. What is defined by values in use leaves those out that
/// were excluded; the figures of all values stand beside it then.
struct Judgement {
    Iso230Figures figures;
    std::optional<Iso230Figures> ofAllValues; ///< only when values were excluded
    DirectionDrift driftUp;
    DirectionDrift driftDown;
    std::optional<Iso230Figures> withoutOffsets; ///< only when a drift is suspected
    Outliers outliers;
    PublishedCheck published;
    std::vector<ComplianceLine> compliance;
    std::optional<Vdi3441Figures> vdi;
    std::vector<Verdict> verdicts;
    std::vector<Verdict> verdictsOfAllValues; ///< with ofAllValues; they decide nothing
    std::vector<JudgeWarning> warnings;

    /// Whether every tolerance is met; true without any.
    [[nodiscard]] bool isWithinTolerances() const;
};

/// measurement: runs or averages.
[[nodiscard]] Judgement judge(const Measurement& measurement, const JudgeOptions& options);

} // namespace axiscomp
