// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/neutral/controller_lookup.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <random>

namespace tst_controllerlookup {

using namespace axiscomp;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double notANumber = std::numeric_limits<double>::quiet_NaN();

bool isSame(double a, double b)
{
    return std::bit_cast<std::uint64_t>(a) == std::bit_cast<std::uint64_t>(b)
        || (std::isnan(a) && std::isnan(b));
}

enum class Spacing { Even, NearlyEven, Uneven, TwoClusters };

std::vector<double> knots(Spacing spacing, std::size_t count, std::mt19937& random)
{
    std::uniform_real_distribution<double> part(0.0, 1.0);
    std::vector<double> result{std::uniform_real_distribution<double>(-1e3, 1e3)(random)};
    while (result.size() < count) {
        const bool isInGap = 2 * result.size() == count || 2 * result.size() + 1 == count;
        const double step = spacing == Spacing::Even ? 0.1
            : spacing == Spacing::NearlyEven         ? 0.1 + 1e-9 * part(random)
            : spacing == Spacing::Uneven             ? std::pow(10.0, -6.0 * part(random))
            : isInGap                                ? 1e6
                                                     : 1e-6;
        result.push_back(result.back() + step);
    }
    return result;
}

double anyPosition(const std::vector<double>& knots, std::mt19937& random)
{
    const double stroke = knots.back() - knots.front();
    const double knot = knots[random() % knots.size()];
    switch (random() % 8) {
    case 0:
        return knot;
    case 1:
        return std::nextafter(knot, infinity);
    case 2:
        return std::nextafter(knot, -infinity);
    case 3: {
        constexpr std::array extremes{infinity, -infinity, 1e300, -1e300, 0.0};
        return extremes[random() % extremes.size()];
    }
    case 4:
        return std::uniform_real_distribution<double>(
            knots.front() - stroke, knots.back() + stroke)(random);
    default:
        return std::uniform_real_distribution<double>(knots.front(), knots.back())(random);
    }
}

NeutralTable anyTable(std::size_t dimensions, std::mt19937& random)
{
    NeutralTable table;
    std::size_t count = 1;
    for (std::size_t n = 0; n < dimensions; ++n) {
        SourceAxis& axis = table.axes.emplace_back();
        axis.knots = knots(static_cast<Spacing>(random() % 4), 2 + random() % 9, random);
        if (random() % 3 == 0)
            axis.wrap = (axis.knots.back() - axis.knots.front()) * (random() % 2 == 0 ? 1.0 : 1.25);
        count *= axis.knots.size();
    }
    CompensationColumn& column = table.columns.emplace_back();
    for (std::size_t i = 0; i < count; ++i)
        column.values.push_back(std::uniform_real_distribution<double>(-1.0, 1.0)(random));
    return table;
}

bool areWithin(const NeutralTable& table, const std::vector<double>& position)
{
    for (std::size_t n = 0; n < position.size(); ++n) {
        const std::vector<double>& all = table.axes[n].knots;
        if (!(position[n] >= all.front() && position[n] <= all.back()))
            return false;
    }
    return true;
}

constexpr std::array behaviours{TableBehaviour{}, TableBehaviour{.outside = Outside::Zero},
    TableBehaviour{.outside = Outside::Extrapolate},
    TableBehaviour{.startsAtFirst = true, .usesFloat = true}};

} // namespace

class TestControllerLookup : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theFirstKnotAboveIsThatOfABinarySearch()
    {
        std::mt19937 random(1); // NOLINT: the same knots every time
        for (int round = 0; round < 400; ++round) {
            const std::vector<double> all =
                knots(static_cast<Spacing>(round % 4), 2 + random() % 300, random);
            const KnotSearch search(all);
            for (int i = 0; i < 100; ++i) {
                const double position = anyPosition(all, random);
                const auto due = std::ranges::upper_bound(all, position) - all.begin();
                QCOMPARE(search.firstAbove(position), static_cast<std::size_t>(due));
            }
        }
    }

    void knotsAtTheEndsOfTheNumbersAreSafe()
    {
        constexpr double largest = std::numeric_limits<double>::max();
        constexpr double smallest = std::numeric_limits<double>::denorm_min();
        for (const std::vector<double>& all : {std::vector<double>{0.0, smallest},
                 std::vector<double>{-largest, largest}, std::vector<double>{0.0, 1.0, largest}}) {
            const KnotSearch search(all);
            for (const double position :
                {-infinity, -largest, -1.0, 0.0, smallest, 1.0, largest, infinity})
                QCOMPARE(search.firstAbove(position),
                    static_cast<std::size_t>(
                        std::ranges::upper_bound(all, position) - all.begin()));
        }
    }

    void aLineHasTheValuesOfItsPositions()
    {
        std::mt19937 random(2); // NOLINT
        for (int round = 0; round < 600; ++round) {
            const std::size_t dimensions = 1 + static_cast<std::size_t>(round) % 3;
            const NeutralTable table = anyTable(dimensions, random);
            const ControllerLookup lookup(table, 0, behaviours[random() % behaviours.size()]);
            std::vector<double> position;
            for (const SourceAxis& axis : table.axes)
                position.push_back(
                    random() % 30 == 0 ? notANumber : anyPosition(axis.knots, random));
            // Along the first axis the single lookup is the line's; along the others it is not.
            for (std::size_t n = 0; n < dimensions; ++n) {
                const ControllerLookup::Line line = lookup.along(n, position);
                for (int i = 0; i < 20; ++i) {
                    position[n] = i == 0 ? notANumber : anyPosition(table.axes[n].knots, random);
                    const double found = line.at(position[n]);
                    const double due = lookup.at(position);
                    if (n == 0)
                        QVERIFY(isSame(found, due));
                    else if (areWithin(table, position))
                        QVERIFY(std::abs(found - due) <= 1e-12);
                }
            }
        }
    }

    void whatRoundingPutsBeyondAnEndIsTheEnd()
    {
        NeutralTable table;
        table.axes.resize(1);
        table.axes[0].knots = {-0.9, -0.6, 0.3 * 3};
        table.columns.emplace_back().values = {1.0, 2.0, 3.0};
        const double beforeFirst = std::nextafter(-0.9, -infinity);
        for (const TableBehaviour& behaviour : behaviours) {
            const ControllerLookup lookup(table, 0, behaviour);
            QVERIFY(lookup.at(std::array{0.9}) == 3.0); // 0.3 * 3 is less
            QVERIFY(lookup.at(std::array{beforeFirst}) == 1.0);
        }
        const ControllerLookup zero(table, 0, {.outside = Outside::Zero});
        QCOMPARE(zero.at(std::array{0.9 + 1e-14}), 0.0);
        QCOMPARE(zero.at(std::array{-0.9 - 1e-14}), 0.0);
    }

    void noNumberGivesNoNumberAlsoBesideAPositionOutside()
    {
        NeutralTable table;
        table.axes.resize(2);
        for (SourceAxis& axis : table.axes)
            axis.knots = {0.0, 1.0};
        table.columns.emplace_back().values = {1.0, 2.0, 3.0, 4.0};
        const ControllerLookup lookup(table, 0, {.outside = Outside::Zero});
        QVERIFY(std::isnan(lookup.at(std::array{notANumber, 5.0})));
        QVERIFY(std::isnan(lookup.at(std::array{5.0, notANumber})));
        QCOMPARE(lookup.at(std::array{5.0, 0.5}), 0.0);
        QCOMPARE(lookup.at(std::array{0.5, 5.0}), 0.0);
        QCOMPARE(lookup.at(std::array{0.5, 0.5}), 2.5);
    }
};

AXISCOMP_TEST(TestControllerLookup)

} // namespace tst_controllerlookup

#include "tst_controllerlookup.moc"
