// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/firmware/axis_simulation.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace axiscomp::drivecomm {

namespace {

constexpr double twoPi = 2.0 * std::numbers::pi;

double seconds(DriveTime time)
{
    return std::chrono::duration<double>(time).count();
}

} // namespace

AxisMotion::AxisMotion(const VirtualAxis& axis, int index)
    : m_middle(axis.low / 2.0 + axis.high / 2.0)
    , m_amplitude(axis.high / 2.0 - axis.low / 2.0)
    , m_perSecond(axis.periodSeconds > 0.0 ? twoPi / axis.periodSeconds : 0.0)
    // The golden angle: no two axes move alike, however many there are.
    , m_phase(index * std::numbers::pi * (3.0 - std::sqrt(5.0)))
{
}

double AxisMotion::actualPosition(DriveTime tick) const
{
    return m_middle + m_amplitude * std::sin(m_perSecond * seconds(tick) + m_phase);
}

double AxisMotion::secondEncoder(double firstEncoder) const
{
    constexpr double scale = 1.0 + 20e-6;
    const double zero = 1e-4 * m_amplitude;
    return firstEncoder * scale + zero;
}

double AxisMotion::setPosition(DriveTime tick) const
{
    constexpr DriveTime lead = std::chrono::milliseconds(1);
    return actualPosition(tick + lead);
}

float AxisMotion::motorTemperature(DriveTime tick) const
{
    constexpr double perSecond = twoPi / 900.0;
    return static_cast<float>(38.0 + 4.0 * std::sin(perSecond * seconds(tick) + m_phase));
}

double AxisMotion::turns(DriveTime tick) const
{
    return std::floor((m_perSecond * seconds(tick) + m_phase) / std::numbers::pi + 0.5);
}

DriveTime AxisMotion::turnTime(double n) const
{
    const std::chrono::duration<double> time(
        ((n - 0.5) * std::numbers::pi - m_phase) / m_perSecond);
    return std::chrono::duration_cast<DriveTime>(time);
}

void CompensationState::request(Request request, Fault fault, DriveTime now)
{
    m_gainAtRequest = gain(now);
    m_requestedAt = now;
    m_request = request;
    m_fault = fault;
}

double CompensationState::gain(DriveTime now) const
{
    const double change = static_cast<double>((now - m_requestedAt).count())
        / static_cast<double>(rampDuration.count());
    const bool in = m_request == Request::AddToEncoders && m_fault == Fault::None;
    return std::clamp(m_gainAtRequest + (in ? change : -change), 0.0, 1.0);
}

CompensationState::State CompensationState::state(DriveTime now) const
{
    if (m_fault != Fault::None)
        return State::Error;
    const double added = gain(now);
    if (m_request == Request::AddToEncoders)
        return added < 1.0 ? State::Ramping : State::Active;
    if (added > 0.0)
        return State::Ramping;
    return m_request == Request::Evaluate ? State::Evaluating : State::Disabled;
}

} // namespace axiscomp::drivecomm
