// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/fit_fields.h"

namespace axiscomp {

namespace {

FitFields fieldsOfRuns(const FitSettings& settings)
{
    const bool isSmooth = settings.method == FitMethod::Smooth;
    FitFields fields;
    fields.method = true;
    fields.smoothness = isSmooth;
    fields.periods = isSmooth;
    fields.harmonics =
        settings.method == FitMethod::Harmonic || (isSmooth && !settings.periods.periods.empty());
    fields.turn = true;
    fields.direction = true;
    fields.home = settings.zero == FitZero::Automatic || settings.zero == FitZero::Home;
    fields.slope = !settings.turn;
    fields.drift = true;
    fields.within = true;
    fields.holdsEnds = true;
    fields.even = true;
    return fields;
}

FitFields fieldsOfTrack(const FitSettings& settings)
{
    const bool isSmooth = settings.method == FitMethod::Smooth;
    FitFields fields;
    fields.method = true;
    fields.smoothness = true;
    fields.periods = isSmooth;
    fields.harmonics = isSmooth && !settings.periods.periods.empty();
    fields.direction = true;
    fields.within = isSmooth;
    fields.farPoints = true;
    fields.robust = !isSmooth;
    return fields;
}

FitFields fieldsOfPoints()
{
    FitFields fields;
    fields.smoothness = true;
    fields.even = true;
    fields.body = true;
    fields.farPoints = true;
    fields.robust = true;
    return fields;
}

} // namespace

FitFields fitFields(const Measurement& measurement, const FitSettings& settings)
{
    switch (measurement.kind) {
    case MeasurementKind::Runs:
    case MeasurementKind::Averages:
        return fieldsOfRuns(settings);
    case MeasurementKind::Track:
        return fieldsOfTrack(settings);
    case MeasurementKind::Points:
        break;
    }
    return fieldsOfPoints();
}

bool isMethodFor(MeasurementKind kind, FitMethod method)
{
    switch (kind) {
    case MeasurementKind::Runs:
    case MeasurementKind::Averages:
        return true;
    case MeasurementKind::Track:
        return method == FitMethod::Linear || method == FitMethod::Smooth;
    case MeasurementKind::Points:
        break;
    }
    return method == FitMethod::Linear;
}

FitSettings settingsFor(const Measurement& measurement, FitSettings settings)
{
    const FitSettings unset;
    const std::size_t dimensions =
        measurement.kind == MeasurementKind::Points ? measurement.points.axes.size() : 1;
    if (!isMethodFor(measurement.kind, settings.method))
        settings.method = unset.method;
    if (!fitFields(measurement, settings).turn)
        settings.turn = unset.turn;
    if (!fitFields(measurement, settings).periods)
        settings.periods.periods.clear();
    const FitFields fields = fitFields(measurement, settings);
    if (!fields.smoothness)
        settings.smoothness = unset.smoothness;
    if (!fields.harmonics)
        settings.periods.harmonics = unset.periods.harmonics;
    if (!fields.direction)
        settings.direction = unset.direction;
    if (!fields.slope)
        settings.slope = unset.slope;
    if (!fields.drift)
        settings.drift = unset.drift;
    if (!fields.within)
        settings.within = unset.within;
    if (!fields.holdsEnds)
        settings.holdsEnds = unset.holdsEnds;
    if (!fields.body)
        settings.remove = unset.remove;
    if (!fields.farPoints)
        settings.farPoints = unset.farPoints;
    if (!fields.robust)
        settings.isRobust = unset.isRobust;
    // What is said of a home position that only runs have.
    if (!measurement.hasTargets()) {
        settings.home = unset.home;
        if (settings.zero == FitZero::Home)
            settings.zero = unset.zero;
        settings.tolerances.clear();
        settings.uncertainty = unset.uncertainty;
    }
    if (settings.grid.size() > 1 && settings.grid.size() != dimensions)
        settings.grid.resize(1);
    return settings;
}

FitSettings withoutLengths(FitSettings settings)
{
    settings.home.reset();
    settings.zeroPosition.clear();
    if (settings.zero == FitZero::Position)
        settings.zero = FitZero::Automatic;
    settings.turn.reset();
    settings.periods.periods.clear();
    settings.grid.clear();
    settings.within.reset();
    settings.speed.reset();
    return settings;
}

} // namespace axiscomp
