// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/grid_reader.h"

#include "core/csv/header.h"
#include "core/table/even_spacing.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace axiscomp::csv {

namespace {

constexpr double sameLine = 1e-9; ///< of the range

/// snap: how far a position may be off its line; closer than twice that is the same one. 0: only
/// what is the same but for rounding.
GridLines gridLines(const std::vector<double>& values, double snap)
{
    std::vector<std::uint32_t> order(values.size());
    std::iota(order.begin(), order.end(), 0U);
    const auto value = [&values](std::uint32_t id) { return values[id]; };
    if (!std::ranges::is_sorted(values))
        std::ranges::sort(order, {}, value);
    const long double range = static_cast<long double>(values[order.back()])
        - static_cast<long double>(values[order.front()]);
    const long double closest =
        std::max(static_cast<long double>(sameLine) * range, 2.0L * static_cast<long double>(snap));
    GridLines lines;
    lines.lineOf.resize(values.size());
    double before = 0.0;
    for (const std::uint32_t id : order) {
        const double next = values[id] + 0.0; // no negative zero
        const long double gap = static_cast<long double>(next) - static_cast<long double>(before);
        if (lines.positions.empty() || (gap > 0.0L && gap >= closest)) {
            lines.positions.push_back(next);
            lines.reach.push_back(next);
        }
        lines.lineOf[id] = static_cast<std::uint32_t>(lines.positions.size() - 1);
        if (snap > 0.0) {
            before = lines.reach.back() = next;
        } else {
            before = lines.positions.back();
        }
    }
    for (std::size_t i = 0; i < lines.positions.size(); ++i) {
        const double last = lines.reach[i];
        lines.reach[i] = 0.5 * (last - lines.positions[i]);
        lines.positions[i] += lines.reach[i];
    }
    return lines;
}

/// How far the positions are off an even line, measured ones on both sides of a grid line included.
EvenSpacing held(const GridLines& lines, double start, double distance)
{
    std::vector<double> even(lines.positions.size());
    for (std::size_t i = 0; i < even.size(); ++i)
        even[i] = start + static_cast<double>(i) * distance;
    EvenSpacing spacing = fitEvenSpacing(even, noDecimals);
    spacing.deviation = 0.0;
    for (std::size_t i = 0; i < even.size(); ++i) {
        const double shift = std::fabs(lines.positions[i] - even[i]) + lines.reach[i];
        if (shift > spacing.deviation) {
            spacing.deviation = shift;
            spacing.worst = i;
        }
    }
    return spacing;
}

/// An even line that keeps within the tolerance of all positions: by the roundest numbers, or else
/// the least-squares line.
std::optional<EvenSpacing> spacingWithin(const GridLines& lines, double tolerance)
{
    const double limit = tolerance * (1.0 + 1e-9);
    const double range = lines.positions.back() - lines.positions.front();
    const auto steps = static_cast<double>(lines.positions.size() - 1);
    constexpr int digits = 12;
    const int coarsest = static_cast<int>(std::ceil(std::log10(range)));
    for (int decimal = coarsest; decimal > coarsest - digits; --decimal) {
        const double unit = std::pow(10.0, std::abs(decimal));
        const auto rounded = [&](double position) {
            return decimal > 0 ? std::round(position / unit) * unit
                               : std::round(position * unit) / unit;
        };
        const double start = rounded(lines.positions.front());
        const double distance = (rounded(lines.positions.back()) - start) / steps;
        if (!(distance > 0.0))
            continue;
        if (const EvenSpacing spacing = held(lines, start, distance);
            spacing.even && spacing.deviation <= limit)
            return spacing;
    }
    const EvenSpacing line = fitEvenSpacing(lines.positions, noDecimals);
    const EvenSpacing spacing = held(lines, line.start, line.distance);
    return spacing.even && spacing.deviation <= limit ? std::optional(spacing) : std::nullopt;
}

/// The tolerance with which positions that scatter would become a grid; 0: none does.
double suggestedSnap(const std::vector<double>& values)
{
    constexpr double mostOfGap = 0.1;
    constexpr double mostOfDistance = 0.02;
    std::vector<double> sorted = values;
    std::ranges::sort(sorted);
    double largestGap = 0.0;
    for (std::size_t i = 1; i < sorted.size(); ++i)
        largestGap = std::max(largestGap, sorted[i] - sorted[i - 1]);
    const GridLines lines = gridLines(values, 0.5 * mostOfGap * largestGap);
    if (lines.positions.size() < 3 || !std::isfinite(largestGap))
        return 0.0;
    const double distance = (lines.positions.back() - lines.positions.front())
        / static_cast<double>(lines.positions.size() - 1);
    const auto spacing = spacingWithin(lines, mostOfDistance * distance);
    if (!spacing || !(spacing->deviation > 0.0))
        return 0.0;
    const double unit = std::pow(10.0, std::floor(std::log10(spacing->deviation)));
    return std::ceil(spacing->deviation / unit * (1.0 - 1e-9)) * unit;
}

Text inSteps(double position, double distance)
{
    return AXISCOMP_TEXT("Error", "{position} (steps of {distance})")
        .with("position", Quantity{roundedText(position)})
        .with("distance", Quantity{roundedText(distance)});
}

/// The spacing of one dimension.
class AxisReader {
public:
    AxisReader(
        const Scan& scan, const GridReading& reading, std::size_t d, DiagnosticList& diagnostics)
        : m_scan(scan)
        , m_reading(reading)
        , m_dimension(d)
        , m_positions(reading.lines[d].positions)
        , m_diagnostics(diagnostics)
    {
    }

    std::optional<GridAxis> read(const CsvOptions& options);
    [[nodiscard]] std::vector<double> knots(const GridAxis& axis) const;

private:
    std::optional<GridAxis> snapped(double snap);
    void reportTooFew();
    void reportUneven(const EvenSpacing& spacing);
    void reportStep(std::size_t index, double due);
    [[nodiscard]] std::size_t fileLine(std::size_t gridLine) const;
    [[nodiscard]] Text text(double position) const
    {
        return positionText(m_scan.columns[m_dimension], m_dimension, position);
    }
    [[nodiscard]] Text withWrongDimensionHint(Text expected) const;

    const Scan& m_scan;
    const GridReading& m_reading;
    std::size_t m_dimension;
    const std::vector<double>& m_positions;
    DiagnosticList& m_diagnostics;
    bool m_isUneven = false;
};

std::vector<double> AxisReader::knots(const GridAxis& axis) const
{
    std::vector<double> knots = m_positions;
    for (std::size_t i = 0; i < knots.size() && !m_isUneven; ++i)
        knots[i] = axis.position(i);
    return knots;
}

std::optional<GridAxis> AxisReader::snapped(double snap)
{
    const GridLines& lines = m_reading.lines[m_dimension];
    const auto spacing = spacingWithin(lines, snap);
    if (!spacing)
        return std::nullopt;
    const ColumnName& column = m_scan.columns[m_dimension];
    const GridAxis axis{column.name, column.unit, spacing->start, spacing->distance,
        static_cast<std::uint32_t>(m_positions.size())};
    if (spacing->deviation > 0.0)
        m_diagnostics.warning(DiagnosticCode::SnappedPositions, fileLine(spacing->worst),
            m_dimension + 1,
            AXISCOMP_TEXT("Error",
                "{axis} is taken for {first} to {last} in steps of {distance}; "
                "the largest shift is {shift}, at {position}")
                .with("axis", columnText(column, m_dimension))
                .with("first", Quantity{roundedText(axis.start)})
                .with("last", Quantity{roundedText(axis.last()), column.unit})
                .with("distance", Quantity{roundedText(axis.distance), column.unit})
                .with("shift", Quantity{roundedText(spacing->deviation), column.unit})
                .with("position", text(axis.position(spacing->worst))),
            {});
    return axis;
}

std::optional<GridAxis> AxisReader::read(const CsvOptions& options)
{
    if (m_positions.size() < 2) {
        reportTooFew();
        return std::nullopt;
    }
    if (!std::isfinite(m_positions.back() - m_positions.front())) {
        m_diagnostics.error(DiagnosticCode::NotFinite, fileLine(m_positions.size() - 1),
            m_dimension + 1, Verbatim{toText(m_positions.back())},
            AXISCOMP_TEXT("Error", "positions with a finite range"));
        return std::nullopt;
    }
    if (options.snap > 0.0)
        if (auto axis = snapped(options.snap))
            return axis;
    const EvenSpacing spacing =
        fitEvenSpacing(m_positions, m_scan.positions[m_dimension].lastDecimal());
    const bool isMergedTooFar = std::ranges::any_of(m_reading.lines[m_dimension].reach,
        [&](double reach) { return reach > options.snap * (1.0 + 1e-9); });
    if (isMergedTooFar) {
        reportUneven(spacing);
        return std::nullopt;
    }
    const ColumnName& column = m_scan.columns[m_dimension];
    GridAxis axis{column.name, column.unit, spacing.start, spacing.distance,
        static_cast<std::uint32_t>(m_positions.size())};
    m_isUneven = !spacing.even;
    if (m_isUneven && options.acceptsUneven) {
        axis.start = m_positions.front();
        axis.distance = (m_positions.back() - m_positions.front())
            / static_cast<double>(m_positions.size() - 1);
        return axis;
    }
    if (!spacing.even) {
        reportUneven(spacing);
        return std::nullopt;
    }
    if (!(axis.distance > 0.0) || !std::isfinite(axis.last())) {
        m_diagnostics.error(DiagnosticCode::NotFinite, fileLine(0), m_dimension + 1,
            Verbatim{toText(m_positions.back())},
            AXISCOMP_TEXT("Error", "positions whose distance a double can hold"));
        return std::nullopt;
    }
    if (spacing.rounded)
        m_diagnostics.warning(DiagnosticCode::RoundedSpacing, fileLine(spacing.worst),
            m_dimension + 1, text(m_positions[spacing.worst]),
            inSteps(axis.position(spacing.worst), axis.distance));
    return axis;
}

void AxisReader::reportTooFew()
{
    m_diagnostics.error(DiagnosticCode::TooFewPoints, fileLine(0), m_dimension + 1,
        AXISCOMP_TEXT("Error", "only {position}").with("position", text(m_positions.front())),
        withDimensionalityHint(AXISCOMP_TEXT("Error", "at least 2 different positions"),
            static_cast<int>(m_dimension)));
}

/// Names the steps that are not like most, or the worst position where none stands out.
void AxisReader::reportUneven(const EvenSpacing& spacing)
{
    constexpr std::size_t mostReported = 5;
    std::vector<double> steps(m_positions.size() - 1);
    for (std::size_t i = 0; i < steps.size(); ++i)
        steps[i] = m_positions[i + 1] - m_positions[i];
    const auto middle = steps.begin() + static_cast<std::ptrdiff_t>((steps.size() - 1) / 2);
    std::ranges::nth_element(steps, middle);
    const double usual = *middle;
    std::size_t reported = 0;
    for (std::size_t i = 1; i < m_positions.size(); ++i) {
        const double due = m_positions[i - 1] + usual;
        if (std::fabs(m_positions[i] - due) <= 2.0 * spacing.tolerance)
            continue;
        if (reported < mostReported)
            reportStep(i, usual);
        else
            m_diagnostics.countErrors(1);
        ++reported;
    }
    if (reported == 0)
        m_diagnostics.error(DiagnosticCode::UnevenSpacing, fileLine(spacing.worst), m_dimension + 1,
            text(m_positions[spacing.worst]),
            withWrongDimensionHint(
                AXISCOMP_TEXT("Error", "{position} on an even line in steps of {distance}")
                    .with("position",
                        Quantity{roundedText(
                            spacing.start + static_cast<double>(spacing.worst) * spacing.distance)})
                    .with("distance", Quantity{roundedText(spacing.distance)})));
}

void AxisReader::reportStep(std::size_t index, double usual)
{
    const double before = m_positions[index - 1];
    m_diagnostics.error(DiagnosticCode::UnevenSpacing, fileLine(index), m_dimension + 1,
        AXISCOMP_TEXT("Error", "{position} next to {before}")
            .with("position", text(m_positions[index]))
            .with("before", Quantity{toText(before)}),
        withWrongDimensionHint(inSteps(before + usual, usual)));
}

std::size_t AxisReader::fileLine(std::size_t gridLine) const
{
    std::size_t found = 0;
    forEachRow(m_scan, [&](const RowStore::Block& block, std::size_t i, std::size_t row) {
        const std::size_t id = m_scan.id(block, i, row, m_dimension);
        found = row;
        return m_reading.lines[m_dimension].lineOf[id] != gridLine;
    });
    return m_scan.rowLines.lineOf(found);
}

/// Values scatter; positions repeat. A column of positions in which most rows differ is a table, if
/// it is not measured positions.
Text AxisReader::withWrongDimensionHint(Text expected) const
{
    const double snap = suggestedSnap(m_scan.positions[m_dimension].values());
    if (snap > 0.0)
        return AXISCOMP_TEXT("Error",
            "{expected}; a tolerance of {tolerance} takes them for an "
            "even grid (--snap, or Snap tolerance in the import)")
            .with("expected", std::move(expected))
            .with("tolerance", Quantity{roundedText(snap)});
    return m_positions.size() > m_scan.rows.size() / 2
        ? withDimensionalityHint(std::move(expected), static_cast<int>(m_dimension))
        : expected;
}

constexpr std::uint32_t nowhere = std::numeric_limits<std::uint32_t>::max();

class PointReader {
public:
    PointReader(const Scan& scan, const GridReading& grid, const CsvOptions& options,
        DiagnosticList& diagnostics)
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
        const double columns = static_cast<double>(scan.columns.size());
        m_mayMiss = options.missing != MissingPoints::Refuse
            && m_pointCount * columns <= static_cast<double>(options.maximumCells);
        // Enough to find the first missing points of a grid of any size, and all points of a full
        // one.
        const double enough = m_mayMiss ? m_pointCount : static_cast<double>(m_rows + mostNamed);
        m_looked = static_cast<std::size_t>(std::min(m_pointCount, enough));
    }

    std::vector<std::uint32_t> read();

private:
    void place();
    void reportDuplicates();
    void reportMissing();
    [[nodiscard]] std::vector<Text> pointText(std::size_t point) const;
    [[nodiscard]] int fewerDimensions() const;

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
    bool m_mayMiss = false; ///< points without a line are no error
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
    if (m_grid.even && !m_mayMiss)
        reportMissing();
    const bool full =
        m_duplicateCount == 0 && (m_mayMiss || m_pointCount == static_cast<double>(m_rows));
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
    Text expected = AXISCOMP_TEXT("Error", "every position once");
    if (m_scan.tables() > 1)
        expected = withDimensionalityHint(expected, m_scan.dimensions + 1);
    for (std::size_t i = 0; i < m_duplicates.size(); ++i) {
        const std::size_t line = m_scan.rowLines.lineOf(m_duplicates[i].row);
        m_diagnostics.error(DiagnosticCode::DuplicatePoint, line, 0,
            AXISCOMP_TEXT("Error", "{point} in line {first} and again in line {second}")
                .with("point", pointText(m_duplicates[i].point))
                .with("first", m_scan.rowLines.lineOf(firstRows[i]))
                .with("second", line),
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
    Argument points = Verbatim{};
    std::size_t named = 0;
    const auto name = [&](Argument point) {
        points = named++ == 0 ? std::move(point)
                              : AXISCOMP_TEXT("Error", "{first}; {next}")
                                    .with("first", points)
                                    .with("next", std::move(point));
    };
    for (std::size_t point = 0; point < m_looked && named < mostNamed; ++point)
        if (!m_occupied[point])
            name(pointText(point));
    if (missing > static_cast<double>(named))
        name(Verbatim{"..."});
    m_diagnostics.error(DiagnosticCode::MissingPoint, 0, 0,
        AXISCOMP_TEXT("Error", "no line for {points} (missing: {missing} of {all} points)")
            .with("points", std::move(points))
            .with("missing", Quantity{roundedText(missing)})
            .with("all", Quantity{roundedText(m_pointCount)}),
        fewerDimensions() > 0
            ? withDimensionalityHint(
                AXISCOMP_TEXT("Error", "every combination of the positions"), fewerDimensions())
            : Text(AXISCOMP_TEXT("Error",
                "every combination of the positions; missing points can be filled or left out "
                "(--fill, --crop, or Missing points in the import)")));
}

std::vector<Text> PointReader::pointText(std::size_t point) const
{
    std::vector<Text> text;
    for (std::size_t d = 0; d < m_dimensions; ++d) {
        const std::vector<double>& positions = m_grid.lines[d].positions;
        text.push_back(positionText(m_scan.columns[d], d, positions[point % positions.size()]));
        point /= positions.size();
    }
    return text;
}

/// Those of a grid of fewer dimensions, when the last columns of positions follow from the ones
/// before; otherwise 0.
int PointReader::fewerDimensions() const
{
    double points = 1.0;
    for (std::size_t d = 0; d + 1 < m_dimensions; ++d) {
        points *= m_sizes[d];
        if (points == static_cast<double>(m_rows))
            return static_cast<int>(d) + 1;
    }
    return 0;
}

} // namespace

Text positionText(const ColumnName& column, std::size_t dimension, double position)
{
    const Quantity quantity{toText(position), column.unit};
    if (column.name.empty())
        return AXISCOMP_TEXT("Error", "position {number} = {position}")
            .with("number", dimension + 1)
            .with("position", quantity);
    return AXISCOMP_TEXT("Error", "{axis} = {position}")
        .with("axis", column.name)
        .with("position", quantity);
}

Text columnText(const ColumnName& column, std::size_t dimension)
{
    return column.name.empty()
        ? AXISCOMP_TEXT("Error", "position {number}").with("number", dimension + 1)
        : Text(Verbatim{column.name});
}

GridReading readGrid(const Scan& scan, const CsvOptions& options, DiagnosticList& diagnostics)
{
    GridReading reading;
    for (const PositionColumn& column : scan.positions)
        reading.lines.push_back(gridLines(column.values(), options.snap));
    reading.even = true;
    for (std::size_t d = 0; d < scan.positions.size(); ++d) {
        AxisReader reader(scan, reading, d, diagnostics);
        const std::optional<GridAxis> axis = reader.read(options);
        reading.even = reading.even && axis;
        if (axis && options.acceptsUneven)
            reading.knots.push_back(reader.knots(*axis));
        reading.grid.axes.push_back(axis.value_or(GridAxis{}));
    }
    return reading;
}

std::vector<std::uint32_t> readPoints(const Scan& scan, const GridReading& grid,
    const CsvOptions& options, DiagnosticList& diagnostics)
{
    return PointReader(scan, grid, options, diagnostics).read();
}

} // namespace axiscomp::csv
