// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/measuring_plan.h"

#include <chrono>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace axiscomp {

/// What was read at one instant. Positions in mm or deg, as the plan has them.
struct CaptureReading {
    std::chrono::nanoseconds time{0}; ///< from any beginning; may jump
    double encoder = 0.0; ///< raw
    double output = 0.0; ///< what the drive adds: the axis stands at encoder + output
    double reference = 0.0; ///< what the instrument says; NaN: nothing that can be used
    std::string state; ///< of the compensation: its state, and the table that is active
    /// Whether the table that is active lies over the positions and sources of the beginning, which
    /// its CRC does not say.
    bool isSamePlace = true;
    bool isHomed = true; ///< otherwise `state` is the drive's word for its homing

    [[nodiscard]] double position() const { return encoder + output; } ///< where the axis is
    [[nodiscard]] double difference() const { return reference - position(); }
};

struct CaptureRules {
    static constexpr double smallestWindow = 1e-9;
    static constexpr double largestWindow = 10.0;
    static constexpr std::chrono::milliseconds shortestDwell{10};
    static constexpr std::chrono::seconds longestDwell{60};
    static constexpr int mostReadings = 1000;

    double window = 0.001; ///< an axis stands while its encoder stays within this, in mm or deg
    std::chrono::nanoseconds dwell = std::chrono::seconds(1); ///< for this long
    int readings = 10; ///< then so many are averaged
};

/// The value of one step of the plan.
struct CapturedValue {
    MeasuringStep step;
    double deviation = 0.0; ///< mean reference - target
    double encoder = 0.0; ///< mean
    double output = 0.0; ///< mean
    std::chrono::nanoseconds time{0}; ///< of the last reading
};

/// Takes the values of a measuring plan, one for each step in its order, from readings of an axis
/// that something else moves. The axis must stand within a hundredth of the mean spacing of the
/// targets, at most 0.1 mm or deg, of the target that is due, and have come to it in the step's
/// direction over the overrun (as far as readings can tell, which miss a turn), or from the target
/// before it where that is nearer. A standstill gives one value at most. Where readings are missing
/// for longer than the dwell, nothing from before counts: the axis may have moved and turned
/// unseen. From one value to the next the reference must move as the axis does, within a fifth of
/// the way or of the spacing: otherwise its unit or direction is another one, or its zero was set
/// anew. Does nothing by itself: everything follows from the readings.
class CaptureSession {
public:
    /// taken: the values of the first steps, which are not taken again.
    CaptureSession(
        MeasuringPlan plan, CaptureRules rules, std::span<const CapturedValue> taken = {});

    enum class Event {
        Moving, ///< the axis moves, or has not left the position that was taken
        Standing, ///< for a while that is too short yet, or its values are being averaged
        Taken, ///< value() is the one of a step; the next one is due
        Refused, ///< the axis stands where no value is taken; problem() says why
        NoReference, ///< it stands where a value is due, and the reading has no reference
        Stopped, ///< the state has changed: nothing is taken any more; problem() says it
        Done, ///< every step has been taken
    };
    [[nodiscard]] Event take(const CaptureReading& reading);
    /// left: the values that are left of those that were taken; the step behind them is due again.
    /// While the axis still stands where it gave the last value it is averaged there anew, after
    /// another dwell.
    void takeBack(std::span<const CapturedValue> left);

    [[nodiscard]] const MeasuringPlan& plan() const { return m_plan; }
    /// The step that is due, from 0; the number of steps when all have been taken.
    [[nodiscard]] std::size_t due() const { return m_due; }
    [[nodiscard]] const CapturedValue& value() const { return m_value; }
    [[nodiscard]] const Text& problem() const { return m_problem; }
    /// This standstill has given its value.
    [[nodiscard]] bool isTaken() const { return m_isTaken; }
    /// How many readings of this standstill are being averaged.
    [[nodiscard]] std::size_t averaged() const { return m_readings.size(); }

private:
    /// The way since the last turn.
    struct Way {
        std::optional<double> begin;
        double farthest = 0.0;
        double widestStep = 0.0; ///< between two readings: so far it may have gone unseen
        int direction = 0; ///< 1 up, -1 down, 0 not moved yet
        std::chrono::nanoseconds unread{0}; ///< before it nothing was read for so long

        void add(double position, double turn);
        [[nodiscard]] double length() const { return direction * (farthest - *begin); }

    private:
        std::optional<double> m_last;
    };

    [[nodiscard]] bool stateChanged(const CaptureReading& reading);
    void followTime(const CaptureReading& reading);
    [[nodiscard]] bool isMoving(const CaptureReading& reading);
    [[nodiscard]] Text obstacle(double position) const;
    [[nodiscard]] Text obstacleOfWay() const;
    [[nodiscard]] Text otherTarget(double position) const;
    /// Empty: the reference has moved as the axis has since the value before.
    [[nodiscard]] Text scaleProblem(const CapturedValue& value) const;
    [[nodiscard]] Event average(const CaptureReading& reading);
    void beginStanding(const CaptureReading& reading);

    MeasuringPlan m_plan;
    CaptureRules m_rules;
    std::size_t m_due;
    double m_spacing; ///< mean, of targets
    double m_tolerance; ///< of a target
    std::optional<std::string> m_state;
    bool m_isStopped = false;
    Way m_way;
    bool m_isStanding = false;
    std::chrono::nanoseconds m_standsSince{0};
    std::optional<std::chrono::nanoseconds> m_last; ///< reading
    double m_lowest = 0.0; ///< of the encoder in this standstill
    double m_highest = 0.0;
    bool m_isTaken = false; ///< this standstill has given its value
    std::vector<CaptureReading> m_readings; ///< that are being averaged
    std::optional<CapturedValue> m_before; ///< the value of the step before the one that is due
    CapturedValue m_value;
    Text m_problem;
};

} // namespace axiscomp
