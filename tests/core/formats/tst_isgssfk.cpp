// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_checks.h"
#include "tests/support/test_registry.h"

namespace tst_isgssfk {

using namespace axiscomp;
using test::applied;
using test::problemLines;

namespace {

const TableFamily& family = isg_ssfk::format();

TableReadOptions linear()
{
    TableReadOptions options;
    options.settings = {{"axis-kind", "linear"}};
    return options;
}

/// The manual's example, cut to four points.
const std::string bilateral = "kopf.log_achs_nr 2\nkopf.log_achs_name Y AXIS\n"
                              "kw.ssfk.interval 0\nkw.ssfk.kw_startpos -200000\n"
                              "kw.ssfk.kw_nr_max 4\nkw.ssfk.unit 1\nkw.ssfk.bilateral 1\n"
                              "kw.ssfk.table[0].setpoint -200000\n"
                              "kw.ssfk.table[1].setpoint -199306\n"
                              "kw.ssfk.table[2].setpoint -198667\n"
                              "kw.ssfk.table[3].setpoint -198001\n"
                              "kw.ssfk.table[0].pos 0\nkw.ssfk.table[1].pos 24\n"
                              "kw.ssfk.table[2].pos -102\nkw.ssfk.table[3].pos 5\n"
                              "kw.ssfk.table[0].neg 0\nkw.ssfk.table[1].neg 67\n"
                              "kw.ssfk.table[2].neg 80\nkw.ssfk.table[3].neg 5\n";
const std::string even =
    "kopf.achs_nr 2\nkw.ssfk.unit 1\nkw.ssfk.interval 100000\n"
    "kw.ssfk.kw_startpos -100000\nkw.ssfk.kw_nr_max 3\nkw.ssfk.bilateral 0\n"
    "kw.ssfk.table[0].pos 7\nkw.ssfk.table[1].pos -4\nkw.ssfk.table[2].pos 7\n";

std::string with(std::string text, const std::string& from, const std::string& to)
{
    return text.replace(text.find(from), from.size(), to);
}

NeutralTable oneColumn()
{
    NeutralTable table;
    table.axes = {test::evenAxis("2", "mm", -30, 2.5, 20)};
    table.columns = {test::waveColumn("2", "mm", 20, 0.01)};
    return table;
}

NeutralTable twoDirections()
{
    NeutralTable table = oneColumn();
    table.columns.push_back(test::waveColumn("2", "mm", 20, -0.02));
    table.columns[0].direction = Direction::Positive;
    table.columns[1].direction = Direction::Negative;
    return table;
}

} // namespace

class TestIsgSsfk : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void eachDirectionHasItsValues()
    {
        READ_TABLE(table, family, bilateral, linear());
        QCOMPARE(table.axes[0].name, std::string("2"));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{-20, -19.9306, -19.8667, -19.8001}));
        QCOMPARE(table.columns.size(), std::size_t(2));
        QCOMPARE(table.columns[0].direction, Direction::Positive);
        QCOMPARE(table.columns[0].values[2], -0.0102);
        QCOMPARE(table.columns[1].direction, Direction::Negative);
        QCOMPARE(table.columns[1].values[2], 0.008);
        QCOMPARE(table.name, std::string("Y AXIS"));
        QVERIFY2(reading_table->diagnostics.empty(), problemLines(*reading_table).c_str());
    }

    void theValueIsTheMeasuredPositionLessTheCommandedOne()
    {
        // The manual: commanded -19.8667 mm, measured 10.2 um less in positive direction.
        READ_TABLE(table, family, bilateral, linear());
        QCOMPARE(table.sign, SignConvention::Feedback);
        QCOMPARE(applied(family, table, {-19.8667}, 0), -0.0102);
        QCOMPARE(family.facts.signEvidence, Evidence::Published);
    }

    void itIsLinearBetweenThePointsAndHeldOutside()
    {
        READ_TABLE(table, family, even, linear());
        QCOMPARE(table.columns[0].direction, Direction::Both);
        QCOMPARE(table.axes[0].knots, (std::vector<double>{-10, 0, 10}));
        QCOMPARE(applied(family, table, {-5}), 0.00015);
        QCOMPARE(applied(family, table, {-11}), 0.0007);
        QCOMPARE(applied(family, table, {1e9}), 0.0007);
    }

    void aModuloAxisMustHaveTheSameValuesAtBothEnds()
    {
        READ_TABLE(table, family, even + "kw.ssfk.modulo 1\n", linear());
        QCOMPARE(table.axes[0].wrap, std::optional(20.0));
        QCOMPARE(applied(family, table, {20}), -0.0004);
        const auto reading =
            family.read(with(even, "[2].pos 7", "[2].pos 8") + "kw.ssfk.modulo 1\n", linear());
        VERIFY_RESULT(reading);
        QVERIFY(reading->tables.empty());
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::NotPeriodic, 9));
    }

    void withoutBilateralTheNegativeValuesAreLeftOut()
    {
        READ_TABLE(table, family, with(bilateral, "bilateral 1", "bilateral 0"), linear());
        QCOMPARE(table.columns.size(), std::size_t(1));
        QVERIFY(test::hasProblem(*reading_table, DiagnosticCode::Assumption, 7));
    }

    void whatIsWrittenIsReadBackWithinHalfAStep_data()
    {
        QTest::addColumn<bool>("isPair");
        QTest::addColumn<bool>("isEven");
        QTest::addRow("both, even") << false << true;
        QTest::addRow("pair, even") << true << true;
        QTest::addRow("both, uneven") << false << false;
        QTest::addRow("pair, uneven") << true << false;
    }
    void whatIsWrittenIsReadBackWithinHalfAStep()
    {
        QFETCH(bool, isPair);
        QFETCH(bool, isEven);
        NeutralTable table = isPair ? twoDirections() : oneColumn();
        if (!isEven)
            table.axes[0].knots[3] += 0.7;
        const auto written = family.write(std::array{table}, {});
        VERIFY_RESULT(written);
        const bool hasSetpoints = written->bytes.find("setpoint") != std::string::npos;
        QCOMPARE(hasSetpoints, !isEven);
        READ_TABLE(again, family, written->bytes, linear());
        QCOMPARE(again, written->held.front());
        COMPARE_TABLES(again, table, 0.00005 + 1e-12);
        QVERIFY(std::ranges::find(
                    written->remarks, "activate it in the axis list of axis 2: lr_param.ssfk 1")
            != written->remarks.end());
    }

    void aDistanceThatIsNoWholeNumberIsWrittenAsSetpoints()
    {
        NeutralTable table = oneColumn();
        table.axes[0] = test::evenAxis("2", "mm", 0, 1.0 / 3.0, 20);
        const auto written = family.write(std::array{table}, {});
        VERIFY_RESULT(written);
        QVERIFY(written->bytes.find("kw.ssfk.interval 0\n") != std::string::npos);
        COMPARE_TABLES(written->held.front(), table, 0.00005 + 1e-12);
    }

    void aModuloAxisIsWrittenOverOnePeriod()
    {
        NeutralTable table = oneColumn();
        table.axes[0] = test::evenAxis("2", "deg", 0, 18, 21);
        table.axes[0].wrap = 360;
        table.columns = {test::waveColumn("2", "deg", 21, 0.01)};
        table.columns[0].values.back() = 0.5;
        VERIFY_ERROR(family.write(std::array{table}, {}), ErrorCode::FormatCannotHold);
        table.columns[0].values.back() = table.columns[0].values.front();
        const auto written = family.write(std::array{table}, {});
        VERIFY_RESULT(written);
        QCOMPARE(written->held.front().axes[0].wrap, std::optional(360.0));
        QCOMPARE(written->held.front().axes[0].unit, std::string("deg"));
    }

    void otherColumnsAreRefused()
    {
        NeutralTable onlyPositive = twoDirections();
        onlyPositive.columns.pop_back();
        VERIFY_ERROR(family.write(std::array{onlyPositive}, {}), ErrorCode::FormatCannotHold);
        NeutralTable cross = oneColumn();
        cross.columns[0].target = "3";
        const auto refused = family.write(std::array{cross}, {});
        VERIFY_ERROR(refused, ErrorCode::FormatCannotHold);
        QVERIFY(test::describe(refused.error()).find("isg-crosscomp") != std::string::npos);
    }

    void aListInIncrementsKeepsThem()
    {
        std::string text = with(even, "unit 1", "unit 0");
        READ_TABLE(table, family, text, linear());
        TableWriteOptions options;
        options.settings = {{"list-unit", "increments"}};
        const auto written = family.write(std::array{table}, options);
        VERIFY_RESULT(written);
        QCOMPARE(written->held.front(), table);
        VERIFY_ERROR(family.write(std::array{table}, {}), ErrorCode::InvalidArgument);
    }

    void aProblemNamesItsPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("problem"); // the beginning of the first one
        const auto row = [](const char* name, const std::string& text, const char* problem) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(problem);
        };
        row("empty", "", "0:0 EmptyFile");
        row("no size", with(even, "kw.ssfk.kw_nr_max 3\n", ""),
            "0:0 Syntax |the entry kw.ssfk.kw_nr_max");
        row("one point", with(even, "nr_max 3", "nr_max 1"),
            "5:19 LimitExceeded kw.ssfk.kw_nr_max 1|2 to");
        row("too many", with(even, "nr_max 3", "nr_max 1501"),
            "0:0 LimitExceeded 1501 points|at most 1500");
        row("absurd", with(even, "nr_max 3", "nr_max 1000000000\nkw.ssfk.max_points 1000000000"),
            "0:0 MissingPoint no kw.ssfk.table[3].pos|1000000000 of them; there are 3");
        row("a value is missing", with(even, "kw.ssfk.table[1].pos -4\n", ""),
            "0:0 MissingPoint no kw.ssfk.table[1].pos|3");
        row("the negative ones are missing", with(even, "bilateral 0", "bilateral 1"),
            "0:0 MissingPoint no kw.ssfk.table[0].neg|3 of them; there are 0");
        row("setpoints are missing", with(even, "interval 100000", "interval 0"),
            "0:0 MissingPoint no kw.ssfk.table[0].setpoint|3");
        row("interval and setpoints", with(bilateral, "interval 0", "interval 5"),
            "3:0 Contradiction kw.ssfk.interval 5 and setpoints of each point|");
        row("negative interval", with(even, "interval 100000", "interval -5"),
            "3:0 LimitExceeded kw.ssfk.interval -5|0, or a distance above 0");
        row("not ascending", with(bilateral, "setpoint -198667", "setpoint -199306"),
            "10:0 NotMonotonic -19.9306 after -19.9306|strictly increasing");
        row("modulo 2", even + "kw.ssfk.modulo 2\n", "10:16 LimitExceeded kw.ssfk.modulo 2|0 to 1");
        row("a number that is none", with(even, "[1].pos -4", "[1].pos nan"),
            "8:22 NotANumber nan|a number");
        row("the axis number is none", with(even, "achs_nr 2", "achs_nr Y"),
            "1:14 NotANumber Y|the logical number of the axis");
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

    void aFileIsRecognisedByTheNamesOfItsEntries()
    {
        QCOMPARE(family.recognise(bilateral), Recognition::Certain);
        QCOMPARE(family.recognise(even + "kw.crosscomp.unit 1\n"), Recognition::Possible);
        QCOMPARE(family.recognise("kw.crosscomp2.unit 1\n"), Recognition::No);
    }
};

AXISCOMP_TEST(TestIsgSsfk)

} // namespace tst_isgssfk

#include "tst_isgssfk.moc"
