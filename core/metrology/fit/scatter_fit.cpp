// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/scatter_fit.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

namespace axiscomp {

namespace {

ScatteredNumbers withoutOnto(const ActiveTable& onto, const Scatter::Column& column)
{
    ScatteredNumbers residuals = column.values;
    if (!onto.table)
        return residuals;
    const Lookup before(*onto.table, onto.outside);
    std::vector<double> place(column.places.size());
    for (std::size_t i = 0; i < residuals.size(); ++i) {
        for (std::size_t axis = 0; axis < place.size(); ++axis)
            place[axis] = column.places[axis][i];
        residuals[i] -= before.at(place);
    }
    return residuals;
}

/// A value measured within the grid belongs beside its edge where a deviation moves it out: there
/// the drive has the value of the edge.
std::vector<ScatteredNumbers> heldPlaces(
    const Scatter& scatter, const Scatter::Column& column, const Grid& grid)
{
    std::vector<ScatteredNumbers> places = column.places;
    for (std::size_t axis = 0; axis < places.size(); ++axis) {
        const GridAxis& along = grid.axes[axis];
        const double rounding = 1e-9 * (along.last() - along.start);
        for (std::size_t i = 0; i < places[axis].size(); ++i) {
            const double measured = scatter.positions[axis][i];
            if (measured >= along.start - rounding && measured <= along.last() + rounding)
                places[axis][i] = std::clamp(places[axis][i], along.start, along.last());
        }
    }
    return places;
}

Result<SmoothedCurve> splineThrough(
    const FitInput& input, const Scatter& scatter, const ActiveTable& onto)
{
    const Scatter::Column& column = scatter.columns.front();
    const ScatteredNumbers residuals = withoutOnto(onto, column);
    const CurveSamples samples{
        column.places.front(), residuals, {}, std::string(positionUnit(input.measurement))};
    return smoothingSpline(
        samples, {.smoothness = input.settings.smoothness, .periods = input.settings.periods});
}

/// Errors: InvalidArgument.
auto nothingInCommon()
{
    return badFit(AXISCOMP_TEXT("Error",
        "the two directions of the track have no part of the way in common: make the table of one "
        "of them (--direction positive or negative)"));
}

Result<SmoothedCurve> meanOfSplines(const SmoothedCurve& up, const SmoothedCurve& down)
{
    const CubicCurve& one = up.curve.base;
    const CubicCurve& other = down.curve.base;
    if (std::max(one.knots.front(), other.knots.front())
        >= std::min(one.knots.back(), other.knots.back()))
        return nothingInCommon();
    SmoothedCurve mean = up;
    mean.curve.base = meanOf(one, other);
    for (std::size_t i = 0; i < mean.curve.terms.size(); ++i) {
        PeriodicTerm& term = mean.curve.terms[i];
        const PeriodicTerm& ofDown = down.curve.terms[i];
        term.cosine = 0.5 * (term.cosine + ofDown.cosine);
        term.sine = 0.5 * (term.sine + ofDown.sine);
        term.standardError = 0.5 * std::hypot(term.standardError, ofDown.standardError);
    }
    mean.smoothness = std::max(up.smoothness, down.smoothness);
    return mean;
}

/// Of one direction, or without directions.
Result<GridFit> fitOneOntoGrid(const Scatter& scatter, const Scatter::Column& column,
    const ActiveTable& onto, const GridFitRequest& request)
{
    const ScatteredNumbers residuals = withoutOnto(onto, column);
    const auto places = heldPlaces(scatter, column, request.grid);
    ScatteredValues values;
    for (std::size_t axis = 0; axis < scatter.dimensions(); ++axis)
        values.coordinates[axis] = places[axis];
    values.values = residuals;
    return fitGrid(values, request);
}

/// nodes: ascending, not empty.
std::size_t nearestOf(const std::vector<std::size_t>& nodes, std::size_t node)
{
    const auto next = std::ranges::lower_bound(nodes, node);
    if (next == nodes.end())
        return nodes.back();
    const bool isBefore = next != nodes.begin() && node - *std::prev(next) < *next - node;
    return isBefore ? *std::prev(next) : *next;
}

/// What is between the fits of two directions at each node; where one was not measured that of the
/// nearest node beside which both were. Errors: those of nothingInCommon.
Result<ScatteredNumbers> betweenDirections(const GridFit& up, const GridFit& down)
{
    std::vector<std::size_t> common;
    for (std::size_t node = 0; node < up.values.size(); ++node) {
        const auto number = static_cast<std::uint32_t>(node);
        if (!std::ranges::binary_search(up.filled, number)
            && !std::ranges::binary_search(down.filled, number))
            common.push_back(node);
    }
    if (common.empty())
        return nothingInCommon();
    ScatteredNumbers between;
    for (std::size_t node = 0; node < up.values.size(); ++node) {
        const std::size_t nearest = nearestOf(common, node);
        between.push_back(down.values[nearest] - up.values[nearest]);
    }
    return between;
}

/// A track in both directions: the mean of the fits of each.
Result<GridFit> fitBothOntoGrid(
    const Scatter& scatter, const ActiveTable& onto, GridFitRequest request)
{
    GridFitRequest ofOne = request;
    ofOne.farPoints = FarPoints::Smooth; // what both leave open is seen below
    std::array<GridFit, 2> fits;
    constexpr std::array directions{Approach::Up, Approach::Down};
    for (std::size_t n = 0; n < fits.size(); ++n) {
        const Scatter some = inDirection(scatter, directions[n]);
        AXISCOMP_TRY(fits[n], fitOneOntoGrid(some, some.columns.front(), onto, ofOne));
    }
    AXISCOMP_TRY(const auto between, betweenDirections(fits[0], fits[1]));
    double squares = 0.0;
    for (std::size_t node = 0; node < between.size(); ++node) {
        const bool isUpKnown =
            !std::ranges::binary_search(fits[0].filled, static_cast<std::uint32_t>(node));
        request.nodes.push_back(isUpKnown ? fits[0].values[node] + 0.5 * between[node]
                                          : fits[1].values[node] - 0.5 * between[node]);
        squares += 0.25 * between[node] * between[node] / static_cast<double>(between.size());
    }
    request.smoothness.reset();
    request.isRobust = false;
    AXISCOMP_TRY(GridFit fit, fitOneOntoGrid(scatter, scatter.columns.front(), onto, request));
    fit.smoothness = std::max(fits[0].smoothness, fits[1].smoothness);
    if (fits[0].crossValidation && fits[1].crossValidation) // what is left out is of one direction
        fit.crossValidation = std::sqrt(squares
            + 0.5
                * (std::pow(*fits[0].crossValidation, 2) + std::pow(*fits[1].crossValidation, 2)));
    for (std::size_t n = 0; n < fits.size(); ++n) {
        std::vector<std::size_t> samples;
        for (std::size_t i = 0; i < scatter.size(); ++i)
            if (scatter.directions[i] == directions[n])
                samples.push_back(i);
        for (DoubtfulPoint point : fits[n].doubtful) {
            point.index = samples[point.index];
            fit.doubtful.push_back(point);
        }
    }
    std::ranges::sort(fit.doubtful, {}, &DoubtfulPoint::index);
    return fit;
}

} // namespace

Result<std::optional<SmoothedCurve>> curveOf(
    const FitInput& input, const Scatter& scatter, const ActiveTable& onto)
{
    if (isFittedOnGrid(input.measurement, input.settings))
        return std::nullopt;
    const auto smoothed = [&]() -> Result<SmoothedCurve> {
        if (!scatter.hasBothDirections())
            return splineThrough(input, scatter, onto);
        AXISCOMP_TRY(const auto up, splineThrough(input, inDirection(scatter, Approach::Up), onto));
        AXISCOMP_TRY(
            const auto down, splineThrough(input, inDirection(scatter, Approach::Down), onto));
        return meanOfSplines(up, down);
    };
    AXISCOMP_TRY(auto curve, smoothed());
    curve.curve.onto = linesOf(onto);
    return std::optional(std::move(curve));
}

Result<GridFit> fitOntoGrid(const Scatter& scatter, const Scatter::Column& column,
    const ActiveTable& onto, const GridFitRequest& request)
{
    const bool isFitted = request.nodes.empty();
    return isFitted && scatter.hasBothDirections() ? fitBothOntoGrid(scatter, onto, request)
                                                   : fitOneOntoGrid(scatter, column, onto, request);
}

} // namespace axiscomp
