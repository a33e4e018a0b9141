// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/capture/capture_request.h"

#include "core/io/system.h"
#include "core/text/utf8.h"

#include <cmath>
#include <utility>

namespace axiscomp {

std::string CaptureReference::text() const
{
    const std::string name = kind == Kind::Lines ? "standard input"
        : kind == Kind::Typed                    ? "typed"
                                                 : source;
    const std::string text = referenceText(name, scale);
    return pattern.empty() ? text : text + ", pattern " + visibleText(pattern);
}

std::chrono::nanoseconds timeSinceStart()
{
    return system::timeSinceStart();
}

CaptureClock::CaptureClock(std::span<const CapturedValue> taken, std::chrono::nanoseconds wall,
    std::function<std::chrono::nanoseconds()> steady)
    : m_steady(std::move(steady))
    , m_isBehind(!taken.empty() && taken.back().time > wall)
{
    m_offset = (m_isBehind ? taken.back().time : wall) - m_steady();
}

std::optional<double> proposedZero(
    const CapturedValue& first, const MeasuringPlan& plan, const ReferenceScale& scale)
{
    constexpr double share = 0.01;
    const std::vector<double> targets = targetsOf(plan);
    if (std::abs(first.deviation) <= share * (targets.back() - targets.front()))
        return std::nullopt;
    return scale.zeroAt - first.deviation;
}

std::optional<FarthestResolution> farthestResolution(
    const AxisReadings& readings, const MeasuringPlan& plan)
{
    double farthest = 0.0;
    for (const double target : targetsOf(plan))
        if (std::abs(target) > std::abs(farthest))
            farthest = target;
    const auto step = readings.resolutionAt(farthest);
    return step ? std::optional(FarthestResolution{farthest, *step}) : std::nullopt;
}

} // namespace axiscomp
