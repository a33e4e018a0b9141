// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace axiscomp::app {

/// What a step of the compensator (Progress::step) does, in words; an unknown one is its own word.
[[nodiscard]] std::string stepWords(std::string_view step);

} // namespace axiscomp::app
