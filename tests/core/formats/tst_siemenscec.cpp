// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/text/number_text.h"

#include "tests/core/formats/format_checks.h"
#include "tests/support/test_registry.h"

namespace tst_siemenscec {

using namespace axiscomp;
using test::applied;
using test::problemLines;

namespace {

const TableFamily& family = siemens_cec::format();

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

std::string with(const std::string& from, const std::string& to)
{
    std::string text = program;
    return text.replace(text.find(from), from.size(), to);
}

NeutralTable crossTable()
{
    NeutralTable table;
    table.sign = SignConvention::Command;
    table.axes = {test::evenAxis("Y1", "mm", -30, 1.5, 12)};
    table.columns = {test::waveColumn("Z1", "mm", 12, 0.02)};
    return table;
}

NeutralTable pairTable()
{
    NeutralTable table = crossTable();
    table.columns.push_back(test::waveColumn("Z1", "mm", 12, -0.01));
    table.columns[0].direction = Direction::Positive;
    table.columns[1].direction = Direction::Negative;
    return table;
}

} // namespace

class TestSiemensCec : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void aTableNamesItsInputAndItsOutput()
    {
        READ_TABLE(table, family, program, {});
        QCOMPARE(table.axes[0].name, std::string("AX2"));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{-400, 0, 400}));
        QCOMPARE(table.columns[0].target, std::string("AX1"));
        QCOMPARE(table.columns[0].direction, Direction::Both);
        QCOMPARE(table.columns[0].values, (std::vector<double>{0.01, 0.02, 0.03}));
        QCOMPARE(table.name, std::string("table 0"));
        QCOMPARE(table.sign, SignConvention::Command);
        QVERIFY2(reading_table->diagnostics.empty(), problemLines(*reading_table).c_str());
    }

    void itIsLinearBetweenThePointsAndHeldOutside()
    {
        READ_TABLE(table, family, program, {});
        QCOMPARE(applied(family, table, {-200}), 0.015);
        QCOMPARE(applied(family, table, {-1e6}), 0.01);
        QCOMPARE(applied(family, table, {1e6}), 0.03);
    }

    void tablesOfBothDirectionsAreOnePair()
    {
        const auto reading =
            family.read(tableText("3", "-1", -1) + tableText("4", "0") + tableText("5", "1"), {});
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
        READ_TABLE(table, family, text, {});
        QCOMPARE(table.axes[0].unit, std::string("deg"));
        QCOMPARE(table.axes[0].wrap, std::optional(800.0));
        QCOMPARE(table.columns[0].unit, std::string("mm"));
        QCOMPARE(applied(family, table, {800}), 0.02);
    }

    void aProductOfTablesIsLeftOutWithAWarning()
    {
        READ_TABLE(table, family, with("MULT_BY_TABLE[0]=0", "MULT_BY_TABLE[0]=2"), {});
        QVERIFY(test::hasProblem(*reading_table, DiagnosticCode::Assumption, 12));
        QCOMPARE(table.columns[0].values[1], 0.02);
    }

    void whatIsWrittenIsReadBackTheSame()
    {
        NeutralTable same = crossTable();
        same.axes[0].name = "X1";
        same.columns[0].target = "X1";
        NeutralTable rotary = crossTable();
        rotary.axes[0] = test::evenAxis("C", "deg", 0, 40, 10);
        rotary.axes[0].wrap = 360;
        rotary.columns = {test::waveColumn("X1", "mm", 10, 1)};
        rotary.columns[0].values.back() = rotary.columns[0].values.front();
        const std::array tables{crossTable(), pairTable(), same, rotary};
        TableWriteOptions options;
        options.settings["first-table"] = "7";
        const auto written = family.write(tables, options);
        VERIFY_RESULT(written);
        TableReadOptions reading;
        reading.settings["rotary-axes"] = "C";
        const auto again = family.read(written->bytes, reading);
        VERIFY_RESULT(again);
        QCOMPARE(again->tables, written->held);
        QCOMPARE(again->tables.size(), tables.size());
        for (std::size_t i = 0; i < tables.size(); ++i)
            COMPARE_TABLES(again->tables[i], tables[i], 1e-12);
        QCOMPARE(again->tables[1].name, std::string("table 8, table 9"));
        QVERIFY(written->remarks.back().find("$MN_MM_CEC_MAX_POINTS[11]") != std::string::npos);
    }

    void theProgramHasTheFormOfTheManual()
    {
        NeutralTable table = crossTable();
        table.axes[0].knots = {0, 2};
        table.columns[0].values = {0.5, -0.25};
        table.columns[0].direction = Direction::Negative;
        const auto written = family.write(std::array{table}, {});
        VERIFY_RESULT(written);
        QCOMPARE(written->bytes,
            std::string("CHANDATA(1)\n$AN_CEC[0,0]=0.5\n$AN_CEC[0,1]=-0.25\n"
                        "$AN_CEC_INPUT_AXIS[0]=(Y1)\n$AN_CEC_OUTPUT_AXIS[0]=(Z1)\n"
                        "$AN_CEC_STEP[0]=2\n$AN_CEC_MIN[0]=0\n$AN_CEC_MAX[0]=2\n"
                        "$AN_CEC_IS_MODULO[0]=0\n$AN_CEC_DIRECTION[0]=-1\n"
                        "$AN_CEC_MULT_BY_TABLE[0]=0\nM17\n"));
    }

    void anAxisWithoutAUsableNameNeedsTheSetting()
    {
        NeutralTable table = crossTable();
        table.columns[0].target = "vertical axis";
        const auto refused = family.write(std::array{table}, {});
        VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
        QVERIFY(test::describe(refused.error()).find("output-axis") != std::string::npos);
        TableWriteOptions options;
        options.settings = {{"output-axis", "AX3"}, {"input-axis", "AX1"}};
        const auto written = family.write(std::array{table}, options);
        VERIFY_RESULT(written);
        QCOMPARE(written->held.front().columns[0].target, std::string("AX3"));
        QCOMPARE(written->held.front().axes[0].name, std::string("AX1"));
        options.settings["first-table"] = "-1";
        VERIFY_ERROR(family.write(std::array{table}, options), ErrorCode::FormatCannotHold);
    }

    void aLinearModuloAxisIsRefused()
    {
        NeutralTable table = crossTable();
        table.axes[0].wrap = 16.5;
        table.columns[0].values.back() = table.columns[0].values.front();
        VERIFY_ERROR(family.write(std::array{table}, {}), ErrorCode::FormatCannotHold);
    }

    void aProblemNamesItsPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("problem"); // the beginning of the first one
        const auto row = [](const char* name, const std::string& text, const char* problem) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(problem);
        };
        row("empty", "", "0:0 EmptyFile");
        row("no table", "M17\n", "0:0 Syntax |variables $AN_CEC");
        row("no input", with("$AN_CEC_INPUT_AXIS[0]=(AX2)", ""),
            "0:0 Syntax |$AN_CEC_INPUT_AXIS of table 0");
        row("no output", with("$AN_CEC_OUTPUT_AXIS[0]=(AX1)", ""),
            "0:0 Syntax |$AN_CEC_OUTPUT_AXIS of table 0");
        row("two inputs", with("M17", "$AN_CEC_INPUT_AXIS[0]=(AX5)\nM17"),
            "14:1 Contradiction $AN_CEC_INPUT_AXIS a second time");
        row("three indices", with("$AN_CEC[0,1]", "$AN_CEC[0,1,2]"),
            "4:1 Syntax $AN_CEC|two indices: [table,point]");
        row("points where a comma is meant", with("$AN_CEC[0,1]", "$AN_CEC[0.1]"),
            "4:1 Syntax $AN_CEC|two indices");
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
    void aProblemNamesItsPlace()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, problem);
        const auto reading = family.read(text.toStdString(), {});
        VERIFY_RESULT(reading);
        QVERIFY(reading->tables.empty());
        const std::string found = problemLines(*reading);
        QVERIFY2(found.starts_with(problem.toStdString()), found.c_str());
    }

    void anUnknownVariableAndAnotherFamilyAreWarnings()
    {
        READ_TABLE(table, family, "$AN_CEC_INPUT_NCU[0]=1\n$AA_ENC_COMP[0,0,X]=1\n" + program, {});
        QCOMPARE(table.axes[0].knots.size(), std::size_t(3));
        QVERIFY(test::hasProblem(*reading_table, DiagnosticCode::UnknownKey, 1));
        QVERIFY(test::hasProblem(*reading_table, DiagnosticCode::Assumption, 2));
    }

    void aFileIsRecognisedByItsVariables()
    {
        QCOMPARE(family.recognise(program), Recognition::Certain);
        QCOMPARE(family.recognise("$AA_ENC_COMP[0,0,X1]=0\n"), Recognition::No);
        QCOMPARE(family.recognise(""), Recognition::No);
    }
};

AXISCOMP_TEST(TestSiemensCec)

} // namespace tst_siemenscec

#include "core/text/number_text.h"
#include "tst_siemenscec.moc"
