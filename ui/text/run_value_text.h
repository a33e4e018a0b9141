// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/measurement.h"

#include <QString>

namespace axiscomp::ui {

class FineScale;

/// One value of a measurement for those who do not see it: "down, target 1, run 1, 93.20 µm,
/// proposed for exclusion", or ", excluded".
[[nodiscard]] QString runValueText(
    const RunValue& value, const FineScale& scale, bool isProposedForExclusion);

} // namespace axiscomp::ui
