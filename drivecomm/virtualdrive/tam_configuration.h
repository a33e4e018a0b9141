// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/drive/register_value.h"
#include "drivecomm/virtualdrive/firmware/virtual_drive.h"

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp::drivecomm {

/// The drives of a TAM configuration file (.TAMcfg; XML, TamTopology > Stations > TamStation > ...
/// > RegisterComponent Address/Type/Value), as options for virtual drives: name and axis names from
/// their packed Int32 registers (the station's Name when they are empty), serial number from
/// HardwareSerialNumber, range from PathPlanner/PositionMinimum and PositionMaximum, all registers
/// as parameters. Errors: InvalidConfiguration with the line.
[[nodiscard]] Result<std::vector<VirtualDriveOptions>> parseTamConfiguration(
    std::string_view xml, const std::string& fileName);

/// Errors: FileNotReadable, FileTooLarge (64 MiB), InvalidConfiguration.
[[nodiscard]] Result<std::vector<VirtualDriveOptions>> loadTamConfiguration(
    const std::filesystem::path& file);

} // namespace axiscomp::drivecomm
