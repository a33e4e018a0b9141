// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_checks.h"
#include "tests/support/test_registry.h"

namespace tst_isgcrosscomp {

using namespace axiscomp;
using test::applied;
using test::problemLines;

namespace {

const TableFamily& family = isg_crosscomp::format();

TableReadOptions linear()
{
    TableReadOptions options;
    options.settings = {{"master-kind", "linear"}, {"axis-kind", "linear"}};
    return options;
}

const std::string head = "kopf.achs_nr 3\nkw.crosscomp.unit 1\nkw.crosscomp.master_ax_nr 1\n";
const std::string three = head
    + "kw.crosscomp.last_index 2\n"
      "kw.crosscomp.table[0].setpoint 0\nkw.crosscomp.table[0].correction 10\n"
      "kw.crosscomp.table[1].setpoint 100000\nkw.crosscomp.table[1].correction -30\n"
      "kw.crosscomp.table[2].setpoint 150000\nkw.crosscomp.table[2].correction 10\n";

NeutralTable unevenTable()
{
    NeutralTable table;
    table.sign = SignConvention::Command;
    SourceAxis axis;
    axis.name = "1";
    axis.unit = "mm";
    axis.knots = {-20.5, 0.0, 7.25, 100.0};
    table.axes = {axis};
    table.columns = {test::waveColumn("3", "mm", 4, 0.05)};
    return table;
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
        READ_TABLE(table, family, text, linear());
        QCOMPARE(table.axes[0].name, std::string("1"));
        QCOMPARE(table.axes[0].unit, std::string("mm"));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{1.0735, 1000.0}));
        QCOMPARE(table.columns[0].target, std::string("3"));
        QCOMPARE(table.columns[0].values, (std::vector<double>{0.0003, 0.1}));
        QCOMPARE(table.columns[0].step, 0.0001);
        QCOMPARE(table.name, std::string("Z axis"));
        QCOMPARE(table.notes, (std::vector<std::string>{"Axis compensation data of Z-axis"}));
        QCOMPARE(table.sign, SignConvention::Command);
        QVERIFY2(reading_table->diagnostics.empty(), problemLines(*reading_table).c_str());
    }

    void itIsLinearBetweenThePointsAndHeldOutside()
    {
        READ_TABLE(table, family, three, linear());
        QCOMPARE(applied(family, table, {5.0}), -0.001);
        QCOMPARE(applied(family, table, {12.5}), -0.001);
        QCOMPARE(applied(family, table, {-1e6}), 0.001);
        QCOMPARE(applied(family, table, {1e6}), 0.001);
    }

    void incrementsAreConvertedWhenTheSettingSaysHowManyAUnitHas()
    {
        std::string text = three;
        text.replace(text.find("unit 1"), 6, "unit 0");
        READ_TABLE(plain, family, text, linear());
        QCOMPARE(plain.axes[0].unit, std::string("increments"));
        QCOMPARE(plain.axes[0].knots, (std::vector<double>{0, 100000, 150000}));
        QVERIFY(test::hasProblem(*reading_plain, DiagnosticCode::UnitNotGiven, 2));
        TableReadOptions options = linear();
        options.settings["increments-per-unit"] = "20000";
        READ_TABLE(table, family, text, options);
        QCOMPARE(table.axes[0].unit, std::string("mm"));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{0, 5, 7.5}));
        QCOMPARE(table.columns[0].values[1], -0.0015);
    }

    void whetherAnAxisIsLinearOrRotaryIsSaidByASettingOrAWarning()
    {
        const auto reading = family.read(three, {});
        VERIFY_RESULT(reading);
        QCOMPARE(reading->tables.front().axes[0].unit, std::string("mm"));
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::Assumption, 2));
        TableReadOptions options = linear();
        options.settings["master-kind"] = "rotary";
        READ_TABLE(table, family, three, options);
        QCOMPARE(table.axes[0].unit, std::string("deg"));
        QCOMPARE(table.columns[0].unit, std::string("mm"));
    }

    void aListWithoutTheEntryUnitIsTakenToBeInIncrementsWithAWarning()
    {
        std::string text = three;
        text.erase(text.find("kw.crosscomp.unit"), 20);
        READ_TABLE(table, family, text, linear());
        QCOMPARE(table.axes[0].unit, std::string("increments"));
        QVERIFY(test::hasProblem(*reading_table, DiagnosticCode::Assumption, 0));
    }

    void aModuloMasterMustHaveTheSameValuesAtBothEnds()
    {
        TableReadOptions options = linear();
        options.settings["modulo"] = "yes";
        READ_TABLE(table, family, three, options);
        QCOMPARE(table.axes[0].wrap, std::optional(15.0));
        QCOMPARE(applied(family, table, {20.0}), -0.001); // 5 of the next turn
        std::string open = three;
        open.replace(open.rfind("correction 10"), 13, "correction 11");
        const auto reading = family.read(open, options);
        VERIFY_RESULT(reading);
        QVERIFY(reading->tables.empty());
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::NotPeriodic, 10));
    }

    void anUnknownEntryIsAWarningAndAnotherTableOfTheListIsNamed()
    {
        READ_TABLE(table, family,
            three + "kw.crosscomp.colour 3\nkw.ssfk.unit 1\nkw.ssfk.bilateral 0\nfoo 1\n",
            linear());
        QCOMPARE(table.axes[0].knots.size(), std::size_t(3));
        QCOMPARE(problemLines(*reading_table),
            std::string("warning 11:1 UnknownKey kw.crosscomp.colour|\n"
                        "warning 12:1 Assumption a table kw.ssfk besides kw.crosscomp|the format "
                        "isg-ssfk to read it; it is left out here\n"
                        "warning 14:1 UnknownKey foo|\n"));
    }

    void decimalsAreReadAndWrittenOnlyWhenAskedFor()
    {
        std::string text = three;
        text.replace(text.find("correction -30"), 14, "correction -30.25");
        READ_TABLE(table, family, text, linear());
        QCOMPARE(table.columns[0].values[1], -0.003025);
        QCOMPARE(table.columns[0].step, 0.0);
        const auto whole = family.write(std::array{table}, {});
        VERIFY_RESULT(whole);
        QVERIFY(whole->bytes.find("correction -30\n") != std::string::npos);
        QCOMPARE(whole->held.front().columns[0].values[1], -0.003);
        TableWriteOptions options;
        options.settings["decimals"] = "yes";
        const auto exact = family.write(std::array{table}, options);
        VERIFY_RESULT(exact);
        QVERIFY(exact->bytes.find("correction -30.25\n") != std::string::npos);
        COMPARE_TABLES(exact->held.front(), table, 0.0);
    }

    void whatIsWrittenIsReadBackWithinHalfAStep()
    {
        NeutralTable table = unevenTable();
        table.notes = {"measured in March", "two\nlines"};
        table.name = "Z";
        const auto written = family.write(std::array{table}, {});
        VERIFY_RESULT(written);
        READ_TABLE(again, family, written->bytes, linear());
        QCOMPARE(again, written->held.front());
        COMPARE_TABLES(again, table, 0.00005 + 1e-12);
        QVERIFY(again.columns[0].values != table.columns[0].values); // they were rounded
        QCOMPARE(again.notes, (std::vector<std::string>{"measured in March", "two", "lines"}));
        QCOMPARE(again.name, table.name);
    }

    void theWriterTellsTheActivationLine()
    {
        const auto written = family.write(std::array{unevenTable()}, {});
        VERIFY_RESULT(written);
        const auto& remarks = written->remarks;
        QVERIFY(std::ranges::find(
                    remarks, "activate it in the axis list of axis 3: lr_param.crosscomp 1")
            != remarks.end());
    }

    void millimetresAndDegreesBecomeNumbersOfTheList()
    {
        NeutralTable table = unevenTable();
        table.axes[0].unit = "deg";
        table.columns[0].unit = "um";
        table.columns[0].values = {0, 1, -2, 10};
        const auto written = family.write(std::array{table}, {});
        VERIFY_RESULT(written);
        QVERIFY(written->bytes.find("[0].setpoint -205000\n") != std::string::npos);
        QVERIFY(written->bytes.find("[2].correction -20\n") != std::string::npos);
        QCOMPARE(written->held.front().axes[0].unit, std::string("deg"));
        QCOMPARE(written->held.front().columns[0].unit, std::string("mm"));
    }

    void aListInIncrementsNeedsToKnowHowManyAUnitHas()
    {
        TableWriteOptions options;
        options.settings = {{"list-unit", "increments"}};
        VERIFY_ERROR(family.write(std::array{unevenTable()}, options), ErrorCode::InvalidArgument);
        options.settings["increments-per-unit"] = "4000";
        const auto written = family.write(std::array{unevenTable()}, options);
        VERIFY_RESULT(written);
        QVERIFY(written->bytes.find("kw.crosscomp.unit 0\n") != std::string::npos);
        QVERIFY(written->bytes.find("[2].setpoint 29000\n") != std::string::npos);
        options.settings["increments-per-unit"] = "0";
        VERIFY_ERROR(family.write(std::array{unevenTable()}, options), ErrorCode::InvalidArgument);
    }

    void axesThatAreNoNumbersNeedASetting()
    {
        NeutralTable table = unevenTable();
        table.axes[0].name = "Y";
        const auto refused = family.write(std::array{table}, {});
        VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
        QVERIFY(test::describe(refused.error()).find("master-axis") != std::string::npos);
        TableWriteOptions options;
        options.settings = {{"master-axis", "7"}, {"axis", "9"}, {"n-cycles", "10"}};
        const auto written = family.write(std::array{table}, options);
        VERIFY_RESULT(written);
        QCOMPARE(written->held.front().axes[0].name, std::string("7"));
        QCOMPARE(written->held.front().columns[0].target, std::string("9"));
        QVERIFY(written->bytes.find("kw.crosscomp.n_cycles 10\n") != std::string::npos);
    }

    void aModuloTableIsWrittenOnlyOverOneClosedPeriod()
    {
        const auto good = wrapped({0, 90, 360}, {0.1, 0.2, 0.1}, 360);
        const auto written = family.write(std::array{good}, {});
        VERIFY_RESULT(written);
        COMPARE_TABLES(written->held.front(), good, 0.0);
        const auto open = wrapped({0, 90, 360}, {0.1, 0.2, 0.3}, 360);
        VERIFY_ERROR(family.write(std::array{open}, {}), ErrorCode::FormatCannotHold);
        const auto part = wrapped({0, 90, 350}, {0.1, 0.2, 0.1}, 360);
        VERIFY_ERROR(family.write(std::array{part}, {}), ErrorCode::FormatCannotHold);
        const auto roundedApart = wrapped({0, 90, 360}, {0.00004, 0.2, 0.00006}, 360);
        const auto closed = family.write(std::array{roundedApart}, {});
        VERIFY_RESULT(closed);
        QVERIFY(closed->held.front().columns[0].values.front()
            == closed->held.front().columns[0].values.back());
    }

    void whatTheNumbersCannotHoldIsRefused()
    {
        NeutralTable far = unevenTable();
        far.axes[0].knots.back() = 1e6;
        VERIFY_ERROR(family.write(std::array{far}, {}), ErrorCode::FormatCannotHold);
        NeutralTable fine = unevenTable();
        fine.axes[0].knots = {0, 1, 1.00001, 2};
        VERIFY_ERROR(family.write(std::array{fine}, {}), ErrorCode::FormatCannotHold);
        NeutralTable many = unevenTable();
        many.axes[0] = test::evenAxis("1", "mm", 0, 1, 1002);
        many.columns = {test::waveColumn("3", "mm", 1002, 1)};
        VERIFY_ERROR(checkHolds(family.facts, std::array{many}), ErrorCode::FormatCannotHold);
    }

    void aProblemNamesItsPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("problem"); // the beginning of the first one
        const auto row = [](const char* name, const std::string& text, const char* problem) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(problem);
        };
        const auto with = [](std::string from, const std::string& to) {
            std::string text = three;
            return text.replace(text.find(from), from.size(), to);
        };
        row("empty", "", "0:0 EmptyFile");
        row("binary", std::string("kw.crosscomp\0.unit 1", 20), "1:0 NotText");
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
        row("absurd",
            with("last_index 2", "last_index 999999999\nkw.crosscomp.max_points 2147483647"),
            "0:0 MissingPoint no kw.crosscomp.table[3].setpoint|1000000000 of them; there are 3");
        row("a point is missing", with("kw.crosscomp.table[1].correction -30\n", ""),
            "0:0 MissingPoint no kw.crosscomp.table[1].correction|3 of them; there are 2");
        row("truncated", three.substr(0, three.size() - 4),
            "10:1 Syntax kw.crosscomp.table[2].corr");
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
            "9:0 NotMonotonic 90000 after 100000|ascending setpoints #70245");
        row("the same once it is in mm", with("setpoint 100000", "setpoint 1e-322"),
            "7:0 NotMonotonic 0 after 0|strictly increasing");
        row("a decimal comma", with("correction -30", "correction -3,0"),
            "8:34 NotANumber -3,0|a number");
        row("a bad index", with("table[2].setpoint", "table[x].setpoint"),
            "9:19 Syntax [x].setpoint 150000|an index from 0");
        row("a negative index", with("table[2].setpoint", "table[-2].setpoint"), "9:19 Syntax");
        row("an index that does not end", with("table[2].setpoint", "table[2.setpoint"),
            "9:19 Syntax");
        row("two indices", with("table[2].setpoint", "table[2][0].setpoint"),
            "9:1 Syntax kw.crosscomp.table[2][0].setpoint|a point kw.crosscomp.table[]. with one "
            "index");
        row("no value", with("setpoint 150000", "setpoint"),
            "9:1 Syntax kw.crosscomp.table[2].setpoint|a value");
        row("unit 2", with("unit 1", "unit 2"), "2:19 LimitExceeded kw.crosscomp.unit 2|0 to 1");
        row("after End", three + "End\nkw.crosscomp.unit 1\n",
            "12:1 Syntax kw.crosscomp.unit|nothing after End");
    }
    void aProblemNamesItsPlace()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, problem);
        const auto reading = family.read(text.toStdString(), linear());
        VERIFY_RESULT(reading);
        QVERIFY(reading->tables.empty());
        const std::string found = problemLines(*reading);
        QVERIFY2(found.starts_with(problem.toStdString()), found.c_str());
    }

    void furtherProblemsAreReportedToo()
    {
        std::string text = three;
        text.replace(text.find("correction 10"), 13, "correction x");
        text.replace(text.find("correction -30"), 14, "correction y");
        const auto reading = family.read(text, linear());
        VERIFY_RESULT(reading);
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::NotANumber, 6));
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::NotANumber, 8));
    }

    void aFileIsRecognisedByTheNamesOfItsEntries()
    {
        QCOMPARE(family.recognise(three), Recognition::Certain);
        QCOMPARE(family.recognise(three + "kw.ssfk.unit 1\n"), Recognition::Possible);
        QCOMPARE(family.recognise("kw.crosscomp2.unit 1\n"), Recognition::No);
        QCOMPARE(family.recognise("1 2\n0 1\n1 1\n"), Recognition::No);
        QCOMPARE(family.recognise(""), Recognition::No);
    }

    void twoMegabytesAreReadWhole()
    {
        std::string text = head + "kw.crosscomp.max_points 40000\nkw.crosscomp.last_index 29999\n";
        for (int i = 0; i < 30000; ++i)
            text += "kw.crosscomp.table[" + std::to_string(i) + "].setpoint " + std::to_string(i)
                + "\nkw.crosscomp.table[" + std::to_string(i) + "].correction 17\n";
        QVERIFY(text.size() > 2'000'000);
        READ_TABLE(table, family, text, linear());
        QCOMPARE(table.pointCount(), std::size_t(30000));
    }
};

AXISCOMP_TEST(TestIsgCrosscomp)

} // namespace tst_isgcrosscomp

#include "tst_isgcrosscomp.moc"
