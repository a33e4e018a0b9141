// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/format_reader.h"
#include "core/formats/format_writer.h"
#include "core/text/token_scanner.h"

#include <array>
#include <cstdint>

namespace axiscomp::isg {

// The compensation lists of the ISG kernel and of TwinCAT CNC: lines "name value", three kinds of
// tables in one syntax (docs/formats.md).

/// One kind of table in a list: "kw.<name>.<key>", "kw.<name>.table[i].<field>".
struct Section {
    std::string_view name; ///< "crosscomp"
    std::size_t indices = 1; ///< of a point
    std::span<const std::string_view> keys; ///< apart from the points
    std::span<const std::string_view> fields; ///< of a point
};

/// Entries without a place in a table: they become its notes ("n_cycles 5"), and entries again.
inline constexpr std::array<std::string_view, 2> keptKeys{"n_cycles", "max_points"};

/// The numbers of one field of the points, in the order of the indices (the last one fastest).
struct Field {
    std::vector<double> numbers;
    std::vector<std::size_t> lines;
};

/// A list as it stands. Refers to the text.
class List {
public:
    List(const Section& section, DiagnosticList& diagnostics)
        : m_section(section)
        , m_diagnostics(diagnostics)
    {
    }

    /// False: cancelled, or no list at all.
    [[nodiscard]] bool parse(std::string_view text, const std::stop_token& stop);

    [[nodiscard]] bool has(std::string_view key) const;
    [[nodiscard]] bool hasField(std::string_view field) const;
    /// The whole value of a text up to '('; empty without the entry.
    [[nodiscard]] std::string text(std::string_view key) const;
    /// The value of an entry between two limits; otherwise an error.
    [[nodiscard]] std::optional<std::int64_t> whole(
        std::string_view key, std::int64_t least, std::int64_t most) const;
    [[nodiscard]] std::optional<double> number(std::string_view key) const;
    /// 0 or 1; what a list without the entry means is said by a warning.
    [[nodiscard]] std::optional<bool> flag(std::string_view key, bool standard) const;
    /// The line of an entry, 0 without it.
    [[nodiscard]] std::size_t line(std::string_view key) const;
    /// Every point of a table of these sizes, or errors.
    [[nodiscard]] std::optional<Field> field(
        std::string_view name, std::array<std::size_t, 2> sizes) const;
    /// kopf.achs_nr or kopf.log_achs_nr, as a name; empty: the list does not say.
    [[nodiscard]] std::string axisNumber() const;
    /// A point count that the entry max_points allows, or its standard value.
    [[nodiscard]] bool checkMostPoints(std::size_t points, std::size_t standard) const;
    [[nodiscard]] std::vector<std::string> takeNotes() { return std::move(m_notes); }
    [[nodiscard]] DiagnosticList& diagnostics() const { return m_diagnostics; }
    [[nodiscard]] std::string path(std::string_view key) const;

private:
    struct Entry {
        Token name;
        Token value;
    };
    struct Cell {
        std::size_t field = 0;
        std::array<std::int64_t, 2> index{}; ///< of one index: {0, i}
        Token name;
        Token value;
    };
    /// "kw.ssfk.table[3].pos" in its parts.
    struct Name {
        Token whole;
        std::string_view base; ///< before the first index: "kw.ssfk.table"
        std::array<std::int64_t, 2> index{};
        std::size_t indices = 0;
        /// Behind as many indices as a point of the section has, if they follow the base: ".pos".
        std::string_view behindPoint;

        [[nodiscard]] std::string_view section() const; ///< "ssfk"
    };
    [[nodiscard]] bool readName(const Token& line, Name& name) const;
    void takeLine(const Token& line, Name& name);
    void takeCell(std::string_view field, const Name& name, const Token& value);
    void takeEntry(std::string_view key, const Entry& entry, bool isHead);
    void takeForeign(std::string_view section, const Token& name);
    [[nodiscard]] const Entry* find(std::string_view key) const;
    void missing(std::string_view key) const;

    const Section& m_section;
    DiagnosticList& m_diagnostics;
    std::map<std::string, Entry, std::less<>> m_entries;
    std::vector<Cell> m_cells;
    std::vector<std::string> m_notes;
    std::vector<std::string> m_foreign; ///< sections that were mentioned already
    bool m_hasEnded = false;
};

/// The table of one section: build makes it of a list.
using Build = std::optional<NeutralTable> (*)(const List& list, const SettingValues& settings);
[[nodiscard]] std::vector<NeutralTable> readSection(
    const TextReading& reading, const Section& section, Build build);
[[nodiscard]] Recognition recogniseList(const Section& section, std::string_view text);

/// The settings of all three.
inline constexpr FormatSetting listUnit{.key = "list-unit",
    .kind = FormatSetting::Kind::Choice,
    .meaning = AXISCOMP_TEXT("Error", "metric: 0.1 um and 0.0001 deg; increments: of the encoder"),
    .choices = "metric, increments",
    .standard = "metric",
    .forWriting = true};
inline constexpr FormatSetting incrementsPerUnit{.key = "increments-per-unit",
    .kind = FormatSetting::Kind::Number,
    .meaning =
        AXISCOMP_TEXT("Error", "encoder increments for one mm or degree, of a list in increments"),
    .forReading = true,
    .forWriting = true};
inline constexpr FormatSetting decimals{.key = "decimals",
    .kind = FormatSetting::Kind::YesNo,
    .meaning = AXISCOMP_TEXT("Error", "write numbers with decimals, which only newer kernels take"),
    .standard = "no",
    .forWriting = true};
inline constexpr FormatSetting axisSetting{.key = "axis",
    .kind = FormatSetting::Kind::WholeNumber,
    .meaning =
        AXISCOMP_TEXT("Error", "logical number of the axis that is compensated, for kopf.achs_nr"),
    .forWriting = true};
[[nodiscard]] constexpr FormatSetting kindSetting(std::string_view key, TextPattern meaning)
{
    return {.key = key,
        .kind = FormatSetting::Kind::Choice,
        .meaning = meaning,
        .choices = "linear, rotary",
        .forReading = true};
}

/// What a list's numbers are: of 0.1 um or 0.0001 deg (10000 for a unit), or increments.
struct Scale {
    FileNumbers numbers;
    bool isMetric = true;
    bool isConverted = true; ///< increments, and how many of them a unit has

    /// "mm", "deg" or "increments"; an axis whose kind nobody says is linear, with a warning.
    [[nodiscard]] std::string unit(
        const SettingValues& settings, std::string_view kindKey, const List& list) const;
};
/// From the entry unit and the settings.
[[nodiscard]] Result<Scale> scaleForWriting(const SettingValues& settings);
[[nodiscard]] std::optional<Scale> scaleOf(const List& list, const SettingValues& settings);
/// The numbers of a field in the table's units.
[[nodiscard]] std::vector<double> scaled(const Scale& scale, const std::vector<double>& numbers);

/// A table in the units of a list, with what its lines are made of.
struct Draft {
    NeutralTable table;
    Scale scale;
    std::string text; ///< begins with the head
    std::string section; ///< "kw.ssfk."

    void add(std::string_view key, std::string_view value);
    void add(std::string_view key, std::size_t value) { add(key, std::to_string(value)); }
    /// "table[3].pos 17"
    void addPoint(std::string_view index, std::string_view field, double inFile);
    [[nodiscard]] std::string numberText(double inFile) const;
};
/// axis: the number for kopf.achs_nr.
[[nodiscard]] Result<Draft> beginDraft(const Section& section, const NeutralTable& table,
    const SettingValues& settings, std::int64_t axis, std::vector<Text>& remarks);
enum class Numbers { Positions, Values };
/// The numbers of the file for positions or values. Errors: FormatCannotHold, 32 bits.
[[nodiscard]] Result<std::vector<double>> inFile(
    const FormatFacts& facts, const Draft& draft, std::span<const double> numbers, Numbers what);
/// FormatCannotHold for a position that rounding makes the same as the one before.
[[nodiscard]] tl::unexpected<Error> roundedTogether(const FormatFacts& facts, double position);
/// How the table of an axis is switched on.
[[nodiscard]] Text activation(const Section& section, std::int64_t axis);
/// Ends the text, reads it back and adds what a person must know. readSettings: what the list does
/// not say itself.
[[nodiscard]] Result<WrittenTables> finish(const TableFormat& format, Draft draft,
    const SettingValues& settings, FormatSettings readSettings, std::vector<Text> remarks);
/// Whether an axis or column is in degrees: "rotary", otherwise "linear".
[[nodiscard]] std::string kindOf(const std::string& unit);
/// Whether positions lie at start + i * distance but for half a number of the file.
[[nodiscard]] bool isEvenInFile(double start, double distance, std::span<const double> exact);

} // namespace axiscomp::isg
