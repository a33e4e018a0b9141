// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/demo_link.h"

#include "core/table/tam_table.h"
#include "drivecomm/virtualdrive/direct_link.h"
#include "drivecomm/virtualdrive/firmware/drive_registers.h"

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

class DemoLink final : public DriveLink {
public:
    explicit DemoLink(const DriveProfile& profile)
        : m_drive(profile, demoDriveOptions())
        , m_link(makeDirectLink(m_drive))
    {
    }

    [[nodiscard]] Result<void> loadState() { return loadDemoState(m_drive); }

    std::string endpoint() const override { return m_link->endpoint(); }
    Result<DriveIdentity> identify(const Exchange& exchange) override
    {
        return m_link->identify(exchange);
    }
    Result<std::vector<RegisterReading>> readRegisters(
        std::span<const std::string> paths, const Exchange& exchange) override
    {
        return m_link->readRegisters(paths, exchange);
    }
    Result<std::vector<RegisterReading>> readTree(
        const std::string& prefix, const Exchange& exchange) override
    {
        return m_link->readTree(prefix, exchange);
    }
    Result<void> writeRegisters(
        std::span<const RegisterWrite> writes, const Exchange& exchange) override
    {
        return m_link->writeRegisters(writes, exchange);
    }
    Result<std::vector<DriveFile>> listFiles(const Exchange& exchange) override
    {
        return m_link->listFiles(exchange);
    }
    Result<Bytes> download(const std::string& path, const Exchange& exchange) override
    {
        return m_link->download(path, exchange);
    }
    Result<void> upload(const std::string& path, ByteView bytes, const Exchange& exchange) override
    {
        return m_link->upload(path, bytes, exchange);
    }

private:
    VirtualDrive m_drive;
    std::unique_ptr<DriveLink> m_link;
};

} // namespace

VirtualDriveOptions demoDriveOptions()
{
    VirtualDriveOptions options;
    options.name = "Demo";
    options.serialNumber = 100042;
    options.axes = {{"X", "Millimeter", 0.0, rangeX, 40.0, true, true},
        {"Y", "Millimeter", 0.0, rangeY, 30.0, true, true}};
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
    AXISCOMP_TRY(const auto sources,
        drive.readRegisters({expandPath(registers::masterPosition, {.axis = 0}),
            expandPath(registers::masterPosition, {.axis = 1})}));
    const auto source = [&](int n) {
        return RegisterWrite{expandPath(paths.source, {.axis = 0, .n = n + 1}),
            sources.at(static_cast<std::size_t>(n)).address};
    };
    return drive.writeRegisters({{expandPath(paths.table, {.axis = 0}), slot.name}, source(0),
        source(1), {paths.saveParameters, profile.enums.saveParametersSave},
        {expandPath(paths.activation, {.axis = 0}), profile.enums.activationAddToEncoders}});
}

Result<std::unique_ptr<DriveLink>> makeDemoLink(const DriveProfile& profile)
{
    auto demo = std::make_unique<DemoLink>(profile);
    if (auto loaded = demo->loadState(); !loaded)
        return fail(std::move(loaded.error()));
    return demo;
}

} // namespace axiscomp::drivecomm
