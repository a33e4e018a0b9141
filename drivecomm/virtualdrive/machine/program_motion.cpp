// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/machine/program_motion.h"

#include <algorithm>
#include <cmath>

namespace axiscomp::drivecomm {

ProgramMotion::ProgramMotion(const MeasuringPlan& plan, double from)
{
    const double perSecond = plan.feedPerMinute / 60.0;
    double time = 0.0;
    double place = from;
    const auto move = [&](double to, int step) {
        const double end = time + std::abs(to - place) / perSecond;
        m_legs.push_back({time, end, place, to, step});
        time = end;
        place = to;
    };
    for (const MeasuringStep& step : plan.steps) {
        if (step.approach != place)
            move(step.approach, step.step);
        move(step.target, step.step);
        time += plan.dwellSeconds;
    }
    m_endSeconds = time;
}

const ProgramMotion::Leg& ProgramMotion::legAt(double seconds) const
{
    const auto next = std::ranges::upper_bound(m_legs, seconds, {}, &Leg::begin);
    return next == m_legs.begin() ? m_legs.front() : *std::prev(next);
}

double ProgramMotion::position(double seconds) const
{
    const Leg& leg = legAt(seconds);
    if (seconds <= leg.begin)
        return leg.from;
    if (seconds >= leg.end)
        return leg.to;
    return leg.from + (leg.to - leg.from) * (seconds - leg.begin) / (leg.end - leg.begin);
}

int ProgramMotion::step(double seconds) const
{
    return legAt(seconds).step;
}

std::vector<double> ProgramMotion::movementEnds(double after, double until) const
{
    std::vector<double> ends;
    auto leg = std::ranges::upper_bound(m_legs, after, {}, &Leg::end);
    for (; leg != m_legs.end() && leg->end <= until; ++leg)
        ends.push_back(leg->end);
    return ends;
}

} // namespace axiscomp::drivecomm
