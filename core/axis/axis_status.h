// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/compensation_setup.h"
#include "core/drive/drive_link.h"
#include "core/drive/journal_entry.h"
#include "core/drive/travel_coverage.h"
#include "core/table/grid.h"
#include "core/table/table_identity.h"
#include "core/table/table_units.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>

namespace axiscomp {

/// What the compensation of an axis is doing (AN140 4.3). Unknown: the axis has no compensation, or
/// the drive says a word that its profile does not have.
enum class CompensationState { Disabled, Evaluating, Ramping, Active, Error, Unknown };

/// Why a compensation does not work. Other: a reason that the profile does not have.
enum class CompensationFault {
    None,
    NotHomed,
    NoTable,
    DimensionMismatch,
    BadSource,
    BadTable,
    Other
};

/// The words are the drive's own, to be shown; what they mean is decided once, by axis_reader.
struct AxisInfo {
    int index = 0;
    std::string folder; ///< "Axes[0]/": the paths of its registers begin with it
    std::string signalFolder; ///< "Axes[0]/Signals/": those of what it measures and computes
    std::string name; ///< may be empty
    std::string unit; ///< the drive's PositionUnit: "Millimeter"
    std::optional<Travel> travel; ///< none: the drive does not say
    std::string homingWord; ///< "HomingDone"
    bool isHomed = false;
    std::string stateWord; ///< "Active"; empty when the axis has no compensation registers
    CompensationState state = CompensationState::Unknown;

    [[nodiscard]] bool hasCompensation() const { return !stateWord.empty(); }
};

/// The header of the table in the axis's slot, as the drive shows it.
struct TableHeader {
    Grid grid;
    std::uint32_t elements = 0;
    std::uint32_t crc = 0;
    bool persistent = false;
};

/// Without a grid where the drive does not show all of it (NaN, the size 0): positions of which a
/// part is known are not compared.
[[nodiscard]] TableIdentity identityOf(const TableHeader& table);

/// Everything the drive says about one axis, read at one instant where the profile allows.
struct AxisStatus {
    DriveIdentity drive;
    AxisInfo axis;
    CompensationSetup setup;
    std::optional<TableHeader> table; ///< none: no slot chosen, or the slot is empty
    std::string activation;
    std::string error; ///< the drive's word for its compensation error, "None"
    CompensationFault fault = CompensationFault::None;
    double output = 0.0; ///< value now added to the encoder position, in position units
    std::array<double, 3> indices{};
    std::array<double, 3> sourceValues{}; ///< of the set sources
    /// PositionUnit of the axes whose positions the sources are; empty: one is none, or the drive
    /// does not say.
    std::array<std::string, 3> sourceUnits{};
    std::string driveError; ///< the drive's word for an error of the whole drive, "None"
    bool hasDriveError = false;
    std::optional<JournalEntry> unfinishedWrite; ///< an earlier write that did not end

    /// Active, or on the way: nothing of the axis may be changed.
    [[nodiscard]] bool isOn() const
    {
        return axis.state == CompensationState::Active || axis.state == CompensationState::Ramping;
    }
};

/// In which units the drive has the numbers of the axis's table.
[[nodiscard]] TableUnits unitsOfTable(const AxisStatus& status);

} // namespace axiscomp
