// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/fit/measurement_fit.h"

namespace axiscomp {

/// Something that was measured, beside the table that was made of it. In mm or deg.
struct FittedPoint {
    double position = 0.0; ///< at which the drive looks the table up
    double value = 0.0; ///< what the table should say there: behind slope and zero
    double residual = 0.0; ///< value less what the drive adds there
    std::optional<double> standardError = {}; ///< of the mean; nothing with a single value

    friend bool operator==(const FittedPoint&, const FittedPoint&) = default;
};

/// Of the table of one axis, ascending: the means of runs and averages, each value of a track.
/// report: of the measurement, by these settings. Points of two or three axes have none.
[[nodiscard]] std::vector<FittedPoint> fittedPoints(
    const Measurement& measurement, const FitSettings& settings, const FitReport& report);

} // namespace axiscomp
