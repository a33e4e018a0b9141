// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/lookup.h"
#include "tests/core/table/lookup_reference.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <cmath>
#include <limits>
#include <random>

namespace tst_lookup {

using namespace axiscomp;
using namespace axiscomp::test;

namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr double largest = std::numeric_limits<double>::max();

void verifyClose(double found, double expected, double tolerance)
{
    if (std::isnan(expected)) {
        QVERIFY2(std::isnan(found), qPrintable(QString::number(found, 'g', 17)));
        return;
    }
    QVERIFY2(std::abs(found - expected) <= tolerance,
        qPrintable(
            QStringLiteral("%1 instead of %2").arg(found, 0, 'g', 17).arg(expected, 0, 'g', 17)));
}

/// Data columns "dimensions" and "outside" with every combination.
void addCombinations()
{
    QTest::addColumn<int>("dimensions");
    QTest::addColumn<Outside>("outside");
    const std::array names{"hold", "zero", "wrap", "extrapolate", "error"};
    for (int dimensions = 1; dimensions <= 3; ++dimensions) {
        for (std::size_t i = 0; i < names.size(); ++i)
            QTest::addRow("%dD %s", dimensions, names[i]) << dimensions << static_cast<Outside>(i);
    }
}

} // namespace

class TestInterpolation : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { axiscomp::test::failOnWarnings(); }

    void aGridPointGivesItsValueToTheLastBit_data() { addCombinations(); }
    void aGridPointGivesItsValueToTheLastBit()
    {
        QFETCH(int, dimensions);
        QFETCH(Outside, outside);
        const CompensationTable table = randomTable(awkwardGrid(dimensions));
        const Lookup lookup(table, outside);
        QCOMPARE(lookup.dimensions(), dimensions);
        forEachPoint(table.grid, [&](const auto& point) {
            QVERIFY(at(lookup, positionsOf(table.grid, point)) == valueAt(table, point));
        });
    }

    void aGridPointIsExactOnAnyGrid()
    {
        std::mt19937 generator(7);
        std::uniform_real_distribution<double> start(-1e6, 1e6);
        std::uniform_real_distribution<double> exponent(-9.0, 6.0);
        for (int round = 0; round < 300; ++round) {
            CompensationTable table =
                randomTable({{{{}, {}, start(generator), std::pow(10.0, exponent(generator)), 50}}},
                    static_cast<unsigned>(round));
            const Lookup lookup(table);
            for (std::size_t i = 0; i < table.values.size(); ++i) {
                const double position = table.grid.axes[0].position(i);
                QVERIFY(lookup.at(position) == static_cast<double>(table.values[i]));
                QVERIFY(lookup.index(0, position) == static_cast<double>(i));
            }
        }
    }

    void aGridPointIsExactNextToValuesOfAnotherMagnitude()
    {
        CompensationTable table;
        table.grid.axes = {{{}, {}, 0.1, 0.1, 4}};
        table.values = {1e-30F, 1e30F, -1e-30F, 3e38F};
        for (const Outside outside : {Outside::Hold, Outside::Extrapolate, Outside::Wrap}) {
            const Lookup lookup(table, outside);
            for (std::size_t i = 0; i < table.values.size(); ++i)
                QVERIFY(lookup.at(table.grid.axes[0].position(i))
                    == static_cast<double>(table.values[i]));
        }
    }

    void everyModeAgreesWithTheTextbook_data() { addCombinations(); }
    void everyModeAgreesWithTheTextbook()
    {
        QFETCH(int, dimensions);
        QFETCH(Outside, outside);
        const CompensationTable table = randomTable(awkwardGrid(dimensions), 3);
        const Lookup lookup(table, outside);
        std::mt19937 generator(5);
        int outsideCount = 0;
        for (int round = 0; round < 5000; ++round) {
            Positions positions{};
            bool isOutside = false;
            for (std::size_t i = 0; i < table.grid.axes.size(); ++i) {
                const GridAxis& axis = table.grid.axes[i];
                const double stroke = axis.last() - axis.start;
                positions[i] = std::uniform_real_distribution<double>(
                    axis.start - stroke, axis.last() + stroke)(generator);
                isOutside = isOutside || positions[i] < axis.start || positions[i] > axis.last();
            }
            outsideCount += isOutside ? 1 : 0;
            // 1e6 / 3 as a start leaves ten digits for the way within a cell
            verifyClose(at(lookup, positions), naiveLookup(table, positions, outside), 2e-8);
        }
        QVERIFY(outsideCount > 1000 && outsideCount < 5000);
    }

    void aLinearFunctionIsReproducedEverywhere_data()
    {
        QTest::addColumn<int>("dimensions");
        for (int dimensions = 1; dimensions <= 3; ++dimensions)
            QTest::addRow("%dD", dimensions) << dimensions;
    }
    void aLinearFunctionIsReproducedEverywhere()
    {
        QFETCH(int, dimensions);
        // whole numbers, so that float32 holds the function exactly at every point
        const std::array<GridAxis, 3> axes{GridAxis{{}, {}, -3.0, 1.0, 9},
            GridAxis{{}, {}, 10.0, 2.0, 6}, GridAxis{{}, {}, 0.0, 4.0, 5}};
        CompensationTable table;
        table.grid.axes.assign(axes.begin(), axes.begin() + dimensions);
        const auto function = [](const Positions& p) {
            return 5.0 + 2.0 * p[0] - 3.0 * p[1] + 0.5 * p[2];
        };
        forEachPoint(table.grid, [&](const auto& point) {
            table.values.push_back(static_cast<float>(function(positionsOf(table.grid, point))));
        });
        const Lookup inside(table);
        const Lookup everywhere(table, Outside::Extrapolate);
        std::mt19937 generator(11);
        for (int round = 0; round < 2000; ++round) {
            Positions positions{};
            Positions far{};
            for (std::size_t i = 0; i < table.grid.axes.size(); ++i) {
                const GridAxis& axis = table.grid.axes[i];
                positions[i] =
                    std::uniform_real_distribution<double>(axis.start, axis.last())(generator);
                far[i] = std::uniform_real_distribution<double>(-1000.0, 1000.0)(generator);
            }
            verifyClose(at(inside, positions), function(positions), 1e-12);
            verifyClose(at(everywhere, far), function(far), 1e-8);
        }
    }

    void aConstantTableIsExactlyConstant()
    {
        CompensationTable table = randomTable(awkwardGrid(3));
        std::ranges::fill(table.values, 0.1F);
        const Lookup lookup(table);
        std::mt19937 generator(13);
        std::uniform_real_distribution<double> position(-2e6, 2e6);
        for (int round = 0; round < 1000; ++round)
            QVERIFY(lookup.at(position(generator), position(generator), position(generator))
                == static_cast<double>(0.1F));
    }

    void wrapRepeatsWithThePeriod()
    {
        CompensationTable table = randomTable({{{{}, {}, -90.0, 10.0, 37}}});
        table.values.back() = table.values.front();
        const Lookup lookup(table, Outside::Wrap);
        std::mt19937 generator(17);
        std::uniform_real_distribution<double> position(-90.0, 270.0);
        for (int round = 0; round < 1000; ++round) {
            const double x = position(generator);
            for (const double turns : {-1000.0, -2.0, -1.0, 1.0, 2.0, 1000.0})
                verifyClose(lookup.at(x + turns * 360.0), lookup.at(x), 1e-10);
        }
        QVERIFY(lookup.at(-90.0 - 360.0) == lookup.at(-90.0));
        QVERIFY(lookup.at(270.0 + 360.0) == lookup.at(-90.0));
    }

    void holdKeepsTheEndValues()
    {
        const CompensationTable table = randomTable(awkwardGrid(1));
        const Lookup lookup(table);
        for (const double x : {-infinity, -largest, -1e300, -1.0, 0.0999999})
            QVERIFY(lookup.at(x) == static_cast<double>(table.values.front()));
        for (const double x : {infinity, largest, 1e300, 0.7000001, 99.0})
            QVERIFY(lookup.at(x) == static_cast<double>(table.values.back()));
    }

    void holdKeepsEachDimensionByItself()
    {
        const CompensationTable table = randomTable(awkwardGrid(3));
        const Lookup lookup(table);
        const double y = table.grid.axes[1].position(2);
        QVERIFY(lookup.at(-infinity, y, infinity) == valueAt(table, {0, 2, 3}));
        QVERIFY(
            lookup.at(1e99, -1e99, table.grid.axes[2].position(1)) == valueAt(table, {6, 0, 1}));
    }

    void zeroAndErrorBeginRightBehindTheEnds()
    {
        const CompensationTable table = randomTable(awkwardGrid(1));
        const double below = table.grid.axes[0].start - 1e-14;
        const double above = table.grid.axes[0].last() + 1e-14;
        const Lookup zero(table, Outside::Zero);
        const Lookup error(table, Outside::Error);
        for (const double x : {below, above, -infinity, infinity, largest}) {
            QVERIFY(zero.at(x) == 0.0);
            QVERIFY(std::isnan(error.at(x)));
        }
        QVERIFY(zero.at(table.grid.axes[0].start) != 0.0);
        QVERIFY(error.at(table.grid.axes[0].last()) == static_cast<double>(table.values.back()));
    }

    void whatRoundingPutsBeyondAnEndIsTheEnd()
    {
        CompensationTable table;
        table.grid.axes = {{{}, {}, 0.0, 0.3, 4}};
        table.values = {1.0F, 2.0F, 3.0F, 4.0F};
        CompensationTable mirrored = table;
        mirrored.grid.axes[0].start = -0.9;
        QVERIFY(table.grid.axes[0].last() < 0.9); // the decimal of the file
        const double beyondLast = std::nextafter(0.9, infinity);
        const double beforeFirst = std::nextafter(-0.9, -infinity);
        for (const Outside outside :
            {Outside::Hold, Outside::Zero, Outside::Wrap, Outside::Extrapolate, Outside::Error}) {
            const Lookup lookup(table, outside);
            for (const double x : {0.9, beyondLast}) {
                QVERIFY(lookup.at(x) == 4.0);
                QCOMPARE(lookup.index(0, x), 3.0);
            }
            QVERIFY(Lookup(mirrored, outside).at(beforeFirst) == 1.0);
        }
        QVERIFY(isWithin(table.grid, std::array{0.9}));
        QVERIFY(!isWithin(table.grid, std::array{0.9 + 1e-14}));
        QVERIFY(!isWithin(table.grid, std::array{notANumber}));
    }

    void whatRoundingPutsBeyondAnEndIsTheEndInEachDimension()
    {
        CompensationTable table = randomTable({{{{}, {}, 0.0, 0.5, 3}, {{}, {}, 0.0, 0.3, 4}}});
        const Lookup zero(table, Outside::Zero);
        QVERIFY(zero.at(0.5, 0.9) == valueAt(table, {1, 3, 0}));
        QVERIFY(zero.at(1.0, 0.9) == valueAt(table, {2, 3, 0}));
    }

    void extrapolateContinuesTheOuterCells()
    {
        CompensationTable table;
        table.grid.axes = {{{}, {}, 0.0, 2.0, 3}};
        table.values = {1.0F, 3.0F, 4.0F};
        const Lookup lookup(table, Outside::Extrapolate);
        QCOMPARE(lookup.at(-2.0), -1.0);
        QCOMPARE(lookup.at(6.0), 5.0);
        QCOMPARE(lookup.at(1.0), 2.0);
        QVERIFY(std::isfinite(lookup.at(1e300)));
    }

    void noNumberGivesNoNumber_data() { addCombinations(); }
    void noNumberGivesNoNumber()
    {
        QFETCH(int, dimensions);
        QFETCH(Outside, outside);
        const CompensationTable table = randomTable(awkwardGrid(dimensions));
        const Lookup lookup(table, outside);
        for (std::size_t i = 0; i < table.grid.axes.size(); ++i) {
            for (const double bad : {notANumber, -notANumber}) {
                Positions positions = positionsOf(table.grid, {1, 1, 1});
                positions[i] = bad;
                QVERIFY(std::isnan(at(lookup, positions)));
                // also while another dimension is outside, where Zero would answer 0
                positions[(i + 1) % table.grid.axes.size()] = dimensions > 1 ? 1e9 : bad;
                QVERIFY(std::isnan(at(lookup, positions)));
                QVERIFY(std::isnan(lookup.index(static_cast<int>(i), bad)));
            }
        }
    }

    void anyPositionIsAnsweredFromTheTable_data() { addCombinations(); }
    void anyPositionIsAnsweredFromTheTable()
    {
        // values in a block of exactly their size: the sanitizers see any other read
        QFETCH(int, dimensions);
        QFETCH(Outside, outside);
        const CompensationTable table = randomTable(awkwardGrid(dimensions));
        const Lookup lookup(table, outside);
        const std::array extremes{-infinity, -largest, -1e19, -1.0, -0.0, 0.0,
            std::numeric_limits<double>::denorm_min(), 0.7, 1e19, largest, infinity};
        for (const double x : extremes) {
            for (const double y : extremes) {
                for (const double z : extremes) {
                    const double value = at(lookup, {x, y, z});
                    if (outside != Outside::Extrapolate)
                        QVERIFY(std::isnan(value) || std::abs(value) <= 1.0);
                    if (outside == Outside::Hold || outside == Outside::Zero)
                        QVERIFY(!std::isnan(value));
                }
            }
        }
    }

    void gridsAtTheEndsOfTheNumbersAreSafe_data()
    {
        QTest::addColumn<double>("start");
        QTest::addColumn<double>("distance");
        QTest::newRow("denormal distance") << 0.0 << std::numeric_limits<double>::denorm_min();
        QTest::newRow("distance below the resolution of the start") << 1e20 << 1.0;
        QTest::newRow("distance at the resolution of the start") << 9007199254740992.0 << 1.0;
        QTest::newRow("negative zero") << -0.0 << 1.0;
        QTest::newRow("last position above the largest number") << -1.7e308 << 1e308;
    }
    void gridsAtTheEndsOfTheNumbersAreSafe()
    {
        QFETCH(double, start);
        QFETCH(double, distance);
        const CompensationTable table = randomTable({{{{}, {}, start, distance, 4}}});
        for (const Outside outside : {Outside::Hold, Outside::Wrap, Outside::Extrapolate}) {
            const Lookup lookup(table, outside);
            for (const double x : {-infinity, -largest, -1.0, -0.0, 0.0, distance, start,
                     start + distance, 1e20, 9007199254740994.0, largest, infinity})
                static_cast<void>(lookup.at(x));
        }
        const Lookup held(table);
        if (std::isfinite(table.grid.axes[0].last()))
            QVERIFY(held.at(-infinity) == static_cast<double>(table.values.front()));
    }

    void theSmallestTableIsInterpolated()
    {
        CompensationTable table;
        table.grid.axes = {{{}, {}, 0.0, 1.0, 2}, {{}, {}, 0.0, 1.0, 2}, {{}, {}, 0.0, 1.0, 2}};
        table.values = {0.0F, 1.0F, 2.0F, 3.0F, 4.0F, 5.0F, 6.0F, 7.0F};
        const Lookup lookup(table);
        QCOMPARE(lookup.at(0.5, 0.5, 0.5), 3.5);
        QCOMPARE(lookup.at(0.25, 0.0, 0.0), 0.25);
        QCOMPARE(lookup.at(0.0, 0.25, 0.0), 0.5);
        QCOMPARE(lookup.at(0.0, 0.0, 0.25), 1.0);
    }

    void theIndexFollowsTheMode()
    {
        const CompensationTable table = randomTable({{{{}, {}, 10.0, 2.0, 5}}});
        QCOMPARE(Lookup(table).index(0, 13.0), 1.5);
        QCOMPARE(Lookup(table).index(0, -1e9), 0.0);
        QCOMPARE(Lookup(table).index(0, infinity), 4.0);
        QCOMPARE(Lookup(table, Outside::Wrap).index(0, 19.0), 0.5);
        QCOMPARE(Lookup(table, Outside::Wrap).index(0, 9.0), 3.5);
        QCOMPARE(Lookup(table, Outside::Zero).index(0, 8.0), -1.0);
        QCOMPARE(Lookup(table, Outside::Extrapolate).index(0, 19.0), 4.5);
        QVERIFY(std::isnan(Lookup(table, Outside::Error).index(0, 9.0)));
        QCOMPARE(Lookup(table, Outside::Error).index(0, 18.0), 4.0);
        QVERIFY(std::isnan(Lookup(table).index(1, 13.0)));
        QVERIFY(std::isnan(Lookup(table).index(-1, 13.0)));
    }
};

AXISCOMP_TEST(TestInterpolation)

} // namespace tst_lookup

#include "tst_lookup.moc"
