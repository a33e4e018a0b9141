// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/measuring_plan.h"

#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace axiscomp {

enum class GcodeDialect { LinuxCnc, Fanuc, Siemens };

[[nodiscard]] std::span<const std::string_view> gcodeDialectNames(); ///< "linuxcnc", ...
/// Nothing for another name.
[[nodiscard]] std::optional<GcodeDialect> gcodeDialectNamed(std::string_view name);

[[nodiscard]] std::string_view gcodeExtension(GcodeDialect dialect); ///< ".ngc", ".nc", ".mpf"
/// Named as a program for a control: a plan in it would mislead the control.
[[nodiscard]] bool isProgramFile(const std::filesystem::path& file);

/// The plan as a program for the machine's own control: absolute positions, the feed in each move,
/// the dwell at each target, the plan in comments, and no word for a tool, a spindle or coolant.
///
///           metric             dwell                                  end
/// LinuxCNC  G21                G4 P, seconds                          M2
/// Fanuc     G21                G04 P, whole milliseconds              M30, between two %
/// Siemens   G710               G4 F, seconds                          M30
///
/// Sources: LinuxCNC, G-codes, G4; SINUMERIK ISO Milling 04.07, 3.3.1 (dwell as Fanuc has it). G4 F
/// and G710, which also makes the feed metric, are from general knowledge of SINUMERIK. Errors:
/// InvalidArgument for an axis that the dialect cannot name.
[[nodiscard]] Result<std::string> gcodeProgram(const MeasuringPlan& plan, GcodeDialect dialect);

} // namespace axiscomp
