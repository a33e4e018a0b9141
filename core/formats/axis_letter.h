// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/table_format.h"

namespace axiscomp {

/// The letter that stands for an axis: the setting of this key, or else the name of the axis where
/// that is one of the letters, "x" as well as "X". Errors: InvalidArgument that names the setting,
/// also for a setting that contradicts the name.
[[nodiscard]] Result<std::string> axisLetter(const FormatFacts& facts,
    const SettingValues& settings, std::string_view key, const std::string& name,
    std::string_view letters);

} // namespace axiscomp
