// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/format_reader.h"
#include "core/formats/format_writer.h"
#include "core/text/token_scanner.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>

namespace axiscomp::pmac {

// Compensation tables of PMAC: DEFINE COMP says sizes, motors and spans in counts, whole numbers of
// 1/16 count follow. They begin at position 0, whose entry is left out, and roll over.

/// An entry of a table is a whole number of this part of a count.
inline constexpr double entriesPerCount = 16.0;

/// The tables of one or of two dimensions in a file.
[[nodiscard]] std::vector<NeutralTable> readTables(TextReading& reading, std::size_t dimensions);
[[nodiscard]] Recognition recogniseFile(std::string_view text, std::size_t dimensions);

/// The keys of settings for each source motor and for the target.
struct Keys {
    std::span<const std::string_view> motors; ///< of the sources
    std::span<const std::string_view> counts; ///< counts per unit of these
};
[[nodiscard]] Result<WrittenTables> writeTable(const TableFormat& format, const Keys& keys,
    const NeutralTable& source, const FormatSettings& settings);

/// Reading: the counts for one unit that the setting of one motor says, or the one of all motors;
/// nothing where neither is given, and the numbers stay in counts.
[[nodiscard]] std::optional<double> countsPerUnit(
    const SettingValues& settings, std::string_view key);
/// The units of a table of one column: those of the settings, but counts where no counts per unit
/// are given, which is said with `inCounts`; an error for a unit that is stated of such counts, and
/// for two units of one motor. sourceKeys: of countsPerUnit, for each source.
void takeMotorUnits(NeutralTable& table, std::span<const std::string_view> sourceKeys,
    const TextReading& reading, std::size_t line, const TextPattern& inCounts);

/// What is wrong with two units for one motor, whose counts per unit are the same for both.
/// sourceKeys: of countsPerUnit, for each source. Nothing: there are none.
[[nodiscard]] std::optional<Diagnostic> motorContradiction(const NeutralTable& table,
    std::span<const std::string_view> sourceKeys, const SettingValues& settings);

/// Writing: numbers that are in counts already are not multiplied once more, and a motor has one
/// unit. sourceKeys: of countsPerUnit, for each source. Errors: InvalidArgument.
[[nodiscard]] Result<void> checkCounted(const FormatFacts& facts, const NeutralTable& table,
    std::span<const std::string_view> sourceKeys, const SettingValues& settings);

inline constexpr std::array<std::string_view, 5> assumptions{
    "The correction is added to the commanded position; the documentation gives no sign.",
    "The corrections of several tables for one motor are added. Each table belongs to a motor, the "
    "one that is addressed in front of it; a second table of the same takes the place of the "
    "first.",
    "An entry has 24 bits.",
    "A table that does not close is written with one more interval that leads back to its first "
    "value; negative positions are written behind the positive ones.",
    "One table is written to a file, for its target motor; a file that is read may hold several.",
};

/// ofMotors: the settings of all motors of the format.
[[nodiscard]] constexpr FormatSetting countsForWriting(std::string_view ofMotors)
{
    return {.key = "counts-per-unit",
        .kind = FormatSetting::Kind::Number,
        .meaning = AXISCOMP_TEXT(
            "Error", "encoder counts for one unit, of every motor without a setting of its own"),
        .forWriting = true,
        .isNeeded = true,
        .unless = ofMotors};
}
inline constexpr FormatSetting countsForReading{.key = "counts-per-unit",
    .kind = FormatSetting::Kind::Number,
    .meaning =
        AXISCOMP_TEXT("Error", "encoder counts for one unit; without it tables are in counts"),
    .forReading = true};
[[nodiscard]] constexpr FormatSetting countsSetting(std::string_view key, TextPattern meaning)
{
    return {.key = key,
        .kind = FormatSetting::Kind::Number,
        .meaning = meaning,
        .forReading = true,
        .forWriting = true};
}
[[nodiscard]] constexpr FormatSetting motorSetting(std::string_view key, TextPattern meaning)
{
    return {.key = key,
        .kind = FormatSetting::Kind::WholeNumber,
        .meaning = meaning,
        .forWriting = true};
}
inline constexpr std::string_view targetCountsKey = "target-counts-per-unit";
inline constexpr FormatSetting targetCounts = countsSetting(
    targetCountsKey, AXISCOMP_TEXT("Error", "encoder counts for one unit of the values"));
inline constexpr FormatSetting targetMotor = motorSetting(
    "target-motor", AXISCOMP_TEXT("Error", "number of the motor that is compensated, 1 to 32"));
inline constexpr FormatSetting usesActual{.key = "position",
    .kind = FormatSetting::Kind::Choice,
    .meaning = AXISCOMP_TEXT(
        "Error", "position of the sources that counts: desired (written with D) or actual"),
    .choices = "desired, actual",
    .standard = "desired",
    .forWriting = true};

} // namespace axiscomp::pmac
