// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_checks.h"
#include "tests/support/test_registry.h"

namespace tst_siemenseec {

using namespace axiscomp;
using test::applied;
using test::problemLines;

namespace {

const TableFamily& family = siemens_eec::format();

/// The manual's example, with fewer points.
const std::string program = "%_N_AX_EEC_INI\n"
                            "CHANDATA(1)\n"
                            "; measured 12 March\n"
                            "$AA_ENC_COMP[0,0,X1]=0.003 ; 1st compensation value\n"
                            "$AA_ENC_COMP[0,1,X1]=0.01 ; +10 um\n"
                            "$AA_ENC_COMP[0,2,X1]=-0.0\n"
                            "$AA_ENC_COMP_STEP[0,X1]=1.0\n"
                            "$AA_ENC_COMP_MIN[0,X1]=-200.0\n"
                            "$AA_ENC_COMP_MAX[0,X1]=-198.0\n"
                            "$AA_ENC_COMP_IS_MODULO[0,X1]=0\n"
                            "M17\n";

std::string with(const std::string& from, const std::string& to)
{
    std::string text = program;
    return text.replace(text.find(from), from.size(), to);
}

NeutralTable ownTable(const std::string& name, std::size_t count = 11)
{
    NeutralTable table;
    table.axes = {test::evenAxis(name, "mm", -20.5, 0.3, count)};
    table.columns = {test::waveColumn(name, "mm", count, 0.01)};
    return table;
}

NeutralTable rotaryTable()
{
    NeutralTable table = ownTable("C", 37);
    table.axes[0] = test::evenAxis("C", "deg", 0, 10, 37);
    table.axes[0].wrap = 360;
    table.columns[0].unit = "deg";
    table.columns[0].values.back() = table.columns[0].values.front();
    return table;
}

} // namespace

class TestSiemensEec : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theExampleOfTheManualIsRead()
    {
        READ_TABLE(table, family, program, {});
        QCOMPARE(table.axes[0].name, std::string("X1"));
        QCOMPARE(table.axes[0].unit, std::string("mm"));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{-200, -199, -198}));
        QCOMPARE(table.columns[0].target, std::string("X1"));
        QCOMPARE(table.columns[0].values, (std::vector<double>{0.003, 0.01, 0}));
        QCOMPARE(table.notes, (std::vector<std::string>{"measured 12 March"}));
        QVERIFY2(reading_table->diagnostics.empty(), problemLines(*reading_table).c_str());
    }

    void aPositiveValueMovesTheAxisInNegativeDirection()
    {
        QCOMPARE(family.facts.sign, SignConvention::Feedback); // added to the actual position
        QCOMPARE(family.facts.signEvidence, Evidence::Published);
        READ_TABLE(table, family, program, {});
        QCOMPARE(table.sign, SignConvention::Feedback);
    }

    void itIsLinearBetweenThePointsAndHeldOutside()
    {
        READ_TABLE(table, family, program, {});
        QCOMPARE(applied(family, table, {-199.5}), 0.0065);
        QCOMPARE(applied(family, table, {-1e6}), 0.003);
        QCOMPARE(applied(family, table, {0}), 0.0);
    }

    void blanksBlockNumbersSmallLettersAndOtherOrdersAreAccepted()
    {
        const std::string text = "N10 $aa_enc_comp_max [ 0 , x1 ] = -198\n"
                                 "N20 $AA_ENC_COMP_MIN[0,X1] =-200\n\n"
                                 "N30$AA_ENC_COMP_STEP[0,(X1)]= 1\n"
                                 "$AA_ENC_COMP_IS_MODULO[0,\"X1\"]=0\n"
                                 "$AA_ENC_COMP[0,2,X1]=3\n$AA_ENC_COMP[0,0,X1]=1\n"
                                 "\t$AA_ENC_COMP[0,1,X1]=2\nm30\n";
        READ_TABLE(table, family, text, {});
        QCOMPARE(table.columns[0].values, (std::vector<double>{1, 2, 3}));
    }

    void aModuloAxisIsInDegreesAndRepeats()
    {
        auto text = with("IS_MODULO[0,X1]=0", "IS_MODULO[0,X1]=1");
        const auto open = family.read(text, {});
        VERIFY_RESULT(open);
        QCOMPARE(problemLines(*open),
            std::string("warning 10:0 NotPeriodic -0 at MAX of axis X1, encoder 0|0.003, as at "
                        "MIN, which follows it\n"));
        text.replace(text.find("=-0.0"), 5, "=0.003");
        READ_TABLE(table, family, text, {});
        QCOMPARE(table.axes[0].unit, std::string("deg"));
        QCOMPARE(table.axes[0].wrap, std::optional(2.0));
        QCOMPARE(applied(family, table, {-197}), 0.01); // one turn further
    }

    void rotaryAxesAreNamedByASetting()
    {
        TableReadOptions options;
        options.settings["rotary-axes"] = "b, x1";
        READ_TABLE(table, family, program, options);
        QCOMPARE(table.axes[0].unit, std::string("deg"));
        QCOMPARE(table.columns[0].unit, std::string("deg"));
    }

    void severalAxesAreSeveralTables()
    {
        const std::array tables{ownTable("X1"), ownTable("Y1", 7), rotaryTable()};
        const auto written = family.write(tables, {});
        VERIFY_RESULT(written);
        TableReadOptions options;
        options.settings["rotary-axes"] = "C";
        const auto again = family.read(written->bytes, options);
        VERIFY_RESULT(again);
        QCOMPARE(again->tables.size(), std::size_t(3));
        QCOMPARE(again->tables, written->held);
        for (std::size_t i = 0; i < tables.size(); ++i)
            COMPARE_TABLES(again->tables[i], tables[i], 1e-12);
        QCOMPARE(again->tables[1].columns[0].values, tables[1].columns[0].values);
    }

    void bothMeasuringSystemsOfAnAxisAreTables()
    {
        std::string second = program;
        for (std::size_t at = 0; (at = second.find("[0,", at)) != std::string::npos;)
            second.replace(at, 3, "[1,");
        const auto reading = family.read(program + second, {});
        VERIFY_RESULT(reading);
        QCOMPARE(reading->tables.size(), std::size_t(2));
        QCOMPARE(reading->tables[1].name, std::string("X1, encoder 1"));
        VERIFY_ERROR(family.write(reading->tables, {}), ErrorCode::FormatCannotHold);
    }

    void theProgramHasTheFormOfTheManual()
    {
        NeutralTable table = ownTable("X1", 2);
        table.axes[0].knots = {0, 0.00001};
        table.columns[0].values = {0.0000001, -2};
        table.notes = {"a note"};
        TableWriteOptions options;
        options.settings["encoder"] = "1";
        const auto written = family.write(std::array{table}, options);
        VERIFY_RESULT(written);
        QCOMPARE(written->bytes,
            std::string("CHANDATA(1)\n; a note\n$AA_ENC_COMP[1,0,X1]=0.0000001\n"
                        "$AA_ENC_COMP[1,1,X1]=-2\n$AA_ENC_COMP_STEP[1,X1]=0.00001\n"
                        "$AA_ENC_COMP_MIN[1,X1]=0\n$AA_ENC_COMP_MAX[1,X1]=0.00001\n"
                        "$AA_ENC_COMP_IS_MODULO[1,X1]=0\nM17\n"));
        QVERIFY(written->remarks.front().find("MD38000") != std::string::npos);
    }

    void valuesAreWrittenInMillimetresAndDegrees()
    {
        NeutralTable table = ownTable("X1", 2);
        table.columns[0].unit = "um";
        table.columns[0].values = {1, 2};
        const auto written = family.write(std::array{table}, {});
        VERIFY_RESULT(written);
        QCOMPARE(written->held.front().columns[0].values, (std::vector<double>{0.001, 0.002}));
    }

    void anAxisWithoutAUsableNameNeedsTheSetting()
    {
        const NeutralTable table = ownTable("1");
        const auto refused = family.write(std::array{table}, {});
        VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
        QVERIFY(test::describe(refused.error()).find("the setting axis") != std::string::npos);
        TableWriteOptions options;
        options.settings["axis"] = "Z1";
        const auto written = family.write(std::array{table}, options);
        VERIFY_RESULT(written);
        QCOMPARE(written->held.front().axes[0].name, std::string("Z1"));
    }

    void whatTheFormatCannotHoldIsRefused()
    {
        NeutralTable cross = ownTable("X1");
        cross.columns[0].target = "Z1";
        const auto refused = family.write(std::array{cross}, {});
        VERIFY_ERROR(refused, ErrorCode::FormatCannotHold);
        QVERIFY(test::describe(refused.error()).find("siemens-cec") != std::string::npos);
        NeutralTable open = rotaryTable();
        open.columns[0].values.back() += 0.1;
        VERIFY_ERROR(family.write(std::array{open}, {}), ErrorCode::FormatCannotHold);
        NeutralTable part = rotaryTable();
        part.axes[0].wrap = 400;
        VERIFY_ERROR(family.write(std::array{part}, {}), ErrorCode::FormatCannotHold);
        NeutralTable uneven = ownTable("X1");
        uneven.axes[0].knots[3] += 0.1;
        VERIFY_ERROR(checkHolds(family.facts, std::array{uneven}), ErrorCode::FormatCannotHold);
    }

    void otherVariablesAreAWarning()
    {
        READ_TABLE(table, family,
            "$MA_ENC_COMP_ENABLE[0]=1\n$AN_CEC[0,0]=1\n$AN_CEC[0,1]=1\n" + program, {});
        QCOMPARE(table.axes[0].knots.size(), std::size_t(3));
        QCOMPARE(problemLines(*reading_table),
            std::string("warning 1:1 UnknownKey $MA_ENC_COMP_ENABLE|\n"
                        "warning 2:1 Assumption tables $AN_CEC besides $AA_ENC_COMP|the format "
                        "siemens-cec to read them; they are left out here\n"));
    }

    void aProgramWithoutIsModuloHasNone()
    {
        READ_TABLE(table, family, with("$AA_ENC_COMP_IS_MODULO[0,X1]=0\n", ""), {});
        QVERIFY(!table.axes[0].wrap);
        QVERIFY(test::hasProblem(*reading_table, DiagnosticCode::Assumption, 0));
    }

    void aProblemNamesItsPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("problem"); // the beginning of the first one
        const auto row = [](const char* name, const std::string& text, const char* problem) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(problem);
        };
        row("empty", "\n", "0:0 EmptyFile");
        row("binary", std::string("$AA\0ENC_COMP", 12), "1:0 NotText");
        row("no table", "CHANDATA(1)\nM17\n", "0:0 Syntax |variables $AA_ENC_COMP");
        row("truncated", program.substr(0, program.find("=0.01")),
            "5:21 Syntax |= and a value behind the index");
        row("without =", with("=0.01 ", " 0.01 "), "5:22 Syntax 0.01|= and a value");
        row("without a value", with("=0.01 ; +10 um", "="), "5:22 Syntax |a value behind =");
        row("without an index", with("[0,1,X1]=0.01", "=0.01"),
            "5:13 Syntax =0.01|an index in [ ]");
        row("the index does not end", with("[0,1,X1]=", "[0,1,X1="), "5:13 Syntax");
        row("two indices", with("[0,1,X1]", "[1,X1]"), "5:1 Syntax $AA_ENC_COMP|three indices");
        row("no such encoder", with("[0,1,X1]", "[2,1,X1]"),
            "5:14 LimitExceeded measuring system 2 of axis X1|0 or 1");
        row("encoder is no number", with("[0,1,X1]", "[a,1,X1]"), "5:14 NotANumber a|");
        row("the point is no number", with("[0,1,X1]", "[0,1.5,X1]"), "5:16 NotANumber 1.5|");
        row("a negative point", with("[0,1,X1]", "[0,-1,X1]"), "5:16 Syntax -1|the number of");
        row("a decimal comma", with("=0.01", "=0,01"), "5:22 NotANumber 0,01|a compensation value");
        row("a point twice", with("[0,1,X1]", "[0,0,X1]"),
            "5:16 DuplicatePoint point 0 of axis X1, encoder 0 a second time");
        row("a point is missing", with("$AA_ENC_COMP[0,1,X1]=0.01", ";"),
            "0:0 MissingPoint no point 1 of axis X1, encoder 0|3 points");
        row("a point beyond", with("[0,2,X1]", "[0,3,X1]"),
            "6:16 Contradiction point 3 of axis X1, encoder 0|points up to 2");
        row("no step", with("$AA_ENC_COMP_STEP[0,X1]=1.0\n", ""),
            "0:0 Syntax |$AA_ENC_COMP_STEP of axis X1, encoder 0, which is missing");
        row("step 0", with("=1.0", "=0"), "7:0 LimitExceeded MIN -200, MAX -198 and STEP 0");
        row("max below min", with("=-198.0", "=-201"), "7:0 LimitExceeded MIN -200, MAX -201");
        row("not a whole number of steps", with("=1.0", "=0.6"),
            "9:0 Contradiction MIN -200, MAX -198 and STEP 0.6");
        row("absurd", with("=1.0", "=0.00000001"), "0:0 MissingPoint no point 3");
        row("more than absurd", with("=1.0", "=1e-300"), "7:0 LimitExceeded");
        row("modulo 2", with("MODULO[0,X1]=0", "MODULO[0,X1]=2"),
            "10:0 LimitExceeded $AA_ENC_COMP_IS_MODULO 2|0 or 1");
        row("a variable twice", with("M17", "$AA_ENC_COMP_MIN[0,X1]=-100\nM17"),
            "11:1 Contradiction $AA_ENC_COMP_MIN of axis X1, encoder 0 a second time|each variable "
            "once; the first is in line 8");
        row("another statement", with("M17", "G1 X100\nM17"), "11:1 Syntax G1 X100|an assignment");
        row("after the end", program + "$AA_ENC_COMP[0,1,X1]=0\n",
            "12:1 Syntax $AA_ENC_COMP[0,1,X1]=0|nothing behind the end");
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

    void aFileIsRecognisedByItsVariables()
    {
        QCOMPARE(family.recognise(program), Recognition::Certain);
        QCOMPARE(family.recognise("N10 $AN_CEC[0,0]=0\n"), Recognition::No);
        QCOMPARE(family.recognise(program + "$AN_CEC_STEP[0]=1\n"), Recognition::Possible);
        QCOMPARE(family.recognise("$AA_ENC_COMPARE[1]=0\n"), Recognition::No);
        QCOMPARE(family.recognise("CHANDATA(1)\nM17\n"), Recognition::No);
    }

    void twoMegabytesAreReadWhole()
    {
        std::string text = "CHANDATA(1)\n";
        for (int i = 0; i < 65000; ++i)
            text += "$AA_ENC_COMP[0," + std::to_string(i) + ",X1]=0.0123\n";
        text += "$AA_ENC_COMP_STEP[0,X1]=0.1\n$AA_ENC_COMP_MIN[0,X1]=0\n"
                "$AA_ENC_COMP_MAX[0,X1]=6499.9\n$AA_ENC_COMP_IS_MODULO[0,X1]=0\nM17\n";
        QVERIFY(text.size() > 2'000'000);
        READ_TABLE(table, family, text, {});
        QCOMPARE(table.pointCount(), std::size_t(65000));
    }
};

AXISCOMP_TEST(TestSiemensEec)

} // namespace tst_siemenseec

#include "tst_siemenseec.moc"
