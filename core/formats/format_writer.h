// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/table_format.h"
#include "core/text/token_scanner.h"

namespace axiscomp {

// What several formats need for writing, and for reading back what they wrote.

/// FormatCannotHold with the limit and the way out.
[[nodiscard]] tl::unexpected<Error> cannotHold(const FormatFacts& facts, Text reason, Text wayOut);

/// For a format of axes that correct themselves: that each column acts on the first source. Errors:
/// TargetNotKnown; FormatCannotHold with the way out for a cross compensation.
[[nodiscard]] Result<void> checkOwnAxis(
    const FormatFacts& facts, const NeutralTable& table, const Text& wayOut);

/// The number that stands for an axis: the setting of this key, or the name of the axis where that
/// is a number from 1. Errors: InvalidArgument that names the setting.
[[nodiscard]] Result<std::int64_t> axisNumber(const FormatFacts& facts,
    const SettingValues& settings, std::string_view key, const std::string& name);

/// That the sources of a table are two axes: of one it would be looked up on its diagonal alone.
/// keys: of the settings that say them. Errors: InvalidArgument.
[[nodiscard]] Result<void> checkTwoSources(
    std::string_view first, std::string_view second, std::span<const std::string_view> keys);

/// Whether the values at both ends of an axis are the same, column by column.
[[nodiscard]] bool isClosed(const NeutralTable& table, std::size_t axis);
/// What a modulo axis must be where the format takes the first and the last position for the same
/// place: one period long, and closed but for `allowance` in the values. Errors: FormatCannotHold.
[[nodiscard]] Result<void> checkOnePeriod(
    const FormatFacts& facts, const NeutralTable& table, std::size_t axis, double allowance);

/// The single column for both directions, or the pair of one target; nothing else fits a format
/// with a pair. negative is null without a pair. Errors: FormatCannotHold.
struct DirectionPair {
    const CompensationColumn* positive = nullptr;
    const CompensationColumn* negative = nullptr;
};
[[nodiscard]] Result<DirectionPair> directionPair(
    const FormatFacts& facts, const NeutralTable& table);

/// The shortest decimal text that is read as the same number, never with an exponent.
[[nodiscard]] std::string plainNumber(double value);

/// The distance between the knots of an even axis: the shortest number that puts all of them where
/// they are, but for the rounding of doubles.
[[nodiscard]] double evenDistance(const SourceAxis& axis);

/// What a format holds of a number x: n / perUnit, n a whole number or, with decimals, one of 12
/// digits.
struct FileNumbers {
    double perUnit = 1.0;
    bool hasDecimals = false;

    [[nodiscard]] double inFile(double x) const;
    [[nodiscard]] double fromFile(double n) const { return n / perUnit; }
    /// 1 / perUnit when all of them are whole, which is what a reader can tell; otherwise 0.
    [[nodiscard]] double stepOf(std::span<const double> inFile) const;
};
/// Where the first of the numbers is that a signed 32-bit number cannot hold.
[[nodiscard]] std::optional<std::size_t> beyond32Bits(std::span<const double> inFile);

/// The notes of a table as comment lines: prefix and text each.
[[nodiscard]] std::string noteLines(const NeutralTable& table, std::string_view prefix);
/// Keeps the text of a comment line as a note; lines without a letter or digit are ornament.
void keepNote(std::vector<std::string>& notes, std::string_view comment);

/// Reads what was written, so that `held` is what the file says. Errors: FormatCannotHold when the
/// text cannot be read: the controller would not take it either. warnings: gets those of reading.
[[nodiscard]] Result<std::vector<NeutralTable>> readBack(const TableFormat& format,
    std::string_view bytes, FormatSettings settings, std::vector<Text>* warnings = nullptr);

/// Tables of a format that says no units, and is read with one for all positions and one for all
/// values, get those in which each axis and column was written. Both in the same order.
void takeWrittenUnits(std::span<NeutralTable> held, std::span<const NeutralTable> written);

} // namespace axiscomp
