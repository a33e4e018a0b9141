// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/io/large_memory.h"
#include "core/metrology/formats/measurement_csv.h"
#include "core/metrology/formats/measurement_formats.h"
#include "core/metrology/formats/run_assembly.h"
#include "core/text/token_scanner.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace axiscomp::points_csv {

namespace {

constexpr std::array<std::string_view, 1> extensions{".csv"};
constexpr std::array kinds{MeasurementKind::Points};
constexpr std::array<std::string_view, 4> rules{
    "Columns X and Y, or X, Y and Z, then any number of value columns such as dX, dY, or the "
    "coordinates of the reference Xr, Yr, Zr, whose difference to X, Y, Z is the value.",
    "A value is the reference less the position, a deviation as that of runs; with // sign: "
    "correction it is the opposite.",
    "Positions and values are all lengths or all angles.",
    "Points may stand in any order, may be repeated, and need not be a grid.",
};
constexpr std::array<std::string_view, 3> axisNames{"X", "Y", "Z"};

/// A column of values, or of reference coordinates less those of an axis.
struct ValueColumn {
    std::size_t column = 0;
    std::string name;
    double factor = 1.0;
    std::optional<std::size_t> axis; ///< whose position is subtracted
};

class Reader {
public:
    Reader(MeasurementCsv& csv, const MeasurementReadOptions& options, Measurement& measurement,
        DiagnosticList& diagnostics)
        : m_csv(csv)
        , m_options(options)
        , m_measurement(measurement)
        , m_points(measurement.points)
        , m_diagnostics(diagnostics)
    {
    }

    void run()
    {
        if (findAxes() && findValues())
            readPoints();
    }

private:
    [[nodiscard]] bool findAxes();
    [[nodiscard]] bool findValues();
    void findMappedValues();
    [[nodiscard]] std::optional<std::size_t> axisOfReference(std::string_view name) const;
    void addValues(std::size_t column, std::string name, std::optional<std::size_t> axis);
    void readPoints();
    template <typename NumberOf> void addPoint(NumberOf numberOf);
    void readPoint();
    void takePoints(const csv::NumberLines& piece);
    void checkValues();

    MeasurementCsv& m_csv;
    const MeasurementReadOptions& m_options;
    Measurement& m_measurement;
    MeasuredPoints& m_points;
    DiagnosticList& m_diagnostics;
    std::vector<std::size_t> m_axes; ///< columns
    std::vector<MeasurementUnit> m_units; ///< of the axes
    std::vector<ValueColumn> m_values;
    std::vector<double> m_lineNumbers; ///< of the line that is being read, by column
};

bool Reader::findAxes()
{
    for (const std::string_view name : axisNames) {
        const std::size_t column = m_csv.column(name, {});
        if (column == 0)
            break;
        const auto unit = m_csv.unit(column, m_options.unit);
        if (!unit)
            continue;
        if (!m_units.empty() && unit->isAngular != m_units.front().isAngular)
            m_csv.error(DiagnosticCode::UnitMixed, column,
                AXISCOMP_TEXT("Error", "column {column}").with("column", name),
                m_units.front().isAngular
                    ? AXISCOMP_TEXT("Error", "an angle as the first axis has")
                    : AXISCOMP_TEXT("Error", "a length as the first axis has"));
        m_axes.push_back(column);
        m_units.push_back(*unit);
        m_points.axes.emplace_back(name);
    }
    if (m_axes.size() < 2 && !m_diagnostics.hasErrors())
        m_csv.error(DiagnosticCode::MissingColumn, 0, AXISCOMP_TEXT("Error", "no columns X and Y"),
            AXISCOMP_TEXT("Error", "columns X and Y, or X, Y and Z, with the positions"));
    if (m_diagnostics.hasErrors())
        return false;
    m_measurement.isAngular = m_units.front().isAngular;
    return true;
}

void Reader::addValues(std::size_t column, std::string name, std::optional<std::size_t> axis)
{
    m_csv.markKnown(column);
    const auto unit = m_csv.unit(column, m_options.valueUnit);
    m_csv.checkSameKind(m_units.front(), unit, column);
    if (axis)
        name = "d" + m_points.axes[*axis];
    m_values.push_back({column, std::move(name), unit ? unit->factor : 1.0, axis});
    m_points.columns.push_back(m_values.back().name);
}

/// With a mapping, the value columns are those that it names beside the axes.
void Reader::findMappedValues()
{
    for (const ColumnMapping& mapping : m_options.columns) {
        const bool isAxis = std::ranges::any_of(axisNames,
            [&mapping](std::string_view name) { return sameLetters(name, mapping.role); });
        const std::size_t column =
            isAxis || sameLetters(mapping.role, "axis") ? 0 : m_csv.column(mapping.role, {});
        if (column != 0)
            addValues(column, mapping.role, axisOfReference(mapping.role));
    }
}

/// "Xr" holds positions of X.
std::optional<std::size_t> Reader::axisOfReference(std::string_view name) const
{
    for (std::size_t a = 0; a < m_axes.size(); ++a)
        if (sameLetters(name, m_points.axes[a] + "r"))
            return a;
    return std::nullopt;
}

bool Reader::findValues()
{
    m_csv.findAxis();
    if (!m_options.columns.empty())
        findMappedValues();
    for (std::size_t i = 0; i < m_csv.columns().size() && m_options.columns.empty(); ++i) {
        const std::string& name = m_csv.columns()[i].name;
        if (!name.empty() && !m_csv.isAxis(i + 1)
            && std::ranges::find(m_axes, i + 1) == m_axes.end())
            addValues(i + 1, name, axisOfReference(name));
    }
    if (m_values.empty())
        m_csv.error(DiagnosticCode::MissingColumn, 0, AXISCOMP_TEXT("Error", "no column of values"),
            AXISCOMP_TEXT("Error", "at least one behind the positions, such as dX [um]"));
    else
        checkStatedValues(m_options,
            std::ranges::any_of(
                m_values, [](const ValueColumn& one) { return one.axis.has_value(); }),
            m_diagnostics);
    return !m_diagnostics.hasErrors();
}

/// numberOf: the number in a column.
template <typename NumberOf> void Reader::addPoint(NumberOf numberOf)
{
    std::array<double, axisNames.size()> position{};
    for (std::size_t a = 0; a < m_axes.size(); ++a) {
        position[a] = numberOf(m_axes[a]) * m_units[a].factor;
        m_points.positions[a].push_back(position[a]);
    }
    for (std::size_t v = 0; v < m_values.size(); ++v) {
        const ValueColumn& column = m_values[v];
        const bool isCorrection = !column.axis && m_csv.comments().holdsCorrections;
        const bool isTurned = isCorrection || (column.axis && m_options.invertsReference);
        const double scaled = numberOf(column.column) * (isTurned ? -column.factor : column.factor);
        m_points.values[v].push_back(!column.axis ? scaled : scaled - position[*column.axis]);
    }
}

void Reader::readPoint()
{
    bool isGood = true;
    const auto read = [&](std::size_t column) {
        const auto number = m_csv.number(column);
        isGood = isGood && number;
        m_lineNumbers[column - 1] = number.value_or(0.0);
    };
    for (const std::size_t column : m_axes)
        read(column);
    for (const ValueColumn& column : m_values)
        read(column.column);
    if (!isGood)
        return;
    addPoint([this](std::size_t column) { return m_lineNumbers[column - 1]; });
    for (const std::vector<double>& values : m_points.values)
        isGood = isGood && std::isfinite(values.back());
    if (!isGood)
        m_csv.error(DiagnosticCode::NotFinite, 0, {},
            AXISCOMP_TEXT("Error", "numbers that a computer can hold; check their size"));
}

/// Short numbers are finite in every unit.
void Reader::takePoints(const csv::NumberLines& piece)
{
    const std::size_t columns = m_csv.columns().size();
    const std::size_t lines = m_csv.take(piece) ? piece.lines : 0;
    for (std::size_t n = 0; n < lines; ++n) {
        const double* const numbers = &piece.values[n * columns];
        addPoint([numbers](std::size_t column) { return numbers[column - 1]; });
    }
    while (m_csv.isBefore(piece.limit) && m_csv.next())
        readPoint();
}

void Reader::readPoints()
{
    m_csv.settleValues(std::nullopt,
        std::ranges::any_of(m_values, [](const ValueColumn& one) { return !one.axis; }));
    m_points.positions.resize(m_axes.size());
    m_points.values.resize(m_values.size());
    const std::size_t lines = m_csv.expectedLines();
    for (auto* const columns : {&m_points.positions, &m_points.values})
        for (std::vector<double>& column : *columns)
            reserveLarge(column, lines);
    m_lineNumbers.resize(m_csv.columns().size());
    if (m_csv.next()) // may be what shows the decimal sign
        readPoint();
    for (auto pieces = m_csv.readAhead(); !pieces.empty(); pieces = m_csv.readAhead())
        for (const csv::NumberLines& piece : pieces)
            takePoints(piece);
    while (m_csv.next())
        readPoint();
    checkValues();
    if (m_points.size() == 0 && !m_diagnostics.hasErrors())
        m_diagnostics.error(DiagnosticCode::TooFewPoints, m_csv.headerLine(), 0,
            AXISCOMP_TEXT("Error", "no data lines after the header"),
            AXISCOMP_TEXT("Error", "a line for each point"));
}

void Reader::checkValues()
{
    for (std::size_t v = 0; v < m_values.size() && !m_diagnostics.hasErrors(); ++v) {
        const std::vector<double>& values = m_points.values[v];
        if (m_values[v].axis) {
            const std::vector<double>& encoder = m_points.positions[*m_values[v].axis];
            std::vector<double> reference = values;
            for (std::size_t i = 0; i < reference.size(); ++i)
                reference[i] += encoder[i];
            checkInstrumentScale(
                {encoder, reference, m_measurement.isAngular}, m_options, m_diagnostics);
        }
        if (!m_diagnostics.hasErrors())
            checkValueSizes({.positions = m_points.positions,
                                .values = values,
                                .unit = std::string(positionUnit(m_measurement)),
                                .line = m_csv.headerLine(),
                                .column = m_values[v].column},
                m_diagnostics);
    }
}

void parse(std::string_view text, const MeasurementReadOptions& options, Measurement& measurement,
    DiagnosticList& diagnostics)
{
    measurement.kind = MeasurementKind::Points;
    MeasurementCsv csv(text, options, measurement, diagnostics);
    if (csv.readHeader())
        Reader(csv, options, measurement, diagnostics).run();
}

MeasurementReading read(std::string_view text, const MeasurementReadOptions& options)
{
    return readMeasurementText(text, options, parse);
}

/// A calibration file for two axes may have the same header: only what nothing else has is certain.
MeasurementRecognition recognise(std::string_view text)
{
    const std::vector<std::string> names = headerNames(text);
    const bool hasPlane = names.size() > 2 && names[0] == "x" && names[1] == "y";
    return hasPlane ? MeasurementRecognition::Possible : MeasurementRecognition::No;
}

} // namespace

const MeasurementFormat& format()
{
    static const MeasurementFormat format{
        .facts = {.name = "points",
            .origin = "grid plates and trackers",
            .description = AXISCOMP_TEXT("Error", "CSV of values at positions of 2 or 3 axes"),
            .extensions = extensions,
            .kinds = kinds,
            .rules = rules},
        .recognise = recognise,
        .read = read};
    return format;
}

} // namespace axiscomp::points_csv
