// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/fanuc/pitch_data.h"
#include "core/formats/own_axis.h"
#include "core/formats/wrap_range.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>

namespace axiscomp::fanuc {

namespace {

constexpr double mostSteps = 9007199254740992.0; // every whole number up to here is a double

/// One table on its way into the file.
class PitchWriter {
public:
    PitchWriter(const FormatFacts& facts, const PitchSetup& setup, std::int64_t largestStep,
        const NeutralTable& table)
        : m_facts(facts)
        , m_setup(setup)
        , m_largestStep(largestStep)
        , m_axis(table.axes.front())
        , m_amounts(table.columns.front().values)
        , m_interval(evenDistance(m_axis))
    {
        if (m_axis.wrap) // both ends are one place
            m_amounts.back() = m_amounts.front();
    }

    /// Finds the knot of the reference position, and the value of each section.
    [[nodiscard]] Result<void> prepare();
    [[nodiscard]] std::string text() const;
    [[nodiscard]] double interval() const { return m_interval; }
    [[nodiscard]] std::size_t count() const { return m_steps.size(); }
    /// What the parameters of the control must be.
    [[nodiscard]] Text parameters() const;

private:
    [[nodiscard]] Result<void> findReference();
    [[nodiscard]] Result<void> checkNumbers() const;
    [[nodiscard]] Result<void> checkAmounts() const;
    [[nodiscard]] Result<void> checkSteps() const;
    /// The amount at each knot is rounded first, so that rounding does not add up.
    [[nodiscard]] std::vector<double> roundedAmounts(std::int64_t magnification) const;
    [[nodiscard]] bool fits(std::int64_t magnification) const;
    [[nodiscard]] std::optional<std::int64_t> fittingMagnification() const;
    [[nodiscard]] Quantity quantity(double number) const
    {
        return {roundedText(number), m_axis.unit};
    }

    const FormatFacts& m_facts;
    PitchSetup m_setup;
    std::int64_t m_largestStep;
    const SourceAxis& m_axis;
    std::vector<double> m_amounts; ///< at each knot, in the unit of the axis
    double m_interval;
    std::int64_t m_knot = 0; ///< that of the reference position
    std::int64_t m_first = 0; ///< the number of the first of m_steps
    std::vector<std::int64_t> m_steps; ///< of the sections, in the order of their numbers
};

Result<void> PitchWriter::findReference()
{
    const double at = (m_setup.position - m_axis.knots.front()) / m_interval;
    const auto sections = static_cast<std::int64_t>(m_axis.knots.size()) - 1;
    const bool isKnot = std::abs(at) < 1e9 && std::abs(at - std::round(at)) <= 1e-6;
    m_knot = isKnot ? std::llround(at) : -1;
    if (isKnot && m_axis.wrap)
        m_knot = ((m_knot % sections) + sections) % sections;
    if (m_knot >= 0 && m_knot <= sections)
        return {};
    return cannotHold(m_facts,
        AXISCOMP_TEXT("Error",
            "the reference position {position} is no point of it; its points are from {first} to "
            "{last}, {distance} apart")
            .with("position", quantity(m_setup.position))
            .with("first", quantity(m_axis.knots.front()))
            .with("last", quantity(m_axis.knots.back()))
            .with("distance", quantity(m_interval)),
        AXISCOMP_TEXT("Error", "resample it with a point there, or check reference-position"));
}

Result<void> PitchWriter::checkNumbers() const
{
    const auto sections = static_cast<std::int64_t>(m_axis.knots.size()) - 1;
    const std::int64_t first = m_axis.wrap ? m_setup.reference : m_setup.reference - m_knot + 1;
    const std::int64_t last =
        m_axis.wrap ? m_setup.reference + sections : m_setup.reference - m_knot + sections;
    if (first >= 0 && last < mostNumbers)
        return {};
    return cannotHold(m_facts,
        AXISCOMP_TEXT("Error", "its points would get the numbers {first} to {last}")
            .with("first", first)
            .with("last", last),
        AXISCOMP_TEXT("Error", "choose a reference-number so that they are from 0 to {most}")
            .with("most", mostNumbers - 1));
}

std::vector<double> PitchWriter::roundedAmounts(std::int64_t magnification) const
{
    std::vector<double> rounded;
    for (const double amount : m_amounts)
        rounded.push_back(std::round(m_setup.stepsOf(amount, magnification)));
    return rounded;
}

Result<void> PitchWriter::checkAmounts() const
{
    for (const double amount : m_amounts)
        if (!(std::abs(m_setup.stepsOf(amount, 1)) <= mostSteps))
            return cannotHold(m_facts,
                AXISCOMP_TEXT("Error", "the value {value} is too large")
                    .with("value", quantity(amount)),
                AXISCOMP_TEXT("Error", "check detection-unit and the unit of the values"));
    const double atReference = m_amounts[static_cast<std::size_t>(m_knot)];
    if (std::round(m_setup.stepsOf(atReference, m_setup.magnification)) == 0.0)
        return {};
    return cannotHold(m_facts,
        AXISCOMP_TEXT("Error",
            "its value at the reference position is {value}, and the controller takes it to be 0 "
            "there")
            .with("value", quantity(atReference)),
        AXISCOMP_TEXT(
            "Error", "shift all values so that it is 0 there; convert does that with --zero"));
}

bool PitchWriter::fits(std::int64_t magnification) const
{
    const std::vector<double> amounts = roundedAmounts(magnification);
    for (std::size_t i = 1; i < amounts.size(); ++i)
        if (std::abs(amounts[i] - amounts[i - 1]) > static_cast<double>(m_largestStep))
            return false;
    return amounts[static_cast<std::size_t>(m_knot)] == 0.0;
}

/// The smallest one with which no value is too large; nothing: there is none.
std::optional<std::int64_t> PitchWriter::fittingMagnification() const
{
    // Rounding changes a difference by less than 1, which bounds the search on both sides.
    double exact = 0.0;
    for (std::size_t i = 1; i < m_amounts.size(); ++i)
        exact = std::max(exact,
            std::abs(m_setup.stepsOf(m_amounts[i], 1) - m_setup.stepsOf(m_amounts[i - 1], 1)));
    const auto limit = static_cast<double>(m_largestStep);
    if (exact / limit > static_cast<double>(largestMagnification))
        return std::nullopt;
    auto magnification = std::max<std::int64_t>(1, std::llround(exact / (limit + 1.0)) - 1);
    while (magnification <= largestMagnification && !fits(magnification))
        ++magnification;
    return magnification <= largestMagnification ? std::optional(magnification) : std::nullopt;
}

Result<void> PitchWriter::checkSteps() const
{
    const std::vector<double> amounts = roundedAmounts(m_setup.magnification);
    for (std::size_t i = 1; i < amounts.size(); ++i) {
        const double step = amounts[i] - amounts[i - 1];
        if (std::abs(step) <= static_cast<double>(m_largestStep))
            continue;
        const auto fitting = fittingMagnification();
        return cannotHold(m_facts,
            AXISCOMP_TEXT("Error",
                "from {first} to {last} it changes by {count} increments of {increment}, and a "
                "value is "
                "at most {most}")
                .with("first", quantity(m_axis.knots[i - 1]))
                .with("last", quantity(m_axis.knots[i]))
                .with("count", std::llround(step))
                .with("increment", quantity(m_setup.amountOf(1.0)))
                .with("most", m_largestStep),
            fitting
                ? AXISCOMP_TEXT("Error",
                    "set magnification={number}, the smallest that fits, or largest-step if the "
                    "controller takes more")
                      .with("number", *fitting)
                : Text(AXISCOMP_TEXT("Error", "check detection-unit and the unit of the values")));
    }
    return {};
}

Result<void> PitchWriter::prepare()
{
    AXISCOMP_CHECK(findReference());
    AXISCOMP_CHECK(checkNumbers());
    AXISCOMP_CHECK(checkAmounts());
    AXISCOMP_CHECK(checkSteps());
    const std::vector<double> amounts = roundedAmounts(m_setup.magnification);
    const std::size_t sections = amounts.size() - 1;
    const std::size_t begin = m_axis.wrap ? static_cast<std::size_t>(m_knot) : 0;
    for (std::size_t i = 0; i < sections; ++i) {
        const std::size_t section = (begin + i) % sections;
        m_steps.push_back(std::llround(amounts[section + 1] - amounts[section]));
    }
    m_first = m_setup.reference + 1;
    if (m_axis.wrap) { // the last section of the turn is the one below the reference position, too
        --m_first;
        m_steps.insert(m_steps.begin(), m_steps.back());
    } else {
        m_first -= m_knot;
    }
    return {};
}

std::string PitchWriter::text() const
{
    std::string text = "%\n";
    for (std::size_t i = 0; i < m_steps.size(); ++i) {
        const std::int64_t number = m_setup.firstRecord + m_first + static_cast<std::int64_t>(i);
        text += 'N' + std::to_string(number) + 'P' + std::to_string(m_steps[i]) + '\n';
    }
    return text + "%\n";
}

Text PitchWriter::parameters() const
{
    return (m_axis.wrap ? AXISCOMP_TEXT("Error",
                "set the parameters of the axis: 3620 = {reference}, 3621 = {first}, 3622 = "
                "{last}, 3623 = {magnification}, 3624 = {interval}, 3625 = {turn}")
                        : AXISCOMP_TEXT("Error",
                            "set the parameters of the axis: 3620 = {reference}, 3621 = {first}, "
                            "3622 = {last}, 3623 = {magnification}, 3624 = {interval}"))
        .with("reference", m_setup.reference)
        .with("first", m_first)
        .with("last", m_first + static_cast<std::int64_t>(m_steps.size()) - 1)
        .with("magnification", m_setup.magnification)
        .with("interval", quantity(m_interval))
        .with("turn", quantity(m_axis.wrap.value_or(0.0)));
}

/// With what the file is read again.
FormatSettings readingSettings(const FormatSettings& given, const SourceAxis& axis, double interval)
{
    FormatSettings reading;
    for (const std::string_view key : {referenceNumberKey, detectionUnitKey, magnificationKey,
             referencePositionKey, firstRecordKey})
        if (const auto value = given.find(key); value != given.end())
            reading.insert(*value);
    reading[std::string(intervalKey)] = plainNumber(interval);
    if (axis.wrap)
        reading[std::string(wrapRangeKey)] = plainNumber(*axis.wrap);
    if (!axis.unit.empty())
        reading["position-unit"] = axis.unit;
    return reading;
}

/// What nobody has published, and what is to be done. given: what a person says of it is known.
void remark(const PitchWriter& writer, const PitchSetup& setup, std::int64_t largestStep,
    const FormatSettings& given, std::vector<Text>& remarks)
{
    if (writer.count() > usualNumbers)
        remarks.push_back(AXISCOMP_TEXT("Error",
            "these are {count} points, and one source says that an axis has at most {most}")
                              .with("count", writer.count())
                              .with("most", usualNumbers));
    remarks.push_back(writer.parameters());
    if (given.find(firstRecordKey) == given.end())
        remarks.push_back(AXISCOMP_TEXT("Error",
            "nobody has published that the numbers begin at line N{first} (first-record): compare "
            "with a file of this controller")
                              .with("first", setup.firstRecord));
    if (given.find(largestStepKey) == given.end())
        remarks.push_back(AXISCOMP_TEXT("Error",
            "nobody has published that a value is at most {most} (largest-step): compare with a "
            "file of this controller")
                              .with("most", largestStep));
    remarks.emplace_back(AXISCOMP_TEXT("Error",
        "the sign is an assumption: a value is put out to the axis as pulses. Check one point on "
        "the machine"));
    remarks.emplace_back(AXISCOMP_TEXT("Error",
        "where within its section a value is put out is not known: the correction is taken to be "
        "linear, and its place is in doubt by half an interval"));
    remarks.emplace_back(AXISCOMP_TEXT("Error",
        "after loading switch the power off and on and return to the reference point; alarm PW1102 "
        "says that the numbers do not fit"));
}

} // namespace

Result<WrittenTables> writeFile(
    const TableFormat& format, const NeutralTable& source, const FormatSettings& settings)
{
    const FormatFacts& facts = format.facts;
    AXISCOMP_CHECK(checkWrapRange(settings));
    AXISCOMP_TRY(const auto given, SettingValues::of(facts, settings, true));
    AXISCOMP_TRY(const auto setup, pitchSetup(facts, given));
    AXISCOMP_TRY(
        const auto largestStep, wholeBetween(facts, given, largestStepKey, 1, largestValue));
    WrittenTables written;
    AXISCOMP_TRY(auto table, asOwnAxisTable(facts, source, given, written.remarks));
    AXISCOMP_CHECK(takeWrapRange(table.axes.front(), given));
    if (table.axes.front().wrap)
        AXISCOMP_CHECK(checkOnePeriod(facts, table, 0, setup.amountOf(0.5)));
    PitchWriter writer(facts, setup, largestStep, table);
    AXISCOMP_CHECK(writer.prepare());
    written.bytes = writer.text();
    AXISCOMP_TRY(auto held,
        readBack(format, written.bytes,
            readingSettings(settings, table.axes.front(), writer.interval())));
    written.held = std::move(held);
    remark(writer, setup, largestStep, settings, written.remarks);
    return written;
}

} // namespace axiscomp::fanuc
