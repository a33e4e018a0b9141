// SPDX-License-Identifier: GPL-3.0-or-later
// A full table over the web link to a virtual drive on loopback, in this process: uploaded, read
// back and compared, committed to flash, as a write does it; and each way by itself. Beside it
// stands curl, which compare.sh starts with the address that `bench_link --serve` prints.
#include "core/axis/verified_transfer.h"
#include "core/table/tam_table.h"
#include "drivecomm/profile/profile_loader.h"
#include "drivecomm/virtualdrive/firmware/virtual_drive.h"
#include "drivecomm/virtualdrive/web/web_server.h"
#include "drivecomm/web/web_drive_link.h"

#include <QCoreApplication>

#include <benchmark/benchmark.h>

#include <cmath>
#include <cstdio>
#include <string_view>

namespace {

using namespace axiscomp;
using namespace axiscomp::drivecomm;

constexpr std::string_view slot = "Table1";

/// Of 2 MB, as large as a slot takes it.
Bytes fullTable(const DriveProfile& profile)
{
    CompensationTable table;
    table.grid.axes = {{"X", "mm", 0.0, 0.5, 724}, {"Y", "mm", 0.0, 0.5, 724}};
    for (std::size_t i = 0; i < table.grid.pointCount(); ++i)
        table.values.push_back(static_cast<float>(0.003 * std::sin(0.01 * static_cast<double>(i))));
    return encodeTamTable(table, profile.tableLayout).value();
}

/// A drive, its server and a link to it.
struct Site {
    DriveProfile profile = genericProfile();
    VirtualDrive drive{profile, {}};
    FaultPlan faults;
    std::unique_ptr<WebServer> server = WebServer::start(drive, profile, faults).value();
    std::unique_ptr<DriveLink> link = makeWebDriveLink(parseEndpoint(server->url()).value(), profile);
    std::string path = profile.slotNamed(slot)->file;
};

void report(benchmark::State& state, const Bytes& table)
{
    state.counters["MB"] = static_cast<double>(table.size()) / 1e6;
}

void upload(benchmark::State& state)
{
    Site site;
    const Bytes table = fullTable(site.profile);
    for (auto _ : state)
        if (auto sent = site.link->upload(site.path, table, {}); !sent)
            state.SkipWithError(sentence(sent.error()).c_str());
    report(state, table);
}

void download(benchmark::State& state)
{
    Site site;
    const Bytes table = fullTable(site.profile);
    static_cast<void>(site.link->upload(site.path, table, {}));
    for (auto _ : state)
        if (auto found = site.link->download(site.path, {}); !found || *found != table)
            state.SkipWithError("another table came back");
    report(state, table);
}

void uploadReadBackAndCommit(benchmark::State& state)
{
    Site site;
    Bytes table = fullTable(site.profile);
    const RegisterAccess access(*site.link, site.profile, {});
    const std::string command = access.slotPath(access.registers().tableCommand, slot);
    for (auto _ : state) {
        auto done = uploadVerified(access, site.path, table, {});
        if (done)
            done = writeVerified(access, {}, {{command, access.enums().tableCommandCommit}});
        if (!done)
            state.SkipWithError(sentence(done.error()).c_str());
    }
    report(state, table);
}

} // namespace

BENCHMARK(upload)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(download)->Unit(benchmark::kMillisecond)->MeasureProcessCPUTime()->UseRealTime();
BENCHMARK(uploadReadBackAndCommit)
    ->Unit(benchmark::kMillisecond)
    ->MeasureProcessCPUTime()
    ->UseRealTime();

int main(int argc, char** argv)
{
    const QCoreApplication application(argc, argv);
    benchmark::Initialize(&argc, argv);
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
