// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/base/wall_time.h"
#include "core/drive/drive_link.h"
#include "core/drive/register_value.h"

#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

/// What one axis had before a write: its registers, and the files of the slots that the write
/// touches.
struct AxisBackup {
    DriveIdentity drive;
    int axis = 0;
    std::string axisName;
    WallTime time{};
    std::vector<RegisterWrite> registers; ///< Table, Dim1Source .. Dim3Source
    struct File {
        std::string slot;
        std::string path;
        Bytes bytes; ///< empty: the slot was empty
        bool persistent = false;
        friend bool operator==(const File&, const File&) = default;
    };
    std::vector<File> files;
    /// PositionUnit of the axis, in which the values of its table are; empty: not known.
    std::string unit{};
    /// The same of the axes whose positions the sources are, dimension by dimension, as far as
    /// known.
    std::vector<std::string> sourceUnits{};
    /// The profile with which it was made, and how that reads the bytes of the files
    /// (layoutText); empty: not known.
    std::string profile{};
    std::string layout{};
    /// The registers whose addresses the sources are, dimension by dimension, as far as known.
    std::vector<std::string> sourcePaths{};

    friend bool operator==(const AxisBackup&, const AxisBackup&) = default;
};

/// Everything the program can change on a drive (`axiscomp backup`): one AxisBackup per axis, and
/// the tables that no axis uses.
struct DriveBackup {
    std::vector<AxisBackup> axes;
    std::vector<AxisBackup::File> otherFiles{};
    /// Of a backup without axes, which name their drive themselves.
    std::optional<DriveIdentity> drive{};

    friend bool operator==(const DriveBackup&, const DriveBackup&) = default;
};

/// Bytes that a backup file may have: for loadFile. Several times what any drive's tables need.
inline constexpr std::uint64_t maximumBackupSize = 128ULL * 1024 * 1024;

/// JSON, format "axiscomp-backup", version 1: tables as base64 with their CRC-32, times in UTC,
/// every register with its type. The same backup always gives the same text.
[[nodiscard]] std::string writeBackup(const DriveBackup& backup);

/// Takes exactly what writeBackup writes, in any order of members and any white space. Errors:
/// InvalidBackup; its reason names the JSON path of the fault ("axes[0].files[1].crc32: ...").
[[nodiscard]] Result<DriveBackup> readBackup(std::string_view text, const std::string& fileName);

} // namespace axiscomp
