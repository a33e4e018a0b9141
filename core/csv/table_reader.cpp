// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/table_reader.h"

#include "core/table/large_correction.h"
#include "core/text/number_text.h"

#include <algorithm>

namespace axiscomp::csv {

namespace {

/// docs/calibration-csv.md, "What goes wrong": 0.01. The rest is for the rounding of float32.
constexpr double largestGradient = 0.01 * (1.0 + 1e-6);
constexpr double largestRelativeError = 1e-6; ///< of the largest value

class TableReader {
public:
    TableReader(const Scan& scan, const std::vector<std::uint32_t>& points, std::size_t index,
        DiagnosticList& diagnostics)
        : m_scan(scan)
        , m_points(points)
        , m_index(index)
        , m_column(scan.positions.size() + index + 1)
        , m_diagnostics(diagnostics)
    {
    }

    CompensationTable read(const Grid& grid);

private:
    void warnOfPrecision(const ValueRange& range);
    void warnOfGradient(const CompensationTable& table);

    const Scan& m_scan;
    const std::vector<std::uint32_t>& m_points;
    std::size_t m_index;
    std::size_t m_column;
    DiagnosticList& m_diagnostics;
};

CompensationTable TableReader::read(const Grid& grid)
{
    const ColumnName& name = m_scan.columns[m_column - 1];
    CompensationTable table{name.name, name.unit, grid, std::vector<float>(m_points.size())};
    const std::uint32_t* point = m_points.data();
    for (const RowStore::Block& block : m_scan.rows.blocks()) {
        const float* values = block.values.get() + m_index * m_scan.rows.blockRows();
        for (std::size_t i = 0; i < block.rows; ++i)
            table.values[*point++] = values[i];
    }
    const auto [smallest, largest] = std::ranges::minmax(table.values);
    warnOfPrecision(m_scan.ranges[m_index]);
    if (smallest == largest)
        m_diagnostics.warning(DiagnosticCode::ConstantTable, m_scan.headerLine, m_column,

            AXISCOMP_TEXT("Error", "{value} at every point of {table}")
                .with("value", Quantity{toText(smallest)})
                .with("table", table.name),
            AXISCOMP_TEXT("Error", "values that differ"));
    else
        warnOfGradient(table);
    return table;
}

void TableReader::warnOfPrecision(const ValueRange& range)
{
    if (range.largestError > largestRelativeError * range.largest)
        m_diagnostics.warning(DiagnosticCode::FloatPrecision,
            m_scan.rowLines.lineOf(range.errorRow), m_column,
            AXISCOMP_TEXT("Error", "a change of {change}")
                .with("change", Quantity{roundedText(range.largestError)}),
            AXISCOMP_TEXT("Error", "at most a millionth of the largest value, {value}")
                .with("value", Quantity{toText(range.largest)}));
}

void TableReader::warnOfGradient(const CompensationTable& table)
{
    const SteepestStep step = steepestStep(table);
    if (!(step.slope > largestGradient))
        return;
    const GridAxis& axis = table.grid.axes[step.dimension];
    const auto row = std::ranges::find(m_points, static_cast<std::uint32_t>(step.to));
    m_diagnostics.warning(DiagnosticCode::LargeGradient,
        m_scan.rowLines.lineOf(static_cast<std::size_t>(row - m_points.begin())), m_column,
        AXISCOMP_TEXT(
            "Error", "a step from {from} to {to} over {distance} in dimension {dimension}")
            .with("from", Quantity{toText(table.values[step.from]), table.unit})
            .with("to", Quantity{toText(table.values[step.to]), table.unit})
            .with("distance", Quantity{roundedText(axis.distance), axis.unit})
            .with("dimension", step.dimension + 1),
        AXISCOMP_TEXT("Error", "at most 0.01 per unit of position"));
}

} // namespace

std::vector<CompensationTable> readTables(const Scan& scan, const Grid& grid,
    const std::vector<std::uint32_t>& points, DiagnosticList& diagnostics)
{
    std::vector<CompensationTable> tables;
    tables.reserve(scan.tables());
    for (std::size_t index = 0; index < scan.tables(); ++index)
        tables.push_back(TableReader(scan, points, index, diagnostics).read(grid));
    return tables;
}

} // namespace axiscomp::csv
