// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/capture_session.h"

#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace axiscomp {

namespace {

/// Mean distance of targets; 0 for a single one.
double spacingOf(const MeasuringPlan& plan)
{
    const std::vector<double> targets = targetsOf(plan);
    if (targets.size() < 2)
        return 0.0;
    return (targets.back() - targets.front()) / static_cast<double>(targets.size() - 1);
}

double toleranceOf(double spacing)
{
    constexpr double share = 0.01;
    constexpr double most = 0.1;
    return spacing > 0.0 ? std::min(most, share * spacing) : most;
}

Quantity shownPosition(double position, const MeasuringPlan& plan)
{
    return {planPosition(position), plan.isAngular ? "deg" : "mm"};
}

} // namespace

void CaptureSession::Way::add(double position, double turn)
{
    widestStep = std::max(widestStep, std::abs(position - m_last.value_or(position)));
    m_last = position;
    if (!begin) {
        begin = farthest = position;
        return;
    }
    const double ahead = position - farthest;
    if (direction == 0) {
        if (std::abs(position - *begin) <= turn)
            return;
        direction = position > *begin ? 1 : -1;
        farthest = position;
    } else if (direction * ahead > 0.0) {
        farthest = position;
    } else if (direction * ahead < -turn) { // turned where it was farthest
        begin = farthest;
        farthest = position;
        direction = -direction;
        unread = {};
        widestStep = std::abs(position - *begin);
    }
}

CaptureSession::CaptureSession(
    MeasuringPlan plan, CaptureRules rules, std::span<const CapturedValue> taken)
    : m_plan(std::move(plan))
    , m_rules(rules)
    , m_due(taken.size())
    , m_spacing(spacingOf(m_plan))
    , m_tolerance(toleranceOf(m_spacing))
{
    if (!taken.empty())
        m_before = taken.back();
}

bool CaptureSession::stateChanged(const CaptureReading& reading)
{
    if (!m_state)
        m_state = reading.state;
    const bool isSame = reading.state == *m_state;
    if (isSame && reading.isSamePlace)
        return false;
    m_isStopped = true;
    if (isSame) {
        m_problem = AXISCOMP_TEXT("Error",
            "the table that is active lies over other positions or sources than at the beginning; "
            "what was taken belongs to the one before: begin a new file");
        return true;
    }
    if (!reading.isHomed) {
        m_problem = AXISCOMP_TEXT("Error",
            "the axis lost its homing in mid-measurement, as after a restart of the drive; its "
            "positions are others after it is homed again: begin a new file");
        return true;
    }
    m_problem = AXISCOMP_TEXT("Error",
        "the compensation changed in mid-measurement, from {before} to {now}; what was taken "
        "belongs "
        "to {before}: begin a new file")
                    .with("before", *m_state)
                    .with("now", reading.state);
    return true;
}

void CaptureSession::beginStanding(const CaptureReading& reading)
{
    m_isStanding = true;
    m_standsSince = reading.time;
    m_lowest = m_highest = reading.encoder;
    m_isTaken = false;
    m_readings.clear();
}

void CaptureSession::followTime(const CaptureReading& reading)
{
    const auto last = std::exchange(m_last, reading.time);
    if (last && reading.time >= *last && reading.time - *last <= m_rules.dwell)
        return;
    m_readings.clear();
    m_standsSince = reading.time;
    // A clock that was put back says nothing of the axis.
    if (last && reading.time > *last) {
        m_way = {};
        m_way.unread = reading.time - *last;
        m_isStanding = false;
    }
}

/// Also true for the first reading of a standstill.
bool CaptureSession::isMoving(const CaptureReading& reading)
{
    const double lowest = std::min(m_lowest, reading.encoder);
    const double highest = std::max(m_highest, reading.encoder);
    if (!m_isStanding || highest - lowest > m_rules.window) {
        beginStanding(reading);
        return true;
    }
    m_lowest = lowest;
    m_highest = highest;
    return false;
}

Text CaptureSession::otherTarget(double position) const
{
    const auto isHere = [&](const MeasuringStep& step) {
        return std::abs(position - step.target) <= m_tolerance;
    };
    const MeasuringStep& due = m_plan.steps[m_due];
    const auto later = std::find_if(
        m_plan.steps.begin() + static_cast<std::ptrdiff_t>(m_due), m_plan.steps.end(), isHere);
    const Text here =
        AXISCOMP_TEXT("Error", "the axis stands at {position}; step {step} at {target} is due")
            .with("position", shownPosition(position, m_plan))
            .with("step", due.step)
            .with("target", shownPosition(due.target, m_plan));
    if (later == m_plan.steps.end())
        return here;
    return AXISCOMP_TEXT(
        "Error", "{problem}; this is the target of step {other}: move the axis back")
        .with("problem", here)
        .with("other", later->step);
}

/// Empty: the axis has come to the step that is due as its plan says.
Text CaptureSession::obstacleOfWay() const
{
    const MeasuringStep& due = m_plan.steps[m_due];
    const int wanted = due.direction == Approach::Up ? 1 : -1;
    const double needed = std::min(m_plan.overrun, std::abs(due.target - due.approach));
    const bool isShort = m_way.length() + m_way.widestStep < needed - m_tolerance;
    if (m_way.direction == wanted && !isShort)
        return {};
    const auto go = [&](const Text& text) {
        return text.with("step", due.step).with("approach", shownPosition(due.approach, m_plan));
    };
    if (m_way.unread.count() > 0 && m_way.direction != -wanted)
        return go(AXISCOMP_TEXT("Error",
                      "how the axis came to step {step} is not known, as nothing could be read for "
                      "{time}; go to {approach} and come back"))
            .with("time",
                Quantity{fixedDigits(std::chrono::duration<double>(m_way.unread).count(), 2), "s"});
    if (m_way.direction == wanted)
        return go(AXISCOMP_TEXT("Error",
                      "the axis came only {way} in the direction of step {step}, less than the "
                      "overrun of {overrun}; go to {approach} and come back"))
            .with("way", shownPosition(m_way.length(), m_plan))
            .with("overrun", shownPosition(needed, m_plan));
    if (due.direction == Approach::Up)
        return go(AXISCOMP_TEXT("Error",
            "step {step} is approached upwards, and the axis did not come from below; go to "
            "{approach} and come back"));
    return go(AXISCOMP_TEXT("Error",
        "step {step} is approached downwards, and the axis did not come from above; go to "
        "{approach} and come back"));
}

/// Empty: the value of the step that is due can be taken here.
Text CaptureSession::obstacle(double position) const
{
    const bool isThere = std::abs(position - m_plan.steps[m_due].target) <= m_tolerance;
    return isThere ? obstacleOfWay() : otherTarget(position);
}

Text CaptureSession::scaleProblem(const CapturedValue& value) const
{
    if (!m_before)
        return {};
    constexpr double share = 0.2;
    const double way = value.step.target - m_before->step.target;
    const double measured = way + value.deviation - m_before->deviation;
    if (std::abs(measured - way) <= share * std::max(std::abs(way), m_spacing))
        return {};
    const Text found = AXISCOMP_TEXT("Error",
        "since the value before, the axis has moved by {way}, and the instrument says {measured}")
                           .with("way", shownPosition(way, m_plan))
                           .with("measured", shownPosition(measured, m_plan));
    const double slope = way != 0.0 ? measured / way : 0.0;
    if (std::abs(slope + 1.0) <= share)
        return AXISCOMP_TEXT("Error",
            "{found}: it counts the other way; begin a new file with the reference inverted")
            .with("found", found);
    return AXISCOMP_TEXT("Error",
        "{found}: its unit or factor is another one, or its zero was set anew, or its beam was "
        "interrupted; put that right, or begin a new file with the right unit")
        .with("found", found);
}

void CaptureSession::takeBack(std::span<const CapturedValue> left)
{
    m_due = left.size();
    m_before = left.empty() ? std::nullopt : std::optional(left.back());
    m_isTaken = false;
    m_readings.clear();
    m_standsSince = m_last.value_or(m_standsSince);
}

CaptureSession::Event CaptureSession::average(const CaptureReading& reading)
{
    if (!std::isfinite(reading.reference)) {
        m_readings.clear();
        m_problem = AXISCOMP_TEXT("Error", "the instrument gives no position");
        return Event::NoReference;
    }
    m_readings.push_back(reading);
    if (m_readings.size() < static_cast<std::size_t>(std::max(1, m_rules.readings)))
        return Event::Standing;
    const auto [lowest, highest] = std::ranges::minmax(m_readings, {}, &CaptureReading::reference);
    const double spread = highest.reference - lowest.reference;
    CapturedValue value{m_plan.steps[m_due], 0.0, 0.0, 0.0, reading.time};
    const auto count = static_cast<double>(m_readings.size());
    for (const CaptureReading& each : std::exchange(m_readings, {})) {
        value.deviation += (each.reference - value.step.target) / count;
        value.encoder += each.encoder / count;
        value.output += each.output / count;
    }
    if (spread > m_rules.window) {
        m_problem = AXISCOMP_TEXT("Error",
            "the readings of the instrument differ by {spread}, more than the window of {window}; "
            "they are taken again")
                        .with("spread",
                            Quantity{roundedText(spread), m_plan.isAngular ? "deg" : "mm"})
                        .with("window",
                            Quantity{roundedText(m_rules.window), m_plan.isAngular ? "deg" : "mm"});
        return Event::Refused;
    }
    m_problem = scaleProblem(value);
    if (!m_problem.isEmpty())
        return Event::Refused;
    m_before = m_value = value;
    m_isTaken = true;
    ++m_due;
    return Event::Taken;
}

CaptureSession::Event CaptureSession::take(const CaptureReading& reading)
{
    if (m_isStopped || stateChanged(reading))
        return Event::Stopped;
    if (m_due >= m_plan.steps.size())
        return Event::Done;
    followTime(reading);
    // A drive that settles goes a little too far and back, which is no turn.
    constexpr double turnWindows = 10.0;
    m_way.add(reading.encoder, turnWindows * m_rules.window);
    if (isMoving(reading) || m_isTaken)
        return Event::Moving;
    if (reading.time - m_standsSince < m_rules.dwell)
        return Event::Standing;
    m_problem = obstacle(reading.encoder + reading.output);
    if (m_problem.isEmpty())
        return average(reading);
    m_readings.clear();
    return Event::Refused;
}

} // namespace axiscomp
