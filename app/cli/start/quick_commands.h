// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <span>

namespace axiscomp::app {

/// Whether the command needs neither a drive nor what is remembered of drives nor a translation:
/// nothing of Qt, which takes longer to load than these take for a small file. arguments: of
/// main().
[[nodiscard]] bool isQuick(std::span<char* const> arguments);

} // namespace axiscomp::app
