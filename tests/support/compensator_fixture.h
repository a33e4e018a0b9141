// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/axis_compensator.h"
#include "core/table/tam_table.h"
#include "drivecomm/profile/profile_loader.h"
#include "tests/support/faulty_link.h"
#include "tests/support/link_attachment.h"

#include <QTemporaryDir>
#include <QTest>

#include <array>
#include <atomic>
#include <cmath>

namespace axiscomp::test {

/// An even table that looks like a real axis: a few micrometres over millimetres. seed makes
/// another one.
inline CompensationTable exampleTable(int dimensions, int seed = 1, std::uint32_t size = 6)
{
    CompensationTable table;
    table.name = "table " + std::to_string(seed);
    for (int n = 0; n < dimensions; ++n)
        table.grid.axes.push_back(
            {.name = {}, .unit = {}, .start = 0.0, .distance = 10.0 + n, .size = size});
    for (std::size_t i = 0; i < table.grid.pointCount(); ++i)
        table.values.push_back(
            static_cast<float>(0.003 * std::sin(0.7 * static_cast<double>(i) + seed)));
    return table;
}

/// A virtual drive of two homed axes whose time passes only when it is asked something, one
/// millisecond each time, with a compensator and a store of its own. It misbehaves by its faults,
/// as a drive, or by its link, exchange by exchange.
struct CompensatorFixture {
    /// profile: what the compensator takes the drive for; outlives this.
    explicit CompensatorFixture(const AttachmentKind& kind = inProcess(),
        const DriveProfile& profile = drivecomm::genericProfile(),
        const std::array<std::string, 2>& names = {"X", "Y"})
        : drive(drivecomm::genericProfile(), options(time, names))
        , attachment(kind.attach(drive, faults))
        , link(drive, attachment->link())
        , store(storeRoot())
        , compensator(link, profile, store, [this] { return wallTime(); })
    {
    }

    /// Whose axes have these names.
    explicit CompensatorFixture(const std::array<std::string, 2>& names)
        : CompensatorFixture(inProcess(), drivecomm::genericProfile(), names)
    {
    }

    static drivecomm::VirtualDriveOptions options(std::atomic<std::int64_t>& milliseconds,
        const std::array<std::string, 2>& names = {"X", "Y"})
    {
        drivecomm::VirtualDriveOptions options;
        options.name = "Test-1";
        options.serialNumber = 4711;
        options.axes = {{.name = names[0]}, {.name = names[1], .periodSeconds = 37.0}};
        options.clock = [&milliseconds] {
            return std::chrono::nanoseconds(std::chrono::milliseconds(++milliseconds));
        };
        return options;
    }

    [[nodiscard]] WallTime wallTime() const
    {
        return WallTime(std::chrono::hours(24 * 365 * 50) + std::chrono::milliseconds(time.load()));
    }
    [[nodiscard]] std::filesystem::path storeRoot() const
    {
        return std::filesystem::path(folder.path().toStdString()) / "axiscomp";
    }
    void pass(std::chrono::milliseconds duration) { time += duration.count(); }

    /// What the drive holds for an axis: Table and sources, and the bytes and the persistency of
    /// the table that they name.
    struct State {
        std::vector<std::string> registers;
        Bytes table;
        std::string persistent;
        friend bool operator==(const State&, const State&) = default;
    };
    [[nodiscard]] State state(int axis = 0) { return stateOf(drive, axis); }
    [[nodiscard]] static State stateOf(drivecomm::VirtualDrive& drive, int axis)
    {
        const std::string base =
            "Axes[" + std::to_string(axis) + "]/Parameters/Compensations/Axis/";
        State state;
        const auto readings = drive.readRegisters(
            {base + "Table", base + "Dim1Source", base + "Dim2Source", base + "Dim3Source"});
        for (const RegisterReading& reading : *readings)
            state.registers.push_back(toText(reading.value));
        if (const TableSlot* slot = drivecomm::genericProfile().slotNamed(state.registers[0])) {
            state.table = drive.download(slot->file).value_or(Bytes{});
            const auto persistent =
                drive.readRegisters({"Application/Tables/" + slot->name + "/Header/Persistent"});
            state.persistent = toText(persistent->front().value);
        }
        return state;
    }
    [[nodiscard]] std::string text(const std::string& path)
    {
        const auto readings = drive.readRegisters({path});
        return readings ? toText(readings->front().value) : "no such register";
    }
    void set(const std::string& path, const RegisterValue& value)
    {
        const auto written = drive.writeRegisters({{path, value}});
        QVERIFY2(written.has_value(), path.c_str());
    }

    std::atomic<std::int64_t> time = 0;
    QTemporaryDir folder;
    /// Told of every request to the drive; set and cleared while there is none.
    drivecomm::FaultPlan::Observer requested;
    drivecomm::FaultPlan faults{{}, [this](bool isWrite) {
                                    if (requested)
                                        requested(isWrite);
                                }};
    drivecomm::VirtualDrive drive;
    std::unique_ptr<LinkAttachment> attachment;
    FaultyLink link;
    DriveStore store;
    AxisCompensator compensator;
};

inline const std::string masterX = "Axes[0]/Signals/PositionController/MasterPosition";
inline const std::string masterY = "Axes[1]/Signals/PositionController/MasterPosition";

/// A write of a 2D table to axis 0.
inline WriteRequest exampleRequest(int seed = 1, Persistency persistency = Persistency::Volatile)
{
    WriteRequest request;
    request.dimensionality = 2;
    request.sources = {masterX, masterY};
    request.table = exampleTable(2, seed);
    request.persistency = persistency;
    return request;
}

} // namespace axiscomp::test
