// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/contours.h"
#include "core/table/lookup.h"
#include "tests/support/test_registry.h"

#include <QTest>

#include <cmath>
#include <functional>
#include <tuple>

namespace tst_contours {

using namespace axiscomp;

namespace {

CompensationTable tableOf(
    std::uint32_t width, std::uint32_t height, const std::function<double(double, double)>& f)
{
    CompensationTable table;
    table.grid.axes = {{"X", "mm", -10.0, 20.0 / (width - 1), width},
        {"Y", "mm", 30.0, 40.0 / (height - 1), height}};
    for (std::size_t j = 0; j < height; ++j)
        for (std::size_t i = 0; i < width; ++i)
            table.values.push_back(static_cast<float>(
                f(table.grid.axes[0].position(i), table.grid.axes[1].position(j))));
    return table;
}

bool isOnBorder(const CompensationTable& table, const ContourPoint& point)
{
    const auto& [x, y] = std::tie(table.grid.axes[0], table.grid.axes[1]);
    return point.x == x.start || point.x == x.last() || point.y == y.start || point.y == y.last();
}

/// Each line is a ring, or ends on the border; each point has the level on the bilinear surface.
void verifyLines(const CompensationTable& table, const Contour& contour, double tolerance)
{
    const Lookup lookup(table);
    for (const ContourLine& line : contour.lines) {
        QVERIFY(line.points.size() >= 2);
        QVERIFY(line.isRing()
            || (isOnBorder(table, line.points.front()) && isOnBorder(table, line.points.back())));
        for (const ContourPoint& point : line.points) {
            QVERIFY(std::isfinite(point.x) && std::isfinite(point.y));
            const double off = std::abs(lookup.at(point.x, point.y) - contour.level);
            QVERIFY2(off <= tolerance, qPrintable(QString::number(off)));
        }
    }
}

} // namespace

class TestContours : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void aPlaneHasOneStraightLinePerLevel()
    {
        const auto table = tableOf(9, 6, [](double x, double y) { return 2.0 * x + y - 50.0; });
        const auto found = contours(table, {-7.0, 0.5, 13.0});
        QCOMPARE(found.size(), std::size_t{3});
        for (const Contour& contour : found) {
            QCOMPARE(contour.lines.size(), std::size_t{1});
            verifyLines(table, contour, 1e-5);
            for (const ContourPoint& point : contour.lines[0].points)
                QVERIFY(std::abs(2.0 * point.x + point.y - 50.0 - contour.level) < 1e-5);
        }
    }

    void aConeHasOneRingPerLevelAndLineEndsWhereItLeavesTheTable()
    {
        const auto radius = [](double x, double y) { return std::hypot(x, y - 50.0); };
        const auto table = tableOf(201, 401, radius);
        const auto found = contours(table, {2.0, 9.0, 15.0});
        for (const std::size_t n : {0, 1}) {
            QCOMPARE(found[n].lines.size(), std::size_t{1});
            QVERIFY(found[n].lines[0].isRing());
        }
        // Wider than the table: above and below a piece of the circle.
        QCOMPARE(found[2].lines.size(), std::size_t{2});
        for (const Contour& contour : found) {
            verifyLines(table, contour, 1e-5);
            double length = 0.0;
            for (const ContourLine& line : contour.lines) {
                for (std::size_t i = 1; i < line.points.size(); ++i)
                    length += std::hypot(line.points[i].x - line.points[i - 1].x,
                        line.points[i].y - line.points[i - 1].y);
                for (const ContourPoint& p : line.points)
                    QVERIFY(std::abs(radius(p.x, p.y) - contour.level) < 0.003);
            }
            const double angle =
                contour.level < 10.0 ? 2.0 * M_PI : 4.0 * std::asin(10.0 / contour.level);
            QVERIFY2(std::abs(length / (angle * contour.level) - 1.0) < 1e-3,
                qPrintable(QString::number(length)));
        }
    }

    void aSaddleIsDividedAsItsSurfaceIs_data()
    {
        QTest::addColumn<double>("level");
        QTest::newRow("above the middle") << 1.5;
        QTest::newRow("just above") << 0.01;
        QTest::newRow("just below") << -0.01;
        QTest::newRow("below") << -1.5;
    }
    /// One cell whose surface is (x - 4) (y - 45): level at (4, 45), which is not its centre.
    void aSaddleIsDividedAsItsSurfaceIs()
    {
        QFETCH(double, level);
        const auto table = tableOf(2, 2, [](double x, double y) { return (x - 4.0) * (y - 45.0); });
        const auto found = contours(table, {level});
        QCOMPARE(found[0].lines.size(), std::size_t{2});
        verifyLines(table, found[0], 1e-4);
        for (const ContourLine& line : found[0].lines) {
            // Each branch of a hyperbola stays in one quarter around the middle.
            const bool isRight = line.points.front().x > 4.0;
            for (const ContourPoint& point : line.points) {
                QCOMPARE(point.x > 4.0, isRight);
                QCOMPARE(point.y > 45.0, isRight == (level > 0.0));
            }
            QVERIFY2(line.points.size() > 20, "a coarse cell's line is curved");
        }
    }

    void aConstantTableHasNone()
    {
        const auto table = tableOf(5, 4, [](double, double) { return 0.3; });
        QVERIFY(contourLevels(table).empty());
        for (const double level : {0.3, static_cast<double>(0.3F), 0.2, 0.4})
            QVERIFY(contours(table, {level})[0].lines.empty());
    }

    void aLevelThatPointsHaveExactlyIsNotBroken()
    {
        // A plateau, a single peak, and a line of points that have the level.
        const auto table = tableOf(21, 21, [](double x, double y) {
            return std::abs(x) <= 3.0 && std::abs(y - 50.0) <= 6.0 ? 1.0
                : x == 8.0 && y == 34.0                            ? 1.0
                                                                   : x / 100.0;
        });
        const auto found = contours(table, {0.0, 1.0});
        QCOMPARE(found[1].lines.size(), std::size_t{1}); // the peak is a point, which is no line
        QVERIFY(found[1].lines[0].isRing());
        for (const Contour& contour : found)
            verifyLines(table, contour, 1e-7);
        QCOMPARE(found[0].lines.size(), std::size_t{1}); // around the plateau
    }

    void noiseIsNotBroken()
    {
        std::uint32_t random = 7;
        const auto table = tableOf(60, 50, [&random](double, double) {
            random = random * 1664525U + 1013904223U;
            return static_cast<double>(random >> 8) / (1 << 24) - 0.5;
        });
        for (const Contour& contour : contours(table, contourLevels(table))) {
            QVERIFY(!contour.lines.empty());
            verifyLines(table, contour, 1e-7);
        }
    }

    void theLevelsAreRoundAndAboutEight_data()
    {
        QTest::addColumn<double>("low");
        QTest::addColumn<double>("high");
        QTest::addColumn<QList<double>>("levels");
        QTest::newRow("micrometres")
            << -0.00071 << 0.00386
            << QList<double>{-0.0005, 0.0, 0.0005, 0.001, 0.0015, 0.002, 0.0025, 0.003, 0.0035};
        QTest::newRow("about zero") << -4.0 << 4.0 << QList<double>{-3, -2, -1, 0, 1, 2, 3};
        QTest::newRow("tens") << 3.0 << 61.0 << QList<double>{10, 20, 30, 40, 50, 60};
        QTest::newRow("thousands")
            << -7100.0 << -2600.0
            << QList<double>{-7000, -6500, -6000, -5500, -5000, -4500, -4000, -3500, -3000};
    }
    void theLevelsAreRoundAndAboutEight()
    {
        QFETCH(double, low);
        QFETCH(double, high);
        QFETCH(QList<double>, levels);
        const auto table =
            tableOf(2, 2, [&](double x, double y) { return x < 0.0 && y < 40.0 ? low : high; });
        const std::vector<double> found = contourLevels(table);
        QCOMPARE(QList<double>(found.begin(), found.end()), levels);
    }

    void thereAreThreeToTenLevelsWhateverTheValues()
    {
        for (double span = 1e-7; span < 1e7; span *= 1.013) {
            for (const double low : {-span / 2.0, 0.0, -span, 3.0 * span}) {
                const std::size_t count = contourLevels(tableOf(2, 2, [&](double x, double) {
                    return x < 0.0 ? low : low + span;
                })).size();
                QVERIFY2(count >= 3 && count <= 10, qPrintable(QString::number(span)));
            }
        }
    }
};

AXISCOMP_TEST(TestContours)

} // namespace tst_contours

#include "tst_contours.moc"
