// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_softmcbasic {

using namespace axiscomp;

namespace {

const TableFormat& format = softmc_basic::format();

NeutralTable twoSources()
{
    return test::commandTable(
        {test::evenAxis("X", "mm", 100, 10, 2), test::evenAxis("Y", "mm", -1, 0.5, 3)},
        {test::columnOf("X", "mm", {0.1, 0.2, 0.3, 0.4, 0.5, 0.6}),
            test::columnOf("Y", "mm", {-1, -2, -3, -4, -5, -6})});
}

void describe(test::FormatSample& sample)
{
    sample.facts = "command is published; 1 to 3 dimensions, even knots; "
                   "points 4000000, columns any, tables 1, bytes 67108864; holds";
    sample.writes("every point has a position of each source, the first fastest", {twoSources()})
        .containing({"Comp1.SourceData[1][2] = 110\nComp1.SourceData[2][2] = -1\n"
                     "Comp1.TargetData[1][2] = 0.2\nComp1.TargetData[2][2] = -2\n"
                     "Comp1.SourceData[1][3] = 100\nComp1.SourceData[2][3] = -0.5\n",
            "Comp1.SourceData[2][6] = 0\n", "Comp1.TargetData[2][6] = -6\n"})
        .remarking({"CompActive = 0", "2 x 3 points"});
    sample
        .writes("both indices begin at 1",
            {test::commandTable(
                {test::evenAxis("1", "mm", 0, 120, 2)}, {test::columnOf("1", "mm", {0, 0.125})})})
        .as("' Compensation table Comp1: 2 points\n"
            "Comp1.SourceData[1][1] = 0\nComp1.TargetData[1][1] = 0\n"
            "Comp1.SourceData[1][2] = 120\nComp1.TargetData[1][2] = 0.125\n");
    sample.writes("the name of the setting", {twoSources()})
        .with({{"name", "Gantry_1"}})
        .containing({"\nGantry_1.TargetData[2][6] = -6\n"});
    for (const char* name : {"1st", "_x", "a b", "x.y", "a[1]", "\u00e4"})
        sample.refuses(std::string("the name ") + name, {twoSources()}, ErrorCode::InvalidArgument,
            "", FormatSettings{{"name", name}});
    NeutralTable scaled = test::commandTable(
        {test::evenAxis("X", "m", 0.1, 0.01, 2), test::evenAxis("Y", "m", -0.001, 0.0005, 3)},
        {test::columnOf("X", "m", {0.0001, 0.0002, 0.0003, 0.0004, 0.0005, 0.0006}),
            test::columnOf("Y", "m", {-0.001, -0.002, -0.003, -0.004, -0.005, -0.006})});
    sample.writes("the units of the settings", {twoSources()})
        .with({{"position-unit", "m"}, {"value-unit", "m"}})
        .containing({"Comp1.SourceData[1][1] = 0.1\n", "Comp1.TargetData[1][1] = 0.0001\n"})
        .becoming(scaled)
        .within(1e-12);
    sample.refuses("two units for one axis", {twoSources()}, ErrorCode::InvalidArgument, "one unit",
        FormatSettings{{"position-unit", "m"}, {"value-unit", "um"}});
}

} // namespace

class TestSoftmcBasic : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void itTakesEffectAtTheFirstValue()
    {
        QCOMPARE(test::applied(format, twoSources(), {99, 0}), 0.0);
    }

    void theAssignmentsAreTheRowsOfTheTextTable()
    {
        const auto basic = format.write(std::array{twoSources()}, {});
        const auto text = softmc::format().write(std::array{twoSources()}, {});
        VERIFY_RESULT(basic);
        VERIFY_RESULT(text);
        std::string rows = "2 2 3\n";
        std::size_t numbers = 0;
        for (std::size_t at = basic->bytes.find(" = "); at != std::string::npos;
             at = basic->bytes.find(" = ", at + 1))
            rows += basic->bytes.substr(at + 3, basic->bytes.find('\n', at) - at - 3)
                + (++numbers % 4 == 0 ? '\n' : ' ');
        QCOMPARE(rows, text->bytes);
        QVERIFY(basic->held.front() == twoSources());
    }
};

AXISCOMP_TEST(TestSoftmcBasic)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_softmcbasic

#include "tst_softmcbasic.moc"
