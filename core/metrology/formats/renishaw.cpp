// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/system.h"
#include "core/metrology/formats/measurement_csv.h"
#include "core/metrology/formats/measurement_formats.h"
#include "core/metrology/formats/run_assembly.h"
#include "core/text/decimal_comma.h"
#include "core/text/token_scanner.h"
#include "core/text/utf8.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <initializer_list>
#include <map>
#include <numbers>
#include <set>

namespace axiscomp::renishaw {

namespace {

constexpr std::array<std::string_view, 2> extensions{".rtl", ".rta"};
constexpr std::array kinds{MeasurementKind::Runs};
constexpr std::array<std::string_view, 6> rules{
    "Sections begin with a line NAME::, and every section ends the one before it. TARGET DATA:: "
    "has "
    "Target-count and Targets, RUNS:: has Run-count, DEVIATIONS:: has lines of run, number of the "
    "target and deviation. USER-TEXT:: and ENVIRONMENT:: become statements and notes.",
    "A file of the type rtl has targets in mm and deviations in um, one of the type rta targets in "
    "degrees and deviations in milliradians.",
    "Targets rise or fall throughout. A comma between two digits is taken for a separator only "
    "where "
    "Target-count says so, since it may be a decimal comma.",
    "The direction of a run is that of its target numbers: rising is up. Runs are counted for each "
    "direction. A bidirectional file (Flags: 0 0 2 0) whose runs all go one way gets a warning.",
    "Texts are UTF-8, else GBK where every byte above ASCII has a second one, else Windows-1252.",
    "Runs against the direction of a unidirectional file (Flags: 0 1 2 0) that are exactly 0 are "
    "left out.",
};
constexpr std::array<std::string_view, 2> assumptions{
    "A deviation is the measured position minus the target.",
    "Flags are kept as a note; nothing is known of them but 0 0 2 0 for bidirectional and 0 1 2 0 "
    "for unidirectional files.",
};

/// "TARGET DATA::" is "TARGET DATA": blanks and letters, then two colons.
std::optional<std::string_view> sectionName(std::string_view line)
{
    const std::string_view text = trimmed(line);
    if (text.size() < 3 || !text.ends_with("::"))
        return std::nullopt;
    const std::string_view name = text.substr(0, text.size() - 2);
    const bool isName = std::ranges::all_of(name, [](char c) {
        return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == ' ' || c == '-';
    });
    return isName ? std::optional(trimmed(name)) : std::nullopt;
}

/// Chinese text as programs on Windows write it (GB 2312, part of GBK): bytes from 0xA1 on that
/// come in pairs. In Western text a byte above ASCII mostly stands alone.
bool isChinese(std::string_view text)
{
    std::size_t pairs = 0;
    for (std::size_t i = 0; i < text.size(); ++i) {
        if (static_cast<unsigned char>(text[i]) < 0x80)
            continue;
        const bool isPair = i + 1 < text.size() && static_cast<unsigned char>(text[i]) >= 0xA1
            && static_cast<unsigned char>(text[i + 1]) >= 0xA1;
        if (!isPair)
            return false;
        ++i;
        ++pairs;
    }
    return pairs > 0;
}

/// "Target-count: 9": the key, and where its value stands.
struct Entry {
    std::string_view key;
    Token value;
};
std::optional<Entry> entryOf(const Token& line)
{
    const std::size_t colon = line.text.find(':');
    if (colon == std::string_view::npos)
        return std::nullopt;
    return Entry{trimmed(line.text.substr(0, colon)), trimmedToken(line.part(colon + 1))};
}

bool areFlags(const std::vector<Token>& flags, std::initializer_list<std::string_view> expected)
{
    return std::ranges::equal(flags, expected, {}, &Token::text);
}

/// A line of DEVIATIONS.
struct Deviation {
    std::int64_t run = 0;
    std::size_t target = 0; ///< from 0
    double value = 0.0; ///< as it stands in the file
    std::size_t line = 0;
};

class Reader {
public:
    Reader(Measurement& measurement, const MeasurementReadOptions& options,
        DiagnosticList& diagnostics, Encoding encoding)
        : m_measurement(measurement)
        , m_options(options)
        , m_diagnostics(diagnostics)
        , m_encoding(encoding)
    {
    }

    void run(std::string_view text);

private:
    void warnOfFurtherSections(TextLines& lines);
    void takeLine(const Token& line);
    void takeHeader(const Token& line);
    void takeTargets(const Token& line);
    void takeNumbers(const Token& text);
    void takeUserText(const Token& line);
    void takeDeviation(const Token& line);
    void checkCounts();
    void checkTargets();
    void checkDirections(const std::array<int, 2>& counts);
    void checkCount(const std::optional<std::int64_t>& said, std::size_t found,
        std::string_view key, std::size_t line);
    [[nodiscard]] std::optional<std::int64_t> count(const Token& value);
    void dropEmptyRuns(std::map<std::int64_t, std::vector<Deviation>>& runs);
    [[nodiscard]] std::optional<Approach> directionOf(const std::vector<Deviation>& run);
    [[nodiscard]] std::vector<RawRunValue> values();
    void note(std::string_view text);

    Measurement& m_measurement;
    const MeasurementReadOptions& m_options;
    DiagnosticList& m_diagnostics;
    Encoding m_encoding;
    std::string m_section;
    std::string m_type;
    bool m_isInTargets = false; ///< numbers may follow on the next lines
    bool m_hasDeviations = false;
    bool m_isUnidirectional = false;
    bool m_isBidirectional = false;
    std::optional<std::int64_t> m_targetCount;
    std::size_t m_targetCountLine = 0;
    std::optional<std::int64_t> m_runCount;
    std::size_t m_runCountLine = 0;
    std::vector<double> m_targets;
    std::size_t m_targetsLine = 0; ///< the first of them
    Token m_doubtfulTarget; ///< with a comma between digits; empty: none
    std::vector<Deviation> m_deviations;
};

void Reader::note(std::string_view text)
{
    constexpr std::size_t mostNotes = 1000;
    const std::string shown = shownText(toUtf8(trimmed(text), m_encoding), 1000);
    if (!shown.empty() && m_measurement.notes.size() < mostNotes)
        m_measurement.notes.push_back(shown);
}

void Reader::takeLine(const Token& line)
{
    if (const auto name = sectionName(line.text)) {
        m_section = std::string(*name);
        m_isInTargets = false;
        return;
    }
    const Token content = trimmedToken(line);
    if (!content)
        return;
    if (sameLetters(m_section, "HEADER"))
        takeHeader(content);
    else if (sameLetters(m_section, "TARGET DATA"))
        takeTargets(content);
    else if (sameLetters(m_section, "USER-TEXT"))
        takeUserText(content);
    else if (sameLetters(m_section, "RUNS")) {
        const auto entry = entryOf(content);
        if (entry && sameLetters(entry->key, "Run-count")) {
            m_runCount = count(entry->value);
            m_runCountLine = content.line;
        }
    } else if (sameLetters(m_section, "DEVIATIONS"))
        takeDeviation(content);
    else if (sameLetters(m_section, "ENVIRONMENT")) {
        const auto entry = entryOf(content);
        const auto number = entry ? numberOf(entry->value.text) : std::nullopt;
        if (entry && sameLetters(entry->key, "Air temp") && number
            && isPossibleTemperature(*number))
            m_measurement.header.airTemperature = number;
        note(content.text);
    }
}

void Reader::takeHeader(const Token& line)
{
    const auto entry = entryOf(line);
    if (entry && sameLetters(entry->key, "File type"))
        m_type = std::string(entry->value.text);
    else
        note(line.text);
}

std::optional<std::int64_t> Reader::count(const Token& value)
{
    return readWholeNumber(value, AXISCOMP_TEXT("Error", "a whole number"), m_diagnostics);
}

void Reader::takeTargets(const Token& line)
{
    const auto entry = entryOf(line);
    if (!entry) {
        if (m_isInTargets)
            takeNumbers(line);
        return;
    }
    m_isInTargets = sameLetters(entry->key, "Targets");
    if (m_isInTargets) {
        takeNumbers(entry->value);
    } else if (sameLetters(entry->key, "Target-count")) {
        m_targetCount = count(entry->value);
        m_targetCountLine = line.line;
    } else {
        std::vector<Token> flags;
        splitTokens(entry->value, " \t", flags);
        if (sameLetters(entry->key, "Flags")) {
            m_isUnidirectional = flags.size() > 1 && flags[1].text == "1";
            m_isBidirectional = areFlags(flags, {"0", "0", "2", "0"});
        }
        note(line.text);
    }
}

void Reader::takeNumbers(const Token& text)
{
    if (m_targetsLine == 0)
        m_targetsLine = text.line;
    std::vector<Token> tokens;
    splitTokens(text, " \t", tokens);
    for (const Token& token : tokens)
        if (!m_doubtfulTarget && commasBetweenDigits(token.text) > 0)
            m_doubtfulTarget = token;
    splitTokens(text, " \t,", tokens);
    for (const Token& token : tokens)
        if (const auto target = readNumber(
                token, AXISCOMP_TEXT("Error", "the position of a target"), m_diagnostics))
            m_targets.push_back(*target);
}

void Reader::takeUserText(const Token& line)
{
    const auto entry = entryOf(line);
    if (!entry || !entry->value) {
        return;
    }
    const std::string value = shownText(toUtf8(entry->value.text, m_encoding), 200);
    MeasurementHeader& header = m_measurement.header;
    if (sameLetters(entry->key, "Machine"))
        header.machine = value;
    else if (sameLetters(entry->key, "Serial No"))
        header.serial = value;
    else if (sameLetters(entry->key, "Date"))
        header.date = value;
    else if (sameLetters(entry->key, "By"))
        header.operatorName = value;
    else if (sameLetters(entry->key, "Axis"))
        header.axis = value;
    else
        note(line.text);
}

void Reader::takeDeviation(const Token& line)
{
    if (line.text.starts_with("Run Target Data")) {
        m_hasDeviations = true;
        return;
    }
    std::vector<Token> tokens;
    splitTokens(line, " \t", tokens);
    if (tokens.size() != 3) {
        m_diagnostics.error(DiagnosticCode::Syntax, line.line, line.column,
            Verbatim{excerpt(line.text, m_encoding)},
            AXISCOMP_TEXT("Error", "run, number of the target and deviation, such as 1 1 0.21"));
        return;
    }
    const auto run = count(tokens[0]);
    const auto target = count(tokens[1]);
    const auto value = readNumber(tokens[2], AXISCOMP_TEXT("Error", "a deviation"), m_diagnostics);
    if (!run || !target || !value)
        return;
    if (*run < 1) {
        m_diagnostics.error(DiagnosticCode::BadRun, line.line, tokens[0].column,
            Verbatim{std::string(tokens[0].text)}, AXISCOMP_TEXT("Error", "a whole number from 1"));
        return;
    }
    if (*target < 1 || static_cast<std::size_t>(*target) > m_targets.size()) {
        m_diagnostics.error(DiagnosticCode::UnknownTargetNumber, line.line, tokens[1].column,
            Verbatim{std::string(tokens[1].text)},
            AXISCOMP_COUNTED(
                "Error", "a number from 1 to {count}, as there are targets", "1, the only target")
                .with("count", m_targets.size()));
        return;
    }
    m_deviations.push_back({*run, static_cast<std::size_t>(*target) - 1, *value, line.line});
}

void Reader::checkCount(const std::optional<std::int64_t>& said, std::size_t found,
    std::string_view key, std::size_t line)
{
    if (said && *said != static_cast<std::int64_t>(found))
        m_diagnostics.error(DiagnosticCode::CountMismatch, line, 0,
            AXISCOMP_TEXT("Error", "{key}: {said}, but {found} are there")
                .with("key", key)
                .with("said", *said)
                .with("found", found),
            AXISCOMP_TEXT("Error", "the whole file; save it again from the instrument's software"));
}

void Reader::checkCounts()
{
    std::set<std::int64_t> runs;
    for (const Deviation& deviation : m_deviations)
        runs.insert(deviation.run);
    checkCount(m_targetCount, m_targets.size(), "Target-count", m_targetCountLine);
    checkCount(m_runCount, runs.size(), "Run-count", m_runCountLine);
    if (!sameLetters(m_type, "rtl") && !sameLetters(m_type, "rta"))
        m_diagnostics.error(DiagnosticCode::Syntax, 0, 0, Verbatim{excerpt(m_type, m_encoding)},
            AXISCOMP_TEXT("Error", "File type: rtl or rta, which says the units"));
    if (m_targets.empty() || !m_hasDeviations)
        m_diagnostics.error(DiagnosticCode::Syntax, 0, 0, {},
            AXISCOMP_TEXT("Error", "sections TARGET DATA:: and DEVIATIONS:: with their numbers"));
}

/// A list that was read wrongly shows by its order, or by targets without a value.
void Reader::checkTargets()
{
    if (m_targets.empty())
        return;
    if (m_doubtfulTarget && !m_targetCount)
        m_diagnostics.error(DiagnosticCode::Syntax, m_doubtfulTarget.line, m_doubtfulTarget.column,
            Verbatim{excerpt(m_doubtfulTarget.text, m_encoding)},
            AXISCOMP_TEXT("Error",
                "positions with a decimal point and blanks between them; without a Target-count "
                "nobody can tell two positions from one with a decimal comma"));
    std::size_t used = 0;
    for (const Deviation& deviation : m_deviations)
        used = std::max(used, deviation.target + 1);
    if (!m_targetCount && m_hasDeviations && used != m_targets.size())
        m_diagnostics.error(DiagnosticCode::CountMismatch, m_targetsLine, 0,
            AXISCOMP_TEXT("Error", "{found} targets, but deviations of {used}")
                .with("found", m_targets.size())
                .with("used", used),
            AXISCOMP_TEXT("Error", "a deviation of every target, or a Target-count"));
    const bool isRising =
        std::ranges::adjacent_find(m_targets, std::ranges::greater_equal{}) == m_targets.end();
    const bool isFalling =
        std::ranges::adjacent_find(m_targets, std::ranges::less_equal{}) == m_targets.end();
    if (!isRising && !isFalling)
        m_diagnostics.error(DiagnosticCode::Syntax, m_targetsLine, 0, {},
            AXISCOMP_TEXT("Error",
                "positions of targets that rise or fall throughout, with a decimal point and "
                "blanks between them"));
}

/// Lines that were sorted by target all seem to be approached in one direction.
void Reader::checkDirections(const std::array<int, 2>& counts)
{
    if (m_isBidirectional && (counts[0] == 0) != (counts[1] == 0))
        m_diagnostics.warning(DiagnosticCode::DirectionsDoubtful, 0, 0,
            AXISCOMP_TEXT("Error",
                "every run goes {direction}, in a file of both directions (Flags: 0 0 2 0)")
                .with("direction", approachText(counts[0] > 0 ? Approach::Up : Approach::Down)),
            AXISCOMP_TEXT("Error",
                "the lines of each run in the order in which they were measured; sorted by target "
                "they all seem to rise"));
}

/// A program that writes such files fills the returns of a unidirectional measurement with 0.
void Reader::dropEmptyRuns(std::map<std::int64_t, std::vector<Deviation>>& runs)
{
    if (!m_isUnidirectional)
        return;
    const std::size_t dropped = std::erase_if(runs, [](const auto& entry) {
        return entry.first % 2 == 0 && std::ranges::all_of(entry.second, [](const Deviation& one) {
            return one.value == 0.0;
        });
    });
    if (dropped > 0)
        m_diagnostics.warning(DiagnosticCode::LeftOut, 0, 0,
            AXISCOMP_COUNTED("Error",
                "{count} runs of a unidirectional file that are exactly 0 throughout",
                "1 run of a unidirectional file that is exactly 0 throughout")
                .with("count", dropped),
            {});
}

/// By the order of the lines of a run.
std::optional<Approach> Reader::directionOf(const std::vector<Deviation>& run)
{
    std::size_t rising = 0;
    std::size_t falling = 0;
    for (std::size_t i = 1; i < run.size(); ++i) {
        rising += run[i].target > run[i - 1].target ? 1 : 0;
        falling += run[i].target < run[i - 1].target ? 1 : 0;
    }
    if (run.size() > 1 && rising == run.size() - 1)
        return Approach::Up;
    if (run.size() > 1 && falling == run.size() - 1)
        return Approach::Down;
    m_diagnostics.error(DiagnosticCode::BadDirection, run.front().line, 0,
        Verbatim{std::to_string(run.front().run)},
        AXISCOMP_TEXT("Error", "a run whose target numbers rise or fall throughout"));
    return std::nullopt;
}

std::vector<RawRunValue> Reader::values()
{
    const bool isRta = sameLetters(m_type, "rta");
    const auto targetUnit =
        unitOfFormat("targets", m_options.unit, isRta ? "deg" : "mm", m_measurement, m_diagnostics);
    const auto valueUnit = unitOfFormat(
        "values", m_options.valueUnit, isRta ? "mrad" : "um", m_measurement, m_diagnostics);
    if (!targetUnit || !valueUnit || !areSameKind(*targetUnit, *valueUnit, m_diagnostics))
        return {};
    m_measurement.isAngular = targetUnit->isAngular;
    const double ofType = isRta ? 1e-3 * 180.0 / std::numbers::pi : 1e-3;
    const double factor = m_options.valueUnit.empty() ? ofType : valueUnit->factor;
    for (const double target : m_targets)
        m_measurement.targets.push_back(target * targetUnit->factor);
    // Targets whose order falls with their number turn every run round.
    const bool isFalling = m_targets.size() > 1 && m_targets.back() < m_targets.front();
    std::map<std::int64_t, std::vector<Deviation>> runs;
    for (const Deviation& deviation : m_deviations)
        runs[deviation.run].push_back(deviation);
    dropEmptyRuns(runs);
    std::array<int, 2> counts{};
    std::vector<RawRunValue> values;
    for (const auto& [number, run] : runs) {
        const auto order = directionOf(run);
        if (!order)
            continue;
        const Approach direction =
            (*order == Approach::Up) != isFalling ? Approach::Up : Approach::Down;
        const int count = ++counts[static_cast<std::size_t>(direction)];
        for (const Deviation& deviation : run) {
            RawRunValue raw;
            raw.target = m_targets[deviation.target] * targetUnit->factor;
            raw.value.direction = direction;
            raw.value.run = count;
            raw.value.deviation = deviation.value * factor;
            raw.value.line = deviation.line;
            values.push_back(raw);
        }
    }
    if (!m_diagnostics.hasErrors())
        checkDirections(counts);
    return values;
}

/// Programs that append a measurement to the file of another.
void Reader::warnOfFurtherSections(TextLines& lines)
{
    while (const auto line = lines.next()) {
        const auto name = sectionName(line->text);
        if (!name || sameLetters(*name, "EOF"))
            continue;
        m_diagnostics.warning(DiagnosticCode::LeftOut, line->line, 0,
            AXISCOMP_TEXT("Error", "further sections behind EOF::"),
            AXISCOMP_TEXT("Error", "one measurement in a file; make a file of each"));
        return;
    }
}

void Reader::run(std::string_view text)
{
    TextLines lines(text);
    while (const auto line = lines.next()) {
        if (m_options.stop.stop_requested())
            return;
        takeLine(*line);
        if (sameLetters(m_section, "EOF"))
            break;
    }
    warnOfFurtherSections(lines);
    checkCounts();
    checkTargets();
    if (!m_diagnostics.hasErrors())
        assembleRuns(values(), m_options, m_measurement, m_diagnostics);
}

void parse(std::string_view text, const MeasurementReadOptions& options, Measurement& measurement,
    DiagnosticList& diagnostics)
{
    measurement.kind = MeasurementKind::Runs;
    if (findInvalidUtf8(text) != std::string_view::npos && isChinese(text)) {
        if (const auto utf8 = system::fromGbk(text)) {
            parse(*utf8, options, measurement, diagnostics);
            return;
        }
    }
    const TextInspection inspection(text, options.stop, diagnostics);
    if (!diagnostics.hasErrors())
        Reader(measurement, options, diagnostics, inspection.encoding()).run(inspection.body());
}

MeasurementReading read(std::string_view text, const MeasurementReadOptions& options)
{
    return readMeasurementText(text, options, parse);
}

MeasurementRecognition recognise(std::string_view text)
{
    TextLines lines(text);
    bool hasTargets = false;
    while (const auto line = lines.next()) {
        const auto name = sectionName(line->text);
        hasTargets = hasTargets || (name && sameLetters(*name, "TARGET DATA"));
        if (hasTargets && name && (sameLetters(*name, "DEVIATIONS") || sameLetters(*name, "RUNS")))
            return MeasurementRecognition::Certain;
    }
    return hasTargets ? MeasurementRecognition::Possible : MeasurementRecognition::No;
}

} // namespace

const MeasurementFormat& format()
{
    static const MeasurementFormat format{
        .facts = {.name = "renishaw",
            .origin = "Renishaw laser software",
            .description = AXISCOMP_TEXT("Error", "linear and angular measurements (.rtl, .rta)"),
            .extensions = extensions,
            .kinds = kinds,
            .rules = rules,
            .assumptions = assumptions},
        .recognise = recognise,
        .read = read};
    return format;
}

} // namespace axiscomp::renishaw
