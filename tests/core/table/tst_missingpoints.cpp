// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/table/missing_points.h"

#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <cmath>
#include <limits>

namespace tst_missingpoints {

using namespace axiscomp;

namespace {

constexpr double gap = std::numeric_limits<double>::quiet_NaN();

/// X 0 .. 40, Y 0 .. 60: a round bed with an unprobed point in the middle.
IncompleteGrid bed(const std::string& unitOfY = "mm")
{
    IncompleteGrid grid;
    grid.knots = {{0, 10, 20, 30, 40}, {0, 20, 40, 60}};
    grid.names = {Verbatim{"X"}, Verbatim{"Y"}};
    grid.units = {"mm", unitOfY};
    grid.tables = {{gap, 0.25, -0.5, -0.25, gap, //
        2, 0.5, gap, 0.5, 2, //
        2, 0.75, 0.5, 1.25, 3, //
        gap, 1, 1, 2, gap}};
    grid.tableNames = {Verbatim{"Z"}};
    grid.valueUnits = {"um"};
    return grid;
}

const std::vector<std::uint32_t> bedGaps{0, 4, 7, 15, 19};

IncompleteGrid line(std::vector<double> values)
{
    IncompleteGrid grid;
    grid.names = {Verbatim{"X"}};
    grid.units = {"mm"};
    std::vector<double>& knots = grid.knots.emplace_back();
    for (std::size_t i = 0; i < values.size(); ++i)
        knots.push_back(static_cast<double>(i));
    grid.tables = {std::move(values)};
    grid.tableNames = {Verbatim{"E"}};
    grid.valueUnits = {"um"};
    return grid;
}

std::string lines(DiagnosticList& diagnostics)
{
    std::string text;
    for (const Diagnostic& diagnostic : diagnostics.take())
        text += message(diagnostic) + '\n';
    return text;
}

void compareNumbers(const std::vector<double>& found, const std::vector<double>& expected)
{
    QCOMPARE(found.size(), expected.size());
    for (std::size_t i = 0; i < found.size(); ++i)
        QVERIFY2(std::abs(found[i] - expected[i]) < 1e-9,
            qPrintable(QStringLiteral("%1: %2 instead of %3")
                           .arg(i)
                           .arg(found[i], 0, 'g', 15)
                           .arg(expected[i], 0, 'g', 15)));
}

} // namespace

class TestMissingPoints : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    /// Computed with numpy.linalg.lstsq.
    void gapsGetTheValueThatTheMethodSays_data()
    {
        QTest::addColumn<int>("method");
        QTest::addColumn<QString>("unitOfY");
        QTest::addColumn<QList<double>>("expected");
        QTest::newRow("plane") << static_cast<int>(MissingPoints::Plane) << "mm"
                               << QList<double>{0.08898305084745771, 0.5889830508474583,
                                      0.8135593220338985, 1.5127118644067792, 2.01271186440678};
        QTest::newRow("smooth") << static_cast<int>(MissingPoints::Smooth) << "mm"
                                << QList<double>{1.28, 0.44, 0.0, 1.44, 3.28};
        QTest::newRow("smooth, by grid spacings where the units differ") << static_cast<int>(
            MissingPoints::Smooth) << "deg" << QList<double>{1.625, 0.875, 0.0, 1.875, 3.625};
        QTest::newRow("nearest") << static_cast<int>(MissingPoints::Nearest) << "mm"
                                 << QList<double>{0.25, -0.25, 0.5, 1.0, 2.0};
    }
    void gapsGetTheValueThatTheMethodSays()
    {
        QFETCH(const int, method);
        QFETCH(const QString, unitOfY);
        QFETCH(const QList<double>, expected);
        DiagnosticList diagnostics(10);
        const IncompleteGrid before = bed(unitOfY.toStdString());
        const auto after = completeGrid(before, static_cast<MissingPoints>(method), diagnostics);
        QVERIFY(after);
        QCOMPARE(after->filled.front(), bedGaps);
        std::vector<double> made;
        for (std::size_t i = 0; i < 20; ++i) {
            const bool isGap = std::ranges::binary_search(bedGaps, i);
            if (isGap)
                made.push_back(after->tables[0][i]);
            else
                QCOMPARE(after->tables[0][i], before.tables[0][i]);
        }
        compareNumbers(made, {expected.begin(), expected.end()});
    }

    void oneDimensionIsContinuedStraightOrCurved()
    {
        DiagnosticList diagnostics(10);
        const auto straight =
            completeGrid(line({1, gap, 3, 4, gap, gap}), MissingPoints::Smooth, diagnostics);
        QVERIFY(straight);
        compareNumbers(straight->tables[0], {1, 2, 3, 4, 5, 6});
        const auto curved =
            completeGrid(line({0, 1, gap, gap, 2, 6}), MissingPoints::Smooth, diagnostics);
        QVERIFY(curved);
        compareNumbers(curved->tables[0], {0, 1, 0.8, 0.7, 2, 6});
    }

    void threeDimensionsAreFilledExactlyWhereTheTruthIsAPlane()
    {
        IncompleteGrid grid;
        grid.knots = {{0, 1, 3}, {0, 2, 4, 5}, {-1, 0, 2}};
        grid.names = {Verbatim{"X"}, Verbatim{"Y"}, Verbatim{"Z"}};
        grid.units = {"mm", "mm", "mm"};
        std::vector<double> truth;
        for (const double z : grid.knots[2])
            for (const double y : grid.knots[1])
                for (const double x : grid.knots[0])
                    truth.push_back(0.5 + 2 * x - 3 * y + 0.25 * z);
        std::vector<double> values = truth;
        for (const std::size_t i : {0, 1, 5, 17, 18, 34, 35})
            values[i] = gap;
        grid.tables = {values};
        grid.tableNames = {Verbatim{"E"}};
        grid.valueUnits = {"um"};
        for (const MissingPoints method : {MissingPoints::Plane, MissingPoints::Smooth}) {
            DiagnosticList diagnostics(10);
            const auto after = completeGrid(grid, method, diagnostics);
            QVERIFY(after);
            compareNumbers(after->tables[0], truth);
        }
    }

    void nearestGoesByDistanceNotByIndex()
    {
        IncompleteGrid grid = line({7, gap, gap, 9});
        grid.knots = {{0, 1, 9, 10}};
        DiagnosticList diagnostics(10);
        const auto after = completeGrid(grid, MissingPoints::Nearest, diagnostics);
        QVERIFY(after);
        QCOMPARE(after->tables[0], (std::vector<double>{7, 7, 9, 9}));
    }

    void theLargestFullPartIsKept_data()
    {
        QTest::addColumn<QList<double>>("values");
        QTest::addColumn<QList<int>>("part"); ///< first X, first Y, columns, rows
        const double n = gap;
        QTest::newRow("a corner") << QList<double>{n, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11}
                                  << QList<int>{1, 0, 3, 3};
        QTest::newRow("the first row")
            << QList<double>{0, n, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11} << QList<int>{0, 1, 4, 2};
        QTest::newRow("the last row")
            << QList<double>{0, 1, 2, 3, 4, 5, 6, 7, 8, 9, n, 11} << QList<int>{0, 0, 4, 2};
    }
    void theLargestFullPartIsKept()
    {
        QFETCH(const QList<double>, values);
        QFETCH(const QList<int>, part);
        IncompleteGrid grid;
        grid.knots = {{0, 1, 2, 3}, {10, 20, 30}};
        grid.names = {Verbatim{"X"}, Verbatim{"Y"}};
        grid.units = {"mm", "mm"};
        grid.tables = {{values.begin(), values.end()}};
        grid.tableNames = {Verbatim{"Z"}};
        grid.valueUnits = {"um"};
        DiagnosticList diagnostics(10);
        const auto after = completeGrid(grid, MissingPoints::Crop, diagnostics);
        QVERIFY(after);
        QCOMPARE(after->first[0], static_cast<std::size_t>(part[0]));
        QCOMPARE(after->first[1], static_cast<std::size_t>(part[1]));
        QCOMPARE(after->knots[0].size(), static_cast<std::size_t>(part[2]));
        QCOMPARE(after->knots[1].size(), static_cast<std::size_t>(part[3]));
        QCOMPARE(after->knots[1].front(), grid.knots[1][after->first[1]]);
        std::vector<double> expected;
        for (int j = part[1]; j < part[1] + part[3]; ++j)
            for (int i = part[0]; i < part[0] + part[2]; ++i)
                expected.push_back(values[j * 4 + i]);
        QCOMPARE(after->tables[0], expected);
        QVERIFY(after->filled[0].empty());
    }

    void aGapInOneTableCropsAll()
    {
        IncompleteGrid grid = line({0, 1, 2, 3, 4});
        grid.tables.push_back({5, 6, gap, 8, 9});
        grid.tables.push_back({gap, 11, 12, 13, 14});
        grid.tableNames = {Verbatim{"A"}, Verbatim{"B"}, Verbatim{"C"}};
        grid.valueUnits = {"um", "um", "um"};
        DiagnosticList diagnostics(10);
        const auto after = completeGrid(grid, MissingPoints::Crop, diagnostics);
        QVERIFY(after);
        QCOMPARE(after->tables, (std::vector<std::vector<double>>{{3, 4}, {8, 9}, {13, 14}}));
    }

    void threeDimensionsAreCroppedToTheLargestBox()
    {
        IncompleteGrid grid;
        grid.knots = {{0, 1, 2}, {0, 1, 2}, {0, 1, 2, 3}};
        grid.names = {Verbatim{"X"}, Verbatim{"Y"}, Verbatim{"Z"}};
        grid.units = {"mm", "mm", "mm"};
        std::vector<double> values(36);
        for (std::size_t i = 0; i < values.size(); ++i)
            values[i] = static_cast<double>(i);
        values[0] = gap; // a corner of the first layer
        values[35] = gap; // the opposite one of the last
        grid.tables = {values};
        grid.tableNames = {Verbatim{"E"}};
        grid.valueUnits = {"um"};
        DiagnosticList diagnostics(10);
        const auto after = completeGrid(grid, MissingPoints::Crop, diagnostics);
        QVERIFY(after);
        // Two whole layers are 18 points; without one row or column of all four only 16 to 24 are
        // left, of which 3 x 2 x 3 = 18 as well; no box has more.
        QCOMPARE(after->tables[0].size(), 18U);
        QVERIFY(std::ranges::none_of(after->tables[0], [](double v) { return std::isnan(v); }));
    }

    void whatWasDoneIsSaidWithNumbers()
    {
        DiagnosticList filled(10);
        QVERIFY(completeGrid(bed(), MissingPoints::Smooth, filled));
        QCOMPARE(lines(filled),
            std::string("points without a value are filled: found 5 of 20 points of Z without a "
                        "value; they get 0 to 3.28 um, the measured values are -0.5 to 3 um "
                        "(FilledPoints)\n"));
        DiagnosticList cropped(10);
        QVERIFY(completeGrid(line({gap, 1, 2, 3, gap, 5}), MissingPoints::Crop, cropped));
        QCOMPARE(lines(cropped),
            std::string("the grid is cropped to the points that have a value: found 2 of 6 points "
                        "without a value; kept are 3 points, X from 1 to 3 mm (CroppedGrid)\n"));
        DiagnosticList whole(10);
        QVERIFY(completeGrid(line({1, 2}), MissingPoints::Crop, whole));
        QCOMPARE(lines(whole), std::string());
    }

    void whatCannotBeDoneIsSaid_data()
    {
        QTest::addColumn<QList<double>>("values");
        QTest::addColumn<int>("method");
        QTest::addColumn<QString>("reason");
        const auto row = [](const char* name, const QList<double>& values, MissingPoints method,
                             const char* reason) {
            QTest::newRow(name) << values << static_cast<int>(method)
                                << QString::fromLatin1(reason);
        };
        row("nothing measured", {gap, gap, gap}, MissingPoints::Nearest, "no value at all in E");
        row("one point makes no line", {gap, 1, gap}, MissingPoints::Plane,
            "measured points of E on one line only");
        row("one point cannot be continued", {gap, 1, gap}, MissingPoints::Smooth,
            "measured points of E on one line only");
        row("no two neighbours", {0, gap, 2}, MissingPoints::Crop, "no 2 neighbouring points");
    }
    void whatCannotBeDoneIsSaid()
    {
        QFETCH(const QList<double>, values);
        QFETCH(const int, method);
        QFETCH(const QString, reason);
        DiagnosticList diagnostics(10);
        QVERIFY(!completeGrid(
            line({values.begin(), values.end()}), static_cast<MissingPoints>(method), diagnostics));
        QVERIFY(diagnostics.hasErrors());
        const std::string said = lines(diagnostics);
        QVERIFY2(said.find(reason.toStdString()) != std::string::npos, said.c_str());
    }
};

AXISCOMP_TEST(TestMissingPoints)

} // namespace tst_missingpoints

#include "tst_missingpoints.moc"
