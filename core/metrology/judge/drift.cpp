// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/judge/drift.h"

#include "core/metrology/judge/iso230.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace axiscomp {

namespace {

/// Least squares of y over x.
std::optional<double> lineSlope(const std::vector<double>& x, const std::vector<double>& y)
{
    const auto n = static_cast<double>(x.size());
    double meanX = 0.0;
    double meanY = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        meanX += x[i] / n;
        meanY += y[i] / n;
    }
    double xx = 0.0;
    double xy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - meanX) * (x[i] - meanX);
        xy += (x[i] - meanX) * (y[i] - meanY);
    }
    return xx > 0.0 ? std::optional(xy / xx) : std::nullopt;
}

/// What belongs to one run: its values without the means of their targets.
struct RunResiduals {
    std::vector<double> positions;
    std::vector<double> residuals;
    std::vector<double> times;
    std::vector<double> temperatures;
};

double meanOf(const std::vector<double>& values)
{
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    return sum / static_cast<double>(values.size());
}

std::map<int, RunResiduals> residualsOf(const Measurement& measurement, Approach direction)
{
    const Iso230Figures figures = iso230Figures(measurement);
    std::vector<double> means(measurement.targets.size());
    for (const TargetFigures& target : figures.targets) {
        const DirectionFigures& one = direction == Approach::Up ? target.up : target.down;
        means[target.target] = one.mean.value_or(0.0);
    }
    std::map<int, RunResiduals> runs;
    for (const RunValue& value : measurement.values) {
        if (value.direction != direction || !value.isUsed)
            continue;
        RunResiduals& run = runs[value.run];
        run.positions.push_back(measurement.targets[value.target]);
        run.residuals.push_back(value.deviation - means[value.target]);
        if (value.time)
            run.times.push_back(*value.time);
        if (value.temperature)
            run.temperatures.push_back(*value.temperature);
    }
    return runs;
}

/// The trend of the offsets over what every run has a mean of.
std::optional<double> trendOver(const std::map<int, RunResiduals>& runs,
    const std::vector<double>& offsets, std::vector<double> RunResiduals::*member)
{
    std::vector<double> means;
    for (const auto& [number, run] : runs) {
        if ((run.*member).empty())
            return std::nullopt;
        means.push_back(meanOf(run.*member));
    }
    return lineSlope(means, offsets);
}

std::optional<double> restOf(const std::map<int, RunResiduals>& runs,
    const std::vector<double>& offsets, std::size_t targets)
{
    double squares = 0.0;
    std::size_t j = 0;
    for (const auto& [number, run] : runs) {
        for (const double residual : run.residuals)
            squares += (residual - offsets[j]) * (residual - offsets[j]);
        ++j;
    }
    const auto freedom = static_cast<double>((targets - 1) * (runs.size() - 1));
    return freedom > 0.0 ? std::optional(std::sqrt(squares / freedom)) : std::nullopt;
}

std::size_t targetCount(const Measurement& measurement, Approach direction)
{
    std::vector<bool> seen(measurement.targets.size());
    for (const RunValue& value : measurement.values)
        if (value.direction == direction && value.isUsed)
            seen[value.target] = true;
    return static_cast<std::size_t>(std::ranges::count(seen, true));
}

bool isSuspicious(const DirectionDrift& drift, std::size_t targets, std::optional<double> r)
{
    if (!drift.firstToLast || !drift.sWithoutOffsets || !r)
        return false;
    const double size = std::abs(*drift.firstToLast);
    const double noise =
        3.0 * std::sqrt(2.0) * *drift.sWithoutOffsets / std::sqrt(static_cast<double>(targets));
    return size > noise && size > *r / 10.0;
}

} // namespace

DirectionDrift driftOf(const Measurement& measurement, Approach direction)
{
    DirectionDrift drift;
    const std::map<int, RunResiduals> runs = residualsOf(measurement, direction);
    std::vector<double> numbers;
    for (const auto& [number, run] : runs) {
        drift.runs.push_back(number);
        numbers.push_back(number);
        drift.offset.push_back(meanOf(run.residuals));
        drift.slope.push_back(lineSlope(run.positions, run.residuals).value_or(0.0));
    }
    const std::size_t targets = targetCount(measurement, direction);
    if (runs.size() < 2 || targets < 2)
        return drift;
    drift.trendPerRun = lineSlope(numbers, drift.offset);
    drift.firstToLast = drift.offset.back() - drift.offset.front();
    drift.sWithoutOffsets = restOf(runs, drift.offset, targets);
    constexpr double secondsPerHour = 3600.0;
    if (const auto perSecond = trendOver(runs, drift.offset, &RunResiduals::times))
        drift.trendPerHour = *perSecond * secondsPerHour;
    drift.trendPerKelvin = trendOver(runs, drift.offset, &RunResiduals::temperatures);
    const Iso230Figure r = direction == Approach::Up ? Iso230Figure::RUp : Iso230Figure::RDown;
    drift.isSuspected = isSuspicious(drift, targets, iso230Figures(measurement)[r].value);
    return drift;
}

Measurement withoutDrift(Measurement measurement, DriftRemoval removal)
{
    for (const Approach direction : {Approach::Up, Approach::Down}) {
        const DirectionDrift drift = driftOf(measurement, direction);
        if (!drift.trendPerRun)
            continue;
        double meanRun = 0.0;
        for (const int run : drift.runs)
            meanRun += static_cast<double>(run) / static_cast<double>(drift.runs.size());
        for (RunValue& value : measurement.values) {
            const auto run = std::ranges::find(drift.runs, value.run);
            if (value.direction != direction || run == drift.runs.end())
                continue;
            const double ofRun = removal == DriftRemoval::Offset
                ? drift.offset[static_cast<std::size_t>(run - drift.runs.begin())]
                : *drift.trendPerRun * (value.run - meanRun);
            value.deviation -= ofRun;
            value.correction -= ofRun;
        }
    }
    return measurement;
}

} // namespace axiscomp
