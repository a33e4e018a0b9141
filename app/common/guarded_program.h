// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/common/console.h"
#include "app/common/exit_codes.h"

#include <functional>

namespace axiscomp::app {

/// "error: Timeout: ..." on standard error; what the program returns for it.
ExitCode noteError(Console& console, const Error& error);

/// What main() returns: what body returns, or OtherFailure after an exception, whose text is on
/// standard error then. Nothing is expected to throw but a computer without memory.
[[nodiscard]] int runGuarded(const std::function<int(Console& console)>& body);

} // namespace axiscomp::app
