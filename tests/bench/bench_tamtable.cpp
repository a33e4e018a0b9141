// SPDX-License-Identifier: GPL-3.0-or-later
// Writes and reads the largest table that a drive can hold, 80 x 80 x 81 values, 2 MB.
#include "core/table/tam_table.h"

#include <benchmark/benchmark.h>

#include <random>

namespace {

using namespace axiscomp;

CompensationTable largestTable()
{
    CompensationTable table;
    table.grid.axes = {{{}, {}, 0.0, 1.25, 80}, {{}, {}, 0.0, 1.25, 80}, {{}, {}, 0.0, 1.25, 81}};
    table.values.resize(table.grid.pointCount());
    std::mt19937 random(1); // NOLINT: the same table every time
    std::normal_distribution<float> noise;
    for (float& value : table.values)
        value = noise(random);
    return table;
}

TableLayout otherOrder()
{
    TableLayout layout = genericTableLayout();
    layout.littleEndian = false;
    layout.dimension1Fastest = false;
    return layout;
}

void encode(benchmark::State& state, const TableLayout& layout)
{
    const CompensationTable table = largestTable();
    for (auto _ : state) {
        auto file = encodeTamTable(table, false, layout);
        if (!file)
            return state.SkipWithError(sentence(file.error()).c_str());
        benchmark::DoNotOptimize(file->data());
    }
    state.SetBytesProcessed(
        state.iterations() * static_cast<std::int64_t>(tamTableSize(table.grid, layout)));
}

void decode(benchmark::State& state, const TableLayout& layout)
{
    const auto file = encodeTamTable(largestTable(), false, layout);
    if (!file)
        return state.SkipWithError(sentence(file.error()).c_str());
    for (auto _ : state) {
        auto decoded = decodeTamTable(*file, layout);
        if (!decoded)
            return state.SkipWithError(sentence(decoded.error()).c_str());
        benchmark::DoNotOptimize(decoded->table.values.data());
    }
    state.SetBytesProcessed(state.iterations() * static_cast<std::int64_t>(file->size()));
}

BENCHMARK_CAPTURE(encode, generic, genericTableLayout())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(encode, otherOrder, otherOrder())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(decode, generic, genericTableLayout())->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(decode, otherOrder, otherOrder())->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
