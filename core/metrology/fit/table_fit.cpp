// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/table_fit.h"

#include "core/base/parallel.h"
#include "core/curve/harmonic_curve.h"
#include "core/curve/smoothing_spline.h"
#include "core/metrology/fit/fit_errors.h"
#include "core/neutral/neutral_table.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace axiscomp {

namespace {

using FitNumbers = std::vector<double>;

Quantity positionQuantity(double position, const std::string& unit)
{
    return {roundedText(position), unit};
}

/// The values of one target.
struct TargetValues {
    double target = 0.0;
    FitNumbers up;
    FitNumbers down;
};

double plainMean(const FitNumbers& numbers)
{
    double sum = 0.0;
    for (const double number : numbers)
        sum += number;
    return sum / static_cast<double>(numbers.size());
}

/// By target; targets that are the same within 1e-9 of the range are one.
Result<std::vector<TargetValues>> byTargets(std::span<const MeasuredValue> values)
{
    std::vector<MeasuredValue> sorted(values.begin(), values.end());
    for (const MeasuredValue& value : sorted)
        if (!std::isfinite(value.target) || !std::isfinite(value.deviation))
            return badFit(AXISCOMP_TEXT("Error", "targets and deviations must be finite numbers"));
    std::ranges::sort(sorted, {}, [](const MeasuredValue& value) {
        return std::tuple(value.target, value.isUp, value.run, value.deviation);
    });
    std::vector<TargetValues> targets;
    const double range = sorted.empty() ? 0.0 : sorted.back().target - sorted.front().target;
    for (const MeasuredValue& value : sorted) {
        if (targets.empty() || value.target - targets.back().target > 1e-9 * range)
            targets.push_back({value.target, {}, {}});
        (value.isUp ? targets.back().up : targets.back().down).push_back(value.deviation);
    }
    if (targets.size() < 2)
        return badFit(
            AXISCOMP_TEXT("Error", "there are values at {count} targets; a table needs two")
                .with("count", targets.size()));
    return targets;
}

bool hasBothDirections(const std::vector<TargetValues>& targets)
{
    const bool hasUp = std::ranges::any_of(targets, [](const auto& t) { return !t.up.empty(); });
    const bool hasDown =
        std::ranges::any_of(targets, [](const auto& t) { return !t.down.empty(); });
    return hasUp && hasDown;
}

/// The mean of the wanted direction at each target; value: not yet in the frame.
Result<std::vector<FitKnot>> meansOf(
    const std::vector<TargetValues>& targets, const TableFitRequest& request)
{
    const bool isBoth = hasBothDirections(targets);
    std::vector<FitKnot> knots;
    for (const TargetValues& target : targets) {
        const bool needsUp = request.direction == FitDirection::Positive
            || (request.direction == FitDirection::Mean && (isBoth || !target.up.empty()));
        const bool needsDown = request.direction == FitDirection::Negative
            || (request.direction == FitDirection::Mean && (isBoth || !target.down.empty()));
        if ((needsUp && target.up.empty()) || (needsDown && target.down.empty()))
            return badFit(AXISCOMP_TEXT("Error",
                "the target {target} has no value of one direction; measure it, leave the target "
                "out, or make the table of the other direction (--direction)")
                              .with("target", positionQuantity(target.target, request.unit)));
        const double up = needsUp ? plainMean(target.up) : plainMean(target.down);
        const double down = needsDown ? plainMean(target.down) : up;
        const std::size_t count =
            (needsUp ? target.up.size() : 0) + (needsDown ? target.down.size() : 0);
        const bool isUnequal = needsUp && needsDown && target.up.size() != target.down.size();
        knots.push_back({target.target, target.target, 0.5 * (up + down),
            static_cast<double>(count), isUnequal});
    }
    return knots;
}

Result<LookupFrame> frameOf(const TableFitRequest& request)
{
    const ActiveTable mover = request.correctsAnother ? ActiveTable{} : request.active;
    return LookupFrame::make(request.lookupAt, {mover}, request.active);
}

/// At the set position an axis stands beside its targets by its own deviations.
bool standsBesideTargets(const TableFitRequest& request)
{
    return request.lookupAt == LookupAt::Set && !request.correctsAnother;
}

/// Where the means belong. Knots are those of gain 1; what they are merged onto counts in full.
/// removed: from the table, so that the axis stands without it at the set position.
Result<void> placeKnots(
    std::vector<FitKnot>& knots, const TableFitRequest& request, const RemovedLine& removed)
{
    AXISCOMP_TRY(const LookupFrame frame, frameOf(request));
    const auto onto = linesOf(request.onto);
    for (FitKnot& knot : knots) {
        const double moved = request.correctsAnother ? 0.0 : knot.value;
        AXISCOMP_TRY(const auto point, frame.atTarget({&knot.target, 1}, knot.value, {&moved, 1}));
        knot.position = point.knot[0];
        if (standsBesideTargets(request))
            knot.position =
                (knot.position - removed.constant - request.laterConstant) / (1.0 + removed.slope);
        const double residual = onto ? point.value - onto->at(knot.position) : knot.value;
        knot.value = point.value - (1.0 - request.gain) * residual;
    }
    std::ranges::sort(knots, {}, &FitKnot::position);
    return {};
}

struct KnotColumns {
    FitNumbers positions;
    FitNumbers values;
    FitNumbers weights;

    explicit KnotColumns(const std::vector<FitKnot>& knots)
    {
        for (const FitKnot& knot : knots) {
            positions.push_back(knot.position);
            values.push_back(knot.value);
            weights.push_back(knot.weight);
        }
    }
};

Result<FittedCurve> curveThrough(
    const KnotColumns& columns, const TableFitRequest& request, TableFit& fit)
{
    const CurveSamples samples{columns.positions, columns.values, columns.weights, request.unit};
    if (!request.periods.periods.empty() && request.method != FitMethod::Smooth)
        return badFit(AXISCOMP_TEXT(
            "Error", "known periods are fitted by the method smooth only (--method smooth)"));
    switch (request.method) {
    case FitMethod::Linear:
        return straightLines(samples, request.turn);
    case FitMethod::Cubic:
        return monotoneCubic(samples, request.turn);
    case FitMethod::Spline:
        return interpolatingSpline(samples, request.turn);
    case FitMethod::Smooth: {
        AXISCOMP_TRY(auto smoothed,
            smoothingSpline(samples, {request.smoothness, request.turn, request.periods}));
        fit.smoothness = smoothed.smoothness;
        return std::move(smoothed.curve);
    }
    case FitMethod::Harmonic: {
        if (!request.turn)
            return badFit(AXISCOMP_TEXT(
                "Error", "harmonics need the length of a turn, which is that of a modulo axis"));
        AXISCOMP_TRY(
            auto harmonic, fitHarmonics(samples, *request.turn, request.periods.harmonics));
        return std::move(harmonic.curve);
    }
    }
    return badFit(AXISCOMP_TEXT("Error", "there is no such method"));
}

/// Residuals are fitted, and what they are merged onto is added as it is: a table that is denser
/// than the targets keeps what it has between them.
Result<FittedCurve> fitCurve(
    const std::vector<FitKnot>& knots, const TableFitRequest& request, TableFit& fit)
{
    KnotColumns columns(knots);
    auto before = linesOf(request.active.table ? request.active : request.onto);
    if (before)
        for (std::size_t i = 0; i < columns.values.size(); ++i)
            columns.values[i] -= before->at(columns.positions[i]);
    AXISCOMP_TRY(FittedCurve curve, curveThrough(columns, request, fit));
    curve.onto = std::move(before);
    return curve;
}

double slopeOf(SlopeRemoval removal, const std::vector<FitKnot>& knots)
{
    if (removal == SlopeRemoval::Keep)
        return 0.0;
    if (removal == SlopeRemoval::Ends)
        return (knots.back().value - knots.front().value)
            / (knots.back().position - knots.front().position);
    double position = 0.0;
    double value = 0.0;
    for (const FitKnot& knot : knots) {
        position += knot.position / static_cast<double>(knots.size());
        value += knot.value / static_cast<double>(knots.size());
    }
    double square = 0.0;
    double product = 0.0;
    for (const FitKnot& knot : knots) {
        square += (knot.position - position) * (knot.position - position);
        product += (knot.position - position) * (knot.value - value);
    }
    return product / square;
}

/// Where the zero of a table is: on average of these places; none: it has no zero.
std::vector<double> zeroPlaces(const TableFitRequest& request, const std::vector<FitKnot>& knots)
{
    if (request.zero == ZeroRule::First)
        return {knots.front().position};
    if (request.zero == ZeroRule::Position)
        return {request.zeroPosition};
    std::vector<double> places;
    if (request.zero == ZeroRule::Mean)
        for (const FitKnot& knot : knots)
            places.push_back(knot.position);
    return places;
}

RemovedLine removedLine(const TableFitRequest& request, const TableFit& fit)
{
    if (request.removed)
        return *request.removed;
    RemovedLine line{slopeOf(request.slope, fit.knots), 0.0};
    const std::vector<double> places = zeroPlaces(request, fit.knots);
    for (const double place : places)
        line.constant +=
            (fit.curve.at(place) - line.slope * place) / static_cast<double>(places.size());
    return line;
}

/// What the knots are placed without. At the set position it is found on the curve through them,
/// which moves by what is still wrong of it times the slope of the values; the knots are those of
/// gain 1, and so is this.
Result<RemovedLine> lineOutOfPositions(
    const std::vector<FitKnot>& means, const TableFitRequest& request)
{
    const bool isNothingTaken =
        request.zero == ZeroRule::Keep && request.slope == SlopeRemoval::Keep;
    if (request.removed || !standsBesideTargets(request) || isNothingTaken)
        return request.removed.value_or(RemovedLine{});
    TableFitRequest whole = request;
    whole.gain = 1.0;
    RemovedLine line;
    if (request.zero != ZeroRule::Keep) // nearly all of it is the zero of the instrument
        for (const FitKnot& knot : means)
            line.constant += knot.value / static_cast<double>(means.size());
    const double range = means.back().target - means.front().target;
    constexpr int mostRounds = 8;
    for (int round = 0; round < mostRounds; ++round) {
        TableFit fit;
        fit.knots = means;
        AXISCOMP_CHECK(placeKnots(fit.knots, whole, line));
        AXISCOMP_TRY(fit.curve, fitCurve(fit.knots, whole, fit));
        const RemovedLine before = line;
        line = removedLine(whole, fit);
        const double change =
            std::abs(line.constant - before.constant) + range * std::abs(line.slope - before.slope);
        if (change <= 1e-12 * range)
            break;
    }
    return line;
}

/// Slope and zero of a curve that is shown beside its table.
FittedCurve relieved(const TableFit& fit)
{
    FittedCurve curve = fit.curve;
    for (std::size_t i = 0; i < curve.base.knots.size(); ++i) {
        curve.base.values[i] -= fit.removed.slope * curve.base.knots[i] + fit.removed.constant;
        if (!curve.base.slopes.empty())
            curve.base.slopes[i] -= fit.removed.slope;
    }
    return curve;
}

/// The knots as resampling plans grids for them.
NeutralTable lineOf(const FittedCurve& curve, const TableFitRequest& request)
{
    NeutralTable table;
    SourceAxis axis;
    axis.unit = request.unit;
    axis.knots = curve.base.knots;
    axis.wrap = request.turn;
    table.axes.push_back(std::move(axis));
    CompensationColumn column;
    column.values = curve.base.values;
    table.columns.push_back(std::move(column));
    return table;
}

Result<PlannedAxis> planGrid(const FittedCurve& curve, const TableFitRequest& request)
{
    const NeutralTable line = lineOf(curve, request);
    const double from = request.grid.start.value_or(curve.base.knots.front());
    const double to = request.grid.end.value_or(curve.base.knots.back());
    if (request.within) {
        AXISCOMP_TRY(const auto fewest,
            fewestCurvePoints(curve, from, to, *request.within, request.mostPoints, request.unit));
        return planPoints(line.axes[0], from, to, fewest.points);
    }
    AxisRequest wanted = request.grid;
    const bool isOpen = wanted.points == 0 && wanted.distance == 0.0;
    if (isOpen && !request.periods.periods.empty())
        wanted.points = request.periods.pointsOver(to - from);
    return planAxis(line, 0, wanted, request.holdsEnds);
}

/// What the table says beside the curve: linear between the points of a grid that was asked for,
/// which a modulo axis enters anew with each turn.
Result<double> tableAt(const FittedCurve& curve, const TableFitRequest& request, double position)
{
    const bool hasGrid = request.within || request.grid.points != 0 || request.grid.distance != 0.0
        || !request.periods.periods.empty();
    if (!hasGrid)
        return curve.at(position);
    AXISCOMP_TRY(const PlannedAxis plan, planGrid(curve, request));
    if (request.turn)
        position -= *request.turn * std::floor((position - plan.knots.front()) / *request.turn);
    const auto above = std::ranges::upper_bound(plan.knots, position);
    if (above == plan.knots.begin() || above == plan.knots.end())
        return curve.at(std::clamp(position, plan.knots.front(), plan.knots.back()));
    const double low = *std::prev(above);
    const double fraction = (position - low) / (*above - low);
    return curve.at(low) + fraction * (curve.at(*above) - curve.at(low));
}

/// What the axis shows at each target, in the frame of the knots: all of it, whatever a gain takes
/// of it, and the mean of both directions where the table serves both and both were measured.
Result<std::vector<FitKnot>> wholeErrors(const std::vector<TargetValues>& targets,
    const TableFitRequest& request, const RemovedLine& removed)
{
    TableFitRequest whole = request;
    whole.gain = 1.0;
    const bool hasBoth = std::ranges::all_of(
        targets, [](const auto& target) { return !target.up.empty() && !target.down.empty(); });
    if (request.servesBoth && hasBoth)
        whole.direction = FitDirection::Mean;
    AXISCOMP_TRY(auto errors, meansOf(targets, whole));
    AXISCOMP_CHECK(placeKnots(errors, whole, removed));
    return errors;
}

/// What stays in the machine since its slope was taken out of the table; none at the zero.
double leftBySlope(
    const TableFitRequest& request, const std::vector<FitKnot>& knots, double position)
{
    const double slope = request.removed ? request.removed->slope : slopeOf(request.slope, knots);
    if (slope == 0.0)
        return 0.0;
    double zero = 0.0;
    const std::vector<double> places = zeroPlaces(request, knots);
    for (const double place : places)
        zero += place / static_cast<double>(places.size());
    return slope * (position - zero);
}

/// What the table of some of the knots leaves at one. error: the whole of it there.
Result<HeldOut::Residual> residualOf(const std::vector<FitKnot>& made, const FitKnot& knot,
    const FitKnot& error, const TableFitRequest& request)
{
    TableFit ignored;
    AXISCOMP_TRY(const FittedCurve curve, fitCurve(made, request, ignored));
    AXISCOMP_TRY(const double fitted, tableAt(curve, request, knot.position));
    AXISCOMP_TRY(const double added,
        error.position == knot.position ? Result<double>(fitted)
                                        : tableAt(curve, request, error.position));
    return HeldOut::Residual{knot.target,
        error.value - added + leftBySlope(request, made, error.position),
        (knot.value - fitted) / request.gain};
}

/// Whether a table that knows all of the error is not to take out all of it.
bool leavesByRequest(const TableFitRequest& request)
{
    const bool leavesSlope =
        request.slope != SlopeRemoval::Keep || (request.removed && request.removed->slope != 0.0);
    const bool leavesDirection = request.servesBoth && request.direction != FitDirection::Mean;
    return request.gain != 1.0 || leavesSlope || leavesDirection;
}

void describeReversal(const std::vector<TargetValues>& targets, TableFit& fit)
{
    if (!hasBothDirections(targets))
        return;
    double reversal = 0.0;
    double lowest = std::numeric_limits<double>::infinity();
    double highest = -lowest;
    for (const TargetValues& target : targets) {
        if (target.up.empty() || target.down.empty())
            continue;
        const double up = plainMean(target.up);
        const double down = plainMean(target.down);
        reversal = std::max(reversal, std::abs(up - down));
        lowest = std::min({lowest, up, down});
        highest = std::max({highest, up, down});
    }
    fit.remainingReversal = 0.5 * reversal;
    fit.isMostlyReversal = reversal > 0.5 * (highest - lowest);
}

void describeResiduals(TableFit& fit)
{
    double square = 0.0;
    double weight = 0.0;
    for (const FitKnot& knot : fit.knots) {
        const double residual = knot.value - fit.curve.at(knot.position);
        square += knot.weight * residual * residual;
        weight += knot.weight;
        fit.residualLargest = std::max(fit.residualLargest, std::abs(residual));
    }
    fit.residualRms = std::sqrt(square / weight);
}

/// One run, linear between its raw positions, its ends held.
class RunError {
public:
    void add(double position, double error) { m_points.emplace(position, error); }
    [[nodiscard]] double at(double position) const
    {
        const auto above = m_points.upper_bound(position);
        if (above == m_points.begin())
            return above->second;
        const auto below = std::prev(above);
        if (above == m_points.end())
            return below->second;
        const double fraction = (position - below->first) / (above->first - below->first);
        return below->second + fraction * (above->second - below->second);
    }

private:
    std::map<double, double> m_points;
};

/// Of an axis that the targets are not along: where these lie what it has is replaced.
std::vector<MeasuredValue> predictedOfAnother(
    std::span<const MeasuredValue> values, const ActiveTable& made, const TableFitRequest& request)
{
    const auto before = linesOf(request.active);
    const Lookup after(*made.table, made.outside);
    std::vector<MeasuredValue> predicted(values.begin(), values.end());
    for (MeasuredValue& value : predicted)
        value.deviation +=
            (before ? before->at(value.target) : 0.0) - made.factor * after.at(value.target);
    return predicted;
}

} // namespace

std::optional<CubicCurve> linesOf(const ActiveTable& table)
{
    if (!table.table)
        return std::nullopt;
    const GridAxis& axis = table.table->grid.axes.front();
    CubicCurve lines;
    for (std::uint32_t i = 0; i < axis.size; ++i) {
        lines.knots.push_back(axis.position(i));
        lines.values.push_back(table.factor * static_cast<double>(table.table->values[i]));
    }
    if (table.outside == Outside::Wrap)
        lines.wrap = axis.last() - axis.start;
    return lines;
}

CompensationTable TableFit::table(const std::string& unit) const
{
    CompensationTable table;
    table.unit = unit;
    table.grid.axes = {
        {{}, unit, grid.start, grid.distance, static_cast<std::uint32_t>(grid.size)}};
    for (const double value : values)
        table.values.push_back(static_cast<float>(value));
    return table;
}

Result<TableFit> fitTable(std::span<const MeasuredValue> values, const TableFitRequest& request)
{
    if (request.turn && request.slope != SlopeRemoval::Keep)
        return badFit(AXISCOMP_TEXT(
            "Error", "a modulo axis has no slope that could be removed: it ends where it begins"));
    AXISCOMP_TRY(const auto targets, byTargets(values));
    TableFit fit;
    AXISCOMP_TRY(fit.knots, meansOf(targets, request));
    AXISCOMP_TRY(const RemovedLine line, lineOutOfPositions(fit.knots, request));
    AXISCOMP_CHECK(placeKnots(fit.knots, request, line));
    AXISCOMP_TRY(fit.curve, fitCurve(fit.knots, request, fit));
    fit.removed = removedLine(request, fit);
    const FittedCurve curve = relieved(fit);
    AXISCOMP_TRY(const PlannedAxis plan, planGrid(curve, request));
    if (plan.knots.size() > request.mostPoints)
        return fail(ErrorCode::ResamplingImpossible,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "the grid would have more than {count} points; take fewer along an axis")
                    .with("count", request.mostPoints)}});
    fit.grid = plan.grid;
    for (const double position : plan.knots)
        fit.values.push_back(curve.at(position));
    fit.density = curveGrid(curve, plan.knots.front(), plan.knots.back(), plan.knots.size());
    describeResiduals(fit);
    describeReversal(targets, fit);
    return fit;
}

Result<std::vector<MeasuredValue>> predictRuns(std::span<const MeasuredValue> values,
    const CompensationTable& table, const TableFitRequest& request)
{
    AXISCOMP_TRY(const LookupFrame before, frameOf(request));
    const ActiveTable made{&table, 1.0, request.turn ? Outside::Wrap : Outside::Hold};
    if (request.correctsAnother)
        return predictedOfAnother(values, made, request);
    AXISCOMP_TRY(const LookupFrame after, LookupFrame::make(request.lookupAt, {made}, made));
    std::map<std::pair<bool, std::size_t>, RunError> runs;
    for (const MeasuredValue& value : values) {
        AXISCOMP_TRY(const auto raw, before.rawPosition({&value.target, 1}));
        // reference - raw position, whatever was active
        runs[{value.isUp, value.run}].add(raw[0], value.target + value.deviation - raw[0]);
    }
    std::vector<MeasuredValue> predicted;
    for (const MeasuredValue& value : values) {
        AXISCOMP_TRY(const auto raw, after.rawPosition({&value.target, 1}));
        MeasuredValue moved = value;
        moved.deviation = raw[0] + runs.at({value.isUp, value.run}).at(raw[0]) - value.target;
        predicted.push_back(moved);
    }
    return predicted;
}

Result<HeldOut> predictHeldOut(std::span<const MeasuredValue> values,
    const TableFitRequest& request, const std::stop_token& stop)
{
    AXISCOMP_TRY(const auto targets, byTargets(values));
    if (targets.size() < 4)
        return badFit(AXISCOMP_TEXT(
            "Error", "there are values at {count} targets; four are needed to leave one out")
                          .with("count", targets.size()));
    AXISCOMP_TRY(auto knots, meansOf(targets, request));
    AXISCOMP_TRY(const RemovedLine line, lineOutOfPositions(knots, request));
    AXISCOMP_CHECK(placeKnots(knots, request, line));
    AXISCOMP_TRY(const auto errors, wholeErrors(targets, request, line));
    const auto errorAt = [&errors](const FitKnot& knot) -> const FitKnot& {
        return *std::ranges::find(errors, knot.target, &FitKnot::target);
    };
    // All but the first and the last.
    std::vector<Result<HeldOut::Residual>> found(
        knots.size() - std::min<std::size_t>(2, knots.size()));
    shareWork(found.size(), 0, [&](std::size_t n) {
        const auto left = static_cast<std::ptrdiff_t>(n) + 1;
        std::vector<FitKnot> others = knots;
        others.erase(others.begin() + left);
        const FitKnot& knot = knots[n + 1];
        found[n] = stop.stop_requested() ? Result<HeldOut::Residual>(fail(ErrorCode::Cancelled))
                                         : residualOf(others, knot, errorAt(knot), request);
    });
    HeldOut result;
    double square = 0.0;
    for (const Result<HeldOut::Residual>& one : found) {
        AXISCOMP_TRY(const auto residual, one);
        result.residuals.push_back(residual);
        square += residual.value * residual.value;
    }
    if (leavesByRequest(request))
        for (const FitKnot* const end : {&knots.front(), &knots.back()}) {
            AXISCOMP_TRY(const auto residual, residualOf(knots, *end, errorAt(*end), request));
            result.ends.push_back(residual);
        }
    std::vector<HeldOut::Residual> all = result.residuals;
    all.insert(all.end(), result.ends.begin(), result.ends.end());
    const auto [lowest, highest] = std::ranges::minmax(all, {}, &HeldOut::Residual::value);
    const auto [least, most] =
        std::ranges::minmax(result.residuals, {}, &HeldOut::Residual::unknown);
    result.rms = std::sqrt(square / static_cast<double>(result.residuals.size()));
    result.largest = std::max(std::abs(lowest.value), std::abs(highest.value));
    result.range = highest.value - lowest.value;
    result.unknownRange = most.unknown - least.unknown;
    return result;
}

} // namespace axiscomp
