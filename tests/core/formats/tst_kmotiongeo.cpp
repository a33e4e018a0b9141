// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_kmotiongeo {

using namespace axiscomp;
using test::changed;
using test::problemLines;

namespace {

const TableFormat& format = kmotion_geo::format();

const TableReadOptions inInches = test::readingWith({{"unit", "inch"}});

/// The four corners of a square, each to be commanded where the next one is.
const std::string square = "2,2\n"
                           "1,1\n"
                           "-0.5,-0.5\n"
                           "0,0,-1, 0, 0\n"
                           "0,1, 0,-1, 0\n"
                           "1,0, 0, 1, 0\n"
                           "1,1, 1, 0, 0\n";

/// Not square: two rows of Y, three columns of X, in the manner of a machine that was measured.
const std::string measured = "2,3\n"
                             "20,10\n"
                             "-20,5\n"
                             "0,0,-19.9975,5.001,0.00125\n"
                             "0,1,0.0015,4.9985,-0.0005\n"
                             "0,2,20.0025,5.0005,0.002\n"
                             "1,0,-19.998,15.0015,0\n"
                             "1,1,-0.001,15.0005,0.001\n"
                             "1,2,20.001,14.9975,-0.0015\n";

const auto with = test::changing(measured);

NeutralTable fullTable(std::size_t columns, std::size_t rows)
{
    NeutralTable table = test::commandTable(
        {test::evenAxis("X", "mm", -64, 0.5, columns), test::evenAxis("Y", "mm", 8, 2, rows)}, {});
    for (const char* target : {"X", "Y", "Z"})
        table.columns.push_back(test::waveColumn(target, "mm", table.pointCount(), 0.0));
    // Numbers that are exact beside the positions.
    for (std::size_t n = 0; n < 3; ++n)
        for (std::size_t i = 0; i < table.pointCount(); ++i)
            table.columns[n].values[i] =
                static_cast<double>((i * (2 * n + 3)) % 17) / 1024.0 - 1.0 / 128.0;
    return table;
}

void describe(test::FormatSample& sample)
{
    sample.facts = "command is read in program code; 2 to 2 dimensions, even knots; "
                   "points 16000000, columns 3, tables 1, bytes 67108864; holds names units";
    sample.text = measured;
    sample.reading = test::readingWith({{"unit", "mm"}});
    sample.writing = test::writingWith({{"unit", "mm"}});
    sample.spareBytes = 6; // of the last number
    sample.recognises(Recognition::Certain, {square, measured, "\n" + measured + "made in May\n"});
    sample.recognises(Recognition::No,
        {"1 2\n0 1\n1 1\n", "5\n2\n-180\n0,-180\n1,-178\n2,-176\n3,-174\n4,-172\n",
            with("2,3", "1,3"), with("2,3", "2,4001"), with("0,0,-19", "2,0,-19"),
            with("0,0,-19", "0,3,-19"), "0,0\n1,0.5\n2,1\n"});
    // By hand, from the numbers of the four corners of a cell.
    sample.applies({{{-20, 5}, 0.0025}, {{-20, 5}, 0.00125, 2}, {{20, 15}, -0.0025, 1},
        {{10, 7.5}, (0.0015 + 0.0025) / 2 * 0.75 + (-0.001 + 0.001) / 2 * 0.25},
        {{-10, 10}, (0.00125 - 0.0005 + 0.0 + 0.001) / 4, 2},
        // Beyond the ends the cell there goes on, along X, along Y, and along both.
        {{40, 5}, 0.002 + (0.002 + 0.0005), 2}, {{-20, 25}, 0.0 - 0.00125, 2},
        {{-30, 0}, 0.0034375, 2}});
    // The example of the specification: at (2, 0) the machine is sent to (2, -2).
    sample.applies({{{2, 0}, 0.0}, {{2, 0}, -2.0, 1}, {{2, 0}, 0.0, 2}, {{-0.5, -0.5}, -0.5},
                       {{-0.5, -0.5}, 0.5, 1}},
        square);
    sample.warning("a unit that nobody says", measured,
        {"0:0 UnitNotGiven numbers without a unit, taken to be inch|the setting unit"},
        FormatSettings());
    sample.warning("more than the points", measured + "0,0,1,1,1\n",
        {"10:1 LeftOut further numbers behind the last point|6 points"});

    sample.refusesReading("another unit", {{"unit", "foot"}}, "the setting unit is \"foot\"");
    const auto row = sample.problemRow();
    const std::string sizes = "Invalid Geometric Correction File (NRows and NCols)";
    const std::string spacing = "Invalid Geometric Correction File (GeoSpacingX and GeoSpacingY)";
    const std::string offset = "Invalid Geometric Correction File (GeoOffsetX and GeoOffsetY)";
    const std::string point = "Invalid Geometric Correction File (invalid data value)";
    row("no distances", "2,3\n", "0:0 Syntax |rows and columns, distances", sizes);
    row("one row", with("2,3", "1,3"), "1:1 LimitExceeded 1|a number of rows or columns, 2 to 4000",
        sizes);
    row("too many columns", with("2,3", "2,4001"), "1:3 LimitExceeded 4001|", sizes);
    row("rows are no whole number", with("2,3", "2.0,3"), "1:1 NotANumber 2.0|", sizes);
    row("a blank before the comma", with("2,3", "2 ,3"),
        "1:2 Syntax  ,3|a comma directly behind the number \"2\"", sizes);
    row("no comma", with("20,10", "20 10"), "2:3 Syntax", spacing);
    row("a distance of 0", with("20,10", "20,0"), "2:4 LimitExceeded a distance of 0|", spacing);
    row("a distance that is none", with("20,10", "x,10"), "2:1 NotANumber x|", spacing);
    row("a start that is none", with("-20,5", "-20,nan"), "3:5 NotANumber nan|", offset);
    row("a decimal comma", with("5.001,0.00125", "5,001,0,00125"), "4:1", point);
    row("a missing number", with("4.9985,-0.0005", "4.9985,,-0.0005"), "5:", point);
    row("half a number", with("15.0015", "15.0015mm"), "7:13 NotANumber 15.0015mm|", point);
    row("a row that is none", with("1,2,20.001", "2,2,20.001"),
        "9:1 LimitExceeded 2|the number of a row, 0 to 1", point);
    row("a column that is none", with("1,2,20.001", "1,-1,20.001"),
        "9:3 LimitExceeded -1|the number of a column, 0 to 2", point);
    row("cut off", measured.substr(0, measured.find("1,1,-0.001")),
        "7:0 MissingPoint no line for 2 points, the first of them row 1, column 1|a line for each "
        "of the 2 x 3 points",
        point);
    row("a point twice", with("1,1,-0.001", "1,0,-0.001"),
        "9:0 MissingPoint no line for row 1, column 1|a line for each of the 2 x 3 points", point);
    row("a thousand million points", "4000,4000\n1,1\n0,0\n0,0,0,0,0\n",
        "4:0 MissingPoint no line for 15999999 points", point);
    row("positions without a difference", with("20,10\n-20,5", "1e-30,10\n-20,5"),
        "0:0 NotFinite positions of X|");

    const NeutralTable full = fullTable(200, 3);
    sample.writes("all three axes", {full})
        .remarking({"the numbers of the file are in mm", "Geo File in the tool setup",
            "plane Z = 0 only"});
    NeutralTable plane = fullTable(2, 3);
    plane.columns.erase(plane.columns.begin(), plane.columns.begin() + 2);
    sample.writes("Z alone", {plane})
        .containing({"3,2\n0.5,2\n-64,8\n0,0,-64,8,-0.0078125\n0,1,-63.5,8,"})
        .becoming(changed(plane, [](NeutralTable& table) {
            for (const char* target : {"X", "Y"})
                table.columns.push_back(
                    test::columnOf(target, "mm", std::vector<double>(table.pointCount())));
        }));
    NeutralTable inches = fullTable(2, 2);
    inches.axes = {test::evenAxis("1", "inch", 0, 1, 2), test::evenAxis("2", "inch", 2, 1, 2)};
    inches.columns = {test::columnOf("other", "inch", {0, 0.25, 0.5, 1})};
    sample.writes("inches, axes by their position", {inches})
        .with({})
        .readWith({{"unit", "inch"}})
        .as("2,2\n1,1\n0,2\n0,0,0,2,0\n0,1,1,2,0.25\n1,0,0,3,0.5\n1,1,1,3,1\n")
        .becoming(changed(inches, [](NeutralTable& table) {
            table.axes[0].name = "X";
            table.axes[1].name = "Y";
            table.columns = {test::columnOf("Z", "inch", {0, 0.25, 0.5, 1}),
                test::columnOf("X", "inch", {0, 0, 0, 0}),
                test::columnOf("Y", "inch", {0, 0, 0, 0})};
        }));
    const auto refuses = [&](const char* name, ErrorCode code, const char* reason,
                             const auto& change) {
        sample.refuses(name, {changed(fullTable(3, 2), change)}, code, reason);
    };
    refuses("another axis", ErrorCode::FormatCannotHold, "it corrects X, Y and Z",
        [](NeutralTable& table) { table.columns[2].target = "A"; });
    refuses("two columns for Z", ErrorCode::FormatCannotHold, "two columns go from",
        [](NeutralTable& table) { table.columns[1].target = "other"; });
    refuses("sources the other way round", ErrorCode::FormatCannotHold, "exchange the sources",
        [](NeutralTable& table) { std::swap(table.axes[0].name, table.axes[1].name); });
    refuses("no target", ErrorCode::TargetNotKnown, "",
        [](NeutralTable& table) { table.columns[0].target.clear(); });
    refuses("an angle", ErrorCode::InvalidArgument, "cannot be given in mm",
        [](NeutralTable& table) { table.axes[0].unit = "deg"; });
    sample.refuses("too many columns", {fullTable(4001, 2)}, ErrorCode::FormatCannotHold,
        "4001 points along X");
}

} // namespace

class TestKmotionGeo : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void rowsGoAlongYAndColumnsAlongX()
    {
        READ_TABLE(table, format, measured, inInches);
        QCOMPARE(problemLines(*reading_table), std::string());
        QCOMPARE(table.axes[0].knots, (std::vector<double>{-20, 0, 20}));
        QCOMPARE(table.axes[1].knots, (std::vector<double>{5, 15}));
        QCOMPARE(table.axes[0].unit, std::string("inch"));
        QCOMPARE(table.columns.size(), std::size_t{3});
        QVERIFY(test::largestDifference(
                    table.columns[0].values, {0.0025, 0.0015, 0.0025, 0.002, -0.001, 0.001})
            < 1e-14);
        QVERIFY(test::largestDifference(
                    table.columns[1].values, {0.001, -0.0015, 0.0005, 0.0015, 0.0005, -0.0025})
            < 1e-14);
        QCOMPARE(table.columns[2].values,
            (std::vector<double>{0.00125, -0.0005, 0.002, 0, 0.001, -0.0015}));
        QVERIFY(ownAxis(table, table.columns[0]) == std::optional<std::size_t>(0));
        QVERIFY(ownAxis(table, table.columns[1]) == std::optional<std::size_t>(1));
        QVERIFY(!ownAxis(table, table.columns[2]));
    }

    void theNumbersOfALineSayWhereItsPointIs()
    {
        const std::string shuffled = "2,2\n1,1\n0,0\n1,1,1,1,4\n0,0,0,0,1\n1,0,0,1,3\n0,1,1,0,2\n";
        READ_TABLE(table, format, shuffled, inInches);
        QCOMPARE(table.columns[2].values, (std::vector<double>{1, 2, 3, 4}));
    }

    void aNegativeDistanceIsTurnedRound()
    {
        const std::string text =
            "2,3\n-20,10\n20,5\n0,0,20,5,1\n0,1,0,5,2\n0,2,-20,5,3\n1,0,20,15,4\n1,1,0,15,5\n"
            "1,2,-20,15,6\n";
        READ_TABLE(table, format, text, inInches);
        QCOMPARE(table.axes[0].knots, (std::vector<double>{-20, 0, 20}));
        QCOMPARE(table.columns[2].values, (std::vector<double>{3, 2, 1, 6, 5, 4}));
        QCOMPARE(table.columns[0].values, std::vector<double>(6, 0.0));
    }

    void numbersStandAsTheControllerReadsThem()
    {
        // Commas behind numbers, line ends and blanks before them, and two groups in one line.
        const std::string text =
            "\xEF\xBB\xBF"
            "2,\r2 1,\t1\r0, 0\r0,0,0,0,\r\r1 0,1,1,0,2\r1,0,0,1,3 1,1,1,1,4\r";
        READ_TABLE(table, format, text, inInches);
        QCOMPARE(table.columns[2].values, (std::vector<double>{1, 2, 3, 4}));
    }

    void millimetresAreSaid()
    {
        READ_TABLE(table, format, measured, test::readingWith({{"unit", "mm"}}));
        QCOMPARE(table.axes[1].unit, std::string("mm"));
        QCOMPARE(table.columns[2].unit, std::string("mm"));
        const auto feet = format.read(measured, test::readingWith({{"unit", "foot"}}));
        VERIFY_ERROR(feet, ErrorCode::InvalidArgument);
    }
};

AXISCOMP_TEST(TestKmotionGeo)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_kmotiongeo

#include "tst_kmotiongeo.moc"
