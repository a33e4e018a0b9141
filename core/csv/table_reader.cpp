// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/table_reader.h"

#include "core/base/parallel.h"
#include "core/table/large_correction.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <limits>
#include <utility>

namespace axiscomp::csv {

namespace {

/// docs/calibration-csv.md, "What goes wrong": 0.01. The rest is for the rounding of float32.
constexpr double largestGradient = 0.01 * (1.0 + 1e-6);
constexpr double largestRelativeError = 1e-6; ///< of the largest value

/// What is worth a warning in a table.
class TableCheck {
public:
    /// places: of the rows in the table; null: they are not worth saying
    TableCheck(
        const Scan& scan, const Places* places, std::size_t index, DiagnosticList& diagnostics)
        : m_scan(scan)
        , m_places(places)
        , m_index(index)
        , m_column(static_cast<std::size_t>(scan.dimensions) + index + 1)
        , m_diagnostics(diagnostics)
    {
    }

    void look(const CompensationTable& table);

private:
    void warnOfPrecision(const ValueRange& range);
    void warnOfGradient(const CompensationTable& table);
    [[nodiscard]] std::size_t lineOf(std::size_t point) const;

    const Scan& m_scan;
    const Places* m_places;
    std::size_t m_index;
    std::size_t m_column;
    DiagnosticList& m_diagnostics;
};

void TableCheck::look(const CompensationTable& table)
{
    const float first = table.values.front();
    const bool isConstant =
        std::ranges::all_of(table.values, [first](float value) { return value == first; });
    warnOfPrecision(m_scan.ranges[m_index]);
    if (isConstant)
        m_diagnostics.warning(DiagnosticCode::ConstantTable, m_scan.headerLine, m_column,
            AXISCOMP_TEXT("Error", "{value} at every point of {table}")
                .with("value", Quantity{toText(first)})
                .with("table", table.name),
            AXISCOMP_TEXT("Error", "values that differ"));
    else
        warnOfGradient(table);
}

void TableCheck::warnOfPrecision(const ValueRange& range)
{
    if (range.largestError > largestRelativeError * range.largest)
        m_diagnostics.warning(DiagnosticCode::FloatPrecision,
            m_scan.rowLines.lineOf(range.errorRow), m_column,
            AXISCOMP_TEXT("Error", "a change of {change}")
                .with("change", Quantity{roundedText(range.largestError)}),
            AXISCOMP_TEXT("Error", "at most a millionth of the largest value, {value}")
                .with("value", Quantity{toText(range.largest)}));
}

void TableCheck::warnOfGradient(const CompensationTable& table)
{
    const SteepestStep step = steepestStep(table);
    if (!(step.slope > largestGradient))
        return;
    const GridAxis& axis = table.grid.axes[step.dimension];
    m_diagnostics.warning(DiagnosticCode::LargeGradient, lineOf(step.to), m_column,
        AXISCOMP_TEXT(
            "Error", "a step from {from} to {to} over {distance} in dimension {dimension}")
            .with("from", Quantity{toText(table.values[step.from]), table.unit})
            .with("to", Quantity{toText(table.values[step.to]), table.unit})
            .with("distance", Quantity{roundedText(axis.distance), axis.unit})
            .with("dimension", step.dimension + 1),
        AXISCOMP_TEXT("Error", "at most 0.01 per unit of position"));
}

/// 0 where the table has points that the file does not have, or others than the file.
std::size_t TableCheck::lineOf(std::size_t point) const
{
    const std::size_t row =
        m_places == nullptr ? m_scan.rows : m_places->rowOf(static_cast<double>(point));
    return row == m_scan.rows ? 0 : m_scan.rowLines.lineOf(row);
}

/// A point without a row is NaN, and one with several has any of them.
std::vector<CompensationTable> placedTables(
    const Scan& scan, const Grid& grid, const Places& places, std::size_t threads)
{
    std::vector<CompensationTable> tables;
    for (std::size_t index = 0; index < scan.tables(); ++index) {
        const ColumnName& name = scan.columns[static_cast<std::size_t>(scan.dimensions) + index];
        tables.push_back({name.name, name.unit, grid,
            std::vector<float>(grid.pointCount(), std::numeric_limits<float>::quiet_NaN())});
    }
    shareWork(scan.pieces.size(), threads, [&](std::size_t n) {
        const std::size_t stride = scan.pieces[n].rows.blockRows();
        places.forEachBlock(scan.pieces[n],
            [&](std::size_t, const RowStore::Block& block, std::span<const double> own) {
                const float* values = block.values.get();
                for (CompensationTable& table : tables) {
                    for (std::size_t i = 0; i < own.size(); ++i)
                        std::atomic_ref(table.values[static_cast<std::size_t>(own[i])])
                            .store(values[i], std::memory_order_relaxed);
                    values += stride;
                }
                return true;
            });
    });
    return tables;
}

bool hasValueEverywhere(const CompensationTable& table)
{
    return std::ranges::none_of(table.values, [](float value) { return std::isnan(value); });
}

std::vector<double> positionsOf(const GridAxis& axis)
{
    std::vector<double> positions;
    for (std::size_t i = 0; i < axis.size; ++i)
        positions.push_back(axis.position(i));
    return positions;
}

IncompleteGrid incompleteGrid(
    const Scan& scan, const GridReading& reading, const std::vector<CompensationTable>& tables)
{
    IncompleteGrid grid;
    for (std::size_t d = 0; d < reading.grid.axes.size(); ++d) {
        const GridAxis& axis = reading.grid.axes[d];
        grid.knots.push_back(reading.knots.empty() ? positionsOf(axis) : reading.knots[d]);
        grid.names.push_back(columnText(scan.columns[d], d));
        grid.units.push_back(axis.unit);
    }
    for (const CompensationTable& table : tables) {
        grid.tables.emplace_back(table.values.begin(), table.values.end());
        grid.tableNames.emplace_back(Verbatim{table.name});
        grid.valueUnits.push_back(table.unit);
    }
    return grid;
}

/// False: that is not possible, and diagnostics say why.
bool complete(const Scan& scan, GridReading& reading, MissingPoints missing,
    std::vector<CompensationTable>& tables, DiagnosticList& diagnostics)
{
    auto grid = completeGrid(incompleteGrid(scan, reading, tables), missing, diagnostics);
    if (!grid)
        return false;
    for (std::size_t d = 0; d < reading.grid.axes.size(); ++d) {
        GridAxis& axis = reading.grid.axes[d];
        const std::vector<double>& knots = grid->knots[d];
        const bool isCut = knots.size() < axis.size;
        const double mean = (knots.back() - knots.front()) / static_cast<double>(knots.size() - 1);
        axis.start = axis.position(grid->first[d]);
        axis.size = static_cast<std::uint32_t>(knots.size());
        if (reading.knots.empty())
            continue;
        if (isCut && std::fabs(mean - axis.distance) > 1e-9 * axis.distance) { // uneven
            axis.start = knots.front();
            axis.distance = mean;
        }
        reading.knots[d] = knots;
    }
    for (std::size_t n = 0; n < tables.size(); ++n) {
        const auto narrow = [](double value) { return static_cast<float>(value); };
        tables[n].grid = reading.grid;
        tables[n].values.resize(grid->tables[n].size());
        std::ranges::transform(grid->tables[n], tables[n].values.begin(), narrow);
        tables[n].filled = std::move(grid->filled[n]);
    }
    return true;
}

} // namespace

std::vector<CompensationTable> readTables(const Scan& scan, GridReading& reading,
    const Places& places, const CsvOptions& options, DiagnosticList& diagnostics)
{
    // As many rows as points, and a value at each: then no point has two.
    const bool mayBeFull = reading.even && reading.pointCount() == static_cast<double>(scan.rows);
    std::vector<CompensationTable> tables;
    if (mayBeFull)
        tables = placedTables(scan, reading.grid, places, options.threads);
    if (!mayBeFull || !hasValueEverywhere(tables.front()))
        checkPoints(scan, reading, places, options, diagnostics);
    if (diagnostics.hasErrors())
        return {};
    if (!mayBeFull)
        tables = placedTables(scan, reading.grid, places, options.threads);
    const Grid whole = reading.grid;
    if (options.missing != MissingPoints::Refuse
        && !complete(scan, reading, options.missing, tables, diagnostics))
        return {};
    const Places* const known = sameSpans(whole, reading.grid) ? &places : nullptr;
    for (std::size_t index = 0; index < scan.tables(); ++index)
        TableCheck(scan, known, index, diagnostics).look(tables[index]);
    return tables;
}

} // namespace axiscomp::csv
