// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_siemenseec {

using namespace axiscomp;
using test::applied;
using test::changed;
using test::problemLines;

namespace {

const TableFormat& format = siemens_eec::format();

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

const auto with = test::changing(program);

NeutralTable ownTable(const std::string& name, std::size_t count = 11)
{
    return test::tableOf(SignConvention::Feedback, {test::evenAxis(name, "mm", -20.5, 0.3, count)},
        {test::waveColumn(name, "mm", count, 0.01)});
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

void describe(test::FormatSample& sample)
{
    sample.facts =
        "feedback is published; 1 to 1 dimensions, even knots; "
        "points any, columns 1, tables any, bytes 67108864; holds names units notes wrap";
    sample.text = program;
    sample.comment = "; ";
    sample.spareBytes = 5; // the end of the program
    sample.warnedBytes = 33; // behind MAX
    sample.applies({{{-199.5}, 0.0065}, {{-1e6}, 0.003}, {{0}, 0.0}});
    sample.recognises(Recognition::Certain, {program});
    sample.recognises(
        Recognition::No, {"N10 $AN_CEC[0,0]=0\n", "$AA_ENC_COMPARE[1]=0\n", "CHANDATA(1)\nM17\n"});
    sample.recognises(Recognition::Possible, {program + "$AN_CEC_STEP[0]=1\n"});
    sample.warning("a modulo axis with other values at its end",
        with("IS_MODULO[0,X1]=0", "IS_MODULO[0,X1]=1"),
        {"10:0 NotPeriodic -0 at MAX of axis X1, encoder 0|0.003, as at MIN, which follows it"});
    const std::string others = "$MA_ENC_COMP_ENABLE[0]=1\n$AN_CEC[0,0]=1\n$AN_CEC[0,1]=1\n";
    sample.warning("other variables", others + program,
        {"1:1 UnknownKey $MA_ENC_COMP_ENABLE|",
            "2:1 Assumption tables $AN_CEC besides $AA_ENC_COMP|the format siemens-cec to read "
            "them; they are left out here"});
    sample.applies({{{-199.5}, 0.0065}}, others + program);
    const auto loaded = [](const char* before, const char* behind) {
        return before + with("M17", std::string(behind) + "\nM17");
    };
    sample.warning("switched off while it is loaded",
        loaded("$MA_ENC_COMP_ENABLE[0,X1]=0\n", "$MA_ENC_COMP_ENABLE[0,X1]=1"), {});
    sample.warning("switched off in the end",
        loaded("$MA_ENC_COMP_ENABLE[0,X1]=1\n", "$MA_ENC_COMP_ENABLE[0,X1]=0"),
        {"12:1 Assumption \"$MA_ENC_COMP_ENABLE[0,X1]=0\", which switches a table of the file "
         "off|"});
    sample.warning("another encoder", loaded("", "$MA_ENC_COMP_ENABLE[1,X1]=0"),
        {"11:1 UnknownKey $MA_ENC_COMP_ENABLE|"});

    const auto oneOf = [](const std::string& unit, std::vector<double> values) {
        return test::tableOf(SignConvention::Feedback, {test::evenAxis("X1", "mm", 0, 0.00001, 2)},
            {test::columnOf("X1", unit, std::move(values))});
    };
    sample.writes("one axis", {ownTable("X1")}).within(0, 1e-12);
    sample.writes("several axes", {ownTable("X1"), ownTable("Y1", 7), rotaryTable()})
        .readWith({{"rotary-axes", "C"}})
        .within(0, 1e-12);
    sample
        .writes("the form of the manual",
            {changed(oneOf("mm", {0.0000001, -2}),
                [](NeutralTable& table) { table.notes = {"a note"}; })})
        .with({{"encoder", "1"}})
        .as("CHANDATA(1)\n; a note\n$AA_ENC_COMP[1,0,X1]=0.0000001\n"
            "$AA_ENC_COMP[1,1,X1]=-2\n$AA_ENC_COMP_STEP[1,X1]=0.00001\n"
            "$AA_ENC_COMP_MIN[1,X1]=0\n$AA_ENC_COMP_MAX[1,X1]=0.00001\n"
            "$AA_ENC_COMP_IS_MODULO[1,X1]=0\nM17\n")
        .remarking({"MD38000"});
    sample.writes("micrometres", {oneOf("um", {1, 2})}).becoming(oneOf("mm", {0.001, 0.002}));
    sample.refuses(
        "no usable name", {ownTable("1")}, ErrorCode::InvalidArgument, "the setting axis");
    sample.writes("the name of the setting", {ownTable("1")})
        .with({{"axis", "Z1"}})
        .becoming(ownTable("Z1"))
        .within(0, 1e-12);
    const auto refuses = [&sample](const char* name, const NeutralTable& table, const auto& change,
                             const char* reason = "") {
        sample.refuses(name, {changed(table, change)}, ErrorCode::FormatCannotHold, reason);
    };
    refuses(
        "another axis", ownTable("X1"), [](NeutralTable& table) { table.columns[0].target = "Z1"; },
        "siemens-cec");
    refuses("an open turn", rotaryTable(),
        [](NeutralTable& table) { table.columns[0].values.back() += 0.1; });
    refuses("part of a turn", rotaryTable(), [](NeutralTable& table) { table.axes[0].wrap = 400; });

    const auto row = sample.problemRow();
    row("no table", "CHANDATA(1)\nM17\n", "0:0 Syntax |variables $AA_ENC_COMP");
    row("truncated", program.substr(0, program.find("=0.01")),
        "5:21 Syntax |= and a value behind the index");
    row("without =", with("=0.01 ", " 0.01 "), "5:22 Syntax 0.01|= and a value");
    row("without a value", with("=0.01 ; +10 um", "="), "5:22 Syntax |a value behind =");
    row("without an index", with("[0,1,X1]=0.01", "=0.01"), "5:13 Syntax =0.01|an index in [ ]");
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

} // namespace

class TestSiemensEec : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    /// A table for the second encoder that was a calibration file meanwhile is not known as that.
    void theMeasuringSystemThatNobodySaysIsARemark()
    {
        const auto remarksOf = [](const std::string& name, const FormatSettings& settings) {
            NeutralTable table = ownTable("X1");
            table.name = name;
            return test::joined(
                format.write(std::span(&table, 1), test::writingWith(settings)).value().remarks);
        };
        const auto isSaid = [](const std::string& remarks) {
            return remarks.find("nothing says for which measuring system of axis X1 the table is: "
                                "it is written for 0; the setting encoder")
                != std::string::npos;
        };
        const std::string open = remarksOf("X1", {});
        QVERIFY2(isSaid(open), open.c_str());
        for (const char* known : {"X1, encoder 0", "X1, encoder 1"}) {
            const std::string remarks = remarksOf(known, {});
            QVERIFY2(!isSaid(remarks), remarks.c_str());
        }
        const std::string stated = remarksOf("X1", {{"encoder", "0"}});
        QVERIFY2(!isSaid(stated), stated.c_str());
    }

    /// 3 * 0.1 is more than 0.3: the last point is where MAX says.
    void theLastPointIsExactlyAtMax()
    {
        std::string text = with("STEP[0,X1]=1.0", "STEP[0,X1]=0.1");
        text = test::with(text, "MIN[0,X1]=-200.0", "MIN[0,X1]=0");
        text = test::with(text, "MAX[0,X1]=-198.0", "MAX[0,X1]=0.3");
        text = test::with(text, "CHANDATA(1)\n", "CHANDATA(1)\n$AA_ENC_COMP[0,3,X1]=0.5\n");
        READ_TABLE(table, format, text, {});
        QCOMPARE(table.axes[0].knots.size(), std::size_t{4});
        QVERIFY(table.axes[0].knots.back() == 0.3);
    }

    /// A third of 100 has no decimals that end; the format takes even positions only.
    void aRoundedStepIsEven()
    {
        for (const char* step : {"33.3333", "33.3333333"}) {
            std::string text = with("STEP[0,X1]=1.0", std::string("STEP[0,X1]=") + step);
            text = test::with(text, "MIN[0,X1]=-200.0", "MIN[0,X1]=0");
            text = test::with(text, "MAX[0,X1]=-198.0", "MAX[0,X1]=100");
            text = test::with(text, "CHANDATA(1)\n", "CHANDATA(1)\n$AA_ENC_COMP[0,3,X1]=0.5\n");
            READ_TABLE(table, format, text, {});
            const std::vector<double> third{0, 100.0 / 3, 200.0 / 3, 100};
            QVERIFY(test::largestDifference(table.axes[0].knots, third) < 1e-13);
            VERIFY_RESULT(checkHolds(format.facts, std::array{table}));
            WRITE_TABLE(written, format, table, {});
            QCOMPARE(written->held, std::vector{table});
        }
    }

    void theExampleOfTheManualIsRead()
    {
        READ_TABLE(table, format, program, {});
        QCOMPARE(table.axes[0].name, std::string("X1"));
        QCOMPARE(table.axes[0].unit, std::string("mm"));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{-200, -199, -198}));
        QCOMPARE(table.columns[0].target, std::string("X1"));
        QCOMPARE(table.columns[0].values, (std::vector<double>{0.003, 0.01, 0}));
        QCOMPARE(table.notes, (std::vector<std::string>{"measured 12 March"}));
        QVERIFY2(reading_table->diagnostics.empty(), problemLines(*reading_table).c_str());
    }

    void blanksBlockNumbersSmallLettersAndOtherOrdersAreAccepted()
    {
        const std::string text = "N10 $aa_enc_comp_max [ 0 , x1 ] = -198\n"
                                 "N20 $AA_ENC_COMP_MIN[0,X1] =-200\n\n"
                                 "N30$AA_ENC_COMP_STEP[0,(X1)]= 1\n"
                                 "$AA_ENC_COMP_IS_MODULO[0,\"X1\"]=0\n"
                                 "$AA_ENC_COMP[0,2,X1]=3\n$AA_ENC_COMP[0,0,X1]=1\n"
                                 "\t$AA_ENC_COMP[0,1,X1]=2\nm30\n";
        READ_TABLE(table, format, text, {});
        QCOMPARE(table.columns[0].values, (std::vector<double>{1, 2, 3}));
    }

    void aModuloAxisIsInDegreesAndRepeats()
    {
        auto text = with("IS_MODULO[0,X1]=0", "IS_MODULO[0,X1]=1");
        text.replace(text.find("=-0.0"), 5, "=0.003");
        READ_TABLE(table, format, text, {});
        QCOMPARE(table.axes[0].unit, std::string("deg"));
        QCOMPARE(table.axes[0].wrap, std::optional(2.0));
        QCOMPARE(applied(format, table, {-197}), 0.01); // one turn further
    }

    void rotaryAxesAreNamedByASetting()
    {
        TableReadOptions options;
        options.settings["rotary-axes"] = "b, x1";
        READ_TABLE(table, format, program, options);
        QCOMPARE(table.axes[0].unit, std::string("deg"));
        QCOMPARE(table.columns[0].unit, std::string("deg"));
    }

    /// IS_MODULO 0 says nothing of it: an axis that swings less than a turn is in degrees, too.
    void anAxisThatTurnsByItsNameIsNotTakenForALinearOneUnsaid()
    {
        const auto linesOf = [](const std::string& axis, const FormatSettings& settings) {
            std::string text = program;
            for (std::size_t at = 0; (at = text.find("X1", at)) != std::string::npos;
                 at += axis.size())
                text.replace(at, 2, axis);
            return problemLines(format.read(text, test::readingWith(settings)).value());
        };
        const auto isSaid = [](const std::string& lines) {
            return lines.find("numbers are taken to be in mm") != std::string::npos;
        };
        for (const char* axis : {"C1", "a", "B"})
            QVERIFY2(isSaid(linesOf(axis, {})), axis);
        for (const char* axis : {"Z1", "U", "AX1", "CX"})
            QVERIFY2(!isSaid(linesOf(axis, {})), axis);
        QVERIFY2(!isSaid(linesOf("C1", {{"rotary-axes", "C1"}})), "said of what is stated");
    }

    /// The letter of an axis is not its name; the file would be read in mm.
    void rotaryAxesThatTheFileDoesNotHaveAreRefused()
    {
        const auto reading = format.read(program, test::readingWith({{"rotary-axes", "B, X"}}));
        VERIFY_RESULT(reading);
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::Contradiction, 0));
        QCOMPARE(reading->diagnostics.back().found.english(), "B, X as the setting rotary-axes");
        QCOMPARE(reading->diagnostics.back().expected.english(), "an axis of the file: X1");
    }

    void bothMeasuringSystemsOfAnAxisAreTables()
    {
        std::string second = program;
        for (std::size_t at = 0; (at = second.find("[0,", at)) != std::string::npos;)
            second.replace(at, 3, "[1,");
        const auto reading = format.read(program + second, {});
        VERIFY_RESULT(reading);
        QCOMPARE(reading->tables.size(), std::size_t(2));
        QCOMPARE(reading->tables[1].name, std::string("X1, encoder 1"));
        const auto written = format.write(reading->tables, {});
        VERIFY_RESULT(written);
        QCOMPARE(written->held.at(0).name, std::string("X1, encoder 0"));
        QCOMPARE(written->held.at(1).name, std::string("X1, encoder 1"));
        TableWriteOptions byEncoder;
        byEncoder.settings = {{"encoder", "1"}};
        VERIFY_ERROR(format.write(reading->tables, byEncoder), ErrorCode::FormatCannotHold);
    }

    void aProgramWithoutIsModuloHasNone()
    {
        READ_TABLE(table, format, with("$AA_ENC_COMP_IS_MODULO[0,X1]=0\n", ""), {});
        QVERIFY(!table.axes[0].wrap);
        QVERIFY(test::hasProblem(*reading_table, DiagnosticCode::Assumption, 0));
    }
};

AXISCOMP_TEST(TestSiemensEec)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_siemenseec

#include "tst_siemenseec.moc"
