// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/csv/cell_reader.h"
#include "core/csv/header.h"
#include "core/csv/number_lines.h"
#include "core/metrology/formats/measurement_format.h"
#include "core/text/line_reader.h"

#include <initializer_list>
#include <map>
#include <span>

namespace axiscomp {

/// The factor of a unit to mm or deg.
struct MeasurementUnit {
    double factor = 1.0;
    bool isAngular = false;
};
/// Nothing for what is no unit of length or angle.
[[nodiscard]] std::optional<MeasurementUnit> measurementUnit(std::string_view symbol);

/// What a unit of time or temperature makes of a number x: (x - zero) / perBase seconds or deg C.
struct ScaleOfUnit {
    std::string_view spelling; ///< empty: without a unit
    double zero = 0.0;
    double perBase = 1.0;
};

/// What the comments of a file say beside the header.
struct MeasurementComments {
    std::optional<bool> holdsReference; ///< "values: reference" or "values: deviation"
    bool holdsCorrections = false; ///< "sign: correction": the opposite of deviations
};

/// A CSV file of a measurement: comments with what is said of it, one header, data lines. Text,
/// separators and numbers as in a calibration file (docs/calibration-csv.md). Columns count from 1.
class MeasurementCsv {
public:
    MeasurementCsv(std::string_view text, const MeasurementReadOptions& options,
        Measurement& measurement, DiagnosticList& diagnostics);

    /// Reads up to the first data line. False: there is no header that can be used, which is
    /// reported.
    bool readHeader();
    [[nodiscard]] const std::vector<csv::ColumnName>& columns() const { return m_columns; }
    [[nodiscard]] std::size_t headerLine() const { return m_headerLine; }

    /// The column of a role: the one that the user mapped, or the only one with one of these names.
    /// 0: there is none. Two of a kind are reported.
    std::size_t column(std::string_view role, std::initializer_list<std::string_view> names);
    /// Finds the column axis, also where others are mapped. The axis of its lines is that of the
    /// measurement: lines of another one are refused. After the other columns were asked for.
    void findAxis();
    [[nodiscard]] bool isAxis(std::size_t column) const { return column == m_axisColumn; }
    /// What was mapped must be among what was asked for by column(); otherwise it is reported.
    void checkMapping();
    /// Columns that nobody asked for, and that are no part of a measurement, become a note.
    void noteUnknownColumns();
    /// For columns that are found in another way than by column().
    void markKnown(std::size_t column) { m_isKnown[column - 1] = true; }
    [[nodiscard]] bool isKnown(std::size_t column) const { return m_isKnown[column - 1]; }

    /// The unit of a column: stated, or in brackets behind the name, or "_mm" at its end (any unit
    /// that the brackets may have). Nothing when it is missing or unknown, which is reported.
    std::optional<MeasurementUnit> unit(std::size_t column, const std::string& stated);
    /// Reports columns of which one is a length and the other an angle.
    void checkSameKind(const std::optional<MeasurementUnit>& a,
        const std::optional<MeasurementUnit>& b, std::size_t column);

    /// The next data line with as many cells as the header. False: the end, or stopped.
    bool next();
    [[nodiscard]] std::size_t line() const { return m_line; }

    /// The next megabytes as far as every column holds numbers: what next() and number() would give
    /// for these lines. What follows up to the limit of each piece is for next(). Nothing at the
    /// end, when it is stopped, and where a column names the axis.
    [[nodiscard]] std::vector<csv::NumberLines> readAhead() const;
    /// Goes on behind the lines of a piece. False: its first line has been read already, behind
    /// comments at the end of the piece before, and all of its lines are for next().
    [[nodiscard]] bool take(const csv::NumberLines& piece);
    [[nodiscard]] bool isBefore(const char* limit) const { return m_lines.position() < limit; }
    /// For how many data lines room is worth making beforehand: about as many as there are.
    [[nodiscard]] std::size_t expectedLines() const;
    [[nodiscard]] std::string_view text(std::size_t column) const { return m_cells.text(column); }
    [[nodiscard]] bool isEmpty(std::size_t column) const { return m_cells.hasNoValue(column); }
    /// Nothing: the cell is no number, which is reported.
    std::optional<double> number(std::size_t column);
    /// Nothing for column 0 and for empty cells as well.
    std::optional<double> optionalNumber(std::size_t column);
    /// Seconds, by the unit in brackets (none: s), or the time of day of ISO 8601 in seconds.
    /// Nothing for column 0, for empty cells, and for another unit, which is reported once.
    std::optional<double> time(std::size_t column);
    /// In deg C, by the unit in brackets (none: C). Nothing as for time().
    std::optional<double> temperature(std::size_t column);
    [[nodiscard]] std::string shown(std::string_view text) const;

    void error(DiagnosticCode code, std::size_t column, Text found, Text expected);
    /// After this a comment that says otherwise is refused: it would hold for some of the lines
    /// only, or for none. isReference: as "values" was understood; nothing where it does not
    /// decide. haveSign: whether "sign" decides; otherwise all values are positions of the
    /// reference, with which a sign that turns them is a contradiction.
    void settleValues(std::optional<bool> isReference, bool haveSign);
    /// That the file says this of its values, in its header or a comment: --values may say
    /// otherwise.
    void noteValues(bool areReference);
    [[nodiscard]] const MeasurementComments& comments() const { return m_comments; }

private:
    /// False: the line is no comment, and not blank.
    bool takeIfComment(std::string_view line, std::size_t lineNumber);
    void takeComment(std::string_view comment, std::size_t line);
    bool takeStatement(std::string_view key, const std::string& value, std::size_t line);
    /// key: in small letters.
    void checkSaidBefore(const std::string& key, const std::string& value, std::size_t line);
    [[nodiscard]] std::string meaningOf(std::string_view key, const std::string& value) const;
    bool takeText(std::string_view key, const std::string& value);
    bool takeNumber(std::string_view key, const std::string& value, std::size_t line);
    void takeCompensation(const std::string& value, std::size_t line);
    void takeAxis(const std::string& value, std::size_t line);
    void checkAxis();
    void refuseAxis(std::size_t line, std::size_t column, std::string_view axis,
        std::string_view before, std::size_t lineBefore);
    void takeKind(const std::string& value, std::size_t line);
    void takeValues(const std::string& value, std::size_t line);
    void takeSign(const std::string& value, std::size_t line);
    void refuseLate(std::size_t line, std::string_view statement);
    void refuseSignOfReference(std::size_t line);
    void refuse(std::size_t line, std::string_view value, const TextPattern& expected);
    [[nodiscard]] std::optional<double> inBase(
        std::size_t column, std::span<const ScaleOfUnit> units, const TextPattern& expected);

    struct Statement {
        std::string meaning;
        std::string value; ///< as written
        std::size_t line = 0;
    };

    const MeasurementReadOptions& m_options;
    Measurement& m_measurement;
    DiagnosticList& m_diagnostics;
    TextInspection m_inspection;
    LineReader m_lines;
    csv::CellReader m_cells;
    std::vector<csv::ColumnName> m_columns;
    std::vector<bool> m_isKnown;
    std::vector<bool> m_isUnitRefused;
    std::vector<std::string> m_askedRoles;
    MeasurementComments m_comments;
    std::size_t m_axisColumn = 0;
    std::string m_axisOfLines; ///< of the column axis, as the file has it; empty: none yet
    std::size_t m_axisOfLinesLine = 0;
    std::size_t m_statedAxisLine = 0;
    bool m_isAxisRefused = false;
    std::optional<bool> m_settledReference;
    bool m_isSignSettled = false;
    bool m_areAllReference = false;
    std::map<std::string, Statement> m_statements; ///< the first of each key
    std::size_t m_headerLine = 0;
    std::size_t m_line = 0;
    std::size_t m_noteBytes = 0;
};

/// "up", "forward", "+", "-1" ... in capital or small letters.
[[nodiscard]] std::optional<Approach> approachOf(std::string_view text);

/// The header line of a file's beginning as lower case names, without units. Empty when there is
/// none. For recognising.
[[nodiscard]] std::vector<std::string> headerNames(std::string_view text);

} // namespace axiscomp
