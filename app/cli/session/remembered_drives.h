// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <vector>

namespace axiscomp::app {

/// The addresses of the window's connections, without users and passwords; none when there has been
/// no window yet.
[[nodiscard]] std::vector<std::string> rememberedDrives();

} // namespace axiscomp::app
