// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_pmac1d {

using namespace axiscomp;
using test::applied;
using test::changed;
using test::problemLines;

namespace {

const TableFormat& format = pmac_1d::format();

const std::string file = "; bowed screw\n"
                         "CLOSE\nDELETE COMP\n"
                         "#1\n"
                         "DEFINE COMP 4,#1D,#2,4000 ; 4 entries\n"
                         "160 -80\n"
                         "32\n"
                         "0 // the last one\n"
                         "I51=1\n";

const auto with = test::changing(file);

TableReadOptions inMillimetres(const std::string& counts = "1000")
{
    return test::readingWith(
        {{"counts-per-unit", counts}, {"position-unit", "mm"}, {"value-unit", "mm"}});
}

const TableWriteOptions thousand = test::writingWith({{"counts-per-unit", "1000"}});

NeutralTable closedTable()
{
    NeutralTable table = test::commandTable(
        {test::evenAxis("3", "mm", 0, 2.5, 25)}, {test::waveColumn("3", "mm", 25, 0.05)});
    table.axes[0].wrap = 60;
    table.columns[0].values.front() = 0;
    table.columns[0].values.back() = 0;
    return table;
}

/// From -20 to 30, 0 at 0, different at both ends.
NeutralTable openTable()
{
    NeutralTable table = test::commandTable(
        {test::evenAxis("1", "mm", -20, 5, 11)}, {test::waveColumn("1", "mm", 11, 0.05)});
    table.columns[0].values[4] = 0;
    return table;
}

void describe(test::FormatSample& sample)
{
    sample.facts = "command is assumed; 1 to 1 dimensions, even knots; "
                   "points any, columns 1, tables 1, bytes 67108864; holds notes wrap";
    sample.text = file;
    sample.reading = inMillimetres();
    sample.writing = thousand;
    sample.comment = "; ";
    sample.spareBytes = file.size() - file.find("0 // the last") - 1;
    sample.applies({{{0.5}, 0.005}, {{4.5}, 0.005}, {{-1}, 0.002}, {{-39}, 0.01}});
    sample.recognises(Recognition::Certain, {file});
    sample.recognises(Recognition::No,
        {"DEFINE COMP 4.4,#1,#2,#3,10,10\n", "#define COMP 1\nint main()\n", "1 2\n0 1\n1 1\n"});
    const std::string open = with("0 // the last", "7 // the last");
    sample.warning("a last entry other than 0", open, {"5:0 NotPeriodic"});
    sample.applies({{{3.5}, (32 + 7) / 32000.0}}, open);
    // As real files have it.
    sample.recognises(
        Recognition::Certain, {with("DEFINE COMP 4,#1D,#2,4000", "DEFINE COMP 4 #1D,#2,4000")});
    sample.applies({{{0.5}, 0.005}, {{4.5}, 0.005}},
        with("DEFINE COMP 4,#1D,#2,4000", "DEFINE COMP 4 #1D, #2\t,4000"));
    sample.warning("tables that are switched off", with("I51=1", "I51=0"),
        {"9:1 Assumption \"I51=0\", which switches a table of the file off"});
    sample.warning("switched on behind it", with("I51=1", "I51=0\nI51=1"), {});
    sample.warning("a table that is deleted behind its definition", file + "#1 DELETE COMP\n",
        {"10:4 Assumption \"DELETE COMP\", which switches a table of the file off"});
    sample.warning("the table of another motor is deleted", file + "#2 DELETE COMP\n", {});
    const std::string another = "#5\nDEFINE COMP 2,#5D,#2,4000\n16 0\n";
    sample.warning("two tables for one motor, which the controller adds", file + another,
        {"0:0 Assumption several tables of 1 to 2, 5 to 2|their sum, since the controller adds"});
    sample.warning("one of them is deleted", file + another + "#5 DELETE COMP\n",
        {"13:4 Assumption \"DELETE COMP\", which switches a table of the file off"});
    sample.warning(
        "tables for different motors", file + "#5\nDEFINE COMP 2,#1D,#5,4000\n16 0\n", {});
    sample.warning("two tables that belong to one motor",
        file + "DEFINE COMP 2,#5D,#2,4000\n16 0\n",
        {"10:1 Assumption a second table that belongs to the same motor|one for each motor"});
    const std::string others = "M145=1\nDEFINE BLCOMP 2,100\n1 2\n" + file;
    sample.warning("other commands", others, {"1:1 UnknownKey", "2:1 UnknownKey"});
    sample.applies({{{0.5}, 0.005}}, others);
    sample.refusesReading("counts below 0", inMillimetres("-5").settings, "");
    const auto row = sample.problemRow();
    row("numbers that no double holds", file,
        "5:0 NotMonotonic inf after 0|strictly increasing positions of motor 1\n"
        "5:0 LimitExceeded entries that are too large",
        "", inMillimetres("1e-310").settings);

    NeutralTable ray = openTable();
    ray.axes[0] = test::evenAxis("1", "mm", 0, 0.5, 11);
    ray.columns[0].values.front() = ray.columns[0].values.back() = 0;
    sample.writes("from 0", {ray})
        .becoming(changed(ray, [](NeutralTable& table) { table.axes[0].wrap = 5; }))
        .within(0.5 / 16000 + 1e-12);
    sample.writes("closed", {closedTable()})
        .containing({"#3\nDEFINE COMP 24,#3D,#3,60000\n"})
        .remarking({"the desired position of its sources (D)"})
        .within(0.5 / 16000 + 1e-12);
    NeutralTable manual = closedTable();
    manual.axes[0] = test::evenAxis("1", "mm", 0, 1, 4);
    manual.axes[0].wrap = 3;
    manual.columns = {test::columnOf("2", "um", {0, 1, -2, 0})};
    manual.notes = {"note"};
    sample.writes("the form of the manual", {manual})
        .with({{"counts-per-unit", "1000"}, {"position", "actual"}, {"value-unit", "mm"}})
        .as("; note\n#2\nDEFINE COMP 3,#1,#2,3000\n16 -32 0\n")
        .remarking({"the actual position of its sources", "I51=1"})
        .becoming(changed(manual, [](NeutralTable& table) {
            table.columns = {test::columnOf("2", "mm", {0, 0.001, -0.002, 0})};
        }));
    NeutralTable letter = closedTable();
    letter.axes[0].name = letter.columns[0].target = "X";
    sample.refuses(
        "motors that are no numbers", {letter}, ErrorCode::InvalidArgument, "source-motor");
    sample.writes("motors that are no numbers", {letter})
        .with({{"counts-per-unit", "1000"}, {"source-motor", "4"}})
        .becoming(changed(closedTable(),
            [](NeutralTable& table) { table.axes[0].name = table.columns[0].target = "4"; }))
        .within(0.5 / 16000 + 1e-12);

    sample.refuses("no counts", {closedTable()}, ErrorCode::InvalidArgument, "",
        FormatSettings{{"counts-per-unit", "1000"}, {"target-counts-per-unit", "0"}});
    const auto refuses = [&sample](const char* name, const char* reason, const auto& change,
                             const FormatSettings& settings = thousand.settings) {
        sample.refuses(
            name, {changed(openTable(), change)}, ErrorCode::FormatCannotHold, reason, settings);
    };
    const auto shiftedBy = [](double distance) {
        return [distance](NeutralTable& table) {
            for (double& knot : table.axes[0].knots)
                knot += distance;
        };
    };
    refuses("a value at 0", "takes it to be 0",
        [](NeutralTable& table) { table.columns[0].values[4] = 0.01; });
    refuses("no point at 0", "is no point of source 1", shiftedBy(1));
    refuses("0 is not reached", "does not reach", shiftedBy(500));
    refuses("too large an entry", "24 bits",
        [](NeutralTable& table) { table.columns[0].values[2] = 600; });
    refuses("too long a span", "counts",
        [](NeutralTable& table) { table.axes[0] = test::evenAxis("1", "mm", -4e6, 1e6, 11); });
    refuses("an open period", "differ by", [](NeutralTable& table) {
        table = closedTable();
        table.columns[0].values.back() = 1;
    });
    refuses("no such motor", "there is no motor 33", [](NeutralTable&) {},
        {{"counts-per-unit", "1000"}, {"source-motor", "33"}});

    row("no table", "CLOSE\n", "0:0 Syntax |DEFINE COMP for a table of one dimension");
    row("truncated", file.substr(0, file.find("32")), "5:0 MissingPoint 2 entries|4, as DEFINE");
    row("too many", with("32\n", "32 33 34\n"), "7:0 Contradiction 5 entries|4, as DEFINE COMP");
    row("further ones", with("I51=1", "5"), "9:1 Contradiction further entries: 5|4, as DEFINE");
    row("entries alone", "1 2 3\n", "1:1 Contradiction further entries: 1 2 3|DEFINE COMP in");
    row("absurd", with("COMP 4,", "COMP 1000000000,"),
        "5:13 LimitExceeded 1000000000 entries|1 to 1000000");
    row("no size", with("COMP 4,", "COMP ,"), "5:13 NotANumber |a number of entries");
    row("no entries", with("COMP 4,", "COMP 0,"), "5:13 LimitExceeded 0 entries");
    row("no span", with("#2,4000", "#2"), "5:1 Syntax DEFINE COMP 4,#1D,#2|DEFINE COMP entries");
    row("span 0", with("#2,4000", "#2,0"), "5:22 LimitExceeded a span of 0|at least 1 count");
    row("span not whole", with("#2,4000", "#2,4000.5"), "5:22 NotANumber 4000.5|a span in counts");
    row("three motors", with("#2,4000", "#2,#3,4000"), "5:1 Syntax DEFINE COMP");
    row("motor 33", with("#2,4000", "#33,4000"), "5:19 Syntax #33|the number of a motor");
    row("a decimal", with("-80", "-80.5"), "6:5 NotANumber -80.5|a whole number of 1/16 count");
    row("not a number", with("-80", "-8O"), "6:5 NotANumber -8O|");
}

} // namespace

class TestPmac1d : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void entriesAreSixteenthsOfACountAndTheOneForZeroIsLeftOut()
    {
        READ_TABLE(table, format, file, {});
        QCOMPARE(table.axes[0].name, std::string("1"));
        QCOMPARE(table.axes[0].unit, std::string("counts"));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{0, 1000, 2000, 3000, 4000}));
        QCOMPARE(table.columns[0].target, std::string("2"));
        QCOMPARE(table.columns[0].values, (std::vector<double>{0, 10, -5, 2, 0}));
        QCOMPARE(table.notes, (std::vector<std::string>{"bowed screw"}));
        QCOMPARE(problemLines(*reading_table),
            std::string("warning 5:0 UnitNotGiven a table in counts|the setting counts-per-unit, "
                        "where a unit matters\n"));
    }

    void countsBecomeUnitsByASetting()
    {
        READ_TABLE(table, format, file, inMillimetres());
        QCOMPARE(table.axes[0].knots, (std::vector<double>{0, 1, 2, 3, 4}));
        QCOMPARE(table.axes[0].unit, std::string("mm"));
        QCOMPARE(table.columns[0].values[1], 0.01);
        QVERIFY2(reading_table->diagnostics.empty(), problemLines(*reading_table).c_str());
        TableReadOptions options = inMillimetres();
        options.settings["target-counts-per-unit"] = "2000";
        READ_TABLE(other, format, file, options);
        QCOMPARE(other.axes[0].knots[1], 1.0);
        QCOMPARE(other.columns[0].values[1], 0.005);
    }

    void countsThatAreStatedForTheTargetAloneLeaveThePositionsInCounts()
    {
        TableReadOptions options =
            test::readingWith({{"target-counts-per-unit", "1000"}, {"value-unit", "mm"}});
        READ_TABLE(table, format, file, options);
        QCOMPARE(table.axes[0].knots[1], 1000.0);
        QCOMPARE(table.axes[0].unit, std::string("counts"));
        QCOMPARE(table.columns[0].values[1], 0.01);
        QCOMPARE(table.columns[0].unit, std::string("mm"));
        QCOMPARE(problemLines(*reading_table),
            std::string("warning 5:0 UnitNotGiven a table in counts|the setting "
                        "source-counts-per-unit, where a unit matters\n"));
        options.settings["position-unit"] = "mm";
        const auto refused = format.read(file, options);
        VERIFY_RESULT(refused);
        QVERIFY(test::mentions(problemLines(*refused),
            "0:0 Contradiction the setting position-unit for numbers in counts|the setting "
            "source-counts-per-unit, which says"));
    }

    /// Values in um with the counts of a mm were 1000 times too small, without a word.
    void aMotorHasOneUnitForItsOneNumberOfCounts()
    {
        const std::string own = with("#1D,#2,", "#1D,#1,");
        TableReadOptions options = inMillimetres();
        options.settings["value-unit"] = "um";
        const auto refused = format.read(own, options);
        VERIFY_RESULT(refused);
        QVERIFY(refused->tables.empty());
        QCOMPARE(problemLines(*refused),
            std::string("0:0 Contradiction positions in mm and values in um|one unit, since the "
                        "controller adds the values to the positions\n"));
        READ_TABLE(another, format, file, options);
        QCOMPARE(another.columns[0].unit, std::string("um"));
        options.settings["target-counts-per-unit"] = "1";
        READ_TABLE(table, format, own, options);
        QCOMPARE(table.columns[0].values[1], 10.0);
        QCOMPARE(table.columns[0].unit, std::string("um"));
    }

    void countsOfEveryMotorAreWrittenWithoutCommonOnes()
    {
        const NeutralTable table = closedTable();
        WRITE_TABLE(common, format, table, thousand);
        const auto own = test::writingWith(
            {{"source-counts-per-unit", "1000"}, {"target-counts-per-unit", "1000"}});
        WRITE_TABLE(written, format, table, own);
        QCOMPARE(written->bytes, common->bytes);
        QCOMPARE(written->held, common->held);
    }

    void aMotorIsWrittenInOneUnit()
    {
        NeutralTable own = closedTable();
        own.columns[0].target = own.axes[0].name;
        const auto refused = format.write(std::array{own},
            test::writingWith({{"counts-per-unit", "1000"}, {"value-unit", "um"}}));
        VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
        QVERIFY2(test::mentions(sentence(refused.error()), "has one unit for both"),
            sentence(refused.error()).c_str());
    }

    void motorsThatAreNotNamedAreTheAddressedOne()
    {
        READ_TABLE(own, format, with("4,#1D,#2,4000", "4,4000"), {});
        QCOMPARE(own.axes[0].name, std::string("1"));
        QCOMPARE(own.columns[0].target, std::string("1"));
        READ_TABLE(source, format, "#7 def comp 2 , #3 , 100\n1 0\n", {});
        QCOMPARE(source.axes[0].name, std::string("3"));
        QCOMPARE(source.columns[0].target, std::string("7"));
        READ_TABLE(none, format, "DEFINE COMP 2,100\n1 0\n", {});
        QCOMPARE(none.axes[0].name, std::string());
        QVERIFY(test::hasProblem(*reading_none, DiagnosticCode::Assumption, 1));
    }

    void severalTablesOfAFileAreReadAndThoseOfTwoDimensionsLeftOut()
    {
        const auto reading = format.read(
            "DEFINE COMP 2.2,#1,#2,#3,10,10\n1 2 3 4 5 6 7 8\n" + file + file, inMillimetres());
        VERIFY_RESULT(reading);
        QCOMPARE(reading->tables.size(), std::size_t(2));
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::Assumption, 1));
    }

    void negativePositionsAreWrittenBehindThePositiveOnes()
    {
        const NeutralTable table = openTable();
        WRITE_TABLE(written, format, table, thousand);
        QVERIFY(written->bytes.starts_with("#1\nDEFINE COMP 11,#1D,#1,55000\n"));
        const NeutralTable& held = written->held.front();
        for (double x = -20; x <= 30; x += 1.25)
            QVERIFY(std::abs(applied(format, held, {x}) - applied(format, table, {x}))
                <= 0.5 / 16000 + 1e-9);
        NeutralTable closed = table;
        closed.columns[0].values.back() = closed.columns[0].values.front();
        WRITE_TABLE(shorter, format, closed, thousand);
        QVERIFY(shorter->bytes.starts_with("#1\nDEFINE COMP 10,#1D,#1,50000\n"));
    }
};

AXISCOMP_TEST(TestPmac1d)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_pmac1d

#include "tst_pmac1d.moc"
