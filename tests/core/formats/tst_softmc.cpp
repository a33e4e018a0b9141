// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_softmc {

using namespace axiscomp;

namespace {

using Targets = std::vector<std::string>;

const TableFormat& format = softmc::format();

const TableReadOptions withUnits =
    test::readingWith({{"position-unit", "mm"}, {"value-unit", "mm"}});

/// The three axes of the manual's example, with a header that fits its rows.
std::string threeAxes()
{
    std::string text = "3 2 3 2\n";
    int row = 0;
    for (int z = 0; z < 2; ++z)
        for (int y = 0; y < 3; ++y)
            for (int x = 0; x < 2; ++x, ++row)
                text += std::to_string(100 * x) + ' ' + std::to_string(10 + y) + ' '
                    + std::to_string(5 * z) + "  0.00" + std::to_string(row % 10) + " 0.1 -0.1\n";
    return text;
}

void describe(test::FormatSample& sample)
{
    sample.facts = "command is published; 1 to 3 dimensions, even knots; "
                   "points 4000000, columns any, tables 1, bytes 67108864; holds";
    sample.text = threeAxes();
    sample.reading = withUnits;
    sample.spareBytes = 3; // of the last number
    sample.applies({{{100, 11, 0}, 0.003}, {{100, 11, 0}, -0.1, 2}});
    const std::string plane = "2 2 2\n10 0 1\n20 0 1\n10 5 1\n20 5 1\n";
    sample.applies({{{10, 0}, 1.0}, {{9.999, 0}, 0.0}, {{15, -0.001}, 0.0}, {{15, 2}, 1.0}}, plane);
    const std::string line = "1 3\n0 1\n10 2\n20 4\n";
    sample.applies({{{1e6}, 4.0}, {{15}, 3.0}}, line);
    sample.recognises(Recognition::Certain, {threeAxes()});
    sample.recognises(Recognition::No, {"0 0.1 0.2\n1 0.1 0.2\n", "X,Table 1\n0,1\n"});
    sample.warning("units that nobody says", line,
        {"0:0 UnitNotGiven positions", "0:0 UnitNotGiven values"}, FormatSettings());

    const std::array axes{test::evenAxis("1", "mm", -20, 0.1, 4),
        test::evenAxis("2", "mm", 0, 2.5, 3), test::evenAxis("3", "mm", 7, 1e-3, 2)};
    for (int dimensions = 1; dimensions <= 3; ++dimensions) {
        NeutralTable table = test::commandTable({axes.begin(), axes.begin() + dimensions}, {});
        for (int n = 1; n <= dimensions; ++n)
            table.columns.push_back(
                test::waveColumn(std::to_string(n), "mm", table.pointCount(), 0.01 * n));
        sample.writes(std::to_string(dimensions) + "D", {table});
    }
    const std::vector axis{test::evenAxis("1", "mm", 0, 1, 2)};
    sample
        .writes("corrections in the unit of the positions",
            {test::commandTable(axis, {test::columnOf("1", "um", {1.0, 2.5})})})
        .as("1 2\n0 0.001\n1 0.0025\n")
        .becoming(test::commandTable(axis, {test::columnOf("1", "mm", {0.001, 0.0025})}));

    const auto row = sample.problemRow();
    row("four sources", "4 2 2 2 2\n", "1:1 LimitExceeded 4 source axes|1 to 3");
    row("a size is missing", "2 3\n0 0 1\n", "1:0 ColumnCount 1 size|2,");
    row("one point", "1 1\n0 1\n", "1:3 LimitExceeded 1 point|at least 2");
    row("too many rows", "3 9999 9999 9999\n", "1:8 LimitExceeded");
    row("no correction", "1 2\n0\n1\n", "2:0 TooFewColumns 1 number|1 position and at least");
    row("a number that is none", "1 2\n0 0.1\n1 0,1\n", "3:3 NotANumber 0,1|a correction");
    row("not finite", "1 2\n0 nan\n1 1\n", "2:3 NotANumber nan|a correction");
    row("ragged", "1 2\n0 1\n1 1 1\n", "3:0 ColumnCount 3 numbers|2, as in the first row");
    row("header does not fit", "1 3\n0 1\n1 1\n",
        "1:0 Contradiction a header of 3 = 3 rows, and 2 rows|");
    row("not the first source fastest", "2 2 2\n0 0 1\n0 1 2\n1 0 3\n1 1 4\n",
        "3:2 Contradiction 1 for source 2|0: the first source changes fastest");
    row("decreasing", "1 2\n1 1\n0 1\n", "0:0 NotMonotonic 0 after 1|strictly increasing");
    row("uneven", "1 3\n0 1\n1 1\n3 1\n", "0:0 UnevenSpacing positions of source 1 from 0 to 3");
}

} // namespace

class TestSoftmc : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theTargetAxesAreNamedUnlessTheyAreTheSourcesInTheirOrder_data()
    {
        QTest::addColumn<Targets>("targets");
        QTest::addColumn<std::string>("named");
        const auto row = [](const char* name, Targets targets, std::string named) {
            QTest::newRow(name) << std::move(targets) << std::move(named);
        };
        row("the sources", {"X", "Y"}, "");
        row("the first of them", {"#1"}, "");
        row("the other order", {"Y", "X"}, "Y, X");
        row("the second alone", {"#2"}, "Y");
        row("another axis", {"X", "Y", "Z"}, "X, Y, Z");
        row("an axis without a name", {"other"}, "another axis");
    }
    void theTargetAxesAreNamedUnlessTheyAreTheSourcesInTheirOrder()
    {
        QFETCH(Targets, targets);
        QFETCH(std::string, named);
        NeutralTable table = test::commandTable(
            {test::evenAxis("X", "mm", 0, 1, 2), test::evenAxis("Y", "mm", 0, 1, 2)}, {});
        for (const std::string& target : targets)
            table.columns.push_back(test::columnOf(target, "mm", {1, 2, 3, 4}));
        for (const TableFormat* to : {&format, &softmc_basic::format()}) {
            const auto written = to->write(std::array{table}, {});
            VERIFY_RESULT(written);
            const std::string remarks = test::joined(written->remarks);
            QCOMPARE(remarks.find("target axes") != std::string::npos, !named.empty());
            QVERIFY2(
                named.empty() || remarks.ends_with("order of the corrections: " + named + '\n'),
                remarks.c_str());
        }
    }

    void anAxisIsWrittenInOneUnit()
    {
        NeutralTable table = test::commandTable(
            {test::evenAxis("X", "mm", 0, 1, 2)}, {test::columnOf("X", "mm", {1, 2})});
        const TableWriteOptions options = test::writingWith({{"value-unit", "um"}});
        VERIFY_ERROR(format.write(std::array{table}, options), ErrorCode::InvalidArgument);
        table.columns[0].target = "Y";
        VERIFY_RESULT(format.write(std::array{table}, options));
    }

    void aTableOfThreeAxesIsReadWithTheFirstSourceFastest()
    {
        READ_TABLE(table, format, threeAxes(), withUnits);
        QCOMPARE(table.axes.size(), std::size_t(3));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{0, 100}));
        QCOMPARE(table.axes[1].knots, (std::vector<double>{10, 11, 12}));
        QCOMPARE(table.axes[2].knots, (std::vector<double>{0, 5}));
        QCOMPARE(table.columns.size(), std::size_t(3));
        QCOMPARE(table.columns[0].values[1], 0.001); // the first source moves first
        QCOMPARE(table.columns[0].values[2], 0.002); // then the second
        QCOMPARE(table.columns[0].values[6], 0.006); // the last one at the end
    }

    void oneCorrectionOrMoreThanThereAreSourcesIsAccepted()
    {
        READ_TABLE(one, format, "2 2 2\n0 0 1\n1 0 2\n0 1 3\n1 1 4\n", withUnits);
        QCOMPARE(one.columns.size(), std::size_t(1));
        READ_TABLE(three, format, "1 2\n0 1 2 3\n1 4 5 6\n", withUnits);
        QCOMPARE(three.columns.size(), std::size_t(3));
    }
};

AXISCOMP_TEST(TestSoftmc)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_softmc

#include "tst_softmc.moc"
