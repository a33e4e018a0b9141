// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/judge/iso230.h"

namespace axiscomp {

/// One condition of the standard on how to measure.
struct ComplianceLine {
    std::string_view rule; ///< "targets", "runs", "bidirectional" ..., for programs
    Text text; ///< "at least 5 targets, and 5 for each metre: 9 over 40 mm"
    std::optional<bool> isMet; ///< nothing: not known
    bool isAssumed = false; ///< the number is not from the standard's text, which was not at hand
};

/// "met", "not met"; nothing: "not known".
[[nodiscard]] TextPattern complianceText(std::optional<bool> isMet);

/// Whether it was measured as ISO 230-2 wants it: never a refusal. period: a known period of the
/// axis such as the lead of its screw, in mm or deg.
[[nodiscard]] std::vector<ComplianceLine> complianceOf(
    const Measurement& measurement, const Iso230Figures& figures, std::optional<double> period);

} // namespace axiscomp
