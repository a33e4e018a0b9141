// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_checks.h"
#include "tests/support/test_registry.h"

namespace tst_aerotech2d {

using namespace axiscomp;
using test::applied;
using test::problemLines;

namespace {

const TableFamily& family = aerotech_2d::format();

/// Two rows of three points; row axis 2, column axis 1.
const std::string file = "; granite\n"
                         ":START2D 2 1 1 2 10 5 3\n"
                         ":START2D POSUNIT=METRIC CORUNIT=METRIC/1000 OFFSETROW = 20\n"
                         ":START2D OFFSETCOL=5\n"
                         "1 -1  2 -2  3 -3\n"
                         "4 -4  5 -5  6 -6\n"
                         ":END\n";

std::string with(const std::string& from, const std::string& to)
{
    std::string text = file;
    return text.replace(text.find(from), from.size(), to);
}

NeutralTable plane(std::size_t columns)
{
    NeutralTable table;
    table.sign = SignConvention::Command;
    table.axes = {test::evenAxis("1", "mm", -10.25, 0.7, 4), test::evenAxis("2", "mm", 3, 2.5, 5)};
    for (std::size_t n = 1; n <= columns; ++n)
        table.columns.push_back(
            test::waveColumn(std::to_string(n), "mm", 20, 0.01 * static_cast<double>(n)));
    return table;
}

} // namespace

class TestAerotech2d : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theLinesGoAlongTheRowAxisAndThePointsAlongTheColumnAxis()
    {
        READ_TABLE(table, family, file, {});
        QCOMPARE(table.axes[0].name, std::string("1"));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{-5, 0, 5}));
        QCOMPARE(table.axes[1].name, std::string("2"));
        QCOMPARE(table.axes[1].knots, (std::vector<double>{-20, -10}));
        QCOMPARE(table.notes, (std::vector<std::string>{"granite"}));
        QVERIFY2(reading_table->diagnostics.empty(), problemLines(*reading_table).c_str());
    }

    void eachPointHasAPairOfCorrections()
    {
        READ_TABLE(table, family, file, {});
        QCOMPARE(table.columns.size(), std::size_t(2));
        QCOMPARE(table.columns[0].target, std::string("1"));
        QCOMPARE(table.columns[1].target, std::string("2"));
        QCOMPARE(applied(family, table, {0, -20}), 0.002);
        QCOMPARE(applied(family, table, {5, -10}, 1), -0.006);
    }

    void aThirdOutputMakesTriples()
    {
        READ_TABLE(table, family,
            ":START2D 2 1 1 2 10 5 2\n:START2D OUTAXIS3=3 POSUNIT=METRIC CORUNIT=METRIC\n"
            "1 2 3 4 5 6\n7 8 9 10 11 12\n:END\n",
            {});
        QCOMPARE(table.columns.size(), std::size_t(3));
        QCOMPARE(table.columns[2].target, std::string("3"));
        QCOMPARE(table.columns[2].values, (std::vector<double>{3, 6, 9, 12}));
    }

    void negativeDistancesCountDownwards()
    {
        READ_TABLE(table, family, with("10 5 3", "-10 -5 3"), {});
        QCOMPARE(table.axes[0].knots, (std::vector<double>{-15, -10, -5}));
        QCOMPARE(table.axes[1].knots, (std::vector<double>{-30, -20}));
        QCOMPARE(applied(family, table, {-5, -20}), 0.001);
        QCOMPARE(applied(family, table, {-15, -30}), 0.006);
        QCOMPARE(applied(family, table, {-5, -30}), 0.004);
    }

    void negcorTurnsTheSign()
    {
        READ_TABLE(table, family, with("OFFSETCOL=5", "OFFSETCOL=5 NEGCOR SERIALNUMBER=12-3"), {});
        QCOMPARE(applied(family, table, {-5, -20}), -0.001);
        QCOMPARE(applied(family, table, {-5, -20}, 1), 0.001);
        QVERIFY(reading_table->diagnostics.empty());
    }

    void itIsBilinearBetweenThePointsAndHeldOutside()
    {
        READ_TABLE(table, family, file, {});
        QCOMPARE(applied(family, table, {-2.5, -15}), 0.003);
        QCOMPARE(applied(family, table, {-1e6, 1e6}), 0.004);
    }

    void valuesMayFlowFreely()
    {
        READ_TABLE(table, family, with("1 -1  2 -2  3 -3\n4 -4", "1 -1\n2 -2 3\n-3 4 -4"), {});
        QCOMPARE(applied(family, table, {0, -10}), 0.005);
    }

    void whatIsWrittenIsReadBackTheSame_data()
    {
        QTest::addColumn<int>("columns");
        QTest::addRow("pairs") << 2;
        QTest::addRow("triples") << 3;
    }
    void whatIsWrittenIsReadBackTheSame()
    {
        QFETCH(int, columns);
        const std::array tables{plane(static_cast<std::size_t>(columns)), plane(2)};
        const auto written = family.write(tables, {});
        VERIFY_RESULT(written);
        const auto again = family.read(written->bytes, {});
        VERIFY_RESULT(again);
        QCOMPARE(again->tables.size(), std::size_t(2));
        QCOMPARE(again->tables, written->held);
        for (std::size_t i = 0; i < 2; ++i) {
            COMPARE_TABLES(again->tables[i], tables[i], 1e-12);
            QCOMPARE(again->tables[i].columns[0].values, tables[i].columns[0].values);
        }
    }

    void theFileHasTheFormOfTheManual()
    {
        NeutralTable table = plane(2);
        table.axes = {test::evenAxis("1", "mm", 0, 5, 2), test::evenAxis("2", "mm", -1, 2, 2)};
        table.columns[0].values = {0.25, 0.5, 0.75, 1};
        table.columns[1].values = {-0.25, -0.5, -0.75, -1};
        const auto written = family.write(std::array{table}, {});
        VERIFY_RESULT(written);
        QCOMPARE(written->bytes,
            std::string(":START2D 2 1 1 2 2 5 2\n:START2D POSUNIT=METRIC CORUNIT=METRIC\n"
                        ":START2D OFFSETROW=1 OFFSETCOL=0\n0.25 -0.25  0.5 -0.5\n"
                        "0.75 -0.75  1 -1\n:END\n"));
    }

    void aSingleColumnGetsASecondOneOfZeros()
    {
        const auto written = family.write(std::array{plane(1)}, {});
        VERIFY_RESULT(written);
        const NeutralTable& held = written->held.front();
        QCOMPARE(held.columns.size(), std::size_t(2));
        QCOMPARE(held.columns[0].values, plane(1).columns[0].values);
        QCOMPARE(held.columns[1].target, std::string("2"));
        QCOMPARE(held.columns[1].values, std::vector<double>(20, 0.0));
    }

    void axesThatAreNoNumbersNeedSettings()
    {
        NeutralTable table = plane(2);
        table.axes[0].name = "X";
        table.axes[1].name = "Y";
        table.columns[0].target = "X";
        table.columns[1].target = "Z";
        const auto refused = family.write(std::array{table}, {});
        VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
        QVERIFY(test::describe(refused.error()).find("column-axis") != std::string::npos);
        TableWriteOptions options;
        options.settings = {{"column-axis", "5"}, {"row-axis", "6"}, {"output-axis-2", "7"}};
        const auto written = family.write(std::array{table}, options);
        VERIFY_RESULT(written);
        QVERIFY(written->bytes.starts_with(":START2D 6 5 5 7 "));
    }

    void rotaryAxesAreWrittenInDegrees()
    {
        NeutralTable table = plane(2);
        table.axes[1].unit = "deg";
        table.columns[1].unit = "deg";
        const auto written = family.write(std::array{table}, {});
        VERIFY_RESULT(written);
        COMPARE_TABLES(written->held.front(), table, 1e-12);
    }

    void aProblemNamesItsPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("problem"); // the beginning of the first one
        const auto row = [](const char* name, const std::string& text, const char* problem) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(problem);
        };
        row("empty", "", "0:0 EmptyFile");
        row("one dimension", ":START 1 SAMPLEDIST=5\n1 2\n:END\n", "1:1 Syntax :START|:START2D or");
        row("six numbers", with("10 5 3", "10 5"), "2:1 Syntax :START2D 2 1 1 2 10 5|7 numbers");
        row("axis 0", with("2 1 1 2", "2 1 0 2"),
            "2:14 LimitExceeded axis 0|the number of an axis");
        row("one axis twice", with("2 1 1 2", "1 1 1 2"), "2:12 Contradiction axis 1 for rows and");
        row("distance 0", with("10 5 3", "10 0 3"), "2:21 LimitExceeded a distance of 0|");
        row("one column", with("10 5 3", "10 5 1"), "2:23 LimitExceeded 1 columns|at least 2");
        row("absurd columns", with("10 5 3", "10 5 1000000000"),
            "5:0 ColumnCount 6 corrections in this line, 12 in all|1000000000 points of 2");
        row("columns not whole", with("10 5 3", "10 5 2.5"),
            "2:23 NotANumber 2.5|the number of columns");
        row("one row", with("4 -4  5 -5  6 -6\n", ""), "2:0 TooFewPoints 1 rows|at least 2");
        row("no values", with("1 -1  2 -2  3 -3\n4 -4  5 -5  6 -6\n", ""),
            "2:0 TooFewPoints 0 rows|at least 2");
        row("a value is missing", with("5 -5", "5"),
            "6:0 ColumnCount 5 corrections in this line, 11 in all|3 points of 2 corrections");
        row("triples without values", with("OFFSETCOL=5", "OFFSETCOL=5 OUTAXIS3=3"),
            "5:0 ColumnCount 6 corrections in this line, 12 in all|3 points of 3");
        row("no third axis", with("OFFSETCOL=5", "OFFSETCOL=5 OUTAXIS3"),
            "4:22 NotANumber OUTAXIS3|the number of an axis");
        row("a value that is none", with("-5", "- 5"), "6:9 NotANumber -|a correction");
        row("no end", with(":END\n", ""), "0:0 Syntax |:END of the table that begins in line 2");
    }
    void aProblemNamesItsPlace()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, problem);
        const auto reading = family.read(text.toStdString(), {});
        VERIFY_RESULT(reading);
        QVERIFY(reading->tables.empty());
        const std::string found = problemLines(*reading);
        QVERIFY2(found.starts_with(problem.toStdString()), found.c_str());
    }

    void aFileIsRecognisedByItsFirstDirective()
    {
        QCOMPARE(family.recognise(file), Recognition::Certain);
        QCOMPARE(family.recognise(":START 1 SAMPLEDIST=5\n"), Recognition::No);
        QCOMPARE(family.recognise("X,Y\n1,2\n"), Recognition::No);
    }

    void twoMegabytesAreReadWhole()
    {
        std::string text = ":START2D 2 1 1 2 1 1 400\n:START2D POSUNIT=METRIC CORUNIT=METRIC\n";
        for (int j = 0; j < 350; ++j) {
            for (int i = 0; i < 400; ++i)
                text += "0.00123 -0.0012 ";
            text += '\n';
        }
        QVERIFY(text.size() > 2'000'000);
        READ_TABLE(table, family, text + ":END\n", {});
        QCOMPARE(table.pointCount(), std::size_t(140000));
    }
};

AXISCOMP_TEST(TestAerotech2d)

} // namespace tst_aerotech2d

#include "tst_aerotech2d.moc"
