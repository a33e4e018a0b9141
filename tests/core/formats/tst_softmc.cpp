// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_checks.h"
#include "tests/support/test_registry.h"

namespace tst_softmc {

using namespace axiscomp;
using test::applied;
using test::problemLines;

namespace {

const TableFamily& family = softmc::format();

TableReadOptions withUnits()
{
    TableReadOptions options;
    options.settings = {{"position-unit", "mm"}, {"value-unit", "mm"}};
    return options;
}

/// The three axes of the manual's example, with a header that fits its rows.
std::string threeAxes()
{
    std::string text = "3 2 3 2\n";
    int row = 0;
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 2; ++x, ++row)
                text += std::to_string(100 * x) + ' ' + std::to_string(10 + y) + ' '
                    + std::to_string(5 * z) + "  0.00" + std::to_string(row % 10) + " 0.1 -0.1\n";
    return text;
}

} // namespace

class TestSoftmc : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aTableOfThreeAxesIsReadWithTheFirstSourceFastest()
    {
        READ_TABLE(table, family, threeAxes(), withUnits());
        QCOMPARE(table.axes.size(), std::size_t(3));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{0, 100}));
        QCOMPARE(table.axes[1].knots, (std::vector<double>{10, 11, 12}));
        QCOMPARE(table.axes[2].knots, (std::vector<double>{0, 5}));
        QCOMPARE(table.columns.size(), std::size_t(3));
        QCOMPARE(table.columns[0].values[1], 0.001); // the first source moves first
        QCOMPARE(table.columns[0].values[2], 0.002); // then the second
        QCOMPARE(table.columns[0].values[6], 0.006); // the last one at the end
        QCOMPARE(applied(family, table, {100, 11, 0}), 0.003);
        QCOMPARE(applied(family, table, {100, 11, 0}, 2), -0.1);
    }

    void oneCorrectionOrMoreThanThereAreSourcesIsAccepted()
    {
        READ_TABLE(one, family, "2 2 2\n0 0 1\n1 0 2\n0 1 3\n1 1 4\n", withUnits());
        QCOMPARE(one.columns.size(), std::size_t(1));
        READ_TABLE(three, family, "1 2\n0 1 2 3\n1 4 5 6\n", withUnits());
        QCOMPARE(three.columns.size(), std::size_t(3));
    }

    void itTakesEffectOnceEverySourceHasReachedItsFirstValue()
    {
        READ_TABLE(table, family, "2 2 2\n10 0 1\n20 0 1\n10 5 1\n20 5 1\n", withUnits());
        QCOMPARE(applied(family, table, {10, 0}), 1.0);
        QCOMPARE(applied(family, table, {9.999, 0}), 0.0);
        QCOMPARE(applied(family, table, {15, -0.001}), 0.0);
        QCOMPARE(applied(family, table, {15, 2}), 1.0);
    }

    void aboveTheLastValueTheLastCorrectionIsHeld()
    {
        READ_TABLE(table, family, "1 3\n0 1\n10 2\n20 4\n", withUnits());
        QCOMPARE(applied(family, table, {1e6}), 4.0);
        QCOMPARE(applied(family, table, {15}), 3.0);
    }

    void whatIsWrittenIsReadBackTheSame_data()
    {
        QTest::addColumn<int>("dimensions");
        QTest::addRow("1D") << 1;
        QTest::addRow("2D") << 2;
        QTest::addRow("3D") << 3;
    }
    void whatIsWrittenIsReadBackTheSame()
    {
        QFETCH(int, dimensions);
        NeutralTable table;
        table.sign = SignConvention::Command;
        const std::array axes{test::evenAxis("1", "mm", -20, 0.1, 4),
            test::evenAxis("2", "mm", 0, 2.5, 3), test::evenAxis("3", "mm", 7, 1e-3, 2)};
        table.axes.assign(axes.begin(), axes.begin() + dimensions);
        for (int n = 1; n <= dimensions; ++n)
            table.columns.push_back(
                test::waveColumn(std::to_string(n), "mm", table.pointCount(), 0.01 * n));
        const auto written = family.write(std::array{table}, {});
        VERIFY_RESULT(written);
        READ_TABLE(again, family, written->bytes, withUnits());
        COMPARE_TABLES(again, table, 0.0);
        COMPARE_TABLES(written->held.front(), table, 0.0);
    }

    void correctionsAreWrittenInTheUnitOfThePositions()
    {
        NeutralTable table;
        table.axes = {test::evenAxis("1", "mm", 0, 1, 2)};
        table.columns = {test::waveColumn("1", "um", 2, 1.0)};
        table.columns[0].values = {1.0, 2.5};
        const auto written = family.write(std::array{table}, {});
        VERIFY_RESULT(written);
        QCOMPARE(written->bytes, std::string("1 2\n0 0.001\n1 0.0025\n"));
    }

    void aProblemNamesItsPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("problem"); // the beginning of the first one
        const auto row = [](const char* name, const char* text, const char* problem) {
            QTest::newRow(name) << QByteArray(text) << QByteArray(problem);
        };
        row("empty", "", "0:0 EmptyFile");
        row("four sources", "4 2 2 2 2\n", "1:1 LimitExceeded 4 source axes|1 to 3");
        row("a size is missing", "2 3\n0 0 1\n", "1:0 ColumnCount 1 sizes|2,");
        row("one point", "1 1\n0 1\n", "1:3 LimitExceeded 1 points|at least 2");
        row("too many rows", "3 9999 9999 9999\n", "1:8 LimitExceeded");
        row("no correction", "1 2\n0\n1\n", "2:0 TooFewColumns 1 numbers|1 positions and at least");
        row("a number that is none", "1 2\n0 0.1\n1 0,1\n", "3:3 NotANumber 0,1|a correction");
        row("not finite", "1 2\n0 nan\n1 1\n", "2:3 NotANumber nan|a correction");
        row("ragged", "1 2\n0 1\n1 1 1\n", "3:0 ColumnCount 3 numbers|2, as in the first row");
        row("header does not fit", "1 3\n0 1\n1 1\n",
            "1:0 Contradiction a header of 3 = 3 rows, and 2 rows|");
        row("not the first source fastest", "2 2 2\n0 0 1\n0 1 2\n1 0 3\n1 1 4\n",
            "3:2 Contradiction 1 for source 2|0: the first source changes fastest");
        row("decreasing", "1 2\n1 1\n0 1\n", "0:0 NotMonotonic 0 after 1|strictly increasing");
        row("uneven", "1 3\n0 1\n1 1\n3 1\n",
            "0:0 UnevenSpacing positions of source 1 from 0 to 3");
    }
    void aProblemNamesItsPlace()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, problem);
        const auto reading = family.read(text.toStdString(), withUnits());
        VERIFY_RESULT(reading);
        QVERIFY(reading->tables.empty());
        const std::string found = problemLines(*reading);
        QVERIFY2(found.starts_with(problem.toStdString()), found.c_str());
    }

    void unitsThatNobodySaysAreAWarning()
    {
        const auto reading = family.read("1 2\n0 1\n1 1\n", {});
        VERIFY_RESULT(reading);
        QCOMPARE(reading->tables.size(), std::size_t(1));
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::UnitNotGiven, 0));
    }

    void aFileIsRecognisedByItsHeader()
    {
        QCOMPARE(family.recognise(threeAxes()), Recognition::Certain);
        QCOMPARE(family.recognise("0 0.1 0.2\n1 0.1 0.2\n"), Recognition::No);
        QCOMPARE(family.recognise("X,Table 1\n0,1\n"), Recognition::No);
        QCOMPARE(family.recognise(""), Recognition::No);
    }

    void twoMegabytesAreReadWhole()
    {
        std::string text = "2 400 300\n";
        for (int y = 0; y < 300; ++y)
            for (int x = 0; x < 400; ++x)
                text += std::to_string(x) + ' ' + std::to_string(y) + " 0.00123\n";
        READ_TABLE(table, family, text, withUnits());
        QCOMPARE(table.pointCount(), std::size_t(120000));
    }
};

AXISCOMP_TEST(TestSoftmc)

} // namespace tst_softmc

#include "tst_softmc.moc"
