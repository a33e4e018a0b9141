// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/format_reader.h"
#include "core/formats/format_writer.h"
#include "core/formats/formats.h"

#include <array>

namespace axiscomp::heidenhain {

// Compensation-value tables are text in columns of fixed width: a first line BEGIN AXIS_Y.COM, a
// line of headers, a line for each position, [END]. Both formats have the axes as columns; they
// differ in where a line says its position.

enum class Layout {
    Positions, ///< TNC 640: AXISPOS in each line
    EvenPositions, ///< iTNC 530: DATUM and DISTANCE in the first line, and positions that fit them
};

inline constexpr std::string_view axisLetters = "XYZABCUVW";
/// A, B and C.
[[nodiscard]] bool isRotary(std::string_view letter);

[[nodiscard]] Recognition recogniseFile(std::string_view text, Layout layout);

/// The columns with values; those that have them in the same lines are one table.
[[nodiscard]] std::vector<NeutralTable> parseFile(TextReading& reading, Layout layout);

[[nodiscard]] Result<WrittenTables> writeFile(const TableFormat& format, Layout layout,
    const NeutralTable& table, const FormatSettings& settings);

/// The most lines that a control takes.
inline constexpr std::size_t mostRows = 256;
/// Decimals of positions and values.
inline constexpr int decimals = 4;

inline constexpr FormatSetting movingAxis{.key = "axis",
    .kind = FormatSetting::Kind::Text,
    .meaning = AXISCOMP_TEXT(
        "Error", "letter of the axis whose position counts, where its name is none or another one"),
    .forReading = true,
    .forWriting = true};
inline constexpr FormatSetting compensatedAxis{.key = "target-axis",
    .kind = FormatSetting::Kind::Text,
    .meaning = AXISCOMP_TEXT("Error",
        "letter of the axis that is compensated by the position of another one, where its name is "
        "none"),
    .forWriting = true};

inline constexpr std::string_view endRule =
    "A value belongs to the header that begins last at or before the value's first character. A "
    "line without a value in a column is left out of it: the control interpolates over it.";
inline constexpr std::string_view columnRule =
    "Positions are from the machine datum. A column is named after the axis that it compensates; "
    "the file belongs to the moving axis to which config.cma assigns it, and is named after it.";
inline constexpr std::string_view limitRule =
    "At most 256 lines (module 9095, error 3). Of a rotary axis only 0 to 360 degrees count.";
inline constexpr std::string_view useRule =
    "A line of config.cma names the file in the column of the moving axis and is marked * when it "
    "is active; older controls also need the bit of the axis in MP730. Errors of module 9095: 2 no "
    "such .COM, 3 more than 256 entries, 6 no .CMA.";
inline constexpr std::string_view curveRule =
    "The points of the error curve are entered; between them the control interpolates linearly.";
inline constexpr std::string_view signAssumption =
    "An error is actual - commanded position, too long a travel positive, as the linear "
    "compensation of the same controls counts it, and as a public program writes the same mean "
    "deviation here and into $AA_ENC_COMP. No text says the sign of a .COM table.";
inline constexpr std::string_view outsideAssumption =
    "Outside of the table the value at that end is held.";
inline constexpr std::string_view rotaryAssumption =
    "A, B and C are rotary axes, in degrees; all others are in mm.";
inline constexpr std::string_view limitAssumption =
    "The limit of 256 lines is that of the TNC 407.";

} // namespace axiscomp::heidenhain
