// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fine_quantity.h"
#include "core/metrology/fit/fit_parts.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <set>

namespace axiscomp {

namespace {

constexpr const char* celsius = "degC";
constexpr double stateGap = 0.5; // K; runs that lie closer are of one thermal state (ours)
constexpr double smallestSpan = 1.0; // K
constexpr double spanPerScatter = 5.0;
constexpr std::size_t mostStatesOnALine = 4;

Quantity kelvin(double difference)
{
    return {roundedText(std::round(difference * 1e3) / 1e3), "K"};
}

Quantity degrees(double temperature)
{
    return {roundedText(std::round(temperature * 1e3) / 1e3), celsius};
}

/// The runs that were measured at about one temperature.
struct ThermalState {
    double temperature = 0.0; ///< mean of its values
    double squares = 0.0; ///< of the differences from it
    std::set<std::pair<Approach, int>> runs;
    Measurement measurement; ///< with the values of the other runs left out
    double weight = 0.0; ///< number of its values

    [[nodiscard]] double firstTarget() const { return targetOf(true); }
    [[nodiscard]] double lastTarget() const { return targetOf(false); }

private:
    [[nodiscard]] double targetOf(bool isFirst) const
    {
        std::optional<double> found;
        for (const RunValue& value : measurement.values) {
            const double target = measurement.targets[value.target];
            if (value.isUsed && (!found || (isFirst ? target < *found : target > *found)))
                found = target;
        }
        return found.value_or(0.0);
    }
};

using RunNumber = std::pair<Approach, int>;

/// The mean temperature of each run, from the coldest.
std::vector<std::pair<double, RunNumber>> temperaturesOfRuns(const Measurement& measurement)
{
    std::map<RunNumber, std::pair<double, double>> sums;
    for (const RunValue& value : measurement.values) {
        if (!value.isUsed)
            continue;
        auto& [sum, count] = sums[{value.direction, value.run}];
        sum += *value.temperature;
        count += 1.0;
    }
    std::vector<std::pair<double, RunNumber>> runs;
    for (const auto& [run, sum] : sums)
        runs.emplace_back(sum.first / sum.second, run);
    std::ranges::sort(runs);
    return runs;
}

ThermalState stateOf(const Measurement& measurement, const std::set<RunNumber>& runs)
{
    ThermalState state;
    state.runs = runs;
    state.measurement = measurement;
    double sum = 0.0;
    for (RunValue& value : state.measurement.values) {
        value.isUsed = value.isUsed && runs.contains({value.direction, value.run});
        if (value.isUsed) {
            sum += *value.temperature;
            state.weight += 1.0;
        }
    }
    state.temperature = sum / state.weight;
    for (const RunValue& value : state.measurement.values)
        if (value.isUsed)
            state.squares += std::pow(*value.temperature - state.temperature, 2);
    return state;
}

std::vector<ThermalState> statesOf(const Measurement& measurement)
{
    std::vector<ThermalState> states;
    std::set<RunNumber> together;
    std::optional<double> before;
    for (const auto& [temperature, run] : temperaturesOfRuns(measurement)) {
        if (before && temperature - *before >= stateGap) {
            states.push_back(stateOf(measurement, together));
            together.clear();
        }
        together.insert(run);
        before = temperature;
    }
    states.push_back(stateOf(measurement, together));
    return states;
}

Result<void> checkSpan(const std::vector<ThermalState>& states)
{
    const double span = states.back().temperature - states.front().temperature;
    const auto needed = [](const TextPattern& pattern) {
        return pattern.with("least", kelvin(smallestSpan)).with("gap", kelvin(stateGap));
    };
    if (states.size() < 2)
        return badFit(needed(AXISCOMP_TEXT("Error",
            "all runs were measured in one thermal state; a table over temperature needs at least "
            "two, {least} apart (runs within {gap} are one state)")));
    if (span < smallestSpan)
        return badFit(needed(
            AXISCOMP_TEXT("Error",
                "the runs were measured in {count} thermal states that span {span}; a table over "
                "temperature needs at least two, {least} apart (runs within {gap} are one state)"))
                          .with("count", states.size())
                          .with("span", kelvin(span)));
    double squares = 0.0;
    double weight = 0.0;
    for (const ThermalState& state : states) {
        squares += state.squares;
        weight += state.weight;
    }
    const double scatter = std::sqrt(squares / (weight - static_cast<double>(states.size())));
    if (span < spanPerScatter * scatter)
        return badFit(AXISCOMP_TEXT("Error",
            "the thermal states span {span}, less than five times the {scatter} by which the "
            "temperature varies within them: let the machine settle before each run")
                          .with("span", kelvin(span))
                          .with("scatter", kelvin(scatter)));
    return {};
}

/// Each state has the whole range: beyond it nothing is known of how the error moves.
Result<void> checkRange(const std::vector<ThermalState>& states, bool isAngular)
{
    for (const ThermalState& state : states)
        if (state.firstTarget() != states.front().firstTarget()
            || state.lastTarget() != states.front().lastTarget())
            return badFit(AXISCOMP_TEXT("Error",
                "at {temperature} it was measured from {from} to {to}, at {other} from {otherFrom} "
                "to {otherTo}: measure the same range in each thermal state")
                              .with("temperature", degrees(state.temperature))
                              .with("from", placeOf(state.firstTarget(), isAngular))
                              .with("to", placeOf(state.lastTarget(), isAngular))
                              .with("other", degrees(states.front().temperature))
                              .with("otherFrom", placeOf(states.front().firstTarget(), isAngular))
                              .with("otherTo", placeOf(states.front().lastTarget(), isAngular)));
    return {};
}

Result<void> checkInput(const FitInput& input)
{
    const auto missing = std::ranges::count_if(input.measurement.values,
        [](const RunValue& value) { return value.isUsed && !value.temperature; });
    if (missing > 0)
        return badFit(AXISCOMP_COUNTED("Error",
            "{count} values have no temperature; a table over temperature needs that of each (the "
            "column temperature)",
            "1 value has no temperature; a table over temperature needs that of each (the column "
            "temperature)")
                          .with("count", missing));
    if (input.state.kind == FoundState::Kind::On)
        return badFit(AXISCOMP_TEXT("Error",
            "residuals are not merged over temperature: measure with the compensation off"));
    if (input.state.active)
        return badFit(AXISCOMP_TEXT("Error",
            "nothing is merged over temperature: leave out --onto, since with the raw positions on "
            "file the values are the whole error"));
    if (input.settings.grid.size() > 2)
        return badFit(AXISCOMP_TEXT("Error",
            "a table over temperature has two dimensions: give at most two numbers for its grid"));
    return {};
}

/// The curves of the states, over one grid of positions.
struct StateCurves {
    std::vector<ThermalState> states;
    std::vector<TableFit> fits; ///< of each, without a zero
    std::vector<TableFitRequest> requests;
    std::size_t reference = 0; ///< the state nearest to 20 degrees
    double removedConstant = 0.0; ///< of all, by the zero of the reference
};

/// One state as a measurement of its own, as far as fitRuns knows it.
FitSettings settingsOfState(const FitSettings& settings, FitZero zero)
{
    FitSettings ofState = settings;
    ofState.isByTemperature = false;
    ofState.zero = zero;
    ofState.drift.reset(); // it was taken out of all runs together
    if (ofState.grid.size() > 1)
        ofState.grid.resize(1);
    return ofState;
}

/// The state nearest to 20 degrees, and what its zero takes out of all.
Result<void> findReference(const FitInput& input, StateCurves& curves)
{
    constexpr double referenceTemperature = 20.0;
    const auto nearest = std::ranges::min_element(curves.states, {}, [](const ThermalState& state) {
        return std::abs(state.temperature - referenceTemperature);
    });
    curves.reference = static_cast<std::size_t>(nearest - curves.states.begin());
    const FitSettings withZero = settingsOfState(input.settings, input.settings.zero);
    const FitInput reference{
        nearest->measurement, withZero, input.state, input.lookupAt, input.stop};
    AXISCOMP_TRY(const auto request, requestOfRuns(reference));
    AXISCOMP_TRY(
        const auto fit, fitTable(fitValues(nearest->measurement, reference).values, request));
    curves.removedConstant = fit.removed.constant;
    return {};
}

Result<StateCurves> curvesOf(const FitInput& input, const Measurement& settled)
{
    StateCurves curves;
    curves.states = statesOf(settled);
    AXISCOMP_CHECK(checkSpan(curves.states));
    AXISCOMP_CHECK(checkRange(curves.states, settled.isAngular));
    AXISCOMP_CHECK(findReference(input, curves));
    const FitSettings settings = settingsOfState(input.settings, FitZero::Keep);
    for (const ThermalState& state : curves.states) {
        const FitInput ofState{
            state.measurement, settings, input.state, input.lookupAt, input.stop};
        AXISCOMP_TRY(auto request, requestOfRuns(ofState));
        request.laterConstant = curves.removedConstant;
        AXISCOMP_TRY(auto fit, fitTable(fitValues(state.measurement, ofState).values, request));
        const AxisGrid& first = curves.fits.empty() ? fit.grid : curves.fits.front().grid;
        if (fit.grid.size != first.size || fit.grid.start != first.start
            || fit.grid.distance != first.distance)
            return badFit(AXISCOMP_TEXT("Error",
                "the targets differ from one thermal state to the other, so that they give no grid "
                "together; say the grid of the table with --points or --distance"));
        curves.fits.push_back(std::move(fit));
        curves.requests.push_back(std::move(request));
    }
    return curves;
}

/// From the coldest state to the warmest. A distance is the widest that is wanted, so that both
/// ends are temperatures that were measured.
GridAxis temperatureAxis(const FitSettings& settings, const std::vector<ThermalState>& states)
{
    const double from = states.front().temperature;
    const double span = states.back().temperature - from;
    double points = states.size() > mostStatesOnALine ? static_cast<double>(states.size()) : 2.0;
    if (settings.grid.size() > 1) {
        const AxisRequest& wanted = settings.grid[1];
        points = wanted.points != 0 ? static_cast<double>(wanted.points)
                                    : std::ceil(span / wanted.distance * (1.0 - 1e-12)) + 1.0;
    }
    // More than any table holds is refused with the whole grid.
    points = std::clamp(points, 2.0, 1e9);
    return {
        "Temperature", celsius, from, span / (points - 1.0), static_cast<std::uint32_t>(points)};
}

/// The value at one point of the position grid, over temperature: the line of least squares through
/// up to four states, straight lines from state to state where there are more.
class OverTemperature {
public:
    OverTemperature(const StateCurves& curves, std::size_t point)
    {
        double weight = 0.0;
        for (std::size_t n = 0; n < curves.states.size(); ++n) {
            const ThermalState& state = curves.states[n];
            m_temperatures.push_back(state.temperature);
            m_values.push_back(curves.fits[n].values[point] - curves.removedConstant);
            weight += state.weight;
            m_mean += state.weight * state.temperature;
            m_meanValue += state.weight * m_values.back();
        }
        m_mean /= weight;
        m_meanValue /= weight;
        double squares = 0.0;
        for (std::size_t n = 0; n < m_values.size(); ++n) {
            const double from = m_temperatures[n] - m_mean;
            squares += curves.states[n].weight * from * from;
            m_slope += curves.states[n].weight * from * (m_values[n] - m_meanValue);
        }
        m_slope /= squares;
    }

    [[nodiscard]] double at(double temperature) const
    {
        if (m_values.size() <= mostStatesOnALine)
            return m_meanValue + m_slope * (temperature - m_mean);
        const auto above = std::ranges::upper_bound(m_temperatures, temperature);
        const auto last = static_cast<std::ptrdiff_t>(m_values.size()) - 1;
        const auto n = static_cast<std::size_t>(
            std::clamp<std::ptrdiff_t>(above - m_temperatures.begin(), 1, last));
        const double share =
            (temperature - m_temperatures[n - 1]) / (m_temperatures[n] - m_temperatures[n - 1]);
        return m_values[n - 1] + share * (m_values[n] - m_values[n - 1]);
    }
    /// What the table leaves at a state.
    [[nodiscard]] double leftAt(std::size_t state) const
    {
        return m_values[state] - at(m_temperatures[state]);
    }

private:
    std::vector<double> m_temperatures;
    std::vector<double> m_values;
    double m_mean = 0.0;
    double m_meanValue = 0.0;
    double m_slope = 0.0;
};

Result<FittedTable> tableOf(const FitInput& input, const StateCurves& curves)
{
    const std::string unit(positionUnit(input.measurement));
    AxisNames names = axisNames(input, nullptr);
    const AxisGrid& positions = curves.fits.front().grid;
    Grid grid;
    grid.axes = {{std::move(names.positions), unit, positions.start, positions.distance,
                     static_cast<std::uint32_t>(positions.size)},
        temperatureAxis(input.settings, curves.states)};
    if (grid.pointCount() > input.settings.mostPoints)
        return fail(ErrorCode::ResamplingImpossible,
            {{"reason",
                AXISCOMP_TEXT(
                    "Error", "the grid has {count} points, and a table holds {most}; take fewer")
                    .with("count", grid.pointCount())
                    .with("most", input.settings.mostPoints)}});
    std::vector<double> values(grid.pointCount());
    double squares = 0.0;
    double largest = 0.0;
    for (std::size_t i = 0; i < positions.size; ++i) {
        const OverTemperature line(curves, i);
        for (std::size_t t = 0; t < grid.axes[1].size; ++t)
            values[t * positions.size + i] = line.at(grid.axes[1].position(t));
        for (std::size_t n = 0; n < curves.states.size(); ++n) {
            squares += std::pow(line.leftAt(n), 2);
            largest = std::max(largest, std::abs(line.leftAt(n)));
        }
    }
    FittedTable made = fittedTable(
        std::move(values), std::move(grid), std::move(names.values), std::move(names.target), unit);
    const TableFit& reference = curves.fits[curves.reference];
    made.removedConstant = curves.removedConstant;
    made.removedSlope = reference.removed.slope;
    made.knots = reference.knots.size();
    made.means = reference.knots;
    made.periods = reference.curve.terms;
    made.smoothness = reference.smoothness;
    made.residualRms =
        std::sqrt(squares / static_cast<double>(positions.size * curves.states.size()));
    made.residualLargest = largest;
    made.measuredNodes = made.table.values.size();
    return made;
}

/// The table along the axis, at one temperature.
CompensationTable sliceOf(const CompensationTable& table, double temperature)
{
    const Lookup lookup(table, Outside::Hold);
    CompensationTable slice{table.name, table.unit, {}, {}};
    slice.grid.axes = {table.grid.axes.front()};
    for (std::size_t i = 0; i < slice.grid.axes.front().size; ++i)
        slice.values.push_back(static_cast<float>(
            lookup.at(std::vector<double>{slice.grid.axes.front().position(i), temperature})));
    return slice;
}

/// The same runs with the table active, each at its own temperature.
Result<Measurement> predictedRuns(
    const FitInput& input, const StateCurves& curves, const CompensationTable& table)
{
    Measurement result = input.measurement;
    const FitSettings settings = settingsOfState(input.settings, FitZero::Keep);
    for (const auto& [temperature, run] : temperaturesOfRuns(input.measurement)) {
        const ThermalState ofRun = stateOf(input.measurement, {run});
        const FitInput single{ofRun.measurement, settings, input.state, input.lookupAt, input.stop};
        const FitValues values = fitValues(ofRun.measurement, single);
        AXISCOMP_TRY(const auto predicted,
            predictRuns(
                values.values, sliceOf(table, temperature), curves.requests[curves.reference]));
        for (std::size_t i = 0; i < predicted.size(); ++i)
            result.values[values.indices[i]].deviation = predicted[i].deviation;
    }
    return result;
}

void takeLarger(const Iso230Figures& ofState, Iso230Figures& figures)
{
    const auto sameTarget = [&](std::size_t n) {
        const auto found =
            std::ranges::find(figures.targets, ofState.targets[n].target, &TargetFigures::target);
        return static_cast<std::size_t>(found - figures.targets.begin());
    };
    for (const Iso230Figure figure : allIso230Figures()) {
        const AxisFigure& one = ofState[figure];
        AxisFigure& largest = figures.axis[static_cast<std::size_t>(figure)];
        if (!one.value || !largest.value || std::abs(*one.value) <= std::abs(*largest.value))
            continue;
        largest.value = one.value;
        if (figure == Iso230Figure::MeanReversal)
            continue; // arises nowhere
        largest.high = sameTarget(one.high);
        largest.low = sameTarget(one.low);
    }
}

/// Each the largest of a state and of all runs together: the axis is at one temperature at a time,
/// and what is above in one state and below in another cancels in the means over all.
Iso230Figures figuresOfStates(
    const Measurement& measurement, const std::vector<ThermalState>& states)
{
    Iso230Figures figures = iso230Figures(measurement);
    for (const ThermalState& state : states) {
        Measurement ofState = measurement;
        for (std::size_t i = 0; i < ofState.values.size(); ++i)
            ofState.values[i].isUsed = state.measurement.values[i].isUsed;
        takeLarger(iso230Figures(ofState), figures);
    }
    return figures;
}

/// What the curve of a state has above the table at its temperature.
class LeftByTable {
public:
    LeftByTable(const FitInput& input, const StateCurves& curves, std::size_t state,
        const CompensationTable& table)
        : m_made(sliceOf(table, curves.states[state].temperature))
        , m_curve(m_made)
        , m_outside(input.outside())
    {
        for (std::size_t i = 0; i < m_curve.values.size(); ++i)
            m_curve.values[i] =
                static_cast<float>(curves.fits[state].values[i] - curves.removedConstant);
    }
    [[nodiscard]] double at(double position) const
    {
        return Lookup(m_curve, m_outside).at(position) - Lookup(m_made, m_outside).at(position);
    }

private:
    CompensationTable m_made;
    CompensationTable m_curve;
    Outside m_outside;
};

/// That of all states, with what the table over temperature leaves of each; M is the largest of a
/// state, since the axis is at one temperature at a time.
Result<HeldOut> heldOutOf(
    const FitInput& input, const StateCurves& curves, const CompensationTable& table)
{
    HeldOut all;
    double squares = 0.0;
    const FitSettings settings = settingsOfState(input.settings, FitZero::Keep);
    for (std::size_t n = 0; n < curves.states.size(); ++n) {
        const Measurement& measurement = curves.states[n].measurement;
        const FitInput ofState{measurement, settings, input.state, input.lookupAt, input.stop};
        AXISCOMP_TRY(auto one,
            predictHeldOut(fitValues(measurement, ofState).values, curves.requests[n], input.stop));
        const LeftByTable left(input, curves, n, table);
        if (one.ends.empty() && curves.states.size() > 2) // a line through two leaves nothing there
            one.ends = {{curves.states[n].firstTarget()}, {curves.states[n].lastTarget()}};
        double lowest = std::numeric_limits<double>::infinity();
        double highest = -lowest;
        for (auto* const residuals : {&one.residuals, &one.ends})
            for (HeldOut::Residual& residual : *residuals) {
                residual.value += left.at(residual.target);
                lowest = std::min(lowest, residual.value);
                highest = std::max(highest, residual.value);
            }
        for (const HeldOut::Residual& residual : one.residuals)
            squares += residual.value * residual.value;
        all.largest = std::max({all.largest, std::abs(lowest), std::abs(highest)});
        all.range = std::max(all.range, highest - lowest);
        all.unknownRange = std::max(all.unknownRange, one.unknownRange);
        all.residuals.insert(all.residuals.end(), one.residuals.begin(), one.residuals.end());
    }
    all.rms = std::sqrt(squares / static_cast<double>(all.residuals.size()));
    return all;
}

void addTemperatureRemarks(const FitInput& input, const StateCurves& curves, FitReport& report)
{
    std::vector<Text> temperatures;
    for (const ThermalState& state : curves.states)
        temperatures.push_back(AXISCOMP_TEXT("Measurement", "{temperature}")
                                   .with("temperature", degrees(state.temperature)));
    addRemark(report, "ThermalStates",
        AXISCOMP_TEXT("Measurement",
            "measured in {count} thermal states: {temperatures}; outside of them the drive holds "
            "the values of the ends")
            .with("count", curves.states.size())
            .with("temperatures", std::move(temperatures)));
    if (curves.states.size() > 2 && curves.states.size() <= mostStatesOnALine)
        addRemark(report, "StraightOverTemperature",
            AXISCOMP_TEXT("Measurement",
                "the table is straight over temperature, which leaves up to {largest} of what was "
                "measured in a state")
                .with("largest",
                    fineQuantity(
                        report.tables.front().residualLargest, input.measurement.isAngular)));
    addRemark(report, "FiguresOfStates", figuresByTemperatureText());
    addRemark(report, "InstrumentZeroKept",
        AXISCOMP_TEXT("Measurement",
            "the table has the movement of the zero from one thermal state to the other, as the "
            "instrument saw it: that is only right if its own zero was not set anew in between"),
        true);
}

Text atTemperature(double temperature, Text sentence)
{
    return AXISCOMP_TEXT("Measurement", "at {temperature}: {sentence}")
        .with("temperature", degrees(temperature))
        .with("sentence", std::move(sentence));
}

/// The runs of a state alone, with what was excluded of them. What the file says of results, and
/// files of their machines, is of all runs.
Measurement runsOfState(const Measurement& measurement, const ThermalState& state)
{
    Measurement runs = measurement;
    std::erase_if(runs.values, [&state](const RunValue& value) {
        return !state.runs.contains({value.direction, value.run});
    });
    runs.published.clear();
    runs.joined.clear();
    return runs;
}

/// What is said of a table of runs, where each state is a measurement of its own.
void addRemarksOfStates(const FitInput& input, const StateCurves& curves, FitReport& report)
{
    JudgeOptions judging;
    judging.outlierRule = input.settings.outlierRule;
    for (JudgeWarning& warning : otherMachines(input.measurement))
        addRemark(report, warning.name, std::move(warning.text), true);
    std::size_t outliers = 0;
    for (const ThermalState& state : curves.states) {
        const Judgement judgement = judge(runsOfState(input.measurement, state), judging);
        outliers += outlierCount(judgement);
        const CompensationTable slice = sliceOf(report.tables.front().table, state.temperature);
        FitReport ofState;
        addStateRemarks(input, judgement, {&slice, 1}, ofState);
        for (FitRemark& remark : ofState.remarks)
            addRemark(report, remark.name, atTemperature(state.temperature, std::move(remark.text)),
                remark.isWarning);
    }
    const auto mostReversal = std::ranges::max_element(
        curves.fits, {}, [](const TableFit& fit) { return fit.remainingReversal.value_or(-1.0); });
    addRunsRemarks(input, outliers, *mostReversal, report);
}

} // namespace

Iso230Figures figuresOfFit(const Measurement& measurement, bool isByTemperature)
{
    const auto isUsed = [](const RunValue& value) { return value.isUsed; };
    const bool hasTemperatures = std::ranges::any_of(measurement.values, isUsed)
        && std::ranges::all_of(measurement.values,
            [](const RunValue& value) { return !value.isUsed || value.temperature; });
    return isByTemperature && hasTemperatures ? figuresOfStates(measurement, statesOf(measurement))
                                              : iso230Figures(measurement);
}

Text figuresByTemperatureText()
{
    return AXISCOMP_TEXT("Measurement",
        "each figure, before and foretold, is the largest of a thermal state and of all runs "
        "together");
}

Result<FitReport> fitRunsByTemperature(const FitInput& input)
{
    const FitSettings& settings = input.settings;
    AXISCOMP_CHECK(checkInput(input));
    const Measurement settled =
        settings.drift ? withoutDrift(input.measurement, *settings.drift) : input.measurement;
    AXISCOMP_TRY(const auto curves, curvesOf(input, settled));
    FitReport report;
    AXISCOMP_TRY(auto made, tableOf(input, curves));
    report.tables.push_back(std::move(made));
    const CompensationTable& table = report.tables.front().table;
    report.before = figuresOfStates(input.measurement, curves.states);
    AXISCOMP_TRY(const auto predicted, predictedRuns(input, curves, table));
    report.predicted = figuresOfStates(predicted, curves.states);
    AXISCOMP_CHECK(addHeldOut(heldOutOf(input, curves, table), report));
    judgeForetold(settings, report);
    const ThermalState& reference = curves.states[curves.reference];
    const FitSettings ofState = settingsOfState(settings, settings.zero);
    const FitInput referenceInput{
        reference.measurement, ofState, input.state, input.lookupAt, input.stop};
    TableFit fit = curves.fits[curves.reference];
    fit.removed.constant += curves.removedConstant;
    report.sign = atTemperature(reference.temperature,
        signOfRuns(referenceInput, fit, sliceOf(table, reference.temperature)));
    addTemperatureRemarks(input, curves, report);
    addRemarksOfStates(input, curves, report);
    return report;
}

} // namespace axiscomp
