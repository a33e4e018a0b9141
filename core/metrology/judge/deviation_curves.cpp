// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/judge/deviation_curves.h"

#include <algorithm>
#include <cstddef>
#include <map>

namespace axiscomp {

namespace {

void widen(std::optional<DeviationRange>& range, const std::optional<double>& value)
{
    if (value)
        range = range ? united(*range, {*value, *value}) : DeviationRange{*value, *value};
}

void append(
    std::vector<PlacedDeviation>& curve, double position, const std::optional<double>& deviation)
{
    if (deviation)
        curve.push_back({position, *deviation});
}

void addFigures(DeviationCurves& curves, const Iso230Figures& figures)
{
    std::optional<DeviationRange> accuracy;
    std::optional<DeviationRange> systematic;
    std::optional<DeviationRange> meanRange;
    for (const TargetFigures& target : figures.targets) {
        const auto add = [&](DeviationCurves::Direction& direction, const DirectionFigures& one) {
            append(direction.mean, target.position, one.mean);
            append(direction.low, target.position, one.low);
            append(direction.high, target.position, one.high);
            widen(accuracy, one.low);
            widen(accuracy, one.high);
            widen(systematic, one.mean);
        };
        add(curves.up, target.up);
        add(curves.down, target.down);
        append(curves.mean, target.position, target.mean);
        widen(meanRange, target.mean);
    }
    if (accuracy)
        curves.all = accuracy;
    if (figures[Iso230Figure::A].value)
        curves.accuracy = accuracy;
    if (figures[Iso230Figure::E].value)
        curves.systematic = systematic;
    if (figures[Iso230Figure::M].value)
        curves.meanRange = meanRange;
    if (const AxisFigure& reversal = figures[Iso230Figure::B]; reversal.value) {
        const TargetFigures& target = figures.targets[reversal.high];
        curves.reversal = {target.position, *target.up.mean, *target.down.mean};
    }
}

void addToEnvelope(DeviationCurves::Direction& direction, const PlacedDeviation& value)
{
    if (direction.smallest.empty() || direction.smallest.back().position != value.position) {
        direction.smallest.push_back(value);
        direction.largest.push_back(value);
        return;
    }
    double& smallest = direction.smallest.back().deviation;
    double& largest = direction.largest.back().deviation;
    smallest = std::min(smallest, value.deviation);
    largest = std::max(largest, value.deviation);
}

void moveBy(std::optional<double>& deviation, double by)
{
    if (deviation)
        *deviation += by;
}

/// The values stand by direction, target and run.
void addValues(DeviationCurves& curves, const Measurement& measurement)
{
    std::map<std::pair<Approach, int>, DeviationCurves::Run> runs;
    for (const RunValue& value : measurement.values) {
        const PlacedDeviation placed{
            measurement.targets[value.target], fromDatum(value.deviation, curves.datum)};
        if (!value.isUsed) {
            curves.excluded.push_back(placed);
            continue;
        }
        DeviationCurves::Run& run = runs[{value.direction, value.run}];
        run.values.push_back(placed);
        addToEnvelope(value.direction == Approach::Up ? curves.up : curves.down, placed);
        widen(curves.all, placed.deviation);
        ++curves.valueCount;
    }
    for (auto& [key, run] : runs) {
        run.direction = key.first;
        run.number = key.second;
        curves.runs.push_back(std::move(run));
    }
}

void thin(std::vector<PlacedDeviation>& curve, std::size_t most)
{
    const std::size_t count = curve.size();
    if (count <= most)
        return;
    const std::size_t parts = std::max<std::size_t>(1, most / 2);
    std::vector<PlacedDeviation> left;
    for (std::size_t part = 0; part < parts; ++part) {
        const auto begin = curve.begin() + static_cast<std::ptrdiff_t>(part * count / parts);
        const auto end = curve.begin() + static_cast<std::ptrdiff_t>((part + 1) * count / parts);
        const auto [low, high] =
            std::ranges::minmax_element(begin, end, {}, &PlacedDeviation::deviation);
        left.push_back(*std::min(low, high));
        left.push_back(*std::max(low, high));
    }
    curve = std::move(left);
}

} // namespace

DeviationRange united(const DeviationRange& a, const DeviationRange& b)
{
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

std::optional<PlacedDeviation> deviationDatum(
    const Iso230Figures& figures, const std::optional<double>& position)
{
    std::vector<PlacedDeviation> means;
    for (const TargetFigures& target : figures.targets)
        append(means, target.position, meanInUse(target));
    if (means.empty())
        return std::nullopt;
    const double first = means.front().position;
    const double at = std::clamp(position.value_or(first), first, means.back().position);
    const auto next = std::ranges::lower_bound(means, at, {}, &PlacedDeviation::position);
    if (next->position == at)
        return *next;
    const PlacedDeviation& before = *std::prev(next);
    const double share = (at - before.position) / (next->position - before.position);
    return PlacedDeviation{at, before.deviation + share * (next->deviation - before.deviation)};
}

TwoDatums deviationDatums(const DatumSide& before, const DatumSide& after)
{
    const auto& position = before.stated ? before.stated : after.stated;
    TwoDatums datums;
    datums.before = deviationDatum(before.figures, position);
    const bool isOfFirst = !position && datums.before;
    datums.after = deviationDatum(
        after.figures, isOfFirst ? std::optional(datums.before->position) : position);
    return datums;
}

double fromDatum(double deviation, const std::optional<PlacedDeviation>& datum)
{
    return datum ? deviation - datum->deviation : deviation;
}

Iso230Figures fromDatum(Iso230Figures figures, const std::optional<PlacedDeviation>& datum)
{
    const double by = fromDatum(0.0, datum);
    for (TargetFigures& target : figures.targets) {
        moveBy(target.mean, by);
        for (DirectionFigures* direction : {&target.up, &target.down})
            for (auto* place : {&direction->mean, &direction->low, &direction->high})
                moveBy(*place, by);
    }
    return figures;
}

Text datumText(const PlacedDeviation& datum, bool isAngular, UnitLetters letters)
{
    Quantity position = placeOf(datum.position, isAngular);
    if (isAngular && letters == UnitLetters::Page)
        position.unit = "°";
    return AXISCOMP_TEXT("Measurement", "0 = mean at {position}")
        .with("position", std::move(position));
}

TextPattern deviationLineText(DeviationLine line)
{
    switch (line) {
    case DeviationLine::MeanUp:
        return AXISCOMP_TEXT("Report", "mean ↑");
    case DeviationLine::MeanDown:
        return AXISCOMP_TEXT("Report", "mean ↓");
    case DeviationLine::Mean:
        return AXISCOMP_TEXT("Report", "mean of both");
    case DeviationLine::BandUp:
        return AXISCOMP_TEXT("Report", "mean ↑ ± 2 s");
    case DeviationLine::BandDown:
        return AXISCOMP_TEXT("Report", "mean ↓ ± 2 s");
    case DeviationLine::Run:
        break;
    }
    return AXISCOMP_TEXT("Report", "single run");
}

DeviationCurves deviationCurves(const Measurement& measurement, const Iso230Figures& figures,
    const std::optional<PlacedDeviation>& datum)
{
    DeviationCurves curves;
    curves.datum = datum;
    addFigures(curves, fromDatum(figures, datum));
    addValues(curves, measurement);
    return curves;
}

DeviationCurves thinned(DeviationCurves curves, std::size_t most)
{
    for (DeviationCurves::Direction* one : {&curves.up, &curves.down})
        for (auto* curve : {&one->mean, &one->low, &one->high, &one->smallest, &one->largest})
            thin(*curve, most);
    thin(curves.mean, most);
    if (curves.valueCount > most)
        curves.runs.clear();
    return curves;
}

} // namespace axiscomp
