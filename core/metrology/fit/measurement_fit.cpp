// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/measurement_fit.h"

#include "core/metrology/fit/fit_parts.h"
#include "core/table/target_axis.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace axiscomp {

namespace {

struct MethodName {
    FitMethod method;
    std::string_view name;
};
constexpr std::array knownMethods{MethodName{FitMethod::Linear, "linear"},
    MethodName{FitMethod::Cubic, "cubic"}, MethodName{FitMethod::Spline, "spline"},
    MethodName{FitMethod::Smooth, "smooth"}, MethodName{FitMethod::Harmonic, "harmonic"}};

struct NamedDirection {
    FitDirection direction;
    std::string_view name;
};
constexpr std::array knownDirections{NamedDirection{FitDirection::Mean, "mean"},
    NamedDirection{FitDirection::Positive, "positive"},
    NamedDirection{FitDirection::Negative, "negative"}, NamedDirection{FitDirection::Both, "both"}};

} // namespace

std::string_view fitMethodName(FitMethod method)
{
    return std::ranges::find(knownMethods, method, &MethodName::method)->name;
}

std::optional<FitMethod> fitMethodNamed(std::string_view name)
{
    const auto found = std::ranges::find(knownMethods, name, &MethodName::name);
    if (found == knownMethods.end())
        return std::nullopt;
    return found->method;
}

std::string_view fitDirectionName(FitDirection direction)
{
    return std::ranges::find(knownDirections, direction, &NamedDirection::direction)->name;
}

std::optional<FitDirection> fitDirectionNamed(std::string_view name)
{
    const auto found = std::ranges::find(knownDirections, name, &NamedDirection::name);
    if (found == knownDirections.end())
        return std::nullopt;
    return found->direction;
}

bool FitReport::isWithinTolerances() const
{
    return std::ranges::all_of(
        verdicts, [](const Verdict& verdict) { return verdict.result == VerdictResult::Passed; });
}

void judgeForetold(const FitSettings& settings, FitReport& report)
{
    report.verdicts = verdicts(*report.predicted, settings.tolerances, settings.uncertainty);
    if (!report.heldOut)
        return;
    // At the targets a table through the means leaves nothing, whatever lies between them.
    const Iso230Figure figure = figureStandingFor(Iso230Figure::M, *report.predicted);
    const double heldOut = report.heldOut->range;
    for (Verdict& verdict : report.verdicts) {
        const auto& [limited, limit] = verdict.tolerance;
        if (limited != figure || verdict.result != VerdictResult::Passed
            || verdictResult(heldOut, limit, verdict.uncertainty) == VerdictResult::Passed)
            continue;
        verdict.result = VerdictResult::Undecided;
        verdict.heldOut = heldOut;
    }
}

bool isFittedOnGrid(const Measurement& measurement, const FitSettings& settings)
{
    return measurement.kind == MeasurementKind::Points
        || (measurement.kind == MeasurementKind::Track && settings.method == FitMethod::Linear);
}

std::string_view madeBy(const Measurement& measurement, const FitSettings& settings)
{
    return isFittedOnGrid(measurement, settings) ? "grid" : fitMethodName(settings.method);
}

FitDirection fittedDirection(const Measurement& measurement, const FitSettings& settings)
{
    if (settings.direction != FitDirection::Mean)
        return settings.direction;
    bool hasUp = false;
    bool hasDown = false;
    const auto count = [&](Approach direction) {
        (direction == Approach::Up ? hasUp : hasDown) = true;
    };
    for (const RunValue& value : measurement.values)
        if (value.isUsed)
            count(value.direction);
    for (const TrackSample& sample : measurement.track)
        count(sample.direction);
    if (hasUp == hasDown)
        return FitDirection::Mean;
    return hasUp ? FitDirection::Positive : FitDirection::Negative;
}

bool hasRawReadings(const Measurement& measurement)
{
    if (measurement.kind == MeasurementKind::Track)
        return true;
    return measurement.hasTargets() && std::ranges::any_of(measurement.values, &RunValue::isUsed)
        && std::ranges::all_of(measurement.values,
            [](const RunValue& value) { return !value.isUsed || value.encoder.has_value(); });
}

bool hasRawValues(const Measurement& measurement, std::string_view axis)
{
    const bool isOfAnother =
        measurement.hasTargets() && correctsAnotherAxis(axis, measurement.header.axis);
    return hasRawReadings(measurement) && !isOfAnother;
}

FittedTable fittedTable(std::vector<double> values, Grid grid, std::string name, std::string target,
    const std::string& unit)
{
    FittedTable fitted;
    fitted.table.name = std::move(name);
    fitted.table.target = std::move(target);
    fitted.table.unit = unit;
    fitted.table.grid = std::move(grid);
    for (const double value : values) {
        const auto held = static_cast<float>(value);
        fitted.table.values.push_back(held);
        fitted.rounding = std::max(fitted.rounding, std::abs(static_cast<double>(held) - value));
    }
    return fitted;
}

namespace {

/// What a table has within a coarser grid and straight lines between the points of that do not.
double lostDetail(const CompensationTable& table, const Grid& grid, Outside outside)
{
    const Lookup exact(table, outside);
    CompensationTable coarse{table.name, table.unit, grid, {}};
    for (std::size_t i = 0; i < grid.pointCount(); ++i)
        coarse.values.push_back(static_cast<float>(exact.at(positionOf(grid, i))));
    const Lookup lines(coarse, outside);
    double lost = 0.0;
    for (std::size_t i = 0; i < table.values.size(); ++i) {
        const auto position = positionOf(table.grid, i);
        if (isWithin(grid, position))
            lost =
                std::max(lost, std::abs(lines.at(position) - static_cast<double>(table.values[i])));
    }
    return lost;
}

/// What a table has beyond a shorter grid, beside its value at the edge, which the drive holds.
double lostBeyond(const CompensationTable& table, const Grid& grid)
{
    const Lookup exact(table, Outside::Hold);
    double lost = 0.0;
    for (std::size_t i = 0; i < table.values.size(); ++i) {
        auto edge = positionOf(table.grid, i);
        for (std::size_t axis = 0; axis < edge.size(); ++axis)
            edge[axis] = std::clamp(edge[axis], grid.axes[axis].start, grid.axes[axis].last());
        lost = std::max(lost, std::abs(exact.at(edge) - static_cast<double>(table.values[i])));
    }
    return lost;
}

} // namespace

FitMerge mergeOnto(
    const FitInput& input, const CompensationTable& old, const CompensationTable& made)
{
    FitMerge merge;
    merge.onto = input.state.active->name;
    merge.gain = input.settings.gain;
    const Lookup before(old, input.outside());
    const Lookup after(made, input.outside());
    // What both have at the points of either
    for (const Grid* grid : {&made.grid, &old.grid}) {
        for (std::size_t i = 0; i < grid->pointCount(); ++i) {
            auto position = positionOf(*grid, i);
            const double change = std::abs(after.at(position) - before.at(position));
            if (merge.largestAt.empty() || change > merge.largestChange) {
                merge.largestChange = change;
                merge.largestAt = std::move(position);
            }
        }
    }
    merge.lostDetail = lostDetail(old, made.grid, input.outside());
    if (!input.settings.turn)
        merge.lostRange = lostBeyond(old, made.grid);
    return merge;
}

void addRemark(FitReport& report, std::string_view name, Text text, bool isWarning)
{
    report.remarks.push_back({name, std::move(text), isWarning});
}

Result<FitReport> fitMeasurement(const Measurement& measurement, const FitSettings& settings,
    const FoundState& state, std::stop_token stop)
{
    if (!settings.lookupAt)
        return badFit(AXISCOMP_TEXT("Error",
            "at which position the drive looks the table up decides where its values belong: "
            "choose "
            "the encoder, for a position before the compensation, or the set position, for one "
            "after it (--lookup-at encoder or --lookup-at set)"));
    if (!(settings.gain > 0.0 && settings.gain <= 2.0))
        return badFit(AXISCOMP_TEXT("Error", "a gain is above 0 and at most 2; it is usually 1"));
    if (settings.gain != 1.0 && !state.active)
        return badFit(AXISCOMP_TEXT("Error",
            "a gain is for residuals that are merged onto a table (--onto); here the values are "
            "the whole error"));
    const FitInput input{measurement, settings, state, *settings.lookupAt, std::move(stop)};
    AXISCOMP_TRY(auto report, measurement.hasTargets() ? fitRuns(input) : fitScattered(input));
    report.lookupAt = input.lookupAt;
    report.state = state;
    if (!state.assumption.isEmpty())
        addRemark(report, "StateAssumed", state.assumption, true);
    addTableRemarks(input, report);
    std::stable_partition(report.remarks.begin(), report.remarks.end(),
        [](const FitRemark& remark) { return remark.isWarning; });
    return report;
}

} // namespace axiscomp
