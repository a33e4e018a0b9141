// SPDX-License-Identifier: GPL-3.0-or-later
// Reading measurements of a million lines, and judging one of 1000 targets with ten runs in each
// direction.
#include "core/metrology/formats/measurement_format.h"
#include "core/metrology/judge/judgement.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <string>

namespace {

using namespace axiscomp;

constexpr int lines = 1'000'000;

std::string runsText(int targets, int runs)
{
    std::string text = "target [mm],direction,run,deviation [um]\n";
    for (int run = 1; run <= runs; ++run)
        for (const char* direction : {",+,", ",-,"})
            for (int target = 0; target < targets; ++target)
                text += std::to_string(target) + direction + std::to_string(run) + ","
                    + std::to_string(std::sin(0.01 * target) + 1e-4 * (target * 31 % 101 + run))
                    + "\n";
    return text;
}

std::string pointsText()
{
    std::string text = "X [mm],Y [mm],dX [um]\n";
    for (int n = 0; n < lines; ++n)
        text += std::to_string(1e-4 * (n * 7919LL % lines)) + ","
            + std::to_string(1e-4 * (n * 104729LL % lines)) + "," + std::to_string(0.01 * (n % 17))
            + "\n";
    return text;
}

void read(benchmark::State& state, const char* format, const std::string& text)
{
    const auto known = measurementFormatNamed(format);
    for (auto _ : state) {
        const MeasurementReading reading = (*known)->read(text, {});
        if (!reading.measurement)
            state.SkipWithError("it was not read");
        benchmark::DoNotOptimize(reading);
    }
    state.SetBytesProcessed(
        static_cast<std::int64_t>(state.iterations()) * static_cast<std::int64_t>(text.size()));
    state.counters["MB"] = static_cast<double>(text.size()) / 1e6;
}

void judgeThousandTargets(benchmark::State& state)
{
    const auto format = measurementFormatNamed("runs");
    const MeasurementReading reading = (*format)->read(runsText(1000, 10), {});
    for (auto _ : state)
        benchmark::DoNotOptimize(judge(*reading.measurement, {}));
}

} // namespace

BENCHMARK_CAPTURE(read, points, "points", pointsText())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read, runs, "runs", runsText(1000, 500))->Unit(benchmark::kMillisecond);
BENCHMARK(judgeThousandTargets)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
