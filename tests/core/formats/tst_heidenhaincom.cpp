// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_heidenhaincom {

using namespace axiscomp;
using test::changed;
using test::problemLines;

namespace {

const TableFormat& format = heidenhain_com::format();

const std::string example = "BEGIN AXIS_Y.COM MM\n"
                            "NR   AXISPOS       BACKLASH      X             Y             Z\n"
                            "0    -90.0000                                  +0.0000\n"
                            "1    -85.0000                                  +0.0021\n"
                            "3    -70.5000                                  -0.0100\n"
                            "[END]\n";
const auto with = test::changing(example);

NeutralTable exampleTable(const std::string& axis = "Y", const std::string& target = "Y")
{
    return test::tableOf(SignConvention::Feedback, {test::axisOf(axis, "mm", {-90, -85, -70.5})},
        {test::columnOf(target, "mm", {0, 0.0021, -0.01})});
}

NeutralTable rotaryTable()
{
    return test::tableOf(SignConvention::Feedback, {test::axisOf("C", "deg", {0, 90, 360})},
        {test::columnOf("C", "deg", {0, 0.002, 0})});
}

void describeWriting(test::FormatSample& sample)
{
    sample.writes("the layout of a public writer", {exampleTable()})
        .as("BEGIN AXIS_Y.COM MM\n"
            "NR   AXISPOS       BACKLASH      X             Y             Z\n"
            "0    -90.0000                                  +0.0000\n"
            "1    -85.0000                                  +0.0021\n"
            "2    -70.5000                                  -0.0100\n"
            "[END]\n")
        .remarking(
            {"no text says the sign of a .COM table", "config.cma, in the column of axis Y"});
    const auto several = changed(exampleTable(), [](NeutralTable& t) {
        t.columns.push_back(test::columnOf("Z", "mm", {0.001, 0, 0.5}));
        t.columns.push_back(test::columnOf("W", "mm", {0, 0, -1}));
    });
    sample.writes("several targets", {several})
        .containing(
            {"NR   AXISPOS       BACKLASH      X             Y             Z             W\n"
             "0    -90.0000                                  +0.0000       +0.0010       "
             "+0.0000\n"});
    sample.writes("a rotary axis", {rotaryTable()})
        .containing({"BEGIN AXIS_C.COM MM\nNR   AXISPOS       BACKLASH      X             Y  ",
            "\n1    +90.0000                                                              "
            "+0.0020\n"});
    sample.writes("letters of settings", {exampleTable("1", "2")})
        .with({{"axis", "x"}, {"target-axis", "Z"}})
        .containing({"BEGIN AXIS_X.COM MM\n"})
        .becoming(exampleTable("X", "Z"));
    sample
        .writes("rounded to four decimals",
            {changed(exampleTable(),
                [](NeutralTable& t) {
                    t.columns[0].values = {0.00004, -0.00004, 0.12346};
                    t.axes[0].knots[1] = -85.00003;
                })})
        .containing({"+0.0000\n1    -85.0000                                  +0.0000\n"})
        .within(5e-5, 5e-5);
    // The file has its columns in the order of the letters.
    sample.writes("columns in another order", {changed(exampleTable("X", "Z"), [](NeutralTable& t) {
        t.columns.push_back(test::columnOf("X", "mm", {0.1, 0.2, 0.3}));
    })});
    sample
        .writes("micrometres",
            {changed(exampleTable(),
                [](NeutralTable& t) {
                    t.columns[0].unit = "um";
                    t.columns[0].values = {0, 2.1, -10};
                })})
        .becoming(exampleTable())
        .within(1e-15, 0);
    sample
        .writes("a rotary axis without a unit",
            {changed(
                rotaryTable(), [](NeutralTable& t) { t.axes[0].unit = t.columns[0].unit = ""; })})
        .becoming(rotaryTable())
        .remarking({"the numbers for axis C have no unit; they are taken to be in deg"});
    const auto cannot = [&](const char* name, const NeutralTable& table, const char* reason) {
        sample.refuses(name, {table}, ErrorCode::FormatCannotHold, reason);
    };
    cannot("a turn from -180",
        changed(rotaryTable(),
            [](NeutralTable& t) {
                t.axes[0].knots = {-180, 0, 180};
            }),
        "only 0 to 360 degrees count");
    cannot("a rotary axis in mm", exampleTable("C", "C"), "A, B and C are in degrees");
    cannot("a linear axis in degrees",
        changed(rotaryTable(), [](NeutralTable& t) { t.axes[0].name = t.columns[0].target = "X"; }),
        "A, B and C are in degrees");
    cannot("a number wider than its column",
        changed(exampleTable(), [](NeutralTable& t) { t.columns[0].values[1] = 123456789; }),
        "more digits than a column holds");
    cannot("positions that are the same with four decimals",
        changed(exampleTable(),
            [](auto& t) {
                t.axes[0].knots = {0, 0.00001, 1};
            }),
        "strictly increasing");
    cannot("a target twice",
        changed(exampleTable(), [](NeutralTable& t) { t.columns.push_back(t.columns[0]); }),
        "two columns for axis Y");
    const auto refuses = [&](const char* name, const NeutralTable& table, const char* reason,
                             const FormatSettings& settings) {
        sample.refuses(name, {table}, ErrorCode::InvalidArgument, reason, settings);
    };
    refuses("no letter", exampleTable("1", "1"), "give the setting axis", {});
    refuses("no letter of the target", exampleTable("Y", "Z1"), "give the setting target-axis", {});
    refuses("another letter", exampleTable(),
        "the setting axis of the format heidenhain-com says Z", {{"axis", "Z"}});
    refuses("no such letter", exampleTable("1", "1"), "the setting axis is Q", {{"axis", "Q"}});
    refuses("the letter of the moving axis", exampleTable("1", "2"), "say X for both",
        {{"axis", "X"}, {"target-axis", "X"}});
    refuses("a target that no column has", exampleTable("X", "X"),
        "target-axis of the format heidenhain-com says Z, and the table goes from X to X",
        {{"target-axis", "Z"}});
}

void describe(test::FormatSample& sample)
{
    sample.facts = "feedback is assumed; 1 to 1 dimensions, any knots; points 256, columns 9, "
                   "tables 1, bytes 67108864; holds names units";
    sample.text = example;
    sample.spareBytes = 1;
    sample.applies({{{-87.5}, 0.00105}, {{-77.75}, -0.00395}, {{-1000}, 0}, {{0}, -0.01}});
    sample.recognises(
        Recognition::Certain, {example, "\n  begin axis-x.com\n", "BEGIN AXIS1.COM MM"});
    sample.recognises(Recognition::No,
        {"BEGIN AXIS-Y.COM DATUM:-90 DISTANCE:+6.5536\n", "BEGIN PGM 5 MM\n",
            "BEGIN AXIS_Y.TAB MM\n", "x\nBEGIN AXIS_Y.COM MM\n"});
    sample.warning("no unit", with(" MM", ""), {"1:0 UnitNotGiven a first line without MM|MM or"});
    sample.warning("values of the other direction", with("-85.0000      ", "-85.0000      -0.0300"),
        {"4:20 LeftOut 1 value in the column BACKLASH|none: it is not published"});
    sample.warning("another axis by a setting", example,
        {"1:1 Assumption axis Y in the name of the file|axis X, as the setting axis says"},
        FormatSettings{{"axis", "x"}});
    sample.warning("an unknown column", with("Z\n", "DOC\n"), {"2:62 UnknownKey DOC|"});
    sample.warning("a rotary axis outside of its turn", with("AXIS_Y", "AXIS_C"),
        {"3:0 Assumption the position -90 deg of the rotary axis C|0 to 360 deg"});
    describeWriting(sample);

    const auto row = sample.problemRow();
    row("another first line", with("BEGIN", "START"),
        "1:1 Syntax START AXIS_Y.COM MM|a first line");
    row("the other layout", with("MM", "DATUM:-90 DISTANCE:5"),
        "1:1 Syntax BEGIN AXIS_Y.COM DATUM:-90 DISTANCE:5|the format heidenhain-com-530 to read "
        "it");
    row("no moving axis", with("AXIS_Y", "AXISTAB"), "1:1 Syntax BEGIN AXISTAB.COM MM|the moving");
    row("a setting that is no letter", example, "1:0 Contradiction the setting axis X1|one letter",
        std::string(), FormatSettings{{"axis", "X1"}});
    row("no headers", "BEGIN AXIS_Y.COM MM\n", "0:0 Syntax |a line of headers");
    row("no header of the position", with("AXISPOS", "POS    "), "2:1 Syntax NR   POS");
    row("no axis", "BEGIN AXIS_Y.COM MM\nNR   AXISPOS       BACKLASH\n[END]\n",
        "2:1 Syntax NR   AX");
    row("a column twice", with("X ", "Y "), "2:48 Contradiction Y|each column once");
    row("a tab in the headers", with("AXISPOS ", "AXISPOS\t"), "2:13 Syntax a tab|blanks");
    row("a tab in a line", with("-85.0000 ", "-85.0000\t"), "4:14 Syntax a tab|blanks, since");
    row("no values", "BEGIN AXIS_Y.COM MM\nNR   AXISPOS       X\n0    +1.0000\n[END]\n",
        "0:0 TooFewPoints |values in a column");
    row("one value", "BEGIN AXIS_Y.COM MM\nNR   AXISPOS       X\n0    +1.0000       0\n[END]\n",
        "3:0 TooFewPoints 1 position of the column of X|at least 2");
    row("no position", with("-85.0000", "        "), "4:1 Syntax 1    ");
    row("two values in a column", with("+0.0021", "+0 1"),
        "4:51 Syntax 1|a value below the header");
    row("a value that begins before its header", with(" +0.0021", "+0.0021"),
        "4:47 Syntax +0.0021|a value below the header");
    row("a value left of the headers", with("1    -85", "1 -85.0"), "4:3 Syntax -85.0");
    row("the line begins later", with("\n1    -85.0000", "\n    1-85.0000"),
        "4:5 Syntax 1-85.0000");
    row("a decimal comma", with("+0.0021", "+0,0021"), "4:48 NotANumber +0,0021|a compensation");
    row("half a number", with("+0.0021", "+0.00-21"), "4:48 NotANumber +0.00-21|");
    row("a position that is none", with("-85.0000", "-85.00.0"), "4:6 NotANumber -85.00.0|");
    row("a number of a line that is none", with("\n1 ", "\nA "),
        "4:1 NotANumber A|the number of a");
    row("numbers of lines that fall", with("\n1 ", "\n0 "), "4:1 NotMonotonic 0|ascending numbers");
    row("positions that fall", with("-85.0000", "-95.0000"),
        "4:0 NotMonotonic -95 after -90|strictly increasing positions of the column of Y");
    row("no end", with("[END]\n", ""), "0:0 Syntax no line [END]|that line at the end");
    row("something behind the end", example + "0    +1\n",
        "7:1 Syntax 0    +1|nothing behind [END]");
    std::string lines;
    for (int i = 0; i <= 256; ++i)
        lines += std::to_string(i) + "    " + std::to_string(1000 + i) + "    0\n";
    row("more lines than a control takes",
        "BEGIN AXIS_X.COM MM\nNR   AXISPOS X\n" + lines + "[END]\n",
        "259:0 LimitExceeded more than 256 lines|at most 256 lines #9095: 3", "9095: 3");
}

} // namespace

class TestHeidenhainCom : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theExampleIsRead()
    {
        READ_TABLE(table, format, example, {});
        COMPARE_TABLES(table, exampleTable(), 0.0);
        QCOMPARE(table.axes[0].step, 0.0001);
    }

    /// A line without a value in a column is left out of it: the control interpolates.
    void columnsWithValuesInOtherLinesAreTablesOfTheirOwn()
    {
        const auto reading = format.read("BEGIN AXIS_Y.COM MM\n"
                                         "NR   AXISPOS       X             Y             Z\n"
                                         "0    -90.0000      +0.0000                     +0.1\n"
                                         "1    -85.0000                                  +0.0021\n"
                                         "2    -80.0000      +0.0010                     +0.3\n"
                                         "[END]\n",
            {});
        VERIFY_RESULT(reading);
        QVERIFY2(reading->diagnostics.empty(), problemLines(*reading).c_str());
        QCOMPARE(reading->tables.size(), std::size_t(2));
        QCOMPARE(reading->tables[0].axes[0].knots, (std::vector<double>{-90, -80}));
        QCOMPARE(reading->tables[0].columns[0].target, std::string("X"));
        QCOMPARE(reading->tables[1].columns[0].target, std::string("Z"));
        QCOMPARE(reading->tables[1].columns[0].values, (std::vector<double>{0.1, 0.0021, 0.3}));
        QCOMPARE(test::applied(format, reading->tables[0], {-85}), 0.0005);
    }

    void inchesAreInches()
    {
        READ_TABLE(table, format, with(" MM", " INCH"), {});
        QCOMPARE(table.axes[0].unit, std::string("inch"));
        QCOMPARE(table.columns[0].unit, std::string("inch"));
    }
};

AXISCOMP_TEST(TestHeidenhainCom)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_heidenhaincom

#include "tst_heidenhaincom.moc"
