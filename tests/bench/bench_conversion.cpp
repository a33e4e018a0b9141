// SPDX-License-Identifier: GPL-3.0-or-later
// A plane of a million points to the other sign and compared under both controllers' rules; a plane
// of 500 x 500 points onto 1000 x 1000 (tests/bench/scipy_resample.py does the same with scipy).
#include "core/conversion/conversion.h"
#include "core/formats/formats.h"

#include <benchmark/benchmark.h>

#include <cmath>

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

NeutralTable plane(std::size_t size)
{
    NeutralTable table;
    table.axes = {axis("X", size), axis("Y", size)};
    CompensationColumn column;
    column.target = "X";
    column.unit = "mm";
    for (std::size_t j = 0; j < size; ++j)
        for (std::size_t i = 0; i < size; ++i)
            column.values.push_back(0.003 * std::sin(0.01 * static_cast<double>(i))
                * std::cos(0.013 * static_cast<double>(j)));
    table.columns = {column};
    return table;
}

void convertAndCompare(benchmark::State& state)
{
    const NeutralTable table = plane(static_cast<std::size_t>(state.range(0)));
    const TableBehaviour& from = calibration_csv::format().facts.behaviour;
    const TableBehaviour& to = softmc::format().facts.behaviour;
    for (auto _ : state) {
        const auto converted = convertSign(table, SignConvention::Command, from);
        if (!converted) {
            state.SkipWithError(sentence(converted.error()).c_str());
            break;
        }
        auto difference = conversionDifference(table, from, converted->table, to);
        benchmark::DoNotOptimize(difference);
    }
}

void resamplePlane(benchmark::State& state, ResamplingMethod method)
{
    const NeutralTable table = plane(500);
    const AxisRequest thousand{.points = 1000, .distance = 0.0, .start = {}, .end = {}};
    const ResamplingRequest request{.axes = {thousand, thousand}, .method = method};
    for (auto _ : state) {
        auto resampled = resample(table, request);
        if (!resampled)
            state.SkipWithError(sentence(resampled.error()).c_str());
        benchmark::DoNotOptimize(resampled);
    }
}

} // namespace

BENCHMARK(convertAndCompare)
    ->Arg(100)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(resamplePlane, linear, ResamplingMethod::Linear)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(resamplePlane, cubic, ResamplingMethod::MonotoneCubic)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();
BENCHMARK_CAPTURE(resamplePlane, spline, ResamplingMethod::NaturalSpline)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

BENCHMARK_MAIN();
