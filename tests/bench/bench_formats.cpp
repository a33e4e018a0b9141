// SPDX-License-Identifier: GPL-3.0-or-later
// Reading and writing files of other controllers of about 2 MB, and comparing a conversion.
#include "core/conversion/conversion.h"
#include "core/formats/formats.h"

#include <benchmark/benchmark.h>

#include <array>
#include <cmath>
#include <cstdio>

namespace {

using namespace axiscomp;

SourceAxis axis(const char* name, std::size_t size)
{
    SourceAxis axis;
    axis.name = name;
    axis.unit = "mm";
    for (std::size_t i = 0; i < size; ++i)
        axis.knots.push_back(0.5 * static_cast<double>(i));
    return axis;
}

NeutralTable table(std::size_t sizeX, std::size_t sizeY, SignConvention sign)
{
    NeutralTable table;
    table.sign = sign;
    table.axes = {axis("1", sizeX), axis("2", sizeY)};
    CompensationColumn column;
    column.target = "1";
    column.unit = "mm";
    for (std::size_t i = 0; i < sizeX * sizeY; ++i)
        column.values.push_back(0.003 * std::sin(0.01 * static_cast<double>(i)));
    table.columns = {column};
    return table;
}

void readText(benchmark::State& state, const TableFormat& format, const std::string& text)
{
    for (auto _ : state) {
        const auto reading = format.read(text, {});
        if (!reading || reading->tables.size() != 1)
            state.SkipWithError("it was not read");
        benchmark::DoNotOptimize(reading);
    }
    state.SetBytesProcessed(
        static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(text.size()));
    state.counters["MB"] = static_cast<double>(text.size()) / 1e6;
}

void readFormat(benchmark::State& state, const TableFormat& format, std::size_t size,
    const FormatSettings& settings)
{
    const std::array tables{table(size, size, format.facts.sign)};
    TableWriteOptions writing;
    writing.settings = settings;
    const auto written = format.write(tables, writing);
    if (!written)
        state.SkipWithError(sentence(written.error()).c_str());
    else
        readText(state, format, written->bytes);
}

/// Rows of size heights, as printf writes them.
std::string heightRows(std::size_t size, const char* form, const char* indent)
{
    std::string rows;
    for (std::size_t i = 0; i < size * size; ++i) {
        std::array<char, 32> number{};
        const auto length = std::snprintf(number.data(), number.size(), form,
            0.001 + 0.3 * std::sin(0.01 * static_cast<double>(i)));
        rows += (i % size == 0 ? indent : ", ");
        rows.append(number.data(), static_cast<std::size_t>(length));
        rows += (i + 1) % size == 0 ? "\n" : "";
    }
    return rows;
}

void readHeightMap(benchmark::State& state)
{
    constexpr std::size_t size = 500;
    readText(state, reprap::format(),
        "RepRapFirmware height map file v2 generated at 2021-04-05 06:07, mean error 0.010, "
        "deviation 0.002\naxis0,axis1,min0,max0,min1,max1,radius,spacing0,spacing1,num0,num1\n"
        "X,Y,0.00,499.00,0.00,499.00,-1.00,1.00,1.00,500,500\n"
            + heightRows(size, "%7.3f", ""));
}

void readBedMesh(benchmark::State& state)
{
    constexpr std::size_t size = 500;
    readText(state, klipper::format(),
        "[bed_mesh default]\nversion = 1\npoints =\n" + heightRows(size, "%f", "\t")
            + "x_count = 500\ny_count = 500\nmin_x = 0\nmax_x = 499\nmin_y = 0\nmax_y = 499\n");
}

void convertPlane(benchmark::State& state)
{
    const std::array tables{table(100, 100, SignConvention::Feedback)};
    ConversionRequest request;
    request.from = &calibration_csv::format();
    request.to = &softmc::format();
    for (auto _ : state) {
        const auto conversion = convertTables(tables, request);
        if (!conversion)
            state.SkipWithError(sentence(conversion.error()).c_str());
        benchmark::DoNotOptimize(conversion);
    }
}

} // namespace

BENCHMARK_CAPTURE(readFormat, softmc, softmc::format(), 270, {})->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(readFormat, aerotech_2d, aerotech_2d::format(), 300, {{"output-axis-1", "1"}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(readFormat, isg_crosscomp2, isg_crosscomp2::format(), 100, {{"axis", "3"}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(readFormat, rapidcode, rapidcode::format(), 400, {{"counts-per-unit", "1000000"}})
    ->Unit(benchmark::kMillisecond);
BENCHMARK(readHeightMap)->Unit(benchmark::kMillisecond);
BENCHMARK(readBedMesh)->Unit(benchmark::kMillisecond);
BENCHMARK(convertPlane)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
