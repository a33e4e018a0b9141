// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fine_quantity.h"
#include "core/metrology/fit/fit_parts.h"
#include "core/table/large_correction.h"
#include "core/table/position_unit.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace axiscomp {

namespace {

/// The remarks of one report.
class Remarks {
public:
    Remarks(const FitInput& input, FitReport& report)
        : m_isAngular(input.measurement.isAngular)
        , m_report(report)
    {
    }

    void say(std::string_view name, Text text) { addRemark(m_report, name, std::move(text)); }
    void warn(std::string_view name, Text text)
    {
        addRemark(m_report, name, std::move(text), true);
    }
    [[nodiscard]] Quantity fine(double value) const { return fineQuantity(value, m_isAngular); }
    [[nodiscard]] Quantity place(double position) const { return placeOf(position, m_isAngular); }
    [[nodiscard]] bool isAngular() const { return m_isAngular; }

private:
    bool m_isAngular;
    FitReport& m_report;
};

void remarkOfZero(const FittedTable& made, Remarks& remarks)
{
    if (made.direction == Direction::Negative)
        return; // the same is taken out of both directions
    if (made.removedSlope != 0.0)
        remarks.say("SlopeRemoved",
            AXISCOMP_TEXT("Measurement", "a slope of {slope} over {length} was taken out")
                .with("slope", remarks.fine(made.removedSlope * 1000.0))
                .with("length", remarks.place(1000.0)));
    if (made.removedConstant != 0.0 && made.direction == Direction::Positive)
        remarks.say("ZeroMoved",
            AXISCOMP_TEXT("Measurement",
                "{constant} was taken out of all values of both tables for their zero")
                .with("constant", remarks.fine(made.removedConstant)));
    else if (made.removedConstant != 0.0)
        remarks.say("ZeroMoved",
            AXISCOMP_TEXT(
                "Measurement", "{constant} was taken out of all values of {table} for its zero")
                .with("constant", remarks.fine(made.removedConstant))
                .with("table", made.table.name));
}

Quantity perSecond(Quantity quantity)
{
    quantity.unit += "/s";
    return quantity;
}

void remarkOfSteps(const FitInput& input, const FittedTable& made, Remarks& remarks)
{
    const CompensationTable& table = made.table;
    const SteepestStep steepest = steepestStep(table);
    const GridAxis& axis = table.grid.axes[steepest.dimension];
    const double from = positionOf(table.grid, steepest.from)[steepest.dimension];
    const auto place = [&](double position) {
        return isTemperatureUnit(axis.unit) ? Quantity{roundedText(position), axis.unit}
                                            : remarks.place(position);
    };
    remarks.say("LargestStep",
        AXISCOMP_TEXT("Measurement",
            "the steepest part of {table} is between {from} and {to}: {step}, {slope} for each "
            "{one}")
            .with("table", table.name)
            .with("from", place(from))
            .with("to", place(from + axis.distance))
            .with("step", remarks.fine(steepest.slope * axis.distance))
            .with("slope", remarks.fine(steepest.slope))
            .with("one", place(1.0)));
    if (input.settings.speed && made.density)
        remarks.say("VelocityStep",
            AXISCOMP_TEXT("Measurement",
                "at {speed} the velocity jumps by at most {step} at a point of the table")
                .with("speed", perSecond(remarks.place(*input.settings.speed)))
                .with("step",
                    perSecond(
                        remarks.fine(made.density->largestSlopeChange * *input.settings.speed))));
}

/// Of what float32 changes two digits tell enough.
void remarkOfRounding(const FittedTable& made, Remarks& remarks)
{
    const double factor = remarks.isAngular() ? 3600.0 : 1000.0;
    std::array<char, 32> buffer{};
    const auto end = std::to_chars(buffer.data(), buffer.data() + buffer.size(),
        made.rounding * factor, std::chars_format::general, 2);
    remarks.say("Rounding",
        AXISCOMP_TEXT("Measurement",
            "a drive holds numbers with 24 bits, which changes a value of {table} by at most "
            "{rounding}")
            .with("table", made.table.name)
            .with("rounding",
                Quantity{
                    std::string(buffer.data(), end.ptr), remarks.isAngular() ? "arcsec" : "um"}));
}

void remarkOfNodes(const FittedTable& made, Remarks& remarks)
{
    if (made.filledNodes > 0)
        remarks.warn("NodesFilled",
            AXISCOMP_COUNTED("Measurement",
                "{count} points of {table} have nothing measured beside them and were filled",
                "1 point of {table} has nothing measured beside it and was filled")
                .with("count", made.filledNodes)
                .with("table", made.table.name));
}

/// The longest way over a turn without a target, where it is longer than others are. Held out does
/// not show it: every target has its neighbours.
void remarkOfGap(const FitInput& input, const FittedTable& made, Remarks& remarks)
{
    constexpr double mostOfMedian = 2.5; // ours
    if (!input.settings.turn || made.means.size() < 2)
        return;
    const double turn = *input.settings.turn;
    std::vector<double> places;
    for (const FitKnot& knot : made.means)
        places.push_back(knot.target - turn * std::floor(knot.target / turn));
    std::ranges::sort(places);
    places.push_back(places.front() + turn);
    std::vector<double> gaps;
    std::size_t widest = 0;
    for (std::size_t i = 0; i + 1 < places.size(); ++i) {
        gaps.push_back(places[i + 1] - places[i]);
        if (gaps[i] > gaps[widest])
            widest = i;
    }
    const double largest = gaps[widest];
    const auto middle = gaps.begin() + static_cast<std::ptrdiff_t>(gaps.size() / 2);
    std::ranges::nth_element(gaps, middle);
    if (largest > mostOfMedian * *middle)
        remarks.warn("TurnNotMeasured",
            AXISCOMP_TEXT("Measurement",
                "from {from} to {to} nothing was measured, {gap} of a turn of {turn}: there the "
                "table is guessed, and no figure knows of it; measure the whole turn")
                .with("from", remarks.place(places[widest]))
                .with("to", remarks.place(places[widest + 1]))
                .with("gap", remarks.place(largest))
                .with("turn", remarks.place(turn)));
}

void remarkOfMerge(const FitMerge& merge, Remarks& remarks)
{
    std::vector<Text> places;
    for (const double place : merge.largestAt)
        places.push_back(Text(Verbatim{roundedText(place)}));
    remarks.say("Merged",
        AXISCOMP_TEXT("Measurement",
            "merged onto {name} with gain {gain}: a value changes by at most {change}, at {place}")
            .with("name", merge.onto)
            .with("gain", Quantity{roundedText(merge.gain), {}})
            .with("change", remarks.fine(merge.largestChange))
            .with("place", std::move(places)));
    constexpr double least = 1e-6; // mm or deg; below it float32 alone makes a difference
    if (merge.lostDetail > least)
        remarks.warn("OldDetailLost",
            AXISCOMP_TEXT("Measurement",
                "the new table is coarser than {name}: up to {lost} of what that has between the "
                "new points is lost; take more points")
                .with("name", merge.onto)
                .with("lost", remarks.fine(merge.lostDetail)));
    if (merge.lostRange > least)
        remarks.warn("OldRangeLost",
            AXISCOMP_TEXT("Measurement",
                "the new table is shorter than {name}: up to {lost} of what that has beyond the "
                "ends of the new one is lost; ask for no grid, which keeps that of {name}, or for "
                "one as long, or measure the whole of it")
                .with("name", merge.onto)
                .with("lost", remarks.fine(merge.lostRange)));
}

/// A figure that says best how good the axis is: A, else E, else M, or what stands for it.
std::optional<Iso230Figure> leadingFigure(const Iso230Figures& figures)
{
    for (const Iso230Figure figure : {Iso230Figure::A, Iso230Figure::E, Iso230Figure::M})
        if (const auto defined = figureStandingFor(figure, figures); figures[defined].value)
            return defined;
    return std::nullopt;
}

void remarkOfImprovement(const FitReport& report, Remarks& remarks)
{
    constexpr double least = 0.2;
    const auto figure = leadingFigure(*report.before);
    if (!figure || !(*report.predicted)[*figure].value)
        return;
    const double before = *(*report.before)[*figure].value;
    const double after = *(*report.predicted)[*figure].value;
    if (before - after < least * before)
        remarks.warn("LittleImprovement",
            AXISCOMP_TEXT("Measurement",
                "the table improves little: {figure} from {before} to {after}, less than a fifth")
                .with("figure", figureText(*figure))
                .with("before", remarks.fine(before))
                .with("after", remarks.fine(after)));
}

void remarkOfHeldOut(const FitReport& report, Remarks& remarks)
{
    if (!report.heldOut)
        return;
    // What a gain, the other direction or a slope leaves is no matter of the targets.
    const double unknown = report.heldOut->unknownRange;
    const double heldOut = report.heldOut->range;
    const Iso230Figure range = figureStandingFor(Iso230Figure::M, *report.before);
    const auto before = (*report.before)[range].value;
    const auto repeatability =
        (*report.before)[figureStandingFor(Iso230Figure::R, *report.before)].value;
    const auto predicted = (*report.predicted)[range].value;
    const bool isAboveHalf = before && unknown > 0.5 * *before;
    constexpr double least = 0.01; // of M: without any repeatability rounding is above its half
    const bool isRounding = before && unknown <= least * *before;
    const bool isAbovePrediction = !isRounding && repeatability && predicted
        && unknown > 0.5 * *repeatability && unknown > 2.0 * *predicted;
    if (!isAboveHalf && !isAbovePrediction)
        return;
    Text text = AXISCOMP_TEXT("Measurement",
        "between the targets the error is not known well enough: foretold without each target, M "
        "is {heldOut}; measure at more targets");
    if (before)
        text = (range == Iso230Figure::M
                ? AXISCOMP_TEXT("Measurement",
                    "between the targets the error is not known well enough: foretold without each "
                    "target, M is {heldOut}, before it was {before}; measure at more targets")
                : AXISCOMP_TEXT("Measurement",
                    "between the targets the error is not known well enough: foretold without each "
                    "target, E of the direction that was measured is {heldOut}, before it was "
                    "{before}; measure at more targets"))
                   .with("before", remarks.fine(*before));
    remarks.warn("BetweenTargets", std::move(text).with("heldOut", remarks.fine(heldOut)));
}

void remarkOfReversal(const FitInput& input, const TableFit& fit, Remarks& remarks)
{
    if (!fit.remainingReversal)
        return;
    if (input.settings.direction == FitDirection::Both)
        remarks.say("ReversalInTables",
            AXISCOMP_TEXT("Measurement",
                "there is a table for each direction, and the reversal of up to {reversal} is in "
                "them: switch off the controller's own backlash compensation")
                .with("reversal", remarks.fine(2.0 * *fit.remainingReversal)));
    else if (fit.isMostlyReversal && input.settings.direction == FitDirection::Mean)
        remarks.warn("MostlyReversal",
            AXISCOMP_TEXT("Measurement",
                "most of this error is reversal, which no table removes: up to {reversal} remains "
                "in each direction")
                .with("reversal", remarks.fine(*fit.remainingReversal)));
    else if (fit.isMostlyReversal)
        remarks.warn("MostlyReversal",
            AXISCOMP_TEXT("Measurement",
                "most of this error is reversal, which no table removes: the table is for one "
                "direction, and up to {reversal} remains in the other")
                .with("reversal", remarks.fine(2.0 * *fit.remainingReversal)));
    else if (input.settings.direction == FitDirection::Mean)
        remarks.say("ReversalRemains",
            AXISCOMP_TEXT("Measurement",
                "the table is for both directions: up to {reversal} of the reversal remains in "
                "each")
                .with("reversal", remarks.fine(*fit.remainingReversal)));
    else
        remarks.say("ReversalRemains",
            AXISCOMP_TEXT("Measurement",
                "the table is for one direction: in the other up to {reversal} of reversal remains")
                .with("reversal", remarks.fine(2.0 * *fit.remainingReversal)));
}

void remarkOfPeriods(const FitInput& input, Remarks& remarks)
{
    const std::vector<double> targets = usedTargets(input.measurement);
    for (const double period : input.settings.periods.periods)
        remarks.say("TargetsPerPeriod",
            AXISCOMP_TEXT("Measurement", "{count} targets lie in {turns} periods of {period}")
                .with("count", targets.size())
                .with("turns",
                    Quantity{
                        fineQuantity((targets.back() - targets.front()) / period / 1000.0, false)
                            .digits,
                        {}})
                .with("period", remarks.place(period)));
}

void remarkOfOutliers(std::size_t count, Remarks& remarks)
{
    if (count > 0)
        remarks.warn("OutliersLeftIn",
            AXISCOMP_COUNTED("Measurement",
                "{count} values do not fit the others and are in the table; judging names them, "
                "and they can be excluded",
                "1 value does not fit the others and is in the table; judging names it, and it can "
                "be excluded")
                .with("count", count));
}

void remarkOfHome(const FitInput& input, const CompensationTable& table, Remarks& remarks)
{
    if (!input.settings.home)
        return;
    const Lookup lookup(table, input.outside());
    remarks.say("ValueAtHome",
        AXISCOMP_TEXT("Measurement", "{table} adds {value} at the home position {home}")
            .with("table", table.name)
            .with("home", remarks.place(*input.settings.home))
            .with("value", remarks.fine(lookup.at(*input.settings.home))));
}

/// Targets where the drive holds the value at the end of the table.
void remarkOfTargetsOutside(const FitInput& input, const CompensationTable& table, Remarks& remarks)
{
    const GridAxis& axis = table.grid.axes.front();
    const std::vector<double> targets = usedTargets(input.measurement);
    constexpr double rounding = 1e-6; // of the distance of two points
    const double before = axis.start - targets.front();
    const double behind = targets.back() - axis.last();
    if (std::max(before, behind) <= rounding * axis.distance)
        return;
    remarks.warn("TargetsOutside",
        AXISCOMP_TEXT("Measurement",
            "{table} goes from {from} to {to}, the targets from {first} to {last}: beyond its ends "
            "the drive holds their values; take the number of points, or a distance that divides "
            "the range of the targets")
            .with("table", table.name)
            .with("from", remarks.place(axis.start))
            .with("to", remarks.place(axis.last()))
            .with("first", remarks.place(targets.front()))
            .with("last", remarks.place(targets.back())));
}

/// The count of the axis is not known but by its targets.
void remarkOfCount(const FitInput& input, const GridAxis& axis, Remarks& remarks)
{
    const double turn = *input.settings.turn;
    const double first = usedTargets(input.measurement).front();
    const double halves = 2.0 * axis.start / turn;
    constexpr double rounding = 1e-9;
    const bool isUsual = std::abs(halves - std::round(halves)) <= rounding;
    if (isUsual && std::abs(first - axis.start) <= rounding * turn)
        return;
    remarks.warn("CountOfTurn",
        AXISCOMP_TEXT("Measurement",
            "the first target is {first}; the table is for an axis that counts from {from} to "
            "{to}: where it counts otherwise, the drive holds the values at the ends")
            .with("first", remarks.place(first))
            .with("from", remarks.place(axis.start))
            .with("to", remarks.place(axis.last())));
}

void remarkOfTurn(const FitInput& input, const CompensationTable& table, Remarks& remarks)
{
    if (!input.settings.turn)
        return;
    const GridAxis& axis = table.grid.axes.front();
    const TableStatistics values = statistics(table);
    constexpr double rounding = 1e-6; // of the largest value; that of float32 is a tenth of it
    const double least = rounding * std::max(std::abs(values.minimum), std::abs(values.maximum));
    double jump =
        static_cast<double>(table.values.back()) - static_cast<double>(table.values.front());
    if (std::abs(jump) <= least)
        jump = 0.0;
    Text ends = AXISCOMP_TEXT("Measurement",
        "over a turn, from {from} to {to}, {table} ends {jump} above where it begins")
                    .with("table", table.name)
                    .with("from", remarks.place(axis.start))
                    .with("to", remarks.place(axis.last()))
                    .with("jump", remarks.fine(jump));
    if (jump != 0.0)
        remarks.warn("EndsOfTurn", std::move(ends));
    else
        remarks.say("EndsOfTurn", std::move(ends));
}

void remarkOfDensity(const FitInput& input, const FittedTable& made, Remarks& remarks)
{
    if (input.settings.method != FitMethod::Linear && made.density)
        remarks.say("Density",
            AXISCOMP_TEXT("Measurement",
                "{count} points of {table} with straight lines between them are at most {distance} "
                "off the curve, at {place}")
                .with("table", made.table.name)
                .with("count", made.density->points)
                .with("distance", remarks.fine(made.density->largestDistance))
                .with("place", remarks.place(made.density->distanceAt)));
}

} // namespace

void addTableRemarks(const FitInput& input, FitReport& report)
{
    Remarks remarks(input, report);
    for (const FittedTable& made : report.tables) {
        remarkOfZero(made, remarks);
        remarkOfSteps(input, made, remarks);
        remarkOfRounding(made, remarks);
        remarkOfNodes(made, remarks);
    }
    remarkOfGap(input, report.tables.front(), remarks); // tables of two directions have its targets
    if (report.merge)
        remarkOfMerge(*report.merge, remarks);
}

void addRunsRemarks(
    const FitInput& input, std::size_t outliers, const TableFit& fit, FitReport& report)
{
    Remarks remarks(input, report);
    remarkOfHeldOut(report, remarks);
    remarkOfImprovement(report, remarks);
    remarkOfReversal(input, fit, remarks);
    remarkOfOutliers(outliers, remarks);
    if (input.settings.turn)
        remarkOfCount(input, report.tables.front().table.grid.axes.front(), remarks);
    else
        remarkOfTargetsOutside(input, report.tables.front().table, remarks);
    for (const FittedTable& made : report.tables)
        remarkOfDensity(input, made, remarks);
    remarkOfPeriods(input, remarks);
}

void addStateRemarks(const FitInput& input, const Judgement& judgement,
    std::span<const CompensationTable> tables, FitReport& report)
{
    Remarks remarks(input, report);
    for (const JudgeWarning& warning : judgement.warnings)
        remarks.warn(warning.name, warning.text);
    for (const CompensationTable& table : tables) {
        remarkOfHome(input, table, remarks);
        remarkOfTurn(input, table, remarks);
    }
}

std::size_t outlierCount(const Judgement& judgement)
{
    return judgement.outliers.up.flagged.size() + judgement.outliers.down.flagged.size();
}

Result<void> addHeldOut(Result<HeldOut> heldOut, FitReport& report)
{
    if (heldOut) {
        report.heldOut = *std::move(heldOut);
        return {};
    }
    if (heldOut.error().code == ErrorCode::Cancelled)
        return fail(heldOut.error());
    addRemark(report, "HeldOutUnknown",
        AXISCOMP_TEXT("Measurement",
            "how well the error between the targets is known cannot be told: {reason}")
            .with("reason", textOf(heldOut.error())),
        true);
    return {};
}

} // namespace axiscomp
