// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"
#include "core/compensator/axis_compensator.h"
#include "core/machine/machine_file.h"

#include <cstddef>
#include <filesystem>
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
/// those of the link, wholeStatus and AxisCompensator::readTable; SourceMissing for a table that is
/// not looked up by all of its dimensions.
[[nodiscard]] Result<DriveSnapshot> snapshotDrive(AxisCompensator& compensator,
    const DriveProfile& profile, const std::filesystem::path& storeRoot,
    const std::string& endpoint, const OperationOptions& options);

/// The file of a snapshot that says which drive has which tables.
inline constexpr const char* machineFileName = "machine.toml";

/// A machine file and those of its tables, to stand in one folder. The same state of the same
/// drives always gives the same bytes.
struct MachineSnapshot {
    std::vector<DriveSnapshot::TableFile> files; ///< the machine file is the last one
    std::size_t drives = 0; ///< that the machine file names

    /// Of the tables alone.
    [[nodiscard]] std::size_t tables() const { return files.size() - 1; }
};

/// All drives as one machine, in the order of their serial numbers; those without a compensation
/// are left out. name: of the machine, may be empty. Errors: InvalidArgument where the result would
/// be no machine file: no drive is left, one of them is there twice, or the name has control
/// characters.
[[nodiscard]] Result<MachineSnapshot> joinSnapshots(
    std::string name, std::vector<DriveSnapshot> drives);

/// Names of the files that saveSnapshot would replace by other bytes. What cannot be read counts as
/// other bytes.
[[nodiscard]] std::vector<std::string> replacedFiles(
    const MachineSnapshot& snapshot, const std::filesystem::path& folder);

/// Makes the folder where there is none; the machine file is written last, so that what it names is
/// there. Errors: FileNotWritable.
[[nodiscard]] Result<void> saveSnapshot(
    const MachineSnapshot& snapshot, const std::filesystem::path& folder);

} // namespace axiscomp
