// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/resampling/resampling.h"
#include "core/metrology/fine_quantity.h"
#include "core/metrology/fit/grid_points.h"
#include "core/metrology/fit/scatter_fit.h"
#include "core/table/even_spacing.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace axiscomp {

namespace {

using ScatteredNumbers = std::vector<double>;
/// The points of a grid that the curve through a track decides; 0: it does not.
Result<std::size_t> pointsOfCurve(
    const FitInput& input, const SmoothedCurve* smoothed, double from, double to)
{
    const FitSettings& settings = input.settings;
    if (!smoothed)
        return std::size_t{0};
    if (settings.within) {
        AXISCOMP_TRY(const auto fewest,
            fewestCurvePoints(smoothed->curve, from, to, *settings.within, settings.mostPoints,
                std::string(positionUnit(input.measurement))));
        return fewest.points;
    }
    const bool isOpen = settings.grid.empty() && !settings.periods.periods.empty();
    return isOpen ? settings.periods.pointsOver(to - from) : std::size_t{0};
}

/// smoothed: the curve through a track; null: the fit is on the grid itself.
Result<GridAxis> gridAxis(
    const FitInput& input, const Scatter& scatter, std::size_t axis, const SmoothedCurve* smoothed)
{
    const FitSettings& settings = input.settings;
    const ScatteredNumbers& positions = scatter.positions[axis];
    const auto [from, to] = std::ranges::minmax(positions);
    GridAxis made;
    made.name = scatter.axes[axis];
    made.unit = positionUnit(input.measurement);
    made.start = from;
    if (!(to > from))
        return badFit(AXISCOMP_TEXT("Error", "all points have the same position along {axis}")
                          .with("axis", made.name));
    const AxisRequest wanted = settings.grid.empty() ? AxisRequest{}
        : settings.grid.size() == 1                  ? settings.grid.front()
                                                     : settings.grid[axis];
    AXISCOMP_TRY(const std::size_t ofCurve, pointsOfCurve(input, smoothed, from, to));
    const std::size_t points = ofCurve > 0 ? ofCurve : wanted.points;
    if (points >= 2) {
        made.size = static_cast<std::uint32_t>(std::min<std::size_t>(points, 100'000'000));
        made.distance = evenDistance(from, to, made.size);
        return made;
    }
    if (settings.grid.empty()) {
        const auto lines = distinctTargets(positions);
        const bool isGrid = input.measurement.kind == MeasurementKind::Points
            && lines.size() < scatter.size() && fitEvenSpacing(lines, noDecimals).even;
        if (!isGrid)
            return badFit(AXISCOMP_TEXT("Error",
                "the positions along {axis} are no even grid; say the grid of the table: its "
                "points, or their distance (--points or --distance)")
                              .with("axis", made.name));
        made.size = static_cast<std::uint32_t>(lines.size());
        made.distance = evenDistance(from, to, lines.size());
        return made;
    }
    if (!(wanted.distance > 0.0))
        return badFit(AXISCOMP_TEXT("Error", "a grid has at least 2 points along {axis}")
                          .with("axis", made.name));
    // The last point of the grid may lie behind the data, so that none of it is left out.
    const double steps = std::max(1.0, std::ceil((to - from) / wanted.distance * (1.0 - 1e-12)));
    if (steps > 100'000'000.0)
        return badFit(AXISCOMP_TEXT("Error", "the distance along {axis} is too small")
                          .with("axis", made.name));
    made.size = static_cast<std::uint32_t>(steps) + 1;
    made.distance = wanted.distance;
    return made;
}

/// The grid of the table that the points are merged onto, where they cover it and no other is asked
/// for.
std::optional<Grid> coveredOldGrid(
    const FitInput& input, const Scatter& scatter, const ActiveTable& onto)
{
    if (!input.settings.grid.empty() || input.settings.within || !onto.table)
        return std::nullopt;
    Grid grid = onto.table->grid;
    for (std::size_t axis = 0; axis < scatter.dimensions(); ++axis) {
        const auto [from, to] = std::ranges::minmax(scatter.positions[axis]);
        const double rounding = 1e-9 * (to - from);
        if (grid.axes[axis].start < from - rounding || grid.axes[axis].last() > to + rounding)
            return std::nullopt;
        grid.axes[axis].name = scatter.axes[axis];
    }
    return grid;
}

Result<Grid> gridOf(const FitInput& input, const Scatter& scatter, const ActiveTable& onto,
    const SmoothedCurve* smoothed)
{
    const FitSettings& settings = input.settings;
    if (settings.grid.size() > 1 && settings.grid.size() != scatter.dimensions())
        return badFit(
            AXISCOMP_TEXT("Error", "the grid needs one number, or one for each of the {count} axes")
                .with("count", scatter.dimensions()));
    if (auto old = coveredOldGrid(input, scatter, onto))
        return *std::move(old);
    Grid grid;
    for (std::size_t axis = 0; axis < scatter.dimensions(); ++axis) {
        AXISCOMP_TRY(auto made, gridAxis(input, scatter, axis, smoothed));
        grid.axes.push_back(std::move(made));
    }
    if (grid.pointCount() > settings.mostPoints)
        return fail(ErrorCode::ResamplingImpossible,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "the grid would have more than {count} points; take fewer along an axis")
                    .with("count", settings.mostPoints)}});
    return grid;
}

/// Through every value of a track goes no curve that is of use: only the smoothing spline.
Result<void> checkScatterMethod(const FitSettings& settings, bool isTrack)
{
    const bool isOnGrid = settings.method == FitMethod::Linear && settings.periods.periods.empty();
    if (isTrack && settings.direction == FitDirection::Both)
        return badFit(AXISCOMP_TEXT("Error",
            "a table for each direction is made of runs over targets; make those of a track one "
            "after the other (--direction positive, then --direction negative)"));
    if (!isTrack && !isOnGrid)
        return badFit(AXISCOMP_TEXT("Error",
            "points are fitted on the grid itself, as the drive interpolates it; leave out "
            "--method and --period"));
    if (!isOnGrid && settings.method != FitMethod::Smooth)
        return badFit(AXISCOMP_TEXT("Error",
            "a track is fitted on the grid itself, or by --method smooth, which known periods "
            "(--period) need; leave other methods out"));
    if (!isOnGrid && settings.isRobust)
        return badFit(AXISCOMP_TEXT("Error",
            "--robust is for a fit on the grid itself; leave out --robust or --method smooth"));
    return {};
}

Result<void> checkScatterSettings(const FitInput& input, std::size_t dimensions)
{
    const FitSettings& settings = input.settings;
    const bool isTrack = input.measurement.kind == MeasurementKind::Track;
    AXISCOMP_CHECK(checkScatterMethod(settings, isTrack));
    if (settings.slope != SlopeRemoval::Keep || settings.turn || settings.home || settings.drift)
        return badFit(AXISCOMP_TEXT("Error",
            "--remove-slope, --turn, --home and --remove-drift are for runs over targets along one "
            "axis"));
    if (settings.within && isFittedOnGrid(input.measurement, settings))
        return badFit(AXISCOMP_TEXT("Error",
            "the fewest points that leave no more than a deviation (--within) are counted on a "
            "curve, which runs have, and a track with --method smooth; say the points of the grid "
            "or their distance (--points or --distance)"));
    if (!settings.tolerances.empty())
        return badFit(AXISCOMP_TEXT(
            "Error", "the figures of the standard need targets; leave --tolerance out"));
    if (settings.zero == FitZero::Home)
        return badFit(AXISCOMP_TEXT("Error",
            "a home position is that of one axis measured over targets; take --zero first, mean, "
            "keep or a position"));
    if (isTrack && settings.remove != BodyRemoval::None)
        return badFit(
            AXISCOMP_TEXT("Error", "--remove is for points of two or three axes; a track has one"));
    if (!isTrack && settings.direction != FitDirection::Mean)
        return badFit(AXISCOMP_TEXT("Error", "points have no direction; leave --direction out"));
    if (settings.zero == FitZero::Position && settings.zeroPosition.size() != dimensions)
        return badFit(AXISCOMP_TEXT("Error", "the zero needs {count} numbers, one for each axis")
                          .with("count", dimensions));
    if (settings.remove == BodyRemoval::RigidAlong && settings.removeAlong >= dimensions)
        return badFit(AXISCOMP_TEXT("Error", "--remove names an axis that the points do not have"));
    return {};
}

FitZero zeroRuleOf(const FitSettings& settings)
{
    if (settings.zero != FitZero::Automatic)
        return settings.zero;
    return settings.remove == BodyRemoval::None ? FitZero::First : FitZero::Keep;
}

Result<double> zeroOf(const FitInput& input, const Grid& grid, const std::vector<double>& values)
{
    const FitSettings& settings = input.settings;
    const FitZero zero = zeroRuleOf(settings);
    if (zero == FitZero::First)
        return values.front();
    if (zero == FitZero::Mean)
        return std::accumulate(values.begin(), values.end(), 0.0)
            / static_cast<double>(values.size());
    if (zero != FitZero::Position)
        return 0.0;
    if (!isWithin(grid, settings.zeroPosition))
        return badFit(AXISCOMP_TEXT("Error", "the position of the zero is outside the grid"));
    ScatteredValues place;
    for (std::size_t axis = 0; axis < grid.axes.size(); ++axis)
        place.coordinates[axis] = {&settings.zeroPosition[axis], 1};
    const double nothing = 0.0;
    place.values = {&nothing, 1};
    return interpolated(GridShape(grid), values, locate(grid, place).points.front());
}
void describeCurve(const SmoothedCurve& smoothed, const GridAxis& axis, FittedTable& made)
{
    made.knots = smoothed.curve.base.knots.size();
    made.smoothness = smoothed.smoothness;
    made.periods = smoothed.curve.terms;
    made.density = curveGrid(smoothed.curve, axis.start, axis.last(), axis.size);
}

/// smoothed: the curve that the grid takes its values from; null: they are fitted on it.
Result<FittedTable> fitColumn(const FitInput& input, const Scatter& scatter,
    const Scatter::Column& column, const Grid& grid, const SmoothedCurve* smoothed, GridFit& fit)
{
    // Residuals are fitted, and what they are merged onto is added as it is: a table that is denser
    // than the points keeps what it has between them. The curve has it already.
    AXISCOMP_TRY(const ActiveTable merged, ontoOf(input, column, scatter.axes));
    const ActiveTable onto = smoothed ? ActiveTable{} : merged;
    GridFitRequest request;
    request.grid = grid;
    if (smoothed) {
        const GridAxis& axis = grid.axes.front();
        for (std::size_t i = 0; i < axis.size; ++i)
            request.nodes.push_back(smoothed->curve.at(axis.position(i)));
    } else {
        request.smoothness = input.settings.smoothness;
    }
    request.isRobust = input.settings.isRobust;
    request.farPoints = input.settings.farPoints;
    request.stop = input.stop;
    AXISCOMP_TRY(fit, fitOntoGrid(scatter, column, onto, request));
    if (onto.table) {
        const Lookup before(*onto.table, onto.outside);
        for (std::size_t i = 0; i < fit.values.size(); ++i)
            fit.values[i] += before.at(positionOf(grid, i));
    }
    AXISCOMP_TRY(const double zero, zeroOf(input, grid, fit.values));
    for (double& value : fit.values)
        value -= zero;
    FittedTable made = fittedTable(
        fit.values, grid, column.name, column.target, std::string(positionUnit(input.measurement)));
    made.table.filled = fit.filled;
    made.removedConstant = zero;
    made.knots = fit.values.size();
    made.smoothness = fit.smoothness;
    if (smoothed)
        describeCurve(*smoothed, grid.axes.front(), made);
    made.residualRms = fit.residualRms;
    made.residualLargest = fit.residualLargest;
    made.crossValidation = fit.crossValidation;
    made.filledNodes = fit.filled.size();
    made.measuredNodes = fit.values.size() - fit.filled.size();
    return made;
}

/// Of a track samples were left out after its turns and of other directions, so that a number would
/// be that of no line of its file: its place is said.
void remarkOfDoubtful(const FitInput& input, const Scatter& scatter, const Scatter::Column& column,
    const GridFit& fit, FitReport& report)
{
    if (fit.doubtful.empty())
        return;
    const bool isAngular = input.measurement.isAngular;
    const DoubtfulPoint& first = fit.doubtful.front();
    Text text = input.measurement.kind == MeasurementKind::Track
        ? AXISCOMP_COUNTED("Measurement",
            "{count} values of {table} do not fit the others and count little; the first is at "
            "{place}, {residual} off",
            "1 value of {table} does not fit the others and counts little: at {place}, "
            "{residual} off")
              .with("place", placeOf(scatter.positions.front()[first.index], isAngular))
        : AXISCOMP_COUNTED("Measurement",
            "{count} values of {table} do not fit the others and count little; the first is "
            "point {first}, {residual} off",
            "1 value of {table} does not fit the others and counts little: point {first}, "
            "{residual} off")
              .with("first", first.index + 1);
    addRemark(report, "DoubtfulPoints",
        std::move(text)
            .with("count", fit.doubtful.size())
            .with("table", column.name)
            .with("residual", fineQuantity(first.residual, isAngular)),
        true);
}

/// What the data say of the fit.
void remarkOfFit(const FitInput& input, const Scatter& scatter, const Scatter::Column& column,
    const GridFit& fit, FitReport& report)
{
    const bool isAngular = input.measurement.isAngular;
    addRemark(report, "Explained",
        AXISCOMP_TEXT("Measurement",
            "{table} explains {share} % of the variance of {count} values; {rms} rms remains")
            .with("table", column.name)
            .with("share", percentText(std::clamp(fit.explained, 0.0, 1.0)))
            .with("count", fit.usedPoints)
            .with("rms", fineQuantity(fit.residualRms, isAngular)));
    if (fit.explainsLittle())
        addRemark(report, "ExplainsLittle",
            AXISCOMP_TEXT("Measurement",
                "{table} explains little: values that were left out are foretold with {left} rms, "
                "and they are {values} rms themselves")
                .with("table", column.name)
                .with("left", fineQuantity(*fit.crossValidation, isAngular))
                .with("values", fineQuantity(fit.valueRms, isAngular)),
            true);
    if (fit.outside > 0)
        addRemark(report, "PointsOutside",
            AXISCOMP_COUNTED("Measurement", "{count} values lie outside the grid and were left out",
                "1 value lies outside the grid and was left out")
                .with("count", fit.outside),
            true);
    remarkOfDoubtful(input, scatter, column, fit, report);
}

/// squareness: as RigidBody has it. Above 0 the angle between the axes is below 90 degrees.
Text squarenessText(const std::string& first, const std::string& second, double squareness)
{
    const double degrees = squareness * 180.0 / 3.14159265358979323846;
    const bool isAbove = fineQuantity(degrees, true).digits.starts_with('-'); // of what is shown
    Text text = isAbove
        ? AXISCOMP_TEXT(
            "Measurement", "the angle between {first} and {second} is {angle} more than 90 degrees")
        : AXISCOMP_TEXT("Measurement",
            "the angle between {first} and {second} is {angle} less than 90 degrees");
    return std::move(text)
        .with("first", first)
        .with("second", second)
        .with("angle", fineQuantity(std::abs(degrees), true));
}

void remarkOfBody(const Scatter& scatter, const RigidBody& body, FitReport& report)
{
    constexpr std::array<std::array<std::size_t, 2>, 3> pairs{{{0, 1}, {0, 2}, {1, 2}}};
    for (std::size_t i = 0; i < pairs.size(); ++i)
        if (pairs[i][1] < scatter.dimensions())
            addRemark(report, "Squareness",
                squarenessText(
                    scatter.axes[pairs[i][0]], scatter.axes[pairs[i][1]], body.squareness[i]));
    if (body.scale != 0.0)
        addRemark(report, "ScaleRemoved",
            AXISCOMP_TEXT("Measurement",
                "a scale of {scale} for each {length} was taken out; the mean scale error of the "
                "axes is in it, and stays in the machine")
                .with("scale", fineQuantity(body.scale * 1000.0, false))
                .with("length", placeOf(1000.0, false)),
            true);
}

Text signOf(const FitInput& input, const Scatter& scatter, const FittedTable& made)
{
    const bool isAngular = input.measurement.isAngular;
    const Scatter::Column& column = scatter.columns.front();
    const Lookup lookup(made.table);
    const auto place = [&](std::size_t point) {
        std::vector<double> position;
        for (const ScatteredNumbers& along : column.places)
            position.push_back(along[point]);
        return position;
    };
    std::size_t largest = 0;
    for (std::size_t i = 1; i < scatter.size(); ++i)
        if (std::abs(lookup.at(place(i))) > std::abs(lookup.at(place(largest))))
            largest = i;
    std::vector<Text> position;
    for (std::size_t axis = 0; axis < scatter.dimensions(); ++axis)
        position.push_back(
            positionAlong(scatter.axes[axis], scatter.positions[axis][largest], isAngular));
    const bool hasBody = input.settings.remove != BodyRemoval::None;
    return signBeside({std::move(position), column.read[largest], 0.0, made.table.name,
                          {column.body[largest] + made.removedConstant, true, false, hasBody},
                          lookup.at(place(largest))},
        isAngular);
}

struct ScatterFit {
    Scatter scatter; ///< with its places
    ActiveTable onto; ///< of the first column
    std::vector<FittedTable> tables; ///< of each column
    std::vector<GridFit> fits;
};

Result<ScatterFit> fitPlaced(const FitInput& input, const Scatter& scatter)
{
    ScatterFit made{scatter, {}, {}, {}};
    const bool isTrack = input.measurement.kind == MeasurementKind::Track;
    if (!isTrack)
        AXISCOMP_CHECK(placeColumns(input, made.scatter));
    AXISCOMP_TRY(made.onto, ontoOf(input, made.scatter.columns.front(), made.scatter.axes));
    if (isTrack) {
        placeTrack(input, made.scatter, made.scatter.columns.front());
        takeShare(made.onto, input.settings.gain, made.scatter.columns.front());
    }
    AXISCOMP_TRY(const auto curve, curveOf(input, made.scatter, made.onto));
    const SmoothedCurve* const smoothed = curve ? &*curve : nullptr;
    AXISCOMP_TRY(const Grid grid, gridOf(input, made.scatter, made.onto, smoothed));
    for (const Scatter::Column& column : made.scatter.columns) {
        GridFit fit;
        AXISCOMP_TRY(auto table, fitColumn(input, made.scatter, column, grid, smoothed, fit));
        made.tables.push_back(std::move(table));
        made.fits.push_back(std::move(fit));
    }
    return made;
}

/// What the zero takes out of a table with gain 1, whose places all have.
Result<double> wholeConstant(const FitInput& input, const ScatterFit& fit, std::size_t n)
{
    const Scatter::Column& column = fit.scatter.columns[n];
    const FittedTable& made = fit.tables[n];
    AXISCOMP_TRY(const ActiveTable onto, ontoOf(input, column, fit.scatter.axes));
    const double gain = input.settings.gain;
    if (gain == 1.0 || !onto.table)
        return made.removedConstant;
    const Grid& grid = made.table.grid;
    const Lookup lookup(*onto.table, onto.outside);
    std::vector<double> before;
    for (std::size_t i = 0; i < grid.pointCount(); ++i)
        before.push_back(lookup.at(positionOf(grid, i)));
    AXISCOMP_TRY(const double old, zeroOf(input, grid, before));
    return old + (made.removedConstant - old) / gain;
}

/// At the set position the axes stand without what the zeros take out, which the fit tells: places
/// that are off move the values by their slope only.
Result<ScatterFit> fitPlaces(const FitInput& input, Scatter scatter)
{
    if (input.lookupAt != LookupAt::Set || zeroRuleOf(input.settings) == FitZero::Keep)
        return fitPlaced(input, scatter);
    double range = 0.0;
    for (const ScatteredNumbers& along : scatter.positions) {
        const auto [from, to] = std::ranges::minmax(along);
        range = std::max(range, to - from);
    }
    for (Scatter::Column& column : scatter.columns) // nearly all of it is the instrument's zero
        column.removed = std::accumulate(column.values.begin(), column.values.end(), 0.0)
            / static_cast<double>(column.values.size());
    constexpr int mostRounds = 8;
    constexpr double near = 1e-7; // times a slope of 0.001 it is nothing, also of float32
    for (int round = 1;; ++round) {
        AXISCOMP_TRY(auto made, fitPlaced(input, scatter));
        double change = 0.0;
        for (std::size_t i = 0; i < scatter.columns.size(); ++i) {
            Scatter::Column& column = scatter.columns[i];
            AXISCOMP_TRY(const double removed, wholeConstant(input, made, i));
            if (column.own)
                change = std::max(change, std::abs(removed - column.removed));
            column.removed = removed;
        }
        if (change <= near * range || round == mostRounds)
            return made;
    }
}

} // namespace

Text positionAlong(const std::string& axis, double position, bool isAngular)
{
    return AXISCOMP_TEXT("Measurement", "{axis} {position}")
        .with("axis", axis)
        .with("position", placeOf(position, isAngular));
}

Argument readAndCorrected(Quantity read, Quantity corrected)
{
    if (read == corrected)
        return read;
    return AXISCOMP_TEXT("Measurement", "{read} ({corrected} after corrections)")
        .with("read", std::move(read))
        .with("corrected", std::move(corrected));
}

TakenOut takenOut(double measured, double added, TakenOut removed)
{
    constexpr double unseen = 1e-3; // of what is added: less is the rounding of the numbers
    removed.evened = measured - removed.removed - added;
    if (std::abs(removed.evened) <= unseen * std::abs(added))
        removed.evened = 0.0;
    return removed;
}

std::optional<Text> takenOutText(const TakenOut& taken, bool isAngular)
{
    if (taken.removed == 0.0 && taken.evened == 0.0)
        return std::nullopt;
    const Quantity evened = fineQuantity(taken.evened, isAngular);
    if (taken.removed == 0.0)
        return AXISCOMP_TEXT(
            "Measurement", "{evened} was taken out by gain, averaging, smoothing or grid")
            .with("evened", evened);
    const TextPattern pattern = taken.hasBody
        ? AXISCOMP_TEXT("Measurement",
            "{removed} was taken out for how the artefact lay and for the zero of the table")
        : taken.hasSlope && !taken.hasZero
        ? AXISCOMP_TEXT("Measurement", "{removed} was taken out for the slope")
        : taken.hasSlope
        ? AXISCOMP_TEXT(
            "Measurement", "{removed} was taken out for the slope and the zero of the table")
        : AXISCOMP_TEXT("Measurement", "{removed} was taken out for the zero of the table");
    Text removed = pattern.with("removed", fineQuantity(taken.removed, isAngular));
    if (taken.evened == 0.0)
        return removed;
    return AXISCOMP_TEXT(
        "Measurement", "{removed}, and {evened} by gain, averaging, smoothing or grid")
        .with("removed", std::move(removed))
        .with("evened", evened);
}

Text signBeside(SignBeside sign, bool isAngular)
{
    auto taken = takenOutText(takenOut(sign.measured, sign.added, sign.removed), isAngular);
    const TextPattern pattern = taken ? AXISCOMP_TEXT("Measurement",
                                    "at {position} the reference was {measured} beside the encoder "
                                    "in {table}; {taken}, so the drive will add {added}")
                                      : AXISCOMP_TEXT("Measurement",
                                          "at {position} the reference was {measured} beside the "
                                          "encoder in {table}; the drive will add {added}");
    return pattern.with("position", std::move(sign.position))
        .with("measured",
            readAndCorrected(fineQuantity(sign.measured - sign.correction, isAngular),
                fineQuantity(sign.measured, isAngular)))
        .with("table", std::move(sign.table))
        .with("taken", std::move(taken).value_or(Text()))
        .with("added", fineQuantity(sign.added, isAngular));
}

Result<FitReport> fitScattered(const FitInput& input)
{
    const bool isTrack = input.measurement.kind == MeasurementKind::Track;
    if (input.settings.isByTemperature)
        return badFit(AXISCOMP_TEXT(
            "Error", "a table over temperature is made of runs with targets along one axis"));
    const CompensationTable* old = nullptr;
    if (isTrack) {
        AXISCOMP_TRY(old, findActiveTable(input));
    }
    Scatter scatter =
        isTrack ? scatterOfTrack(input, axisNames(input, old)) : scatterOfPoints(input);
    AXISCOMP_CHECK(checkScatterSettings(input, scatter.dimensions()));
    if (scatter.size() == 0)
        return badFit(AXISCOMP_TEXT("Error", "there are no values in this direction"));
    FitReport report;
    AXISCOMP_TRY(report.removedBody, removeBody(input, scatter));
    AXISCOMP_TRY(auto made, fitPlaces(input, std::move(scatter)));
    for (std::size_t i = 0; i < made.tables.size(); ++i)
        remarkOfFit(input, made.scatter, made.scatter.columns[i], made.fits[i], report);
    report.tables = std::move(made.tables);
    if (made.onto.table)
        report.merge = mergeOnto(input, *made.onto.table, report.tables.front().table);
    if (report.removedBody)
        remarkOfBody(made.scatter, *report.removedBody, report);
    report.sign = signOf(input, made.scatter, report.tables.front());
    return report;
}

} // namespace axiscomp
