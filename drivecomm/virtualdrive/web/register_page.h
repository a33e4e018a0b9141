// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_profile.h"
#include "core/drive/register_value.h"

#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp::drivecomm {

struct PageFrame;

/// A register as a person sees and sets it.
struct RegisterRow {
    RegisterReading reading;
    bool isWritable = false;
    std::vector<std::string> names; ///< all that can be chosen; empty: anything can be entered
    bool isSource = false; ///< holds a register's address; its path may be entered
    std::string sourcePath; ///< of the register that it points to
};

/// Registers in a table, with a form that sets all fields that were filled in, in one request.
/// sources are suggestions for DimSources.
[[nodiscard]] std::string registerListPage(const PageFrame& frame, const DriveProfile& profile,
    std::span<const RegisterRow> rows, std::span<const std::string> sources);

/// One level of the register tree: the folders below prefix, and the registers in it.
[[nodiscard]] std::string registerTreePage(const PageFrame& frame, const DriveProfile& profile,
    std::string_view prefix, std::span<const std::string> folders,
    std::span<const RegisterRow> rows, std::span<const std::string> sources);

/// What was set, read back.
[[nodiscard]] std::string registersSetPage(
    const PageFrame& frame, std::span<const RegisterRow> rows, std::string_view backLink);

} // namespace axiscomp::drivecomm
