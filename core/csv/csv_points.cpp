// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/grid_reader.h"
#include "core/csv/header.h"

#include <array>
#include <cmath>

namespace axiscomp::csv {

namespace {

constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

class PointReader {
public:
    PointReader(const Scan& scan, const GridReading& grid, DiagnosticList& diagnostics)
        : m_scan(scan)
        , m_grid(grid)
        , m_dimensions(grid.lines.size())
        , m_rows(scan.rows.size())
        , m_diagnostics(diagnostics)
    {
        for (std::size_t d = 0; d < m_dimensions; ++d) {
            m_sizes[d] = static_cast<double>(grid.lines[d].positions.size());
            m_pointCount *= m_sizes[d];
        }
        // Enough to find the first missing points of a grid of any size, and all points of a full
        // one.
        m_looked = static_cast<std::size_t>(
            std::min(m_pointCount, static_cast<double>(m_rows + mostNamed)));
    }

    std::vector<std::uint32_t> read();

private:
    void place();
    void reportDuplicates();
    void reportMissing();
    [[nodiscard]] std::string pointText(std::size_t point) const;
    [[nodiscard]] std::string fewerDimensionsHint() const;

    static constexpr std::size_t mostNamed = 3; ///< missing points
    static constexpr std::size_t mostDuplicates = 20;

    struct Duplicate {
        std::size_t row;
        std::uint32_t point;
    };

    const Scan& m_scan;
    const GridReading& m_grid;
    std::size_t m_dimensions;
    std::size_t m_rows;
    DiagnosticList& m_diagnostics;
    std::array<double, 3> m_sizes{1.0, 1.0, 1.0};
    double m_pointCount = 1.0; ///< may be beyond any integer in a file that is no grid
    std::size_t m_looked = 0; ///< points that are looked at, from the first
    std::vector<bool> m_occupied;
    std::vector<std::uint32_t> m_points;
    std::vector<Duplicate> m_duplicates; ///< the first ones
    std::size_t m_duplicateCount = 0;
};

std::vector<std::uint32_t> PointReader::read()
{
    place();
    reportDuplicates();
    // What a grid misses is worth saying when there is a grid: not when positions scatter.
    if (m_grid.even)
        reportMissing();
    const bool full = m_duplicateCount == 0 && m_pointCount == static_cast<double>(m_rows);
    return full ? std::move(m_points) : std::vector<std::uint32_t>{};
}

void PointReader::place()
{
    // Doubles hold every place that is looked at exactly, and do not overflow beyond.
    std::array<std::vector<double>, 3> strides;
    double stride = 1.0;
    for (std::size_t d = 0; d < m_dimensions; ++d) {
        for (const std::uint32_t line : m_grid.lines[d].lineOf)
            strides[d].push_back(stride * line);
        stride *= m_sizes[d];
    }
    m_occupied.assign(m_looked, false);
    m_points.resize(m_rows);
    const auto limit = static_cast<double>(m_looked);
    forEachRow(m_scan, [&](const RowStore::Block& block, std::size_t i, std::size_t row) {
        double point = 0.0;
        for (std::size_t d = 0; d < m_dimensions; ++d)
            point += strides[d][m_scan.id(block, i, row, d)];
        m_points[row] = nowhere;
        if (point >= limit)
            return true;
        m_points[row] = static_cast<std::uint32_t>(point);
        if (!m_occupied[m_points[row]]) {
            m_occupied[m_points[row]] = true;
        } else {
            if (m_duplicateCount < mostDuplicates)
                m_duplicates.push_back({row, m_points[row]});
            ++m_duplicateCount;
        }
        return true;
    });
}

void PointReader::reportDuplicates()
{
    std::vector<std::size_t> firstRows(m_duplicates.size(), m_rows);
    if (!m_duplicates.empty())
        for (std::size_t row = 0; row < m_duplicates.back().row; ++row)
            for (std::size_t i = 0; i < m_duplicates.size(); ++i)
                if (m_points[row] == m_duplicates[i].point)
                    firstRows[i] = std::min(firstRows[i], row);
    std::string expected = "every position once";
    if (m_scan.tables() > 1)
        expected += dimensionalityHint(m_scan.dimensions + 1);
    for (std::size_t i = 0; i < m_duplicates.size(); ++i) {
        const std::size_t line = m_scan.rowLines.lineOf(m_duplicates[i].row);
        m_diagnostics.error(DiagnosticCode::DuplicatePoint, line, 0,
            pointText(m_duplicates[i].point) + " in line "
                + std::to_string(m_scan.rowLines.lineOf(firstRows[i])) + " and again in line "
                + std::to_string(line),
            expected);
    }
    m_diagnostics.countErrors(m_duplicateCount - m_duplicates.size());
}

void PointReader::reportMissing()
{
    // Duplicates beyond the points that are looked at are not known; there are many missing then.
    const double missing = m_pointCount - static_cast<double>(m_rows - m_duplicateCount);
    if (missing <= 0.0)
        return;
    std::string names;
    std::size_t named = 0;
    for (std::size_t point = 0; point < m_looked && named < mostNamed; ++point) {
        if (m_occupied[point])
            continue;
        names += (named == 0 ? "" : "; ") + pointText(point);
        ++named;
    }
    const bool more = missing > static_cast<double>(named);
    m_diagnostics.error(DiagnosticCode::MissingPoint, 0, 0,
        "no line for " + names + (more ? "; ..." : "") + " (missing: " + roundedText(missing)
            + " of " + roundedText(m_pointCount) + " points)",
        "every combination of the positions" + fewerDimensionsHint());
}

std::string PointReader::pointText(std::size_t point) const
{
    std::string text;
    for (std::size_t d = 0; d < m_dimensions; ++d) {
        const std::vector<double>& positions = m_grid.lines[d].positions;
        text += (d == 0 ? "" : ", ")
            + positionText(m_scan.columns[d], d, positions[point % positions.size()]);
        point /= positions.size();
    }
    return text;
}

/// A grid of fewer dimensions, when the last columns of positions follow from the ones before.
std::string PointReader::fewerDimensionsHint() const
{
    double points = 1.0;
    for (std::size_t d = 0; d + 1 < m_dimensions; ++d) {
        points *= m_sizes[d];
        if (points == static_cast<double>(m_rows))
            return dimensionalityHint(static_cast<int>(d) + 1);
    }
    return "";
}

} // namespace

std::vector<std::uint32_t> readPoints(
    const Scan& scan, const GridReading& grid, DiagnosticList& diagnostics)
{
    return PointReader(scan, grid, diagnostics).read();
}

} // namespace axiscomp::csv
