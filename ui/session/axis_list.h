// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_link.h"
#include "ui/session/axis_entry.h"

#include <QString>

#include <span>
#include <string>
#include <vector>

namespace axiscomp::ui {

/// A drive that has been found, and whether it answers now.
struct DriveAxes {
    QString endpoint;
    bool isDemo = false;
    bool isConnected = false;
    DriveIdentity drive;
    std::vector<AxisInfo> axes;
};

/// The axes of all drives, in their order. A label says as much as is needed to be the only one of
/// its kind: the axis's index when its name is not the only one, the drive's serial number, the
/// endpoint. An axis without a name is "Axis 3".
[[nodiscard]] std::vector<AxisEntry> axisEntries(std::span<const DriveAxes> drives);

/// The label of an entry, in the language of the moment.
[[nodiscard]] QString axisLabel(const AxisEntry& entry);

/// The same without the drive: "X", "X [1]" when the drive has several of that name.
[[nodiscard]] QString axisNameOnDrive(const AxisEntry& entry);

/// "X · PositionController/MasterPosition", "Application/Variables/Floats[3]"
[[nodiscard]] QString registerName(const std::string& path, std::span<const AxisEntry> axesOfDrive);

} // namespace axiscomp::ui
