// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/conversion_errors.h"
#include "core/conversion/sign_conversion.h"
#include "core/neutral/table_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

namespace axiscomp {

namespace {

/// From the unit of one table's axis to that of the other.
using AxisFactors = std::array<double, 3>;

struct ColumnPair {
    std::size_t a = 0;
    std::size_t b = 0;
    double factor = 1.0; ///< from the unit of b's column to that of a's
};

bool sharesDirection(Direction a, Direction b)
{
    return a == b || a == Direction::Both || b == Direction::Both;
}

bool haveSameTarget(const NeutralTable& a, const CompensationColumn& columnA, const NeutralTable& b,
    const CompensationColumn& columnB)
{
    const auto targetA = targetOf(a, columnA);
    return targetA && targetA == targetOf(b, columnB)
        && (targetA->source || targetName(a, columnA) == targetName(b, columnB));
}

/// The columns that correct an axis that is no source, in their order.
std::vector<std::size_t> crossColumns(const NeutralTable& table)
{
    std::vector<std::size_t> columns;
    for (std::size_t n = 0; n < table.columns.size(); ++n) {
        const auto target = targetOf(table, table.columns[n]);
        if (target && !target->source)
            columns.push_back(n);
    }
    return columns;
}

/// Formats have their own names for axes: "Z" may have become "3".
std::optional<std::size_t> sameCrossColumn(
    const NeutralTable& a, std::size_t column, const NeutralTable& b)
{
    const std::vector<std::size_t> ofA = crossColumns(a);
    const std::vector<std::size_t> ofB = crossColumns(b);
    const auto found = std::ranges::find(ofA, column);
    if (found == ofA.end() || ofA.size() != ofB.size())
        return std::nullopt;
    const std::size_t other = ofB[static_cast<std::size_t>(found - ofA.begin())];
    return sharesDirection(a.columns[column].direction, b.columns[other].direction)
        ? std::optional(other)
        : std::nullopt;
}

Result<std::vector<ColumnPair>> pairsOf(const NeutralTable& a, const NeutralTable& b)
{
    std::vector<ColumnPair> pairs;
    for (std::size_t i = 0; i < a.columns.size(); ++i) {
        const CompensationColumn& column = a.columns[i];
        const std::size_t before = pairs.size();
        for (std::size_t j = 0; j < b.columns.size(); ++j)
            if (haveSameTarget(a, column, b, b.columns[j])
                && sharesDirection(b.columns[j].direction, column.direction))
                pairs.push_back({i, j});
        const bool isByOrder = a.columns.size() == b.columns.size()
            || (!targetOf(a, column) && a.columns.size() < b.columns.size());
        if (const auto cross = sameCrossColumn(a, i, b); cross && pairs.size() == before)
            pairs.push_back({i, *cross});
        if (pairs.size() == before && isByOrder)
            pairs.push_back({i, i});
        if (pairs.size() == before)
            return invalidArgument(
                AXISCOMP_TEXT("Error", "the second table has no column for {column}")
                    .with("column", columnText(a, column)));
    }
    for (ColumnPair& pair : pairs) {
        const CompensationColumn& column = a.columns[pair.a];
        AXISCOMP_TRY(const auto factor,
            factorBetween(b.columns[pair.b].unit, column.unit,
                AXISCOMP_TEXT("Error", "values for {column}")
                    .with("column", columnText(a, column))));
        pair.factor = factor;
    }
    return pairs;
}

/// x in another unit; an end of the axis stays one, whatever rounding makes of it.
double convertedTo(const SourceAxis& axis, double x, double factor)
{
    const double converted = x * factor;
    const double first = axis.knots.front();
    const double last = axis.knots.back();
    const double rounding =
        16.0 * std::numeric_limits<double>::epsilon() * (std::abs(first) + std::abs(last));
    for (const double end : {first, last})
        if (std::abs(converted - end) <= rounding)
            return end;
    return converted;
}

/// One of the two tables, with what moves its places.
struct Side {
    const NeutralTable& table;
    const TableBehaviour& behaviour;
    AxisFactors factors; ///< from a's unit

    [[nodiscard]] Position positionOf(const Position& x) const
    {
        Position converted{};
        for (std::size_t n = 0; n < table.axes.size(); ++n)
            converted[n] = convertedTo(table.axes[n], x[n], factors[n]);
        return converted;
    }
    [[nodiscard]] std::span<const double> used(const Position& position) const
    {
        return std::span(position).first(table.axes.size());
    }
    [[nodiscard]] bool contains(const Position& position) const
    {
        for (std::size_t n = 0; n < table.axes.size(); ++n) {
            const SourceAxis& axis = table.axes[n];
            if (!axis.wrap
                && !(position[n] >= axis.knots.front() && position[n] <= axis.knots.back()))
                return false;
        }
        return true;
    }
};

/// The positions along one axis that are looked at, in a's unit.
class AxisPositions {
public:
    AxisPositions(const SourceAxis& a, const SourceAxis& b, double fromA)
    {
        add(a, 1.0);
        add(b, 1.0 / fromA);
        if (a.wrap || b.wrap)
            m_wrap = a.wrap ? *a.wrap : *b.wrap / fromA;
    }

    void addKnot(double position) { m_positions.push_back(position); }

    /// Ascending, but for the further turns of a modulo axis, which follow.
    [[nodiscard]] std::vector<double> all(bool withMiddles) const
    {
        std::vector<double> sorted = m_positions;
        std::ranges::sort(sorted);
        sorted.erase(std::unique(sorted.begin(), sorted.end()), sorted.end());
        std::vector<double> dense;
        for (std::size_t i = 0; i < sorted.size(); ++i) {
            if (i > 0 && withMiddles)
                dense.push_back(std::midpoint(sorted[i - 1], sorted[i]));
            dense.push_back(sorted[i]);
        }
        const std::size_t turn = dense.size();
        for (std::size_t i = 0; i < turn && m_wrap > 0.0; ++i) {
            dense.push_back(dense[i] - m_wrap);
            dense.push_back(dense[i] + m_wrap);
        }
        return dense;
    }

private:
    void add(const SourceAxis& axis, double factor)
    {
        constexpr double little = 0.01;
        const std::vector<double>& knots = axis.knots;
        for (const double knot : knots)
            m_positions.push_back(knot * factor);
        const double firstCell = knots[1] - knots[0];
        const double lastCell = knots.back() - knots[knots.size() - 2];
        for (const double cells : {little, 1.0}) {
            m_positions.push_back((knots.front() - cells * firstCell) * factor);
            m_positions.push_back((knots.back() + cells * lastCell) * factor);
        }
    }

    std::vector<double> m_positions;
    double m_wrap = 0.0;
};

/// The positions of each axis.
using AxisLists = std::vector<std::vector<double>>;

/// All combinations of the positions of all axes but one.
template <typename Visit> void forEachLine(const AxisLists& axes, std::size_t along, Visit visit)
{
    std::size_t count = 1;
    for (std::size_t n = 0; n < axes.size(); ++n)
        count *= n == along ? 1 : axes[n].size();
    for (std::size_t index = 0; index < count; ++index) {
        Position x{};
        std::size_t rest = index;
        for (std::size_t n = 0; n < axes.size(); ++n) {
            if (n == along)
                continue;
            x[n] = axes[n][rest % axes[n].size()];
            rest /= axes[n].size();
        }
        visit(x);
    }
}

/// Evenly chosen, the first and the last among them.
std::vector<double> thinned(const std::vector<double>& positions, std::size_t count)
{
    std::vector<double> kept;
    for (std::size_t i = 0; i < count; ++i)
        kept.push_back(positions[i * (positions.size() - 1) / (count - 1)]);
    return kept;
}

class Comparison {
public:
    Comparison(const Side& a, const Side& b) : m_a(a), m_b(b) { }

    [[nodiscard]] Result<void> prepare();
    [[nodiscard]] Result<ConversionDifference> run(std::size_t mostPositions);

private:
    [[nodiscard]] bool isMixed() const { return m_a.table.sign != m_b.table.sign; }
    [[nodiscard]] const Side& command() const
    {
        return m_a.table.sign == SignConvention::Command ? m_a : m_b;
    }
    [[nodiscard]] const Side& feedback() const { return &command() == &m_a ? m_b : m_a; }
    /// The own axes of a side's columns, as a states them, or else b.
    [[nodiscard]] OwnAxes rolesOf(const Side& side) const;
    [[nodiscard]] Result<Motion> motionOf(const Side& side, Direction direction) const;
    /// The axis that a column moves, where it is only one.
    [[nodiscard]] Result<std::optional<std::size_t>> movedAxis(Direction direction) const;
    /// Where x + c(x) meets the knots of the feedback table, on a line along the axis that moves.
    [[nodiscard]] std::vector<double> metKnots(
        const Position& line, std::size_t axis, const Motion& motion) const;
    [[nodiscard]] AxisLists positions(ConversionDifference& result, std::size_t most) const;
    /// Where each table is looked up for a position x, and whether both have values there.
    struct Places {
        Position a;
        Position b;
        bool isInside = false;
    };
    [[nodiscard]] Places placesOf(const Position& x, const Motion& motion) const;
    [[nodiscard]] Result<ColumnDifference> compare(
        const ColumnPair& pair, const AxisLists& axes, std::size_t& positions) const;

    Side m_a;
    Side m_b;
    std::vector<ColumnPair> m_pairs;
};

Result<void> Comparison::prepare()
{
    const NeutralTable& a = m_a.table;
    const NeutralTable& b = m_b.table;
    for (const NeutralTable* table : {&a, &b})
        if (auto fine = checkConsistent(*table); !fine)
            return fine;
    if (a.axes.size() != b.axes.size())
        return invalidArgument(AXISCOMP_TEXT(
            "Error", "a table of {count} source axes cannot be compared with one of {other}")
                                   .with("count", a.axes.size())
                                   .with("other", b.axes.size()));
    for (std::size_t n = 0; n < a.axes.size(); ++n) {
        AXISCOMP_TRY(const auto factor,
            factorBetween(a.axes[n].unit, b.axes[n].unit,
                AXISCOMP_TEXT("Error", "positions of {axis}").with("axis", axisText(a, n))));
        m_a.factors[n] = 1.0;
        m_b.factors[n] = factor;
    }
    AXISCOMP_TRY(auto pairs, pairsOf(a, b));
    m_pairs = std::move(pairs);
    return {};
}

OwnAxes Comparison::rolesOf(const Side& side) const
{
    const OwnAxes ofA = ownAxesOf(m_a.table);
    const OwnAxes ofB = ownAxesOf(m_b.table);
    OwnAxes roles = ownAxesOf(side.table);
    for (const ColumnPair& pair : m_pairs) {
        const bool isStated = targetOf(m_a.table, m_a.table.columns[pair.a]).has_value();
        roles[&side == &m_a ? pair.a : pair.b] = isStated ? ofA[pair.a] : ofB[pair.b];
    }
    return roles;
}

Result<Motion> Comparison::motionOf(const Side& side, Direction direction) const
{
    if (!isMixed())
        return Motion(side.table, side.behaviour, {});
    AXISCOMP_TRY(const auto movers, moversOf(side.table, rolesOf(side), direction));
    return Motion(side.table, side.behaviour, movers);
}

Result<std::optional<std::size_t>> Comparison::movedAxis(Direction direction) const
{
    if (!isMixed())
        return std::nullopt;
    AXISCOMP_TRY(const auto movers, moversOf(command().table, rolesOf(command()), direction));
    return movers.size() == 1 ? std::optional(movers.front().axis) : std::nullopt;
}

std::vector<double> Comparison::metKnots(
    const Position& line, std::size_t axis, const Motion& motion) const
{
    const SourceAxis& moved = command().table.axes[axis];
    const double toFeedback = feedback().factors[axis] / command().factors[axis];
    Position x = line;
    std::vector<double> places = moved.knots;
    if (moved.wrap && !isFullTurn(moved))
        places.push_back(places.front() + *moved.wrap);
    std::vector<double> sums;
    for (const double place : places) {
        x[axis] = place / command().factors[axis];
        sums.push_back(place + motion.offset(command().used(command().positionOf(x)))[axis]);
    }
    const bool goesOn = command().behaviour.outside == Outside::Extrapolate && !moved.wrap;
    std::vector<double> met;
    const auto add = [&](double knot) {
        const auto after = std::ranges::upper_bound(sums, knot);
        const auto i = static_cast<std::size_t>(after - sums.begin());
        double place = 0.0;
        const std::size_t cell = std::clamp<std::size_t>(i, 1, sums.size() - 1);
        if ((i == 0 || i == sums.size()) && goesOn)
            place = std::lerp(places[cell - 1], places[cell],
                (knot - sums[cell - 1]) / (sums[cell] - sums[cell - 1]));
        else if (i == 0 || i == sums.size()) // the ends are held, or nothing is applied
            place = knot - (i == 0 ? sums.front() - places.front() : sums.back() - places.back());
        else
            place =
                std::lerp(places[i - 1], places[i], (knot - sums[i - 1]) / (sums[i] - sums[i - 1]));
        met.push_back(place / command().factors[axis]);
    };
    for (const double knot : feedback().table.axes[axis].knots) {
        add(knot / toFeedback);
        if (moved.wrap) {
            add(knot / toFeedback - *moved.wrap);
            add(knot / toFeedback + *moved.wrap);
        }
    }
    return met;
}

AxisLists Comparison::positions(ConversionDifference& result, std::size_t most) const
{
    AxisLists axes;
    double count = 1.0;
    const bool withMiddles = isMixed() && m_a.table.axes.size() > 1;
    for (std::size_t n = 0; n < m_a.table.axes.size(); ++n) {
        axes.push_back(
            AxisPositions(m_a.table.axes[n], m_b.table.axes[n], m_b.factors[n]).all(withMiddles));
        count *= static_cast<double>(axes.back().size());
    }
    // From the shortest axis to the longest, so that what one does not use is left to the others.
    std::vector<std::vector<double>*> byLength;
    for (std::vector<double>& axis : axes)
        byLength.push_back(&axis);
    std::ranges::sort(byLength, {}, [](const auto* axis) { return axis->size(); });
    double left = static_cast<double>(std::max<std::size_t>(most, 8));
    result.isThinned = count > left;
    for (std::size_t n = 0; n < byLength.size(); ++n) {
        const double share = std::pow(left, 1.0 / static_cast<double>(byLength.size() - n));
        const auto allowed = std::max<std::size_t>(2, static_cast<std::size_t>(share + 1e-9));
        if (byLength[n]->size() > allowed)
            *byLength[n] = thinned(*byLength[n], allowed);
        left /= static_cast<double>(byLength[n]->size());
    }
    return axes;
}

Comparison::Places Comparison::placesOf(const Position& x, const Motion& motion) const
{
    Places places{x, m_b.positionOf(x), false};
    places.isInside = m_a.contains(places.a) && m_b.contains(places.b);
    if (!isMixed())
        return places;
    // the feedback table is looked up where the encoder is moved to
    const bool isCommandA = &command() == &m_a;
    const Position offset = motion.offset(command().used(isCommandA ? places.a : places.b));
    Position moved = x;
    for (std::size_t n = 0; n < m_a.table.axes.size(); ++n)
        moved[n] += offset[n] / command().factors[n];
    (isCommandA ? places.b : places.a) = feedback().positionOf(moved);
    places.isInside = places.isInside && m_a.contains(places.a) && m_b.contains(places.b);
    return places;
}

Result<ColumnDifference> Comparison::compare(
    const ColumnPair& pair, const AxisLists& axes, std::size_t& positions) const
{
    const Direction direction = m_a.table.columns[pair.a].direction == Direction::Both
        ? m_b.table.columns[pair.b].direction
        : m_a.table.columns[pair.a].direction;
    AXISCOMP_TRY(const auto motion, motionOf(command(), direction));
    AXISCOMP_TRY(const auto moved, movedAxis(direction));
    const ControllerLookup a(m_a.table, pair.a, m_a.behaviour);
    const ControllerLookup b(m_b.table, pair.b, m_b.behaviour);
    const double factor = isMixed() ? pair.factor : -pair.factor;
    ColumnDifference result{pair.a, pair.b, 0.0, {}, 0.0, {}};
    const auto look = [&](const Position& x) {
        const Places places = placesOf(x, motion);
        const double size = std::abs(a.at(m_a.used(places.a)) + factor * b.at(m_b.used(places.b)));
        const auto end = x.begin() + static_cast<std::ptrdiff_t>(axes.size());
        if (size > result.largest) {
            result.largest = size;
            result.where.assign(x.begin(), end);
        }
        if (places.isInside && size > result.largestInside) {
            result.largestInside = size;
            result.whereInside.assign(x.begin(), end);
        }
    };
    const std::size_t along = moved.value_or(0);
    positions = 0;
    forEachLine(axes, along, [&](Position x) {
        std::vector<double> met;
        if (moved)
            met = metKnots(x, along, motion);
        for (const std::vector<double>* list : {&axes[along], &std::as_const(met)})
            for (const double position : *list) {
                x[along] = position;
                look(x);
                ++positions;
            }
    });
    return result;
}

Result<ConversionDifference> Comparison::run(std::size_t mostPositions)
{
    ConversionDifference result;
    const AxisLists axes = positions(result, mostPositions);
    for (const ColumnPair& pair : m_pairs) {
        std::size_t count = 0;
        AXISCOMP_TRY(auto difference, compare(pair, axes, count));
        result.positions = std::max(result.positions, count);
        result.columns.push_back(std::move(difference));
    }
    return result;
}

} // namespace

Result<ConversionDifference> conversionDifference(const NeutralTable& a,
    const TableBehaviour& behaviourA, const NeutralTable& b, const TableBehaviour& behaviourB,
    std::size_t mostPositions)
{
    Comparison comparison({a, behaviourA, {}}, {b, behaviourB, {}});
    AXISCOMP_CHECK(comparison.prepare());
    return comparison.run(mostPositions);
}

} // namespace axiscomp
