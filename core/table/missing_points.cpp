// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/missing_points.h"

#include "core/table/grid_filling.h"
#include "core/text/number_text.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace axiscomp {

namespace {

using Index = std::array<std::size_t, 3>;

struct Box {
    Index first{};
    Index size{};
    [[nodiscard]] std::size_t points() const { return size[0] * size[1] * size[2]; }
};

/// The largest box of points that all have a value, and at least two of them in each dimension.
class BoxSearch {
public:
    BoxSearch(const Index& size, std::size_t dimensions, const std::vector<bool>& isMissing)
        : m_size(size)
        , m_isMissing(isMissing)
    {
        for (std::size_t d = 0; d < dimensions; ++d)
            m_least[d] = 2;
    }

    [[nodiscard]] std::optional<Box> run();

private:
    void searchLayers(std::size_t first);
    void searchRow(std::size_t row, std::size_t firstLayer, std::size_t layers);
    void consider(const Box& box);

    Index m_size;
    const std::vector<bool>& m_isMissing;
    Index m_least{1, 1, 1};
    std::vector<bool> m_isFull; ///< of the layers looked at, each place: in all of them
    std::vector<std::size_t> m_height; ///< how many full rows end at each place of a row
    Box m_best;
};

std::optional<Box> BoxSearch::run()
{
    for (std::size_t first = 0; first < m_size[2]; ++first)
        if (m_size[0] * m_size[1] * (m_size[2] - first) > m_best.points())
            searchLayers(first);
    return m_best.points() > 0 ? std::optional(m_best) : std::nullopt;
}

void BoxSearch::searchLayers(std::size_t first)
{
    const std::size_t area = m_size[0] * m_size[1];
    m_isFull.assign(area, true);
    for (std::size_t layer = first; layer < m_size[2]; ++layer) {
        std::size_t full = 0;
        for (std::size_t place = 0; place < area; ++place) {
            m_isFull[place] = m_isFull[place] && !m_isMissing[layer * area + place];
            full += m_isFull[place] ? 1 : 0;
        }
        if (full * (m_size[2] - first) <= m_best.points())
            return; // further layers leave fewer places
        m_height.assign(m_size[0], 0);
        for (std::size_t row = 0; row < m_size[1]; ++row)
            searchRow(row, first, layer - first + 1);
    }
}

/// All boxes that cannot be widened and whose last row this is, by the heights before it.
void BoxSearch::searchRow(std::size_t row, std::size_t firstLayer, std::size_t layers)
{
    struct Step {
        std::size_t place;
        std::size_t height;
    };
    std::vector<Step> steps;
    for (std::size_t place = 0; place <= m_size[0]; ++place) {
        std::size_t height = 0;
        if (place < m_size[0])
            height = m_height[place] = m_isFull[row * m_size[0] + place] ? m_height[place] + 1 : 0;
        std::size_t from = place;
        while (!steps.empty() && steps.back().height >= height) {
            const Step step = steps.back();
            steps.pop_back();
            from = step.place;
            consider({{step.place, row + 1 - step.height, firstLayer},
                {place - step.place, step.height, layers}});
        }
        if (height > 0)
            steps.push_back({from, height});
    }
}

void BoxSearch::consider(const Box& box)
{
    for (std::size_t d = 0; d < box.size.size(); ++d)
        if (box.size[d] < m_least[d])
            return;
    if (box.points() > m_best.points())
        m_best = box;
}

class Completion {
public:
    Completion(IncompleteGrid& grid, DiagnosticList& diagnostics)
        : m_grid(grid)
        , m_diagnostics(diagnostics)
    {
        for (std::size_t d = 0; d < grid.knots.size(); ++d)
            m_size[d] = grid.knots[d].size();
    }

    [[nodiscard]] std::optional<CompletedGrid> crop();
    [[nodiscard]] std::optional<CompletedGrid> fill(MissingPoints choice);

private:
    [[nodiscard]] bool fillTable(std::size_t table, MissingPoints choice);
    [[nodiscard]] GridCoordinates coordinates() const;
    void warnOfFilled(std::size_t table, const std::vector<std::uint32_t>& filled);
    void warnOfCrop(const Box& box, std::size_t missing);
    void refuse(Text found, Text expected)
    {
        m_diagnostics.error(
            DiagnosticCode::MissingPoint, 0, 0, std::move(found), std::move(expected));
    }
    [[nodiscard]] std::size_t points() const { return m_size[0] * m_size[1] * m_size[2]; }

    IncompleteGrid& m_grid;
    DiagnosticList& m_diagnostics;
    Index m_size{1, 1, 1};
};

std::optional<CompletedGrid> Completion::crop()
{
    std::vector<bool> isMissing(points());
    for (const std::vector<double>& table : m_grid.tables)
        for (std::size_t point = 0; point < table.size(); ++point)
            isMissing[point] = isMissing[point] || std::isnan(table[point]);
    const auto box = BoxSearch(m_size, m_grid.knots.size(), isMissing).run();
    if (!box) {
        refuse(AXISCOMP_TEXT("Error", "no 2 neighbouring points in every dimension with a value"),
            AXISCOMP_TEXT("Error", "a part of the grid that is complete; fill the points instead"));
        return std::nullopt;
    }
    CompletedGrid result;
    result.first = box->first;
    for (std::size_t d = 0; d < m_grid.knots.size(); ++d) {
        const auto from = m_grid.knots[d].begin() + static_cast<std::ptrdiff_t>(box->first[d]);
        result.knots.emplace_back(from, from + static_cast<std::ptrdiff_t>(box->size[d]));
    }
    for (const std::vector<double>& table : m_grid.tables) {
        std::vector<double>& kept = result.tables.emplace_back();
        kept.reserve(box->points());
        for (std::size_t k = 0; k < box->size[2]; ++k)
            for (std::size_t j = 0; j < box->size[1]; ++j) {
                const std::size_t row = (box->first[2] + k) * m_size[1] + box->first[1] + j;
                const auto from =
                    table.begin() + static_cast<std::ptrdiff_t>(row * m_size[0] + box->first[0]);
                kept.insert(kept.end(), from, from + static_cast<std::ptrdiff_t>(box->size[0]));
            }
    }
    result.filled.resize(m_grid.tables.size());
    warnOfCrop(*box, static_cast<std::size_t>(std::ranges::count(isMissing, true)));
    return result;
}

void Completion::warnOfCrop(const Box& box, std::size_t missing)
{
    std::vector<Text> ranges;
    for (std::size_t d = 0; d < m_grid.knots.size(); ++d)
        ranges.push_back(
            AXISCOMP_TEXT("Error", "{axis} from {first} to {last}")
                .with("axis", m_grid.names[d])
                .with("first", Quantity{roundedText(m_grid.knots[d][box.first[d]])})
                .with("last",
                    Quantity{roundedText(m_grid.knots[d][box.first[d] + box.size[d] - 1]),
                        m_grid.units[d]}));
    m_diagnostics.warning(DiagnosticCode::CroppedGrid, 0, 0,
        AXISCOMP_TEXT("Error",
            "{missing} of {all} points without a value; kept are {kept} points, "
            "{ranges}")
            .with("missing", missing)
            .with("all", points())
            .with("kept", box.points())
            .with("ranges", std::move(ranges)),
        {});
}

/// Comparable in all dimensions: as they are in the same unit, else in mean grid spacings.
GridCoordinates Completion::coordinates() const
{
    const auto spacing = [](const std::vector<double>& knots) {
        return (knots.back() - knots.front()) / static_cast<double>(knots.size() - 1);
    };
    const bool isOneUnit = std::ranges::all_of(
        m_grid.units, [&](const std::string& unit) { return unit == m_grid.units.front(); });
    GridCoordinates coordinates = m_grid.knots;
    for (std::vector<double>& places : coordinates) {
        const double scale = spacing(isOneUnit ? m_grid.knots.front() : places);
        const double first = places.front();
        for (double& place : places)
            place = (place - first) / scale;
    }
    return coordinates;
}

bool Completion::fillTable(std::size_t table, MissingPoints choice)
{
    std::vector<double>& values = m_grid.tables[table];
    const auto missing = static_cast<std::size_t>(
        std::ranges::count_if(values, [](double value) { return std::isnan(value); }));
    const std::size_t most = mostSmoothPoints(m_grid.knots.size());
    if (missing == values.size()) {
        refuse(AXISCOMP_TEXT("Error", "no value at all in {table}")
                   .with("table", m_grid.tableNames[table]),
            AXISCOMP_TEXT("Error", "a column with values"));
        return false;
    }
    if (choice == MissingPoints::Smooth && missing > most) {
        refuse(AXISCOMP_TEXT("Error", "{count} points without a value").with("count", missing),
            AXISCOMP_TEXT(
                "Error", "at most {most} for a smooth filling; choose the nearest point or a plane")
                .with("most", most));
        return false;
    }
    bool isFilled = true;
    if (choice == MissingPoints::Nearest)
        fillNearest(coordinates(), values);
    else if (choice == MissingPoints::Plane)
        isFilled = fillPlane(coordinates(), values);
    else
        isFilled = fillSmooth(coordinates(), values);
    if (!isFilled)
        refuse(AXISCOMP_TEXT("Error", "measured points of {table} on one line only")
                   .with("table", m_grid.tableNames[table]),
            AXISCOMP_TEXT(
                "Error", "points that determine a plane; choose the nearest point instead"));
    return isFilled;
}

std::optional<CompletedGrid> Completion::fill(MissingPoints choice)
{
    CompletedGrid result;
    for (std::size_t table = 0; table < m_grid.tables.size(); ++table) {
        std::vector<std::uint32_t>& filled = result.filled.emplace_back();
        for (std::size_t point = 0; point < points(); ++point)
            if (std::isnan(m_grid.tables[table][point]))
                filled.push_back(static_cast<std::uint32_t>(point));
        if (filled.empty())
            continue;
        if (!fillTable(table, choice))
            return std::nullopt;
        warnOfFilled(table, filled);
    }
    result.knots = std::move(m_grid.knots);
    result.tables = std::move(m_grid.tables);
    return result;
}

/// What was made up is held against what was measured: an extrapolation can run away.
void Completion::warnOfFilled(std::size_t table, const std::vector<std::uint32_t>& filled)
{
    const std::vector<double>& values = m_grid.tables[table];
    struct Range {
        double low = std::numeric_limits<double>::infinity();
        double high = -std::numeric_limits<double>::infinity();
        void add(double value)
        {
            low = std::min(low, value);
            high = std::max(high, value);
        }
    };
    Range made;
    Range measured;
    auto next = filled.begin();
    for (std::size_t point = 0; point < values.size(); ++point) {
        const bool isMade = next != filled.end() && *next == point;
        (isMade ? made : measured).add(values[point]);
        next += isMade ? 1 : 0;
    }
    const auto text = [&unit = m_grid.valueUnits[table]](const Range& range) {
        return AXISCOMP_TEXT("Error", "{low} to {high}")
            .with("low", Quantity{shortestText(static_cast<float>(range.low))})
            .with("high", Quantity{shortestText(static_cast<float>(range.high)), unit});
    };
    m_diagnostics.warning(DiagnosticCode::FilledPoints, 0, 0,
        AXISCOMP_TEXT("Error",
            "{count} of {all} points of {table} without a value; they get "
            "{made}, the measured values are {measured}")
            .with("count", filled.size())
            .with("all", values.size())
            .with("table", m_grid.tableNames[table])
            .with("made", text(made))
            .with("measured", text(measured)),
        {});
}

} // namespace

std::string filledNote(std::string_view table, std::size_t filled, std::size_t all)
{
    return std::to_string(filled) + " of " + std::to_string(all) + " points of "
        + std::string(table) + " are filled, not measured";
}

std::optional<CompletedGrid> completeGrid(
    IncompleteGrid grid, MissingPoints choice, DiagnosticList& diagnostics)
{
    const auto hasGaps = [](const std::vector<double>& values) {
        return std::ranges::any_of(values, [](double value) { return std::isnan(value); });
    };
    if (std::ranges::none_of(grid.tables, hasGaps)) {
        CompletedGrid result{std::move(grid.knots), {}, std::move(grid.tables), {}};
        result.filled.resize(result.tables.size());
        return result;
    }
    Completion completion(grid, diagnostics);
    return choice == MissingPoints::Crop ? completion.crop() : completion.fill(choice);
}

} // namespace axiscomp
