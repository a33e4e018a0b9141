// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/format_reader.h"
#include "core/formats/format_writer.h"
#include "core/text/token_scanner.h"

namespace axiscomp::aerotech {

// Calibration files: lines that begin with :START or :START2D say what a table is, numbers follow,
// :END ends it (docs/formats.md).

/// "POSUNIT=METRIC", "OFFSETROW = 5", or a word alone such as NEGCOR, whose value is empty.
struct Option {
    Token key;
    Token value;
};

/// One table as it stands.
struct Block {
    Token start; ///< the first directive
    std::vector<Token> numbers; ///< what stands behind it without a key
    std::vector<Option> options;
    std::vector<double> values;
    struct Line {
        std::size_t line = 0;
        std::size_t count = 0; ///< of values
    };
    std::vector<Line> lines;
    std::vector<std::string> notes; ///< the comment lines since the table before

    /// Null without it.
    [[nodiscard]] const Option* option(std::string_view key) const;
};

/// The blocks of a file; directive: ":START" or ":START2D". Every block has an end and readable
/// values, or there is an error.
[[nodiscard]] std::vector<Block> readBlocks(const TextReading& reading, std::string_view directive);
/// A warning for each option that is none of these, an error for one that is there twice and for
/// NEGCOR with a value, which might be meant to switch it off.
void checkOptions(
    const Block& block, std::span<const std::string_view> known, DiagnosticList& diagnostics);
[[nodiscard]] Recognition recogniseFile(std::string_view text, std::string_view directive);

/// The number of an option, or a standard value without it.
[[nodiscard]] std::optional<double> numberOption(
    const Block& block, std::string_view key, double standard, DiagnosticList& diagnostics);
/// A warning when HOMEOFFSET or HOMEDIRECTION say something that no table can.
void remarkHome(const Block& block, DiagnosticList& diagnostics);

/// "METRIC/1000": mm or deg, 1000 numbers of the file for one.
struct Unit {
    bool isMetric = false;
    bool isEnglish = false;
    std::string name; ///< of what is not metric: "inch", "counts", or what a setting says
    std::string_view setting = {}; ///< the key of that one, or of what makes counts a unit
    double perUnit = 1.0;
    Token place; ///< of the option, or of the table without it

    /// Adds an error for inches of a rotary axis.
    [[nodiscard]] std::string of(const TextReading& reading, std::string_view axis) const;
};
[[nodiscard]] std::optional<Unit> unitOption(
    const Block& block, std::string_view key, const TextReading& reading);

/// False, with an error, when both units are the user's or counts, are different, and nobody says
/// both, so that values would be taken to be in the unit of the positions.
[[nodiscard]] bool areKnownApart(
    const Unit& positions, const Unit& values, DiagnosticList& diagnostics);

/// False, with an error, when a divided unit makes values that no double holds.
[[nodiscard]] bool areFinite(
    const NeutralTable& table, const Block& block, DiagnosticList& diagnostics);

inline constexpr FormatSetting rotaryAxes{.key = "rotary-axes",
    .kind = FormatSetting::Kind::Text,
    .meaning = AXISCOMP_TEXT(
        "Error", "numbers of the axes for which METRIC means degrees, such as 4,5; all others mm"),
    .forReading = true};
inline constexpr FormatSetting primaryUnit{.key = "primary-unit",
    .kind = FormatSetting::Kind::Text,
    .meaning = AXISCOMP_TEXT("Error", "what PRIMARY stands for, such as mm"),
    .forReading = true};
inline constexpr FormatSetting secondaryUnit{.key = "secondary-unit",
    .kind = FormatSetting::Kind::Text,
    .meaning = AXISCOMP_TEXT("Error", "what SECONDARY stands for, such as inch"),
    .forReading = true};
inline constexpr FormatSetting countsPerUnit{.key = "counts-per-unit",
    .kind = FormatSetting::Kind::Number,
    .meaning = AXISCOMP_TEXT("Error",
        "counts of each axis for one primary-unit; without it what is in COUNTS stays in counts"),
    .forReading = true};
inline constexpr FormatSetting units{.key = "units",
    .kind = FormatSetting::Kind::Choice,
    .meaning = AXISCOMP_TEXT("Error",
        "METRIC (mm and degrees), or PRIMARY: the table's own units are those of the axes"),
    .choices = "metric, primary",
    .standard = "metric",
    .forWriting = true};

/// An axis of even positions distance * k - offset; a negative distance counts downwards.
struct Sampling {
    double distance = 0.0;
    double offset = 0.0;
    std::size_t count = 0;

    [[nodiscard]] bool isDownwards() const { return distance < 0.0; }
    [[nodiscard]] std::vector<double> knots(double perUnit) const; ///< ascending
};
/// The first position and the distance of an axis in a file.
[[nodiscard]] Sampling samplingOf(const SourceAxis& axis);

/// The table in the units that the file will say.
[[nodiscard]] Result<NeutralTable> inFileUnits(
    const NeutralTable& table, const SettingValues& settings, std::vector<Text>& remarks);
/// "METRIC" or "PRIMARY".
[[nodiscard]] std::string unitWord(const SettingValues& settings);
/// The settings with which a file says what was written; the names of the tables are those of the
/// file.
[[nodiscard]] FormatSettings readingSettings(
    std::span<const NeutralTable> written, const SettingValues& settings);

} // namespace axiscomp::aerotech
