// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/virtualdrive/firmware/flash_memory.h"
#include "drivecomm/virtualdrive/firmware/virtual_drive.h"

namespace axiscomp::drivecomm {

/// How an axis moves: pure functions of time, a slow sine over the axis's range, shifted for each
/// axis so that several axes cover an area.
class AxisMotion {
public:
    AxisMotion(const VirtualAxis& axis, int index);

    /// What the loop holds: the encoder position with the output of the compensation.
    [[nodiscard]] double actualPosition(DriveTime tick) const;
    [[nodiscard]] double setPosition(DriveTime tick) const; ///< what it follows
    /// Of slightly other scale and zero than the first.
    [[nodiscard]] double secondEncoder(double firstEncoder) const;
    [[nodiscard]] float motorTemperature(DriveTime tick) const; ///< degree Celsius
    [[nodiscard]] double middle() const { return m_middle; }
    /// How often it has turned: whole numbers between two turns.
    [[nodiscard]] double turns(DriveTime tick) const;
    /// When it turns for the n-th time.
    [[nodiscard]] DriveTime turnTime(double n) const;

private:
    double m_middle = 0.0;
    double m_amplitude = 0.0;
    double m_perSecond = 0.0; ///< radians
    double m_phase = 0.0;
};

/// Homing takes one second.
class Homing {
public:
    static constexpr DriveTime duration = std::chrono::seconds(1);
    enum class State { NotHomed, Homing, Done };

    explicit Homing(bool homed) : m_homed(homed) { }
    void start(DriveTime now) { m_doneAt = now + duration, m_homed = true; }
    void lose() { m_homed = false; }
    [[nodiscard]] State state(DriveTime now) const
    {
        if (!m_homed)
            return State::NotHomed;
        return now < m_doneAt ? State::Homing : State::Done;
    }

private:
    bool m_homed;
    DriveTime m_doneAt{DriveTime::min()};
};

/// The state machine of one axis's compensation. All transitions by time are computed from the
/// moment of the last command, so that they happen at their exact time however seldom anybody
/// looks.
class CompensationState {
public:
    /// For a ramp from 0 to 1.
    static constexpr DriveTime rampDuration = std::chrono::milliseconds(10);
    enum class Request { Disabled, Evaluate, AddToEncoders };
    enum class State { Disabled, Evaluating, Ramping, Active, Error };
    enum class Fault { None, NotHomed, NoTable, DimensionMismatch, BadSource, BadTable };

    /// fault: what the checks for this request found.
    void request(Request request, Fault fault, DriveTime now);
    /// While Evaluating: what a repeated check found.
    void setFault(Fault fault) { m_fault = fault; }
    void reboot() { *this = {}; }

    [[nodiscard]] Request requested() const { return m_request; }
    [[nodiscard]] Fault fault() const { return m_fault; }
    [[nodiscard]] State state(DriveTime now) const;
    /// The part of the lookup that is added, 0 to 1.
    [[nodiscard]] double gain(DriveTime now) const;
    /// Table, sources and the table's file must not change.
    [[nodiscard]] bool isOn(DriveTime now) const
    {
        return state(now) == State::Ramping || state(now) == State::Active;
    }

private:
    Request m_request = Request::Disabled;
    Fault m_fault = Fault::None;
    double m_gainAtRequest = 0.0;
    DriveTime m_requestedAt{0};
};

} // namespace axiscomp::drivecomm
