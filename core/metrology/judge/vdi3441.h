// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/judge/iso230.h"

namespace axiscomp {

/// The evaluation of VDI/DGQ 3441 as it is generally known; its text was not at hand, so these
/// figures are an assumption. U_i = |B_i|, Ps_i = 3 (s_i up + s_i down). In mm or deg.
struct Vdi3441Figures {
    double p = 0.0; ///< max(xm_i + (U_i + Ps_i)/2) - min(xm_i - (U_i + Ps_i)/2)
    double pa = 0.0; ///< max xm_i - min xm_i
    double uMax = 0.0;
    double uMean = 0.0;
    double psMax = 0.0;
    double psMean = 0.0;
};

/// Nothing where a target lacks a direction, or has a single value.
[[nodiscard]] std::optional<Vdi3441Figures> vdi3441Figures(const Iso230Figures& figures);

} // namespace axiscomp
