// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/formats/measurement_csv.h"

#include "core/base/wall_time.h"
#include "core/csv/fields.h"
#include "core/metrology/header_texts.h"
#include "core/table/position_unit.h"
#include "core/table/target_axis.h"
#include "core/text/number_text.h"
#include "core/text/token_scanner.h"
#include "core/text/utf8.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

namespace axiscomp {

namespace {

/// "target_mm" is "target" with the unit mm; "error_rev" is a direction and no turn.
csv::ColumnName withUnitOfName(csv::ColumnName column)
{
    const std::size_t line = column.name.rfind('_');
    if (!column.unit.empty() || line == std::string::npos || line == 0)
        return column;
    std::string ending = column.name.substr(line + 1);
    if (!isPositionUnit(ending) || approachOf(ending))
        return column;
    column.unit = std::move(ending);
    column.name.resize(line);
    return column;
}

constexpr std::array timeUnits{ScaleOfUnit{""}, ScaleOfUnit{"s"}, ScaleOfUnit{"ms", 0.0, 1000.0},
    ScaleOfUnit{"min", 0.0, 1.0 / 60.0}, ScaleOfUnit{"h", 0.0, 1.0 / 3600.0}};
constexpr std::array temperatureUnits{ScaleOfUnit{""}, ScaleOfUnit{"C"}, ScaleOfUnit{"degC"},
    ScaleOfUnit{"deg C"}, ScaleOfUnit{"\u00b0C"}, ScaleOfUnit{"Celsius"}, ScaleOfUnit{"K", 273.15},
    ScaleOfUnit{"Kelvin", 273.15}, ScaleOfUnit{"F", 32.0, 1.8}, ScaleOfUnit{"degF", 32.0, 1.8},
    ScaleOfUnit{"deg F", 32.0, 1.8}, ScaleOfUnit{"\u00b0F", 32.0, 1.8},
    ScaleOfUnit{"Fahrenheit", 32.0, 1.8}};

std::string lowerCase(std::string text)
{
    for (char& c : text)
        if (c >= 'A' && c <= 'Z')
            c = static_cast<char>(c - 'A' + 'a');
    return text;
}

/// "20.4 C" is 20.4: the number at the beginning, when nothing but a unit follows.
std::optional<double> numberWithUnit(
    std::string_view text, std::initializer_list<std::string_view> units)
{
    const std::size_t end = text.find_first_of(" \t");
    const auto number = numberOf(text.substr(0, end));
    const std::string_view unit =
        end == std::string_view::npos ? std::string_view() : trimmed(text.substr(end));
    const bool isKnown = unit.empty() || std::ranges::any_of(units, [unit](std::string_view known) {
        return sameLetters(unit, known);
    });
    return number && std::isfinite(*number) && isKnown ? number : std::nullopt;
}

/// "2026-11-21T09:30:00", with or without Z, a blank in place of the T.
std::optional<double> isoSeconds(std::string_view text)
{
    std::string iso(text);
    if (iso.size() > 10 && iso[10] == ' ')
        iso[10] = 'T';
    if (!iso.ends_with('Z'))
        iso += 'Z';
    const auto time = utcFromText(iso);
    if (!time)
        return std::nullopt;
    return std::chrono::duration<double>(time->time_since_epoch()).count();
}

} // namespace

std::optional<MeasurementUnit> measurementUnit(std::string_view symbol)
{
    if (const auto length = unitFactor(symbol, "mm"))
        return MeasurementUnit{*length, false};
    if (const auto angle = unitFactor(symbol, "deg"))
        return MeasurementUnit{*angle, true};
    return std::nullopt;
}

std::optional<Approach> approachOf(std::string_view text)
{
    constexpr std::array<std::string_view, 7> up{
        "+", "up", "fwd", "forward", "1", "positive", "+1"};
    constexpr std::array<std::string_view, 8> down{
        "-", "down", "bwd", "backward", "rev", "-1", "negative", "reverse"};
    const auto isOne = [text](std::string_view word) { return sameLetters(text, word); };
    if (std::ranges::any_of(up, isOne))
        return Approach::Up;
    if (std::ranges::any_of(down, isOne))
        return Approach::Down;
    return std::nullopt;
}

std::vector<std::string> headerNames(std::string_view text)
{
    LineReader lines(text.starts_with("\xEF\xBB\xBF") ? text.substr(3) : text);
    while (!lines.atEnd()) {
        const std::string_view line = lines.next();
        if (isCsvComment(line))
            continue;
        DiagnosticList ignored(1);
        const auto header = csv::readColumnNames(line, 1, Encoding::Utf8, ignored);
        std::vector<std::string> names;
        if (header)
            for (const csv::ColumnName& column : header->columns)
                names.push_back(lowerCase(withUnitOfName(column).name));
        return names;
    }
    return {};
}

MeasurementCsv::MeasurementCsv(std::string_view text, const MeasurementReadOptions& options,
    Measurement& measurement, DiagnosticList& diagnostics)
    : m_options(options)
    , m_measurement(measurement)
    , m_diagnostics(diagnostics)
    , m_inspection(text, options.stop, diagnostics)
    , m_lines(m_inspection.body())
    , m_cells(m_inspection.encoding(), diagnostics, m_lines.end())
{
}

bool MeasurementCsv::readHeader()
{
    if (m_diagnostics.hasErrors())
        return false;
    for (std::size_t i = 0; i < m_options.skippedLines && !m_lines.atEnd(); ++i)
        static_cast<void>(m_lines.next());
    while (!m_lines.atEnd()) {
        const std::size_t lineNumber = m_lines.lineNumber();
        const std::string_view line = m_lines.next();
        if (takeIfComment(line, lineNumber))
            continue;
        m_headerLine = lineNumber;
        auto header =
            csv::readColumnNames(line, lineNumber, m_inspection.encoding(), m_diagnostics);
        if (!header)
            return false;
        if (header->columns.size() == 1 && line.find('\t') != std::string_view::npos) {
            m_diagnostics.error(DiagnosticCode::MissingColumn, lineNumber, 0,
                AXISCOMP_COUNTED("Error", "{count} columns", "1 column").with("count", 1),
                AXISCOMP_TEXT("Error", "columns separated by , or ; instead of tabs"));
            return false;
        }
        for (csv::ColumnName& column : header->columns)
            m_columns.push_back(withUnitOfName(std::move(column)));
        m_isKnown.assign(m_columns.size(), false);
        m_isUnitRefused.assign(m_columns.size(), false);
        m_cells.begin(header->separator, m_columns.size(), lineNumber);
        if (!m_cells.checkThousands(
                {m_lines.position(), static_cast<std::size_t>(m_lines.end() - m_lines.position())},
                m_lines.lineNumber()))
            return false;
        for (LineReader ahead = m_lines; !ahead.atEnd(); m_lines = ahead) {
            const std::size_t number = ahead.lineNumber();
            if (!takeIfComment(ahead.next(), number))
                break;
        }
        return !m_diagnostics.hasErrors();
    }
    if (m_inspection.body().find_first_not_of(" \t\r\n") == std::string_view::npos) {
        m_diagnostics.error(DiagnosticCode::EmptyFile, 0, 0, {}, {});
        return false;
    }
    m_diagnostics.error(DiagnosticCode::NoHeader, 0, 0, {},
        AXISCOMP_TEXT("Error", "a line with the names of the columns, such as target [mm]"));
    return false;
}

std::size_t MeasurementCsv::column(
    std::string_view role, std::initializer_list<std::string_view> names)
{
    m_askedRoles.push_back(lowerCase(std::string(role)));
    const auto isCalled = [](const csv::ColumnName& column, std::string_view name) {
        return sameLetters(column.name, name) || sameLetters(column.name + "_" + column.unit, name);
    };
    const auto mapping = std::ranges::find_if(m_options.columns,
        [role](const ColumnMapping& one) { return sameLetters(one.role, role); });
    if (mapping == m_options.columns.end() && !m_options.columns.empty())
        return 0;
    std::vector<std::size_t> found;
    for (std::size_t i = 0; i < m_columns.size(); ++i) {
        const bool isMeant = mapping != m_options.columns.end()
            ? isCalled(m_columns[i], mapping->column)
            : isCalled(m_columns[i], role)
                || std::ranges::any_of(
                    names, [&](std::string_view name) { return isCalled(m_columns[i], name); });
        if (isMeant)
            found.push_back(i + 1);
    }
    if (mapping != m_options.columns.end()) {
        const auto number = wholeNumberOf(mapping->column);
        if (number && *number >= 1 && static_cast<std::size_t>(*number) <= m_columns.size())
            found = {static_cast<std::size_t>(*number)};
        if (found.empty())
            error(DiagnosticCode::MissingColumn, 0,
                AXISCOMP_TEXT("Error", "no column {column} for {role}")
                    .with("column", mapping->column)
                    .with("role", role),
                AXISCOMP_COUNTED("Error", "the name of a column, or its number from 1 to {count}",
                    "the name of the column, or 1")
                    .with("count", m_columns.size()));
    }
    if (found.size() > 1)
        error(DiagnosticCode::MissingColumn, found[1],
            AXISCOMP_TEXT("Error", "two columns for {role}").with("role", role),
            AXISCOMP_TEXT("Error", "one; name the columns with --columns"));
    for (const std::size_t one : found)
        markKnown(one);
    return found.empty() ? 0 : found.front();
}

void MeasurementCsv::findAxis()
{
    if (!m_options.columns.empty())
        m_axisColumn = column("axis", {});
    for (std::size_t i = 0; i < m_columns.size() && m_axisColumn == 0; ++i)
        if (!m_isKnown[i] && m_columns[i].unit.empty() && sameLetters(m_columns[i].name, "axis")) {
            m_axisColumn = i + 1;
            markKnown(i + 1);
        }
}

/// Empty cells are as the line before.
void MeasurementCsv::checkAxis()
{
    const std::string_view axis = text(m_axisColumn);
    if (axis.empty() || sameLetters(axis, m_axisOfLines))
        return;
    if (!m_axisOfLines.empty()) {
        refuseAxis(m_line, m_axisColumn, shown(axis), shown(m_axisOfLines), m_axisOfLinesLine);
        return;
    }
    m_axisOfLines = axis;
    m_axisOfLinesLine = m_line;
    std::string& stated = m_measurement.header.axis;
    if (stated.empty())
        stated = shown(axis);
    else if (areDifferentAxes(stated, axis))
        refuseAxis(m_line, m_axisColumn, shown(axis), stated, m_statedAxisLine);
}

/// Once, whatever number of lines it concerns.
void MeasurementCsv::refuseAxis(std::size_t line, std::size_t column, std::string_view axis,
    std::string_view before, std::size_t lineBefore)
{
    if (!m_isAxisRefused)
        m_diagnostics.error(DiagnosticCode::Contradiction, line, column,
            AXISCOMP_TEXT("Error", "axis {axis}, and axis {before} in line {line}")
                .with("axis", Verbatim{std::string(axis)})
                .with("before", Verbatim{std::string(before)})
                .with("line", lineBefore),
            AXISCOMP_TEXT("Error", "the measurement of one axis; make a file for each axis"));
    m_isAxisRefused = true;
}

void MeasurementCsv::takeAxis(const std::string& value, std::size_t line)
{
    if (!m_axisOfLines.empty() && areDifferentAxes(value, m_axisOfLines)) {
        refuseAxis(line, 0, value, shown(m_axisOfLines), m_axisOfLinesLine);
        return;
    }
    m_measurement.header.axis = value;
    m_statedAxisLine = line;
}

void MeasurementCsv::checkMapping()
{
    for (const ColumnMapping& mapping : m_options.columns)
        if (std::ranges::find(m_askedRoles, lowerCase(mapping.role)) == m_askedRoles.end())
            error(DiagnosticCode::MissingColumn, 0,
                AXISCOMP_TEXT("Error", "a column for {role}").with("role", mapping.role),
                AXISCOMP_TEXT("Error", "one of these words before the =: {known}")
                    .with("known", m_askedRoles));
}

void MeasurementCsv::noteUnknownColumns()
{
    for (std::size_t i = 0; i < m_columns.size(); ++i)
        if (!m_isKnown[i] && !m_columns[i].name.empty())
            m_measurement.notes.push_back("column not used: " + m_columns[i].name);
}

std::optional<MeasurementUnit> MeasurementCsv::unit(std::size_t column, const std::string& stated)
{
    const csv::ColumnName& name = m_columns[column - 1];
    const std::string& symbol = stated.empty() ? name.unit : stated;
    const Text expected = AXISCOMP_TEXT("Error",
        "a unit in brackets behind the name, such as {example}, or --unit "
        "and --value-unit")
                              .with("example", Verbatim{name.name + " [mm]"});
    if (symbol.empty()) {
        error(DiagnosticCode::UnitMissing, column,
            AXISCOMP_TEXT("Error", "column {column}").with("column", name.name), expected);
        return std::nullopt;
    }
    if (!stated.empty() && !name.unit.empty() && !isSameUnit(stated, name.unit))
        m_measurement.againstFile.units.push_back({name.name, stated, name.unit});
    const auto known = measurementUnit(symbol);
    if (!known)
        error(DiagnosticCode::UnitMissing, column,
            AXISCOMP_TEXT("Error", "the unit {unit} of column {column}")
                .with("unit", symbol)
                .with("column", name.name),
            AXISCOMP_TEXT("Error", "a length or an angle: mm, um, m, inch, deg, arcsec, mrad"));
    return known;
}

void MeasurementCsv::checkSameKind(const std::optional<MeasurementUnit>& a,
    const std::optional<MeasurementUnit>& b, std::size_t column)
{
    if (a && b && a->isAngular != b->isAngular)
        error(DiagnosticCode::UnitMixed, column,
            AXISCOMP_TEXT("Error", "column {column}").with("column", m_columns[column - 1].name),
            a->isAngular ? AXISCOMP_TEXT("Error", "an angle as the targets are")
                         : AXISCOMP_TEXT("Error", "a length as the targets are"));
}

std::size_t MeasurementCsv::expectedLines() const
{
    constexpr std::ptrdiff_t most = 4'000'000; // lines may be blank
    constexpr std::ptrdiff_t sample = 16'384;
    const std::ptrdiff_t size = m_lines.end() - m_lines.position();
    const std::ptrdiff_t looked = std::min(sample, size);
    const std::ptrdiff_t lines =
        std::count(m_lines.position(), m_lines.position() + looked, '\n') + 1;
    return static_cast<std::size_t>(std::min(most, lines * (1 + size / (looked + 1))));
}

std::vector<csv::NumberLines> MeasurementCsv::readAhead() const
{
    if (m_axisColumn != 0 || m_options.stop.stop_requested())
        return {};
    return csv::readNumberLines(
        {m_lines.position(), static_cast<std::size_t>(m_lines.end() - m_lines.position())},
        m_cells.format(), m_columns.size());
}

bool MeasurementCsv::take(const csv::NumberLines& piece)
{
    if (m_lines.position() != piece.begin)
        return false;
    m_lines.skipTo(piece.end, piece.lines);
    return true;
}

bool MeasurementCsv::next()
{
    while (!m_lines.atEnd()) {
        m_line = m_lines.lineNumber();
        if ((m_line & 0xfffU) == 0 && m_options.stop.stop_requested())
            return false;
        const std::string_view line = m_lines.next();
        if (takeIfComment(line, m_line) || !m_cells.take(line, m_line))
            continue;
        if (m_axisColumn != 0)
            checkAxis();
        return true;
    }
    return false;
}

std::optional<double> MeasurementCsv::number(std::size_t column)
{
    Number number;
    if (!m_cells.readNumber(column, number))
        return std::nullopt;
    return number.value;
}

std::optional<double> MeasurementCsv::optionalNumber(std::size_t column)
{
    return column == 0 || isEmpty(column) ? std::nullopt : number(column);
}

std::optional<double> MeasurementCsv::time(std::size_t column)
{
    if (column == 0 || isEmpty(column))
        return std::nullopt;
    if (const auto iso = isoSeconds(text(column)))
        return iso;
    return inBase(column, timeUnits,
        AXISCOMP_TEXT("Error",
            "a time in s, ms, min or h, in brackets behind the name; without a unit it is in "
            "s"));
}

std::optional<double> MeasurementCsv::temperature(std::size_t column)
{
    const TextPattern expected = AXISCOMP_TEXT("Error",
        "a temperature in C, K or F, in brackets behind the name; without a unit it is in "
        "C");
    const auto found = inBase(column, temperatureUnits, expected);
    if (found && !isPossibleTemperature(*found))
        error(DiagnosticCode::Syntax, column, Verbatim{shown(text(column))}, expected);
    return found;
}

std::optional<double> MeasurementCsv::inBase(
    std::size_t column, std::span<const ScaleOfUnit> units, const TextPattern& expected)
{
    const auto found = optionalNumber(column);
    if (!found)
        return std::nullopt;
    const csv::ColumnName& name = m_columns[column - 1];
    const auto known = std::ranges::find_if(
        units, [&](const ScaleOfUnit& one) { return sameLetters(one.spelling, name.unit); });
    if (known != units.end())
        return (*found - known->zero) / known->perBase;
    if (!m_isUnitRefused[column - 1])
        m_diagnostics.error(DiagnosticCode::Syntax, m_headerLine, column,
            Verbatim{name.name + " [" + name.unit + "]"}, expected);
    m_isUnitRefused[column - 1] = true;
    return std::nullopt;
}

std::string MeasurementCsv::shown(std::string_view text) const
{
    return excerpt(text, m_inspection.encoding());
}

void MeasurementCsv::error(DiagnosticCode code, std::size_t column, Text found, Text expected)
{
    m_diagnostics.error(
        code, m_line == 0 ? m_headerLine : m_line, column, std::move(found), std::move(expected));
}

void MeasurementCsv::settleValues(std::optional<bool> isReference, bool haveSign)
{
    m_settledReference = isReference;
    m_isSignSettled = haveSign;
    m_areAllReference = !haveSign;
    if (m_areAllReference && m_comments.holdsCorrections)
        refuseSignOfReference(m_statements.at("sign").line);
}

void MeasurementCsv::noteValues(bool areReference)
{
    using Values = MeasurementReadOptions::Values;
    AgainstFile& asked = m_measurement.againstFile;
    if (areReference && m_options.values == Values::Deviation)
        asked.takesAsDeviations = true;
    if (!areReference && m_options.values == Values::Reference)
        asked.takesAsReference = true;
}

void MeasurementCsv::refuseSignOfReference(std::size_t line)
{
    m_diagnostics.error(DiagnosticCode::Contradiction, line, 0,
        AXISCOMP_TEXT("Error", "sign: correction, and positions of the reference"),
        AXISCOMP_TEXT("Error",
            "no sign with positions of the reference, which are what they are; or deviations with "
            "their sign"));
}

bool MeasurementCsv::takeIfComment(std::string_view line, std::size_t lineNumber)
{
    if (!isCsvComment(line))
        return false;
    if (const std::string_view content = trimmed(line); !content.empty())
        takeComment(trimmed(content.substr(2)), lineNumber);
    return true;
}

void MeasurementCsv::takeComment(std::string_view comment, std::size_t line)
{
    constexpr std::size_t mostNoteBytes = std::size_t{1} << 20U;
    std::string text = shownText(toUtf8(comment, m_inspection.encoding()), 1000);
    const std::size_t colon = text.find(':');
    const std::string_view key = trimmed(std::string_view(text).substr(0, colon));
    const std::string value(colon == std::string::npos
            ? std::string_view()
            : withoutSeparators(std::string_view(text).substr(colon + 1)));
    if (colon != std::string::npos && takeStatement(key, value, line)) {
        checkSaidBefore(lowerCase(std::string(key)), value, line);
        return;
    }
    if (colon != std::string::npos && sameLetters(key, "note"))
        text = value;
    m_noteBytes += text.size();
    if (!text.empty() && m_noteBytes <= mostNoteBytes)
        m_measurement.notes.push_back(text);
}

/// By what a statement means, so that "20.4" and "20.40 C" are one. Empty: nothing that counts.
std::string MeasurementCsv::meaningOf(std::string_view key, const std::string& value) const
{
    const MeasurementHeader& header = m_measurement.header;
    const auto number = [](const std::optional<double>& said) {
        return said ? shortestText(*said) : std::string();
    };
    if (key == "axis")
        return lowerCase(value);
    if (key == "drive") {
        const auto serial = driveSerialOf(header);
        return serial ? std::to_string(*serial) : std::string();
    }
    if (key == "compensation")
        return measuredStateText(header.compensation);
    if (key == "corrected")
        return header.corrected == MeasurementHeader::Corrected::NotSaid
            ? std::string()
            : std::to_string(static_cast<int>(header.corrected));
    if (key == "kind")
        return std::string(measurementKindName(m_measurement.kind));
    if (key == "values")
        return m_comments.holdsReference.value_or(false) ? "reference" : "deviation";
    if (key == "sign")
        return m_comments.holdsCorrections ? "correction" : "deviation";
    if (key == "air temperature")
        return number(header.airTemperature);
    if (key == "material temperature")
        return number(header.materialTemperature);
    return key == "expansion" ? number(header.expansion) : std::string();
}

void MeasurementCsv::checkSaidBefore(
    const std::string& key, const std::string& value, std::size_t line)
{
    const std::string meaning = meaningOf(key, value);
    if (meaning.empty())
        return;
    const auto [first, isFirst] = m_statements.try_emplace(key, Statement{meaning, value, line});
    if (isFirst || first->second.meaning == meaning)
        return;
    const auto shownStatement = [&](const std::string& said) {
        return key + ": " + excerpt(said, Encoding::Utf8);
    };
    m_diagnostics.error(DiagnosticCode::Contradiction, line, 0,
        AXISCOMP_TEXT("Error", "{second}, and {first} in line {line}")
            .with("second", shownStatement(value))
            .with("first", shownStatement(first->second.value))
            .with("line", first->second.line),
        AXISCOMP_TEXT("Error", "one statement of it"));
}

bool MeasurementCsv::takeStatement(std::string_view key, const std::string& value, std::size_t line)
{
    if (sameLetters(key, "axis")) {
        takeAxis(value, line);
        return true;
    }
    if (takeText(key, value) || takeNumber(key, value, line))
        return true;
    if (sameLetters(key, "compensation")) {
        takeCompensation(value, line);
    } else if (sameLetters(key, "corrected")) {
        if (sameLetters(value, "none"))
            m_measurement.header.corrected = MeasurementHeader::Corrected::None;
        else if (sameLetters(value, "20C") || sameLetters(value, "20 C"))
            m_measurement.header.corrected = MeasurementHeader::Corrected::To20Celsius;
        else
            refuse(line, value, AXISCOMP_TEXT("Error", "corrected: none, or corrected: 20C"));
    } else if (sameLetters(key, "kind") && m_measurement.hasTargets()) {
        takeKind(value, line);
    } else if (sameLetters(key, "values")) {
        takeValues(value, line);
    } else if (sameLetters(key, "sign")) {
        takeSign(value, line);
    } else {
        return false;
    }
    return true;
}

/// Tracks and points say theirs by their columns.
void MeasurementCsv::takeKind(const std::string& value, std::size_t line)
{
    for (const MeasurementKind kind : {MeasurementKind::Runs, MeasurementKind::Averages})
        if (sameLetters(value, measurementKindName(kind))) {
            m_measurement.kind = kind;
            return;
        }
    refuse(line, value, AXISCOMP_TEXT("Error", "kind: runs, or kind: averages (means of runs)"));
}

void MeasurementCsv::takeValues(const std::string& value, std::size_t line)
{
    const bool isReference = sameLetters(value, "reference");
    if (!isReference && !sameLetters(value, "deviation"))
        refuse(line, value, AXISCOMP_TEXT("Error", "values: deviation, or values: reference"));
    else if (m_settledReference && *m_settledReference != isReference)
        refuseLate(line, "values: " + value);
    else {
        m_comments.holdsReference = isReference;
        noteValues(isReference);
    }
}

void MeasurementCsv::takeSign(const std::string& value, std::size_t line)
{
    const bool isCorrection = sameLetters(value, "correction");
    if (!isCorrection && !sameLetters(value, "deviation"))
        refuse(line, value,
            AXISCOMP_TEXT("Error",
                "sign: deviation (reference minus target), or sign: correction (its "
                "opposite)"));
    else if (m_areAllReference && isCorrection)
        refuseSignOfReference(line);
    else if (m_isSignSettled && m_comments.holdsCorrections != isCorrection)
        refuseLate(line, "sign: " + value);
    else
        m_comments.holdsCorrections = isCorrection;
}

void MeasurementCsv::refuseLate(std::size_t line, std::string_view statement)
{
    refuse(line, statement,
        AXISCOMP_TEXT("Error", "this statement before the header, since it holds for every line"));
}

bool MeasurementCsv::takeText(std::string_view key, const std::string& value)
{
    if (sameLetters(key, "axiscomp runs"))
        return true;
    for (const HeaderText& text : headerTexts)
        if (sameLetters(key, text.key)) {
            m_measurement.header.*text.member = value;
            return true;
        }
    return false;
}

bool MeasurementCsv::takeNumber(std::string_view key, const std::string& value, std::size_t line)
{
    MeasurementHeader& header = m_measurement.header;
    const bool isAir = sameLetters(key, "air temperature");
    if (isAir || sameLetters(key, "material temperature")) {
        const auto number = numberWithUnit(value, {"C", "degC", "deg C", "\u00b0C"});
        (isAir ? header.airTemperature : header.materialTemperature) = number;
        if (!number || !isPossibleTemperature(*number))
            refuse(line, value, AXISCOMP_TEXT("Error", "a temperature in deg C, such as 20.4"));
        return true;
    }
    if (!sameLetters(key, "expansion"))
        return false;
    header.expansion = numberWithUnit(value, {"1/K", "/K"});
    if (!header.expansion)
        refuse(line, value,
            AXISCOMP_TEXT("Error", "a coefficient of expansion in 1/K, such as 11.5e-6"));
    return true;
}

void MeasurementCsv::takeCompensation(const std::string& value, std::size_t line)
{
    MeasuredState& state = m_measurement.header.compensation;
    if (sameLetters(value, "off")) {
        state = {MeasuredState::Kind::Off, {}};
        return;
    }
    if (sameLetters(value, "on")) {
        state = {MeasuredState::Kind::On, {}};
        return;
    }
    std::uint32_t crc = 0;
    const std::string_view digits =
        value.size() > 4 ? std::string_view(value).substr(4) : std::string_view();
    const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), crc, 16);
    if (sameLetters(std::string_view(value).substr(0, 4), "crc:") && read.ec == std::errc{}
        && read.ptr == digits.data() + digits.size())
        state = {MeasuredState::Kind::On, crc};
    else
        refuse(line, value,
            AXISCOMP_TEXT("Error",
                "compensation: off, on, or crc: with the checksum of the table, such as "
                "crc:1c291ca3"));
}

void MeasurementCsv::refuse(std::size_t line, std::string_view value, const TextPattern& expected)
{
    m_diagnostics.error(
        DiagnosticCode::Syntax, line, 0, Verbatim{excerpt(value, Encoding::Utf8)}, expected);
}

std::optional<MeasurementPreview> previewMeasurement(
    std::string_view text, std::size_t skippedLines, std::size_t mostRows)
{
    MeasurementReadOptions options;
    options.skippedLines = skippedLines;
    Measurement measurement;
    DiagnosticList diagnostics(options.maximumDiagnostics);
    MeasurementCsv csv(text, options, measurement, diagnostics);
    if (!csv.readHeader())
        return std::nullopt;
    MeasurementPreview preview;
    for (const csv::ColumnName& column : csv.columns())
        preview.columns.push_back(
            column.unit.empty() ? column.name : column.name + " [" + column.unit + "]");
    while (preview.rows.size() < mostRows && csv.next()) {
        std::vector<std::string>& row = preview.rows.emplace_back();
        for (std::size_t column = 1; column <= preview.columns.size(); ++column)
            row.push_back(csv.shown(csv.text(column)));
    }
    return preview;
}

} // namespace axiscomp
