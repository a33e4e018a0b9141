// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/metrology/measurement.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

// The order in which a machine visits the targets of a measurement. Positions in mm or deg.

struct MeasuringStep {
    int step = 1; ///< from 1
    int run = 1; ///< from 1, counted for each direction
    Approach direction = Approach::Up;
    double target = 0.0;
    double approach = 0.0; ///< where the axis comes from: below the target going up, above it going
                           ///< down

    friend bool operator==(const MeasuringStep&, const MeasuringStep&) = default;
};

inline constexpr std::size_t mostPlanSteps = 100'000;
inline constexpr double largestPlanPosition = 1e6; ///< in mm or deg, from zero

struct MeasuringPlan {
    std::string axis; ///< "X"
    bool isAngular = false; ///< deg, and deg/min
    double overrun =
        0.0; ///< how far an axis moves in the direction of a run before its first target
    double feedPerMinute = 0.0;
    double dwellSeconds = 0.0; ///< at each target
    std::optional<double> period; ///< over which the targets were spread
    std::uint64_t seed = 0;
    std::vector<MeasuringStep> steps; ///< 1 to mostPlanSteps

    friend bool operator==(const MeasuringPlan&, const MeasuringPlan&) = default;
};

struct MeasuringPlanRequest {
    std::string axis = "X";
    bool isAngular = false;
    double from = 0.0; ///< the first target
    double to = 0.0; ///< the last one, above it
    std::optional<int> count; ///< of targets: this or spacing
    std::optional<double> spacing; ///< the mean distance of targets
    std::optional<double> period; ///< of the axis's periodic error, such as the lead of its screw
    int cycles = 5; ///< runs in each direction
    std::uint64_t seed = 1; ///< the same seed gives the same targets
    std::optional<double> overrun; ///< none: 1 % of the range, at most a third of the spacing
    double feedPerMinute = 1000.0;
    double dwellSeconds = 5.0;
};

/// What of a request is impossible. Targets: their count or spacing.
enum class MeasuringPlanField { Axis, From, To, Targets, Period, Cycles, Overrun, Feed, Dwell };
struct MeasuringPlanFault {
    MeasuringPlanField field = MeasuringPlanField::From;
    Text reason; ///< has the way out
};
/// The first one; none: makeMeasuringPlan() makes the plan.
[[nodiscard]] std::optional<MeasuringPlanFault> measuringPlanFault(
    const MeasuringPlanRequest& request);

/// Bidirectional runs over uneven targets, as ISO 230-2 asks for:
///     P_i = from + (i - 1) p + r_i,  p = (to - from) / (count - 1),  r_1 = r_m = 0
/// r_i is even within +-period, where there is one, else within +-0.3 p (ours), as far as
/// neighbours stay at least p/3 apart. Targets are whole thousandths of mm or deg, as they are
/// printed. Each cycle goes up over all targets, past the last by the overrun, and down over all.
/// Errors: InvalidArgument, the reason has the way out.
[[nodiscard]] Result<MeasuringPlan> makeMeasuringPlan(const MeasuringPlanRequest& request);

/// "25.310": as plans and programs print positions.
[[nodiscard]] std::string planPosition(double position);
/// How far the axis goes, overrun included.
struct PlanTravel {
    double lowest = 0.0;
    double highest = 0.0;
};
[[nodiscard]] PlanTravel planTravel(const MeasuringPlan& plan);
/// The targets, ascending, each once.
[[nodiscard]] std::vector<double> targetsOf(const MeasuringPlan& plan);

/// // axiscomp plan: 1, statements, and step,run,direction,target [mm],approach [mm].
[[nodiscard]] std::string measuringPlanCsv(const MeasuringPlan& plan);

inline constexpr std::size_t mostPlanBytes = 16 * 1024 * 1024;
/// Errors: FileNotReadable with the line, what is wrong there and what is expected.
[[nodiscard]] Result<MeasuringPlan> readMeasuringPlan(
    std::string_view text, const std::string& fileName);

} // namespace axiscomp
