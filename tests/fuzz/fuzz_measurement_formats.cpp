// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/formats/measurement_format.h"
#include "core/metrology/judge/judgement.h"
#include "tests/fuzz/expect.h"

#include <algorithm>
#include <cmath>

using namespace axiscomp;

namespace {

const MeasurementFormat& formatOf(std::string_view name)
{
    const auto formats = measurementFormats();
    for (const MeasurementFormat* format : formats)
        if (format->facts.name == name)
            return *format;
    return *formats[static_cast<unsigned char>(name.front()) % formats.size()];
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

/// The first line is the name of a format, or anything, which then chooses one; the rest is the
/// file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size)
{
    const std::string_view input(reinterpret_cast<const char*>(data), size);
    const std::size_t end = input.find('\n');
    if (end == std::string_view::npos || end == 0)
        return 0;
    const std::string_view text = input.substr(end + 1);
    static_cast<void>(chooseMeasurementFormat(text, "m.csv", {}));
    MeasurementReadOptions options;
    options.takesDirectionFromOrder = input.front() == 'o';
    const MeasurementReading reading = formatOf(input.substr(0, end)).read(text, options);
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
