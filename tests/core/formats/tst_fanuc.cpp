// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/sign_conversion.h"
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_fanuc {

using namespace axiscomp;
using test::changed;
using test::problemLines;

namespace {

const TableFormat& format = fanuc::format();

std::string linesOf(int first, const std::vector<int>& steps)
{
    std::string text = "%\n";
    for (const int step : steps)
        text += "N" + std::to_string(first++) + "P" + std::to_string(step) + "\n";
    return text + "%\n";
}

/// The published example: numbers 33 to 49, of which 40 is that of the reference point.
const std::string file = linesOf(10033, {2, 1, 1, -2, 0, -1, 0, -1, 2, 1, 0, -1, -1, -2, 0, 1, 2});
const auto with = test::changing(file);

const FormatSettings ofExample{{"reference-number", "40"}, {"interval", "50"},
    {"detection-unit", "0.001"}, {"position-unit", "mm"}};
const TableReadOptions reading = test::readingWith(ofExample);

/// A rotary axis of eight sections: numbers 61 to 68, and 60 for the last one once more.
const std::string turn = linesOf(10060, {1, 2, -2, 1, -1, -1, 0, 0, 1});
const FormatSettings ofTurn{{"reference-number", "60"}, {"interval", "45"},
    {"detection-unit", "0.001"}, {"position-unit", "deg"}, {"wrap-range", "360"}};

/// The settings of the example with another value.
FormatSettings set(const std::string& key, const std::string& value, FormatSettings settings)
{
    settings[key] = value;
    return settings;
}
FormatSettings set(const std::string& key, const std::string& value)
{
    return set(key, value, ofExample);
}

const FormatSettings writing{{"reference-number", "40"}, {"detection-unit", "0.001"}};

NeutralTable tableOf(std::string unit, SourceAxis axis, const std::vector<double>& steps)
{
    NeutralTable table = test::commandTable({std::move(axis)}, {test::columnOf("#1", unit, {})});
    for (const double step : steps)
        table.columns[0].values.push_back(step / 1000.0);
    return table;
}
/// What the control applies in the published example.
NeutralTable example()
{
    return tableOf("mm", test::evenAxis("", "mm", -400, 50, 18),
        {0, 2, 3, 4, 2, 2, 1, 1, 0, 2, 3, 3, 2, 1, -1, -1, 0, 2});
}
NeutralTable rotary(double first)
{
    NeutralTable table = tableOf("deg", test::evenAxis("", "deg", first, 45, 9),
        first == 0 ? std::vector<double>{0, 2, 0, 1, 0, -1, -1, -1, 0}
                   : std::vector<double>{0, -1, -1, -1, 0, 2, 0, 1, 0});
    table.axes[0].wrap = 360;
    return table;
}

void describeReading(test::FormatSample& sample)
{
    sample.text = file;
    sample.reading = reading;
    sample.isOnlyNamed = true;
    sample.comment = "(";
    sample.spareBytes = 1;
    sample.recognises(Recognition::No, {file, turn, "%\nN03620P40\n%\n"});
    // The published numbers of the example; one step is 0.001 mm.
    sample.applies({{{-250}, 0.004}, {{-275}, 0.0035}, {{-300}, 0.003}, {{-400}, 0}, {{0}, 0},
        {{50}, 0.002}, {{150}, 0.003}, {{300}, -0.001}, {{400}, 0}, {{450}, 0.002}, {{1000}, 0.002},
        {{-1000}, 0}});
    sample.warning("a unit that nobody says", file, {"0:0 UnitNotGiven"},
        FormatSettings{
            {"reference-number", "40"}, {"interval", "50"}, {"detection-unit", "0.001"}});
    sample.warning("a value again", with("N10034P1", "N10033P3\nN10034P1"),
        {"3:8 DuplicateValue value 33 again|"});
    sample.warning("an interval in increments", with("%\n", "%\nN03624A1P50000\n"),
        {"2:0 Assumption parameter 3624 of 50000|a number with a decimal point, to compare it with "
         "the setting interval of 50;"});
    // The interval of the axis, that of another one, and none.
    sample.warning("the same interval in the file",
        with("%\n",
            "%\nN03620A1P0A2P40\nN03621A1P0A2P33\nN03622A1P0A2P49\n"
            "N03624A1P25.000A2P50.000\nN03625A1P360.0\n"),
        {});
    sample.warning("an interval of 0", with("%\n", "%\nN03624P0\n"), {});
    sample.warning("a turn in the file", test::with(turn, "%\n", "%\nN03625P360.0\n"), {}, ofTurn);
    sample.warning("lines of something else", with("N10049P2", "N10049P2\nN20000P1\nN20001P1"),
        {"19:1 LeftOut line N20000|N10000 to N19999, as the setting first-record says"});
    sample.warning("many points", linesOf(10000, std::vector<int>(129)),
        {"0:0 LimitExceeded 129 points|at most 128 of an axis"});
}

void describeProblems(test::FormatSample& sample)
{
    const auto row = sample.problemRow();
    row("no line in front", with("%\n", ""), "1:1 Syntax N10033P2|a line % in front of it");
    row("nothing", "(pitch errors)\n", "0:0 Syntax |lines such as N10033P2 between two lines %");
    row("no end", file.substr(0, file.size() - 2), "18:0 Syntax lines without an end|a line %");
    row("another line", with("N10034P1", "G90"), "3:1 Syntax G90|a line such as N10033P2");
    row("no value", with("N10034P1", "N10034"), "3:1 Syntax N10034|a line such as N10033P2");
    row("another letter", with("N10034P1", "N10034A1P1"), "3:1 Syntax N10034A1P1|a line such as");
    row("half a number", with("P1\n", "P1.5\n"), "3:8 NotANumber 1.5|a whole number of increments");
    row("a huge number", with("P1\n", "P2147483648\n"),
        "3:8 LimitExceeded 2147483648|at most 2147483647");
    row("parameters alone", "%\nN03620P40\n%\n",
        "0:0 TooFewPoints no line from N10000 to N19999|pitch error data; the setting "
        "first-record");
    row("a missing number", with("N10034P1\n", ""),
        "3:0 MissingPoint no value 34|each number from 33 to 49; first-number and last-number");
    row("both directions", with("%\n", "%\nN03605A1P00000000A2P00000001\n"),
        "2:1 Contradiction bit 0 of parameter 3605 is 1: values for each direction of motion|one "
        "value for both directions");
    row("another reference point in the file", with("%\n", "%\nN03620A1P38A2P0\n"),
        "2:0 Contradiction parameter 3620, which is 40 for no axis|the reference point, numbers "
        "and "
        "magnification of one axis, as the settings say");
    row("another magnification in the file", with("%\n", "%\nN03620P40\nN03623P10\n"),
        "3:0 Contradiction parameter 3623, which is 1 for no axis|");
    row("another interval in the file",
        with("%\n",
            "%\nN03620A1P40A2P0\nN03621A1P33A2P0\nN03622A1P49A2P0\n"
            "N03624A1P25.000A2P50.0\n"),
        "5:0 Contradiction parameter 3624 of 25.000|50, as the setting interval says");
    row("numbers of two axes", with("%\n", "%\nN03621A1P33A2P45\nN03622A1P44A2P49\n"),
        "2:0 Contradiction parameters 3620 to 3623 of several axes, and numbers 33 to 49|the "
        "numbers of one axis; first-number and last-number choose them");
    row("parameters of two axes without their numbers", with("%\n", "%\nN03620A1P40A2P60\n"),
        "2:0 Contradiction parameters 3620 to 3623 of several axes, and numbers 33 to 49|");
    const auto ofSettings = [&](const char* name, const std::string& text, const char* line,
                                const FormatSettings& settings) {
        sample.problem(name, text, line, {}, settings);
    };
    ofSettings("another reference point", file,
        "0:0 Contradiction the numbers 33 to 49 for the axis|numbers round that of the reference "
        "point, 50, as the setting reference-number says",
        set("reference-number", "50"));
    ofSettings("numbers that are not there", file, "0:0 MissingPoint no value 50|each number",
        set("last-number", "51"));
    ofSettings("numbers from the last to the first", file,
        "0:0 Contradiction the numbers 45 to 42 for the axis|",
        set("first-number", "45", set("last-number", "42")));
    ofSettings("a turn that is not complete", linesOf(10060, {1, 1, -2, 1}),
        "0:0 MissingPoint no value 64|the numbers 61 to 68 of one turn", ofTurn);
    ofSettings("another turn in the file", test::with(turn, "%\n", "%\nN03625P180.\n"),
        "2:0 Contradiction parameter 3625 of 180.|360, as the setting wrap-range says", ofTurn);
    ofSettings("a turn that does not close", linesOf(10060, {1, 2, -2, 1, -1, -1, 0, 0, 2}),
        "10:0 NotPeriodic the values 61 to 68, which add up to 1|0 over one turn", ofTurn);
    ofSettings("another last section", linesOf(10060, {2, 2, -2, 1, -1, -1, 0, 0, 1}),
        "2:0 NotPeriodic value 60, of the reference point|the same as value 68", ofTurn);
    ofSettings("no last section", linesOf(10061, {2, -2, 1, -1, -1, 0, 0, 1}),
        "9:0 MissingPoint value 60, of the reference point|the same as value 68", ofTurn);
    ofSettings("positions without an end", file, "0:0 NotFinite positions of the axis|",
        set("interval", "1e308"));

    sample.refusesReading("no interval", set("interval", "0"), "expected a number above 0");
    sample.refusesReading("interval is no number", set("interval", "x"), "a number such as 0.5");
    sample.refusesReading("no detection unit", set("detection-unit", "-1"), "number above 0");
    sample.refusesReading("no magnification", set("magnification", "0"), "expected 1 to 10000");
    sample.refusesReading("no such number", set("reference-number", "10000"), "expected 0 to 9999");
    sample.refusesReading("no range", set("wrap-range", "0"), "expected more than 0");
    sample.refusesReading("part of an interval", set("wrap-range", "360"),
        "the setting wrap-range is 360, expected 1 to 9999 times the interval of 50");
    sample.refusesReading("numbers of a turn", set("first-number", "61", ofTurn),
        "leave first-number and last-number out");
}

void describeWriting(test::FormatSample& sample)
{
    sample.writing = test::writingWith(writing);
    sample.writes("an axis", {example()})
        .as(file)
        .remarking({"3620 = 40, 3621 = 33, 3622 = 49, 3623 = 1, 3624 = 50 mm",
            "begin at line N10000 (first-record)", "at most 7 (largest-step)",
            "the sign is an assumption", "in doubt by half an interval", "PW1102"});
    sample.writes("a rotary axis", {rotary(0)})
        .with({{"reference-number", "60"}, {"detection-unit", "0.001"}})
        .readWith(ofTurn)
        .as(turn)
        .remarking({"3621 = 60, 3622 = 68, 3623 = 1, 3624 = 45 deg, 3625 = 360 deg"});
    sample.writes("a turn round the reference point", {rotary(-180)})
        .with({{"reference-number", "60"}, {"detection-unit", "0.001"}})
        .readWith(ofTurn)
        .as(turn)
        .becoming(rotary(0));
    NeutralTable open = rotary(0);
    open.axes[0].wrap.reset();
    sample.writes("an axis that a setting makes rotary", {open})
        .with({{"reference-number", "60"}, {"detection-unit", "0.001"}, {"wrap-range", "360"}})
        .readWith(ofTurn)
        .as(turn)
        .becoming(rotary(0));
    // Rounded are the amounts 1.4, 2.8, 4.2, not their differences.
    sample
        .writes(
            "rounded", {tableOf("mm", test::evenAxis("", "mm", 100, 10, 4), {0, 1.4, 2.8, 4.2})})
        .within(0.00041, 0)
        .with({{"reference-number", "0"}, {"detection-unit", "0.001"},
            {"reference-position", "100"}, {"first-record", "0"}})
        .readWith({{"reference-number", "0"}, {"detection-unit", "0.001"}, {"interval", "10"},
            {"reference-position", "100"}, {"first-record", "0"}, {"position-unit", "mm"}})
        .as("%\nN1P1\nN2P2\nN3P1\n%\n");
    sample.writes("magnified", {tableOf("mm", test::evenAxis("", "mm", 0, 50, 3), {0, 15, -6})})
        .with({{"reference-number", "40"}, {"detection-unit", "0.001"}, {"magnification", "3"}})
        .readWith(set("magnification", "3"))
        .as("%\nN10041P5\nN10042P-7\n%\n");
}

void describeRefusals(test::FormatSample& sample)
{
    const auto refuses = [&](const char* name, const NeutralTable& table, const char* reason,
                             const FormatSettings& settings = writing) {
        sample.refuses(name, {table}, ErrorCode::FormatCannotHold, reason, settings);
    };
    refuses("a reference point between points", example(), "the reference position 10 mm is no",
        set("reference-position", "10", writing));
    refuses("a reference point outside", example(), "the reference position 500 mm is no point",
        set("reference-position", "500", writing));
    refuses("a value at the reference point", example(),
        "its value at the reference position is 0.002 mm",
        set("reference-position", "50", writing));
    refuses("numbers below 0", example(), "the numbers -2 to 14",
        set("reference-number", "5", writing));
    refuses("numbers beyond the last", example(), "the numbers 9988 to 10004",
        set("reference-number", "9995", writing));
    refuses("a step that is too large",
        tableOf("mm", test::evenAxis("", "mm", 0, 50, 3), {0, 20, 40}),
        "from 0 mm to 50 mm it changes by 20 increments of 0.001 mm, and a value is at most 7");
    refuses("and its way out", tableOf("mm", test::evenAxis("", "mm", 0, 50, 3), {0, 20, 40}),
        "set magnification=3, the smallest that fits");
    refuses("a step beyond any magnification",
        tableOf("mm", test::evenAxis("", "mm", 0, 50, 3), {0, 1e6, 0}), "check detection-unit");
    refuses("a value beyond any number",
        tableOf("mm", test::evenAxis("", "mm", 0, 50, 3), {0, 1e200, 0}), "is too large");
    refuses("an open period",
        changed(rotary(0), [](NeutralTable& table) { table.columns[0].values.back() = 0.001; }),
        "differ by");
    sample.refuses("another range", {rotary(0)}, ErrorCode::InvalidArgument, "repeats after 360",
        set("wrap-range", "180", writing));
    sample.refuses("another axis",
        {changed(example(), [](NeutralTable& table) { table.columns[0].target = "Z"; })},
        ErrorCode::TargetNotKnown, {}, writing);
    sample.refuses("no step at all", {example()}, ErrorCode::InvalidArgument, "expected 1 to",
        set("largest-step", "0", writing));
}

void describe(test::FormatSample& sample)
{
    sample.facts = "command is assumed; 1 to 1 dimensions, even knots; "
                   "points 10001, columns 1, tables 1, bytes 67108864; holds wrap";
    describeReading(sample);
    describeProblems(sample);
    describeWriting(sample);
    describeRefusals(sample);
}

} // namespace

class TestFanuc : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theValuesAddUpFromTheReferencePointToBothSides()
    {
        READ_TABLE(table, format, file, reading);
        COMPARE_TABLES(table, example(), 0.0);
        QVERIFY(ownAxis(table, table.columns[0]) == std::optional<std::size_t>(0));
    }

    void magnificationAndReferencePositionCount()
    {
        READ_TABLE(table, format, file,
            test::readingWith(set("magnification", "3", set("reference-position", "1000"))));
        QCOMPARE(table.axes[0].knots.front(), 600.0);
        QCOMPARE(test::applied(format, table, {750}), 0.012);
        QCOMPARE(test::applied(format, table, {1000}), 0.0);
    }

    /// A whole file of a control: parameters, comments, ends of blocks, blanks, and another axis.
    void whatAControlWritesRoundTheNumbersIsPassedOver()
    {
        std::string text = "%;\nN00000P00001100;\nN03605A1P00000010A2P00001110;\n(AXIS X)\n"
                           "N03620A1P40A2P0;\nN05898S1P30.0S2P30.0;\n";
        for (const std::string line : {"N10010P7", "n 10040 p +1", "N10041P-1;N10042P2"})
            text += line + ";\n";
        text += "%\nbehind the end\n";
        READ_TABLE(table, format, text,
            test::readingWith(set("first-number", "40", set("last-number", "42"))));
        QCOMPARE(problemLines(*reading_table), std::string());
        QCOMPARE(table.axes[0].knots, (std::vector<double>{-50, 0, 50, 100}));
        QCOMPARE(table.columns[0].values, (std::vector<double>{-0.001, 0, -0.001, 0.001}));
    }

    void aTurnHasTheNumbersBehindThatOfItsReferencePoint()
    {
        READ_TABLE(table, format, turn, test::readingWith(ofTurn));
        COMPARE_TABLES(table, rotary(0), 0.0);
        QCOMPARE(test::applied(format, table, {-45}), -0.001); // as at 315
    }

    /// No content tells it from parameters: neither its own format nor another one takes it.
    void noFormatClaimsSuchAFile()
    {
        for (const std::string& text : {file, turn, std::string("%\nN03620P40\n%\n"),
                 std::string("%;\nN10033P2;\nN10034P1;\n%\n"), linesOf(10033, {2}),
                 std::string("N10033P2\nN10034P1\n")})
            for (const char* name : {"CNC-PARA.TXT", "pitch.dat", "pitch.prg", "pitch"}) {
                QVERIFY2(guessFormat(text, name).formats.empty(), name);
                VERIFY_ERROR(chooseFormat(text, name, false), ErrorCode::UnknownFormat);
            }
    }

    void whatAPersonStatesIsNotSaidToBeUnknown()
    {
        const auto remarksOn = [](const FormatSettings& settings) {
            const auto written = format.write(std::array{example()}, test::writingWith(settings));
            return written ? test::joined(written->remarks) : std::string();
        };
        const std::string step = remarksOn(set("largest-step", "20", writing));
        QVERIFY2(!test::mentions(step, "largest-step") && test::mentions(step, "first-record"),
            step.c_str());
        const std::string record = remarksOn(set("first-record", "0", writing));
        QVERIFY2(!test::mentions(record, "first-record") && test::mentions(record, "largest-step"),
            record.c_str());
    }

    void valuesForEachDirectionAreRefusedByName()
    {
        NeutralTable table = example();
        table.columns.push_back(table.columns[0]);
        table.columns[0].direction = Direction::Positive;
        table.columns[1].direction = Direction::Negative;
        const auto refused = checkHolds(format.facts, std::array{table});
        VERIFY_ERROR(refused, ErrorCode::FormatCannotHold);
        QVERIFY(test::mentions(sentence(refused.error()), "fanuc"));
        QVERIFY(test::mentions(sentence(refused.error()), "both directions of motion"));
    }

    void morePointsThanOneSourceSaysAreWrittenAndSaid()
    {
        const NeutralTable table =
            tableOf("mm", test::evenAxis("", "mm", 0, 50, 130), std::vector<double>(130));
        WRITE_TABLE(written, format, table, test::writingWith(writing));
        QVERIFY(test::mentions(test::joined(written->remarks),
            "these are 129 points, and one source says that an axis has at most 128"));
    }

    void asFeedbackTheCorrectionStandsWhereItLeadsTo()
    {
        READ_TABLE(table, format, file, reading);
        const auto feedback = convertSign(
            table, SignConvention::Feedback, format.facts.behaviour, ConvertedKnots::Exact);
        VERIFY_RESULT(feedback);
        QCOMPARE(test::applied(format, feedback->table, {-249.996}), -0.004);
    }
};

AXISCOMP_TEST(TestFanuc)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_fanuc

#include "tst_fanuc.moc"
