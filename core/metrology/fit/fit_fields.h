// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/fit/measurement_fit.h"

namespace axiscomp {

/// Which settings of a fit mean something for a measurement, with the others as they are. What does
/// not is not asked for; fitMeasurement refuses it.
struct FitFields {
    bool method = false;
    bool smoothness = false;
    bool periods = false;
    bool harmonics = false;
    bool turn = false;
    bool direction = false;
    bool home = false;
    bool slope = false;
    bool drift = false;
    bool within = false; ///< the fewest points for a deviation
    bool holdsEnds = false;
    bool even = false; ///< the grid of the targets, or of the points
    bool body = false; ///< removal of how an artefact lay
    bool farPoints = false;
    bool robust = false;
};
[[nodiscard]] FitFields fitFields(const Measurement& measurement, const FitSettings& settings);

/// Whether the method can be chosen for this kind of measurement.
[[nodiscard]] bool isMethodFor(MeasurementKind kind, FitMethod method);

/// The settings with those that mean nothing for the measurement as if they were not given, so that
/// what was chosen for another one does not stand in the way.
[[nodiscard]] FitSettings settingsFor(const Measurement& measurement, FitSettings settings);

/// The settings without lengths of the axis: home, the position of the zero, a turn, periods, the
/// grid and what it may lose, and the speed. 10 mm say nothing of an axis in degrees.
[[nodiscard]] FitSettings withoutLengths(FitSettings settings);

} // namespace axiscomp
