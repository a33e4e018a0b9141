// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/format_reader.h"
#include "core/formats/format_writer.h"

#include <cstdint>
#include <string_view>

namespace axiscomp::fanuc {

// Stored pitch error data. Each number stands for a section of the axis, one interval long, and its
// value says by how many steps the correction changes over it; at the reference position it is 0.
// With the number R of the reference position, R + k is the section that ends k intervals above it
// (k >= 1), and R - k the one that ends k + 1 intervals below it (k >= 0).

inline constexpr std::int64_t mostNumbers = 10'000; ///< 0 to 9999
inline constexpr std::size_t usualNumbers = 128; ///< of one axis
inline constexpr std::int64_t largestValue = 2'147'483'647;
inline constexpr std::int64_t largestMagnification = 10'000;

inline constexpr std::string_view referenceNumberKey = "reference-number";
inline constexpr std::string_view intervalKey = "interval";
inline constexpr std::string_view detectionUnitKey = "detection-unit";
inline constexpr std::string_view magnificationKey = "magnification";
inline constexpr std::string_view referencePositionKey = "reference-position";
inline constexpr std::string_view firstNumberKey = "first-number";
inline constexpr std::string_view lastNumberKey = "last-number";
inline constexpr std::string_view firstRecordKey = "first-record";
inline constexpr std::string_view largestStepKey = "largest-step";

/// What parameters of the control say of an axis, and the file does not.
struct PitchSetup {
    std::int64_t reference = 0; ///< number of the reference position
    double position = 0.0; ///< of it, in the unit of the axis
    std::int64_t firstRecord = 0; ///< of number 0: line N10000
    std::int64_t magnification = 1;
    double multiplier = 1.0; ///< the detection unit is multiplier / divisor, one of which is 1
    double divisor = 1.0;

    /// What so many steps are in the unit of the axis.
    [[nodiscard]] double amountOf(double steps) const
    {
        return steps * static_cast<double>(magnification) * multiplier / divisor;
    }
    /// How many steps of a magnification make an amount; not rounded.
    [[nodiscard]] double stepsOf(double amount, std::int64_t ofMagnification) const
    {
        return amount * divisor / multiplier / static_cast<double>(ofMagnification);
    }
};
/// Errors: InvalidArgument that names the setting.
[[nodiscard]] Result<PitchSetup> pitchSetup(
    const FormatFacts& facts, const SettingValues& settings);
/// A whole number from least to most. Errors: InvalidArgument that names the setting.
[[nodiscard]] Result<std::int64_t> wholeBetween(const FormatFacts& facts,
    const SettingValues& settings, std::string_view key, std::int64_t least, std::int64_t most);

/// Reading: which sections belong to the axis.
struct PitchSections {
    double interval = 0.0;
    std::optional<std::int64_t> first; ///< numbers; nothing: as the file has them
    std::optional<std::int64_t> last;
    std::optional<double> turn; ///< of a rotary axis, whose numbers are those of one turn
};
/// Errors: InvalidArgument that names the setting.
[[nodiscard]] Result<PitchSections> pitchSections(
    const FormatFacts& facts, const PitchSetup& setup, const SettingValues& settings);

[[nodiscard]] Result<TableReading> readFile(
    const TableFormat& format, std::string_view text, const TableReadOptions& options);
[[nodiscard]] Result<WrittenTables> writeFile(
    const TableFormat& format, const NeutralTable& table, const FormatSettings& settings);

} // namespace axiscomp::fanuc
