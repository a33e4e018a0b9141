// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

/// What a drive does not tell about what a reboot brings back, as far as the programs of this
/// computer have brought it about.
struct RebootState {
    /// A slot that the saved parameters of an axis name, or may name.
    struct Use {
        int axis = 0;
        std::string slot;
        std::uint32_t crc = 0; ///< of the elements that the slot held when they were saved
        friend bool operator==(const Use&, const Use&) = default;
    };
    bool isKnown = false; ///< a program has saved the parameters of this drive
    std::vector<Use> uses;
    /// Slots where flash may hold another table than the volatile one that lies over it.
    std::vector<std::string> covered;
    friend bool operator==(const RebootState&, const RebootState&) = default;

    [[nodiscard]] bool isCovered(std::string_view slot) const;
    /// The first axis but this one whose saved parameters name the slot.
    [[nodiscard]] std::optional<int> otherUser(std::string_view slot, int axis) const;
    /// To put this table into the slot's flash would give an axis the table of one write and
    /// the saved sources of another.
    [[nodiscard]] bool isInTheWay(std::string_view slot, int axis, std::uint32_t crc) const;
};

} // namespace axiscomp
