// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_kmotionlinear {

using namespace axiscomp;
using test::problemLines;

namespace {

const TableFormat& format = kmotion_linear::format();

const std::string file = "5\n2\n-180\n0,-180\n1,-178.1\n2,-176.2\n3,-174.1\n4,-172\n";
const auto with = test::changing(file);

const TableReadOptions inDegrees = test::readingWith({{"position-unit", "deg"}});

void describe(test::FormatSample& sample)
{
    sample.facts = "command is published; 1 to 1 dimensions, even knots; "
                   "points 1000000, columns 1, tables 1, bytes 67108864; holds";
    sample.text = file;
    sample.reading = test::readingWith({{"position-unit", "mm"}});
    sample.spareBytes = 1; // the end of the last line
    sample.recognises(Recognition::Certain, {file, "\r\n" + file});
    sample.recognises(Recognition::No,
        {with("5\n", "6\n"), with("5\n", "4\n"), with("1,-178.1", "2,-178.1"), "0,0\n1,0.5\n2,1\n",
            "5\n2\n-180\n-180\n-178.1\n-176.2\n-174.1\n-172\n", "24 -1448819\n0\n2\n3\n",
            "5\n2\n-180\n"});
    sample.warning("a unit that nobody says", file, {"0:0 UnitNotGiven"}, FormatSettings());

    const auto row = sample.problemRow();
    row("no header", "5\n2\n", "0:0 Syntax |a line each for the number of positions");
    row("a count that is none", with("5\n", "5.5\n"), "1:1 NotANumber 5.5|a number of positions");
    row("one position", with("5\n", "1\n"), "1:1 LimitExceeded 1 position|2 to 1000000");
    row("a range of 0", with("\n2\n", "\n0\n"), "2:1 LimitExceeded a range of 0|more than 0");
    row("a negative range", with("\n2\n", "\n-2\n"), "2:1 LimitExceeded a range of -2|");
    row("a start that is none", with("-180\n0", "left\n0"), "3:1 NotANumber left|");
    row("fewer lines", with("4,-172\n", ""), "1:0 MissingPoint 4 positions|5, as the first line");
    row("more lines", file + "5,-170\n", "1:0 Contradiction 6 positions|5, as the first line");
    row("another index", with("2,-176", "3,-176"), "6:1 Contradiction the index 3|2: indices");
    row("an index that is none", with("2,-176", "x,-176"), "6:1 NotANumber x|an index from 0");
    row("a decimal comma", with("-178.1", "-178,1"), "5:0 ColumnCount 3 numbers|index and");
    row("half a number", with("-178.1", "-178.1mm"), "5:3 NotANumber -178.1mm|a position to");
    row("an index alone", with("2,-176.2", "2"), "6:0 ColumnCount 1 number|2, as in the first row");
    row("not finite", with("-178.1", "inf"), "5:3 NotANumber inf|a position to command");
    row("corrections instead of positions", "3\n10\n0\n0,0\n1,0.002\n2,-0.001\n",
        "6:0 NotMonotonic -0.001 after 0.002|strictly increasing positions to command; a list of");
    row("increasing corrections", "3\n10\n0\n0,0\n1,0.1\n2,0.2\n",
        "5:0 Contradiction 0.1 to command, to reach 10|at most half a range away; a list of");
    row("positions without a difference", with("\n2\n-180", "\n1e-30\n-180"),
        "5:0 Contradiction -178.1 to command");

    NeutralTable table = test::commandTable(
        {test::evenAxis("", "mm", -8, 0.5, 33)}, {test::waveColumn("#1", "mm", 33, 0.0)});
    for (std::size_t i = 0; i < 33; ++i)
        table.columns[0].values[i] = static_cast<double>((i * 5) % 7) / 1024.0;
    sample.writes("an axis", {table}).remarking({"positions to command, not corrections"});
    const std::vector axis{test::evenAxis("", "mm", 0, 1, 2)};
    sample
        .writes("corrections in another unit",
            {test::commandTable(axis, {test::columnOf("#1", "um", {250, -500})})})
        .as("2\n1\n0\n0,0.25\n1,0.5\n")
        .becoming(test::commandTable(axis, {test::columnOf("#1", "mm", {0.25, -0.5})}));
    sample.refuses("positions in another order",
        {test::commandTable(axis, {test::columnOf("#1", "mm", {0.5, -0.5})})},
        ErrorCode::FormatCannotHold, "is not larger than the one before");
    sample.refuses("another axis",
        {test::commandTable(
            {test::evenAxis("X", "mm", 0, 1, 2)}, {test::columnOf("Z", "mm", {0, 0})})},
        ErrorCode::FormatCannotHold, "it corrects an axis by its own position");
}

} // namespace

class TestKmotionLinear : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void positionsToCommandBecomeCorrections()
    {
        READ_TABLE(table, format, file, inDegrees);
        QCOMPARE(problemLines(*reading_table), std::string());
        QCOMPARE(table.axes[0].knots, (std::vector<double>{-180, -178, -176, -174, -172}));
        QVERIFY(test::largestDifference(table.columns[0].values, {0, -0.1, -0.2, -0.1, 0}) < 1e-12);
        QVERIFY(std::abs(test::applied(format, table, {-177}) + 0.15) < 1e-12);
        QVERIFY(std::abs(test::applied(format, table, {-400})) < 1e-12);
        QCOMPARE(table.axes[0].unit, std::string("deg"));
    }

    void linesOfThePositionAloneAreRead()
    {
        READ_TABLE(table, format, "3\r\n10\r\n0\r\n0.5\r\n10.25\r\n20\r\n", inDegrees);
        QCOMPARE(table.columns[0].values, (std::vector<double>{0.5, 0.25, 0}));
    }
};

AXISCOMP_TEST(TestKmotionLinear)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_kmotionlinear

#include "tst_kmotionlinear.moc"
