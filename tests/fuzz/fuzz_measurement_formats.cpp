// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/formats/measurement_format.h"
#include "core/metrology/judge/judgement.h"
#include "tests/fuzz/expect.h"

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <optional>

using namespace axiscomp;

namespace {

/// How an input is read, as its first line says.
struct Way {
    const MeasurementFormat* format = nullptr;
    MeasurementReadOptions options;
};

/// The name of a format; `order`, which takes directions from the order; columns that are mapped
/// (`target=1,deviation=2`); or anything, which then chooses a format.
std::optional<Way> wayOf(std::string_view line, std::string_view text)
{
    const auto formats = measurementFormats();
    Way way;
    if (line.find('=') != std::string_view::npos) {
        auto columns = columnMappingFromText(line);
        if (!columns)
            return std::nullopt;
        way.options.columns = *std::move(columns);
        way.options.unit = "mm";
        way.options.valueUnit = "um";
        way.options.values = MeasurementReadOptions::Values::Deviation;
        const auto chosen = chooseMeasurementFormat(text, "m.csv", way.options);
        if (!chosen)
            return std::nullopt;
        way.format = *chosen;
        return way;
    }
    way.options.takesDirectionFromOrder = line.front() == 'o';
    const auto named = measurementFormatNamed(line);
    way.format =
        named ? *named : formats[static_cast<unsigned char>(line.front()) % formats.size()];
    return way;
}

/// Whether the fuzzer is to stay with another way: AXISCOMP_FUZZ_FORMAT is the name of a format, or
/// `mapped`.
bool isLeftOut(const Way& way)
{
    static const char* const wanted = std::getenv("AXISCOMP_FUZZ_FORMAT");
    if (wanted == nullptr)
        return false;
    return (way.options.columns.empty() ? way.format->facts.name : "mapped") != wanted;
}

void expectConsistent(const Measurement& measurement)
{
    FUZZ_EXPECT(!measurement.hasTargets() || measurement.targets.size() >= 2);
    FUZZ_EXPECT(std::ranges::is_sorted(measurement.targets));
    for (const RunValue& value : measurement.values) {
        FUZZ_EXPECT(value.target < measurement.targets.size());
        FUZZ_EXPECT(value.run >= 1);
        FUZZ_EXPECT(std::isfinite(value.deviation));
    }
    for (const std::vector<double>& column : measurement.points.values)
        FUZZ_EXPECT(column.size() == measurement.points.size());
}

/// What was read can be written, and reads back to the same values.
void expectSameAgain(const Measurement& measurement)
{
    const std::string text = writeRunsCsv(measurement);
    const auto runs = measurementFormatNamed("runs");
    FUZZ_EXPECT(runs.has_value());
    const MeasurementReading again = (*runs)->read(text, {});
    FUZZ_EXPECT(again.measurement.has_value());
    FUZZ_EXPECT(again.measurement->values.size() == measurement.values.size());
    for (std::size_t i = 0; i < measurement.values.size(); ++i) {
        const RunValue& a = measurement.values[i];
        const RunValue& b = again.measurement->values[i];
        FUZZ_EXPECT(a.deviation == b.deviation && a.target == b.target && a.run == b.run
            && a.direction == b.direction && a.isUsed == b.isUsed);
    }
}

void judgeIt(const Measurement& measurement)
{
    JudgeOptions options;
    options.wantsVdi = true;
    const Judgement judgement = judge(measurement, options);
    FUZZ_EXPECT(!judgement.compliance.empty());
    for (const JudgeWarning& warning : judgement.warnings)
        FUZZ_EXPECT(!warning.text.english().empty());
    const auto& figures = judgement.figures;
    const auto value = [&figures](Iso230Figure figure) { return figures[figure].value; };
    if (value(Iso230Figure::A) && std::isfinite(*value(Iso230Figure::A))) {
        constexpr double slack = 1.0 + 1e-9;
        FUZZ_EXPECT(*value(Iso230Figure::A) * slack >= *value(Iso230Figure::E));
    }
}

} // namespace

/// The first line says how the rest is read.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view input(reinterpret_cast<const char*>(data), size);
    const std::size_t end = input.find('\n');
    if (end == std::string_view::npos || end == 0)
        return 0;
    const std::string_view text = input.substr(end + 1);
    static_cast<void>(chooseMeasurementFormat(text, "m.csv", {}));
    static_cast<void>(previewMeasurement(text, 0, 20));
    const auto way = wayOf(input.substr(0, end), text);
    if (!way || isLeftOut(*way))
        return 0;
    const MeasurementReading reading = way->format->read(text, way->options);
    FUZZ_EXPECT(reading.measurement.has_value() != reading.hasErrors());
    for (const Diagnostic& diagnostic : reading.diagnostics)
        FUZZ_EXPECT(!message(diagnostic).empty());
    if (!reading.measurement)
        return 0;
    expectConsistent(*reading.measurement);
    if (reading.measurement->hasTargets()) {
        judgeIt(*reading.measurement);
        expectSameAgain(*reading.measurement);
    }
    return 0;
}
