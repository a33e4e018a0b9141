// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/common/input_stream.h"
#include "core/base/result.h"

#include <cstdint>
#include <string>
#include <string_view>

namespace axiscomp::app {

/// As a file name: standard input or standard output.
inline constexpr std::string_view standardStream = "-";

[[nodiscard]] bool standardInputIsTerminal();

/// Everything up to the end. Errors: Cancelled, FileNotReadable, FileTooLarge.
[[nodiscard]] Result<std::string> readStandardInput(
    Interrupt& interrupt, std::uint64_t maximumSize);

} // namespace axiscomp::app
