// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/curve/curve_grid.h"

#include "core/curve/curve_errors.h"

#include <algorithm>
#include <cmath>
#include <functional>
#include <iterator>
#include <numbers>
#include <vector>

namespace axiscomp {

namespace {

constexpr int placesBetween = 8;

class EvenLines {
public:
    EvenLines(const FittedCurve& curve, double from, double to, std::size_t points)
        : m_curve(curve)
        , m_from(from)
        , m_to(to)
    {
        for (std::size_t i = 0; i < points; ++i)
            m_values.push_back(curve.at(position(i, points), m_pieces));
    }

    [[nodiscard]] double position(std::size_t i, std::size_t points) const
    {
        return i + 1 == points
            ? m_to
            : m_from + (m_to - m_from) * static_cast<double>(i) / static_cast<double>(points - 1);
    }
    [[nodiscard]] double distanceAt(double place)
    {
        const auto cells = static_cast<double>(m_values.size() - 1);
        const double number = (place - m_from) / (m_to - m_from) * cells;
        const double cell = std::clamp(std::floor(number), 0.0, cells - 1.0);
        const auto i = static_cast<std::size_t>(cell);
        const double fraction = std::clamp(number - cell, 0.0, 1.0);
        const double line = m_values[i] + fraction * (m_values[i + 1] - m_values[i]);
        return std::abs(line - m_curve.at(place, m_pieces));
    }
    /// Calls visit for every place that counts until it answers false.
    void visitPlaces(const std::function<bool(double)>& visit) const;
    [[nodiscard]] double peakBetween(double low, double high);
    [[nodiscard]] double largestSlopeChange() const;

private:
    const FittedCurve& m_curve;
    double m_from;
    double m_to;
    std::vector<double> m_values;
    FittedCurve::Pieces m_pieces; // where the place before was
};

void EvenLines::visitPlaces(const std::function<bool(double)>& visit) const
{
    std::vector<double> knots;
    for (std::size_t i = 0; i < m_values.size(); ++i)
        knots.push_back(position(i, m_values.size()));
    const auto addWithin = [&](const CubicCurve& curve) {
        const auto known = std::ssize(knots);
        std::ranges::copy_if(curve.knots, std::back_inserter(knots),
            [this](double knot) { return knot > m_from && knot < m_to; });
        std::ranges::inplace_merge(knots, knots.begin() + known);
    };
    addWithin(m_curve.base);
    if (m_curve.onto)
        addWithin(*m_curve.onto);
    const double same = 1e-12 * (m_to - m_from);
    for (std::size_t i = 0; i + 1 < knots.size(); ++i) {
        const double width = knots[i + 1] - knots[i];
        if (width <= same) // a point of the table that the curve is added to
            continue;
        for (int place = 0; place <= placesBetween; ++place)
            if (!visit(knots[i] + width * place / (placesBetween + 1)))
                return;
    }
}

double EvenLines::largestSlopeChange() const
{
    const double distance = (m_to - m_from) / static_cast<double>(m_values.size() - 1);
    double largest = 0.0;
    for (std::size_t i = 1; i + 1 < m_values.size(); ++i)
        largest = std::max(
            largest, std::abs(m_values[i + 1] - 2.0 * m_values[i] + m_values[i - 1]) / distance);
    return largest;
}

/// The place of the largest distance between two places beside it (golden section).
double EvenLines::peakBetween(double low, double high)
{
    constexpr double share = 1.0 / std::numbers::phi;
    constexpr int steps = 40;
    for (int step = 0; step < steps; ++step) {
        const double left = high - share * (high - low);
        const double right = low + share * (high - low);
        if (distanceAt(left) >= distanceAt(right))
            high = right;
        else
            low = left;
    }
    return 0.5 * (low + high);
}

} // namespace

CurveGrid curveGrid(const FittedCurve& curve, double from, double to, std::size_t points)
{
    EvenLines lines(curve, from, to, points);
    std::vector<double> places;
    std::vector<double> distances;
    lines.visitPlaces([&](double place) {
        places.push_back(place);
        distances.push_back(lines.distanceAt(place));
        return true;
    });
    CurveGrid grid{.points = points, .distanceAt = from};
    // between its neighbours a place can be below the peak by a few percent
    const double limit = 0.95 * *std::ranges::max_element(distances);
    for (std::size_t i = 0; i < places.size(); ++i) {
        if (distances[i] < limit)
            continue;
        const double peak = lines.peakBetween(
            i == 0 ? from : places[i - 1], i + 1 == places.size() ? to : places[i + 1]);
        for (const double place : {places[i], peak}) {
            const double distance = lines.distanceAt(place);
            if (distance > grid.largestDistance) {
                grid.largestDistance = distance;
                grid.distanceAt = place;
            }
        }
    }
    grid.largestSlopeChange = lines.largestSlopeChange();
    return grid;
}

Result<CurveGrid> fewestCurvePoints(const FittedCurve& curve, double from, double to, double within,
    std::size_t most, const std::string& valueUnit)
{
    if (!(std::isfinite(within) && within > 0.0))
        return badCurve(AXISCOMP_TEXT("Error", "the wanted distance must be a number above 0"));
    double worst = from; // where the last grid failed, most others fail as well
    for (std::size_t points = 2; points <= most; ++points) {
        EvenLines lines(curve, from, to, points);
        bool holds = lines.distanceAt(worst) <= within;
        if (holds)
            lines.visitPlaces([&](double place) {
                holds = lines.distanceAt(place) <= within;
                if (!holds)
                    worst = place;
                return holds;
            });
        if (!holds)
            continue;
        const CurveGrid grid = curveGrid(curve, from, to, points);
        if (grid.largestDistance <= within)
            return grid;
        worst = grid.distanceAt;
    }
    return fail(ErrorCode::ResamplingImpossible,
        {{"reason",
            AXISCOMP_TEXT("Error",
                "a distance of {distance} from the curve takes more than {count} points; with "
                "these it is {found}; allow more points or a larger distance")
                .with("distance", placeQuantity(within, valueUnit))
                .with("count", most)
                .with("found",
                    placeQuantity(curveGrid(curve, from, to, most).largestDistance, valueUnit))}});
}

} // namespace axiscomp
