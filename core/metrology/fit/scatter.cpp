// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/scatter.h"
#include "core/table/target_axis.h"

#include <array>

namespace axiscomp {

namespace {

bool isWanted(const TrackSample& sample, FitDirection direction)
{
    return direction == FitDirection::Mean
        || (sample.direction == Approach::Up) == (direction == FitDirection::Positive);
}

/// The column of the deviations along each dimension; null: not measured.
std::vector<const Scatter::Column*> ownColumns(const Scatter& scatter)
{
    std::vector<const Scatter::Column*> own(scatter.dimensions());
    for (const Scatter::Column& column : scatter.columns)
        if (column.own)
            own[*column.own] = &column;
    return own;
}

/// The table of what was active for an axis of points over these; none: nothing was. Errors: those
/// of checkTableOver.
Result<ActiveTable> activeFor(
    const FitInput& input, const std::string& target, std::span<const std::string> axes)
{
    if (input.state.kind != FoundState::Kind::On || target.empty())
        return ActiveTable{};
    const auto& tables = input.state.active->tables;
    const auto found = std::ranges::find(tables, target, &CompensationTable::target);
    if (found == tables.end())
        return ActiveTable{};
    AXISCOMP_CHECK(checkTableOver(input.state.active->name, *found, axes));
    return ActiveTable{&*found};
}

} // namespace

Scatter scatterOfTrack(const FitInput& input, const AxisNames& names)
{
    const Measurement& measurement = input.measurement;
    Scatter scatter;
    scatter.axes = {names.positions};
    scatter.positions.resize(1);
    Scatter::Column column{names.values, names.target, 0, {}};
    for (const TrackSample& sample : measurement.track) {
        if (!isWanted(sample, input.settings.direction))
            continue;
        scatter.positions[0].push_back(sample.encoder);
        column.values.push_back(sample.reference - sample.encoder);
        scatter.directions.push_back(sample.direction);
    }
    column.read = column.values;
    column.body.assign(column.values.size(), 0.0);
    scatter.columns.push_back(std::move(column));
    return scatter;
}

Scatter inDirection(const Scatter& track, Approach direction)
{
    const Scatter::Column& all = track.columns.front();
    Scatter some;
    some.axes = track.axes;
    some.positions.resize(1);
    Scatter::Column column;
    column.places.resize(1);
    for (std::size_t i = 0; i < track.size(); ++i) {
        if (track.directions[i] != direction)
            continue;
        some.positions[0].push_back(track.positions[0][i]);
        column.values.push_back(all.values[i]);
        column.places[0].push_back(all.places[0][i]);
    }
    some.columns.push_back(std::move(column));
    return some;
}

Scatter scatterOfPoints(const FitInput& input)
{
    const MeasuredPoints& points = input.measurement.points;
    Scatter scatter;
    scatter.axes = points.axes;
    scatter.positions = points.positions;
    for (std::size_t i = 0; i < points.columns.size(); ++i) {
        Scatter::Column column;
        column.name = points.columns[i];
        column.target = targetInHeader(column.name, points.axes);
        if (const auto target = targetAxis(column.target, points.axes))
            column.own = target->source;
        column.values = points.values[i];
        column.body.assign(column.values.size(), 0.0);
        scatter.columns.push_back(std::move(column));
    }
    return scatter;
}

Result<std::optional<RigidBody>> removeBody(const FitInput& input, Scatter& scatter)
{
    const FitSettings& settings = input.settings;
    if (settings.remove == BodyRemoval::None)
        return std::nullopt;
    const auto own = ownColumns(scatter);
    VectorDeviations vectors;
    vectors.dimensions = scatter.dimensions();
    for (std::size_t axis = 0; axis < own.size(); ++axis) {
        if (!own[axis])
            return badFit(AXISCOMP_TEXT("Error",
                "how the artefact lay is found from the deviations along all of its axes, but "
                "there is no column for {axis}, such as d{axis}; take out nothing (--remove)")
                              .with("axis", scatter.axes[axis]));
        vectors.positions[axis] = scatter.positions[axis];
        vectors.deviations[axis] = own[axis]->values;
    }
    RigidBodyRequest request;
    if (settings.remove == BodyRemoval::RigidAlong)
        request.alongAxis = settings.removeAlong;
    request.fitsScale = settings.remove == BodyRemoval::Scale;
    AXISCOMP_TRY(const auto body, fitRigidBody(vectors, request));
    for (Scatter::Column& column : scatter.columns) {
        if (!column.own)
            continue;
        for (std::size_t i = 0; i < scatter.size(); ++i) {
            std::array<double, 3> position{};
            for (std::size_t axis = 0; axis < scatter.dimensions(); ++axis)
                position[axis] = scatter.positions[axis][i];
            column.body[i] = body.at(position)[*column.own];
            column.values[i] -= column.body[i];
        }
    }
    return body;
}

Result<ActiveTable> ontoOf(
    const FitInput& input, const Scatter::Column& column, std::span<const std::string> axes)
{
    if (input.measurement.kind != MeasurementKind::Track)
        return activeFor(input, column.target, axes);
    AXISCOMP_TRY(const CompensationTable* const old, findActiveTable(input));
    return ActiveTable{old};
}

void takeShare(const ActiveTable& onto, double gain, Scatter::Column& column)
{
    if (!onto.table)
        return;
    const Lookup before(*onto.table, onto.outside);
    for (std::size_t i = 0; i < column.values.size(); ++i)
        column.values[i] -= (1.0 - gain) * (column.values[i] - before.at(column.places[0][i]));
}

Result<void> placeColumns(const FitInput& input, Scatter& scatter)
{
    const std::size_t dimensions = scatter.dimensions();
    std::vector<ActiveTable> movers;
    for (const std::string& axis : scatter.axes) {
        AXISCOMP_TRY(movers.emplace_back(), activeFor(input, axis, scatter.axes));
    }
    const auto own = ownColumns(scatter);
    std::vector<ScatteredNumbers> moved(dimensions, ScatteredNumbers(scatter.size(), 0.0));
    for (std::size_t axis = 0; axis < dimensions; ++axis)
        if (own[axis])
            for (std::size_t i = 0; i < scatter.size(); ++i)
                moved[axis][i] = own[axis]->values[i] - own[axis]->removed;
    for (Scatter::Column& column : scatter.columns) {
        AXISCOMP_TRY(const ActiveTable active, activeFor(input, column.target, scatter.axes));
        if (input.state.kind == FoundState::Kind::On && !active.table)
            return badFit(AXISCOMP_TEXT("Error",
                "{name} has no table whose target is that of the column {column}; state the "
                "targets of its tables, or measure without a table")
                              .with("name", input.state.active->name)
                              .with("column", column.name));
        AXISCOMP_TRY(const auto frame, LookupFrame::make(input.lookupAt, movers, active));
        column.places.assign(dimensions, ScatteredNumbers(scatter.size()));
        column.read.resize(scatter.size());
        for (std::size_t i = 0; i < scatter.size(); ++i) {
            std::array<double, 3> target{};
            std::array<double, 3> shift{};
            for (std::size_t axis = 0; axis < dimensions; ++axis) {
                target[axis] = scatter.positions[axis][i];
                shift[axis] = moved[axis][i];
            }
            const double residual = column.values[i];
            AXISCOMP_TRY(const auto point,
                frame.atTarget({target.data(), dimensions}, residual, {shift.data(), dimensions}));
            for (std::size_t axis = 0; axis < dimensions; ++axis)
                column.places[axis][i] = point.knot[axis];
            column.values[i] = point.value - (1.0 - input.settings.gain) * residual;
            column.read[i] = point.value + column.body[i];
        }
    }
    return {};
}

void placeTrack(const FitInput& input, const Scatter& scatter, Scatter::Column& column)
{
    column.places = scatter.positions;
    if (input.lookupAt == LookupAt::Set)
        for (std::size_t i = 0; i < column.read.size(); ++i)
            column.places[0][i] += column.read[i] - column.removed;
}

} // namespace axiscomp
