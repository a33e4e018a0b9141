// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/tam_table.h"
#include "drivecomm/profile/profile_loader.h"
#include "drivecomm/serial/serial_drive_link.h"
#include "drivecomm/virtualdrive/serial/serial_server.h"
#include "tests/drivecomm/known_paths.h"
#include "tests/support/serial_wire.h"
#include "tests/support/verify.h"

#include <QTest>

namespace axiscomp::test {

using namespace drivecomm;
using namespace std::chrono_literals;

inline std::unique_ptr<DriveLink> serialLinkTo(const std::string& url)
{
    return makeSerialDriveLink(parseEndpoint(url).value(), genericProfile());
}

inline Bytes serialTableFile(std::uint32_t points, float scale = 0.001F)
{
    CompensationTable table;
    table.name = "serial";
    table.grid.axes.push_back({{}, {}, 0.0, 1.0, points});
    for (std::uint32_t i = 0; i < points; ++i)
        table.values.push_back(scale * static_cast<float>(i % 17));
    return encodeTamTable(table, false, genericProfile().layout).value_or(Bytes{});
}
/// Fills a small slot: 63360 bytes.
inline Bytes fullTable(float scale = 0.001F)
{
    return serialTableFile((63360 - 128) / 4, scale);
}

/// A virtual drive behind a serial port.
struct SerialDrive {
    explicit SerialDrive(const SerialServerOptions& options = {})
        : server(SerialServer::start(drive, faults, options).value())
    {
    }

    static VirtualDriveOptions options()
    {
        VirtualDriveOptions options;
        options.name = "Serial-1";
        options.serialNumber = 1559;
        options.axes = {{.name = "X"}, {.name = "Y"}};
        return options;
    }

    [[nodiscard]] Bytes file(const std::string& path)
    {
        return drive.download(path).value_or(Bytes{});
    }

    VirtualDrive drive{genericProfile(), options()};
    FaultPlan faults;
    std::unique_ptr<SerialServer> server;
};

} // namespace axiscomp::test
