// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/fitted_points.h"

#include "core/table/lookup.h"

#include <algorithm>
#include <array>

namespace axiscomp {

namespace {

/// Of the means that a table of this direction is made of, by target; empty where they cannot be
/// told apart by their number.
std::vector<std::optional<double>> standardErrors(
    const Iso230Figures& figures, FitDirection direction, std::size_t means)
{
    std::vector<std::optional<double>> errors;
    for (const TargetFigures& target : figures.targets) {
        if (direction == FitDirection::Mean)
            errors.push_back(standardError(target));
        else if (const DirectionFigures& one =
                     direction == FitDirection::Positive ? target.up : target.down;
                 one.mean)
            errors.push_back(standardError(one));
    }
    if (errors.size() != means)
        errors.assign(means, std::nullopt);
    return errors;
}

std::vector<FittedPoint> meansOf(const FitSettings& settings, const FitReport& report)
{
    const FittedTable& made = report.tables.front();
    const auto errors = report.before
        ? standardErrors(*report.before, settings.direction, made.means.size())
        : std::vector<std::optional<double>>(made.means.size());
    std::vector<FittedPoint> points;
    for (std::size_t i = 0; i < made.means.size(); ++i)
        points.push_back({made.means[i].position, made.means[i].value, 0.0, errors[i]});
    return points;
}

bool isOfDirection(const TrackSample& sample, FitDirection direction)
{
    return direction == FitDirection::Mean
        || (sample.direction == Approach::Up) == (direction == FitDirection::Positive);
}

std::vector<FittedPoint> valuesOfTrack(
    const Measurement& measurement, const FitSettings& settings, const FitReport& report)
{
    std::vector<FittedPoint> points;
    // At the set position the axis stands without what is taken out for the zero.
    const double removed =
        report.lookupAt == LookupAt::Set ? report.tables.front().removedConstant : 0.0;
    for (const TrackSample& sample : measurement.track) {
        if (!isOfDirection(sample, settings.direction))
            continue;
        const auto place = pointOfReading(report.lookupAt, {&sample.encoder, 1},
            {&sample.reference, 1}, sample.reference - sample.encoder);
        points.push_back({place.knot[0] - removed, place.value});
    }
    return points;
}

} // namespace

std::vector<FittedPoint> fittedPoints(
    const Measurement& measurement, const FitSettings& settings, const FitReport& report)
{
    std::vector<FittedPoint> points;
    if (measurement.hasTargets())
        points = meansOf(settings, report);
    else if (measurement.kind == MeasurementKind::Track)
        points = valuesOfTrack(measurement, settings, report);
    const FittedTable& made = report.tables.front();
    const Lookup lookup(made.table, settings.turn ? Outside::Wrap : Outside::Hold);
    for (FittedPoint& point : points) {
        point.value -= made.removedConstant + made.removedSlope * point.position;
        point.residual = point.value - lookup.at(point.position);
    }
    std::ranges::sort(points, {}, &FittedPoint::position);
    return points;
}

} // namespace axiscomp
