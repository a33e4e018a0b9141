// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/fine_quantity.h"
#include "core/metrology/judge/uncertainty.h"
#include "core/metrology/measurement.h"
#include "ui/style/contrast.h"
#include "ui/text/fine_scale.h"

#include <QString>

#include <optional>

namespace axiscomp::ui {

// What tables of a judgement have in their cells.

[[nodiscard]] QString noFigure(); ///< for one that is not defined
/// value: in mm or deg. In the unit that the heading names.
[[nodiscard]] QString shownOrNothing(const FineUnit& unit, const std::optional<double>& value,
    int decimals = FineScale::usualDecimals);
/// Likewise, with the unit that suits it.
[[nodiscard]] QString aloneOrNothing(const std::optional<double>& value, bool isAngular);
/// "↑ up": the arrow of the plot, and the word of the standard.
[[nodiscard]] QString directionText(Approach direction);
[[nodiscard]] Tone toneOf(VerdictResult result);

} // namespace axiscomp::ui
