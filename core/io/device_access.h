// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"

#include <optional>
#include <string>

namespace axiscomp {

/// Why this user may not use a port, and what to do about it.
struct DeviceObstacle {
    Text found;
    Text wayOut = {}; ///< may be empty
    std::string group = {}; ///< to join, or to begin a session with; empty: none would help
    int systemError = 0; ///< errno
};

/// A port as this user finds it.
struct DeviceAccess {
    std::string device; ///< all symbolic links followed; empty: there is none
    std::optional<DeviceObstacle> obstacle; ///< none: it may be read and written
};

/// Looks without opening the port.
[[nodiscard]] DeviceAccess deviceAccess(const std::string& path);

/// Who may use a port that this user may not.
struct DeviceGroup {
    std::string name; ///< empty: nobody but its owner and root
    bool hasAccount = false; ///< the user's account is in it
    bool hasSession = false; ///< and this session, which keeps the groups that it began with
};
[[nodiscard]] DeviceObstacle noPermission(const DeviceGroup& group);

} // namespace axiscomp
