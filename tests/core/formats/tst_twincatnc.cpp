// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/sign_conversion.h"
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_twincatnc {

using namespace axiscomp;
using test::changed;
using test::problemLines;

namespace {

const TableFormat& format = twincat_nc::format();

const std::string file =
    "VAR (* of axis 1 *)\n"
    "stPar : ST_PositionCompensationTableParameter := (MinPosition:=0.0, MaxPosition:=30.0,\n"
    "    NoOfTableElements:=4, Direction:=WorkDirectionBoth, Modulo:=FALSE); // nominal\n"
    "stTab : ARRAY[0..3] OF ST_PositionCompensationTableElement := [\n"
    "    (Position:=0.0, Compensation:=0.0), (Position := 10.0, Compensation := 0.1),\n"
    "    (Position:=20.0, Compensation:=0.2), (Position:=30.0, Compensation:=0.15)];\n"
    "END_VAR\n";
const auto with = test::changing(file);

const TableReadOptions inMillimetres = test::readingWith({{"position-unit", "mm"}});

NeutralTable example(std::size_t count)
{
    NeutralTable table = test::commandTable(
        {test::evenAxis("", "mm", -20, 0.5, count)}, {test::columnOf("#1", "mm", {})});
    for (std::size_t i = 0; i < count; ++i)
        table.columns[0].values.push_back(static_cast<double>((i * 5) % 11) / 64.0);
    return table;
}

void describe(test::FormatSample& sample)
{
    sample.facts = "command is assumed; 1 to 1 dimensions, even knots; "
                   "points 1000000, columns 1, tables 1, bytes 67108864; holds wrap";
    sample.text = file;
    sample.reading = inMillimetres;
    sample.comment = "// ";
    sample.spareBytes = file.size() - file.find("];\nEND_VAR") - 2;
    sample.applies({{{5}, 0.05}, {{25}, 0.175}, {{-1}, 0}, {{100}, 0.15}});
    sample.recognises(Recognition::Certain, {file});
    sample.recognises(Recognition::No,
        {"(* ST_PositionCompensationTableElement *)\n", "// ST_PositionCompensationTableElement\n",
            "x : ARRAY[0..3] OF LREAL;\n", "0,0\n1,1\n"});
    // The older library: other names, and no brackets round the elements.
    const std::string older =
        "stPar : ST_PositionCompensationTableParameter := (fPosMin:=0, fPosMax:=20);\n";
    sample.applies({{{15}, 0.375}},
        "par : ST_PositionCompensationTableParameter := (fPosMin := 0, fPosMax := 20, "
        "NoOfTableElements := 3);\ntab : ARRAY[1..3] OF ST_PositionCompensationTableElement := "
        "(fPos := 0, fCompensation := 0), (fPos := 10, fCompensation := 0.25), (fPos := 20, "
        "fCompensation := 0.5);\n");
    sample.warning("a unit that nobody says", file, {"0:0 UnitNotGiven"}, FormatSettings());
    sample.warning("statements that change the table and its parameters",
        file + "stTab[2].Compensation := 0.5;\nsttab[i].Compensation:=1;\nstPar.Modulo := TRUE;\n",
        {"8:1 Assumption stTab, which is changed by a statement"});
    sample.warning("a statement that changes the parameters", file + "STPAR.Modulo := TRUE;\n",
        {"8:1 Assumption STPAR, which is changed by a statement"});
    sample.warning("statements that use the table",
        file
            + "fb(Enable := TRUE, Table := ADR(stTab), Parameter := stPar, n := 4);\n"
              "IF stTab[2].Compensation > 0 THEN x := stTab[2].Position; END_IF\n",
        {});
    sample.warning("an unknown member", with("Modulo:=FALSE", "Ramp:=5, Modulo:=FALSE"),
        {"3:57 UnknownKey Ramp|"});

    const auto row = sample.problemRow();
    row("no table", "VAR\nEND_VAR\n",
        "0:0 Syntax |a variable of the type ST_PositionCompensationTableParameter");
    row("parameters alone", older, "1:0 Syntax |an array of ST_PositionCompensationTableElement");
    row("elements alone", file.substr(file.find("stTab")),
        "1:24 Syntax ST_PositionCompensationTableElement|a variable of the type ST_Position");
    row("no end", with("];\n", "]\n"), "7:0 Syntax a declaration without its end|a semicolon");
    row("no count", with("NoOfTableElements:=4, ", ""), "0:0 NotANumber |the number of elements");
    row("fewer elements", with("=4", "=5"), "3:24 MissingPoint 4 elements|5, as NoOfTableElements");
    row("more elements", with("=4", "=3"), "3:24 Contradiction 4 elements|3, as NoOfTableElements");
    row("another range", with("30.0,\n", "40.0,\n"),
        "2:0 Contradiction positions from 0 to 30|from 0 to 40, as MinPosition");
    row("a number in the brackets of its neighbour",
        with("(Position:=0.0, Compensation:=0.0), (Position := 10.0, Compensation := 0.1)",
            "(Position:=0.0), (Compensation:=0.0, Position := 10.0, Compensation := 0.1)"),
        "5:60 Contradiction Compensation|one position and one compensation in each pair");
    row("another direction", with("WorkDirectionBoth", "WorkDirectionPositive"),
        "3:38 Contradiction WorkDirectionPositive|WorkDirectionBoth");
    row("neither true nor false", with("FALSE", "PERHAPS"), "3:65 Syntax PERHAPS|TRUE or FALSE");
    row("uneven", with("n := 10.0", "n := 11.0"), "5:0 UnevenSpacing positions from 0 to 30|equal");
    row("not increasing", with("n := 10.0", "n := 0.0"), "5:0 NotMonotonic 0 after 0|");
    row("a position that is none", with("n := 10.0", "n := ten"), "5:54 NotANumber ten|a position");
    row("an expression", with("n := 0.1)", "n := 0.1*UM)"),
        "5:79 Syntax *|a comma, a bracket or a semicolon behind the value \"0.1\"");
    row("a decimal comma of a compensation", with("n := 0.1)", "n := 0,1)"),
        "5:76 NotANumber 0,1|a number with a decimal point");
    row("a decimal comma of a position", with("n := 10.0,", "n := 10,0,"),
        "5:54 NotANumber 10,0|a number with a decimal point");
    row("a decimal comma of a parameter", with("MinPosition:=0.0", "MinPosition:=0,0"),
        "2:64 NotANumber 0,0|a number with a decimal point");
    row("a compensation is missing", with(", Compensation := 0.1)", ")"),
        "5:0 Syntax an element of one number|a position and a compensation");
    row("ends that differ", with("FALSE", "TRUE"),
        "6:0 NotPeriodic the values 0 and 0.15 at the ends|the same value at both ends");
    row("no elements",
        with("(Position:=0.0, Compensation:=0.0), (Position := 10.0, Compensation := "
             "0.1),\n    (Position:=20.0, Compensation:=0.2), (Position:=30.0, "
             "Compensation:=0.15)",
            ""),
        "2:0 TooFewPoints 0 elements|at least 2");

    sample.writes("an axis", {example(33)})
        .remarking({"the manual contradicts itself", "Position Correction of the axis on"});
    NeutralTable small = example(3);
    small.axes[0] = test::evenAxis("", "deg", 0, 180, 3);
    small.axes[0].wrap = 360;
    small.columns[0] = test::columnOf("#1", "deg", {0.5, -0.25, 0.5});
    sample.writes("a modulo axis", {small})
        .with({{"name", "Axis_1"}})
        .readWith({{"position-unit", "deg"}})
        .as("stAxis_1Parameter : ST_PositionCompensationTableParameter := (MinPosition:=0.0, "
            "MaxPosition:=360.0, NoOfTableElements:=3, Direction:=WorkDirectionBoth, "
            "Modulo:=TRUE);\n"
            "stAxis_1Table : ARRAY[0..2] OF ST_PositionCompensationTableElement := [\n"
            "    (Position:=0.0, Compensation:=0.5),\n"
            "    (Position:=180.0, Compensation:=-0.25),\n"
            "    (Position:=360.0, Compensation:=0.5)\n"
            "];\n");
    sample.refuses("a name that is none", {example(3)}, ErrorCode::InvalidArgument,
        "expected letters, digits", FormatSettings{{"name", "1 axis"}});
    sample.refuses("an open period",
        {changed(small, [](NeutralTable& table) { table.columns[0].values.back() = 1; })},
        ErrorCode::FormatCannotHold, "differ by");
    sample.refuses("another axis",
        {changed(example(3), [](NeutralTable& table) { table.columns[0].target = "Z"; })},
        ErrorCode::TargetNotKnown);
}

} // namespace

class TestTwincatNc : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void pairsOfPositionAndCompensationAreRead()
    {
        READ_TABLE(table, format, file, inMillimetres);
        QCOMPARE(problemLines(*reading_table), std::string());
        QCOMPARE(table.name, std::string("stTab"));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{0, 10, 20, 30}));
        QCOMPARE(table.columns[0].values, (std::vector<double>{0, 0.1, 0.2, 0.15}));
        QVERIFY(!table.axes[0].wrap);
        QVERIFY(ownAxis(table, table.columns[0]) == std::optional<std::size_t>(0));
    }

    void asFeedbackTheCorrectionStandsWhereItLeadsTo()
    {
        READ_TABLE(table, format, file, inMillimetres);
        const auto feedback = convertSign(
            table, SignConvention::Feedback, format.facts.behaviour, ConvertedKnots::Exact);
        VERIFY_RESULT(feedback);
        QCOMPARE(test::applied(format, feedback->table, {10.1}), -0.1);
    }

    void aModuloTableRepeats()
    {
        READ_TABLE(table, format,
            test::with(with("FALSE", "TRUE"), "Compensation:=0.15", "Compensation:=0.0"),
            inMillimetres);
        QCOMPARE(table.axes[0].wrap.value_or(0.0), 30.0);
        QCOMPARE(test::applied(format, table, {45}), 0.15); // as at 15
    }

    void eachPairOfVariablesIsATable()
    {
        const auto reading = format.read(file + file, inMillimetres);
        VERIFY_RESULT(reading);
        QCOMPARE(reading->tables.size(), std::size_t{2});
        QCOMPARE(problemLines(*reading), std::string());
    }
};

AXISCOMP_TEST(TestTwincatNc)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_twincatnc

#include "tst_twincatnc.moc"
