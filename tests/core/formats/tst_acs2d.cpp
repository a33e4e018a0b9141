// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_acs2d {

using namespace axiscomp;
using test::changed;
using test::problemLines;

namespace {

const TableFormat& format = acs_2d::format();

/// Not square, so that swapped indices are noticed.
const std::string program =
    "! plane\n"
    "GLOBAL REAL M0(2)(3)\n"
    "BASE0 = -615; INCREMENT0 = 10\n"
    "BASE1 = -240; INCREMENT1 = 10\n"
    "M0(0)(0) = 0.010\n"
    "M0(0)(1) = 0.012\n"
    "M0(0)(2) = 0.016\n"
    "M0(1)(0) = 0.020\n"
    "M0(1)(1) = 0.018\n"
    "M0(1)(2) = 0.010\n"
    "MFLAGS(0).#DEFCON = 0\n"
    "CONNECT RPOS(0) = APOS(0) + MAP2(APOS(0), APOS(1), M0, BASE0, INCREMENT0, BASE1, INCREMENT1)\n"
    "DEPENDS 0, (0,1)\n";
const auto with = test::changing(program);

const FormatSettings inMillimetres{{"position-unit", "mm"}, {"value-unit", "mm"}};

NeutralTable exampleTable(const std::string& target = "0")
{
    return test::commandTable(
        {test::evenAxis("0", "mm", -615, 10, 3), test::evenAxis("1", "mm", -240, 10, 2)},
        {test::columnOf(target, "mm", {0.010, 0.012, 0.016, 0.020, 0.018, 0.010})});
}

void describeWriting(test::FormatSample& sample)
{
    const FormatSettings sources{{"source-axis-1", "0"}, {"source-axis-2", "1"}};
    sample.writing = test::writingWith(sources);
    const auto extended = [&](const char* key, const char* value) {
        FormatSettings settings = sources;
        settings[key] = value;
        return settings;
    };
    sample
        .writes("three rows",
            {test::commandTable(
                {test::evenAxis("0", "mm", 0, 0.1, 4), test::evenAxis("1", "mm", -5, 2.5, 3)},
                {test::waveColumn("1", "mm", 12, 0.01)})})
        .within(0, 1e-15);
    sample
        .writes("one of the sources",
            {changed(exampleTable(), [](NeutralTable& t) { t.notes = {"a note"}; })})
        .as("! a note\nGLOBAL REAL STATIC ERRORMAP(2)(3)\nERRORMAP(0)(0) = 0.01\n"
            "ERRORMAP(0)(1) = 0.012\nERRORMAP(0)(2) = 0.016\nERRORMAP(1)(0) = 0.02\n"
            "ERRORMAP(1)(1) = 0.018\nERRORMAP(1)(2) = 0.01\nMFLAGS(0).#DEFCON = 0\n"
            "CONNECT RPOS(0) = APOS(0) + MAP2(APOS(0), APOS(1), ERRORMAP, -615, 10, -240, 10)\n"
            "DEPENDS 0, (0,1)\nSTOP\n")
        .remarking({"must not have declared", "replaces an error map of axis 0"});
    sample.writes("another axis", {exampleTable("Z")})
        .with(extended("target-axis", "2"))
        .containing({"CONNECT RPOS(2) = APOS(2) + MAP2(APOS(0), APOS(1), ", "DEPENDS 2, (0,1)"})
        .becoming(exampleTable("2"));
    sample.writes("without a declaration, another name", {exampleTable("1")})
        .with({{"source-axis-1", "4"}, {"source-axis-2", "7"}, {"target-axis", "7"},
            {"declare", "no"}, {"name", "M0"}})
        .containing({"M0(1)(2) = 0.01\nMFLAGS(7)", "MAP2(APOS(4), APOS(7), M0, "})
        .remarking({"must have declared the array M0"})
        .becoming(changed(exampleTable(), [](NeutralTable& t) {
            t.axes[0].name = "4";
            t.axes[1].name = t.columns[0].target = "7";
        }));
    const auto refuses = [&](const char* name, const NeutralTable& table, const char* reason,
                             const FormatSettings& settings) {
        sample.refuses(name, {table}, ErrorCode::InvalidArgument, reason, settings);
    };
    refuses("another axis without its number", exampleTable("Z"), "needs the setting target-axis",
        sources);
    refuses("another axis with the number of a source", exampleTable("Z"), "contradict",
        extended("target-axis", "1"));
    refuses("a source with the number of the other", exampleTable("0"), "contradict",
        extended("target-axis", "1"));
    refuses("a source twice", exampleTable(), "both sources are axis 0",
        extended("source-axis-2", "0"));
    refuses("an axis below 0", exampleTable(), "source-axis-2", extended("source-axis-2", "-1"));
    refuses("no name", exampleTable(), "the setting name", extended("name", "a-b"));
    refuses("two units for an axis", exampleTable(), "has one unit for both",
        extended("value-unit", "um"));
    sample.refuses("a target that is not stated", {exampleTable("")}, ErrorCode::TargetNotKnown);
}

void describe(test::FormatSample& sample)
{
    sample.facts = "command is read in program code; 2 to 2 dimensions, even knots; points any, "
                   "columns 1, tables 1, bytes 67108864; holds notes";
    sample.reading = test::readingWith(inMillimetres);
    sample.text = program;
    sample.comment = "! ";
    sample.spareBytes = 18; // DEPENDS is not needed to read it
    sample.applies({{{-610, -235}, 0.015}, {{-595, -232.5}, 0.0115}, {{-600, -240}, 0.014},
        {{0, -1000}, 0.016}});
    sample.recognises(Recognition::Certain, {program});
    sample.recognises(Recognition::No,
        {"! MAP2\n", "M0(0)(0) = 1\n", "CONNECT RPOS(0) = APOS(0)\n", "ERRORMAP1D 0, 0, 0, 1, A\n",
            "CONNECT RPOS(0) = APOS(0) + MAP(APOS(0), M, 0, 1)\n"});
    sample.recognises(Recognition::Possible, {program + "ERRORMAP1D 0, 0, 0, 1, A\n"});
    sample.warning("declared larger", with("M0(2)(3)", "M0(53)(64)"),
        {"2:13 Assumption M0(53)(64) with elements for M0(2)(3)|"});
    sample.warning("a map of one axis besides", program + "ERRORMAP1D 0, 0, 0, 1, A\n",
        {"14:1 LeftOut a map of one axis (ERRORMAP1D)|the format acs-1d to read it"});
    sample.warning("another map of the axis",
        program
            + "M1(0)(0)=1;M1(0)(1)=2;M1(1)(0)=3;M1(1)(1)=4\n"
              "CONNECT RPOS(0) = APOS(0) + MAP2(APOS(0), APOS(1), M1, 0, 5, 0, 7)\n",
        {"15:1 Assumption another map of axis 0, besides that of line 12|one map"});
    sample.warning("an element twice", with("MFLAGS", "M0(1)(2) = 0.01\nMFLAGS"),
        {"11:12 DuplicatePoint M0(1)(2) a second time|"});
    sample.warning("a base twice", with("BASE1 = -240;", "BASE1 = 0; BASE1 = -240;"),
        {"4:20 DuplicateValue BASE1 a second time|each value once; the last one counts"});
    sample.warning("another connection", program + "CONNECT RPOS(0) = APOS(0)\n",
        {"14:1 Assumption \"CONNECT RPOS(0) = APOS(0)\", which switches a table of the file off|"});
    sample.warning("connections of others and before",
        "MFLAGS(0).17 = 1\n" + program + "CONNECT RPOS(1) = APOS(1)\n", {});
    sample.warning("no units", program,
        {"0:0 UnitNotGiven positions without a unit", "0:0 UnitNotGiven values without a unit"},
        FormatSettings{});
    describeWriting(sample);

    const auto row = sample.problemRow();
    row("no map", "M0(0)(0) = 1\n", "0:0 Syntax |a statement CONNECT with MAP2");
    row("a map of one axis only", "ERRORMAP1D 0, 0, 0, 1, A\n",
        "1:1 Syntax a map of one axis (ERRORMAP1D)|the format acs-1d");
    row("swapped sizes", with("M0(2)(3)", "M0(3)(2)"), "2:13 Contradiction M0(3)(2)|M0(2)(3)");
    row("an element is missing", with("M0(1)(0) = 0.020\n", ""), "11:52 MissingPoint no M0(1)(0)|");
    row("one index", with("M0(1)(0) =", "M0(1) ="), "8:9 Syntax 0.020|two indices of M0");
    row("an expression", with("0.020", "A/2"), "8:12 NotANumber A/2|");
    row("an element within IF", with("M0(1)(2) = 0.010", "IF 0; M0(1)(2) = 0.010; END"),
        "10:18 Syntax 0.010|a number outside of IF, ELSE, SWITCH, LOOP, WHILE and ON; only");
    row("another array is copied into it", with("MFLAGS", "COPY(M1, M0)\nMFLAGS"),
        "11:1 NotANumber COPY(M1, M0)|numbers for the elements of M0 alone; what else changes");
    row("a computed index", with("M0(1)(0) =", "M0(1)(J) ="), "8:7 NotANumber J|an index");
    row("a step of 0", with("INCREMENT1 = 10", "INCREMENT1 = 0"),
        "12:82 LimitExceeded a step of 0|");
    row("a name without a value", with("BASE1 = -240;", ""), "12:75 NotANumber BASE1|a number");
    row("two units for an axis", program,
        "0:0 Contradiction positions in mm and values in um|one unit", std::string(),
        FormatSettings{{"position-unit", "mm"}, {"value-unit", "um"}});
    row("one row", "M(0)(0)=1;M(0)(1)=2\nCONNECT RPOS(0)=APOS(0)+MAP2(APOS(0),APOS(1),M,0,1,0,1)\n",
        "2:0 TooFewPoints 1 position of axis 1|at least 2");
    const std::string connect = "12:1 Syntax CONNECT RPOS(0) =";
    row("the same source twice", with("APOS(1)", "APOS(0)"), connect);
    row("added to another axis", with("= APOS(0)", "= APOS(1)"), connect);
    row("subtracted", with("+ MAP2", "- MAP2"), connect);
    row("other arguments", with(", INCREMENT1", ""), connect);
    row("another position", with("MAP2(APOS(0)", "MAP2(FPOS(0)"), connect);
    row("a map that is not supported", program + "ERRORMAP2D 0, 0\n",
        "14:1 Syntax ERRORMAP2D, which is not supported|");
}

} // namespace

class TestAcs2d : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theFirstIndexBelongsToTheSecondSource()
    {
        READ_TABLE(table, format, program, test::readingWith(inMillimetres));
        COMPARE_TABLES(table, exampleTable(), 0.0);
        QCOMPARE(table.name, std::string("M0"));
        QCOMPARE(table.notes, (std::vector<std::string>{"plane"}));
    }

    void namesOfAxesAreThoseOfTheProgram()
    {
        READ_TABLE(table, format,
            "AXISDEF X=0, Y=1, Z=4\n"
                + test::with(with("RPOS(0)", "RPOS(Z)"), "APOS(0)", "APOS(4)"),
            test::readingWith(inMillimetres));
        QCOMPARE(table.axes[0].name, std::string("X"));
        QCOMPARE(table.axes[1].name, std::string("Y"));
        QCOMPARE(table.columns[0].target, std::string("Z"));
        QVERIFY(!ownAxis(table, table.columns[0]));
    }

    /// The unit of the values is that of the source that is corrected, not of the first one.
    void sourcesMayHaveUnitsOfTheirOwn()
    {
        const NeutralTable table = test::commandTable(
            {test::evenAxis("0", "mm", 0, 5, 2), test::evenAxis("1", "deg", 0, 90, 3)},
            {test::columnOf("1", "deg", {0, 0.01, 0.02, -0.03, 0, 0.05})});
        WRITE_TABLE(written, format, table,
            test::writingWith({{"source-axis-1", "0"}, {"source-axis-2", "1"}}));
        QCOMPARE(written->held.size(), std::size_t(1));
        COMPARE_TABLES(written->held.front(), table, 0.0);
    }

    void twoConnectionsOverTheSameSourcesAreTwoTables()
    {
        const auto reading = format.read(program
                + "M1(0)(0)=1;M1(0)(1)=2;M1(1)(0)=3;M1(1)(1)=4\n"
                  "CONNECT RPOS(1) = APOS(1) + MAP2(APOS(0), APOS(1), M1, 0, 5, 0, 7)\n",
            test::readingWith(inMillimetres));
        VERIFY_RESULT(reading);
        QVERIFY2(reading->diagnostics.empty(), problemLines(*reading).c_str());
        QCOMPARE(reading->tables.size(), std::size_t(2));
        QCOMPARE(reading->tables[1].name, std::string("M1"));
        QCOMPARE(ownAxis(reading->tables[1], reading->tables[1].columns[0]), std::optional(1UL));
        QCOMPARE(reading->tables[1].columns[0].values, (std::vector<double>{1, 2, 3, 4}));
        QCOMPARE(reading->tables[1].axes[1].knots, (std::vector<double>{0, 7}));
    }
};

AXISCOMP_TEST(TestAcs2d)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_acs2d

#include "tst_acs2d.moc"
