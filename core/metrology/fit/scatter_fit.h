// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/curve/smoothing_spline.h"
#include "core/metrology/fit/grid_fit.h"
#include "core/metrology/fit/scatter.h"

namespace axiscomp {

// Of a track in both directions, each is fitted by itself, and the mean of the fits is taken:
// however the directions share the samples, the reversal is no part of it.

/// The smoothing spline through a track, where one is asked for; through what the table lacks that
/// it is merged onto, and with that table. Errors: those of smoothingSpline; InvalidArgument for
/// two directions without a part of the way in common.
[[nodiscard]] Result<std::optional<SmoothedCurve>> curveOf(
    const FitInput& input, const Scatter& scatter, const ActiveTable& onto);
/// What the table lacks that a column is merged onto, at the nodes of a grid. Errors: those of
/// fitGrid, and of curveOf for two directions.
[[nodiscard]] Result<GridFit> fitOntoGrid(const Scatter& scatter, const Scatter::Column& column,
    const ActiveTable& onto, const GridFitRequest& request);

} // namespace axiscomp
