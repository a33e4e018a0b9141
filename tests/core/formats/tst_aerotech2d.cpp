// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_aerotech2d {

using namespace axiscomp;
using test::changed;
using test::problemLines;

namespace {

const TableFormat& format = aerotech_2d::format();

/// Two rows of three points; row axis 2, column axis 1.
const std::string file = "; granite\n"
                         ":START2D 2 1 1 2 10 5 3\n"
                         ":START2D POSUNIT=METRIC CORUNIT=METRIC/1000 OFFSETROW = 20\n"
                         ":START2D OFFSETCOL=5\n"
                         "1 -1  2 -2  3 -3\n"
                         "4 -4  5 -5  6 -6\n"
                         ":END\n";

const auto with = test::changing(file);
const std::string downwards = with("10 5 3", "-10 -5 3");
const std::string rowsDownwards = with("10 5 3", "-10 5 3");
const std::string columnsDownwards = with("10 5 3", "10 -5 3");
const std::string turned = with("OFFSETCOL=5", "OFFSETCOL=5 NEGCOR SERIALNUMBER=12-3");

NeutralTable plane(std::size_t columns)
{
    NeutralTable table = test::commandTable(
        {test::evenAxis("1", "mm", -10.25, 0.7, 4), test::evenAxis("2", "mm", 3, 2.5, 5)}, {});
    for (std::size_t n = 1; n <= columns; ++n)
        table.columns.push_back(
            test::waveColumn(std::to_string(n), "mm", 20, 0.01 * static_cast<double>(n)));
    return table;
}

void describe(test::FormatSample& sample)
{
    sample.facts = "command is published; 2 to 2 dimensions, even knots; "
                   "points any, columns 3, tables any, bytes 67108864; holds units notes";
    sample.text = file;
    sample.comment = "; ";
    sample.spareBytes = 1;
    sample.applies(
        {{{0, -20}, 0.002}, {{5, -10}, -0.006, 1}, {{-2.5, -15}, 0.003}, {{-1e6, 1e6}, 0.004}});
    sample.applies({{{-5, -20}, 0.001}, {{-15, -30}, 0.006}, {{-5, -30}, 0.004}}, downwards);
    sample.applies({{{-5, -30}, 0.004}, {{5, -20}, 0.003}, {{5, -30}, 0.006}}, rowsDownwards);
    sample.applies(
        {{{-5, -10}, 0.004}, {{-15, -20}, 0.003}, {{-15, -10}, 0.006}}, columnsDownwards);
    sample.applies({{{-5, -20}, -0.001}, {{-5, -20}, 0.001, 1}}, turned);
    // values may flow freely
    sample.applies({{{0, -10}, 0.005}}, with("1 -1  2 -2  3 -3\n4 -4", "1 -1\n2 -2 3\n-3 4 -4"));
    sample.warning("nothing to complain of", turned, {});
    sample.warning("two tables of the same axes, which the controller adds", file + file,
        {"0:0 Assumption several tables of 1", "0:0 Assumption several tables of 1"});
    sample.recognises(Recognition::Certain, {file});
    sample.recognises(Recognition::No, {":START 1 SAMPLEDIST=5\n", "X,Y\n1,2\n"});

    sample.writes("pairs", {plane(2)}).within(0, 1e-12);
    sample.writes("several tables", {plane(3), plane(2)}).within(0, 1e-12);
    sample
        .writes("the form of the manual",
            {test::commandTable(
                {test::evenAxis("1", "mm", 0, 5, 2), test::evenAxis("2", "mm", -1, 2, 2)},
                {test::columnOf("1", "mm", {0.25, 0.5, 0.75, 1}),
                    test::columnOf("2", "mm", {-0.25, -0.5, -0.75, -1})})})
        .as(":START2D 2 1 1 2 2 5 2\n:START2D POSUNIT=METRIC CORUNIT=METRIC\n"
            ":START2D OFFSETROW=1 OFFSETCOL=0\n0.25 -0.25  0.5 -0.5\n"
            "0.75 -0.75  1 -1\n:END\n");
    sample.writes("a single column gets a second one of zeros", {plane(1)})
        .becoming(changed(plane(1),
            [](NeutralTable& table) {
                table.columns.push_back(test::columnOf("2", "mm", std::vector(20, 0.0)));
            }))
        .within(0, 1e-12);
    sample
        .writes("a rotary axis",
            {changed(plane(2),
                [](NeutralTable& table) { table.axes[1].unit = table.columns[1].unit = "deg"; })})
        .readWith({{"rotary-axes", "2"}})
        .within(1e-12);
    const NeutralTable named = changed(plane(2), [](NeutralTable& table) {
        table.axes[0].name = table.columns[0].target = "X";
        table.axes[1].name = "Y";
        table.columns[1].target = "Z";
    });
    sample.refuses("axes that are no numbers", {named}, ErrorCode::InvalidArgument, "column-axis");
    sample.refuses("one axis as both sources", {plane(2)}, ErrorCode::InvalidArgument,
        "both sources are axis 1: column-axis and row-axis", FormatSettings{{"row-axis", "1"}});
    sample.writes("axes that are no numbers", {named})
        .with({{"column-axis", "5"}, {"row-axis", "6"}, {"output-axis-2", "7"}})
        .containing({":START2D 6 5 5 7 "})
        .becoming(changed(plane(2),
            [](NeutralTable& table) {
                table.axes[0].name = table.columns[0].target = "5";
                table.axes[1].name = "6";
                table.columns[1].target = "7";
            }))
        .within(0, 1e-12);

    const auto row = sample.problemRow();
    row("one dimension", ":START 1 SAMPLEDIST=5\n1 2\n:END\n", "1:1 Syntax :START|:START2D or");
    row("six numbers", with("10 5 3", "10 5"), "2:1 Syntax :START2D 2 1 1 2 10 5|7 numbers");
    row("axis 0", with("2 1 1 2", "2 1 0 2"), "2:14 LimitExceeded axis 0|the number of an axis");
    row("one axis twice", with("2 1 1 2", "1 1 1 2"), "2:12 Contradiction axis 1 for rows and");
    row("distance 0", with("10 5 3", "10 0 3"), "2:21 LimitExceeded a distance of 0|");
    row("one column", with("10 5 3", "10 5 1"), "2:23 LimitExceeded 1 column|at least 2");
    row("absurd columns", with("10 5 3", "10 5 1000000000"),
        "5:0 ColumnCount 6 corrections in this line, 12 in all|1000000000 points of 2");
    row("columns not whole", with("10 5 3", "10 5 2.5"),
        "2:23 NotANumber 2.5|the number of columns");
    row("one row", with("4 -4  5 -5  6 -6\n", ""), "2:0 TooFewPoints 1 row|at least 2");
    row("no values", with("1 -1  2 -2  3 -3\n4 -4  5 -5  6 -6\n", ""),
        "2:0 TooFewPoints 0 rows|at least 2");
    row("a value is missing", with("5 -5", "5"),
        "6:0 ColumnCount 5 corrections in this line, 11 in all|3 points of 2 corrections");
    row("triples without values", with("OFFSETCOL=5", "OFFSETCOL=5 OUTAXIS3=3"),
        "5:0 ColumnCount 6 corrections in this line, 12 in all|3 points of 3");
    row("no third axis", with("OFFSETCOL=5", "OFFSETCOL=5 OUTAXIS3"),
        "4:22 NotANumber OUTAXIS3|the number of an axis");
    row("a value that is none", with("-5", "- 5"), "6:9 NotANumber -|a correction");
    row("decimal commas of one row that fit the count",
        with("1 -1  2 -2  3 -3\n4 -4  5 -5  6 -6\n", "1,5 -1,5  2,5 -2,5  3,5 -3,5\n"),
        "5:1 NotANumber 1,5|decimal points, and blanks between the numbers");
    row("NEGCOR with a value", with("OFFSETCOL=5", "OFFSETCOL=5 NEGCOR = FALSE"),
        "4:31 Syntax FALSE|NEGCOR without a value, or no NEGCOR");
    row("no end", with(":END\n", ""), "0:0 Syntax |:END of the table that begins in line 2");
}

} // namespace

class TestAerotech2d : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theLinesGoAlongTheRowAxisAndThePointsAlongTheColumnAxis()
    {
        READ_TABLE(table, format, file, {});
        QCOMPARE(table.axes[0].name, std::string("1"));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{-5, 0, 5}));
        QCOMPARE(table.axes[1].name, std::string("2"));
        QCOMPARE(table.axes[1].knots, (std::vector<double>{-20, -10}));
        QCOMPARE(table.notes, (std::vector<std::string>{"granite"}));
        QVERIFY2(reading_table->diagnostics.empty(), problemLines(*reading_table).c_str());
    }

    void eachPointHasAPairOfCorrections()
    {
        READ_TABLE(table, format, file, {});
        QCOMPARE(table.columns.size(), std::size_t(2));
        QCOMPARE(table.columns[0].target, std::string("1"));
        QCOMPARE(table.columns[1].target, std::string("2"));
    }

    void aThirdOutputMakesTriples()
    {
        READ_TABLE(table, format,
            ":START2D 2 1 1 2 10 5 2\n:START2D OUTAXIS3=3 POSUNIT=METRIC CORUNIT=METRIC\n"
            "1 2 3 4 5 6\n7 8 9 10 11 12\n:END\n",
            {});
        QCOMPARE(table.columns.size(), std::size_t(3));
        QCOMPARE(table.columns[2].target, std::string("3"));
        QCOMPARE(table.columns[2].values, (std::vector<double>{3, 6, 9, 12}));
    }

    void negativeDistancesCountDownwards()
    {
        READ_TABLE(table, format, downwards, {});
        QCOMPARE(table.axes[0].knots, (std::vector<double>{-15, -10, -5}));
        QCOMPARE(table.axes[1].knots, (std::vector<double>{-30, -20}));
    }
};

AXISCOMP_TEST(TestAerotech2d)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_aerotech2d

#include "tst_aerotech2d.moc"
