// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/formats/measurement_csv.h"
#include "core/metrology/formats/measurement_formats.h"
#include "core/metrology/formats/run_assembly.h"
#include "core/text/token_scanner.h"
#include "core/text/utf8.h"

#include <algorithm>
#include <array>
#include <map>
#include <set>

namespace axiscomp::ecmc_data {

namespace {

constexpr std::array<std::string_view, 2> extensions{".data", ".txt"};
constexpr std::array kinds{MeasurementKind::Runs};
constexpr std::array<std::string_view, 3> rules{
    "Lines TGT_DATA[i]= with the targets, REF_DATA_FWD[i,j]= and REF_DATA_BWD[i,j]= with the "
    "positions of the reference at target i in cycle j, from 1. FWD is up.",
    "UNIT= says the unit, mm without it. CYCLES= and POSITIONS= must agree with what is there.",
    "Other KEY= lines become notes; lines with # are comments.",
};

/// "REF_DATA_FWD[1,2]": the name and its numbers.
struct Key {
    std::string_view name;
    std::vector<std::int64_t> indices;
};

std::optional<Key> keyOf(std::string_view text)
{
    const std::size_t open = text.find('[');
    if (open == std::string_view::npos)
        return Key{text, {}};
    if (!text.ends_with(']'))
        return std::nullopt;
    Key key{trimmed(text.substr(0, open)), {}};
    std::vector<Token> parts;
    splitCells({text.substr(open + 1, text.size() - open - 2), 1, 1}, ',', parts);
    constexpr std::int64_t most = 1'000'000;
    for (const Token& part : parts) {
        const auto index = wholeNumberOf(part.text);
        if (!index || *index < 1 || *index > most)
            return std::nullopt;
        key.indices.push_back(*index);
    }
    return key;
}

struct Reading {
    std::int64_t target = 0;
    std::int64_t cycle = 0;
    double position = 0.0;
    Approach direction = Approach::Up;
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

    void takeLine(const Token& line);
    [[nodiscard]] std::vector<RawRunValue> values();

private:
    void takeReference(const Key& key, const Token& value, Approach direction);
    void takeTarget(const Key& key, const Token& value);
    void takeOther(const Token& line, const Key& key, const Token& value);
    void refuseKey(const Token& line);
    void checkCount(
        const std::optional<std::int64_t>& said, std::size_t found, std::string_view key);

    Measurement& m_measurement;
    const MeasurementReadOptions& m_options;
    DiagnosticList& m_diagnostics;
    Encoding m_encoding;
    std::map<std::int64_t, double> m_targets;
    std::vector<Reading> m_readings;
    std::string m_unit = "mm";
    std::optional<std::int64_t> m_cycles;
    std::optional<std::int64_t> m_positions;
};

void Reader::takeLine(const Token& line)
{
    const Token content = trimmedToken(withoutComment(line, "#"));
    // The first line of a file may be a shell variable with the comment behind it.
    if (!content || content.text.starts_with("TEST_DATA="))
        return;
    const std::size_t equals = content.text.find('=');
    const auto key = keyOf(trimmed(content.text.substr(0, equals)));
    if (!key || equals == std::string_view::npos) {
        refuseKey(content);
        return;
    }
    const Token value = trimmedToken(content.part(equals + 1));
    if (key->name == "TGT_DATA")
        takeTarget(*key, value);
    else if (key->name == "REF_DATA_FWD")
        takeReference(*key, value, Approach::Up);
    else if (key->name == "REF_DATA_BWD")
        takeReference(*key, value, Approach::Down);
    else
        takeOther(content, *key, value);
}

void Reader::refuseKey(const Token& line)
{
    m_diagnostics.error(DiagnosticCode::Syntax, line.line, line.column,
        Verbatim{excerpt(line.text, m_encoding)},
        AXISCOMP_TEXT("Error", "TGT_DATA[i]=, REF_DATA_FWD[i,j]=, REF_DATA_BWD[i,j]= or KEY="));
}

void Reader::takeTarget(const Key& key, const Token& value)
{
    if (key.indices.size() != 1) {
        refuseKey(value);
        return;
    }
    const auto target =
        readNumber(value, AXISCOMP_TEXT("Error", "the position of a target"), m_diagnostics);
    if (target && !m_targets.emplace(key.indices.front(), *target).second)
        m_diagnostics.error(DiagnosticCode::Contradiction, value.line, 0,
            AXISCOMP_TEXT("Error", "a second target {number}").with("number", key.indices.front()),
            AXISCOMP_TEXT("Error", "each target once"));
}

void Reader::takeReference(const Key& key, const Token& value, Approach direction)
{
    if (key.indices.size() != 2) {
        refuseKey(value);
        return;
    }
    const auto position =
        readNumber(value, AXISCOMP_TEXT("Error", "a position of the reference"), m_diagnostics);
    if (position)
        m_readings.push_back({key.indices[0], key.indices[1], *position, direction, value.line});
}

void Reader::takeOther(const Token& line, const Key& key, const Token& value)
{
    const Text whole = AXISCOMP_TEXT("Error", "a whole number");
    if (sameLetters(key.name, "UNIT")) {
        m_unit = std::string(value.text);
    } else if (key.name == "CYCLES") {
        m_cycles = readWholeNumber(value, whole, m_diagnostics);
    } else if (key.name == "POSITIONS") {
        m_positions = readWholeNumber(value, whole, m_diagnostics);
    } else {
        constexpr std::size_t mostNotes = 1000;
        if (m_measurement.notes.size() < mostNotes)
            m_measurement.notes.push_back(shownText(toUtf8(line.text, m_encoding), 1000));
    }
}

void Reader::checkCount(
    const std::optional<std::int64_t>& said, std::size_t found, std::string_view key)
{
    if (said && *said != static_cast<std::int64_t>(found))
        m_diagnostics.error(DiagnosticCode::CountMismatch, 0, 0,
            AXISCOMP_TEXT("Error", "{key}: {said}, but {found} are there")
                .with("key", key)
                .with("said", *said)
                .with("found", found),
            AXISCOMP_TEXT("Error", "the whole file"));
}

std::vector<RawRunValue> Reader::values()
{
    std::set<std::int64_t> cycles;
    for (const Reading& reading : m_readings)
        cycles.insert(reading.cycle);
    checkCount(m_positions, m_targets.size(), "POSITIONS");
    checkCount(m_cycles, cycles.size(), "CYCLES");
    const auto unit = unitOfFormat("targets", m_options.unit, m_unit, m_measurement, m_diagnostics);
    const auto valueUnit = m_options.valueUnit.empty()
        ? unit
        : unitOfFormat("values", m_options.valueUnit, m_unit, m_measurement, m_diagnostics);
    if (!unit || !valueUnit || !areSameKind(*unit, *valueUnit, m_diagnostics))
        return {};
    m_measurement.isAngular = unit->isAngular;
    for (const auto& [number, target] : m_targets)
        m_measurement.targets.push_back(target * unit->factor);
    std::vector<RawRunValue> values;
    for (const Reading& reading : m_readings) {
        const auto target = m_targets.find(reading.target);
        if (target == m_targets.end()) {
            m_diagnostics.error(DiagnosticCode::UnknownTargetNumber, reading.line, 0,
                Verbatim{std::to_string(reading.target)},
                AXISCOMP_TEXT("Error", "the number of a target, TGT_DATA[{number}]=")
                    .with("number", reading.target));
            continue;
        }
        RawRunValue raw;
        raw.target = target->second * unit->factor;
        raw.reference = reading.position * valueUnit->factor;
        raw.value.direction = reading.direction;
        raw.value.run = static_cast<int>(reading.cycle);
        raw.value.line = reading.line;
        values.push_back(raw);
    }
    return values;
}

MeasurementRecognition recognise(std::string_view text)
{
    TextLines lines(text);
    while (const auto line = lines.next())
        if (trimmed(line->text).starts_with("TGT_DATA["))
            return MeasurementRecognition::Certain;
    return MeasurementRecognition::No;
}

} // namespace

const MeasurementFormat& format()
{
    static const MeasurementFormat format{
        .facts = {.name = "ecmc",
            .origin = "ecmc (EtherCAT motion control for EPICS)",
            .description = AXISCOMP_TEXT("Error", "data of an ISO 230-2 test"),
            .extensions = extensions,
            .kinds = kinds,
            .rules = rules},
        .recognise = recognise,
        .read = readRuns<valuesByLine<Reader>>};
    return format;
}

} // namespace axiscomp::ecmc_data
