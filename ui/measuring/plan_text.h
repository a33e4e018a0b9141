// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/measuring_plan.h"

#include <QString>

namespace axiscomp::ui {

/// "25.310", with the decimal sign of the language: as plans have positions.
[[nodiscard]] QString planPositionText(double position);
/// "25.310 mm"
[[nodiscard]] QString planPositionText(double position, bool isAngular);
/// "Axis X, 51 targets, 510 values"
[[nodiscard]] QString planSummaryText(const MeasuringPlan& plan);

} // namespace axiscomp::ui
