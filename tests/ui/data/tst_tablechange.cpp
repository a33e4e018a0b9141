// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/test_registry.h"
#include "ui/data/table_change.h"

#include <QTest>

#include <cmath>
#include <functional>

namespace tst_tablechange {

using namespace axiscomp;
using namespace axiscomp::ui;

namespace {

using Function = std::function<double(double x, double y, double z)>;

std::shared_ptr<const CompensationTable> tableOf(
    const std::vector<GridAxis>& axes, const Function& value)
{
    CompensationTable table;
    table.unit = "mm";
    table.grid.axes = axes;
    const auto sizeOf = [&](std::size_t n) { return n < axes.size() ? axes[n].size : 1U; };
    const auto at = [&](std::size_t n, std::size_t i) {
        return n < axes.size() ? axes[n].position(i) : 0.0;
    };
    for (std::size_t k = 0; k < sizeOf(2); ++k)
        for (std::size_t j = 0; j < sizeOf(1); ++j)
            for (std::size_t i = 0; i < sizeOf(0); ++i)
                table.values.push_back(static_cast<float>(value(at(0, i), at(1, j), at(2, k))));
    return std::make_shared<const CompensationTable>(std::move(table));
}

GridAxis axis(const char* name, double start, double distance, std::uint32_t size)
{
    return {.name = name, .unit = "mm", .start = start, .distance = distance, .size = size};
}

bool isNear(double a, double b)
{
    return std::abs(a - b) <= 1e-6;
}

} // namespace

/// What the small pictures before a write show. Linear functions are exact between grid points.
class TestTableChange : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void onOneGridTheDifferenceHasItsPoints()
    {
        const std::vector<GridAxis> grid{axis("X", 0.0, 10.0, 5), axis("Y", 100.0, 5.0, 4)};
        const auto now = tableOf(grid, [](double x, double y, double) { return 1e-3 * x + y; });
        const auto old = tableOf(grid, [](double x, double, double) { return 3e-3 * x; });
        const TableChange change = tableChange(now, old);
        QCOMPARE(change.before.drawn, old);
        QCOMPARE(change.after.drawn, now);
        QVERIFY(change.difference.drawn->grid == now->grid);
        for (std::size_t j = 0; j < 4; ++j)
            for (std::size_t i = 0; i < 5; ++i)
                QVERIFY(std::abs(static_cast<double>(change.difference.drawn->values[i + 5 * j])
                            - (grid[1].position(j) - 2e-3 * grid[0].position(i)))
                    < 1e-5);
        QVERIFY(!change.after.cutAt);
    }

    void theDifferenceIsShownWhereOnlyOneOfTheTablesHasPoints()
    {
        // The old table ends at 20 with 0.2 and holds it; the new one begins at 10 with 0.
        const auto old =
            tableOf({axis("X", 0.0, 10.0, 3)}, [](double x, double, double) { return 0.01 * x; });
        const auto now =
            tableOf({axis("X", 10.0, 15.0, 3)}, [](double x, double, double) { return x - 10.0; });
        const TableChange change = tableChange(now, old);
        const CompensationTable& drawn = *change.difference.drawn;
        QCOMPARE(drawn.grid.axes[0].start, 0.0);
        QVERIFY(isNear(drawn.grid.axes[0].last(), 40.0));
        for (std::size_t i = 0; i < drawn.values.size(); ++i) {
            const double x = drawn.grid.axes[0].position(i);
            const double expected = std::max(x - 10.0, 0.0) - 0.01 * std::min(x, 20.0);
            QVERIFY2(std::abs(static_cast<double>(drawn.values[i]) - expected) < 1e-5,
                qPrintable(QString::number(x)));
        }
        QVERIFY(isNear(change.difference.largest.change, 29.8));
        QCOMPARE(change.difference.largest.position[0], 40.0);
        QVERIFY(isNear(change.after.largest.change, 30.0));
        QVERIFY(isNear(change.before.largest.change, 0.2));
        QVERIFY(isNear(change.scale(), 30.0));
    }

    void ofThreeDimensionsTheMiddleSliceIsDrawn()
    {
        const Function value = [](double x, double y, double z) {
            return x + 10.0 * y + 100.0 * z;
        };
        const auto now = tableOf(
            {axis("X", 0.0, 1.0, 3), axis("Y", 0.0, 1.0, 2), axis("Z", 2.0, 2.0, 5)}, value);
        const auto old =
            tableOf({axis("X", 0.0, 1.0, 3), axis("Y", 0.0, 1.0, 2), axis("Z", 0.0, 5.0, 3)},
                [&](double x, double y, double z) { return value(x, y, z) - 7.0; });
        const TableChange change = tableChange(now, old);
        QCOMPARE(change.after.cutAt, std::optional(6.0));
        QCOMPARE(change.before.cutAt, std::optional(5.0)); // its slice that is nearest
        QCOMPARE(change.difference.cutAt, std::optional(6.0));
        QCOMPARE(change.after.drawn->grid.dimensions(), 2);
        for (std::size_t j = 0; j < 2; ++j)
            for (std::size_t i = 0; i < 3; ++i) {
                const auto x = static_cast<double>(i);
                const auto y = static_cast<double>(j);
                QVERIFY(isNear(change.after.drawn->values[i + 3 * j], value(x, y, 6.0)));
                QVERIFY(isNear(change.before.drawn->values[i + 3 * j], value(x, y, 5.0) - 7.0));
                QVERIFY(isNear(change.difference.drawn->values[i + 3 * j], 7.0));
            }
        QVERIFY(isNear(change.after.largest.change, 2.0 + 10.0 + 1000.0)); // in another slice
        QCOMPARE(change.after.largest.position[2], 10.0);
        QCOMPARE(change.after.grid.dimensions(), 3);
    }

    void withoutOneOfThemThereIsNothingToCompare()
    {
        const Function value = [](double x, double, double) { return -x; };
        const auto line = tableOf({axis("X", 0.0, 1.0, 3)}, value);
        const auto map = tableOf({axis("X", 0.0, 1.0, 3), axis("Y", 0.0, 1.0, 2)}, value);
        const TableChange first = tableChange(line, nullptr);
        QVERIFY(!first.before.drawn && !first.difference.drawn);
        QCOMPARE(first.after.largest.change, -2.0);
        QCOMPARE(first.scale(), 2.0);
        const TableChange deleted = tableChange(nullptr, map);
        QVERIFY(deleted.before.drawn && !deleted.after.drawn && !deleted.difference.drawn);
        const TableChange other = tableChange(line, map);
        QVERIFY(other.before.drawn && other.after.drawn && !other.difference.drawn);
        QVERIFY(other.difference.largest.isBound);
        QCOMPARE(other.difference.largest.change, 2.0); // 0 after -2
    }

    void overOtherSourcesThereIsNoDifferenceToDraw()
    {
        const std::vector<GridAxis> grid{axis("X", 0.0, 1.0, 3)};
        const auto now = tableOf(grid, [](double x, double, double) { return x; });
        const auto old = tableOf(grid, [](double x, double, double) { return x - 1.0; });
        const TableChange change = tableChange(now, old, TableSources::Other);
        QCOMPARE(change.before.drawn, old);
        QCOMPARE(change.after.drawn, now);
        QVERIFY(!change.difference.drawn);
        QVERIFY(change.difference.largest.isBound);
        QCOMPARE(change.difference.largest.change, 3.0); // 2 after -1
        QVERIFY(tableChange(now, old).difference.drawn);
    }
};

AXISCOMP_TEST(TestTableChange)

} // namespace tst_tablechange

#include "tst_tablechange.moc"
