// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/common/interrupt.h"
#include "core/base/result.h"

#include <chrono>
#include <cstdint>
#include <string>
#include <string_view>

namespace axiscomp::app {

/// As a file name: standard input or standard output.
inline constexpr std::string_view standardStream = "-";

/// Appends what has come on a descriptor, waiting for it; false at the end. Errors: Cancelled,
/// FileNotReadable.
[[nodiscard]] Result<bool> readMore(int descriptor, Interrupt& interrupt, std::string& text);

enum class Input { None, Some, Ended };
/// Waits until a moment for something on standard input, which is appended, or just so long when it
/// is not read. None: the moment has come. Errors: Cancelled, FileNotReadable.
[[nodiscard]] Result<Input> waitForInput(Interrupt& interrupt, bool reads,
    std::chrono::steady_clock::time_point until, std::string& text);
[[nodiscard]] bool standardInputIsTerminal();

/// Everything up to the end. Errors: Cancelled, FileNotReadable, FileTooLarge.
[[nodiscard]] Result<std::string> readStandardInput(
    Interrupt& interrupt, std::uint64_t maximumSize);

} // namespace axiscomp::app
