// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <CLI/App.hpp>

namespace axiscomp::app {

// What the number of an option has to be, said in words: the ranges of CLI11 list all digits of the
// largest double. Neither takes what is no number or infinite.

[[nodiscard]] CLI::Validator anyNumber();
[[nodiscard]] CLI::Validator numberAboveZero();
[[nodiscard]] CLI::Validator numberFromZero(); ///< 0 or above
/// Both included. CLI::Range takes nan, which is neither below nor above anything.
[[nodiscard]] CLI::Validator numberBetween(double smallest, double largest);

} // namespace axiscomp::app
