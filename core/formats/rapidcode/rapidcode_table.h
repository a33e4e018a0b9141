// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/table_format.h"
#include "core/text/diagnostic.h"
#include "core/text/token_scanner.h"

#include <cstdint>

namespace axiscomp {

// What RSI's function CompensatorConfigSet takes: for each input axis minimum, maximum and delta in
// its user units, and one array of raw counts of the output axis.

inline constexpr std::size_t rapidCodeMostPoints = 4'000'000;

/// One input axis.
struct RapidCodeInput {
    double minimum = 0.0;
    double maximum = 0.0;
    double delta = 0.0;
    std::size_t points = 0; ///< (maximum - minimum) / delta + 1

    [[nodiscard]] std::vector<double> knots() const;
};

/// How often delta lies between minimum and maximum, plus one; nothing unless that is a whole
/// number, 2 to rapidCodeMostPoints.
[[nodiscard]] std::optional<std::size_t> rapidCodePoints(
    double minimum, double maximum, double delta);

struct RapidCodeTable {
    std::vector<RapidCodeInput> inputs; ///< 1 or 2
    std::vector<std::int64_t> counts; ///< the first input fastest
    double countsPerUnit = 1.0; ///< of the output axis
    NeutralTable held; ///< the same as a table, without notes
    bool actsOnInput = false; ///< the output axis is one of the inputs
};

/// The table with the units of the settings (position-unit, value-unit) or its own; values without
/// one of these are in the unit of the first input where they can be. The units are added to
/// remarks. Errors: InvalidArgument (settings, units), FormatCannotHold.
[[nodiscard]] Result<RapidCodeTable> rapidCodeTable(const FormatFacts& facts,
    const NeutralTable& table, const SettingValues& settings, std::vector<Text>& remarks);

/// "The input is the output axis ...": what the user must choose in the call.
[[nodiscard]] Text rapidCodeInputAdvice(const RapidCodeTable& table);

/// Text as a comment line can hold it.
[[nodiscard]] std::string oneLine(std::string_view text);

} // namespace axiscomp
