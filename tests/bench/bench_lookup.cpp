// SPDX-License-Identifier: GPL-3.0-or-later
// Independent lookups at random positions that were made beforehand, one by one and a million in
// one call; the time is that of one.
#include "core/table/lookup.h"

#include <benchmark/benchmark.h>

#include <array>
#include <random>
#include <vector>

namespace {

using namespace axiscomp;

constexpr std::size_t queryCount = 16384;

CompensationTable randomTable(int dimensions, std::uint32_t size)
{
    CompensationTable table;
    std::mt19937 random(1); // NOLINT: the same table every time
    for (int i = 0; i < dimensions; ++i)
        table.grid.axes.push_back({{}, {}, -50.0 + i, 1.25, size});
    table.values.resize(table.grid.pointCount());
    std::normal_distribution<float> noise;
    for (float& value : table.values)
        value = noise(random);
    return table;
}

/// Within the table; above 1, `stretch` lets some lie outside.
template <std::size_t dimensions>
std::vector<std::array<double, dimensions>> randomQueries(const Grid& grid, double stretch)
{
    std::mt19937 random(2); // NOLINT: the same positions every time
    std::vector<std::array<double, dimensions>> queries(queryCount);
    for (auto& query : queries) {
        for (std::size_t i = 0; i < dimensions; ++i) {
            const double centre = (grid.axes[i].start + grid.axes[i].last()) / 2.0;
            const double half = (grid.axes[i].last() - grid.axes[i].start) / 2.0 * stretch;
            query[i] = std::uniform_real_distribution<double>(centre - half, centre + half)(random);
        }
    }
    return queries;
}

template <std::size_t dimensions>
void lookup(benchmark::State& state, std::uint32_t size, Outside outside, double stretch)
{
    const CompensationTable table = randomTable(static_cast<int>(dimensions), size);
    const Lookup lookup(table, outside);
    const auto queries = randomQueries<dimensions>(table.grid, stretch);
    // A sum of them would be kept in memory, since a call behind a rare branch may change every
    // register for it; each lookup would wait for the one before to be added.
    std::vector<double> values(queryCount);
    for (auto _ : state) {
        for (std::size_t i = 0; i < queryCount; ++i)
            values[i] =
                std::apply([&](auto... position) { return lookup.at(position...); }, queries[i]);
        benchmark::DoNotOptimize(values.data());
        benchmark::ClobberMemory();
    }
    state.counters["each"] = benchmark::Counter(static_cast<double>(queryCount),
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

template <std::size_t dimensions> void batch(benchmark::State& state, std::uint32_t size)
{
    constexpr std::size_t count = 1'000'000;
    const CompensationTable table = randomTable(static_cast<int>(dimensions), size);
    const Lookup lookup(table, Outside::Hold);
    const auto queries = randomQueries<dimensions>(table.grid, 1.0);
    std::vector<double> positions;
    for (std::size_t i = 0; i < count; ++i) {
        const auto& query = queries[i % queryCount];
        positions.insert(positions.end(), query.begin(), query.end());
    }
    std::vector<double> values(count);
    for (auto _ : state) {
        lookup.atEach(positions, values);
        benchmark::DoNotOptimize(values.data());
    }
    state.counters["each"] = benchmark::Counter(static_cast<double>(count),
        benchmark::Counter::kIsIterationInvariantRate | benchmark::Counter::kInvert);
}

void linear(benchmark::State& state)
{
    lookup<1>(state, 8000, Outside::Hold, 1.0);
}
void bilinear(benchmark::State& state)
{
    lookup<2>(state, 720, Outside::Hold, 1.0);
}
void trilinear(benchmark::State& state)
{
    lookup<3>(state, 80, Outside::Hold, 1.0);
}
void trilinearExtrapolate(benchmark::State& state)
{
    lookup<3>(state, 80, Outside::Extrapolate, 1.0);
}
void trilinearSomeHeld(benchmark::State& state)
{
    lookup<3>(state, 80, Outside::Hold, 1.1);
}
void trilinearSomeWrapped(benchmark::State& state)
{
    lookup<3>(state, 80, Outside::Wrap, 1.1);
}

void bilinearBatch(benchmark::State& state)
{
    batch<2>(state, 720);
}
void trilinearBatch(benchmark::State& state)
{
    batch<3>(state, 80);
}

BENCHMARK(linear);
BENCHMARK(bilinear);
BENCHMARK(trilinear);
BENCHMARK(trilinearExtrapolate);
BENCHMARK(trilinearSomeHeld);
BENCHMARK(trilinearSomeWrapped);
BENCHMARK(bilinearBatch)->UseRealTime();
BENCHMARK(trilinearBatch)->UseRealTime();

} // namespace

BENCHMARK_MAIN();
