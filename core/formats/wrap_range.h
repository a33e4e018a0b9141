// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/table_format.h"

namespace axiscomp {

// Formats that do not say of a rotary axis after which range its position begins again.

inline constexpr std::string_view wrapRangeKey = "wrap-range";
inline constexpr FormatSetting wrapRangeSetting{.key = wrapRangeKey,
    .kind = FormatSetting::Kind::Number,
    .meaning = AXISCOMP_TEXT(
        "Error", "of a rotary axis: the range after which its position begins again, such as 360"),
    .forReading = true,
    .forWriting = true};

/// Errors: InvalidArgument for a range that is not above 0. One that is no number is left to
/// SettingValues.
[[nodiscard]] Result<void> checkWrapRange(const FormatSettings& given);

/// Writing: the range of the table is that of the setting. Errors: InvalidArgument where the table
/// says another one.
[[nodiscard]] Result<void> takeWrapRange(SourceAxis& axis, const SettingValues& values);

/// Before the sign is converted, where it keeps the knots: a table of exactly one turn by the
/// setting, and with equal ends, repeats, since its ends would not be equal afterwards. Any other
/// table stays for the writer to judge. table: consistent.
[[nodiscard]] NeutralTable asWholeTurn(NeutralTable table, const FormatSettings& given);

} // namespace axiscomp
