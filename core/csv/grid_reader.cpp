// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/csv/grid_reader.h"

#include "core/base/parallel.h"
#include "core/csv/header.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace axiscomp::csv {

namespace {

Text inSteps(double position, double distance)
{
    return AXISCOMP_TEXT("Error", "{position} (steps of {distance})")
        .with("position", Quantity{roundedText(position)})
        .with("distance", Quantity{roundedText(distance)});
}

/// The spacing of one dimension.
class AxisReader {
public:
    AxisReader(const Scan& scan, const SortedPositions& sorted, const GridLines& lines,
        std::size_t d, DiagnosticList& diagnostics)
        : m_scan(scan)
        , m_sorted(sorted)
        , m_lines(lines)
        , m_dimension(d)
        , m_positions(lines.positions)
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
    [[nodiscard]] Text withWrongDimensionHint(Text expected);

    const Scan& m_scan;
    const SortedPositions& m_sorted;
    const GridLines& m_lines;
    std::size_t m_dimension;
    const std::vector<double>& m_positions;
    DiagnosticList& m_diagnostics;
    bool m_isUneven = false;
    std::optional<double> m_suggestedSnap; ///< once it is known
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
    const auto spacing = spacingWithin(m_lines, snap);
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
    const EvenSpacing spacing = fitEvenSpacing(m_positions, m_scan.lastDecimalOf(m_dimension));
    const bool isMergedTooFar = std::ranges::any_of(
        m_lines.reach, [&](double reach) { return reach > options.snap * (1.0 + 1e-9); });
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

/// Of the first row that lies on the grid line.
std::size_t AxisReader::fileLine(std::size_t gridLine) const
{
    // Ids follow each other as they come up in the file.
    const auto found = std::ranges::find(m_lines.lineOf, static_cast<std::uint32_t>(gridLine));
    const auto id = static_cast<std::size_t>(found - m_lines.lineOf.begin());
    return m_scan.rowLines.lineOf(m_scan.rowOf(m_dimension, id));
}

/// Values scatter; positions repeat. A column of positions in which most rows differ is a table, if
/// it is not measured positions.
Text AxisReader::withWrongDimensionHint(Text expected)
{
    if (!m_suggestedSnap)
        m_suggestedSnap = suggestedSnap(m_sorted, m_scan.dimensions > 1);
    if (*m_suggestedSnap > 0.0)
        return AXISCOMP_TEXT("Error",
            "{expected}; a tolerance of {tolerance} takes them for an "
            "even grid (--snap, or Snap tolerance in the import)")
            .with("expected", std::move(expected))
            .with("tolerance", Quantity{roundedText(*m_suggestedSnap)});
    return m_positions.size() > m_scan.rows / 2
        ? withDimensionalityHint(std::move(expected), static_cast<int>(m_dimension))
        : expected;
}

/// Whether every point of the grid occurs once, and what is to be said where it does not.
class PointCheck {
public:
    PointCheck(const Scan& scan, const GridReading& grid, const Places& places,
        const CsvOptions& options, DiagnosticList& diagnostics)
        : m_scan(scan)
        , m_grid(grid)
        , m_places(places)
        , m_diagnostics(diagnostics)
        , m_pointCount(grid.pointCount())
    {
        const double columns = static_cast<double>(scan.columns.size());
        m_mayMiss = options.missing != MissingPoints::Refuse
            && m_pointCount * columns <= static_cast<double>(options.maximumCells);
        // Enough to find the first missing points of a grid of any size.
        const double enough = m_mayMiss ? m_pointCount : static_cast<double>(scan.rows + mostNamed);
        m_looked = static_cast<std::size_t>(std::min(m_pointCount, enough));
    }

    void run();

private:
    void findDuplicates();
    void reportDuplicates();
    void reportMissing();
    [[nodiscard]] std::vector<Text> pointText(std::size_t point) const;
    [[nodiscard]] int fewerDimensions() const;

    static constexpr std::size_t mostNamed = 3; ///< missing points
    static constexpr std::size_t mostDuplicates = 20;

    struct Duplicate {
        std::size_t row;
        std::size_t point;
    };

    const Scan& m_scan;
    const GridReading& m_grid;
    const Places& m_places;
    DiagnosticList& m_diagnostics;
    double m_pointCount;
    bool m_mayMiss = false; ///< points without a line are no error
    std::size_t m_looked = 0; ///< points that are looked at, from the first
    std::vector<bool> m_occupied;
    std::vector<Duplicate> m_duplicates; ///< the first ones
    std::size_t m_duplicateCount = 0;
};

void PointCheck::run()
{
    findDuplicates();
    reportDuplicates();
    // What a grid misses is worth saying when there is a grid: not when positions scatter.
    if (m_grid.even && !m_mayMiss)
        reportMissing();
}

void PointCheck::findDuplicates()
{
    m_occupied.assign(m_looked, false);
    const auto limit = static_cast<double>(m_looked);
    for (const Piece& piece : m_scan.pieces)
        m_places.forEachBlock(
            piece, [&](std::size_t row, const RowStore::Block&, std::span<const double> places) {
                for (std::size_t i = 0; i < places.size(); ++i) {
                    if (places[i] >= limit)
                        continue;
                    const auto point = static_cast<std::size_t>(places[i]);
                    if (m_occupied[point] && m_duplicateCount++ < mostDuplicates)
                        m_duplicates.push_back({row + i, point});
                    m_occupied[point] = true;
                }
                return true;
            });
}

void PointCheck::reportDuplicates()
{
    Text expected = AXISCOMP_TEXT("Error", "every position once");
    if (m_scan.tables() > 1)
        expected = withDimensionalityHint(expected, m_scan.dimensions + 1);
    for (std::size_t i = 0; i < m_duplicates.size(); ++i) {
        const std::size_t line = m_scan.rowLines.lineOf(m_duplicates[i].row);
        m_diagnostics.error(DiagnosticCode::DuplicatePoint, line, 0,
            AXISCOMP_TEXT("Error", "{point} in line {first} and again in line {second}")
                .with("point", pointText(m_duplicates[i].point))
                .with("first",
                    m_scan.rowLines.lineOf(
                        m_places.rowOf(static_cast<double>(m_duplicates[i].point))))
                .with("second", line),
            expected);
    }
    m_diagnostics.countErrors(m_duplicateCount - m_duplicates.size());
}

void PointCheck::reportMissing()
{
    // Duplicates beyond the points that are looked at are not known; there are many missing then.
    const double missing = m_pointCount - static_cast<double>(m_scan.rows - m_duplicateCount);
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

std::vector<Text> PointCheck::pointText(std::size_t point) const
{
    std::vector<Text> text;
    for (std::size_t d = 0; d < m_grid.lines.size(); ++d) {
        const std::vector<double>& positions = m_grid.lines[d].positions;
        text.push_back(positionText(m_scan.columns[d], d, positions[point % positions.size()]));
        point /= positions.size();
    }
    return text;
}

/// Those of a grid of fewer dimensions, when the last columns of positions follow from the ones
/// before; otherwise 0.
int PointCheck::fewerDimensions() const
{
    double points = 1.0;
    for (std::size_t d = 0; d + 1 < m_grid.lines.size(); ++d) {
        points *= static_cast<double>(m_grid.lines[d].positions.size());
        if (points == static_cast<double>(m_scan.rows))
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

double GridReading::pointCount() const
{
    double count = 1.0;
    for (const GridLines& each : lines)
        count *= static_cast<double>(each.positions.size());
    return count;
}

GridReading readGrid(const Scan& scan, const CsvOptions& options, DiagnosticList& diagnostics)
{
    const auto dimensions = static_cast<std::size_t>(scan.dimensions);
    struct Dimension {
        GridLines lines;
        std::optional<GridAxis> axis;
        std::vector<double> knots;
        DiagnosticList diagnostics;
    };
    std::vector<Dimension> found(dimensions, {{}, {}, {}, DiagnosticList(diagnostics.maximum())});
    shareWork(dimensions, options.threads, [&](std::size_t d) {
        Dimension& own = found[d];
        const SortedPositions sorted(scan.positionsOf(d));
        own.lines = gridLines(sorted, options.snap);
        AxisReader reader(scan, sorted, own.lines, d, own.diagnostics);
        own.axis = reader.read(options);
        if (own.axis && options.acceptsUneven)
            own.knots = reader.knots(*own.axis);
    });
    GridReading reading;
    reading.even = true;
    for (Dimension& own : found) {
        diagnostics.append(std::move(own.diagnostics));
        reading.even = reading.even && own.axis;
        if (own.axis && options.acceptsUneven)
            reading.knots.push_back(std::move(own.knots));
        reading.grid.axes.push_back(own.axis.value_or(GridAxis{}));
        reading.lines.push_back(std::move(own.lines));
    }
    return reading;
}

void checkPoints(const Scan& scan, const GridReading& grid, const Places& places,
    const CsvOptions& options, DiagnosticList& diagnostics)
{
    PointCheck(scan, grid, places, options, diagnostics).run();
}

} // namespace axiscomp::csv
