// SPDX-License-Identifier: GPL-3.0-or-later
// Reading measurements of a million lines; judging one of 1000 targets with ten runs in each
// direction, fitting it and foretelling it, as the command line and the window do.
#include "core/metrology/fit/measured_state.h"
#include "core/metrology/fit/measurement_fit.h"
#include "core/metrology/formats/measurement_format.h"
#include "core/metrology/judge/judgement.h"

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <optional>
#include <string>

namespace {

using namespace axiscomp;

constexpr int lines = 1'000'000;

std::string runsText(int targets, int runs)
{
    std::string text = "// compensation: off\ntarget [mm],direction,run,deviation [um]\n";
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
        text += std::to_string(1e-4 * static_cast<double>(n * 7919LL % lines)) + ","
            + std::to_string(1e-4 * static_cast<double>(n * 104729LL % lines)) + ","
            + std::to_string(0.01 * (n % 17)) + "\n";
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

/// The whole of it, with the prediction at targets that were left out.
void fitRuns(benchmark::State& state, FitMethod method, std::optional<double> smoothness)
{
    const auto format = measurementFormatNamed("runs");
    const auto targets = static_cast<int>(state.range(0));
    const MeasurementReading reading = (*format)->read(runsText(targets, 10), {});
    FitSettings settings;
    settings.method = method;
    settings.smoothness = smoothness;
    settings.lookupAt = LookupAt::Encoder;
    const auto found = findState({.onFile = reading.measurement->header.compensation});
    if (!found) {
        state.SkipWithError(sentence(found.error()).c_str());
        return;
    }
    for (auto _ : state) {
        const auto report = fitMeasurement(*reading.measurement, settings, *found);
        if (!report || !report->heldOut)
            state.SkipWithError("it was not fitted");
        benchmark::DoNotOptimize(report);
    }
}

} // namespace

BENCHMARK_CAPTURE(fitRuns, linear, FitMethod::Linear, std::nullopt)
    ->Arg(81)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fitRuns, smooth, FitMethod::Smooth, 100.0)
    ->Arg(81)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(fitRuns, automatic, FitMethod::Smooth, std::nullopt)
    ->Arg(81)
    ->Arg(1000)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read, points, "points", pointsText())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(read, runs, "runs", runsText(1000, 500))->Unit(benchmark::kMillisecond);
BENCHMARK(judgeThousandTargets)->Unit(benchmark::kMillisecond);

/// --sample FILE writes the points instead.
int main(int argc, char** argv)
{
    if (argc == 3 && std::strcmp(argv[1], "--sample") == 0) {
        std::ofstream file(argv[2], std::ios::binary);
        file << pointsText();
        return file.flush() ? EXIT_SUCCESS : EXIT_FAILURE;
    }
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return EXIT_SUCCESS;
}
