// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/formats/formats.h"
#include "core/table/table_layout.h"
#include "tests/fuzz/expect.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <vector>

using namespace axiscomp;

namespace {

const TableLayout& layout()
{
    static const TableLayout generic = genericTableLayout();
    return generic;
}

/// A value for everything that a format must be told.
FormatSettings neededSettings(const FormatFacts& facts, bool isWriting)
{
    FormatSettings settings;
    for (const FormatSetting& setting : facts.settings)
        if (setting.isNeeded && (isWriting ? setting.forWriting : setting.forReading))
            settings[std::string(setting.key)] = setting.kind == FormatSetting::Kind::Text ? "X"
                : setting.key.ends_with("-2")                                              ? "2"
                                                                                           : "1000";
    return settings;
}

void expectConsistent(const NeutralTable& table)
{
    FUZZ_EXPECT(!table.axes.empty() && table.axes.size() <= 3);
    FUZZ_EXPECT(!table.columns.empty());
    for (const SourceAxis& axis : table.axes) {
        FUZZ_EXPECT(axis.knots.size() >= 2);
        for (std::size_t i = 0; i < axis.knots.size(); ++i) {
            FUZZ_EXPECT(std::isfinite(axis.knots[i]));
            FUZZ_EXPECT(i == 0 || axis.knots[i] > axis.knots[i - 1]);
        }
        FUZZ_EXPECT(!axis.wrap || *axis.wrap > 0.0);
    }
    for (const CompensationColumn& column : table.columns) {
        FUZZ_EXPECT(column.values.size() == table.pointCount());
        for (const double value : column.values)
            FUZZ_EXPECT(std::isfinite(value));
    }
}

void evaluate(const TableFormat& format, const NeutralTable& table)
{
    for (std::size_t column = 0; column < table.columns.size(); ++column) {
        const ControllerLookup applied(table, column, format.facts.behaviour);
        for (const double far : {-1e300, 0.0, 1e300, HUGE_VAL}) {
            const std::array<double, 3> position{far, -far, far};
            static_cast<void>(applied.at(std::span(position).first(table.axes.size())));
        }
        std::array<double, 3> first{};
        for (std::size_t n = 0; n < table.axes.size(); ++n)
            first[n] = table.axes[n].knots.front();
        FUZZ_EXPECT(!std::isnan(applied.at(std::span(first).first(table.axes.size()))));
    }
}

/// What was read can be written, or there is a reason; what was written can be read, and says what
/// the writer said it would.
void expectWritable(const TableFormat& format, const std::vector<NeutralTable>& tables,
    const TableReadOptions& reading)
{
    if (format.write == nullptr || !checkHolds(format.facts, tables))
        return;
    TableWriteOptions options;
    options.layout = &layout();
    options.settings = neededSettings(format.facts, true);
    const auto written = format.write(tables, options);
    if (!written) {
        FUZZ_EXPECT(!sentence(written.error()).empty());
        return;
    }
    const auto again = format.read(written->bytes, reading);
    FUZZ_EXPECT(again.has_value());
    FUZZ_EXPECT(again->tables.size() == written->held.size());
    for (std::size_t n = 0; n < again->tables.size(); ++n)
        FUZZ_EXPECT(again->tables[n].pointCount() == written->held[n].pointCount());
}

const TableFormat& formatOf(std::string_view name)
{
    std::vector<const TableFormat*> readable;
    for (const TableFormat* format : tableFormats()) {
        if (format->read == nullptr)
            continue;
        if (format->facts.name == name)
            return *format;
        readable.push_back(format);
    }
    return *readable[static_cast<unsigned char>(name.front()) % readable.size()];
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
    const TableFormat& format = formatOf(input.substr(0, end));
    const std::string_view text = input.substr(end + 1);
    static_cast<void>(guessFormat(text, "table.txt"));

    TableReadOptions options;
    options.layout = &layout();
    options.dimensions = &format == &calibration_csv::format() ? 2 : 0;
    options.settings = neededSettings(format.facts, false);
    const auto reading = format.read(text, options);
    if (!reading)
        return 0;
    FUZZ_EXPECT(reading->tables.empty() || !reading->hasErrors());
    FUZZ_EXPECT(!reading->tables.empty() || reading->hasErrors());
    for (const NeutralTable& table : reading->tables) {
        expectConsistent(table);
        evaluate(format, table);
    }
    if (!reading->tables.empty())
        expectWritable(format, reading->tables, options);
    return 0;
}
