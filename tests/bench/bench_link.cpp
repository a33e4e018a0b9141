// SPDX-License-Identifier: GPL-3.0-or-later
// A full table over the link to a drive: AXISCOMP_BENCH_DRIVE is its endpoint, a virtual drive of
// compare.sh. A write is all of it: planned, kept in a backup, uploaded, read back, compared,
// stored in flash, switched over. A drive allows only so many writes to its flash within an hour.
#include "core/compensator/axis_compensator.h"
#include "core/table/tam_table.h"
#include "drivecomm/link_factory.h"
#include "drivecomm/profile/profile_loader.h"

#include <benchmark/benchmark.h>

#include <QCoreApplication>
#include <QTemporaryDir>

#include <cmath>
#include <cstdlib>

namespace {

using namespace axiscomp;
using namespace axiscomp::drivecomm;

constexpr std::uint32_t fullSize = 724; // 724 x 724 values are the largest square of a large slot

CompensationTable fullTable(int seed)
{
    CompensationTable table;
    for (int i = 0; i < 2; ++i)
        table.grid.axes.push_back(
            {.name = {}, .unit = "mm", .start = 0.0, .distance = 1.0, .size = fullSize});
    table.unit = "mm";
    for (std::size_t i = 0; i < table.grid.pointCount(); ++i)
        table.values.push_back(
            static_cast<float>(0.003 * std::sin(0.007 * static_cast<double>(i) + seed)));
    return table;
}

struct Connection {
    Connection()
    {
        const char* const name = std::getenv("AXISCOMP_BENCH_DRIVE");
        const auto endpoint = parseEndpoint(name == nullptr ? "" : name);
        if (!endpoint)
            return;
        if (auto made = makeLink(*endpoint, genericProfile()))
            link = *std::move(made);
    }

    std::unique_ptr<DriveLink> link;
};

/// One for all, as a program that has written before has it.
DriveStore& storeOfAll()
{
    static const QTemporaryDir folder;
    static DriveStore store{std::filesystem::path(folder.path().toStdString())};
    return store;
}

template <typename Outcome> bool isDone(benchmark::State& state, const Outcome& outcome)
{
    if (!outcome)
        state.SkipWithError(sentence(outcome.error()).c_str());
    return outcome.has_value();
}

void writeFullTable(benchmark::State& state)
{
    Connection connection;
    if (connection.link == nullptr) {
        state.SkipWithError("AXISCOMP_BENCH_DRIVE is no endpoint");
        return;
    }
    AxisCompensator compensator(*connection.link, genericProfile(), storeOfAll());
    WriteRequest request;
    request.dimensionality = 2;
    const std::string position = "]/Signals/PositionController/MasterPosition";
    request.sources = {"Axes[0" + position, "Axes[1" + position};
    request.persistency = Persistency::Persistent;
    static int seed = 0;
    for (auto _ : state) {
        state.PauseTiming();
        request.table = fullTable(++seed);
        state.ResumeTiming();
        if (!isDone(state, compensator.write(0, request)))
            break;
    }
}

void transferAndCommit(benchmark::State& state)
{
    Connection connection;
    if (connection.link == nullptr) {
        state.SkipWithError("AXISCOMP_BENCH_DRIVE is no endpoint");
        return;
    }
    DriveLink& link = *connection.link;
    static int seed = 100;
    const TableLayout& layout = genericProfile().layout;
    const Bytes file = encodeTamTable(fullTable(++seed), false, layout).value();
    const std::string path = "tables/large1.TAMtbl";
    const std::vector<RegisterWrite> commit{{"Application/Tables/Large1/Header/Persistent", true},
        {"Application/Tables/Large1/Command", std::string("Commit")}};
    const std::vector<std::string> stored{"Application/Tables/Large1/Header/Persistent"};
    for (auto _ : state) {
        if (!isDone(state, link.upload(path, file, {})))
            break;
        const auto readBack = link.download(path, {});
        if (!isDone(state, readBack) || *readBack != file
            || !isDone(state, decodeTamTable(*readBack, layout))
            || !isDone(state, link.writeRegisters(commit, {}))
            || !isDone(state, link.readRegisters(stored, {})))
            break;
    }
}

void transfer(benchmark::State& state, bool isUpload)
{
    Connection connection;
    const auto encoded = encodeTamTable(fullTable(1), false, genericProfile().layout);
    if (connection.link == nullptr || !encoded) {
        state.SkipWithError("AXISCOMP_BENCH_DRIVE is no endpoint");
        return;
    }
    const std::string path = "tables/large2.TAMtbl";
    if (!isDone(state, connection.link->upload(path, *encoded, {})))
        return;
    for (auto _ : state) {
        if (isUpload ? !isDone(state, connection.link->upload(path, *encoded, {}))
                     : !isDone(state, connection.link->download(path, {})))
            break;
    }
    state.counters["bytes"] = static_cast<double>(encoded->size());
}

void upload(benchmark::State& state)
{
    transfer(state, true);
}
void download(benchmark::State& state)
{
    transfer(state, false);
}

/// As `monitor` and the window's live values ask.
void readEightRegisters(benchmark::State& state)
{
    Connection connection;
    if (connection.link == nullptr) {
        state.SkipWithError("AXISCOMP_BENCH_DRIVE is no endpoint");
        return;
    }
    const std::string axis = "Axes[0]/Signals/Compensations/Axis/";
    const std::vector<std::string> paths{axis + "State", axis + "Error", axis + "Output",
        axis + "Dim1Index", axis + "Dim2Index", axis + "Dim3Index",
        "Axes[0]/Signals/PositionController/MasterPosition",
        "Axes[0]/Signals/PositionController/Encoders[0]/Position"};
    if (!isDone(state, connection.link->readRegisters(paths, {})))
        return;
    for (auto _ : state) {
        if (!isDone(state, connection.link->readRegisters(paths, {})))
            break;
    }
}

BENCHMARK(readEightRegisters)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(50);
BENCHMARK(transferAndCommit)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(writeFullTable)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(upload)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);
BENCHMARK(download)->Unit(benchmark::kMillisecond)->UseRealTime()->Iterations(1);

} // namespace

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
