// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_pmac2d {

using namespace axiscomp;
using test::applied;
using test::changed;

namespace {

const TableFormat& format = pmac_2d::format();

/// 2 rows and 3 columns of intervals: 4 x 3 points, the first of which has no entry.
const std::string file = "#3\nDEFINE COMP 2.3,#1D,#2D,#3,3000,4000\n"
                         "16 32 0\n"
                         "48 64 80 48\n"
                         "0 16 32 0\n";

const auto with = test::changing(file);

const TableReadOptions inMillimetres =
    test::readingWith({{"counts-per-unit", "1000"}, {"position-unit", "mm"}, {"value-unit", "mm"}});
const TableWriteOptions thousand = test::writingWith({{"counts-per-unit", "1000"}});

/// Symmetric ranges round 0, where the value is 0.
NeutralTable plane()
{
    NeutralTable table = test::commandTable(
        {test::evenAxis("1", "mm", -10, 5, 5), test::evenAxis("2", "mm", -4, 2, 6)},
        {test::waveColumn("3", "mm", 30, 0.05)});
    table.columns[0].values[2 + 2 * 5] = 0;
    return table;
}

void describe(test::FormatSample& sample)
{
    sample.facts = "command is assumed; 2 to 2 dimensions, even knots; "
                   "points any, columns 1, tables 1, bytes 67108864; holds notes wrap";
    sample.text = file;
    sample.reading = inMillimetres;
    sample.writing = thousand;
    sample.comment = "; ";
    sample.spareBytes = 1;
    sample.applies({{{0, 0}, 0.0}, {{1, 0}, 0.001}, {{0, 2}, 0.003}, {{2, 2}, 0.005},
        {{1, 1}, 0.0025}, {{4, 5}, 0.0025}, {{-2, -2}, 0.004}});
    sample.warning("two tables for one motor, which the controller adds",
        file + "#4\nDEFINE COMP 1.1,#1D,#4D,#3,3000,4000\n0 0 0\n",
        {"0:0 Assumption several tables of 1, 2 to 3, 1, 4 to 3|their sum, since"});
    sample.recognises(Recognition::Certain, {file});
    sample.recognises(Recognition::No, {"DEFINE COMP 4,#1,#2,10\n"});
    sample.recognises(Recognition::Possible, {file + "DEFINE COMP 4,#1,#2,10\n"});

    NeutralTable rolling =
        test::commandTable({test::evenAxis("1", "mm", 0, 1, 4), test::evenAxis("2", "mm", 0, 2, 3)},
            {test::columnOf(
                "3", "mm", {0, 0.001, 0.002, 0, 0.003, 0.004, 0.005, 0.003, 0, 0.001, 0.002, 0})});
    rolling.axes[0].wrap = 3;
    rolling.axes[1].wrap = 4;
    const NeutralTable flat = changed(rolling,
        [](NeutralTable& table) { table.axes[0].wrap = table.axes[1].wrap = std::nullopt; });
    sample.writes("from 0", {flat}).becoming(rolling).as(file);
    sample.writes("a table that rolls over", {rolling}).as(file);
    NeutralTable zero = plane();
    zero.columns[0].values[2 + 2 * 5] = 0.5;
    sample.refuses("a value at 0", {zero}, ErrorCode::FormatCannotHold);
    sample.refuses("one motor as both sources", {plane()}, ErrorCode::InvalidArgument,
        "both sources are axis 1: row-motor and column-motor",
        FormatSettings{{"counts-per-unit", "1000"}, {"column-motor", "1"}});
    NeutralTable letter = plane();
    letter.axes[1].name = "Y";
    sample.refuses(
        "axes that are no numbers", {letter}, ErrorCode::InvalidArgument, "column-motor");

    const auto row = sample.problemRow();
    row("one dimension", "DEFINE COMP 2,#1,#2,100\n1 0\n", "warning 1:1 Assumption a table of one");
    row("truncated", with("0 16 32 0\n", "0 16\n"), "2:0 MissingPoint 9 entries|11, as DEFINE");
    row("too many", with("0 16 32 0\n", "0 16 32 0 5\n"), "5:0 Contradiction 12 entries|11");
    row("no second span", with("3000,4000", "3000"), "2:1 Syntax DEFINE COMP 2.3");
    row("no rows", with("2.3,", "0.3,"), "2:13 LimitExceeded 0 entries");
    row("no columns", with("2.3,", "2.,"), "2:15 NotANumber |a number of entries");
    row("absurd", with("2.3,", "900000.900000,"), "2:0 MissingPoint 11 entries|810001800000");
    row("one motor as both sources", with("#2D,#3", "#1D,#3"),
        "2:1 Contradiction DEFINE COMP 2.3,#1D,#1D,#3,3000,4000|another axis than that of the "
        "first source");
    row("the addressed motor as both sources", with("#1D,#2D,#3", "#3D"),
        "2:1 Contradiction DEFINE COMP 2.3,#3D,3000,4000|another axis");
    row("four motors", with("#3,3000", "#3,#4,3000"), "2:1 Syntax DEFINE COMP");
}

} // namespace

class TestPmac2d : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void alongARowTheRowMotorMovesAndTheFirstEntryIsLeftOut()
    {
        READ_TABLE(table, format, file, inMillimetres);
        QCOMPARE(table.axes[0].name, std::string("1"));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{0, 1, 2, 3}));
        QCOMPARE(table.axes[1].name, std::string("2"));
        QCOMPARE(table.axes[1].knots, (std::vector<double>{0, 2, 4}));
        QCOMPARE(table.columns[0].target, std::string("3"));
    }

    void motorsThatAreNotNamedAreTheAddressedOne()
    {
        READ_TABLE(one, format, with("#1D,#2D,#3", "#1"), inMillimetres);
        QCOMPARE(one.axes[0].name, std::string("1"));
        QCOMPARE(one.axes[1].name, std::string("3"));
        QCOMPARE(one.columns[0].target, std::string("3"));
        READ_TABLE(two, format, with("#1D,#2D,#3", "#5,#6"), inMillimetres);
        QCOMPARE(two.axes[1].name, std::string("6"));
        QCOMPARE(two.columns[0].target, std::string("3"));
    }

    void eachMotorMayHaveItsOwnCounts()
    {
        TableReadOptions options = inMillimetres;
        options.settings["column-counts-per-unit"] = "500";
        options.settings["target-counts-per-unit"] = "100";
        READ_TABLE(table, format, file, options);
        QCOMPARE(table.axes[0].knots[1], 1.0);
        QCOMPARE(table.axes[1].knots[1], 4.0);
        QCOMPARE(applied(format, table, {1, 0}), 0.01);
    }

    void aMotorHasOneUnitForItsOneNumberOfCounts()
    {
        TableReadOptions options = inMillimetres;
        options.settings["value-unit"] = "um";
        READ_TABLE(another, format, file, options);
        QCOMPARE(another.columns[0].unit, std::string("um"));
        const auto refused = format.read(with("#2D,#3", "#2D,#2"), options);
        VERIFY_RESULT(refused);
        QVERIFY(test::mentions(test::problemLines(*refused),
            "0:0 Contradiction positions in mm and values in um|one unit"));
        options.settings["column-counts-per-unit"] = "1000000";
        VERIFY_RESULT(format.read(with("#2D,#3", "#2D,#2"), options));
        READ_TABLE(counted, format, with("#2D,#3", "#2D,#2"), options);
        QCOMPARE(counted.columns[0].target, std::string("2"));
    }

    void whatIsWrittenCorrectsTheSame()
    {
        const NeutralTable table = plane();
        WRITE_TABLE(written, format, table, thousand);
        QVERIFY(written->bytes.starts_with("#3\nDEFINE COMP 6.5,#1D,#2D,#3,25000,12000\n"));
        READ_TABLE(again, format, written->bytes, inMillimetres);
        QCOMPARE(again, written->held.front());
        for (double y = -4; y <= 6; y += 0.5)
            for (double x = -10; x <= 10; x += 1.25)
                QVERIFY(std::abs(applied(format, again, {x, y}) - applied(format, table, {x, y}))
                    <= 0.5 / 16000 + 1e-9);
    }

    void eachSourceKeepsItsUnit()
    {
        NeutralTable table = plane();
        table.axes[1].unit = "inch";
        WRITE_TABLE(written, format, table, thousand);
        QCOMPARE(written->held.at(0).axes.at(0).unit, std::string("mm"));
        QCOMPARE(written->held.at(0).axes.at(1).unit, std::string("inch"));
    }
};

AXISCOMP_TEST(TestPmac2d)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_pmac2d

#include "tst_pmac2d.moc"
