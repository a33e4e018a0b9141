// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/measuring_plan.h"

#include <vector>

namespace axiscomp::drivecomm {

/// How an axis moves that a machine's control sends over a plan: at constant feed to where a target
/// is approached from, to the target, and it stands there for the dwell. A pure function of the
/// seconds since its start.
class ProgramMotion {
public:
    /// from: where the axis is when the program starts. The plan has a feed above 0.
    ProgramMotion(const MeasuringPlan& plan, double from);

    [[nodiscard]] double position(double seconds) const;
    /// The step that the axis is moving to or standing at, from 1; after the end the last one.
    [[nodiscard]] int step(double seconds) const;
    /// The ends of all movements after `after`, up to `until`: between two of them the axis does
    /// not turn.
    [[nodiscard]] std::vector<double> movementEnds(double after, double until) const;
    /// When everything has been visited.
    [[nodiscard]] double endSeconds() const { return m_endSeconds; }

private:
    /// A movement, and standing at its end until the next one begins.
    struct Leg {
        double begin = 0.0; ///< seconds
        double end = 0.0;
        double from = 0.0;
        double to = 0.0;
        int step = 1;
    };
    [[nodiscard]] const Leg& legAt(double seconds) const;

    std::vector<Leg> m_legs;
    double m_endSeconds = 0.0;
};

} // namespace axiscomp::drivecomm
