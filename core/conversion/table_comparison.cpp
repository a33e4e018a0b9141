// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/base/parallel.h"
#include "core/base/portable_math.h"
#include "core/conversion/resampling/resampling_errors.h"
#include "core/conversion/sign_conversion.h"
#include "core/neutral/table_motion.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <optional>
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

/// Where a column stands among those of its target and direction.
struct PlaceAmongAlike {
    std::size_t number = 0;
    std::size_t count = 0; ///< how many there are
};

std::vector<PlaceAmongAlike> placesAmongAlike(const NeutralTable& table)
{
    std::vector<PlaceAmongAlike> places(table.columns.size());
    for (std::size_t n = 0; n < places.size(); ++n)
        for (std::size_t other = 0; other < places.size(); ++other) {
            const CompensationColumn& own = table.columns[n];
            const CompensationColumn& beside = table.columns[other];
            if (beside.direction != own.direction || !haveSameTarget(table, own, table, beside))
                continue;
            places[n].number += other < n ? 1 : 0;
            ++places[n].count;
        }
    return places;
}

/// Of tables beside each other, of which one is chosen later, each is compared with itself alone.
bool areOthersBeside(const PlaceAmongAlike& a, const PlaceAmongAlike& b)
{
    return a.count == b.count && a.number != b.number;
}

/// Of the first so many columns of a.
Result<std::vector<ColumnPair>> pairsOf(
    const NeutralTable& a, const NeutralTable& b, std::size_t columns)
{
    const std::vector<PlaceAmongAlike> placesInA = placesAmongAlike(a);
    const std::vector<PlaceAmongAlike> placesInB = placesAmongAlike(b);
    std::vector<ColumnPair> pairs;
    for (std::size_t i = 0; i < columns; ++i) {
        const CompensationColumn& column = a.columns[i];
        const std::size_t before = pairs.size();
        for (std::size_t j = 0; j < b.columns.size(); ++j) {
            const CompensationColumn& other = b.columns[j];
            if (haveSameTarget(a, column, b, other)
                && sharesDirection(other.direction, column.direction)
                && (other.direction != column.direction
                    || !areOthersBeside(placesInA[i], placesInB[j])))
                pairs.push_back({i, j});
        }
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
            converted[n] = placeOf(n, x[n]);
        return converted;
    }
    [[nodiscard]] std::span<const double> used(const Position& position) const
    {
        return std::span(position).first(table.axes.size());
    }
    [[nodiscard]] double placeOf(std::size_t axis, double x) const
    {
        return convertedTo(table.axes[axis], x, factors[axis]);
    }
    [[nodiscard]] bool contains(std::size_t axis, double place) const
    {
        const SourceAxis& source = table.axes[axis];
        return source.wrap || (place >= source.knots.front() && place <= source.knots.back());
    }
    [[nodiscard]] bool contains(const Position& position) const
    {
        return containsBut(table.axes.size(), position);
    }
    /// In all axes but one.
    [[nodiscard]] bool containsBut(std::size_t axis, const Position& position) const
    {
        for (std::size_t n = 0; n < table.axes.size(); ++n)
            if (n != axis && !contains(n, position[n]))
                return false;
        return true;
    }
};

/// What was found at one position: a difference, and whether both tables have values there.
struct Look {
    double size = 0.0;
    bool isInside = false;
};

/// A position along an axis, and where it lies in both tables before any correction moves it: the
/// same on all lines.
struct Unmoved {
    double x = 0.0; ///< in a's unit
    ControllerLookup::Place a;
    ControllerLookup::Place b;
    bool isInside = false;
};

/// Both tables along one line of positions, which no correction leaves.
struct LineLooks {
    ControllerLookup::Line a;
    ControllerLookup::Line b;
    double factor; ///< of b's value
    bool othersInside; ///< the positions of the other axes, in both tables
    std::optional<Motion::Line> motion; ///< of the command table; none: the same convention
    double motionFactor; ///< from a's unit to that of the motion
    bool isCommandA;
    const Side& feedback;
    const ControllerLookup& feedbackLookup;
    std::size_t along;

    /// So many are looked at beside each other, step by step: one alone would be waited for from
    /// the correction to the value.
    static constexpr std::size_t atOnce = 64;

    /// At most atOnce positions; a look for each.
    void atEach(std::span<const Unmoved> unmoved, std::span<Look> looks) const
    {
        if (!motion) {
            for (std::size_t i = 0; i < unmoved.size(); ++i)
                looks[i] = {std::abs(a.at(unmoved[i].a) + factor * b.at(unmoved[i].b)),
                    othersInside && unmoved[i].isInside};
            return;
        }
        // the feedback table is looked up where the encoder is moved to
        std::array<double, atOnce> moved;
        for (std::size_t i = 0; i < unmoved.size(); ++i) {
            const double offset = motion->offset(isCommandA ? unmoved[i].a : unmoved[i].b);
            moved[i] = feedback.placeOf(along, unmoved[i].x + offset / motionFactor);
        }
        std::array<ControllerLookup::Place, atOnce> places;
        for (std::size_t i = 0; i < unmoved.size(); ++i)
            places[i] = feedbackLookup.placeOf(along, moved[i]);
        for (std::size_t i = 0; i < unmoved.size(); ++i) {
            const double ofA = a.at(isCommandA ? unmoved[i].a : places[i]);
            const double ofB = b.at(isCommandA ? places[i] : unmoved[i].b);
            looks[i] = {std::abs(ofA + factor * ofB),
                othersInside && unmoved[i].isInside && feedback.contains(along, moved[i])};
        }
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

/// How many combinations of the positions of all axes but one there are.
std::size_t lineCount(const AxisLists& axes, std::size_t along)
{
    std::size_t count = 1;
    for (std::size_t n = 0; n < axes.size(); ++n)
        count *= n == along ? 1 : axes[n].size();
    return count;
}

/// One of them; 0 along the axis itself.
Position lineAt(const AxisLists& axes, std::size_t along, std::size_t index)
{
    Position x{};
    for (std::size_t n = 0; n < axes.size(); ++n) {
        if (n == along)
            continue;
        x[n] = axes[n][index % axes[n].size()];
        index /= axes[n].size();
    }
    return x;
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

    [[nodiscard]] Result<void> prepare(std::optional<std::size_t> columns);
    [[nodiscard]] Result<ConversionDifference> run(std::size_t mostPositions);

private:
    /// What all lines of one comparison have in common.
    struct Job {
        const ControllerLookup& a;
        const ControllerLookup& b;
        double factor; ///< of b's value
        const Motion& motion; ///< of the command table
        bool movesAcross; ///< also out of the lines
        bool movesAlong;
        const AxisLists& axes;
        std::size_t along;
        std::vector<Unmoved> positions = {}; ///< axes[along]
        /// The knots of the command table along the axis, on a modulo axis to the next turn, and
        /// where it is looked up there.
        std::vector<double> knots = {};
        std::vector<ControllerLookup::Place> knotPlaces = {};
    };
    /// What was found on some lines.
    struct Finding {
        ColumnDifference difference;
        std::size_t positions = 0;

        /// Of two that are as large, the first counts.
        void take(const Look& look, const Position& x, std::size_t dimensions);
        void append(const Finding& following);
    };

    [[nodiscard]] bool isMixed() const { return m_a.table.sign != m_b.table.sign; }
    [[nodiscard]] const Side& command() const
    {
        return m_a.table.sign == SignConvention::Command ? m_a : m_b;
    }
    [[nodiscard]] const Side& feedback() const { return &command() == &m_a ? m_b : m_a; }
    /// The own axes of a side's columns, as a states them, or else b.
    [[nodiscard]] OwnAxes rolesOf(const Side& side) const;
    [[nodiscard]] Result<Motion> motionOf(const Side& side, Direction direction) const;
    /// The axes that the command table moves.
    [[nodiscard]] Result<std::vector<std::size_t>> movedAxes(Direction direction) const;
    void findPlaces(Job& job) const;
    [[nodiscard]] Unmoved unmovedAt(const Job& job, double x) const;
    /// Where x + c(x) meets the knots of the feedback table, on a line along the axis that moves.
    [[nodiscard]] std::vector<double> metKnots(const Job& job, const Position& line) const;
    [[nodiscard]] AxisLists positions(ConversionDifference& result, std::size_t most) const;
    [[nodiscard]] Result<ColumnDifference> compare(
        const ColumnPair& pair, const AxisLists& axes, std::size_t& positions) const;
    void compareLine(const Job& job, Position x, Finding& finding) const;
    [[nodiscard]] LineLooks looksAlong(const Job& job, const Position& x) const;
    [[nodiscard]] Look lookAcross(const Job& job, const Position& x) const;

    Side m_a;
    Side m_b;
    std::vector<ColumnPair> m_pairs;
};

Result<void> Comparison::prepare(std::optional<std::size_t> columns)
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
    AXISCOMP_TRY(auto pairs, pairsOf(a, b, columns.value_or(a.columns.size())));
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

Result<std::vector<std::size_t>> Comparison::movedAxes(Direction direction) const
{
    std::vector<std::size_t> axes;
    if (!isMixed())
        return axes;
    AXISCOMP_TRY(const auto movers, moversOf(command().table, rolesOf(command()), direction));
    for (const Mover& mover : movers)
        axes.push_back(mover.axis);
    return axes;
}

void Comparison::findPlaces(Job& job) const
{
    const SourceAxis& axis = command().table.axes[job.along];
    const double factor = command().factors[job.along];
    const ControllerLookup& lookup = &command() == &m_a ? job.a : job.b;
    for (const double x : job.axes[job.along])
        job.positions.push_back(unmovedAt(job, x));
    job.knots = axis.knots;
    if (axis.wrap && !isFullTurn(axis))
        job.knots.push_back(axis.knots.front() + *axis.wrap);
    for (const double knot : job.knots)
        job.knotPlaces.push_back(
            lookup.placeOf(job.along, convertedTo(axis, knot / factor, factor)));
}

Unmoved Comparison::unmovedAt(const Job& job, double x) const
{
    const double placeB = m_b.placeOf(job.along, x);
    return {x, job.a.placeOf(job.along, x), job.b.placeOf(job.along, placeB),
        m_a.contains(job.along, x) && m_b.contains(job.along, placeB)};
}

std::vector<double> Comparison::metKnots(const Job& job, const Position& line) const
{
    const std::size_t axis = job.along;
    const SourceAxis& moved = command().table.axes[axis];
    const double toFeedback = feedback().factors[axis] / command().factors[axis];
    const std::vector<double>& places = job.knots;
    const Motion::Line moving = job.motion.along(axis, command().used(command().positionOf(line)));
    std::vector<double> sums(places.size());
    for (std::size_t i = 0; i < places.size(); ++i)
        sums[i] = places[i] + moving.offset(job.knotPlaces[i]);
    const KnotSearch search(sums);
    // Far beyond the knots of the other axes, a table that goes on may change their order.
    const bool ascends =
        std::ranges::adjacent_find(sums, std::ranges::greater_equal{}) == sums.end();
    const bool goesOn = command().behaviour.outside == Outside::Extrapolate && !moved.wrap;
    std::vector<double> met;
    const auto add = [&](double knot) {
        const std::size_t i = ascends
            ? search.firstAbove(knot)
            : static_cast<std::size_t>(std::ranges::upper_bound(sums, knot) - sums.begin());
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
        const double share = portable::pow(left, 1.0 / static_cast<double>(byLength.size() - n));
        const auto allowed = std::max<std::size_t>(2, static_cast<std::size_t>(share + 1e-9));
        if (byLength[n]->size() > allowed)
            *byLength[n] = thinned(*byLength[n], allowed);
        left /= static_cast<double>(byLength[n]->size());
    }
    return axes;
}

void Comparison::Finding::take(const Look& look, const Position& x, std::size_t dimensions)
{
    const auto end = x.begin() + static_cast<std::ptrdiff_t>(dimensions);
    if (look.size > difference.largest) {
        difference.largest = look.size;
        difference.where.assign(x.begin(), end);
    }
    if (look.isInside && look.size > difference.largestInside) {
        difference.largestInside = look.size;
        difference.whereInside.assign(x.begin(), end);
    }
}

void Comparison::Finding::append(const Finding& following)
{
    positions += following.positions;
    const ColumnDifference& other = following.difference;
    if (other.largest > difference.largest) {
        difference.largest = other.largest;
        difference.where = other.where;
    }
    if (other.largestInside > difference.largestInside) {
        difference.largestInside = other.largestInside;
        difference.whereInside = other.whereInside;
    }
}

LineLooks Comparison::looksAlong(const Job& job, const Position& x) const
{
    const bool isCommandA = &command() == &m_a;
    const Position ofB = m_b.positionOf(x);
    // Where the feedback table is looked up has been converted, whichever it is.
    const Position ofA = isMixed() && !isCommandA ? m_a.positionOf(x) : x;
    const bool othersInside = m_a.containsBut(job.along, x) && m_a.containsBut(job.along, ofA)
        && m_b.containsBut(job.along, ofB);
    LineLooks looks{job.a.along(job.along, m_a.used(ofA)), job.b.along(job.along, m_b.used(ofB)),
        job.factor, othersInside, {}, command().factors[job.along], isCommandA, feedback(),
        isCommandA ? job.b : job.a, job.along};
    looks.a.workOut();
    looks.b.workOut();
    if (isMixed()) {
        looks.motion = job.motion.along(job.along, command().used(isCommandA ? x : ofB));
        looks.motion->workOut();
    }
    return looks;
}

Look Comparison::lookAcross(const Job& job, const Position& x) const
{
    const bool isCommandA = &command() == &m_a;
    Position ofA = x;
    Position ofB = m_b.positionOf(x);
    const bool isInside = m_a.contains(ofA) && m_b.contains(ofB);
    // the feedback table is looked up where the encoder is moved to
    const Position offset = job.motion.offset(command().used(isCommandA ? ofA : ofB));
    Position moved = x;
    for (std::size_t n = 0; n < m_a.table.axes.size(); ++n)
        moved[n] += offset[n] / command().factors[n];
    (isCommandA ? ofB : ofA) = feedback().positionOf(moved);
    return {std::abs(job.a.at(m_a.used(ofA)) + job.factor * job.b.at(m_b.used(ofB))),
        isInside && m_a.contains(ofA) && m_b.contains(ofB)};
}

void Comparison::compareLine(const Job& job, Position x, Finding& finding) const
{
    const LineLooks line = looksAlong(job, x);
    std::array<Look, LineLooks::atOnce> looks;
    const auto lookAt = [&](std::span<const Unmoved> some) {
        if (!job.movesAcross)
            line.atEach(some, looks);
        for (std::size_t i = 0; i < some.size(); ++i) {
            x[job.along] = some[i].x;
            finding.take(job.movesAcross ? lookAcross(job, x) : looks[i], x, job.axes.size());
        }
        finding.positions += some.size();
    };
    const auto lookAtAll = [&](std::span<const Unmoved> all) {
        for (std::size_t i = 0; i < all.size(); i += looks.size())
            lookAt(all.subspan(i, std::min(looks.size(), all.size() - i)));
    };
    std::vector<Unmoved> met;
    if (job.movesAlong)
        for (const double position : metKnots(job, x))
            met.push_back(unmovedAt(job, position));
    lookAtAll(job.positions);
    lookAtAll(met);
}

Result<ColumnDifference> Comparison::compare(
    const ColumnPair& pair, const AxisLists& axes, std::size_t& positions) const
{
    const Direction direction = m_a.table.columns[pair.a].direction == Direction::Both
        ? m_b.table.columns[pair.b].direction
        : m_a.table.columns[pair.a].direction;
    AXISCOMP_TRY(const auto motion, motionOf(command(), direction));
    AXISCOMP_TRY(const auto moved, movedAxes(direction));
    const ControllerLookup a(m_a.table, pair.a, m_a.behaviour);
    const ControllerLookup b(m_b.table, pair.b, m_b.behaviour);
    Job job{a, b, isMixed() ? pair.factor : -pair.factor, motion, moved.size() > 1,
        moved.size() == 1, axes, moved.size() == 1 ? moved.front() : 0};
    findPlaces(job);
    constexpr std::size_t enough = 32'768; // positions for a thread to be worth its while
    const std::size_t lines = lineCount(axes, job.along);
    const std::size_t atOnce = std::max<std::size_t>(1, enough / axes[job.along].size());
    std::vector<Finding> findings((lines + atOnce - 1) / atOnce);
    shareWork(findings.size(), 0, [&](std::size_t part) {
        const std::size_t end = std::min(lines, (part + 1) * atOnce);
        for (std::size_t line = part * atOnce; line < end; ++line)
            compareLine(job, lineAt(axes, job.along, line), findings[part]);
    });
    Finding all;
    all.difference.columnA = pair.a;
    all.difference.columnB = pair.b;
    for (const Finding& finding : findings)
        all.append(finding);
    positions = all.positions;
    return std::move(all.difference);
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
    std::size_t mostPositions, std::optional<std::size_t> columns)
{
    Comparison comparison({a, behaviourA, {}}, {b, behaviourB, {}});
    AXISCOMP_CHECK(comparison.prepare(columns));
    return comparison.run(mostPositions);
}

} // namespace axiscomp
