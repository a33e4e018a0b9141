// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/calibration_csv.h"
#include "core/text/utf8.h"
#include "tests/fuzz/expect.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <vector>

using namespace axiscomp;

namespace {

void expectConsistent(const CalibrationData& data, int dimensions)
{
    FUZZ_EXPECT(data.grid.dimensions() == dimensions);
    FUZZ_EXPECT(!data.tables.empty());
    for (const GridAxis& axis : data.grid.axes) {
        FUZZ_EXPECT(axis.size >= 2);
        FUZZ_EXPECT(axis.distance > 0.0 && std::isfinite(axis.start) && std::isfinite(axis.last()));
    }
    for (const CompensationTable& table : data.tables) {
        FUZZ_EXPECT(table.grid == data.grid);
        FUZZ_EXPECT(table.values.size() == data.grid.pointCount());
        FUZZ_EXPECT(std::ranges::all_of(table.values, [](float v) { return std::isfinite(v); }));
        FUZZ_EXPECT(!table.name.empty());
    }
}

/// As far as doubles of this size can say.
bool samePositions(const GridAxis& a, const GridAxis& b)
{
    const double allowance = 4e-15 * std::max(std::fabs(a.start), std::fabs(a.last()));
    return a.size == b.size && std::fabs(a.start - b.start) <= allowance
        && std::fabs(a.last() - b.last()) <= allowance;
}

void expectReadBack(const CalibrationData& data, const CsvOptions& options)
{
    const std::string text = writeCalibrationCsv(data);
    const CsvReading again = parseCalibrationCsv(text, options);
    FUZZ_EXPECT(again.data.has_value());
    FUZZ_EXPECT(again.data->tables.size() == data.tables.size());
    for (std::size_t d = 0; d < data.grid.axes.size(); ++d) {
        FUZZ_EXPECT(again.data->grid.axes[d].name == data.grid.axes[d].name);
        FUZZ_EXPECT(samePositions(data.grid.axes[d], again.data->grid.axes[d]));
    }
    for (std::size_t i = 0; i < data.tables.size(); ++i) {
        FUZZ_EXPECT(again.data->tables[i].name == data.tables[i].name);
        FUZZ_EXPECT(again.data->tables[i].values == data.tables[i].values);
    }
}

void expectPresentable(const CsvReading& reading, const CsvOptions& options)
{
    FUZZ_EXPECT(reading.diagnostics.size() <= options.maximumDiagnostics);
    for (const Diagnostic& diagnostic : reading.diagnostics) {
        const std::string text = message(diagnostic);
        FUZZ_EXPECT(findInvalidUtf8(text) == std::string_view::npos);
        FUZZ_EXPECT(text.find('\n') == std::string::npos);
    }
    // What is said of the whole file comes first or last.
    std::vector<std::size_t> lines;
    for (const Diagnostic& diagnostic : reading.diagnostics)
        if (diagnostic.line > 0)
            lines.push_back(diagnostic.line);
    FUZZ_EXPECT(std::ranges::is_sorted(lines));
}

} // namespace

/// The first byte chooses the dimensionality, the rest is the file.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size)
{
    if (size == 0)
        return 0;
    CsvOptions options;
    options.dimensions = 1 + bytes[0] % 3;
    options.maximumDiagnostics = 20;
    const std::string_view text(reinterpret_cast<const char*>(bytes) + 1, size - 1);
    const CsvReading reading = parseCalibrationCsv(text, options);
    FUZZ_EXPECT(!reading.cancelled);
    FUZZ_EXPECT(reading.data.has_value() == !reading.hasErrors());
    expectPresentable(reading, options);
    if (reading.data) {
        expectConsistent(*reading.data, options.dimensions);
        expectReadBack(*reading.data, options);
    }
    return 0;
}
