// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/tam_table.h"
#include "drivecomm/profile/profile_loader.h"
#include "drivecomm/virtualdrive/firmware/virtual_drive.h"
#include "tests/drivecomm/known_paths.h"
#include "tests/support/verify.h"

#include <algorithm>
#include <chrono>
#include <memory>

namespace axiscomp::test {

using namespace std::chrono_literals;

/// The paths of docs/drive.md, spelled out: the tests check that the profile and the drive have
/// these and no others.
inline std::string axisPath(int axis, const std::string& rest)
{
    return "Axes[" + std::to_string(axis) + "]/" + rest;
}
inline const std::string compensation = "Parameters/Compensations/Axis/";
inline const std::string tableOf0 = axisPath(0, compensation + "Table");
inline const std::string activationOf0 = axisPath(0, "Commands/Compensations/Axis/Activation");
inline const std::string stateOf0 = axisPath(0, "Signals/Compensations/Axis/State");
inline const std::string errorOf0 = axisPath(0, "Signals/Compensations/Axis/Error");
inline const std::string outputOf0 = axisPath(0, "Signals/Compensations/Axis/Output");
inline const std::string masterOf0 = axisPath(0, "Signals/PositionController/MasterPosition");
inline const std::string masterOf1 = axisPath(1, "Signals/PositionController/MasterPosition");
inline const std::string homingOf0 = axisPath(0, "Signals/Homing/State");
inline const std::string homeAxis0 = axisPath(0, "Commands/Homing/Command");
inline const std::string driveError = "General/Signals/DriveError";
inline const std::string save = "General/Commands/SaveParameters";

inline std::string sourceOf0(int n)
{
    return axisPath(0, compensation + "Dim" + std::to_string(n) + "Source");
}
inline std::string indexOf0(int n)
{
    return axisPath(0, "Signals/Compensations/Axis/Dim" + std::to_string(n) + "Index");
}
inline std::string slotPath(const std::string& slot, const std::string& rest)
{
    return "Application/Tables/" + slot + "/" + rest;
}

/// From 0 in steps of 10: covers the axes' range 0 to 100 and a bit more.
inline CompensationTable evenTable(int dimensions, float scale = 0.001F, std::uint32_t size = 12)
{
    CompensationTable table;
    table.name = "bench";
    for (int n = 0; n < dimensions; ++n)
        table.grid.axes.push_back({{}, {}, 0.0, 10.0, size});
    for (std::size_t i = 0; i < table.grid.pointCount(); ++i)
        table.values.push_back(scale * static_cast<float>(i % 13) - scale * 3.0F);
    return table;
}

/// The same value everywhere.
inline CompensationTable flatTable(float value)
{
    CompensationTable table = evenTable(1);
    std::ranges::fill(table.values, value);
    return table;
}

/// A virtual drive of two axes X and Y whose clock is moved by hand.
struct DriveFixture {
    explicit DriveFixture(int axes = 2)
    {
        for (int n = 0; n < axes; ++n)
            options.axes.push_back({n < 2 ? std::string(1, static_cast<char>('X' + n)) : "",
                "Millimeter", 0.0, 100.0, 60.0 + n, true});
        options.clock = [this] { return time; };
        options.wallClock = [this] { return wallTime; };
        start();
    }

    void start()
    {
        drive.reset();
        auto made = drivecomm::VirtualDrive::create(profile, options);
        QVERIFY2(made.has_value(), made ? "" : describe(made.error()).c_str());
        drive = *std::move(made);
    }

    [[nodiscard]] RegisterReading reading(const std::string& path)
    {
        const auto read = drive->readRegisters({path});
        return read ? read->front() : RegisterReading{sentence(read.error()), 0, {}, {}};
    }
    [[nodiscard]] std::string text(const std::string& path) { return toText(reading(path).value); }
    [[nodiscard]] double number(const std::string& path) { return toDouble(reading(path).value); }
    [[nodiscard]] std::uint32_t address(const std::string& path) { return reading(path).address; }

    Result<void> set(const std::string& path, const RegisterValue& value)
    {
        return drive->writeRegisters({{path, value}});
    }
    [[nodiscard]] Bytes encoded(const CompensationTable& table, bool persistent = false) const
    {
        return encodeTamTable(table, persistent, profile.layout).value_or(Bytes{});
    }
    Result<void> upload(
        const std::string& slot, const CompensationTable& table, bool persistent = false)
    {
        return drive->upload(profile.slotNamed(slot)->file, encoded(table, persistent));
    }
    [[nodiscard]] Bytes file(const std::string& slot)
    {
        return drive->download(profile.slotNamed(slot)->file).value_or(Bytes{});
    }

    /// Axis 0 uses slot, with these sources.
    Result<void> select(const std::string& slot, const std::vector<std::string>& sources)
    {
        std::vector<RegisterWrite> writes{{tableOf0, slot}};
        for (int n = 1; n <= 3; ++n)
            writes.push_back({sourceOf0(n),
                n <= static_cast<int>(sources.size())
                    ? address(sources[static_cast<std::size_t>(n - 1)])
                    : std::uint32_t{0}});
        return drive->writeRegisters(writes);
    }
    /// Axis 0 compensates by a table in Small1 over its own position.
    Result<void> activate(const CompensationTable& table)
    {
        if (Result<void> done = upload("Small1", table); !done)
            return done;
        if (Result<void> done = select("Small1", {masterOf0}); !done)
            return done;
        return set(activationOf0, "AddToEncoders");
    }

    const DriveProfile& profile = drivecomm::genericProfile();
    std::chrono::nanoseconds time{0};
    WallTime wallTime{std::chrono::hours(24 * 365 * 50)};
    drivecomm::VirtualDriveOptions options;
    std::unique_ptr<drivecomm::VirtualDrive> drive;
};

} // namespace axiscomp::test

/// Compares std::string, printing both on failure.
#define COMPARE_TEXT(actual, expected)                                                             \
    QCOMPARE(QString::fromStdString(actual), QString::fromStdString(expected))
