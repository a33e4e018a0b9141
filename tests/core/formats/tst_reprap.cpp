// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_reprap {

using namespace axiscomp;
using test::applied;
using test::problemLines;

namespace {

const TableFormat& format = reprap::format();

const std::string title = "RepRapFirmware height map file v2 generated at 2021-04-05 06:07, mean "
                          "error 0.010, deviation 0.002\n";
const std::string oldLabels = "xmin,xmax,ymin,ymax,radius,xspacing,yspacing,xnum,ynum\n";
const std::string newLabels =
    "axis0,axis1,min0,max0,min1,max1,radius,spacing0,spacing1,num0,num1\n";
const std::string heights = "  0.100, -0.200,  0.000\n  0.300,  0.400,  0.500\n";

std::string oldFile(const std::string& parameters, const std::string& rows)
{
    return title + oldLabels + parameters + '\n' + rows;
}
const std::string parameters = "10.00,115.00,20.00,220.00,-1.00,50.00,200.00,3,2";

void describe(test::FormatSample& sample)
{
    sample.facts = "command is read in program code; 2 to 2 dimensions, even knots; "
                   "points any, columns 1, tables 1, bytes 67108864; holds names units notes";
    sample.text = oldFile(parameters, heights);
    sample.spareBytes = 4; // of the last number
    sample.applies({{{60, 20}, double(-0.2F)}, {{10, 220}, double(0.3F)},
        {{-50, -50}, double(0.1F)}, {{500, 500}, double(0.5F)}});
    // One spacing for both axes, and a line that somebody has added.
    sample.applies({{{60, 20}, double(-0.2F)}, {{10, 70}, double(0.3F)}},
        title
            + "xmin,xmax,ymin,ymax,radius,spacing,xnum,ynum\n10.00,115.00,20.00,70.00,-1.00,50.00,"
              "3,2\n"
            + heights + "\nsaved by hand\n");
    sample.recognises(Recognition::Certain,
        {oldFile(parameters, heights), "RepRapFirmware height map file v1\n"});
    sample.recognises(Recognition::No, {"RepRapFirmware probe points file v2\n", "0,1\n1,1\n"});

    const auto row = sample.problemRow();
    row("other title", "X,Y\n1,2\n", "1:0 Syntax X,Y|the line RepRapFirmware height map");
    row("version 1", "RepRapFirmware height map file v1\n" + oldLabels + parameters,
        "1:0 Syntax version 1 of the height map|version 2, which newer firmware writes");
    row("title only", title, "2:0 Syntax |the line xmin");
    row("other labels", title + "xmin,xmax\n1,2\n", "2:0 Syntax xmin,xmax|the line xmin");
    row("no parameters", title + oldLabels, "3:0 ColumnCount 1 entry|9: xmin");
    row("parameters cut off", title + oldLabels + "10.00,115.00,2",
        "3:0 ColumnCount 3 entries|9: xmin");
    row("the other header's parameters", title + newLabels + parameters + '\n' + heights,
        "3:0 ColumnCount 9 entries|11: axis0");
    row("parameter is none", oldFile("10.00,x,20,220,-1,50,200,3,2", heights),
        "3:7 NotANumber x|a number for xmax");
    row("parameter is not finite", oldFile("10,inf,20,220,-1,50,200,3,2", heights),
        "3:4 NotANumber inf|a number for xmax");
    row("count is none", oldFile("10,115,20,220,-1,50,200,3.0,2", heights),
        "3:25 NotANumber 3.0|a number of points");
    row("one point", oldFile("10,115,20,220,-1,50,200,1,2", heights),
        "3:0 TooFewPoints X from 10 to 115 by 50 in 1 points|at least 2");
    row("a thousand million points",
        oldFile("10,115,20,220,-1,50,200,1000000000,1000000000", heights),
        "3:0 Contradiction X from 10 to 115 by 50 in 1000000000 points|as many");
    row("a thousand million points that fit",
        oldFile("0,999999999,0,999999999,-1,1,1,1000000000,1000000000", heights),
        "4:0 ColumnCount 3 heights|1000000000, one for each position of X");
    row("too few points for the range", oldFile("10,310,20,220,-1,50,200,3,2", heights),
        "3:0 Contradiction X from 10 to 310 by 50 in 3 points|as many");
    row("no spacing", oldFile("10,115,20,220,-1,0,200,3,2", heights),
        "3:0 Contradiction X from 10 to 115 by 0 in 3 points|as many");
    row("no range", oldFile("10,115,220,20,-1,50,200,3,2", heights),
        "3:0 Contradiction Y from 220 to 20 by 200 in 2 points|as many");
    row("one axis twice", title + newLabels + "X,X," + parameters + '\n' + heights,
        "3:0 Contradiction the axes \"X\" and \"X\"|two different letters");
    row("line too short", oldFile(parameters, "0.1,0.2\n0.1,0.2,0.3\n"),
        "4:0 ColumnCount 2 heights|3, one for each position of X");
    row("line too long", oldFile(parameters, "0.1,0.2,0.3,0.4\n0.1,0.2,0.3\n"),
        "4:0 ColumnCount 4 heights|3, one for each position of X");
    row("height is none", oldFile(parameters, "0.1, a,0.3\n0.1,0.2,0.3\n"),
        "4:6 NotANumber a|a height in mm");
    row("height is missing", oldFile(parameters, "0.1,,0.3\n0.1,0.2,0.3\n"),
        "4:5 NotANumber |a height in mm");
    row("too few lines", oldFile(parameters, "0.1,0.2,0.3\n"),
        "0:0 MissingPoint 1 line of heights|2, one for each position of Y");
    row("too many lines", oldFile(parameters, heights + "0.1,0.2,0.3\n"),
        "6:0 Contradiction a further line after 2|2 lines of heights");
}

} // namespace

class TestReprap : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aFileOfEachHeaderIsRead_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("names");
        QTest::newRow("until 3.2")
            << QByteArray::fromStdString(oldFile(parameters, heights)) << QByteArray("XY");
        QTest::newRow("from 3.3") << QByteArray::fromStdString(
            title + newLabels + "U,Z," + parameters + "\r\n" + heights)
                                  << QByteArray("UZ");
        QTest::newRow("further labels") << QByteArray::fromStdString(title
            + "xmin,xmax,ymin,ymax,radius,xspacing,yspacing,"
              "xnum,ynum,more\n"
            + parameters + '\n' + heights)
                                        << QByteArray("XY");
    }
    void aFileOfEachHeaderIsRead()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, names);
        READ_TABLE(table, format, text.toStdString(), {});
        QCOMPARE(problemLines(*reading_table), std::string());
        QCOMPARE(table.axes[0].name + table.axes[1].name, names.toStdString());
        QCOMPARE(table.axes[0].unit, std::string("mm"));
        QCOMPARE(table.columns[0].unit, std::string("mm"));
        QCOMPARE(table.columns[0].target, std::string("Z"));
        QCOMPARE(table.axes[1].knots, (std::vector<double>{20, 220}));
        QCOMPARE(table.columns[0].values, (std::vector<double>{0.1, -0.2, 0, 0.3, 0.4, 0.5}));
    }

    void positionsGoByTheSpacingAndMayEndBeforeTheMaximum()
    {
        READ_TABLE(table, format, oldFile(parameters, heights), {});
        QCOMPARE(table.axes[0].knots, (std::vector<double>{10, 60, 110}));
    }

    void theHeightsAreLookedUpAtXAndYWhichStay()
    {
        READ_TABLE(table, format, oldFile(parameters, heights), {});
        QVERIFY(std::abs(applied(format, table, {85, 120}) - 0.175) < 1e-7); // of float32
        QVERIFY(!ownAxis(table, table.columns[0]));
    }

    void theTitleIsKeptAsANote()
    {
        READ_TABLE(table, format, oldFile(parameters, heights), {});
        QCOMPARE(table.notes,
            (std::vector<std::string>{
                "generated at 2021-04-05 06:07, mean error 0.010, deviation 0.002"}));
    }

    void pointsThatWereNotProbedAreFilledOnlyWhenAsked()
    {
        const std::string wayOut = "a height with decimals; points without a value can be filled "
                                   "or left out (--fill, --crop, or Missing points in the "
                                   "import)\n";
        const auto reading = format.read(
            oldFile(parameters, "  0.100,      0,  0.000\n      0,  0.400,  -0.500\n"), {});
        VERIFY_RESULT(reading);
        QVERIFY(reading->tables.empty());
        QCOMPARE(problemLines(*reading),
            "4:2 MissingPoint a point that was not probed at X = 60, Y = 20|" + wayOut
                + "5:1 MissingPoint a point that was not probed at X = 10, Y = 220|" + wayOut);
        TableReadOptions options;
        options.missing = MissingPoints::Nearest;
        const auto filled = format.read(
            oldFile(parameters, "  0.100,      0,  0.000\n      0,  0.400,  -0.500\n"), options);
        VERIFY_RESULT(filled);
        QCOMPARE(filled->tables.size(), 1U);
        const CompensationColumn& column = filled->tables.front().columns.front();
        QCOMPARE(column.filled, (std::vector<std::uint32_t>{1, 3}));
        QCOMPARE(column.values, (std::vector<double>{0.1, 0.1, 0, 0.4, 0.4, -0.5}));
        READ_TABLE(zero, format, oldFile(parameters, "0.000,0.0,-0.000\n0.,1,2\n"), {});
        QCOMPARE(zero.columns[0].values[0], 0.0);
    }

    void aSpacingIsKnownToTwoDecimals()
    {
        READ_TABLE(table, format,
            oldFile("0.00,200.00,0.00,100.01,-1.00,66.67,33.34,4,4",
                "0.1,0.1,0.1,0.1\n0.1,0.1,0.1,0.1\n0.1,0.1,0.1,0.1\n0.1,0.1,0.1,0.1\n"),
            {});
        QCOMPARE(table.axes[0].knots.back(), 3 * 66.67);
    }

    void twoMegabytesAreReadWhole()
    {
        std::string rows;
        for (int y = 0; y < 500; ++y)
            for (int x = 0; x < 500; ++x)
                rows += x == 499 ? "  0.012\n" : " -0.012,";
        READ_TABLE(table, format, oldFile("0,499,0,499,-1,1,1,500,500", rows), {});
        QCOMPARE(table.pointCount(), std::size_t(250000));
    }
};

AXISCOMP_TEST(TestReprap)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_reprap

#include "tst_reprap.moc"
