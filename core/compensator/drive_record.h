// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_status.h"
#include "core/axis/proof.h"
#include "core/base/result.h"
#include "core/base/wall_time.h"
#include "core/drive/drive_profile.h"
#include "core/metrology/record/calibration_record.h"
#include "core/store/measured_figures.h"
#include "core/table/table_identity.h"
#include "core/table/table_layout.h"

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace axiscomp {

// What a drive holds, in the record of a compensation.

/// A record is of one axis: that of its first write, or of its measurement where a drive took part
/// in that; and of the drive that its measurement states. An axis that has the name of another one
/// by now (areDifferentAxes) is not that axis. Errors: InvalidArgument, with both.
[[nodiscard]] Result<void> checkRecordAxis(
    const CalibrationRecord& record, const AxisStatus& status);

/// Whether a table is one of the record: as it has the numbers, in mm or deg, or as a drive shows
/// them whose axis is in m or rad. Without a grid it is known by its CRC-32 alone.
[[nodiscard]] bool hasTable(
    const CalibrationRecord& record, const TableIdentity& found, const TableLayout& layout);

/// Whether the sources are on the side of the compensation for which the record's table was made
/// (checkLookupSources). Errors: InvalidArgument, with the way out.
[[nodiscard]] Result<void> checkRecordSources(const CalibrationRecord& record,
    const DriveProfile& profile, int axis, std::span<const std::string> sources);

/// Notes that the axis holds the table. now: as read after the write. What was on record of an
/// earlier write, and its proof, is replaced. Errors: as checkRecordAxis; NoTable.
[[nodiscard]] Result<void> recordWrite(CalibrationRecord& record, const AxisStatus& now,
    const std::string& profileName, WallTime time);

/// Whether the axis has the table that was written by the record (isSameTable), in the units in
/// which it was written, looked up where the record's table belongs. Of an older record, which has
/// no units, one of its tables has to be the one that was written, in the units of now. Errors: as
/// checkRecordAxis; InvalidArgument for a record that was not written, and for another table;
/// UnitMismatch; as checkRecordSources; TargetMismatch.
[[nodiscard]] Result<void> checkRecordTable(
    const CalibrationRecord& record, const AxisStatus& status, const DriveProfile& profile);

/// The same rule for the figures that this computer has kept: whether the axis looks its table up
/// where that of the record belongs. What is not stated fits.
[[nodiscard]] bool isLookedUpAsMade(
    const MadeForLookup& made, const AxisStatus& status, const DriveProfile& profile);

/// And whether the numbers of the table still mean what they meant, on the axis that it was (the
/// rule of checkRecordTable and checkRecordAxis). What is not noted fits.
[[nodiscard]] bool isMeantAsKept(const MeasuredFigures& kept, const AxisStatus& status);

/// Notes the proof of the record's table; one that shows nothing (Proof::Extent) is none and leaves
/// the record as it is. Errors: as checkRecordTable.
[[nodiscard]] Result<void> recordProof(CalibrationRecord& record, const AxisStatus& now,
    const Proof& proof, const DriveProfile& profile);

} // namespace axiscomp
