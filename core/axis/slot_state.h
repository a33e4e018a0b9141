// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/register_access.h"

namespace axiscomp {

/// What a slot holds and who uses it, in one reading: two readings differ when somebody else has
/// changed the slot in between.
struct SlotState {
    std::uint32_t elements = 0; ///< 0: empty
    std::uint32_t crc = 0; ///< of the elements
    bool persistent = false;
    Text otherUser; ///< "axis 1", "the cogging compensation of axis 0"; empty: none

    [[nodiscard]] bool isEmpty() const { return elements == 0; }
    friend bool operator==(const SlotState&, const SlotState&) = default;
};

/// What slotState needs to have been read. `axis` is whose user of the slot does not count.
[[nodiscard]] std::vector<std::string> slotStatePaths(
    const RegisterAccess& access, const DriveIdentity& drive, int axis, std::string_view slot);
[[nodiscard]] SlotState slotState(const RegisterAccess& access, const DriveIdentity& drive,
    int axis, std::string_view slot, const Readings& readings);

/// For errors: "empty", "36 values (CRC 00c0ffee), volatile, used by axis 1"
[[nodiscard]] Text slotStateText(const SlotState& state);

} // namespace axiscomp
