// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/neutral/controller_lookup.h"
#include "core/neutral/neutral_table.h"
#include "core/table/missing_points.h"
#include "core/table/table_units.h"
#include "core/text/diagnostic.h"

#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <map>
#include <optional>
#include <span>
#include <stop_token>

namespace axiscomp {

struct TableLayout;

/// Where a statement about a controller comes from, as docs/formats.md says it.
enum class Evidence {
    Published, ///< the manufacturer's documentation
    Code, ///< public program code
    Assumed, ///< not published, or not found: our assumption
};
[[nodiscard]] std::string_view evidenceName(Evidence evidence);

enum class KnotRule {
    Any, ///< ascending
    Even, ///< start + i * distance, a distance for each axis
    SquareCells, ///< even, with one distance for all axes
};

/// An axis of a table: one of its sources, or what one of its columns corrects.
struct AxisOfTable {
    bool isTarget = false;
    std::size_t number = 0; ///< of the source or the column, from 0

    [[nodiscard]] static constexpr AxisOfTable source(std::size_t n) { return {false, n}; }
    [[nodiscard]] static constexpr AxisOfTable target(std::size_t n) { return {true, n}; }
};

/// What a file does not say, or a choice in writing it: --set KEY=VALUE.
struct FormatSetting {
    enum class Kind { Text, WholeNumber, Number, Choice, YesNo };
    std::string_view key = {}; ///< "counts-per-unit"
    Kind kind = Kind::Text;
    TextPattern meaning = {}; ///< for help and dialogs: "counts per unit of position"
    std::string_view choices = {}; ///< "increments, metric": of Kind::Choice
    std::string_view standard = {}; ///< the value without a setting; empty: as the meaning says
    bool forReading = false;
    bool forWriting = false;
    bool isNeeded = false; ///< an error without it
    /// Settings, "a, b", that together take the place of one that is needed.
    std::string_view unless = {};
    /// The axis that it names in every table, of a format whose files hold several
    /// (checkNamedAxes).
    std::optional<AxisOfTable> namedAxis = {};
};
using FormatSettings = std::map<std::string, std::string, std::less<>>;

/// What a format's tables are and can hold. Lists, dialogs, documentation and checks are made from
/// this.
struct FormatFacts {
    std::string_view name = {}; ///< "softmc": for --from, --to and --as
    std::string_view controller = {}; ///< "softMC (Danaher, Servotronix, Kollmorgen)"
    TextPattern description = {}; ///< "text table, first source fastest"
    std::span<const std::string_view> extensions = {}; ///< ".txt", the usual one first
    int fewestDimensions = 1;
    int mostDimensions = 1;
    KnotRule knots = KnotRule::Even;
    std::size_t mostPoints = 0; ///< of one table; 0: no limit is known
    std::size_t mostColumns = 1; ///< of one table; 0: no limit. A pair of directions is one
    std::size_t mostTables = 1; ///< of one file; 0: no limit
    bool addsTables = false; ///< of one axis, on the controller; otherwise one of them counts
    std::size_t mostBytes = 64U << 20U; ///< of a file
    bool holdsNames = false; ///< of axes
    bool holdsUnits = false;
    bool marksMissing = false; ///< files may say of a point that it has no value
    bool holdsNotes = false;
    bool holdsDirections = false; ///< a value for each direction of motion
    bool holdsWrap = false; ///< modulo axes
    bool holdsPersistency = false;
    bool isText = true;
    std::string_view numbers = {}; ///< "decimal text", "float32", "whole numbers of 0.1 um"
    SignConvention sign = SignConvention::Command;
    Evidence signEvidence = Evidence::Assumed;
    TableBehaviour behaviour = {}; ///< what the controller makes of a table
    Evidence outsideEvidence = Evidence::Assumed;
    std::span<const FormatSetting> settings = {};
    std::span<const std::string_view> rules = {}; ///< sentences for docs/formats.md, published
    std::span<const std::string_view> assumptions = {}; ///< likewise; ours

    /// Nobody has published the sign: a conversion is refused (SignNotStated) until the user says
    /// it, with --sign or --to-sign, in the field Sign, or as sign in a machine file. signEvidence
    /// alone decides that: a format says Assumed there and has nothing else to do.
    [[nodiscard]] bool needsSign() const { return signEvidence == Evidence::Assumed; }
};

struct TableReadOptions {
    int dimensions = 0; ///< of a calibration CSV file, which does not say; 0: not given
    const TableLayout* layout = nullptr; ///< of a TAM table
    FormatSettings settings; ///< "position-unit" and "value-unit" for every format that lacks them
    MissingPoints missing = MissingPoints::Refuse; ///< of formats that mark points without a value
    double snap = 0.0; ///< see CsvOptions
    std::size_t maximumDiagnostics = 100;
    std::stop_token stop;
};

struct TableReading {
    std::vector<NeutralTable> tables; ///< empty with an error
    std::vector<Diagnostic> diagnostics; ///< in the order of the file
    std::size_t suppressed = 0; ///< further errors
    bool cancelled = false;

    [[nodiscard]] bool hasErrors() const;
};

struct TableWriteOptions {
    const TableLayout* layout = nullptr; ///< of a TAM table
    FormatSettings settings;
    std::string fileName; ///< without folder; where a text names its own file
};

struct WrittenTables {
    std::string bytes; ///< of the file
    std::vector<NeutralTable> held; ///< what the file says, rounded as it is there
    std::vector<Text> remarks; ///< what else a person must do or know: activation lines
};

/// How sure a format is that a text is one of its files.
enum class Recognition { No, Possible, Certain };

/// One format of one controller. One that cannot be read has no read; one that cannot be written
/// has no write.
struct TableFormat {
    FormatFacts facts;
    /// text: the first bytes of the file, at most 64 KiB; may end in the middle of a line. None
    /// for a format that only the file's name tells.
    Recognition (*recognise)(std::string_view text) = nullptr;
    /// The whole file. Problems of the file are diagnostics; settings that cannot be are errors
    /// (InvalidArgument).
    Result<TableReading> (*read)(std::string_view text, const TableReadOptions& options) = nullptr;
    /// tables: what checkHolds accepts, with the format's sign. Errors: InvalidArgument
    /// (settings), FormatCannotHold (numbers that the format has no room for).
    Result<WrittenTables> (*write)(
        std::span<const NeutralTable> tables, const TableWriteOptions& options) = nullptr;
};

/// All of them, those of the product itself first.
[[nodiscard]] std::span<const TableFormat* const> tableFormats();

/// "csv, tamtbl": their names, for sentences.
[[nodiscard]] std::string formatNames(std::span<const TableFormat* const> formats);

/// By name, upper or lower case. Errors: UnknownFormat.
[[nodiscard]] Result<const TableFormat*> formatNamed(std::string_view name);

/// What tells one format from another stands within this; `recognise` is given no more.
inline constexpr std::size_t longestBeginning = std::size_t{64} * 1024;
/// The bytes at the beginning of a file that tell its format; fewer of a shorter file, and none of
/// one that cannot be read, which its reader says.
[[nodiscard]] std::string beginningOf(const std::filesystem::path& file);

/// What a file is, from its content; the extension decides among those that are possible.
struct FormatGuess {
    std::vector<const TableFormat*> formats; ///< the most likely first; empty: none
    bool isCertain = false; ///< exactly one fits
};
[[nodiscard]] FormatGuess guessFormat(std::string_view text, std::string_view fileName);

/// The format that a file's name stands for; null when none or several do.
[[nodiscard]] const TableFormat* formatOfExtension(std::string_view fileName);

/// Which format a file is read as, when nobody says it.
struct FormatChoice {
    const TableFormat* format = nullptr;
    std::vector<const TableFormat*> others; ///< that the content would allow as well
};
/// A file that could be of another controller is not taken for one on a mere suspicion, since its
/// numbers might have the other sign: its content is certain, or its name says the one format that
/// its content allows. text: the first bytes. isCalibration: the user said something that only
/// calibration files need (the number of dimensions). Errors: UnknownFormat, also (measured) for
/// what certainly is a measurement, each column of which would be a table; FormatAmbiguous with
/// the candidates.
[[nodiscard]] Result<FormatChoice> chooseFormat(
    std::string_view text, const std::string& fileName, bool isCalibration);
/// Whether it refused a measurement, which is not read as a calibration file either.
[[nodiscard]] bool isOfMeasurement(const Result<FormatChoice>& choice);

/// The format to write a file in: by its name when one is given, else by the file's extension.
/// Errors: UnknownFormat, FormatAmbiguous, InvalidArgument for one that cannot be written.
[[nodiscard]] Result<const TableFormat*> outputFormat(
    const std::string& fileName, const std::string& formatName);

/// Checks dimensions, knots, points, columns, directions and modulo against the facts. Errors:
/// FormatCannotHold with the limit and the way out; InvalidArgument for what is no table
/// (checkConsistent).
[[nodiscard]] Result<void> checkHolds(
    const FormatFacts& facts, std::span<const NeutralTable> tables);

/// That no setting for writing gives axes of different tables one name, since the controller would
/// correct that one by all of them. Errors: InvalidArgument with the way out.
[[nodiscard]] Result<void> checkNamedAxes(
    const FormatFacts& facts, std::span<const NeutralTable> tables, const FormatSettings& settings);

/// Whether a format without units is read, and written, in any that the settings position-unit and
/// value-unit state. Not one that has these settings of its own.
[[nodiscard]] bool takesAnyUnits(const FormatFacts& facts);

/// The settings that a format has for reading or for writing, those of missing units among them.
[[nodiscard]] std::vector<FormatSetting> formatSettings(const FormatFacts& facts, bool isWriting);

/// The settings, and the units that a person states of the file as settings position-unit and
/// value-unit, so that a format that has these checks them as it does its settings; unitOfDrive is
/// none. Errors: InvalidArgument for a unit of which a setting says something else.
[[nodiscard]] Result<FormatSettings> withStatedUnits(
    const FormatFacts& facts, FormatSettings settings, const StatedUnits& stated);

/// The value of a setting, or its standard value. Errors: InvalidArgument for a value that is not
/// of the setting's kind, for one that is needed and missing, for keys that the format does not
/// have, and for unitOfDrive, which is no unit that numbers could be read in.
class SettingValues {
public:
    [[nodiscard]] static Result<SettingValues> of(
        const FormatFacts& facts, const FormatSettings& settings, bool isWriting);

    [[nodiscard]] bool has(std::string_view key) const; ///< given, or with a standard value
    [[nodiscard]] std::string text(std::string_view key) const; ///< empty: not given
    [[nodiscard]] double number(std::string_view key) const; ///< has(key)
    [[nodiscard]] std::int64_t whole(std::string_view key) const; ///< has(key)
    [[nodiscard]] bool yes(std::string_view key) const;

private:
    FormatSettings m_values;
};

/// Errors: InvalidArgument for the value of a setting that is no number above 0.
[[nodiscard]] Result<void> checkAboveZero(
    const FormatFacts& facts, std::string_view key, const std::string& value);

} // namespace axiscomp
