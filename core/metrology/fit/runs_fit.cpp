// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fine_quantity.h"
#include "core/metrology/fit/fit_parts.h"
#include "core/table/even_spacing.h"
#include "core/table/target_axis.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>
#include <string>

namespace axiscomp {

namespace {

/// The mean at a target of what values have beside their deviations.
class TargetMeans {
public:
    template <typename Part>
    TargetMeans(const Measurement& measurement, FitDirection direction, Part part)
        : m_up(measurement.targets.size())
        , m_down(measurement.targets.size())
        , m_direction(direction)
    {
        for (const RunValue& value : measurement.values)
            if (value.isUsed)
                (value.direction == Approach::Up ? m_up : m_down)[value.target].add(part(value));
    }

    /// In the way in which deviations are averaged.
    [[nodiscard]] double at(std::size_t target) const
    {
        const Sum& up = m_up[target];
        const Sum& down = m_down[target];
        const bool isUp = m_direction == FitDirection::Positive || down.count == 0.0;
        const bool isDown = m_direction == FitDirection::Negative || up.count == 0.0;
        if (isUp && up.count > 0.0)
            return up.mean();
        return isDown ? down.mean() : 0.5 * (up.mean() + down.mean());
    }

private:
    struct Sum {
        double total = 0.0;
        double count = 0.0;
        void add(double value)
        {
            total += value;
            count += 1.0;
        }
        [[nodiscard]] double mean() const { return total / count; }
    };
    std::vector<Sum> m_up;
    std::vector<Sum> m_down;
    FitDirection m_direction;
};

/// Whether the raw positions of an axis tell where the values of another one belong.
bool isPlacedByReadings(const FitInput& input)
{
    return input.lookupAt == LookupAt::Encoder && correctsAnother(input)
        && hasRawReadings(input.measurement);
}

} // namespace

FitValues fitValues(const Measurement& measurement, const FitInput& input)
{
    const bool isRaw = input.state.kind == FoundState::Kind::Irrelevant;
    const bool hasRawPlaces = isRaw || isPlacedByReadings(input);
    // Where the axis stood, by its raw positions
    const TargetMeans places(measurement, input.settings.direction,
        [](const RunValue& value) { return value.encoder.value_or(0.0); });
    FitValues result;
    for (std::size_t i = 0; i < measurement.values.size(); ++i) {
        const RunValue& value = measurement.values[i];
        if (!value.isUsed)
            continue;
        MeasuredValue fitted;
        fitted.isUp = value.direction == Approach::Up;
        fitted.run = static_cast<std::size_t>(value.run);
        fitted.target = measurement.targets[value.target];
        fitted.deviation = value.deviation;
        if (isRaw)
            fitted.deviation += fitted.target - *value.encoder;
        if (hasRawPlaces)
            fitted.target = places.at(value.target);
        result.values.push_back(fitted);
        result.indices.push_back(i);
    }
    return result;
}

std::vector<double> usedTargets(const Measurement& measurement)
{
    std::vector<bool> areUsed(measurement.targets.size(), false);
    for (const RunValue& value : measurement.values)
        if (value.isUsed)
            areUsed[value.target] = true;
    std::vector<double> used;
    for (std::size_t i = 0; i < areUsed.size(); ++i)
        if (areUsed[i])
            used.push_back(measurement.targets[i]);
    return used.size() < 2 ? measurement.targets : used;
}

namespace {

/// What findActiveTable finds, after it is known that there is no doubt about it.
const CompensationTable* activeTable(const FitInput& input)
{
    return findActiveTable(input).value_or(nullptr);
}

/// A turn that is shorter than what was measured is the wrong number: targets would fall onto
/// others.
Result<void> checkTurn(const FitInput& input)
{
    if (!input.settings.turn)
        return {};
    const Measurement& measurement = input.measurement;
    const double turn = *input.settings.turn;
    const std::vector<double> used = usedTargets(measurement);
    const double first = used.front();
    const double last = used.back();
    constexpr double rounding = 1e-9;
    if (last - first > turn * (1.0 + rounding))
        return badFit(AXISCOMP_TEXT("Error",
            "the targets go from {from} to {to}, which is more than a turn of {turn}: give the "
            "length of the whole turn (--turn), or leave out what lies in a second one (--exclude)")
                          .with("from", placeOf(first, measurement.isAngular))
                          .with("to", placeOf(last, measurement.isAngular))
                          .with("turn", placeOf(turn, measurement.isAngular)));
    return {};
}

Result<void> checkRunsSettings(const FitInput& input)
{
    const FitSettings& settings = input.settings;
    if (settings.remove != BodyRemoval::None || settings.isRobust
        || settings.farPoints != FarPoints::Refuse)
        return badFit(AXISCOMP_TEXT("Error",
            "--remove, --robust and --fill are for points of two or three axes and for tracks; "
            "this measurement has targets along one axis"));
    const bool hasOneAxis = settings.grid.size() <= 1 || settings.isByTemperature;
    if (!hasOneAxis || settings.zeroPosition.size() > 1)
        return badFit(AXISCOMP_TEXT(
            "Error", "the measurement is along one axis: give one number for its grid and zero"));
    if (settings.zero == FitZero::Position && settings.zeroPosition.empty())
        return badFit(AXISCOMP_TEXT("Error", "the position of the zero is missing"));
    const bool isSmooth = settings.method == FitMethod::Smooth;
    if (settings.smoothness && !isSmooth)
        return badFit(AXISCOMP_TEXT("Error",
            "a smoothness is for the method smooth (--method smooth); the others go through every "
            "mean"));
    if (settings.direction == FitDirection::Both && input.state.active)
        return badFit(AXISCOMP_TEXT("Error",
            "{name} has one value for both directions, and so has what is merged onto it: make the "
            "table of the mean (--direction mean)")
                          .with("name", input.state.active->name));
    if (settings.direction == FitDirection::Both && settings.isByTemperature)
        return badFit(AXISCOMP_TEXT("Error",
            "a table over position and temperature is for a drive, which has one value for both "
            "directions (--direction mean)"));
    AXISCOMP_CHECK(findActiveTable(input));
    return {};
}

Result<void> placeZero(const FitInput& input, TableFitRequest& request)
{
    const FitSettings& settings = input.settings;
    const std::vector<double> targets = usedTargets(input.measurement);
    const bool isHomeMeasured =
        settings.home && *settings.home >= targets.front() && *settings.home <= targets.back();
    switch (settings.zero) {
    case FitZero::Automatic:
        request.zero = isHomeMeasured ? ZeroRule::Position : ZeroRule::First;
        request.zeroPosition = settings.home.value_or(0.0);
        return {};
    case FitZero::Home:
        if (!settings.home)
            return badFit(AXISCOMP_TEXT("Error",
                "the home position of the axis is not known: give it (--home), or the position of "
                "the zero (--zero)"));
        if (!isHomeMeasured)
            return badFit(AXISCOMP_TEXT("Error",
                "the home position {home} is outside the targets, so that the error there is not "
                "known; take the first target for the zero or another position (--zero)")
                              .with("home", placeOf(*settings.home, input.measurement.isAngular)));
        request.zero = ZeroRule::Position;
        request.zeroPosition = *settings.home;
        return {};
    case FitZero::Position:
        request.zero = ZeroRule::Position;
        request.zeroPosition = settings.zeroPosition.front();
        if (!settings.turn
            && (request.zeroPosition < targets.front() || request.zeroPosition > targets.back()))
            return badFit(AXISCOMP_TEXT("Error",
                "the position {position} of the zero is outside the targets, which go from {from} "
                "to {to}")
                              .with("position",
                                  placeOf(request.zeroPosition, input.measurement.isAngular))
                              .with("from", placeOf(targets.front(), input.measurement.isAngular))
                              .with("to", placeOf(targets.back(), input.measurement.isAngular)));
        return {};
    case FitZero::First:
        request.zero = ZeroRule::First;
        return {};
    case FitZero::Mean:
        request.zero = ZeroRule::Mean;
        return {};
    case FitZero::Keep:
        request.zero = ZeroRule::Keep;
        return {};
    }
    return {};
}

/// Of even targets, whose grid the table takes over.
Result<double> distanceOf(const std::vector<double>& targets)
{
    const EvenSpacing even = fitEvenSpacing(targets, noDecimals);
    if (!even.even)
        return badFit(AXISCOMP_TEXT("Error",
            "the targets are not evenly spaced; say the grid of the table: its points, their "
            "distance, or what it may be off the curve (--points, --distance or --within)"));
    return even.distance;
}

/// Where a modulo axis begins to count, as far as its targets tell: they lie between 0 and a turn,
/// or within half a turn to both sides; otherwise the first of them.
double startOfTurn(const std::vector<double>& targets, double turn)
{
    constexpr double rounding = 1e-9; // of a turn
    for (const double offset : {0.0, -0.5 * turn}) {
        const double turns = std::floor((targets.front() - offset) / turn + rounding);
        const double start = turns * turn + offset;
        if (targets.back() <= start + turn * (1.0 + rounding))
            return start;
    }
    return targets.front();
}

/// The range of a table of one turn, and the points where nothing else was asked for: the targets
/// are among them.
Result<AxisRequest> gridOfTurn(const FitInput& input, const CompensationTable* old)
{
    const FitSettings& settings = input.settings;
    const std::vector<double> targets = usedTargets(input.measurement);
    AxisRequest wanted = settings.grid.empty() ? AxisRequest{} : settings.grid.front();
    const double turn = *settings.turn;
    wanted.start = old ? old->grid.axes.front().start : startOfTurn(targets, turn);
    wanted.end = *wanted.start + turn;
    const bool isAsked = settings.within || wanted.points != 0 || wanted.distance != 0.0;
    if (old && !isAsked)
        wanted.points = old->grid.axes.front().size;
    if (old || isAsked || !settings.periods.periods.empty())
        return wanted;
    AXISCOMP_TRY(const double distance, distanceOf(targets));
    constexpr double rounding = 1e-6; // of a step
    const auto isWhole = [&](double length) {
        return std::abs(length / distance - std::round(length / distance)) <= rounding;
    };
    if (!isWhole(targets.front() - *wanted.start) || !isWhole(turn))
        return badFit(AXISCOMP_TEXT("Error",
            "the axis is taken to count from {from} to {to}, and steps of {distance} do not lead "
            "from one end over the targets to the other; say the grid of the table: its points, "
            "their distance, or what it may be off the curve (--points, --distance or --within)")
                          .with("from", placeOf(*wanted.start, input.measurement.isAngular))
                          .with("to", placeOf(*wanted.end, input.measurement.isAngular))
                          .with("distance", placeOf(distance, input.measurement.isAngular)));
    wanted.points = static_cast<std::size_t>(std::llround(turn / distance)) + 1;
    return wanted;
}

/// The grid where knots are not the targets: the old table's, or the targets' own, or what was
/// asked for from the first to the last target. The ends of the curve, which lie beside these by
/// the deviations only, are held as the drive holds them.
Result<AxisRequest> gridBesideTargets(const FitInput& input, const CompensationTable* old)
{
    const FitSettings& settings = input.settings;
    const std::vector<double> targets = usedTargets(input.measurement);
    AxisRequest wanted = settings.grid.empty() ? AxisRequest{} : settings.grid.front();
    const double from = targets.front();
    const double to = targets.back();
    if (settings.within || wanted.points != 0) {
        wanted.start = from;
        wanted.end = to;
        return wanted;
    }
    if (wanted.distance != 0.0) {
        const double range = (to - from) / wanted.distance;
        const double steps = settings.holdsEnds ? std::ceil(range * (1.0 - 1e-12))
                                                : std::floor(range * (1.0 + 1e-12));
        if (steps < 1.0)
            return wanted;
        return AxisRequest{.points = static_cast<std::size_t>(steps) + 1,
            .start = from,
            .end = from + steps * wanted.distance};
    }
    if (old) { // beyond the targets it goes on, with the last residual
        const GridAxis& axis = old->grid.axes.front();
        return AxisRequest{.points = axis.size, .start = axis.start, .end = axis.last()};
    }
    AXISCOMP_TRY(const double distance, distanceOf(targets));
    return AxisRequest{.points = static_cast<std::size_t>(std::llround((to - from) / distance)) + 1,
        .start = from,
        .end = to};
}

} // namespace

Result<TableFitRequest> requestOfRuns(const FitInput& input)
{
    const FitSettings& settings = input.settings;
    TableFitRequest request;
    request.direction = settings.direction;
    request.method = settings.method;
    request.smoothness = settings.smoothness;
    request.periods = settings.periods;
    request.turn = settings.turn;
    request.slope = settings.slope;
    request.lookupAt = input.lookupAt;
    request.correctsAnother = correctsAnother(input);
    request.gain = settings.gain;
    request.within = settings.within;
    request.mostPoints = settings.mostPoints;
    request.holdsEnds = settings.holdsEnds;
    request.unit = positionUnit(input.measurement);
    AXISCOMP_CHECK(placeZero(input, request));
    const CompensationTable* const old = activeTable(input);
    if (input.state.kind == FoundState::Kind::On)
        request.active = {old, 1.0, input.outside()};
    else if (old)
        request.onto = {old, 1.0, input.outside()};
    // Harmonics go on between the knots of their curve, which are the ends of the turn.
    const bool standsOnTargets =
        request.correctsAnother ? !isPlacedByReadings(input) : input.lookupAt == LookupAt::Encoder;
    const bool areKnotsTargets = standsOnTargets && input.state.kind == FoundState::Kind::Off
        && settings.method != FitMethod::Harmonic;
    if (settings.turn) {
        AXISCOMP_TRY(request.grid, gridOfTurn(input, old));
        request.holdsEnds = request.holdsEnds || !areKnotsTargets;
        return request;
    }
    const bool isOpen = settings.grid.empty() && !settings.within && !old;
    if (isOpen && !settings.periods.periods.empty())
        return request;
    if (areKnotsTargets) {
        if (isOpen)
            AXISCOMP_CHECK(distanceOf(usedTargets(input.measurement)));
        if (!settings.grid.empty())
            request.grid = settings.grid.front();
        return request;
    }
    AXISCOMP_TRY(request.grid, gridBesideTargets(input, old));
    request.holdsEnds = true;
    return request;
}

namespace {

/// One table of runs, and how it was made.
struct RunsTable {
    FitSettings settings; ///< of this table: never FitDirection::Both
    TableFitRequest request;
    FitValues values; ///< without the drift that is taken out
    TableFit fit;

    [[nodiscard]] FitInput input(const FitInput& whole) const
    {
        return {whole.measurement, settings, whole.state, whole.lookupAt, whole.stop};
    }
    [[nodiscard]] bool isFor(const MeasuredValue& value) const
    {
        return settings.direction == FitDirection::Mean
            || value.isUp == (settings.direction == FitDirection::Positive);
    }
};

Result<RunsTable> fitOne(const FitInput& whole, const Measurement& settled, FitDirection direction,
    const std::optional<RemovedLine>& removed = {})
{
    RunsTable made{whole.settings, {}, {}, {}};
    made.settings.direction = direction;
    const FitInput input = made.input(whole);
    AXISCOMP_TRY(made.request, requestOfRuns(input));
    made.request.removed = removed;
    made.request.servesBoth = whole.settings.direction != FitDirection::Both;
    made.values = fitValues(settled, input);
    AXISCOMP_TRY(made.fit, fitTable(made.values.values, made.request));
    return made;
}

/// Both tables lose the slope and the constant of their mean, so that their reversal stays, and
/// have one grid, the denser one.
Result<std::vector<RunsTable>> fitBoth(const FitInput& whole, const Measurement& settled)
{
    AXISCOMP_TRY(const auto mean, fitOne(whole, settled, FitDirection::Mean));
    std::vector<RunsTable> tables;
    std::size_t points = 0;
    for (const FitDirection direction : {FitDirection::Positive, FitDirection::Negative}) {
        AXISCOMP_TRY(auto one, fitOne(whole, settled, direction, mean.fit.removed));
        points = std::max(points, one.fit.grid.size);
        tables.push_back(std::move(one));
    }
    for (RunsTable& one : tables) {
        if (one.fit.grid.size == points)
            continue;
        one.request.within.reset();
        one.request.grid.points = points;
        AXISCOMP_TRY(one.fit, fitTable(one.values.values, one.request));
    }
    return tables;
}

Result<std::vector<RunsTable>> fitDirections(const FitInput& input, const Measurement& settled)
{
    if (input.settings.direction == FitDirection::Both)
        return fitBoth(input, settled);
    AXISCOMP_TRY(auto one, fitOne(input, settled, input.settings.direction));
    return std::vector{std::move(one)};
}

/// The same runs with the tables active, as a measurement of its own. One table serves both
/// directions, whichever it was made of. made: the tables as a drive has them.
Result<Measurement> predictedMeasurement(const FitInput& whole,
    const std::vector<RunsTable>& tables, const std::vector<FittedTable>& made)
{
    Measurement result = whole.measurement;
    for (std::size_t n = 0; n < tables.size(); ++n) {
        const FitValues values = fitValues(whole.measurement, tables[n].input(whole));
        AXISCOMP_TRY(
            const auto predicted, predictRuns(values.values, made[n].table, tables[n].request));
        for (std::size_t i = 0; i < predicted.size(); ++i)
            if (tables.size() == 1 || tables[n].isFor(predicted[i]))
                result.values[values.indices[i]].deviation = predicted[i].deviation;
    }
    return result;
}

/// Of both directions at each target.
std::vector<double> heldOutMeans(const std::vector<HeldOut::Residual>& up,
    const std::vector<HeldOut::Residual>& down, double HeldOut::Residual::*part)
{
    std::vector<double> means;
    for (std::size_t i = 0; i < up.size(); ++i)
        means.push_back(0.5 * (up[i].*part + down[i].*part));
    return means;
}

double heldOutRange(const std::vector<double>& numbers)
{
    const auto [lowest, highest] = std::ranges::minmax(numbers);
    return highest - lowest;
}

/// Of two tables: the residuals of both, and M as the standard has it, of their mean at each
/// target.
HeldOut together(const HeldOut& up, const HeldOut& down)
{
    HeldOut both;
    both.residuals = up.residuals;
    both.residuals.insert(both.residuals.end(), down.residuals.begin(), down.residuals.end());
    both.rms = std::sqrt(0.5 * (up.rms * up.rms + down.rms * down.rms));
    both.largest = std::max(up.largest, down.largest);
    both.unknownRange =
        heldOutRange(heldOutMeans(up.residuals, down.residuals, &HeldOut::Residual::unknown));
    std::vector<double> left =
        heldOutMeans(up.residuals, down.residuals, &HeldOut::Residual::value);
    const auto ends = heldOutMeans(up.ends, down.ends, &HeldOut::Residual::value);
    left.insert(left.end(), ends.begin(), ends.end());
    both.range = heldOutRange(left);
    return both;
}

Result<HeldOut> heldOutOf(const std::vector<RunsTable>& tables, const std::stop_token& stop)
{
    std::vector<HeldOut> found;
    for (const RunsTable& one : tables) {
        AXISCOMP_TRY(auto heldOut, predictHeldOut(one.values.values, one.request, stop));
        found.push_back(std::move(heldOut));
    }
    return found.size() == 1 ? std::move(found.front()) : together(found[0], found[1]);
}

} // namespace

Result<Measurement> predictMeasurement(const Measurement& measurement,
    const CompensationTable& table, LookupAt lookupAt, const FoundState& state,
    std::optional<double> turn)
{
    if (!measurement.hasTargets())
        return badFit(AXISCOMP_TEXT("Error", "a prediction needs a measurement of targets"));
    if (table.grid.axes.size() != 1)
        return badFit(AXISCOMP_TEXT("Error", "a prediction needs a table of one dimension"));
    const GridAxis& axis = table.grid.axes.front();
    const double length = axis.last() - axis.start;
    if (turn && !(std::abs(length - *turn) <= 1e-6 * length)) {
        const std::string unit(positionUnit(measurement));
        return badFit(AXISCOMP_TEXT("Error",
            "the table is {length} long, but a turn of the axis is {turn}: a prediction needs a "
            "table of one turn")
                          .with("length", Quantity{roundedText(length), unit})
                          .with("turn", Quantity{roundedText(*turn), unit}));
    }
    FitSettings settings;
    settings.turn = turn;
    const FitInput input{measurement, settings, state, lookupAt, {}};
    AXISCOMP_CHECK(checkTableOfAxis(Text(Verbatim{table.name}), table, input));
    TableFitRequest request;
    request.lookupAt = lookupAt;
    request.correctsAnother = correctsAnother(input);
    request.turn = turn;
    if (state.kind == FoundState::Kind::On) {
        AXISCOMP_TRY(const CompensationTable* const active, findActiveTable(input));
        request.active = {active, 1.0, input.outside()};
    }
    const FitValues values = fitValues(measurement, input);
    AXISCOMP_TRY(const auto predicted, predictRuns(values.values, table, request));
    Measurement result = measurement;
    for (std::size_t i = 0; i < predicted.size(); ++i)
        result.values[values.indices[i]].deviation = predicted[i].deviation;
    for (RunValue& value : result.values) {
        value.encoder.reset();
        value.output.reset();
    }
    return result;
}

namespace {

/// What corrections have put to the value of a knot, on average.
double correctionAt(const FitInput& input, const FitKnot& knot)
{
    const Measurement& measurement = input.measurement;
    const FitValues fitted = fitValues(measurement, input);
    const auto value = std::ranges::min_element(fitted.values, {},
        [&](const MeasuredValue& one) { return std::abs(one.target - knot.target); });
    const auto index = fitted.indices[static_cast<std::size_t>(value - fitted.values.begin())];
    const TargetMeans corrections(
        measurement, input.settings.direction, [](const RunValue& one) { return one.correction; });
    return corrections.at(measurement.values[index].target);
}

TextPattern patternOfRuns(const FitKnot& knot, bool isTakenOut)
{
    if (knot.hasUnequalRuns)
        return isTakenOut
            ? AXISCOMP_TEXT("Measurement",
                "where the encoder reads {reading} the reference said {reference}, the mean of "
                "both directions with {count} values; {taken}, so the drive will add {added}")
            : AXISCOMP_TEXT("Measurement",
                "where the encoder reads {reading} the reference said {reference}, the mean of "
                "both directions with {count} values; the drive will add {added}");
    return isTakenOut
        ? AXISCOMP_COUNTED("Measurement",
            "where the encoder reads {reading} the reference said {reference} on average of "
            "{count} values; {taken}, so the drive will add {added}",
            "where the encoder reads {reading} the reference said {reference}, measured once; "
            "{taken}, so the drive will add {added}")
        : AXISCOMP_COUNTED("Measurement",
            "where the encoder reads {reading} the reference said {reference} on average of "
            "{count} values; the drive will add {added}",
            "where the encoder reads {reading} the reference said {reference}, measured once; the "
            "drive will add {added}");
}

} // namespace

Text signOfRuns(const FitInput& input, const TableFit& fit, const CompensationTable& table)
{
    const bool isAngular = input.measurement.isAngular;
    const Lookup lookup(table, input.outside());
    const FitKnot* largest = &fit.knots.front();
    for (const FitKnot& knot : fit.knots)
        if (std::abs(lookup.at(knot.position)) > std::abs(lookup.at(largest->position)))
            largest = &knot;
    const double added = lookup.at(largest->position);
    const TakenOut removed{fit.removed.constant + fit.removed.slope * largest->position,
        fit.removed.constant != 0.0, fit.removed.slope != 0.0};
    const bool isEncoder = input.lookupAt == LookupAt::Encoder;
    // With gain 1 the value of a knot leads from the raw position to the reference.
    double whole = largest->value;
    double reading = isEncoder ? largest->position : largest->target;
    if (const CompensationTable* const merged = activeTable(input)) {
        const Lookup old(*merged, input.outside());
        const bool isAtTarget = !isEncoder && input.state.kind == FoundState::Kind::On;
        const double before = old.at(isAtTarget ? largest->target : largest->position);
        whole = before + (largest->value - before) / input.settings.gain;
        if (isAtTarget)
            reading -= before;
    }
    const double correction = correctionAt(input, *largest);
    if (correctsAnother(input))
        return signBeside(
            {{positionAlong(table.grid.axes.front().name, largest->position, isAngular)}, whole,
                correction, table.name, removed, added},
            isAngular);
    const double reference = reading + whole;
    Quantity signedAmount = fineQuantity(added, isAngular);
    if (added > 0.0)
        signedAmount.digits = "+" + signedAmount.digits;
    auto taken = takenOutText(takenOut(whole, added, removed), isAngular);
    return patternOfRuns(*largest, taken.has_value())
        .with("reading", placeOf(reading, isAngular))
        .with("reference",
            readAndCorrected(
                placeOf(reference - correction, isAngular), placeOf(reference, isAngular)))
        .with("count", static_cast<std::int64_t>(largest->weight))
        .with("taken", std::move(taken).value_or(Text()))
        .with("added", std::move(signedAmount));
}

namespace {

FittedTable describe(const FitInput& input, const RunsTable& one)
{
    const TableFit& fit = one.fit;
    const Measurement& measurement = input.measurement;
    const std::string unit(positionUnit(measurement));
    AxisNames names = axisNames(input, activeTable(input));
    Direction direction = Direction::Both;
    if (input.settings.direction == FitDirection::Both) {
        const bool isUp = one.settings.direction == FitDirection::Positive;
        direction = isUp ? Direction::Positive : Direction::Negative;
        names.values += isUp ? " up" : " down";
    }
    Grid grid;
    grid.axes = {{std::move(names.positions), unit, fit.grid.start, fit.grid.distance,
        static_cast<std::uint32_t>(fit.grid.size)}};
    FittedTable made = fittedTable(
        fit.values, std::move(grid), std::move(names.values), std::move(names.target), unit);
    made.direction = direction;
    made.removedConstant = fit.removed.constant;
    made.removedSlope = fit.removed.slope;
    made.knots = fit.knots.size();
    made.means = fit.knots;
    made.periods = fit.curve.terms;
    made.smoothness = fit.smoothness;
    made.residualRms = fit.residualRms;
    made.residualLargest = fit.residualLargest;
    made.density = fit.density;
    made.measuredNodes = made.table.values.size();
    return made;
}

/// Of two tables that of the one with the larger value. input: with what was fitted.
Text signOfTables(
    const FitInput& input, const std::vector<RunsTable>& tables, const FitReport& report)
{
    const auto largest = [&](std::size_t n) {
        const TableStatistics values = statistics(report.tables[n].table);
        return std::max(std::abs(values.minimum), std::abs(values.maximum));
    };
    const std::size_t n = tables.size() == 2 && largest(1) > largest(0) ? 1 : 0;
    Text sign = signOfRuns(tables[n].input(input), tables[n].fit, report.tables[n].table);
    if (tables.size() == 1)
        return sign;
    return (n == 0 ? AXISCOMP_TEXT("Measurement", "approached upwards: {sentence}")
                   : AXISCOMP_TEXT("Measurement", "approached downwards: {sentence}"))
        .with("sentence", std::move(sign));
}

} // namespace

Result<FitReport> fitRuns(const FitInput& input)
{
    const FitSettings& settings = input.settings;
    AXISCOMP_CHECK(checkRunsSettings(input));
    AXISCOMP_CHECK(checkTurn(input));
    if (settings.isByTemperature)
        return fitRunsByTemperature(input);
    const Measurement settled =
        settings.drift ? withoutDrift(input.measurement, *settings.drift) : input.measurement;
    AXISCOMP_TRY(const auto tables, fitDirections(input, settled));

    FitReport report;
    for (const RunsTable& one : tables)
        report.tables.push_back(describe(input, one));
    if (const CompensationTable* const old = activeTable(input))
        report.merge = mergeOnto(input, *old, report.tables.front().table);
    JudgeOptions judging;
    judging.outlierRule = settings.outlierRule;
    const Judgement judgement = judge(input.measurement, judging);
    report.before = judgement.figures;
    AXISCOMP_TRY(const auto predicted, predictedMeasurement(input, tables, report.tables));
    report.predicted = iso230Figures(predicted);
    AXISCOMP_CHECK(addHeldOut(heldOutOf(tables, input.stop), report));
    judgeForetold(settings, report);
    report.sign =
        signOfTables({settled, settings, input.state, input.lookupAt, input.stop}, tables, report);
    addRunsRemarks(input, outlierCount(judgement), tables.front().fit, report);
    std::vector<CompensationTable> made;
    for (const FittedTable& one : report.tables)
        made.push_back(one.table);
    addStateRemarks(input, judgement, made, report);
    return report;
}

} // namespace axiscomp
