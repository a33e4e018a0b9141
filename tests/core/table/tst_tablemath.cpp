// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/table_identity.h"
#include "core/table/table_math.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

namespace tst_tablemath {

using namespace axiscomp;

namespace {

GridAxis axis(double start, double distance, std::uint32_t size)
{
    return {"X", "mm", start, distance, size};
}

CompensationTable line(double start, double distance, const std::vector<float>& values)
{
    return {
        "E", "mm", {{axis(start, distance, static_cast<std::uint32_t>(values.size()))}}, values};
}

/// 2 x 2 x 3 points whose value tells where they are: 1, 10 and 100 for a step of each dimension.
CompensationTable block()
{
    CompensationTable table{"E", "mm", {{axis(0, 1, 2), axis(0, 1, 2), axis(0, 1, 3)}}, {}};
    for (int k = 0; k < 3; ++k)
        for (int j = 0; j < 2; ++j)
            for (int i = 0; i < 2; ++i)
                table.values.push_back(static_cast<float>(i + 10 * j + 100 * k));
    table.filled = {1, 6};
    return table;
}

} // namespace

class TestTableMath : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aTableIsItsValuesAndWhereTheyLie()
    {
        const TableIdentity one{7, Grid{{axis(0, 20, 11)}}};
        const auto isOne = [&one](std::uint32_t crc, const GridAxis& other) {
            const TableIdentity table{crc, Grid{{other}}};
            return isSameTable(one, table) && isSameTable(table, one);
        };
        QVERIFY(isOne(7, axis(0, 20, 11)));
        QVERIFY(isOne(7, {"", "", 1e-6, double(20.000001F), 11})); // as single precision rounds
        QVERIFY(!isOne(8, axis(0, 20, 11)));
        QVERIFY(!isOne(7, axis(50, 20, 11)));
        QVERIFY(!isOne(7, axis(-200, 40, 11))); // ends where the other does
        QVERIFY(!isOne(7, axis(0, 20.01, 11)));
        QVERIFY(!isOne(7, axis(0, 20, 12)));
        QVERIFY(!isSameTable(one, {7, Grid{{axis(0, 20, 11), axis(0, 1, 2)}}}));
        QVERIFY(isSameTable(one, {7, {}})); // where it lies is not known
        QVERIFY(!isSameTable(one, {8, {}}));
    }

    void withoutAnOldTableTheLargestChangeIsTheLargestValue()
    {
        const CompensationTable table = line(5, 2, {0.1F, -0.3F, 0.2F});
        const LargestChange largest = largestChange(table, nullptr);
        QCOMPARE(largest.change, -0.3F);
        QCOMPARE(largest.position[0], 7.0);
    }

    /// The new table ends at 10; at 50 it holds 0.2 where the old one had 1.
    void theLargestChangeMayLieWhereOnlyTheOldTableHasPoints()
    {
        const CompensationTable table = line(0, 10, {0.1F, 0.2F});
        const CompensationTable old = line(0, 50, {0.0F, 1.0F, 0.0F});
        const LargestChange largest = largestChange(table, &old);
        QCOMPARE(largest.change, double(0.2F) - 1.0);
        QCOMPARE(largest.position[0], 50.0);
    }

    /// The old table ends at 10 with 0.5, which it holds; the new one has -1 at 100.
    void theLargestChangeMayLieWhereOnlyTheNewTableHasPoints()
    {
        const CompensationTable table = line(0, 50, {0.0F, 0.2F, -1.0F});
        const CompensationTable old = line(0, 10, {0.0F, 0.5F});
        const LargestChange largest = largestChange(table, &old);
        QCOMPARE(largest.change, -1.5);
        QCOMPARE(largest.position[0], 100.0);
    }

    /// A peak of the old table between the points of the new one.
    void theLargestChangeMayLieBetweenTheNewPoints()
    {
        CompensationTable table{"E", "mm", {{axis(0, 10, 2), axis(0, 10, 2)}}, {0, 0, 0, 0}};
        CompensationTable old{"E", "mm", {{axis(0, 4, 3), axis(0, 5, 3)}}, std::vector<float>(9)};
        old.values[1 + 3 * 1] = 0.25F;
        const LargestChange largest = largestChange(table, &old);
        QCOMPARE(largest.change, -0.25);
        QCOMPARE(largest.position[0], 4.0);
        QCOMPARE(largest.position[1], 5.0);
    }

    /// Any value of the new table may follow any of the old one.
    void withOtherSourcesTheLargestChangeIsABound()
    {
        const CompensationTable table = line(0, 5, {1.0F, 3.0F, -1.0F});
        const CompensationTable old = line(0, 5, {1.0F, 2.0F, -2.0F});
        const LargestChange largest = largestChange(table, &old, TableSources::Other);
        QCOMPARE(largest.change, 5.0);
        QVERIFY(largest.isBound);
        QCOMPARE(largestChange(old, &table, TableSources::Other).change, -5.0);
        const LargestChange same = largestChange(table, &old);
        QCOMPARE(same.change, 1.0);
        QVERIFY(!same.isBound);
        QVERIFY(!largestChange(table, nullptr, TableSources::Other).isBound);
    }

    void withOtherDimensionsTheLargestChangeIsABound()
    {
        const CompensationTable old = block(); // 0 to 211
        const LargestChange largest = largestChange(line(0, 1, {1.0F, 2.0F}), &old);
        QCOMPARE(largest.change, 1.0 - 211.0);
        QVERIFY(largest.isBound);
    }

    void theDifferenceHoldsTheOldTablesEndValues()
    {
        const CompensationTable old = line(0, 10, {0.0F, 0.5F});
        const auto difference = tableDifference(line(0, 5, {1.0F, 1.0F, 1.0F, 1.0F}), old);
        QVERIFY(difference.has_value());
        QCOMPARE(difference->values, (std::vector<float>{1.0F, 0.75F, 0.5F, 0.5F}));
        QVERIFY(!tableDifference(block(), old).has_value());
    }

    void aSliceKeepsTheOrderOfTheOtherDimensions_data()
    {
        QTest::addColumn<int>("dimension");
        QTest::addColumn<std::vector<float>>("values");
        QTest::addColumn<std::vector<std::uint32_t>>("filled");
        QTest::newRow("X at 1") << 0 << std::vector<float>{1, 11, 101, 111, 201, 211}
                                << std::vector<std::uint32_t>{0};
        QTest::newRow("Y at 1") << 1 << std::vector<float>{10, 11, 110, 111, 210, 211}
                                << std::vector<std::uint32_t>{2};
        QTest::newRow("Z at 1") << 2 << std::vector<float>{100, 101, 110, 111}
                                << std::vector<std::uint32_t>{2};
    }
    void aSliceKeepsTheOrderOfTheOtherDimensions()
    {
        QFETCH(int, dimension);
        QFETCH(std::vector<float>, values);
        QFETCH(std::vector<std::uint32_t>, filled);
        const CompensationTable slice = tableSlice(block(), static_cast<std::size_t>(dimension), 1);
        QCOMPARE(slice.values, values);
        QCOMPARE(slice.filled, filled);
        QCOMPARE(slice.grid.dimensions(), 2);
    }

    void theNearestPointIsHeldAtTheEnds()
    {
        const GridAxis places = axis(10, 5, 4);
        QCOMPARE(nearestIndex(places, -1e9), std::size_t{0});
        QCOMPARE(nearestIndex(places, 17.4), std::size_t{1});
        QCOMPARE(nearestIndex(places, 17.6), std::size_t{2});
        QCOMPARE(nearestIndex(places, 1e9), std::size_t{3});
    }
};

AXISCOMP_TEST(TestTableMath)

} // namespace tst_tablemath

#include "tst_tablemath.moc"
