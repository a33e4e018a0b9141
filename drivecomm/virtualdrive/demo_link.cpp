// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/tam_table.h"
#include "drivecomm/virtualdrive/firmware/drive_registers.h"
#include "drivecomm/virtualdrive/firmware/virtual_drive.h"

#include <cmath>
#include <numbers>

namespace axiscomp::drivecomm {

namespace {

constexpr double rangeX = 300.0; // mm
constexpr double rangeY = 200.0;

/// The error of X over the area of a cross table as one measures it: a scale error, the waviness of
/// the guide, and the yaw of X that grows with Y.
double measuredErrorMm(double x, double y)
{
    const double scale = 12e-6 * x;
    const double waviness = 0.0015 * std::sin(2.0 * std::numbers::pi * x / 120.0);
    const double yaw = 0.002 * (y / rangeY - 0.5) * std::cos(std::numbers::pi * x / rangeX);
    return scale + waviness + yaw;
}

CompensationTable demoTable()
{
    constexpr double spacing = 10.0;
    const auto points = [](double range) {
        return static_cast<std::uint32_t>(range / spacing) + 1;
    };
    CompensationTable table{"Demo X over X, Y", "mm",
        {{{"X", "mm", 0.0, spacing, points(rangeX)}, {"Y", "mm", 0.0, spacing, points(rangeY)}}},
        {}};
    const auto& axes = table.grid.axes;
    for (std::size_t iy = 0; iy < axes[1].size; ++iy)
        for (std::size_t ix = 0; ix < axes[0].size; ++ix)
            table.values.push_back(
                static_cast<float>(measuredErrorMm(axes[0].position(ix), axes[1].position(iy))));
    return table;
}

} // namespace

VirtualDriveOptions demoDriveOptions()
{
    VirtualDriveOptions options;
    options.name = "Demo";
    options.serialNumber = 100042;
    options.axes = {
        {"X", "Millimeter", 0.0, rangeX, 40.0, true}, {"Y", "Millimeter", 0.0, rangeY, 30.0, true}};
    return options;
}

Result<void> loadDemoState(VirtualDrive& drive)
{
    const DriveProfile& profile = drive.profile();
    const RegisterPaths& paths = profile.registers;
    const TableSlot& slot = profile.tableSlots.front();
    const Result<Bytes> file = encodeTamTable(demoTable(), true, profile.layout);
    if (!file)
        return fail(file.error());
    if (Result<void> uploaded = drive.upload(slot.file, *file); !uploaded)
        return uploaded;
    const auto sources = drive.readRegisters({expandPath(registers::masterPosition, {.axis = 0}),
        expandPath(registers::masterPosition, {.axis = 1})});
    if (!sources)
        return fail(sources.error());
    const auto source = [&](int n) {
        return RegisterWrite{expandPath(paths.source, {.axis = 0, .n = n + 1}),
            sources->at(static_cast<std::size_t>(n)).address};
    };
    return drive.writeRegisters({{expandPath(paths.table, {.axis = 0}), slot.name}, source(0),
        source(1), {paths.saveParameters, profile.enums.saveParametersSave},
        {expandPath(paths.activation, {.axis = 0}), profile.enums.activationAddToEncoders}});
}

} // namespace axiscomp::drivecomm
