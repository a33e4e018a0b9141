// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/formats/measurement_csv.h"
#include "core/metrology/formats/measurement_formats.h"
#include "core/metrology/formats/run_assembly.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>

namespace axiscomp::runs_csv {

namespace {

constexpr std::array<std::string_view, 1> extensions{".csv"};
constexpr std::array kinds{MeasurementKind::Runs, MeasurementKind::Averages};
constexpr std::array<std::string_view, 7> rules{
    "One line for each value, in any order. Columns by name, in capital or small letters: target; "
    "direction (+ or -, up or down, fwd or bwd, forward or backward, positive or negative, 1 or "
    "-1); run or cycle; and either deviation (also error or value) or reference (also actual or "
    "measured).",
    "Further columns: encoder (the raw position), output (what the drive added), axis (the same in "
    "every line), time (in s, ms, "
    "min or h as its brackets say, s without; or ISO 8601), temperature (in C, K or F as its "
    "brackets say, C without), use (0: kept, not used). Others are named in a note.",
    "A deviation is the reference position minus the target: positive when the axis went too far.",
    "Units stand in brackets behind the name, or are stated with --unit and --value-unit.",
    "run counts from 1 for each direction. Without the column, the n-th line of a target and "
    "direction is its run n. With the column, an empty deviation or reference is a value that is "
    "missing.",
    "Comments // KEY: VALUE say what was measured: machine, axis, instrument, serial, operator, "
    "date, feed, dwell, drive (its name, then \"serial number\" and the number), compensation "
    "(off, on, or crc: and the checksum of the table), air "
    "temperature, material temperature, expansion, corrected (none or 20C), kind (runs, or "
    "averages: each value is a mean of runs), values (deviation or reference), sign (deviation or "
    "correction). The last two stand before the first value.",
    "Any other CSV is read with --columns 'target=1,direction=3,deviation=5', by number or name.",
};

/// The columns of one file and what their numbers mean.
class Reader {
public:
    Reader(MeasurementCsv& csv, const MeasurementReadOptions& options, Measurement& measurement)
        : m_csv(csv)
        , m_options(options)
        , m_measurement(measurement)
    {
    }

    [[nodiscard]] bool findColumns();
    [[nodiscard]] std::vector<RawRunValue> read();

private:
    void decideValues();
    void checkValuesComment(bool isReference);
    [[nodiscard]] bool findUnits();
    [[nodiscard]] std::optional<RawRunValue> readLine();
    [[nodiscard]] bool readDirection(RunValue& value);
    [[nodiscard]] bool readRun(RunValue& value);
    void readFurther(RunValue& value);
    void takeDirections(std::vector<RawRunValue>& values);

    MeasurementCsv& m_csv;
    const MeasurementReadOptions& m_options;
    Measurement& m_measurement;
    std::size_t m_target = 0;
    std::size_t m_direction = 0;
    std::size_t m_run = 0;
    std::size_t m_value = 0;
    std::size_t m_encoder = 0;
    std::size_t m_output = 0;
    std::size_t m_time = 0;
    std::size_t m_temperature = 0;
    std::size_t m_use = 0;
    bool m_isReference = false;
    double m_targetFactor = 1.0;
    double m_valueFactor = 1.0;
    double m_encoderFactor = 1.0;
    double m_outputFactor = 1.0;
};

bool Reader::findColumns()
{
    m_target = m_csv.column("target", {"position"});
    m_direction = m_csv.column("direction", {"dir"});
    m_run = m_csv.column("run", {"cycle"});
    m_encoder = m_csv.column("encoder", {});
    m_output = m_csv.column("output", {});
    m_time = m_csv.column("time", {});
    m_temperature = m_csv.column("temperature", {});
    m_use = m_csv.column("use", {});
    decideValues();
    m_csv.findAxis();
    m_csv.checkMapping();
    if (m_target == 0)
        m_csv.error(DiagnosticCode::MissingColumn, 0, AXISCOMP_TEXT("Error", "no column target"),
            AXISCOMP_TEXT("Error",
                "a column target, or which column it is: --columns 'target=1,direction=2,...'"));
    if (m_direction == 0 && !m_options.takesDirectionFromOrder)
        m_csv.error(DiagnosticCode::MissingColumn, 0, AXISCOMP_TEXT("Error", "no column direction"),
            AXISCOMP_TEXT("Error",
                "a column direction with + and -, or --direction-from order when the runs rise "
                "and fall"));
    return m_target != 0 && m_value != 0 && (m_direction != 0 || m_options.takesDirectionFromOrder)
        && findUnits();
}

/// Deviations or positions of the reference: by the name of the column, by what the file says, by
/// what the user says.
void Reader::decideValues()
{
    const std::size_t deviation = m_csv.column("deviation", {"error", "value"});
    const std::size_t reference = m_csv.column("reference", {"actual", "measured"});
    if ((deviation == 0) == (reference == 0)) {
        m_csv.error(DiagnosticCode::MissingColumn, 0,
            deviation == 0 ? AXISCOMP_TEXT("Error", "neither deviation nor reference")
                           : AXISCOMP_TEXT("Error", "both deviation and reference"),
            AXISCOMP_TEXT("Error",
                "either a column deviation (reference minus target) or a column reference "
                "(position)"));
        return;
    }
    m_value = deviation != 0 ? deviation : reference;
    checkValuesComment(reference != 0);
    m_isReference = reference != 0 || m_csv.comments().holdsReference.value_or(false);
    if (m_options.values != MeasurementReadOptions::Values::AsFileSays)
        m_isReference = m_options.values == MeasurementReadOptions::Values::Reference;
    const bool isUpToFile =
        reference == 0 && m_options.values == MeasurementReadOptions::Values::AsFileSays;
    m_csv.settleValues(isUpToFile ? std::optional(m_isReference) : std::nullopt, !m_isReference);
}

/// isReference: by the name of the column, as a comment may say it too. The name "value" says
/// nothing.
void Reader::checkValuesComment(bool isReference)
{
    const std::string& name = m_csv.columns()[m_value - 1].name;
    if (sameLetters(name, "value"))
        return;
    m_csv.noteValues(isReference);
    if (m_csv.comments().holdsReference.value_or(isReference) != isReference)
        m_csv.error(DiagnosticCode::Contradiction, m_value,
            AXISCOMP_TEXT("Error", "column {column}, and values: {said}")
                .with("column", name)
                .with("said", Verbatim{isReference ? "deviation" : "reference"}),
            AXISCOMP_TEXT("Error", "one of the two; a column value goes with both"));
}

bool Reader::findUnits()
{
    const auto target = m_csv.unit(m_target, m_options.unit);
    const auto value = m_csv.unit(m_value, m_options.valueUnit);
    m_csv.checkSameKind(target, value, m_value);
    const auto encoder = m_encoder == 0 ? target : m_csv.unit(m_encoder, m_options.unit);
    const auto output = m_output == 0 ? value : m_csv.unit(m_output, m_options.valueUnit);
    if (m_encoder != 0)
        m_csv.checkSameKind(target, encoder, m_encoder);
    if (m_output != 0)
        m_csv.checkSameKind(target, output, m_output);
    if (!target || !value || !encoder || !output)
        return false;
    m_targetFactor = target->factor;
    m_valueFactor = value->factor;
    m_encoderFactor = encoder->factor;
    m_outputFactor = output->factor;
    m_measurement.isAngular = target->isAngular;
    return true;
}

std::vector<RawRunValue> Reader::read()
{
    std::vector<RawRunValue> values;
    while (m_csv.next())
        if (const auto value = readLine())
            values.push_back(*value);
    m_csv.noteUnknownColumns();
    if (m_options.takesDirectionFromOrder)
        takeDirections(values);
    return values;
}

std::optional<RawRunValue> Reader::readLine()
{
    RawRunValue raw;
    raw.value.line = m_csv.line();
    raw.value.run = 0;
    const auto target = m_csv.number(m_target);
    // Where runs are counted by their lines, what is missing would change their numbers.
    const bool isMissing =
        m_run != 0 && !m_options.takesDirectionFromOrder && m_csv.isEmpty(m_value);
    if (isMissing && target)
        m_measurement.targets.push_back(*target * m_targetFactor);
    std::optional<double> number;
    if (!isMissing)
        number = m_csv.number(m_value);
    const bool hasDirection = m_options.takesDirectionFromOrder || readDirection(raw.value);
    const bool hasRun = m_options.takesDirectionFromOrder || readRun(raw.value);
    readFurther(raw.value);
    if (!target || !number || !hasDirection || !hasRun)
        return std::nullopt;
    raw.target = *target * m_targetFactor;
    if (m_isReference)
        raw.reference = *number * m_valueFactor;
    else
        raw.value.deviation =
            *number * (m_csv.comments().holdsCorrections ? -m_valueFactor : m_valueFactor);
    return raw;
}

bool Reader::readDirection(RunValue& value)
{
    const std::string_view text = m_csv.text(m_direction);
    const auto direction = approachOf(text);
    if (direction)
        value.direction = *direction;
    else
        m_csv.error(DiagnosticCode::BadDirection, m_direction, Verbatim{m_csv.shown(text)},
            AXISCOMP_TEXT("Error", "+ or -, up or down, forward or backward"));
    return direction.has_value();
}

bool Reader::readRun(RunValue& value)
{
    if (m_run == 0)
        return true;
    const std::string_view text = m_csv.text(m_run);
    const auto run = wholeNumberOf(text);
    constexpr std::int64_t most = 1'000'000;
    if (run && *run >= 1 && *run <= most) {
        value.run = static_cast<int>(*run);
        return true;
    }
    m_csv.error(DiagnosticCode::BadRun, m_run, Verbatim{m_csv.shown(text)},
        AXISCOMP_TEXT("Error", "a whole number from 1"));
    return false;
}

void Reader::readFurther(RunValue& value)
{
    const auto scaled = [](std::optional<double> number, double factor) {
        return number ? std::optional(*number * factor) : std::nullopt;
    };
    value.encoder = scaled(m_csv.optionalNumber(m_encoder), m_encoderFactor);
    value.output = scaled(m_csv.optionalNumber(m_output), m_outputFactor);
    value.temperature = m_csv.temperature(m_temperature);
    value.time = m_csv.time(m_time);
    value.isUsed = m_csv.optionalNumber(m_use).value_or(1.0) != 0.0;
}

/// Runs as they rise and fall: a new one begins where the direction changes.
void Reader::takeDirections(std::vector<RawRunValue>& values)
{
    std::array<int, 2> counts{};
    for (std::size_t begin = 0; begin < values.size();) {
        std::size_t end = begin + 1;
        const double step = end < values.size() ? values[end].target - values[begin].target : 0.0;
        while (end < values.size() && (values[end].target - values[end - 1].target) * step > 0.0)
            ++end;
        if (end - begin < 2) {
            m_csv.error(DiagnosticCode::BadDirection, m_target,
                AXISCOMP_TEXT("Error", "line {line}").with("line", values[begin].value.line),
                AXISCOMP_TEXT("Error",
                    "at least two targets one after the other in each run, so that its direction "
                    "shows"));
            return;
        }
        const Approach direction = step > 0.0 ? Approach::Up : Approach::Down;
        const int run = ++counts[static_cast<std::size_t>(direction)];
        for (; begin < end; ++begin) {
            values[begin].value.direction = direction;
            values[begin].value.run = run;
        }
    }
}

std::vector<RawRunValue> valuesOf(std::string_view text, const MeasurementReadOptions& options,
    Measurement& measurement, DiagnosticList& diagnostics)
{
    MeasurementCsv csv(text, options, measurement, diagnostics);
    if (!csv.readHeader())
        return {};
    Reader reader(csv, options, measurement);
    return reader.findColumns() ? reader.read() : std::vector<RawRunValue>{};
}

/// "// axiscomp runs: 1" in the first line: whatever is wrong with the rest is said by line.
bool isNamed(std::string_view text)
{
    const Token line = trimmedToken({text.substr(0, text.find_first_of("\r\n")), 0, 1});
    return line.text.starts_with("//")
        && trimmedToken({line.text.substr(2), 0, 1}).text.starts_with("axiscomp runs");
}

MeasurementRecognition recognise(std::string_view text)
{
    if (isNamed(text))
        return MeasurementRecognition::Certain;
    const std::vector<std::string> names = headerNames(text);
    const auto has = [&names](std::string_view name) {
        return std::ranges::find(names, name) != names.end();
    };
    const bool hasValue = has("deviation") || has("error") || has("value") || has("reference")
        || has("actual") || has("measured");
    if (!has("target") || !hasValue)
        return MeasurementRecognition::No;
    return MeasurementRecognition::Certain;
}

} // namespace

const MeasurementFormat& format()
{
    static const MeasurementFormat format{
        .facts = {.name = "runs",
            .origin = "this program",
            .description = AXISCOMP_TEXT("Error", "CSV with a line for each value"),
            .extensions = extensions,
            .kinds = kinds,
            .rules = rules},
        .recognise = recognise,
        .read = readRuns<valuesOf>};
    return format;
}

} // namespace axiscomp::runs_csv
