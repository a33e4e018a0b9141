// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/record/comparison.h"

#include "core/curve/smoothing_spline.h"
#include "core/metrology/fit/measurement_fit.h"
#include "core/metrology/joined_files.h"
#include "core/store/backup_json.h"
#include "core/table/target_axis.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>
#include <iterator>

namespace axiscomp {

namespace {

using Numbers = std::vector<double>;

auto wrongStateAfter(Text reason)
{
    return fail(ErrorCode::MeasurementState, {{"reason", std::move(reason)}});
}

/// What the second measurement says of its state, or some of its files do.
const MeasuredState& stateSaidOf(const Measurement& measurement)
{
    const MeasurementHeader& header = measurement.header;
    return header.compensation.kind == MeasuredState::Kind::NotSaid ? header.compensationOfSome
                                                                    : header.compensation;
}

/// Whether the second measurement was made with the table active.
Result<void> checkStateAfter(const Measurement& after, const ComparisonRequest& request)
{
    if (!request.tableCrc)
        return {};
    const MeasuredState& state = stateSaidOf(after);
    const std::string crc = crcText(*request.tableCrc);
    if (state.kind == MeasuredState::Kind::Off)
        return wrongStateAfter(AXISCOMP_TEXT("Error",
            "the second measurement was made with the compensation off; activate the table {crc} "
            "and measure again")
                                   .with("crc", crc));
    if (state.tableCrc && *state.tableCrc != *request.tableCrc)
        return wrongStateAfter(AXISCOMP_TEXT("Error",
            "the second measurement was made with the table {found} active, and the record has the "
            "table {crc}; activate that one and measure again, or take the record of {found}")
                                   .with("found", crcText(*state.tableCrc))
                                   .with("crc", crc));
    if (needsStatement(after, request) && !request.isTableStated)
        return wrongStateAfter(AXISCOMP_TEXT("Error",
            "the second measurement does not say which table was active while it was made; if it "
            "was the table {crc}, say it with --measured-with on")
                                   .with("crc", crc));
    return {};
}

/// The CRC of a table does not tell: twin machines may hold the same one.
Result<void> checkComparedDrives(
    const Measurement& before, const Measurement& after, const ComparisonRequest& request)
{
    const auto found = driveSerialOf(after.header);
    for (const auto& known : {driveSerialOf(before.header), request.driveSerial}) {
        if (!found || !known || *found == *known)
            continue;
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "the second measurement is of the drive with the serial number {found}, and "
                    "the first one or its table is of the one with {known}; measure that drive, "
                    "or, where it was replaced since, correct the line // drive: in the file of "
                    "the second")
                    .with("found", Verbatim{std::to_string(*found)})
                    .with("known", Verbatim{std::to_string(*known)})}});
    }
    return {};
}

/// Ascending: those with a value in use.
Numbers targetsInUse(const Measurement& measurement)
{
    std::vector<bool> isInUse(measurement.targets.size());
    for (const RunValue& value : measurement.values)
        if (value.isUsed)
            isInUse[value.target] = true;
    Numbers targets;
    for (std::size_t i = 0; i < isInUse.size(); ++i)
        if (isInUse[i])
            targets.push_back(measurement.targets[i]);
    return targets;
}

constexpr double rangeRounding = 1e-9; ///< of a length

/// Whether targets lie all round a rotary axis: they are over every position of it, wherever they
/// begin.
bool goRound(const Numbers& targets, bool isAngular)
{
    if (!isAngular || targets.size() < 2)
        return false;
    const auto gaps = static_cast<double>(targets.size() - 1);
    const double turn = (targets.back() - targets.front()) * (gaps + 1.0) / gaps;
    return turn >= 360.0 * (1.0 - rangeRounding);
}

/// How much of what the first measurement covers the second one covers, too.
enum class SecondRange { Whole, Less, Apart };

SecondRange secondRangeOf(const Numbers& before, const Numbers& after, bool isAngular)
{
    constexpr std::size_t fewestGaps = 4; // two targets are no measure of how near others may be
    if (before.empty() || after.empty() || goRound(after, isAngular))
        return SecondRange::Whole;
    const double length = before.back() - before.front();
    const double lengthAfter = after.back() - after.front();
    const double common =
        std::min(before.back(), after.back()) - std::max(before.front(), after.front());
    const double rounding = rangeRounding * std::max(length, lengthAfter);
    const bool isApart =
        common < -rounding || (common <= rounding && std::min(length, lengthAfter) > rounding);
    if (isApart && !goRound(before, isAngular))
        return SecondRange::Apart;
    const double gap = length / static_cast<double>(std::max(before.size() - 1, fewestGaps));
    const double lacking = length - std::max(common, 0.0);
    return lacking <= gap + rounding ? SecondRange::Whole : SecondRange::Less;
}

double largestDistance(const Numbers& targets)
{
    double largest = 0.0;
    for (std::size_t i = 1; i < targets.size(); ++i)
        largest = std::max(largest, targets[i] - targets[i - 1]);
    return largest;
}

Result<void> checkComparedRanges(const Measurement& before, const Measurement& after)
{
    const Numbers first = targetsInUse(before);
    const Numbers second = targetsInUse(after);
    if (secondRangeOf(first, second, after.isAngular) != SecondRange::Apart)
        return {};
    return fail(ErrorCode::InvalidArgument,
        {{"reason",
            AXISCOMP_TEXT("Error",
                "{ranges}: nothing of what was measured first is measured again; measure over the "
                "targets of the first measurement")
                .with("ranges",
                    rangesText({{first.front(), first.back()}, {second.front(), second.back()}},
                        after.isAngular))}});
}

Result<void> checkComparable(
    const Measurement& before, const Measurement& after, const ComparisonRequest& request)
{
    if (!before.hasTargets() || !after.hasTargets())
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error", "only measurements of runs over targets are compared")}});
    if (before.isAngular != after.isAngular
        || request.isAngular.value_or(after.isAngular) != after.isAngular)
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "one measurement is of lengths and the other of angles; they are not of the "
                    "same axis")}});
    if (areDifferentAxes(before.header.axis, after.header.axis))
        return fail(ErrorCode::InvalidArgument,
            {{"reason",
                AXISCOMP_TEXT("Error",
                    "the first measurement is of axis {before} and the second of axis {after}; "
                    "they are not of the same axis")
                    .with("before", before.header.axis)
                    .with("after", after.header.axis)}});
    AXISCOMP_CHECK(checkComparedDrives(before, after, request));
    return checkComparedRanges(before, after);
}

/// A remark on one of the two.
Text ofMeasurement(bool isAfter, Text remark)
{
    return (isAfter ? AXISCOMP_TEXT("Measurement", "second measurement: {remark}")
                    : AXISCOMP_TEXT("Measurement", "first measurement: {remark}"))
        .with("remark", std::move(remark));
}

std::vector<Text> statementsOf(const TextsOfFiles& said)
{
    std::vector<Text> texts;
    for (const auto& each : said)
        if (!each.said.empty())
            texts.emplace_back(Verbatim{each.said});
    return texts;
}

void warnOfOther(std::vector<JudgeWarning>& warnings, std::string_view name,
    const TextPattern& text, const TextsOfFiles& before, const TextsOfFiles& after)
{
    if (areAllDifferent(before, after))
        warnings.push_back(
            {name, text.with("before", statementsOf(before)).with("after", statementsOf(after))});
}

void warnOfLesserTravel(Comparison& comparison, const Measurement& before, const Measurement& after)
{
    comparison.lesserRange = lesserRange(before, after);
    if (comparison.lesserRange)
        comparison.warnings.push_back(
            {"LesserRange", lesserRangeText(*comparison.lesserRange, after.isAngular)});
    const auto wider = widerTargetsText(before, after);
    comparison.isWider = wider.has_value();
    if (wider)
        comparison.warnings.push_back({"WiderTargets", *wider});
}

void warnOfLaterMeasurement(
    Comparison& comparison, const std::string& date, const std::string& lastDate)
{
    if (isEarlier(date, lastDate))
        comparison.warnings.push_back({"EarlierMeasurement",
            AXISCOMP_TEXT("Measurement",
                "the second measurement is of {date}, and the record has one of {last} with the "
                "same table, which decides")
                .with("date", Verbatim{date})
                .with("last", Verbatim{lastDate})});
}

std::string dateOfMeasurement(const RecordedMeasurement& recorded)
{
    return recorded.files.empty() ? std::string() : recorded.files.front().measurement.header.date;
}

std::vector<RemainingError> remainingErrors(const Iso230Figures& figures)
{
    std::vector<RemainingError> errors;
    for (const TargetFigures& target : figures.targets)
        errors.push_back({target.position, meanInUse(target).value_or(0.0), standardError(target)});
    return errors;
}

/// Of what a figure is the range: M of the means of both directions, E of those of one.
const std::optional<double>& meanBy(const TargetFigures& target, Iso230Figure range)
{
    if (range == Iso230Figure::M)
        return target.mean;
    return range == Iso230Figure::EUp ? target.up.mean : target.down.mean;
}

/// 2 s / sqrt(2 n), of the pooled standard deviation, and of one direction 2 s / sqrt(n); 0 when
/// there is none.
double scatterOfMeans(const Iso230Figures& figures, Iso230Figure range)
{
    double squares = 0.0;
    double degrees = 0.0;
    std::size_t fewest = 0;
    const auto add = [&](const DirectionFigures& direction) {
        if (!direction.s)
            return;
        const double freedom = static_cast<double>(direction.n) - 1.0;
        squares += freedom * *direction.s * *direction.s;
        degrees += freedom;
        fewest = fewest == 0 ? direction.n : std::min(fewest, direction.n);
    };
    for (const TargetFigures& target : figures.targets) {
        if (range != Iso230Figure::EDown)
            add(target.up);
        if (range != Iso230Figure::EUp)
            add(target.down);
    }
    const double directions = range == Iso230Figure::M ? 2.0 : 1.0;
    return degrees > 0.0
        ? 2.0 * std::sqrt(squares / degrees / (directions * static_cast<double>(fewest)))
        : 0.0;
}

void centre(Numbers& values)
{
    double sum = 0.0;
    for (const double value : values)
        sum += value;
    for (double& value : values)
        value -= sum / static_cast<double>(values.size());
}

double product(const Numbers& a, const Numbers& b)
{
    double sum = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i)
        sum += a[i] * b[i];
    return sum;
}

/// How well one curve is a multiple of another; both about their means.
struct Likeness {
    double factor = 0.0; ///< least squares
    double correlation = 0.0; ///< -1 to 1
};

Likeness likenessOf(const Numbers& curve, const Numbers& pattern)
{
    const double size = product(pattern, pattern);
    const double own = product(curve, curve);
    if (!(size > 0.0 && own > 0.0))
        return {};
    const double common = product(curve, pattern);
    return {common / size, common / std::sqrt(size * own)};
}

/// What is left, and what it is compared with, at the targets that lie within the first ones.
struct ErrorCurves {
    Numbers residual;
    Numbers before;
    Numbers slope;
};

/// range: of what they are (meanBy).
ErrorCurves errorCurves(const Iso230Figures& before, const Iso230Figures& after, Iso230Figure range)
{
    Numbers knots;
    Numbers means;
    for (const TargetFigures& target : before.targets) {
        if (!meanBy(target, range))
            continue;
        knots.push_back(target.position);
        means.push_back(*meanBy(target, range));
    }
    ErrorCurves curves;
    const auto spline = interpolatingSpline({knots, means});
    if (!spline)
        return curves;
    const double step = 1e-4 * (knots.back() - knots.front());
    for (const TargetFigures& target : after.targets) {
        const double x = target.position;
        if (x < knots.front() || x > knots.back() || !meanBy(target, range))
            continue;
        const double low = std::max(x - step, knots.front());
        const double high = std::min(x + step, knots.back());
        curves.residual.push_back(*meanBy(target, range));
        curves.before.push_back(spline->at(x));
        curves.slope.push_back((spline->at(high) - spline->at(low)) / (high - low));
    }
    for (Numbers* curve : {&curves.residual, &curves.before, &curves.slope})
        if (!curve->empty())
            centre(*curve);
    return curves;
}

/// Two digits: what is said only points somewhere.
std::string about(double value)
{
    constexpr int digits = 2;
    return significantText(value, digits);
}

ComparisonHint scaleHint(double factor)
{
    constexpr double tolerance = 0.25;
    if (std::abs(factor - 2.0) <= tolerance)
        return {"Sign",
            AXISCOMP_TEXT("Measurement",
                "the error is {factor} times what it was before: the table has the wrong sign")
                .with("factor", about(factor))};
    if (std::abs(factor - 1.0) <= 0.1)
        return {"NotActive",
            AXISCOMP_TEXT("Measurement",
                "the error is the same as before: the compensation was not active, or another "
                "axis was measured")};
    return {"Scale",
        AXISCOMP_TEXT("Measurement",
            "what is left is {factor} times the error before: the table adds {share} times what it "
            "should; look at the units of measurement and table")
            .with("factor", about(factor))
            .with("share", about(1.0 - factor))};
}

std::vector<ComparisonHint> hintsOf(const ErrorCurves& curves, bool isAngular)
{
    constexpr std::size_t fewestTargets = 4;
    constexpr double alike = 0.9;
    const ComparisonHint other{"OtherState",
        AXISCOMP_TEXT("Measurement",
            "what is left resembles neither the error before nor its slope: the machine was in "
            "another state, such as another temperature or load, or it is another axis")};
    if (curves.residual.size() < fewestTargets)
        return {other};
    const Likeness error = likenessOf(curves.residual, curves.before);
    const Likeness slope = likenessOf(curves.residual, curves.slope);
    if (std::max(std::abs(error.correlation), std::abs(slope.correlation)) < alike)
        return {other};
    if (std::abs(error.correlation) >= std::abs(slope.correlation))
        return {scaleHint(error.factor)};
    return {{"Shifted",
        AXISCOMP_TEXT("Measurement",
            "what is left follows the slope of the error before: the table is shifted by about "
            "{shift} against the axis; look at the home position and the source of the table")
            .with("shift", Quantity{about(slope.factor), isAngular ? "deg" : "mm"})}};
}

/// What was promised of M, and what came of it.
struct Promise {
    std::optional<double> before = {};
    double after = 0.0;
    double largest = 0.0; ///< that counts as predicted
    double unknown = 0.0; ///< what cannot be told of it: max(U, 2 s / sqrt(2 n))
};

/// Nothing: that is open.
std::optional<bool> isKept(const Promise& promise, const std::vector<ComparisonHint>& hints)
{
    if (isAbove(promise.after, promise.largest))
        return false;
    if (!promise.before || isAbove(*promise.before, promise.largest + promise.unknown))
        return true;
    // A table that does nothing is within such a limit, too: only what has become of the error
    // tells. Of an axis that has none to speak of nobody can see that it became better.
    const double before = *promise.before;
    if (!isAbove(before, promise.unknown) && !isAbove(promise.after, before + promise.unknown))
        return true;
    const bool isSame = std::ranges::count(hints, "NotActive", &ComparisonHint::name) > 0;
    if (isSame || !isAbove(before, promise.after))
        return false;
    if (isAbove(before, promise.after + promise.unknown))
        return true;
    return std::nullopt;
}

std::vector<ComparisonHint> hintsBy(
    const Comparison& comparison, Iso230Figure range, bool isAngular)
{
    return hintsOf(errorCurves(comparison.before, comparison.after, range), isAngular);
}

/// Nothing was promised: what has not become smaller is looked at.
std::vector<ComparisonHint> hintsWithoutPromise(const Comparison& comparison, bool isAngular)
{
    for (const Iso230Figure range : {Iso230Figure::M, Iso230Figure::EUp, Iso230Figure::EDown}) {
        const auto& before = comparison.before[range].value;
        const auto& after = comparison.after[range].value;
        if (!before || !after)
            continue;
        return isAbove(*before, *after) ? std::vector<ComparisonHint>()
                                        : hintsBy(comparison, range, isAngular);
    }
    return {};
}

/// Whether the machine became as good as was promised, or better at all, and if not, what to look
/// at.
void judgePrediction(Comparison& comparison, const ComparisonRequest& request, bool isAngular)
{
    constexpr double allowance = 1.2;
    comparison.promised = figureStandingFor(Iso230Figure::M, comparison.before);
    const auto& before = comparison.before[comparison.promised].value;
    const auto& after = comparison.after[comparison.promised].value;
    if (!request.heldOut || !after) {
        comparison.hints = hintsWithoutPromise(comparison, isAngular);
        return;
    }
    auto hints = hintsBy(comparison, comparison.promised, isAngular);
    const double unknown = std::max(
        request.uncertainty.value_or(0.0), scatterOfMeans(comparison.after, comparison.promised));
    const double largest = allowance * request.heldOut->range + unknown;
    const auto kept = isKept({before, *after, largest, unknown}, hints);
    comparison.largestAsPredicted = largest;
    comparison.isNoBetter = kept != true && !isAbove(*after, largest);
    // What was promised is of all of the travel: over less of it, or at fewer of its targets, M is
    // smaller by itself.
    if (kept != true || !(comparison.lesserRange || comparison.isWider))
        comparison.isAsPredicted = kept;
    if (kept != true)
        comparison.hints = std::move(hints);
}

/// Nothing: every value is used.
std::optional<Iso230Figures> figuresOfAll(const Measurement& measurement, bool isByTemperature)
{
    if (measurement.excludedCount() == 0)
        return std::nullopt;
    return figuresOfFit(withAllValues(measurement), isByTemperature);
}

void judgeAllValues(Comparison& comparison, const Measurement& before, const Measurement& after,
    const ComparisonRequest& request)
{
    comparison.beforeOfAllValues = figuresOfAll(before, request.isByTemperature);
    comparison.afterOfAllValues = figuresOfAll(after, request.isByTemperature);
    if (comparison.beforeOfAllValues)
        comparison.warnings.push_back(
            {"ValuesExcluded", ofMeasurement(false, excludedText(before.excludedCount()))});
    if (!comparison.afterOfAllValues)
        return;
    comparison.warnings.push_back(
        {"ValuesExcluded", ofMeasurement(true, excludedText(after.excludedCount()))});
    comparison.verdictsOfAllValues =
        verdicts(*comparison.afterOfAllValues, request.tolerances, request.uncertainty);
    std::ranges::move(
        otherVerdicts(comparison.verdicts, comparison.verdictsOfAllValues, after.isAngular),
        std::back_inserter(comparison.warnings));
}

bool isByTemperature(const CalibrationRecord& record)
{
    return record.fit && record.fit->settings.isByTemperature;
}

} // namespace

std::vector<JudgeWarning> machineWarnings(const Measurement* before, const Measurement* after)
{
    std::vector<JudgeWarning> warnings;
    for (const bool isAfter : {false, true})
        if (const Measurement* one = isAfter ? after : before)
            for (JudgeWarning& warning : otherMachines(*one))
                warnings.push_back({warning.name, ofMeasurement(isAfter, std::move(warning.text))});
    if (!before || !after)
        return warnings;
    using Header = MeasurementHeader;
    warnOfOther(warnings, "OtherMachine",
        AXISCOMP_TEXT("Measurement",
            "the first measurement is of the machine {before}, the second of {after}"),
        saidByFiles(*before, &Header::machine), saidByFiles(*after, &Header::machine));
    warnOfOther(warnings, "OtherSerial",
        AXISCOMP_TEXT("Measurement",
            "the first measurement has the serial number {before}, the second {after}"),
        saidByFiles(*before, &Header::serial), saidByFiles(*after, &Header::serial));
    return warnings;
}

std::optional<TwoRanges> lesserRange(const Measurement& before, const Measurement& after)
{
    const Numbers first = targetsInUse(before);
    const Numbers second = targetsInUse(after);
    if (secondRangeOf(first, second, after.isAngular) == SecondRange::Whole)
        return std::nullopt;
    return TwoRanges{{first.front(), first.back()}, {second.front(), second.back()}};
}

Text rangesText(const TwoRanges& ranges, bool isAngular)
{
    const auto number = [](double position) { return Quantity{roundedText(position)}; };
    const auto withUnit = [isAngular](double position) {
        return Quantity{roundedText(position), isAngular ? "deg" : "mm"};
    };
    return AXISCOMP_TEXT("Measurement",
        "first measurement from {beforeFirst} to {beforeLast}, second one from {afterFirst} to "
        "{afterLast}")
        .with("beforeFirst", number(ranges.before.first))
        .with("beforeLast", withUnit(ranges.before.last))
        .with("afterFirst", number(ranges.after.first))
        .with("afterLast", withUnit(ranges.after.last));
}

Text lesserRangeText(const TwoRanges& ranges, bool isAngular)
{
    return AXISCOMP_TEXT("Measurement",
        "{ranges}: over a shorter travel the figures are smaller whatever the compensation does, "
        "and nothing is proved for the rest")
        .with("ranges", rangesText(ranges, isAngular));
}

std::optional<Text> widerTargetsText(const Measurement& before, const Measurement& after)
{
    constexpr double wide = 2.0 * (1.0 + rangeRounding);
    const double first = largestDistance(targetsInUse(before));
    const double second = largestDistance(targetsInUse(after));
    if (first == 0.0 || second <= wide * first)
        return std::nullopt;
    const std::string_view unit = after.isAngular ? "deg" : "mm";
    const auto shown = [unit](double distance) {
        return Quantity{roundedText(distance), std::string(unit)};
    };
    return AXISCOMP_TEXT("Measurement",
        "the targets of the second measurement are up to {second} apart, those of the first one up "
        "to {first}: what lies between them is not measured again")
        .with("second", shown(second))
        .with("first", shown(first));
}

std::optional<double> changeOf(
    const std::optional<double>& before, const std::optional<double>& after)
{
    return before && after ? std::optional(*after - *before) : std::nullopt;
}

Iso230Figures figuresBy(const CalibrationRecord& record, const Measurement& measurement)
{
    return figuresOfFit(measurement, isByTemperature(record));
}

bool needsStatement(const Measurement& after, const ComparisonRequest& request)
{
    return request.tableCrc && stateSaidOf(after).kind != MeasuredState::Kind::Off
        && !after.header.compensation.tableCrc;
}

CorrectedAlike areCorrectedAlike(const CorrectedSide& before, const CorrectedSide& after)
{
    const auto isAt20 = [](const CorrectedSide& side) {
        return side.measurement.header.corrected == MeasurementHeader::Corrected::To20Celsius;
    };
    if ((isAt20(before) && !isAt20(after)) || (before.isForDeadPath && !after.isForDeadPath))
        return CorrectedAlike::AfterIsNot;
    if (isAt20(after) != isAt20(before) || after.isForDeadPath != before.isForDeadPath)
        return CorrectedAlike::BeforeIsNot;
    return CorrectedAlike::Yes;
}

bool Comparison::isWithinTolerances() const
{
    return std::ranges::all_of(
        verdicts, [](const Verdict& verdict) { return verdict.result == VerdictResult::Passed; });
}

bool Comparison::hasExcluded() const
{
    return beforeOfAllValues || afterOfAllValues;
}

const Iso230Figures& Comparison::ofAllValues(bool isAfter) const
{
    if (isAfter)
        return afterOfAllValues ? *afterOfAllValues : after;
    return beforeOfAllValues ? *beforeOfAllValues : before;
}

ComparisonRequest comparisonRequest(const CalibrationRecord& record)
{
    ComparisonRequest request;
    if (record.before && !record.before->files.empty())
        request.isAngular = record.before->files.front().measurement.isAngular;
    if (record.prediction) {
        request.predicted = record.prediction->predicted;
        request.heldOut = record.prediction->heldOut;
    }
    if (record.drive)
        request.driveSerial = record.drive->serialNumber;
    if (!record.tables.empty())
        request.tableCrc = record.tables.front().crc;
    if (record.write)
        request.tableCrc = record.write->crc;
    RecordedJudging judging = judgingOf(record);
    request.isByTemperature = isByTemperature(record);
    if (const RecordedAfter* const last = lastAfter(record))
        request.lastDate = dateOfMeasurement(last->measurement);
    request.tolerances = std::move(judging.tolerances);
    request.uncertainty = judging.uncertainty;
    return request;
}

Result<Comparison> compareMeasurements(
    const Measurement& before, const Measurement& after, const ComparisonRequest& request)
{
    AXISCOMP_CHECK(checkComparable(before, after, request));
    AXISCOMP_CHECK(checkStateAfter(after, request));
    Comparison comparison{figuresOfFit(before, request.isByTemperature), request.predicted,
        request.heldOut, figuresOfFit(after, request.isByTemperature), {}, {}};
    comparison.isByTemperature = request.isByTemperature;
    comparison.uncertainty = request.uncertainty;
    comparison.errorBefore = remainingErrors(comparison.before);
    comparison.residual = remainingErrors(comparison.after);
    warnOfLesserTravel(comparison, before, after);
    judgePrediction(comparison, request, after.isAngular);
    comparison.verdicts = verdicts(comparison.after, request.tolerances, request.uncertainty);
    judgeAllValues(comparison, before, after, request);
    std::ranges::move(machineWarnings(&before, &after), std::back_inserter(comparison.warnings));
    warnOfLaterMeasurement(comparison, after.header.date, request.lastDate);
    return comparison;
}

void keepAfter(CalibrationRecord& record, RecordedMeasurement after, const Comparison& comparison)
{
    RecordedAfter recorded;
    recorded.measurement = std::move(after);
    recorded.figures = figureValues(comparison.after);
    recorded.isAsPredicted = comparison.isAsPredicted;
    recorded.tableCrc = comparisonRequest(record).tableCrc;
    const auto isLater = [&recorded](const RecordedAfter& other) {
        return other.tableCrc == recorded.tableCrc
            && isEarlier(
                dateOfMeasurement(recorded.measurement), dateOfMeasurement(other.measurement));
    };
    auto place = record.after.end();
    while (place != record.after.begin() && isLater(*std::prev(place)))
        --place;
    const bool isLast = place == record.after.end();
    record.after.insert(place, std::move(recorded));
    if (!isLast)
        return;
    record.verdict = RecordedVerdict{comparison.verdicts};
    // Without a verdict that has it, "as predicted" would rest on what nobody can look up.
    RecordedJudging judging = judgingOf(record);
    if (judging.uncertainty == comparison.uncertainty)
        return;
    judging.uncertainty = comparison.uncertainty;
    record.judging = std::move(judging);
}

} // namespace axiscomp
