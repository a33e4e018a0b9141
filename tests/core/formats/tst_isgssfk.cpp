// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_isgssfk {

using namespace axiscomp;
using test::applied;
using test::with;
using Lines = test::FormatSample::Lines;
using test::problemLines;

namespace {

const TableFormat& format = isg_ssfk::format();

const TableReadOptions linear = test::readingWith({{"axis-kind", "linear"}});

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

const std::string oneSided = with(bilateral, "bilateral 1", "bilateral 0");

NeutralTable oneColumn()
{
    return test::tableOf(SignConvention::Feedback, {test::evenAxis("2", "mm", -30, 2.5, 20)},
        {test::waveColumn("2", "mm", 20, 0.01)});
}

NeutralTable twoDirections()
{
    NeutralTable table = oneColumn();
    table.columns.push_back(test::waveColumn("2", "mm", 20, -0.02));
    table.columns[0].direction = Direction::Positive;
    table.columns[1].direction = Direction::Negative;
    return table;
}

void describe(test::FormatSample& sample)
{
    sample.facts =
        "feedback is published; 1 to 1 dimensions, any knots; "
        "points 1500, columns 1, tables 1, bytes 67108864; holds units notes directions wrap";
    sample.text = even;
    sample.reading = linear;
    sample.comment = "# ";
    sample.spareBytes = 1;
    sample.applies({{{-5}, 0.00015}, {{-11}, 0.0007}, {{1e9}, 0.0007}});
    // The manual: commanded -19.8667 mm, measured 10.2 um less in positive direction.
    sample.applies({{{-19.8667}, -0.0102}}, bilateral);
    sample.recognises(Recognition::Certain, {bilateral});
    sample.recognises(Recognition::Possible, {even + "kw.crosscomp.unit 1\n"});
    sample.recognises(Recognition::No, {"kw.crosscomp2.unit 1\n"});
    sample.warning("negative values without bilateral", oneSided, {"7:0 Assumption"});
    sample.warning("the example of the manual", bilateral, {});

    const Lines hint{"activate it in the axis list of axis 2: lr_param.ssfk 1\n"};
    const Lines withoutSetpoints{"kw.ssfk.interval 25000\n"};
    const Lines withSetpoints{"kw.ssfk.interval 0\n", "setpoint"};
    for (const bool isPair : {false, true}) {
        NeutralTable table = isPair ? twoDirections() : oneColumn();
        const std::string name = isPair ? "a pair, " : "one column, ";
        sample.writes(name + "even", {table})
            .within(0.00005 + 1e-12)
            .containing(withoutSetpoints)
            .remarking(hint);
        table.axes[0].knots[3] += 0.7;
        sample.writes(name + "uneven", {table})
            .within(0.00005 + 1e-12)
            .containing(withSetpoints)
            .remarking(hint);
    }
    NeutralTable thirds = oneColumn();
    thirds.axes[0] = test::evenAxis("2", "mm", 0, 1.0 / 3.0, 20);
    sample.writes("a distance that is no whole number", {thirds})
        .within(0.00005 + 1e-12)
        .containing(withSetpoints);
    NeutralTable turn = oneColumn();
    turn.axes[0] = test::evenAxis("2", "deg", 0, 18, 21);
    turn.axes[0].wrap = 360;
    turn.columns = {test::waveColumn("2", "deg", 21, 0.01)};
    turn.columns[0].values.back() = 0.5;
    sample.refuses("an open period", {turn}, ErrorCode::FormatCannotHold);
    turn.columns[0].values.back() = turn.columns[0].values.front();
    sample.writes("one period", {turn}).readWith({{"axis-kind", "rotary"}}).within(0.00005 + 1e-12);
    NeutralTable onlyPositive = twoDirections();
    onlyPositive.columns.pop_back();
    sample.refuses("half a pair", {onlyPositive}, ErrorCode::FormatCannotHold);
    NeutralTable cross = oneColumn();
    cross.columns[0].target = "3";
    sample.refuses("another axis", {cross}, ErrorCode::FormatCannotHold, "isg-crosscomp");
    NeutralTable increments = test::tableOf(SignConvention::Feedback,
        {test::evenAxis("2", "increments", -100000, 100000, 3)},
        {test::columnOf("2", "increments", {7, -4, 7})});
    sample.refuses("increments", {increments}, ErrorCode::InvalidArgument);
    sample.writes("increments stay what they are", {increments})
        .with({{"list-unit", "increments"}});

    const auto row = sample.problemRow();
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
    row("a modulo axis with other values at its end",
        with(even, "[2].pos 7", "[2].pos 8") + "kw.ssfk.modulo 1\n", "9:0 NotPeriodic");
}

} // namespace

class TestIsgSsfk : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void eachDirectionHasItsValues()
    {
        READ_TABLE(table, format, bilateral, linear);
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

    void oneColumnIsForBothDirections()
    {
        READ_TABLE(table, format, even, linear);
        QCOMPARE(table.columns[0].direction, Direction::Both);
        QCOMPARE(table.axes[0].knots, (std::vector<double>{-10, 0, 10}));
    }

    void withoutBilateralTheNegativeValuesAreLeftOut()
    {
        READ_TABLE(table, format, oneSided, linear);
        QCOMPARE(table.columns.size(), std::size_t(1));
    }

    void aModuloAxisMustHaveTheSameValuesAtBothEnds()
    {
        READ_TABLE(table, format, even + "kw.ssfk.modulo 1\n", linear);
        QCOMPARE(table.axes[0].wrap, std::optional(20.0));
        QCOMPARE(applied(format, table, {20}), -0.0004);
    }
};

AXISCOMP_TEST(TestIsgSsfk)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_isgssfk

#include "tst_isgssfk.moc"
