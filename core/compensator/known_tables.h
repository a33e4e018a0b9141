// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_status.h"
#include "core/base/result.h"
#include "core/drive/drive_profile.h"
#include "core/metrology/fit/known_tables.h"
#include "core/metrology/fit/lookup_frame.h"
#include "core/metrology/fit/measured_state.h"
#include "core/store/drive_store.h"
#include "core/table/compensation_table.h"

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

namespace axiscomp {

// What an axis says of the tables that may have been active while it was measured.

/// What an axis of a drive has to say of a measurement of it.
struct AxisTables {
    KnownTables active; ///< the table that the axis uses
    std::optional<LookupAt> lookupAt; ///< nothing: its source is no position that the profile knows
    std::string source; ///< the path of it
    std::vector<KnownTables> backups; ///< tables that it had before, newest first
    std::vector<Text> remarks; ///< what is assumed of units
    std::vector<Error> unreadable; ///< backups that cannot be read
};

/// Which axis, and by which register its new table will be looked up.
struct AxisOfDrive {
    AxisInfo axis;
    std::int32_t serialNumber = 0; ///< of the drive
    std::string source; ///< see lookupSource; empty: none is set
    std::optional<LookupAt> lookupAt; ///< of the table that it has
    std::array<DimSource, 3> sources{}; ///< that it has
};
[[nodiscard]] AxisOfDrive axisOfDrive(const AxisStatus& status, const DriveProfile& profile);

/// table: the one that the axis uses, as it was downloaded. Tables of backups are in the units in
/// which they were kept, where their backup says them. Reads the backups of the axis: not for a
/// thread that must not wait. Errors: UnitMismatch; those of elementCrc.
[[nodiscard]] Result<AxisTables> tablesOfAxis(const AxisOfDrive& axis, CompensationTable table,
    const DriveProfile& profile, const DriveStore& store, const std::string& unit);

/// That a person and the source of the axis say the same of where it looks its table up. Errors:
/// InvalidArgument.
[[nodiscard]] Result<void> checkLookupAt(
    LookupAt stated, const DriveProfile& profile, const std::string& source);

} // namespace axiscomp
