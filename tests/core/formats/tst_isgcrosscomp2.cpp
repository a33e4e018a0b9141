// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_isgcrosscomp2 {

using namespace axiscomp;

namespace {

const TableFormat& format = isg_crosscomp2::format();

const TableReadOptions linear = test::readingWith(
    {{"master1-kind", "linear"}, {"master2-kind", "linear"}, {"axis-kind", "linear"}});

/// 3 points along master 1, 2 along master 2; the value of [j][i] is 10 * j + i.
std::string plane()
{
    std::string text = "kopf.achs_nr 3\nkw.crosscomp2.unit 1\nkw.crosscomp2.interval 50000\n"
                       "kw.crosscomp2.last_index_master1 2\nkw.crosscomp2.last_index_master2 1\n"
                       "kw.crosscomp2.start_position_master1 -100000\n"
                       "kw.crosscomp2.start_position_master2 20000\n"
                       "kw.crosscomp2.master1_ax_nr 1\nkw.crosscomp2.master2_ax_nr 2\n";
    for (int j = 0; j < 2; ++j)
        for (int i = 0; i < 3; ++i)
            text += "kw.crosscomp2.table[" + std::to_string(j) + "][" + std::to_string(i)
                + "].correction " + std::to_string(10 * j + i) + '\n';
    return text;
}

const auto with = test::changing(plane());

NeutralTable planeTable(double distance1 = 5.0, double distance2 = 5.0)
{
    return test::commandTable({test::evenAxis("1", "mm", -10, distance1, 4),
                                  test::evenAxis("2", "mm", 0.5, distance2, 3)},
        {test::waveColumn("3", "mm", 12, 0.02)});
}

void describe(test::FormatSample& sample)
{
    sample.facts = "command is assumed; 2 to 2 dimensions, square knots; "
                   "points 10201, columns 1, tables 1, bytes 67108864; holds units notes wrap";
    sample.text = plane();
    sample.reading = linear;
    sample.comment = "# ";
    sample.spareBytes = 2; // of the last number
    sample.applies({{{-5, 2}, 0.0001}, {{0, 7}, 0.0012}, {{-2.5, 4.5}, 0.00065},
        {{1e6, -1e6}, 0.0002}, {{-1e6, 1e6}, 0.001}});
    // entries may come in any order
    const std::size_t points = plane().find("kw.crosscomp2.table");
    sample.applies({{{0, 7}, 0.0012}}, plane().substr(points) + plane().substr(0, points));
    sample.recognises(Recognition::Certain, {plane()});
    sample.recognises(Recognition::No, {"kw.crosscomp.unit 1\n"});

    sample.writes("a plane", {planeTable()})
        .within(0.00005 + 1e-12)
        .remarking({"activate it in the axis list of axis 3: lr_param.crosscomp2 1\n"});
    sample.writes("decimals", {planeTable(0.12345, 0.12345)})
        .with({{"decimals", "yes"}})
        .within(1e-12);
    sample.refuses("unequal distances", {planeTable(5, 4)}, ErrorCode::FormatCannotHold);
    sample.refuses("a distance that is no whole number, rather than adding it up",
        {test::commandTable(
            {test::evenAxis("1", "mm", 0, 1.00003, 40), test::evenAxis("2", "mm", 0, 1.00003, 3)},
            {test::waveColumn("3", "mm", 120, 0.02)})},
        ErrorCode::FormatCannotHold, "0.0001 mm");

    sample.refuses("one axis as both masters", {planeTable()}, ErrorCode::InvalidArgument,
        "both sources are axis 1: master1-axis and master2-axis",
        FormatSettings{{"master2-axis", "1"}});

    const auto row = sample.problemRow();
    row("one axis as both masters", with("master2_ax_nr 2", "master2_ax_nr 1"),
        "9:0 Contradiction kw.crosscomp2.master2_ax_nr 1|another axis than that of the first "
        "source");
    row("no distance", with("kw.crosscomp2.interval 50000\n", ""),
        "0:0 Syntax |the entry kw.crosscomp2.interval");
    row("distance 0", with("interval 50000", "interval 0"),
        "3:0 LimitExceeded kw.crosscomp2.interval 0|a distance above 0");
    row("grid", with("interval 50000", "interval 50000\nkw.crosscomp2.grid HEXAGONAL"),
        "4:0 Syntax HEXAGONAL|QUADRATIC or RECTANGULAR");
    row("distances of rectangles without such a grid",
        with("interval 50000", "interval 50000\nkw.crosscomp2.interval1 25000"),
        "4:0 Contradiction kw.crosscomp2.interval1 25000|interval of a square grid, or interval1 "
        "and interval2 of a grid RECTANGULAR");
    row("the distance of squares in a grid of rectangles",
        with("interval 50000",
            "interval 7\nkw.crosscomp2.grid RECTANGULAR\nkw.crosscomp2.interval1 50000\n"
            "kw.crosscomp2.interval2 50000"),
        "3:0 Contradiction kw.crosscomp2.interval 7|");
    row("no start", with("kw.crosscomp2.start_position_master2 20000\n", ""),
        "0:0 Syntax |the entry kw.crosscomp2.start_position_master2");
    row("too many", with("last_index_master1 2", "last_index_master1 5100"),
        "0:0 LimitExceeded 10202 points|at most 10201");
    row("absurd",
        with("last_index_master1 2",
            "last_index_master1 2000000000\nkw.crosscomp2.max_points 2147483647"),
        "5:0 LimitExceeded 4000000002 points|");
    row("a point is missing", with("kw.crosscomp2.table[1][1].correction 11\n", ""),
        "0:0 MissingPoint no kw.crosscomp2.table[1][1].correction|6 of them; there are 5");
    row("beyond", with("table[1][2]", "table[2][1]"),
        "15:1 Contradiction kw.crosscomp2.table[2][1].correction");
    row("one index", with("table[1][2]", "table[2]"),
        "15:1 Syntax kw.crosscomp2.table[2].correction|a point kw.crosscomp2.table[][]. with "
        "two indices");
    row("three indices", with("table[1][2]", "table[1][2][3]"), "15:26 Syntax [3].correction");
    row("twice", with("table[1][2]", "table[0][0]"), "15:1 DuplicatePoint");
    row("distance lost in the position",
        with("start_position_master1 -100000", "start_position_master1 1e300"), "0:0 NotMonotonic");
}

} // namespace

class TestIsgCrosscomp2 : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theFirstIndexCountsAlongMasterTwo()
    {
        READ_TABLE(table, format, plane(), linear);
        QCOMPARE(table.axes[0].name, std::string("1"));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{-10, -5, 0}));
        QCOMPARE(table.axes[1].name, std::string("2"));
        QCOMPARE(table.axes[1].knots, (std::vector<double>{2, 7}));
        QCOMPARE(table.columns[0].target, std::string("3"));
    }

    void aGridOfRectanglesIsReadWithTwoDistances()
    {
        const auto text = with("kw.crosscomp2.interval 50000\n",
            "kw.crosscomp2.grid RECTANGULAR (new)\nkw.crosscomp2.interval1 50000\n"
            "kw.crosscomp2.interval2 10000\nkw.crosscomp2.interval 0\n");
        READ_TABLE(table, format, text, linear);
        QCOMPARE(table.axes[0].knots[1], -5.0);
        QCOMPARE(table.axes[1].knots[1], 3.0);
    }

    void aModuloMasterIsClosedAlongItsWholeEdge()
    {
        TableReadOptions options = linear;
        options.settings["modulo1"] = "yes";
        std::string closed = plane();
        closed.replace(closed.find("[0][2].correction 2"), 19, "[0][2].correction 0");
        const auto half = format.read(closed, options);
        VERIFY_RESULT(half);
        QVERIFY(test::hasProblem(*half, DiagnosticCode::NotPeriodic, 0));
        closed.replace(closed.find("[1][2].correction 12"), 20, "[1][2].correction 10");
        READ_TABLE(table, format, closed, options);
        QCOMPARE(table.axes[0].wrap, std::optional(10.0));
        QVERIFY(!table.axes[1].wrap);
        WRITE_TABLE(written, format, table, {});
        QCOMPARE(written->held.front(), table);
        NeutralTable open = planeTable();
        open.axes[1].wrap = 10.0;
        VERIFY_ERROR(format.write(std::array{open}, {}), ErrorCode::FormatCannotHold);
    }

    void aLargePlaneIsReadWhole()
    {
        std::string text = with("last_index_master1 2", "last_index_master1 199");
        text.replace(text.find("master2 1\n"), 10, "master2 249\n");
        text =
            text.substr(0, text.find("kw.crosscomp2.table")) + "kw.crosscomp2.max_points 50000\n";
        for (int j = 0; j < 250; ++j)
            for (int i = 0; i < 200; ++i)
                text += "kw.crosscomp2.table[" + std::to_string(j) + "][" + std::to_string(i)
                    + "].correction 12\n";
        QVERIFY(text.size() > 2'000'000);
        READ_TABLE(table, format, text, linear);
        QCOMPARE(table.pointCount(), std::size_t(50000));
    }
};

AXISCOMP_TEST(TestIsgCrosscomp2)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_isgcrosscomp2

#include "tst_isgcrosscomp2.moc"
