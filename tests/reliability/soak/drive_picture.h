// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/lookup.h"
#include "drivecomm/virtualdrive/firmware/virtual_drive.h"

#include <array>
#include <map>
#include <optional>
#include <string>
#include <vector>

namespace axiscomp::test {

/// What one axis of a drive compensates with, as the drive itself has it.
struct AxisPicture {
    std::string slot; ///< "Disabled": none
    std::array<std::uint32_t, 3> sources{}; ///< addresses, 0 = unset
    Bytes table; ///< the file in the slot, Persistent set to false; empty: none
    bool persistent = false;

    friend bool operator==(const AxisPicture&, const AxisPicture&) = default;
    /// The same compensation, in whatever slot.
    [[nodiscard]] bool compensatesAs(const AxisPicture& other) const
    {
        return sources == other.sources && table == other.table && persistent == other.persistent;
    }
    /// The drive would switch it on, right or wrong.
    [[nodiscard]] bool canBeActivated() const;
    /// "Small1 (crc 1c291ca3, 304 bytes, volatile), sources 12 13 0"
    [[nodiscard]] std::string text() const;
};

/// Everything of a drive that a program can change, at one instant.
struct DrivePicture {
    std::vector<AxisPicture> axes;
    std::vector<std::string> states; ///< of the axes' compensations
    std::map<std::string, Bytes> slots; ///< files by slot name, those that are not empty
    std::uint64_t flashCycles = 0; ///< of all slots
    std::string driveError;

    /// The axis that names the slot.
    [[nodiscard]] std::optional<int> userOf(const std::string& slot) const;
    [[nodiscard]] bool isOn(int axis) const;
};

[[nodiscard]] DrivePicture pictureOf(drivecomm::VirtualDrive& drive);

/// The address of a register; 0 when there is none.
[[nodiscard]] std::uint32_t addressOf(drivecomm::VirtualDrive& drive, const std::string& path);

/// Compares an axis that is Active, or Evaluating, with core's lookup at the same instant: what is
/// wrong, or nothing.
[[nodiscard]] std::optional<std::string> wrongOutput(drivecomm::VirtualDrive& drive, int axis);

} // namespace axiscomp::test
