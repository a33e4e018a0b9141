// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/fanuc/pitch_data.h"
#include "core/formats/formats.h"
#include "core/formats/own_axis.h"
#include "core/formats/wrap_range.h"
#include "core/text/number_text.h"
#include "core/text/text_file.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>
#include <vector>

namespace axiscomp::fanuc {

namespace {

constexpr std::int64_t directionsParameter = 3605;
constexpr std::int64_t referenceParameter = 3620;
constexpr std::int64_t firstParameter = 3621;
constexpr std::int64_t lastParameter = 3622;
constexpr std::int64_t magnificationParameter = 3623;
constexpr std::int64_t intervalParameter = 3624;
constexpr std::int64_t turnParameter = 3625;

struct Value {
    std::int64_t steps = 0;
    std::size_t line = 0;
};

/// "N10033P2": the number behind N, and what follows it.
struct NumberedBlock {
    std::int64_t number = 0;
    Token rest;
};
std::optional<NumberedBlock> numberedBlock(const Token& block)
{
    if (!sameLetters(block.text.substr(0, 1), "N"))
        return std::nullopt;
    const Token behind = trimmedToken(block.part(1));
    const std::size_t end =
        std::min(behind.text.find_first_not_of("0123456789"), behind.text.size());
    const auto number = wholeNumberOf(behind.text.substr(0, end));
    if (!number)
        return std::nullopt;
    return NumberedBlock{*number, trimmedToken(behind.part(end))};
}

bool isValueLetter(char c)
{
    return c == 'P' || c == 'p';
}

/// Whether bit 0 of a parameter is set, for one axis or in one of several:
/// "A1P00000000A2P00000001".
bool hasBitZero(std::string_view values)
{
    for (std::size_t at = 0; at < values.size(); ++at) {
        if (!isValueLetter(values[at]))
            continue;
        const std::size_t end = std::min(values.find_first_not_of("01", at + 1), values.size());
        if (values[end - 1] == '1')
            return true;
    }
    return false;
}

/// The numbers of a parameter, one for each axis: "A1P40A2P0", or "P25.000" of one axis.
std::vector<std::string_view> axisNumbers(std::string_view values)
{
    std::vector<std::string_view> numbers;
    for (std::size_t at = 0; at < values.size(); ++at) {
        if (!isValueLetter(values[at]))
            continue;
        const std::size_t end =
            std::min(values.find_first_not_of("0123456789.+- ", at + 1), values.size());
        numbers.push_back(trimmed(values.substr(at + 1, end - at - 1)));
    }
    return numbers;
}

bool isNumber(std::string_view text, std::int64_t number)
{
    return numberOf(text) == static_cast<double>(number);
}

/// Without a decimal point it is in increments, whose unit the file does not say.
bool isInIncrements(std::string_view number)
{
    return number.find('.') == std::string_view::npos;
}

bool isAmount(std::string_view number, double amount)
{
    const auto said = numberOf(number);
    return said && std::abs(*said - amount) <= 1e-9 * std::abs(amount);
}

class PitchReader {
public:
    PitchReader(TextReading& reading, const PitchSetup& setup, const PitchSections& sections)
        : m_reading(reading)
        , m_setup(setup)
        , m_sections(sections)
    {
    }
    [[nodiscard]] std::vector<NeutralTable> read();

private:
    void scan();
    void takeBlock(const Token& block);
    void takeNumbered(const Token& block, const NumberedBlock& numbered);
    void takeParameter(const Token& block, const NumberedBlock& numbered);
    void takeValue(std::int64_t number, const Token& text);
    void checkEnd(std::size_t lines);
    [[nodiscard]] bool chooseNumbers();
    [[nodiscard]] bool checkParameters();
    [[nodiscard]] bool isOfAxis(std::size_t axis) const;
    [[nodiscard]] bool checkAmount(std::int64_t number, std::string_view key, double amount);
    [[nodiscard]] bool checkAmounts();
    [[nodiscard]] bool checkComplete();
    [[nodiscard]] bool checkTurn();
    [[nodiscard]] NeutralTable table();
    [[nodiscard]] std::int64_t steps(std::int64_t number) const
    {
        return m_values.at(number).steps;
    }

    TextReading& m_reading;
    DiagnosticList& m_diagnostics = m_reading.diagnostics;
    PitchSetup m_setup;
    PitchSections m_sections;
    bool m_isInRecord = false;
    bool m_hasRecord = false;
    bool m_hasOthers = false; ///< numbers above those of points were said
    std::int64_t m_first = 0;
    std::int64_t m_last = 0;
    std::map<std::int64_t, Value> m_values; ///< by number
    struct Parameter {
        std::vector<std::string_view> numbers; ///< of each axis
        std::size_t line = 0;
    };
    std::map<std::int64_t, Parameter> m_parameters; ///< by number
    std::map<std::int64_t, std::int64_t> m_expected; ///< what parameters of the axis must be
};

void PitchReader::takeValue(std::int64_t number, const Token& text)
{
    const auto steps = readWholeNumber(
        text, AXISCOMP_TEXT("Error", "a whole number of increments behind P"), m_diagnostics);
    if (!steps)
        return;
    if (*steps < -largestValue || *steps > largestValue) {
        m_diagnostics.error(DiagnosticCode::LimitExceeded, text.line, text.column, quoted(text),
            AXISCOMP_TEXT("Error", "at most {most}").with("most", largestValue));
        return;
    }
    const auto [at, isNew] = m_values.try_emplace(number, Value{*steps, text.line});
    if (isNew)
        return;
    at->second = {*steps, text.line};
    m_diagnostics.warning(DiagnosticCode::DuplicateValue, text.line, text.column,
        AXISCOMP_TEXT("Error", "value {number} again").with("number", number),
        AXISCOMP_TEXT("Error", "each value once; the last one counts"));
}

void PitchReader::takeParameter(const Token& block, const NumberedBlock& numbered)
{
    if (numbered.number == directionsParameter && hasBitZero(numbered.rest.text))
        m_diagnostics.error(DiagnosticCode::Contradiction, block.line, block.column,
            AXISCOMP_TEXT(
                "Error", "bit 0 of parameter 3605 is 1: values for each direction of motion"),
            AXISCOMP_TEXT("Error",
                "one value for both directions; leave the line out if it is of another axis"));
    auto numbers = axisNumbers(numbered.rest.text);
    if (!numbers.empty())
        m_parameters[numbered.number] = {std::move(numbers), block.line};
}

void PitchReader::takeNumbered(const Token& block, const NumberedBlock& numbered)
{
    const std::int64_t number = numbered.number - m_setup.firstRecord;
    if (number < 0) {
        takeParameter(block, numbered);
        return;
    }
    if (number >= mostNumbers) {
        if (!m_hasOthers)
            m_diagnostics.warning(DiagnosticCode::LeftOut, block.line, block.column,
                AXISCOMP_TEXT("Error", "line N{number}").with("number", numbered.number),
                AXISCOMP_TEXT("Error", "N{first} to N{last}, as the setting first-record says")
                    .with("first", m_setup.firstRecord)
                    .with("last", m_setup.firstRecord + mostNumbers - 1));
        m_hasOthers = true;
        return;
    }
    if (!numbered.rest || !isValueLetter(numbered.rest.text.front())) {
        m_diagnostics.error(DiagnosticCode::Syntax, block.line, block.column, quoted(block),
            AXISCOMP_TEXT("Error", "a line such as {example}")
                .with("example", Verbatim{"N10033P2"}));
        return;
    }
    takeValue(number, trimmedToken(numbered.rest.part(1)));
}

void PitchReader::takeBlock(const Token& block)
{
    if (block.text == "%") {
        m_isInRecord = !m_isInRecord;
        m_hasRecord = true;
        return;
    }
    const auto numbered = numberedBlock(block);
    const bool isComment = block.text.starts_with('(');
    if (m_isInRecord && numbered)
        takeNumbered(block, *numbered);
    else if (m_isInRecord && !isComment)
        m_diagnostics.error(DiagnosticCode::Syntax, block.line, block.column, quoted(block),
            AXISCOMP_TEXT("Error", "a line such as {example}")
                .with("example", Verbatim{"N10033P2"}));
    else if (numbered)
        m_diagnostics.error(DiagnosticCode::Syntax, block.line, block.column, quoted(block),
            AXISCOMP_TEXT("Error", "a line % in front of it"));
}

void PitchReader::checkEnd(std::size_t lines)
{
    if (m_diagnostics.hasErrors())
        return;
    if (m_isInRecord)
        m_diagnostics.error(DiagnosticCode::Syntax, lines, 0,
            AXISCOMP_TEXT("Error", "lines without an end"),
            AXISCOMP_TEXT("Error", "a line % behind the last one"));
    else if (!m_hasRecord)
        m_diagnostics.error(DiagnosticCode::Syntax, 0, 0, {},
            AXISCOMP_TEXT("Error", "lines such as {example} between two lines %")
                .with("example", Verbatim{"N10033P2"}));
}

void PitchReader::scan()
{
    TextLines lines(m_reading.text);
    std::vector<Token> blocks;
    std::size_t last = 0;
    while (const auto line = lines.next()) {
        if (m_reading.isStopped())
            return;
        last = line->line;
        splitCells(*line, ';', blocks); // the end of a block, where it is written
        for (const Token& block : blocks)
            if (block)
                takeBlock(block);
    }
    checkEnd(last);
}

/// The numbers of the axis: as settings say, or all that the file has.
bool PitchReader::chooseNumbers()
{
    if (m_values.empty() && !(m_sections.first && m_sections.last)) {
        m_diagnostics.error(DiagnosticCode::TooFewPoints, 0, 0,
            AXISCOMP_TEXT("Error", "no line from N{first} to N{last}")
                .with("first", m_setup.firstRecord)
                .with("last", m_setup.firstRecord + mostNumbers - 1),
            AXISCOMP_TEXT("Error",
                "pitch error data; the setting first-record says where their numbers begin"));
        return false;
    }
    m_first = m_sections.first ? *m_sections.first : m_values.begin()->first;
    m_last = m_sections.last ? *m_sections.last : m_values.rbegin()->first;
    const std::int64_t reference = m_setup.reference;
    if (m_first <= m_last && m_first <= reference + 1 && reference <= m_last)
        return true;
    m_diagnostics.error(DiagnosticCode::Contradiction, 0, 0,
        AXISCOMP_TEXT("Error", "the numbers {first} to {last} for the axis")
            .with("first", m_first)
            .with("last", m_last),
        AXISCOMP_TEXT("Error",
            "numbers round that of the reference point, {number}, as the setting {key} says")
            .with("number", reference)
            .with("key", referenceNumberKey));
    return false;
}

/// Whether the parameters of the axis with this place in the file are those of the settings.
bool PitchReader::isOfAxis(std::size_t axis) const
{
    return std::ranges::all_of(m_expected, [&](const auto& parameter) {
        const auto said = m_parameters.find(parameter.first);
        if (said == m_parameters.end())
            return true;
        const auto& numbers = said->second.numbers;
        return axis < numbers.size() && isNumber(numbers[axis], parameter.second);
    });
}

/// That one of the axes whose parameters are in the file is the one that the settings describe.
bool PitchReader::checkParameters()
{
    m_expected = {{referenceParameter, m_setup.reference},
        {firstParameter, m_sections.turn ? m_setup.reference : m_first}, {lastParameter, m_last},
        {magnificationParameter, m_setup.magnification}};
    std::size_t axes = 0;
    for (const auto& [number, value] : m_expected) {
        const auto said = m_parameters.find(number);
        if (said == m_parameters.end())
            continue;
        axes = std::max(axes, said->second.numbers.size());
        const auto isIt = [&](std::string_view text) { return isNumber(text, value); };
        if (std::ranges::any_of(said->second.numbers, isIt))
            continue;
        m_diagnostics.error(DiagnosticCode::Contradiction, said->second.line, 0,
            AXISCOMP_TEXT("Error", "parameter {number}, which is {value} for no axis")
                .with("number", number)
                .with("value", value),
            AXISCOMP_TEXT("Error",
                "the reference point, numbers and magnification of one axis, as the settings say"));
        return false;
    }
    bool isOne = axes == 0;
    for (std::size_t axis = 0; axis < axes; ++axis)
        isOne = isOne || isOfAxis(axis);
    const bool areChosen = (m_sections.first && m_sections.last) || m_sections.turn
        || (m_parameters.contains(firstParameter) && m_parameters.contains(lastParameter));
    if (isOne && (axes < 2 || areChosen))
        return true;
    m_diagnostics.error(DiagnosticCode::Contradiction,
        m_parameters.lower_bound(referenceParameter)->second.line, 0,
        AXISCOMP_TEXT(
            "Error", "parameters 3620 to 3623 of several axes, and numbers {first} to {last}")
            .with("first", m_first)
            .with("last", m_last),
        AXISCOMP_TEXT(
            "Error", "the numbers of one axis; first-number and last-number choose them"));
    return false;
}

/// That a parameter of the axis is what a setting says. One of 0 says nothing, such as that of an
/// axis without compensation.
bool PitchReader::checkAmount(std::int64_t number, std::string_view key, double amount)
{
    const auto said = m_parameters.find(number);
    std::vector<std::string_view> numbers;
    for (std::size_t axis = 0; said != m_parameters.end() && axis < said->second.numbers.size();
         ++axis)
        if (isOfAxis(axis) && numberOf(said->second.numbers[axis]) != 0.0)
            numbers.push_back(said->second.numbers[axis]);
    const auto isIt = [&](std::string_view text) {
        return !isInIncrements(text) && isAmount(text, amount);
    };
    if (numbers.empty() || std::ranges::any_of(numbers, isIt))
        return true;
    const auto unknown = std::ranges::find_if(numbers, isInIncrements);
    const bool isUnknown = unknown != numbers.end();
    const Text found = AXISCOMP_TEXT("Error", "parameter {number} of {value}")
                           .with("number", number)
                           .with("value", quoted(Token{isUnknown ? *unknown : numbers.front()}));
    if (isUnknown)
        m_diagnostics.warning(DiagnosticCode::Assumption, said->second.line, 0, found,
            AXISCOMP_TEXT("Error",
                "a number with a decimal point, to compare it with the setting {key} of {value}; "
                "the file does not say what unit it is in without one")
                .with("key", key)
                .with("value", Quantity{toText(amount)}));
    else
        m_diagnostics.error(DiagnosticCode::Contradiction, said->second.line, 0, found,
            AXISCOMP_TEXT("Error", "{value}, as the setting {key} says")
                .with("value", Quantity{toText(amount)})
                .with("key", key));
    return isUnknown;
}

bool PitchReader::checkAmounts()
{
    return checkAmount(intervalParameter, intervalKey, m_sections.interval)
        && (!m_sections.turn || checkAmount(turnParameter, wrapRangeKey, *m_sections.turn));
}

bool PitchReader::checkComplete()
{
    std::int64_t expected = m_first;
    for (auto at = m_values.lower_bound(m_first); expected <= m_last; ++at, ++expected) {
        if (at != m_values.end() && at->first == expected)
            continue;
        m_diagnostics.error(DiagnosticCode::MissingPoint,
            at == m_values.end() ? 0 : at->second.line, 0,
            AXISCOMP_TEXT("Error", "no value {number}").with("number", expected),
            (m_sections.turn ? AXISCOMP_TEXT("Error", "the numbers {first} to {last} of one turn")
                             : AXISCOMP_TEXT("Error",
                                 "each number from {first} to {last}; first-number and last-number "
                                 "choose those of one axis"))
                .with("first", m_first)
                .with("last", m_last));
        return false;
    }
    const auto count = static_cast<std::size_t>(m_last - m_first + 1);
    if (count > usualNumbers)
        m_diagnostics.warning(DiagnosticCode::LimitExceeded, 0, 0,
            AXISCOMP_COUNTED("Error", "{count} points", "1 point").with("count", count),
            AXISCOMP_TEXT("Error", "at most {most} of an axis, as one source says")
                .with("most", usualNumbers));
    return true;
}

/// Of a rotary axis the values of a turn add up to 0, and the number of the reference point stands
/// for the last section once more.
bool PitchReader::checkTurn()
{
    std::int64_t sum = 0;
    for (std::int64_t number = m_first; number <= m_last; ++number)
        sum += steps(number);
    if (sum != 0) {
        m_diagnostics.error(DiagnosticCode::NotPeriodic, m_values.at(m_last).line, 0,
            AXISCOMP_TEXT("Error", "the values {first} to {last}, which add up to {sum}")
                .with("first", m_first)
                .with("last", m_last)
                .with("sum", sum),
            AXISCOMP_TEXT("Error", "0 over one turn"));
        return false;
    }
    const auto reference = m_values.find(m_setup.reference);
    if (reference != m_values.end() && reference->second.steps == steps(m_last))
        return true;
    m_diagnostics.error(
        reference == m_values.end() ? DiagnosticCode::MissingPoint : DiagnosticCode::NotPeriodic,
        m_values.at(reference == m_values.end() ? m_last : m_setup.reference).line, 0,
        AXISCOMP_TEXT("Error", "value {number}, of the reference point")
            .with("number", m_setup.reference),
        AXISCOMP_TEXT("Error", "the same as value {number}, which is the same section")
            .with("number", m_last));
    return false;
}

NeutralTable PitchReader::table()
{
    NeutralTable table;
    table.sign = SignConvention::Command;
    SourceAxis& axis = table.axes.emplace_back();
    std::vector<double>& values = table.columns.emplace_back().values;
    const std::int64_t below = m_setup.reference - m_first + 1;
    std::int64_t sum = 0; // at the lower end, so that it is 0 at the reference position
    for (std::int64_t k = 0; k < below; ++k)
        sum -= steps(m_setup.reference - k);
    for (std::int64_t k = -below;; ++k) {
        axis.knots.push_back(m_setup.position + static_cast<double>(k) * m_sections.interval);
        values.push_back(sum == 0 ? 0.0 : m_setup.amountOf(static_cast<double>(sum)));
        const std::int64_t number = m_first + k + below;
        if (number > m_last)
            break;
        sum += steps(number);
    }
    if (m_sections.turn) {
        axis.wrap = *m_sections.turn;
        axis.knots.back() = axis.knots.front() + *m_sections.turn;
    }
    takeOneUnit(table, m_reading.settings, m_diagnostics);
    return table;
}

std::vector<NeutralTable> PitchReader::read()
{
    scan();
    if (m_reading.isStopped() || m_diagnostics.hasErrors() || !chooseNumbers() || !checkParameters()
        || !checkAmounts() || !checkComplete() || (m_sections.turn && !checkTurn()))
        return {};
    return {table()};
}

std::vector<NeutralTable> parsePitchData(TextReading& reading)
{
    const FormatFacts& facts = fanuc::format().facts;
    const auto setup = pitchSetup(facts, reading.settings);
    const auto sections = setup ? pitchSections(facts, *setup, reading.settings)
                                : Result<PitchSections>(fail(setup.error()));
    if (!sections) // readFile has looked
        return {};
    return PitchReader(reading, *setup, *sections).read();
}

} // namespace

Result<TableReading> readFile(
    const TableFormat& format, std::string_view text, const TableReadOptions& options)
{
    AXISCOMP_CHECK(checkWrapRange(options.settings));
    AXISCOMP_TRY(const auto settings, SettingValues::of(format.facts, options.settings, false));
    AXISCOMP_TRY(const auto setup, pitchSetup(format.facts, settings));
    AXISCOMP_CHECK(pitchSections(format.facts, setup, settings));
    return readText(format.facts, text, options, parsePitchData);
}

} // namespace axiscomp::fanuc
