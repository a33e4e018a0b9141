// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/compensation_setup.h"
#include "core/drive/drive_link.h"
#include "core/drive/journal_entry.h"
#include "core/table/grid.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace axiscomp {

struct AxisInfo {
    int index = 0;
    std::string name; ///< may be empty
    std::string unit; ///< the drive's PositionUnit: "Millimeter"
    std::string homing; ///< "HomingDone"
    std::string state; ///< compensation state; empty when the axis has no compensation registers
};

/// The header of the table in the axis's slot, as the drive shows it.
struct TableHeader {
    Grid grid;
    std::uint32_t elements = 0;
    std::uint32_t crc = 0;
    bool persistent = false;
};

/// Everything the drive says about one axis, read at one instant where the profile allows.
struct AxisStatus {
    DriveIdentity drive;
    AxisInfo axis;
    CompensationSetup setup;
    std::optional<TableHeader> table; ///< none: no slot chosen, or the slot is empty
    std::string activation;
    std::string error; ///< the drive's compensation error, "None"
    double output = 0.0; ///< value now added to the encoder position, in position units
    std::array<double, 3> indices{};
    std::array<double, 3> sourceValues{}; ///< of the set sources
    std::string driveError;
    std::optional<JournalEntry> unfinishedWrite; ///< an earlier write that did not end
};

} // namespace axiscomp
