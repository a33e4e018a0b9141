// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/number_text.h"
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_siemenscec {

using namespace axiscomp;
using test::applied;
using test::changed;
using test::problemLines;

namespace {

const TableFormat& format = siemens_cec::format();

std::string tableText(const std::string& index, const std::string& direction, double factor = 1.0)
{
    std::string text;
    for (int i = 0; i < 3; ++i)
        text += "$AN_CEC[" + index + ',' + std::to_string(i)
            + "]=" + toText(factor * 0.01 * (i + 1)) + " ; +\n";
    return text + "$AN_CEC_INPUT_AXIS[" + index + "]=(AX2) ; basic axis Y1\n$AN_CEC_OUTPUT_AXIS["
        + index + "]=(AX1)\n$AN_CEC_STEP[" + index + "]=400\n$AN_CEC_MIN[" + index
        + "]=-400.0\n$AN_CEC_MAX[" + index + "]=400.0\n$AN_CEC_DIRECTION[" + index
        + "]=" + direction + "\n$AN_CEC_MULT_BY_TABLE[" + index + "]=0\n$AN_CEC_IS_MODULO[" + index
        + "]=0\n";
}
const std::string program = "%_N_NC_CEC_INI\nCHANDATA(1)\n" + tableText("0", "0") + "M17\n";

const auto with = test::changing(program);

NeutralTable crossTable()
{
    return test::commandTable(
        {test::evenAxis("Y1", "mm", -30, 1.5, 12)}, {test::waveColumn("Z1", "mm", 12, 0.02)});
}

NeutralTable pairTable()
{
    NeutralTable table = crossTable();
    table.columns.push_back(test::waveColumn("Z1", "mm", 12, -0.01));
    table.columns[0].direction = Direction::Positive;
    table.columns[1].direction = Direction::Negative;
    return table;
}

void describeSwitches(test::FormatSample& sample)
{
    const auto at = [](const char* last) { return with("M17", std::string(last) + "\nM17"); };
    sample.warning("a table that is switched off", at("$SN_CEC_TABLE_ENABLE[0]=0 ; off"),
        {"14:1 Assumption \"$SN_CEC_TABLE_ENABLE[0]=0\", which switches a table of the file off|"});
    sample.warning("an axis without compensation", at("N5 $ma_cec_enable[(ax1)] = FALSE"),
        {"14:4 Assumption \"$ma_cec_enable[(ax1)] = FALSE\", which switches a table of the file "
         "off|"});
    sample.warning("switched off while it is loaded",
        "$SN_CEC_TABLE_ENABLE[0]=0\n$MA_CEC_ENABLE[AX1]=0\n"
            + at("$SN_CEC_TABLE_ENABLE[0]=1\n$MA_CEC_ENABLE[AX1]=1"),
        {});
    sample.warning("another table and another axis",
        at("$SN_CEC_TABLE_ENABLE[1]=0\n$SN_CEC_TABLE_ENABLE[0]=1\n$MA_CEC_ENABLE[AX2]=0"),
        {"14:1 UnknownKey $SN_CEC_TABLE_ENABLE|", "16:1 UnknownKey $MA_CEC_ENABLE|"});
}

void describe(test::FormatSample& sample)
{
    sample.facts = "command is assumed; 1 to 1 dimensions, even knots; "
                   "points any, columns 1, tables any, bytes 67108864; holds names units notes "
                   "directions wrap";
    sample.text = program;
    sample.comment = "; ";
    sample.spareBytes = 5; // the end of the program
    sample.warnedBytes = 75; // behind MAX
    sample.applies({{{-200}, 0.015}, {{-1e6}, 0.01}, {{1e6}, 0.03}});
    sample.recognises(Recognition::Certain, {program});
    sample.recognises(Recognition::No, {"$AA_ENC_COMP[0,0,X1]=0\n"});
    // As machines have it.
    std::string machine =
        "MSG(\"load CEC\")\nSTOPRE\n" + tableText("0", "0") + "NEWCONF\nG4 F1\nM0\nMSG()\nRET\n";
    sample.recognises(Recognition::Certain, {machine});
    sample.applies({{{-200}, 0.015}}, machine);
    for (const char* const point : {"0", "1", "2"})
        machine = test::changing(machine)(
            std::string("$AN_CEC[0,") + point, std::string("$AN_CEC[0.") + point);
    sample.applies({{{-200}, 0.015}, {{1e6}, 0.03}}, machine); // the 802D
    const std::string product = with("MULT_BY_TABLE[0]=0", "MULT_BY_TABLE[0]=2");
    sample.warning("a product of tables is left out", product, {"12:0 Assumption"});
    sample.applies({{{0}, 0.02}}, product);
    const std::string weight = "$SN_CEC_TABLE_WEIGHT[0]=";
    sample.problem("a weight of the table, which multiplies it", weight + "-2\n" + program,
        {"1:1 LimitExceeded"});
    sample.applies({{{400}, 0.03}}, weight + "1.0 ; as it is\n" + program);
    sample.problem("a table in inches", "$MA_CEC_SCALING_SYSTEM_METRIC[AX1]=0\n" + program,
        "1:1 LimitExceeded $MA_CEC_SCALING_SYSTEM_METRIC = 0, with which the lengths of the table "
        "are in inches|1; take the line out, and multiply positions and values in inches by 25.4");
    sample.applies({{{400}, 0.03}}, "$MA_CEC_SCALING_SYSTEM_METRIC[AX1]=1\n" + program);
    sample.applies({{{400}, 0.03}}, "$MA_CEC_SCALING_SYSTEM_METRIC[AX1]=TRUE\n" + program);
    describeSwitches(sample);
    const std::string others = "$AN_CEC_INPUT_NCU[0]=1\n$AA_ENC_COMP[0,0,X]=1\n" + program;
    const auto twoTables = [](const char* first, const char* second) {
        return "CHANDATA(1)\n" + tableText("0", first) + tableText("1", second) + "M17\n";
    };
    sample.warning("two tables of one axis, which the controller adds", twoTables("0", "1"),
        {"0:0 Assumption several tables of AX2 to AX1"});
    sample.warning("two tables of one axis over different ones, which it adds too",
        test::changing(twoTables("1", "-1"))("AXIS[1]=(AX2)", "AXIS[1]=(AX3)"),
        {"0:0 Assumption several tables of AX2 to AX1, positive, AX3 to AX1, negative"});
    sample.warning("a table of each direction", twoTables("1", "-1"), {});
    sample.warning(
        "an unknown variable and another format", others, {"1:1 UnknownKey", "2:1 Assumption"});
    sample.applies({{{400}, 0.03}}, others);

    NeutralTable same = crossTable();
    same.axes[0].name = same.columns[0].target = "X1";
    NeutralTable rotary = crossTable();
    rotary.axes[0] = test::evenAxis("C", "deg", 0, 40, 10);
    rotary.axes[0].wrap = 360;
    rotary.columns = {test::waveColumn("X1", "mm", 10, 1)};
    rotary.columns[0].values.back() = rotary.columns[0].values.front();
    NeutralTable pair = pairTable();
    pair.name = "table 8, table 9";
    sample.writes("one table", {crossTable()}).within(1e-12);
    sample.writes("several tables", {crossTable(), pair, same, rotary})
        .with({{"first-table", "7"}})
        .readWith({{"rotary-axes", "C"}})
        .within(1e-12)
        .remarking({"$MN_MM_CEC_MAX_POINTS[11]"});
    NeutralTable manual = test::commandTable(
        {test::evenAxis("Y1", "mm", 0, 2, 2)}, {test::columnOf("Z1", "mm", {0.5, -0.25})});
    manual.columns[0].direction = Direction::Negative;
    sample.writes("the form of the manual", {manual})
        .as("CHANDATA(1)\n$AN_CEC[0,0]=0.5\n$AN_CEC[0,1]=-0.25\n"
            "$AN_CEC_INPUT_AXIS[0]=(Y1)\n$AN_CEC_OUTPUT_AXIS[0]=(Z1)\n"
            "$AN_CEC_STEP[0]=2\n$AN_CEC_MIN[0]=0\n$AN_CEC_MAX[0]=2\n"
            "$AN_CEC_IS_MODULO[0]=0\n$AN_CEC_DIRECTION[0]=-1\n"
            "$AN_CEC_MULT_BY_TABLE[0]=0\nM17\n");
    NeutralTable unnamed = crossTable();
    unnamed.columns[0].target = "vertical axis";
    FormatSettings settings{{"output-axis", "AX3"}, {"input-axis", "AX1"}};
    sample.refuses("no usable name", {unnamed}, ErrorCode::InvalidArgument, "output-axis");
    sample.writes("names of the settings", {unnamed})
        .with(settings)
        .becoming(changed(crossTable(),
            [](NeutralTable& table) {
                table.axes[0].name = "AX1";
                table.columns[0].target = "AX3";
            }))
        .within(1e-12);
    settings["first-table"] = "-1";
    sample.refuses("no such table", {unnamed}, ErrorCode::FormatCannotHold, "", settings);
    NeutralTable modulo = crossTable();
    modulo.axes[0].wrap = 16.5;
    modulo.columns[0].values.back() = modulo.columns[0].values.front();
    sample.refuses("a linear modulo axis", {modulo}, ErrorCode::FormatCannotHold);

    const auto row = sample.problemRow();
    row("no table", "M17\n", "0:0 Syntax |variables $AN_CEC");
    row("no input", with("$AN_CEC_INPUT_AXIS[0]=(AX2)", ""),
        "0:0 Syntax |$AN_CEC_INPUT_AXIS of table 0");
    row("no output", with("$AN_CEC_OUTPUT_AXIS[0]=(AX1)", ""),
        "0:0 Syntax |$AN_CEC_OUTPUT_AXIS of table 0");
    row("two inputs", with("M17", "$AN_CEC_INPUT_AXIS[0]=(AX5)\nM17"),
        "14:1 Contradiction $AN_CEC_INPUT_AXIS a second time");
    row("three indices", with("$AN_CEC[0,1]", "$AN_CEC[0,1,2]"),
        "4:1 Syntax $AN_CEC|two indices: [table,point]");
    row("no such table", with("$AN_CEC[0,1]", "$AN_CEC[1000,1]"),
        "4:9 LimitExceeded table 1000|the index of a table, 0 to 999");
    row("direction 2", with("DIRECTION[0]=0", "DIRECTION[0]=2"),
        "11:0 LimitExceeded $AN_CEC_DIRECTION 2|0, 1 or -1");
    row("step does not fit", with("STEP[0]=400", "STEP[0]=6.73"),
        "10:0 Contradiction MIN -400, MAX 400 and STEP 6.73 of table 0|a whole number of "
        "steps");
    row("a value that is none", with("=0.02", "=?"), "4:14 NotANumber ?|a compensation value");
    row("a point is missing", with("$AN_CEC[0,1]=0.02", ""), "0:0 MissingPoint no point 1");
    row("a second table is incomplete", with("M17", "$AN_CEC[7,0]=1\nM17"),
        "0:0 Syntax |$AN_CEC_INPUT_AXIS of table 7");
}

} // namespace

class TestSiemensCec : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aTableNamesItsInputAndItsOutput()
    {
        READ_TABLE(table, format, program, {});
        QCOMPARE(table.axes[0].name, std::string("AX2"));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{-400, 0, 400}));
        QCOMPARE(table.columns[0].target, std::string("AX1"));
        QCOMPARE(table.columns[0].direction, Direction::Both);
        QCOMPARE(table.columns[0].values, (std::vector<double>{0.01, 0.02, 0.03}));
        QCOMPARE(table.name, std::string("table 0"));
        QCOMPARE(table.sign, SignConvention::Command);
        QVERIFY2(reading_table->diagnostics.empty(), problemLines(*reading_table).c_str());
    }

    /// What became of each of them is compared with it.
    void twoTablesOfDifferentDirectionsStayTwoWhereTheyAreWritten()
    {
        const NeutralTable pair = pairTable();
        NeutralTable negative = pair;
        negative.columns.erase(negative.columns.begin());
        NeutralTable positive = pair;
        positive.columns.pop_back();
        const auto written = format.write(std::array{negative, positive, pair}, {});
        VERIFY_RESULT(written);
        QCOMPARE(written->held.size(), std::size_t{3});
        QCOMPARE(written->held[0].columns.size(), std::size_t{1});
        QCOMPARE(written->held[0].columns[0].direction, Direction::Negative);
        QCOMPARE(written->held[1].columns[0].direction, Direction::Positive);
        QCOMPARE(written->held[2].columns.size(), std::size_t{2});
        QCOMPARE(written->held[2].name, std::string("table 2, table 3"));
    }

    void tablesOfBothDirectionsAreOnePair()
    {
        const auto reading =
            format.read(tableText("3", "-1", -1) + tableText("4", "0") + tableText("5", "1"), {});
        VERIFY_RESULT(reading);
        QCOMPARE(reading->tables.size(), std::size_t(2));
        const NeutralTable& pair = reading->tables.front();
        QCOMPARE(pair.columns.size(), std::size_t(2));
        QCOMPARE(pair.columns[0].direction, Direction::Positive);
        QCOMPARE(pair.columns[0].values[0], 0.01);
        QCOMPARE(pair.columns[1].direction, Direction::Negative);
        QCOMPARE(pair.columns[1].values[0], -0.01);
        QCOMPARE(pair.name, std::string("table 3, table 5"));
    }

    void aModuloInputIsInDegrees()
    {
        std::string text = with("IS_MODULO[0]=0", "IS_MODULO[0]=1");
        text.replace(text.find("=0.03"), 5, "=0.01");
        READ_TABLE(table, format, text, {});
        QCOMPARE(table.axes[0].unit, std::string("deg"));
        QCOMPARE(table.axes[0].wrap, std::optional(800.0));
        QCOMPARE(table.columns[0].unit, std::string("mm"));
        QCOMPARE(applied(format, table, {800}), 0.02);
    }
};

AXISCOMP_TEST(TestSiemensCec)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_siemenscec

#include "core/text/number_text.h"
#include "tst_siemenscec.moc"
