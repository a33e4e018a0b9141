// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>

namespace axiscomp {

/// What a file is that somebody opens without saying what it is.
enum class FileKind { Record, MachineFile, Configuration, Table, Measurement };

/// By the name where it tells (.axcal, .toml, .TAMcfg, .TAMtbl), else by the content. A CSV file
/// that no measurement is certain to be is a table: whoever reads it says what is wrong with it.
/// beginning: at most the first 64 KiB. Errors: UnknownFormat.
[[nodiscard]] Result<FileKind> kindOfFile(std::string_view beginning, const std::string& fileName);

/// What the name alone tells.
[[nodiscard]] std::optional<FileKind> kindOfName(std::string_view fileName);

/// Of a file on this computer. Errors: UnknownFormat, FileNotReadable.
[[nodiscard]] Result<FileKind> kindOfFile(const std::filesystem::path& file);

} // namespace axiscomp
