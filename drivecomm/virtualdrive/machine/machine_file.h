// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "drivecomm/virtualdrive/machine/machine_description.h"

#include <filesystem>
#include <string>
#include <string_view>

namespace axiscomp::drivecomm {

/// A machine file (docs/virtual-machine.md). Axes come in the order X, Y, Z, A, B, C, then by name.
/// Errors: FileNotReadable with the place, what is wrong there, and the nearest name for one that
/// is not known.
[[nodiscard]] Result<MachineDescription> parseMachine(
    std::string_view json, const std::string& fileName);

/// Errors: FileNotReadable, FileTooLarge (1 MiB).
[[nodiscard]] Result<MachineDescription> loadMachine(const std::filesystem::path& file);

} // namespace axiscomp::drivecomm
