// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/measuring_plan.h"

#include "core/base/fixed_random.h"
#include "core/text/number_text.h"
#include "core/text/utf8.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace axiscomp {

namespace {

constexpr double stepsPerUnit = 1000.0; ///< positions are whole thousandths
constexpr int mostTargets = 10'000;
constexpr double smallestSpacing = 0.01; ///< ten thousandths: a third of it is still some of them

using Thousandths = std::int64_t;

Thousandths nearestThousandth(double position)
{
    return std::llround(position * stepsPerUnit);
}

double planPositionOf(Thousandths value)
{
    return static_cast<double>(value) / stepsPerUnit;
}

bool isWholeThousandth(double position)
{
    constexpr double rounding = 1e-6;
    return std::abs(position * stepsPerUnit - std::round(position * stepsPerUnit)) < rounding;
}

using PlanField = MeasuringPlanField;
using PlanFault = std::optional<MeasuringPlanFault>;

PlanFault impossiblePlan(PlanField field, Text reason)
{
    return MeasuringPlanFault{field, std::move(reason)};
}

Quantity planQuantity(double value, bool isAngular)
{
    return {roundedText(value), isAngular ? "deg" : "mm"};
}

PlanFault faultOfAxis(const MeasuringPlanRequest& request)
{
    if (request.axis.find_first_not_of(' ') == std::string::npos
        || shownText(request.axis, request.axis.size()) != request.axis)
        return impossiblePlan(PlanField::Axis,
            AXISCOMP_TEXT(
                "Error", "name the axis as the drive or the control names it, such as X"));
    return std::nullopt;
}

PlanFault faultOfEnds(const MeasuringPlanRequest& request)
{
    for (const PlanField field : {PlanField::From, PlanField::To}) {
        const double end = field == PlanField::From ? request.from : request.to;
        if (!(std::abs(end) <= largestPlanPosition))
            return impossiblePlan(field,
                AXISCOMP_TEXT("Error", "a target must lie within {limit} of zero")
                    .with("limit", planQuantity(largestPlanPosition, request.isAngular)));
        if (!isWholeThousandth(end))
            return impossiblePlan(field,
                AXISCOMP_TEXT("Error",
                    "{position} has more than the three decimals that a program prints; choose an "
                    "end with fewer")
                    .with("position", planQuantity(end, request.isAngular)));
    }
    if (!(request.from < request.to))
        return impossiblePlan(PlanField::To,
            AXISCOMP_TEXT("Error",
                "the last target ({to}) must be above the first ({from}); exchange the two, or "
                "choose other ends")
                .with("from", planQuantity(request.from, request.isAngular))
                .with("to", planQuantity(request.to, request.isAngular)));
    return std::nullopt;
}

PlanFault faultOfRest(const MeasuringPlanRequest& request)
{
    const auto isPositive = [](double value, double most) { return value > 0.0 && value <= most; };
    if (request.period && !isPositive(*request.period, largestPlanPosition))
        return impossiblePlan(PlanField::Period,
            AXISCOMP_TEXT("Error", "a period is above 0; leave it out if none is known"));
    if (request.overrun && !isPositive(*request.overrun, largestPlanPosition))
        return impossiblePlan(PlanField::Overrun,
            AXISCOMP_TEXT("Error",
                "the overrun must be above 0: without it the first target of a run would not be "
                "approached in the direction of the run"));
    if (request.overrun && !isWholeThousandth(*request.overrun))
        return impossiblePlan(PlanField::Overrun,
            AXISCOMP_TEXT("Error", "the overrun has more than three decimals; round it"));
    constexpr double fastest = 1e6;
    if (!isPositive(request.feedPerMinute, fastest))
        return impossiblePlan(PlanField::Feed,
            AXISCOMP_TEXT("Error", "the feed must be above 0 and at most {most}")
                .with("most",
                    Quantity{roundedText(fastest), request.isAngular ? "deg/min" : "mm/min"}));
    constexpr double longestSeconds = 3600.0;
    if (!isPositive(request.dwellSeconds, longestSeconds))
        return impossiblePlan(PlanField::Dwell,
            AXISCOMP_TEXT("Error",
                "the dwell must be above 0 s and at most {most}: the axis stands still while it is "
                "measured")
                .with("most", Quantity{roundedText(longestSeconds), "s"}));
    if (request.cycles < 1)
        return impossiblePlan(
            PlanField::Cycles, AXISCOMP_TEXT("Error", "at least one cycle is needed"));
    return std::nullopt;
}

/// By count or by spacing, not checked.
double wantedTargets(const MeasuringPlanRequest& request)
{
    const double range = request.to - request.from;
    return request.spacing ? std::round(range / *request.spacing) + 1.0 : *request.count;
}

PlanFault faultOfCount(const MeasuringPlanRequest& request)
{
    if (request.count.has_value() == request.spacing.has_value())
        return impossiblePlan(PlanField::Targets,
            AXISCOMP_TEXT("Error", "give the number of targets or their spacing, one of the two"));
    const double range = request.to - request.from;
    if (request.spacing && !(*request.spacing > 0.0 && *request.spacing <= range))
        return impossiblePlan(PlanField::Targets,
            AXISCOMP_TEXT("Error",
                "the spacing must be above 0 and at most the distance of the ends, {range}")
                .with("range", planQuantity(range, request.isAngular)));
    const double wanted = wantedTargets(request);
    if (!(wanted >= 2.0 && wanted <= mostTargets))
        return impossiblePlan(PlanField::Targets,
            AXISCOMP_TEXT("Error", "a plan has 2 to {most} targets, not {count}")
                .with("most", mostTargets)
                .with("count", Quantity{roundedText(wanted)}));
    const int count = static_cast<int>(wanted);
    if (range / (count - 1) < smallestSpacing)
        return impossiblePlan(PlanField::Targets,
            AXISCOMP_TEXT("Error",
                "{count} targets would be closer than {least}, which three decimals cannot keep "
                "uneven; choose fewer")
                .with("count", count)
                .with("least", planQuantity(smallestSpacing, request.isAngular)));
    if (static_cast<std::size_t>(count) * 2 * static_cast<std::size_t>(request.cycles)
        > mostPlanSteps)
        return impossiblePlan(PlanField::Cycles,
            AXISCOMP_TEXT("Error",
                "the plan would have more than {most} steps; choose fewer targets or cycles")
                .with("most", mostPlanSteps));
    return std::nullopt;
}

/// Each target in turn is drawn evenly from where its neighbours leave it, over and over: with
/// neighbours that are never in the way that is one even draw, and otherwise every choice that
/// keeps the distances comes as often as any other.
std::vector<Thousandths> unevenTargets(const MeasuringPlanRequest& request, int count)
{
    constexpr double usualShare = 0.3;
    constexpr int sweeps = 100;
    const double spacing = (request.to - request.from) / (count - 1);
    const double reach = request.period.value_or(usualShare * spacing);
    const auto leastDistance = static_cast<Thousandths>(std::ceil(spacing / 3.0 * stepsPerUnit));
    const auto evenTarget = [&](std::size_t i) {
        return request.from + static_cast<double>(i) * spacing;
    };
    std::vector<Thousandths> targets;
    for (std::size_t i = 0; i < static_cast<std::size_t>(count); ++i)
        targets.push_back(nearestThousandth(evenTarget(i)));
    targets.back() = nearestThousandth(request.to);
    FixedRandom random({request.seed});
    for (int sweep = 0; sweep < sweeps; ++sweep)
        for (std::size_t i = 1; i + 1 < targets.size(); ++i) {
            const auto lowest =
                static_cast<Thousandths>(std::ceil((evenTarget(i) - reach) * stepsPerUnit));
            const auto highest =
                static_cast<Thousandths>(std::floor((evenTarget(i) + reach) * stepsPerUnit));
            const Thousandths least = std::max(lowest, targets[i - 1] + leastDistance);
            const Thousandths most = std::min(highest, targets[i + 1] - leastDistance);
            if (least <= most)
                targets[i] = random.between(least, most);
        }
    return targets;
}

Thousandths overrunOf(const MeasuringPlanRequest& request, int count)
{
    if (request.overrun)
        return nearestThousandth(*request.overrun);
    constexpr double share = 0.01;
    const double range = request.to - request.from;
    const double usual = std::min(share * range, range / (count - 1) / 3.0);
    return std::max<Thousandths>(1, static_cast<Thousandths>(std::ceil(usual * stepsPerUnit)));
}

} // namespace

std::optional<MeasuringPlanFault> measuringPlanFault(const MeasuringPlanRequest& request)
{
    for (const auto faultOf : {faultOfAxis, faultOfEnds, faultOfRest, faultOfCount})
        if (auto fault = faultOf(request))
            return fault;
    return std::nullopt;
}

Result<MeasuringPlan> makeMeasuringPlan(const MeasuringPlanRequest& request)
{
    if (auto fault = measuringPlanFault(request))
        return fail(ErrorCode::InvalidArgument, {{"reason", std::move(fault->reason)}});
    const int count = static_cast<int>(wantedTargets(request));
    std::vector<Thousandths> targets = unevenTargets(request, count);
    const Thousandths overrun = overrunOf(request, count);
    MeasuringPlan plan{request.axis, request.isAngular, planPositionOf(overrun),
        request.feedPerMinute, request.dwellSeconds, request.period, request.seed, {}};
    for (int run = 1; run <= request.cycles; ++run)
        for (const Approach direction : {Approach::Up, Approach::Down}) {
            Thousandths before =
                direction == Approach::Up ? targets.front() - overrun : targets.front() + overrun;
            for (const Thousandths target : targets) {
                plan.steps.push_back({static_cast<int>(plan.steps.size()) + 1, run, direction,
                    planPositionOf(target), planPositionOf(before)});
                before = target;
            }
            std::ranges::reverse(targets);
        }
    return plan;
}

PlanTravel planTravel(const MeasuringPlan& plan)
{
    const std::vector<double> targets = targetsOf(plan);
    PlanTravel travel{targets.front(), targets.back()};
    for (const MeasuringStep& step : plan.steps) {
        travel.lowest = std::min(travel.lowest, step.approach);
        travel.highest = std::max(travel.highest, step.approach);
    }
    return travel;
}

std::string planPosition(double position)
{
    constexpr int decimals = 3;
    std::array<char, 64> digits{};
    const double shown = nearestThousandth(position) == 0 ? 0.0 : position;
    const auto end = std::to_chars(
        digits.data(), digits.data() + digits.size(), shown, std::chars_format::fixed, decimals);
    return {digits.data(), end.ptr};
}

std::vector<double> targetsOf(const MeasuringPlan& plan)
{
    std::vector<double> targets;
    for (const MeasuringStep& step : plan.steps)
        targets.push_back(step.target);
    return distinctTargets(std::move(targets));
}

} // namespace axiscomp
