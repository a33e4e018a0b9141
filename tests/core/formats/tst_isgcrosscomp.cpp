// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_isgcrosscomp {

using namespace axiscomp;
using test::applied;
using test::changed;
using test::problemLines;

namespace {

const TableFormat& format = isg_crosscomp::format();

const TableReadOptions linear =
    test::readingWith({{"master-kind", "linear"}, {"axis-kind", "linear"}});

const std::string head = "kopf.achs_nr 3\nkw.crosscomp.unit 1\nkw.crosscomp.master_ax_nr 1\n";
const std::string three = head
    + "kw.crosscomp.last_index 2\n"
      "kw.crosscomp.table[0].setpoint 0\nkw.crosscomp.table[0].correction 10\n"
      "kw.crosscomp.table[1].setpoint 100000\nkw.crosscomp.table[1].correction -30\n"
      "kw.crosscomp.table[2].setpoint 150000\nkw.crosscomp.table[2].correction 10\n";
const auto with = test::changing(three);

NeutralTable unevenTable()
{
    return test::commandTable({test::axisOf("1", "mm", {-20.5, 0.0, 7.25, 100.0})},
        {test::waveColumn("3", "mm", 4, 0.05)});
}

/// Of a modulo axis.
NeutralTable wrapped(std::vector<double> knots, std::vector<double> values, double period)
{
    NeutralTable table = unevenTable();
    table.axes[0].knots = std::move(knots);
    table.axes[0].wrap = period;
    table.axes[0].unit = "deg";
    table.columns[0].values = std::move(values);
    return table;
}

const FormatSettings turning{{"master-kind", "rotary"}, {"axis-kind", "linear"}, {"modulo", "yes"}};

void describe(test::FormatSample& sample)
{
    sample.facts = "command is assumed; 1 to 1 dimensions, any knots; "
                   "points 1001, columns 1, tables 1, bytes 67108864; holds units notes wrap";
    sample.text = three;
    sample.reading = linear;
    sample.comment = "# ";
    sample.spareBytes = 2; // of the last number
    sample.applies({{{5.0}, -0.001}, {{12.5}, -0.001}, {{-1e6}, 0.001}, {{1e6}, 0.001}});
    sample.recognises(Recognition::Certain, {three});
    sample.recognises(Recognition::Possible, {three + "kw.ssfk.unit 1\n"});
    sample.recognises(Recognition::No, {"kw.crosscomp2.unit 1\n", "1 2\n0 1\n1 1\n"});
    sample.warning("an unknown entry and another table of the list",
        three + "kw.crosscomp.colour 3\nkw.ssfk.unit 1\nkw.ssfk.bilateral 0\nfoo 1\n",
        {"11:1 UnknownKey kw.crosscomp.colour|",
            "12:1 Assumption a table kw.ssfk besides kw.crosscomp|the format isg-ssfk to read it; "
            "it is left out here",
            "14:1 UnknownKey foo|"});
    sample.applies({{{5.0}, -0.001}}, three + "kw.ssfk.unit 1\n");

    NeutralTable noted = unevenTable();
    noted.notes = {"measured in March", "two", "lines"};
    noted.name = "Z";
    NeutralTable broken = noted;
    broken.notes = {"measured in March", "two\nlines"};
    sample.writes("uneven positions", {unevenTable()})
        .within(0.00005 + 1e-12)
        .remarking({"activate it in the axis list of axis 3: lr_param.crosscomp 1\n"});
    sample.writes("a name and notes", {broken}).within(0.00005 + 1e-12).becoming(noted);
    NeutralTable kept = unevenTable();
    kept.notes = {"measured in March", "n_cycles 25", "max_points 500"};
    sample.writes("entries that a table has no place for", {kept})
        .containing({"# measured in March\nkopf",
            "kw.crosscomp.n_cycles 25\n"
            "kw.crosscomp.max_points 500\n"})
        .within(0.00005 + 1e-12)
        .becoming(kept);
    sample.writes("a setting comes before the note", {kept})
        .with({{"n-cycles", "10"}})
        .containing({"kw.crosscomp.n_cycles 10\n"})
        .becoming(changed(kept, [](NeutralTable& table) { table.notes[1] = "n_cycles 10"; }))
        .within(0.00005 + 1e-12);
    NeutralTable outgrown = kept;
    outgrown.notes = {"max_points 2"};
    sample.writes("more points than the table that was read", {outgrown})
        .remarking({"max_points 2 of the source is left out"})
        .becoming(changed(outgrown, [](NeutralTable& table) { table.notes.clear(); }))
        .within(0.00005 + 1e-12);
    NeutralTable degrees = unevenTable();
    degrees.axes[0].unit = "deg";
    degrees.columns = {test::columnOf("3", "um", {0, 1, -2, 10})};
    sample.writes("degrees and micrometres", {degrees})
        .readWith({{"master-kind", "rotary"}, {"axis-kind", "linear"}})
        .containing({"[0].setpoint -205000\n", "[2].correction -20\n"})
        .becoming(changed(degrees, [](NeutralTable& table) {
            table.columns = {test::columnOf("3", "mm", {0, 0.001, -0.002, 0.01})};
        }));
    NeutralTable letter = unevenTable();
    letter.axes[0].name = "Y";
    sample.refuses(
        "an axis that is no number", {letter}, ErrorCode::InvalidArgument, "master-axis");
    sample.writes("numbers of the settings", {letter})
        .with({{"master-axis", "7"}, {"axis", "9"}, {"n-cycles", "10"}})
        .containing({"kw.crosscomp.n_cycles 10\n"})
        .becoming(changed(unevenTable(),
            [](NeutralTable& table) {
                table.axes[0].name = "7";
                table.columns[0].target = "9";
                table.notes = {"n_cycles 10"};
            }))
        .within(0.00005 + 1e-12);

    const FormatSettings increments{{"list-unit", "increments"}};
    FormatSettings many = increments;
    many["increments-per-unit"] = "4000";
    FormatSettings none = increments;
    none["increments-per-unit"] = "0";
    FormatSettings counted = linear.settings;
    counted["increments-per-unit"] = "4000";
    sample.refuses(
        "increments of no size", {unevenTable()}, ErrorCode::InvalidArgument, "", increments);
    sample.refuses("no increments", {unevenTable()}, ErrorCode::InvalidArgument, "", none);
    sample.writes("in increments", {unevenTable()})
        .with(many)
        .readWith(counted)
        .containing({"kw.crosscomp.unit 0\n", "[2].setpoint 29000\n"})
        .within(0.5 / 4000 + 1e-12);

    sample.writes("a closed period", {wrapped({0, 90, 360}, {0.1, 0.2, 0.1}, 360)})
        .readWith(turning);
    sample
        .writes(
            "ends that are rounded apart", {wrapped({0, 90, 360}, {0.00004, 0.2, 0.00006}, 360)})
        .readWith(turning)
        .becoming(wrapped({0, 90, 360}, {0, 0.2, 0}, 360));
    const auto cannotHold = ErrorCode::FormatCannotHold;
    sample.refuses("an open period", {wrapped({0, 90, 360}, {0.1, 0.2, 0.3}, 360)}, cannotHold);
    sample.refuses("part of a period", {wrapped({0, 90, 350}, {0.1, 0.2, 0.1}, 360)}, cannotHold);
    const auto at = [](std::vector<double> knots) {
        NeutralTable table = unevenTable();
        table.axes[0].knots = std::move(knots);
        return table;
    };
    sample.refuses("too far", {at({-20.5, 0.0, 7.25, 1e6})}, cannotHold);
    sample.refuses("too fine", {at({0, 1, 1.00001, 2})}, cannotHold);

    const auto row = sample.problemRow();
    row("another list", "kw.ssfk.unit 1\n", "warning 1:1 Assumption");
    row("no entry at all", "kopf.achs_nr 1\n", "0:0 Syntax |a table kw.crosscomp, of which");
    row("without a size", with("kw.crosscomp.last_index 2\n", ""),
        "0:0 Syntax |the entry kw.crosscomp.last_index");
    row("without a master", with("kw.crosscomp.master_ax_nr 1\n", ""),
        "0:0 Syntax |the entry kw.crosscomp.master_ax_nr");
    row("one point", with("last_index 2", "last_index 0"),
        "4:25 LimitExceeded kw.crosscomp.last_index 0|1 to");
    row("a size that is none", with("last_index 2", "last_index two"), "4:25 NotANumber two|");
    row("too many", with("last_index 2", "last_index 1001"),
        "0:0 LimitExceeded 1002 points|at most 1001");
    row("more than max_points", with("last_index 2", "last_index 2\nkw.crosscomp.max_points 2"),
        "5:0 LimitExceeded 3 points|at most 2");
    row("absurd", with("last_index 2", "last_index 999999999\nkw.crosscomp.max_points 2147483647"),
        "0:0 MissingPoint no kw.crosscomp.table[3].setpoint|1000000000 of them; there are 3");
    row("a point is missing", with("kw.crosscomp.table[1].correction -30\n", ""),
        "0:0 MissingPoint no kw.crosscomp.table[1].correction|3 of them; there are 2");
    row("truncated", three.substr(0, three.size() - 4), "10:1 Syntax kw.crosscomp.table[2].corr");
    row("an index beyond", with("table[2].setpoint", "table[7].setpoint"),
        "9:1 Contradiction kw.crosscomp.table[7].setpoint|indices within");
    row("twice", with("table[2].setpoint", "table[1].setpoint"),
        "9:1 DuplicatePoint kw.crosscomp.table[1].setpoint a second time");
    row("an entry twice", three + "kw.crosscomp.unit 0\n",
        "11:1 Contradiction kw.crosscomp.unit a second time|each entry once; the first is in "
        "line 2");
    row("two axis numbers", three + "kopf.log_achs_nr 4\n",
        "11:0 Contradiction kopf.log_achs_nr 4|3, as kopf.achs_nr says");
    row("not ascending", with("setpoint 150000", "setpoint 90000"),
        "9:0 NotMonotonic 90000 after 100000|ascending setpoints", "70245");
    row("the same once it is in mm", with("setpoint 100000", "setpoint 1e-322"),
        "7:0 NotMonotonic 0 after 0|strictly increasing");
    row("a decimal comma", with("correction -30", "correction -3,0"),
        "8:34 NotANumber -3,0|a number");
    row("a bad index", with("table[2].setpoint", "table[x].setpoint"),
        "9:19 Syntax [x].setpoint 150000|an index from 0");
    row("a negative index", with("table[2].setpoint", "table[-2].setpoint"), "9:19 Syntax");
    row("an index that does not end", with("table[2].setpoint", "table[2.setpoint"), "9:19 Syntax");
    row("two indices", with("table[2].setpoint", "table[2][0].setpoint"),
        "9:1 Syntax kw.crosscomp.table[2][0].setpoint|a point kw.crosscomp.table[]. with one "
        "index");
    row("no value", with("setpoint 150000", "setpoint"),
        "9:1 Syntax kw.crosscomp.table[2].setpoint|a value");
    row("unit 2", with("unit 1", "unit 2"), "2:19 LimitExceeded kw.crosscomp.unit 2|0 to 1");
    row("after End", three + "End\nkw.crosscomp.unit 1\n",
        "12:1 Syntax kw.crosscomp.unit|nothing after End");
    row("further problems",
        test::with(with("correction 10", "correction x"), "correction -30", "correction y"),
        "6:34 NotANumber x|a number\n8:34 NotANumber y|a number\n");
    FormatSettings modulo = linear.settings;
    modulo["modulo"] = "yes";
    row("a modulo master with other values at its end", three.substr(0, three.size() - 2) + "1\n",
        "10:0 NotPeriodic", "", modulo);
}

} // namespace

class TestIsgCrosscomp : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theExampleOfTheManualIsRead()
    {
        const std::string text = "# ****************************************\n"
                                 "# Axis compensation data of Z-axis\n"
                                 "# ****************************************\n"
                                 "kopf.achs_nr 3\n"
                                 "kopf.log_achs_name Z axis (the quill)\n"
                                 "kw.crosscomp.last_index 1 /*Last valid index of the table*/\n"
                                 "kw.crosscomp.master_ax_nr 1 /*Log. ax. number*/\n"
                                 "kw.crosscomp.unit 1 /*0:Incr. 1:Metric in 0.1 um*/\n"
                                 "kw.crosscomp.n_cycles 10\n"
                                 "#\n"
                                 "kw.crosscomp.table[0].setpoint 10735\n"
                                 "kw.crosscomp.table[0].correction 3\n"
                                 "kw.crosscomp.table[ 1 ].sollw 10000000 /*at 1000 mm*/\n"
                                 "kw.crosscomp.table[1].correction\t1000\n"
                                 "End\n";
        READ_TABLE(table, format, text, linear);
        QCOMPARE(table.axes[0].name, std::string("1"));
        QCOMPARE(table.axes[0].unit, std::string("mm"));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{1.0735, 1000.0}));
        QCOMPARE(table.columns[0].target, std::string("3"));
        QCOMPARE(table.columns[0].values, (std::vector<double>{0.0003, 0.1}));
        QCOMPARE(table.name, std::string("Z axis"));
        QCOMPARE(table.notes,
            (std::vector<std::string>{"Axis compensation data of Z-axis", "n_cycles 10"}));
        QCOMPARE(table.sign, SignConvention::Command);
        QVERIFY2(reading_table->diagnostics.empty(), problemLines(*reading_table).c_str());
    }

    void incrementsAreConvertedWhenTheSettingSaysHowManyAUnitHas()
    {
        const std::string text = with("unit 1", "unit 0");
        READ_TABLE(plain, format, text, linear);
        QCOMPARE(plain.axes[0].unit, std::string("increments"));
        QCOMPARE(plain.axes[0].knots, (std::vector<double>{0, 100000, 150000}));
        QVERIFY(test::hasProblem(*reading_plain, DiagnosticCode::UnitNotGiven, 2));
        TableReadOptions options = linear;
        options.settings["increments-per-unit"] = "20000";
        READ_TABLE(table, format, text, options);
        QCOMPARE(table.axes[0].unit, std::string("mm"));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{0, 5, 7.5}));
        QCOMPARE(table.columns[0].values[1], -0.0015);
    }

    void whetherAnAxisIsLinearOrRotaryIsSaidByASettingOrAWarning()
    {
        const auto reading = format.read(three, {});
        VERIFY_RESULT(reading);
        QCOMPARE(reading->tables.front().axes[0].unit, std::string("mm"));
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::Assumption, 2));
        TableReadOptions options = linear;
        options.settings["master-kind"] = "rotary";
        READ_TABLE(table, format, three, options);
        QCOMPARE(table.axes[0].unit, std::string("deg"));
        QCOMPARE(table.columns[0].unit, std::string("mm"));
    }

    void aListWithoutTheEntryUnitIsTakenToBeInIncrementsWithAWarning()
    {
        READ_TABLE(table, format, with("kw.crosscomp.unit 1\n", ""), linear);
        QCOMPARE(table.axes[0].unit, std::string("increments"));
        QVERIFY(test::hasProblem(*reading_table, DiagnosticCode::Assumption, 0));
    }

    void aModuloMasterMustHaveTheSameValuesAtBothEnds()
    {
        TableReadOptions options = linear;
        options.settings["modulo"] = "yes";
        READ_TABLE(table, format, three, options);
        QCOMPARE(table.axes[0].wrap, std::optional(15.0));
        QCOMPARE(applied(format, table, {20.0}), -0.001); // 5 of the next turn
    }

    void decimalsAreReadAndWrittenOnlyWhenAskedFor()
    {
        READ_TABLE(table, format, with("correction -30", "correction -30.25"), linear);
        QCOMPARE(table.columns[0].values[1], -0.003025);
        WRITE_TABLE(whole, format, table, {});
        QVERIFY(whole->bytes.find("correction -30\n") != std::string::npos);
        QCOMPARE(whole->held.front().columns[0].values[1], -0.003);
        TableWriteOptions options;
        options.settings["decimals"] = "yes";
        WRITE_TABLE(exact, format, table, options);
        QVERIFY(exact->bytes.find("correction -30.25\n") != std::string::npos);
        COMPARE_TABLES(exact->held.front(), table, 0.0);
    }

    void twoMegabytesAreReadWhole()
    {
        std::string text = head + "kw.crosscomp.max_points 40000\nkw.crosscomp.last_index 29999\n";
        for (int i = 0; i < 30000; ++i)
            text += "kw.crosscomp.table[" + std::to_string(i) + "].setpoint " + std::to_string(i)
                + "\nkw.crosscomp.table[" + std::to_string(i) + "].correction 17\n";
        QVERIFY(text.size() > 2'000'000);
        READ_TABLE(table, format, text, linear);
        QCOMPARE(table.pointCount(), std::size_t(30000));
    }
};

AXISCOMP_TEST(TestIsgCrosscomp)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_isgcrosscomp

#include "tst_isgcrosscomp.moc"
