// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/formats/run_assembly.h"

#include "core/table/position_unit.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <map>
#include <new>
#include <numbers>
#include <set>
#include <tuple>

namespace axiscomp {

namespace {

/// Six digits: enough to recognise a number.
std::string shortNumber(double value)
{
    std::array<char, 32> buffer{};
    const auto result = std::to_chars(
        buffer.data(), buffer.data() + buffer.size(), value, std::chars_format::general, 6);
    return {buffer.data(), result.ptr};
}

Quantity position(double value, const Measurement& measurement)
{
    return {shortNumber(value), std::string(positionUnit(measurement))};
}

/// The slope of y over x by least squares; nothing when x does not move.
std::optional<double> slopeOf(std::span<const double> x, std::span<const double> y)
{
    double meanX = 0.0;
    double meanY = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        meanX += x[i] / static_cast<double>(x.size());
        meanY += y[i] / static_cast<double>(x.size());
    }
    double xx = 0.0;
    double xy = 0.0;
    for (std::size_t i = 0; i < x.size(); ++i) {
        xx += (x[i] - meanX) * (x[i] - meanX);
        xy += (x[i] - meanX) * (y[i] - meanY);
    }
    const double slope = xy / xx;
    return xx > 0.0 && std::isfinite(slope) ? std::optional(slope) : std::nullopt;
}

/// A way to be wrong by a factor.
struct ScaleMistake {
    double factor;
    TextPattern meaning;
};
constexpr std::array scaleMistakes{
    ScaleMistake{1000.0,
        AXISCOMP_TEXT(
            "Error", "the reference has a unit that is 1000 times smaller, as um for mm")},
    ScaleMistake{0.001,
        AXISCOMP_TEXT("Error", "the reference has a unit that is 1000 times larger, as m for mm")},
    ScaleMistake{25.4, AXISCOMP_TEXT("Error", "the reference is in mm and the encoder in inch")},
    ScaleMistake{
        1.0 / 25.4, AXISCOMP_TEXT("Error", "the reference is in inch and the encoder in mm")},
    ScaleMistake{
        0.5, AXISCOMP_TEXT("Error", "the factor of the interferometer is wrong: it counts half")},
    ScaleMistake{
        2.0, AXISCOMP_TEXT("Error", "the factor of the interferometer is wrong: it counts double")},
    ScaleMistake{180.0 / std::numbers::pi,
        AXISCOMP_TEXT("Error", "the reference is in degrees and the encoder in radians")},
    ScaleMistake{std::numbers::pi / 180.0,
        AXISCOMP_TEXT("Error", "the reference is in radians and the encoder in degrees")},
};
constexpr double scaleTolerance = 0.01;

/// The slope of y over x where one does not follow the other.
std::optional<double> wrongSlope(std::span<const double> x, std::span<const double> y)
{
    const auto slope = slopeOf(x, y);
    return slope && std::abs(*slope - 1.0) > scaleTolerance ? slope : std::nullopt;
}

/// Whether the reference is beside the axis but for whole turns: 359.9999 for 0.
bool isWholeTurnsAway(std::span<const double> encoder, std::span<const double> reference)
{
    constexpr double turn = 360.0;
    bool hasTurns = false;
    for (std::size_t i = 0; i < encoder.size(); ++i) {
        const double turns = std::round((reference[i] - encoder[i]) / turn);
        if (!(std::abs(reference[i] - turns * turn - encoder[i]) <= scaleTolerance * turn))
            return false;
        hasTurns = hasTurns || turns != 0.0;
    }
    return hasTurns;
}

Text scaleExplanation(double slope, bool isInverted)
{
    if (std::abs(slope + 1.0) < scaleTolerance && isInverted)
        return AXISCOMP_TEXT("Error",
            "1; as it stands in the file it follows the axis: leave --invert-reference out");
    if (std::abs(slope + 1.0) < scaleTolerance)
        return AXISCOMP_TEXT(
            "Error", "the instrument counts the other way; if so, say it with --invert-reference");
    for (const ScaleMistake& mistake : scaleMistakes)
        if (std::abs(std::abs(slope) / mistake.factor - 1.0) < scaleTolerance)
            return AXISCOMP_TEXT("Error",
                "1; {meaning}: correct the file, or state the unit of the reference with "
                "--value-unit, and that of the other positions with --unit")
                .with("meaning", mistake.meaning);
    return AXISCOMP_TEXT(
        "Error", "1 within 1 %; check which columns are reference and encoder, and their units");
}

/// Puts the values of one file together.
class Assembly {
public:
    Assembly(const MeasurementReadOptions& options, Measurement& measurement,
        DiagnosticList& diagnostics)
        : m_options(options)
        , m_measurement(measurement)
        , m_diagnostics(diagnostics)
    {
    }

    void run(std::vector<RawRunValue> values);

private:
    void takeReferences(std::vector<RawRunValue>& values);
    [[nodiscard]] bool checkEncoder(std::span<const RawRunValue> values);
    bool findTargets(const std::vector<RawRunValue>& values);
    [[nodiscard]] bool checkFinite(double number, std::size_t line);
    void countRuns();
    void checkDuplicates();
    void checkCompleteness();
    void checkDirection(Approach direction);
    void checkSizes();

    const MeasurementReadOptions& m_options;
    Measurement& m_measurement;
    DiagnosticList& m_diagnostics;
};

void Assembly::run(std::vector<RawRunValue> values)
{
    takeReferences(values);
    if (!findTargets(values))
        return;
    for (RawRunValue& raw : values) {
        raw.value.target = targetIndex(m_measurement.targets, raw.target);
        m_measurement.values.push_back(raw.value);
    }
    countRuns();
    sortValues(m_measurement.values);
    checkDuplicates();
    if (m_diagnostics.hasErrors())
        return;
    checkCompleteness();
    checkSizes();
}

void Assembly::takeReferences(std::vector<RawRunValue>& values)
{
    std::vector<double> encoder;
    std::vector<double> reference;
    for (RawRunValue& raw : values) {
        if (!raw.reference)
            continue;
        if (m_options.invertsReference)
            raw.reference = -*raw.reference;
        raw.value.deviation = *raw.reference - raw.target;
        encoder.push_back(raw.value.encoder.value_or(raw.target));
        reference.push_back(*raw.reference);
    }
    m_measurement.againstFile.invertsReference = m_options.invertsReference && !reference.empty();
    if (!values.empty())
        checkStatedValues(m_options, !reference.empty(), m_diagnostics);
    if (checkEncoder(values) && !reference.empty())
        checkInstrumentScale(
            {encoder, reference, m_measurement.isAngular}, m_options, m_diagnostics);
}

/// Raw positions of another unit or sign would go into the table whole. A reference is not compared
/// with them then: the sentence would blame it.
bool Assembly::checkEncoder(std::span<const RawRunValue> values)
{
    std::vector<double> targets;
    std::vector<double> encoder;
    for (const RawRunValue& raw : values) {
        if (!raw.value.encoder)
            continue;
        targets.push_back(raw.target);
        encoder.push_back(*raw.value.encoder);
    }
    const auto slope = wrongSlope(targets, encoder);
    if (!slope)
        return true;
    m_diagnostics.error(DiagnosticCode::InstrumentScale, 0, 0,
        AXISCOMP_TEXT("Error", "the encoder moves {slope} times as far as the targets")
            .with("slope", Quantity{shortNumber(*slope)}),
        AXISCOMP_TEXT("Error",
            "1 within 1 %; correct the column of the encoder, or take it out of the file"));
    return false;
}

bool Assembly::checkFinite(double number, std::size_t line)
{
    if (std::isfinite(number))
        return true;
    m_diagnostics.error(DiagnosticCode::NotFinite, line, 0, {},
        AXISCOMP_TEXT("Error", "numbers that a computer can hold; check their size"));
    return false;
}

/// Those that were planned stay where no value was measured: they are missing in every run.
bool Assembly::findTargets(const std::vector<RawRunValue>& values)
{
    std::vector<double> positions;
    for (const RawRunValue& raw : values) {
        for (const double number : {2.0 * raw.target, raw.value.deviation,
                 raw.value.encoder.value_or(0.0), raw.value.output.value_or(0.0)})
            if (!checkFinite(number, raw.value.line))
                return false;
        positions.push_back(raw.target);
    }
    for (const double planned : m_measurement.targets)
        if (!checkFinite(2.0 * planned, 0))
            return false;
    positions.insert(positions.end(), m_measurement.targets.begin(), m_measurement.targets.end());
    m_measurement.targets = distinctTargets(std::move(positions));
    std::set<std::size_t> measured;
    for (const RawRunValue& raw : values)
        measured.insert(targetIndex(m_measurement.targets, raw.target));
    if (measured.size() >= 2)
        return true;
    m_diagnostics.error(DiagnosticCode::TooFewTargets, 0, 0,
        AXISCOMP_COUNTED("Error", "{count} targets", "1 target").with("count", measured.size()),
        AXISCOMP_TEXT("Error", "at least 2 different positions that the axis was sent to"));
    return false;
}

/// Runs without a number are counted as they come, for each target and direction.
void Assembly::countRuns()
{
    std::map<std::pair<Approach, std::size_t>, int> counts;
    for (RunValue& value : m_measurement.values)
        if (value.run == 0)
            value.run = ++counts[{value.direction, value.target}];
}

void Assembly::checkDuplicates()
{
    const std::vector<RunValue>& values = m_measurement.values;
    // Of several means repeatability would follow as if they were single values.
    const bool areMeans = m_measurement.kind == MeasurementKind::Averages;
    const auto key = [areMeans](const RunValue& v) {
        return std::tuple(v.direction, v.target, areMeans ? 1 : v.run);
    };
    for (std::size_t i = 1; i < values.size(); ++i) {
        if (key(values[i]) != key(values[i - 1]))
            continue;
        m_diagnostics.error(DiagnosticCode::DuplicateValue, values[i].line, 0,
            AXISCOMP_TEXT("Error",
                "target {target}, {direction}, run {run} in line {first} and in line {second}")
                .with("target", position(m_measurement.targets[values[i].target], m_measurement))
                .with("direction", approachText(values[i].direction))
                .with("run", values[i].run)
                .with("first", values[i - 1].line)
                .with("second", values[i].line),
            areMeans ? AXISCOMP_TEXT("Error", "one mean for each target and direction")
                     : AXISCOMP_TEXT("Error",
                         "one value for each target, direction and run, or a number for each run"));
    }
}

void Assembly::checkCompleteness()
{
    checkDirection(Approach::Up);
    checkDirection(Approach::Down);
    const int up = m_measurement.runCount(Approach::Up);
    const int down = m_measurement.runCount(Approach::Down);
    if (up != down && up > 0 && down > 0)
        m_diagnostics.warning(DiagnosticCode::UnequalRuns, 0, 0,
            AXISCOMP_TEXT("Error", "{up} up and {down} down").with("up", up).with("down", down),
            AXISCOMP_TEXT("Error", "as many in each direction"));
}

void Assembly::checkDirection(Approach direction)
{
    std::map<int, std::vector<bool>> runs;
    for (const RunValue& value : m_measurement.values) {
        if (value.direction != direction)
            continue;
        std::vector<bool>& seen = runs[value.run];
        seen.resize(m_measurement.targets.size());
        seen[value.target] = true;
    }
    constexpr std::size_t mostNamed = 3;
    std::vector<std::string> named;
    std::size_t missing = 0;
    for (const auto& [run, seen] : runs)
        for (std::size_t target = 0; target < seen.size(); ++target)
            if (!seen[target] && ++missing <= mostNamed)
                named.push_back(std::string(approachName(direction)) + ":"
                    + std::to_string(target + 1) + ":" + std::to_string(run));
    if (missing > mostNamed)
        named.emplace_back("...");
    if (missing > 0)
        m_diagnostics.warning(DiagnosticCode::IncompleteRuns, 0, 0,
            AXISCOMP_COUNTED(
                "Error", "no value for {places} ({count} are missing)", "no value for {places}")
                .with("count", missing)
                .with("places", named),
            AXISCOMP_TEXT("Error", "a value for every target in every run"));
}

void Assembly::checkSizes()
{
    std::vector<double> targets;
    std::vector<double> deviations;
    for (const RunValue& value : m_measurement.values) {
        targets.push_back(m_measurement.targets[value.target]);
        deviations.push_back(value.deviation);
    }
    checkValueSizes({.positions = {&targets, 1},
                        .values = deviations,
                        .unit = std::string(positionUnit(m_measurement))},
        m_diagnostics);
}

/// The slope that makes values look like positions along one of the axes; nothing: none does.
std::optional<double> slopeOfPositions(const SizedValues& sized)
{
    for (const std::vector<double>& positions : sized.positions) {
        const auto slope = slopeOf(positions, sized.values);
        if (slope && std::abs(*slope - 1.0) < scaleTolerance)
            return slope;
    }
    return std::nullopt;
}

double largestTravel(const SizedValues& sized)
{
    double travel = 0.0;
    for (const std::vector<double>& positions : sized.positions) {
        const auto [low, high] = std::ranges::minmax_element(positions);
        travel = std::max(travel, *high - *low);
    }
    return travel;
}

} // namespace

void assembleRuns(std::vector<RawRunValue> values, const MeasurementReadOptions& options,
    Measurement& measurement, DiagnosticList& diagnostics)
{
    if (!diagnostics.hasErrors())
        Assembly(options, measurement, diagnostics).run(std::move(values));
}

void checkInstrumentScale(const FollowedPositions& positions, const MeasurementReadOptions& options,
    DiagnosticList& diagnostics)
{
    const auto slope = wrongSlope(positions.encoder, positions.reference);
    if (!slope)
        return;
    const bool isTurn =
        positions.areAngles && isWholeTurnsAway(positions.encoder, positions.reference);
    diagnostics.error(DiagnosticCode::InstrumentScale, 0, 0,
        AXISCOMP_TEXT("Error", "the reference moves {slope} times as far as the axis")
            .with("slope", Quantity{shortNumber(*slope)}),
        isTurn ? Text(AXISCOMP_TEXT("Error",
            "1; some values are whole turns away, since the instrument begins again at "
            "360 deg: let it count on, or write -0.0001 in place of 359.9999 in the file"))
               : scaleExplanation(*slope, options.invertsReference));
}

std::optional<MeasurementUnit> unitOfFormat(std::string_view what, const std::string& stated,
    const std::string& ofFile, Measurement& measurement, DiagnosticList& diagnostics)
{
    const std::string& symbol = stated.empty() ? ofFile : stated;
    const auto unit = measurementUnit(symbol);
    if (!unit)
        diagnostics.error(DiagnosticCode::UnitMissing, 0, 0,
            AXISCOMP_TEXT("Error", "the unit {unit}").with("unit", symbol),
            AXISCOMP_TEXT("Error", "a length or an angle: mm, um, m, inch, deg, arcsec, mrad"));
    else if (!stated.empty() && !isSameUnit(stated, ofFile))
        measurement.againstFile.units.push_back({std::string(what), stated, ofFile});
    return unit;
}

bool areSameKind(
    const MeasurementUnit& targets, const MeasurementUnit& values, DiagnosticList& diagnostics)
{
    if (targets.isAngular == values.isAngular)
        return true;
    diagnostics.error(DiagnosticCode::UnitMixed, 0, 0, {},
        targets.isAngular ? AXISCOMP_TEXT("Error", "an angle as the targets are")
                          : AXISCOMP_TEXT("Error", "a length as the targets are"));
    return false;
}

void checkStatedValues(
    const MeasurementReadOptions& options, bool holdsReference, DiagnosticList& diagnostics)
{
    using Values = MeasurementReadOptions::Values;
    const bool isOther = options.values == (holdsReference ? Values::Deviation : Values::Reference);
    if (isOther)
        diagnostics.error(DiagnosticCode::MissingColumn, 0, 0,
            holdsReference ? AXISCOMP_TEXT("Error", "positions of the reference")
                           : AXISCOMP_TEXT("Error", "deviations"),
            AXISCOMP_TEXT("Error", "what --values says; leave it out, since the file says it"));
    else if (options.invertsReference && !holdsReference)
        diagnostics.error(DiagnosticCode::MissingColumn, 0, 0, AXISCOMP_TEXT("Error", "deviations"),
            AXISCOMP_TEXT("Error",
                "positions of the reference for --invert-reference; deviations with the opposite "
                "sign say it in the file (// sign: correction)"));
}

void checkValueSizes(const SizedValues& sized, DiagnosticList& diagnostics)
{
    if (sized.values.empty())
        return;
    if (const auto slope = slopeOfPositions(sized)) {
        const TextPattern found = sized.column == 0
            ? AXISCOMP_TEXT("Error", "values that rise by {slope} with the target")
            : AXISCOMP_TEXT("Error", "values that rise by {slope} with the position");
        diagnostics.warning(DiagnosticCode::ValuesLookLikePositions, sized.line, sized.column,
            found.with("slope", Quantity{shortNumber(*slope)}),
            AXISCOMP_TEXT("Error", "deviations, which hardly follow it"));
        return;
    }
    double largest = 0.0;
    for (const double value : sized.values)
        largest = std::max(largest, std::abs(value));
    const double travel = largestTravel(sized);
    constexpr double most = 0.01;
    constexpr double least = 1e-9;
    if (std::isfinite(travel) && largest > 0.0
        && (largest > most * travel || largest < least * travel))
        diagnostics.warning(DiagnosticCode::UnitSuspicious, sized.line, sized.column,
            AXISCOMP_TEXT("Error", "a largest deviation of {value} over {travel}")
                .with("value", Quantity{shortNumber(largest), sized.unit})
                .with("travel", Quantity{shortNumber(travel), sized.unit}),
            largest < most * travel ? AXISCOMP_TEXT("Error", "more than a billionth of the travel")
                                    : AXISCOMP_TEXT("Error", "at most 1 % of the travel"));
}

MeasurementReading readMeasurementText(std::string_view text, const MeasurementReadOptions& options,
    void (*parse)(std::string_view text, const MeasurementReadOptions& options,
        Measurement& measurement, DiagnosticList& diagnostics))
{
    MeasurementReading reading;
    DiagnosticList diagnostics(options.maximumDiagnostics);
    Measurement measurement;
    try {
        parse(text, options, measurement, diagnostics);
    } catch (const std::bad_alloc&) {
        diagnostics.error(DiagnosticCode::IoError, 0, 0,
            AXISCOMP_TEXT("Error", "there is not enough memory"), {});
    }
    reading.cancelled = options.stop.stop_requested();
    if (!diagnostics.hasErrors() && !reading.cancelled)
        reading.measurement = std::move(measurement);
    reading.suppressed = diagnostics.suppressed();
    reading.diagnostics = diagnostics.take();
    return reading;
}

} // namespace axiscomp
