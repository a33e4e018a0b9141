// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/serial/device_node.h"

#include "core/io/device_access.h"

#include <cstring>
#include <utility>

namespace axiscomp::drivecomm {

Result<std::string> usableDevice(const std::string& path)
{
    DeviceAccess access = deviceAccess(path);
    if (!access.obstacle)
        return std::move(access.device);
    const DeviceObstacle& obstacle = *access.obstacle;
    Text reason = obstacle.found;
    if (!obstacle.wayOut.isEmpty())
        reason = AXISCOMP_TEXT("Error", "{found}; {wayOut}")
                     .with("found", obstacle.found)
                     .with("wayOut", obstacle.wayOut);
    // NOLINTNEXTLINE(concurrency-mt-unsafe): glibc's is thread-safe
    const char* detail = std::strerror(obstacle.systemError);
    return fail(ErrorCode::NotConnected, {{"reason", std::move(reason)}}, detail);
}

} // namespace axiscomp::drivecomm
