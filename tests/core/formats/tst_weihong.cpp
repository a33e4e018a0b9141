// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/sign_conversion.h"
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_weihong {

using namespace axiscomp;
using test::changed;
using test::problemLines;

namespace {

const TableFormat& format = weihong::format();

/// The manual's example.
const std::string example = ";unit=mm\n"
                            "[X]\n"
                            "-570.025, 0.027, 0.083\n"
                            "-450.020, 0.025, 0.077\n"
                            "-330.015, 0.015, 0.068\n"
                            "-210.010, 0.000, 0.057\n";
const auto with = test::changing(example);

NeutralTable exampleTable(const std::string& name = "X")
{
    NeutralTable table = test::tableOf(SignConvention::Feedback,
        {test::axisOf(name, "mm", {-570.025, -450.02, -330.015, -210.01})},
        {test::columnOf(name, "mm", {0.027, 0.025, 0.015, 0}),
            test::columnOf(name, "mm", {0.083, 0.077, 0.068, 0.057})});
    table.columns[0].direction = Direction::Positive;
    table.columns[1].direction = Direction::Negative;
    return table;
}

NeutralTable plainTable(const std::string& name)
{
    return test::tableOf(SignConvention::Feedback, {test::axisOf(name, "mm", {0, 10, 40})},
        {test::columnOf(name, "mm", {0, 0.01, -0.0000002})});
}

void describeWriting(test::FormatSample& sample)
{
    sample.writes("one direction", {plainTable("X")}).remarking({"or to 1 with the backlash"});
    sample
        .writes("the form of the manual",
            {changed(exampleTable(), [](NeutralTable& t) { t.notes = {"a note"}; })})
        .as(";unit=mm\n; a note\n[X]\n-570.025, 0.027, 0.083\n-450.02, 0.025, 0.077\n"
            "-330.015, 0.015, 0.068\n-210.01, 0, 0.057\n")
        .remarking({"axeserr.dat", "Screw error compensation to 2: both", "within the stroke"});
    sample.writes("both directions the same, several axes", {plainTable("Y"), exampleTable("Z")})
        .containing({"[Y]\n0, 0, 0\n10, 0.01, 0.01\n40, -0.0000002, -0.0000002\n[Z]\n-570.025, "})
        .remarking({"both directions"});
    sample.writes("the axis of the setting", {plainTable("1")})
        .with({{"axis", "Z"}})
        .becoming(plainTable("Z"));
    sample.writes("a small letter", {plainTable("y")}).becoming(plainTable("Y"));
    sample.writes("the letter of a longer name", {plainTable("Z1")})
        .with({{"axis", "Z"}})
        .becoming(plainTable("Z"));
    const auto micrometres = changed(plainTable("X"), [](NeutralTable& t) {
        t.columns[0].unit = "um";
        t.columns[0].values = {0, 10, -2};
    });
    sample.writes("micrometres", {micrometres}).becoming(changed(plainTable("X"), [](auto& t) {
        t.columns[0].values[2] = -0.002;
    }));
    sample.refuses(
        "no such axis", {plainTable("1")}, ErrorCode::InvalidArgument, "give the setting axis");
    sample.refuses("another letter than that of the table", {plainTable("X")},
        ErrorCode::InvalidArgument, "the setting axis of the format weihong says Y",
        FormatSettings{{"axis", "Y"}});
    sample.refuses("two tables of an axis", {plainTable("X"), plainTable("X")},
        ErrorCode::FormatCannotHold, "two tables for axis X");
    sample.refuses("a rotary axis",
        {changed(
            plainTable("X"), [](NeutralTable& t) { t.axes[0].unit = t.columns[0].unit = "deg"; })},
        ErrorCode::InvalidArgument, "numbers in deg cannot be given in mm");
    sample.refuses("another axis",
        {changed(plainTable("X"), [](NeutralTable& t) { t.columns[0].target = "Y"; })},
        ErrorCode::FormatCannotHold, "corrects an axis by its own position");
}

void describe(test::FormatSample& sample)
{
    sample.facts = "feedback is assumed; 1 to 1 dimensions, any knots; points any, columns 1, "
                   "tables any, bytes 67108864; holds names units notes directions";
    sample.text = example;
    sample.comment = "; ";
    sample.spareBytes = example.size() - 54; // two points are a table
    sample.applies({{{-510.0225}, 0.026}, {{-510.0225}, 0.080, 1}, {{-400}, 0.020831840339986},
        {{-400}, 0.073248656305987, 1}, {{-100}, 0}, {{-100}, 0.057, 1}, {{-1e6}, 0.027}});
    // Backlash alone: what stays behind on the way back.
    sample.applies({{{50}, 0}, {{50}, 0.03, 1}, {{-1}, 0.03, 1}},
        "unit = MM\n[y]\n0, 0.000, 0.030\n100, 0.000, 0.030\n");
    sample.recognises(
        Recognition::Certain, {example, "\n ; x\n [ y ]\n\n; y\n-1,+2 , 3e-3\n", "[Z]\n1,2,3"});
    sample.recognises(Recognition::No,
        {"[X]\n1,2\n", "[X]\n1,2,3,4\n", "[A]\n1,2,3\n", "1,2,3\n", "[X]\na=1\n1,2,3\n",
            "[XY]\n1,2,3\n", "; [X]\n1,2,3\n", "[X]\n1,2,x\n"});
    sample.warning("no unit", with(";unit=mm\n", ""), {"0:0 UnitNotGiven no line unit=mm|"});
    sample.warning("another letter", with("[X]", "[A]"), {"2:1 Assumption a section of axis A|X"});
    describeWriting(sample);

    const auto row = sample.problemRow();
    row("no section", ";unit=mm\n", "0:0 Syntax |a section such as [X]");
    row("numbers before the section", with("[X]\n", ""),
        "2:1 Syntax -570.025, 0.027, 0.083|a section");
    row("another unit", with("unit=mm", " unit = inch"), "1:10 Contradiction the unit \"inch\"|mm");
    row("another unit without a comment", with(";unit=mm", "UNIT=um"),
        "1:6 Contradiction the unit \"um\"|mm");
    row("an axis twice", example + "[x]\n0, 0, 0\n1, 0, 0\n",
        "7:1 Contradiction a second section of axis X|each axis once; the first is in line 2");
    row("a section without an axis", with("[X]", "[SPINDLE]"), "2:1 Syntax [SPINDLE]|the letter");
    row("something behind the section", with("[X]", "[X] ; x"), "2:1 Syntax [X] ; x|the letter");
    row("one line", "[X]\n1, 2, 3\n", "2:0 TooFewPoints 1 position of axis X|at least 2");
    row("no line", example + "[Y]\n", "7:0 TooFewPoints 0 positions of axis Y|at least 2");
    row("a falling position", with("-330.015", "-450.020"),
        "5:0 NotMonotonic -450.02 after -450.02|strictly increasing positions of axis X");
    row("a missing number", with(", 0.083", ""),
        "3:0 ColumnCount 2 numbers between commas|3, with");
    row("decimal commas", with("-570.025, 0.027, 0.083", "-570,025, 0,027, 0,083"),
        "3:0 ColumnCount 6 numbers between commas|3, with decimal points");
    row("blanks for commas", with("-570.025, 0.027, 0.083", "-570.025 0.027 0.083"),
        "3:0 ColumnCount 1 number between commas|3, with");
    row("half a number", with("0.027", "0.027mm"), "3:11 NotANumber 0.027mm|a forward error in mm");
    row("no finite number", with("0.083", "nan"), "3:18 NotANumber nan|a backward error in mm");
    row("a comment behind numbers", with("0.083", "0.083 ; x"), "3:18 NotANumber 0.083 ; x|");
}

} // namespace

class TestWeihong : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theExampleOfTheManualIsRead()
    {
        READ_TABLE(table, format, example, {});
        COMPARE_TABLES(table, exampleTable(), 0.0);
    }

    void everySectionIsATable()
    {
        const auto reading =
            format.read("; made by \xB2\xE2\xC1\xBF\n" + example + "[z]\n0,1,1\n5,2,2\n", {});
        VERIFY_RESULT(reading);
        QCOMPARE(reading->tables.size(), std::size_t(2));
        QCOMPARE(reading->tables[0].notes.size(), std::size_t(1));
        QCOMPARE(reading->tables[1].axes[0].name, std::string("Z"));
        QCOMPARE(reading->tables[1].columns.size(), std::size_t(1));
        QCOMPARE(reading->tables[1].columns[0].direction, Direction::Both);
    }

    void aNoteThatWouldBeAUnitIsNotWritten()
    {
        NeutralTable table = plainTable("X");
        table.notes = {"unit = inch", "a unit"};
        WRITE_TABLE(written, format, table, {});
        QCOMPARE(written->held[0].notes, (std::vector<std::string>{"a unit"}));
    }

    void theErrorsBecomeCommands()
    {
        const auto command =
            convertSign(exampleTable(), SignConvention::Command, format.facts.behaviour);
        VERIFY_RESULT(command);
        const auto& columns = command->table.columns;
        QVERIFY2(std::abs(columns[0].values[1] + 0.025000416656) < 1e-12,
            toText(columns[0].values[1]).c_str());
        QVERIFY2(std::abs(columns[1].values[1] + 0.077003850032) < 1e-12,
            toText(columns[1].values[1]).c_str());
    }
};

AXISCOMP_TEST(TestWeihong)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_weihong

#include "tst_weihong.moc"
