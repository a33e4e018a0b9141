// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"
#include "core/compensator/axis_compensator.h"
#include "core/machine/machine_file.h"

#include <string>
#include <vector>

namespace axiscomp {

/// One drive as a section of a machine file, with the files of its tables.
struct DriveSnapshot {
    MachineDrive drive;
    struct TableFile {
        std::string name; ///< "100001-axis0.csv"
        Bytes bytes;
        friend bool operator==(const TableFile&, const TableFile&) = default;
    };
    std::vector<TableFile> files; ///< of the axes that use a table
};

/// Reads all axes that have a compensation; changes nothing. A table is a calibration file with the
/// drive's units where that gives every bit back, else a TAM table. What the drive does not need
/// to be the same is not in it: the slots. endpoint: as the machine file shall have it. Errors:
/// those of the link; SourceMissing for a table that is not looked up by all of its dimensions.
[[nodiscard]] Result<DriveSnapshot> snapshotDrive(AxisCompensator& compensator,
    const DriveProfile& profile, const std::string& endpoint, const OperationOptions& options);

} // namespace axiscomp
