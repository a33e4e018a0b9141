// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_powerpmac {

using namespace axiscomp;
using test::changed;
using test::problemLines;

namespace {

const TableFormat& format = power_pmac::format();

const std::string file =
    "// left gantry\n"
    "CompTable[0].Source[0] = 1;\n"
    "CompTable[0].Nx[0] = 4; CompTable[0].Nx[1] = 0; CompTable[0].Nx[2] = 0;\n"
    "CompTable[0].X0[0] = -100000; CompTable[0].Dx[0] = 200000;\n"
    "CompTable[0].Target[0] = Motor[1].CompPos.a; CompTable[0].Target[1] = Motor[1].CompPos2.a;\n"
    "CompTable[0].Sf[0] = 1; CompTable[0].Ctrl = 7; CompTable[0].OutCtrl = 0;\n"
    "CompTable[0].Data[0] = 0,12.5,-3,4,8;\n"
    "Sys.CompEnable = 1;\n";
const auto with = test::changing(file);

TableReadOptions counted(const std::string& counts)
{
    return test::readingWith(
        {{"counts-per-unit", counts}, {"position-unit", "mm"}, {"value-unit", "mm"}});
}

NeutralTable example(std::size_t count)
{
    NeutralTable table = test::tableOf(SignConvention::Feedback,
        {test::evenAxis("3", "mm", -20, 0.5, count)}, {test::columnOf("3", "mm", {})});
    for (std::size_t i = 0; i < count; ++i)
        table.columns[0].values.push_back(static_cast<double>((i * 5) % 11) / 64.0);
    return table;
}

void describe(test::FormatSample& sample)
{
    sample.facts = "feedback is assumed; 1 to 1 dimensions, even knots; "
                   "points 1000000, columns 1, tables 1, bytes 67108864; holds";
    sample.text = file;
    sample.reading = counted("1");
    sample.writing = test::writingWith({{"counts-per-unit", "1024"}});
    sample.comment = "// ";
    sample.spareBytes = file.size() - file.find("4,8;") - 3;
    sample.applies({{{-75000}, 6.25}, {{0}, -3}, {{60000}, 4.8}, {{-200000}, 0}, {{200000}, 8}});
    sample.recognises(Recognition::Certain, {file, "comptable[3].nx[0]=2\n"});
    sample.recognises(
        Recognition::No, {"// CompTable[0]\n", "DEFINE COMP 4,#1D,#2,4000\n", "0,0\n1,1\n"});
    sample.warning("tables that are switched off", with("Enable = 1", "Enable = 0"),
        {"8:1 Assumption \"Sys.CompEnable = 0\", which switches a table of the file off"});
    const std::string second =
        "CompTable[1].Source[0] = 2; CompTable[1].Nx[0] = 1; CompTable[1].X0[0] = 0;\n"
        "CompTable[1].Dx[0] = 1; CompTable[1].Target[0] = Motor[1].CompPos.a;\n"
        "CompTable[1].Target[1] = Motor[1].CompPos2.a;\n"
        "CompTable[1].Data[0] = 0,0;\n";
    sample.warning("two tables for one motor, which the controller adds",
        with("Enable = 1", "Enable = 2") + second,
        {"0:0 Assumption several tables of 1 to 1, 2 to 1|their sum, since the controller adds"});
    const auto aloneRow = [&sample](const char* name, const std::string& text, const char* line) {
        sample.warning(name, text, {line});
    };
    aloneRow("the first feedback loop alone",
        with(" CompTable[0].Target[1] = Motor[1].CompPos2.a;", ""),
        "5:26 Assumption a table for CompPos alone|CompPos and CompPos2 of the motor; the table is "
        "taken for both");
    aloneRow("the second feedback loop alone",
        with("CompTable[0].Target[0] = Motor[1].CompPos.a; ", ""),
        "5:26 Assumption a table for CompPos2 alone|");
    aloneRow("the same feedback loop twice", with("CompPos2.a", "CompPos"),
        "5:71 Assumption a table for CompPos alone|");
    sample.warning("one of them is not in use", file + second,
        {"8:1 Assumption \"Sys.CompEnable = 1\", which switches a table of the file off"});
    sample.warning("another span further on", file + "CompTable[0].Dx[0] = 100000;\n",
        {"9:1 DuplicateValue CompTable[0].Dx[0] = 100000 a second time|each value once"});
    sample.warning("the same span again", file + "CompTable[0].Dx[0] = 200000;\n", {});
    // Data may be continued, and names are written in either case.
    const std::string continued = with("Data[0] = 0,12.5,-3,4,8",
        "data[0]=0,12.5,-3\n"
        "COMPTABLE[ 0 ].DATA[3] = 4,8");
    sample.applies({{{60000}, 4.8}}, continued);
    const std::string commented =
        with("Sys.", "/* before\nCompTable[0].Data[0] = 7,8,9;\n*/ Sys. /* CompTable[1] */");
    sample.applies({{{-75000}, 6.25}, {{60000}, 4.8}}, commented);
    sample.recognises(Recognition::No, {"/*\nCompTable[0].Nx[0] = 1;\n*/\n"});
    sample.warning("an unknown element", file + "CompTable[0].Wrap = 3;\n",
        {"9:1 UnknownKey CompTable[0].Wrap = 3|"});
    sample.warning("a third target", file + "CompTable[0].Target[2]=Motor[3].CompPos;\n",
        {"9:1 UnknownKey CompTable[0].Target[2]=Motor[3].CompPos|"});
    sample.warning("another scale factor", file + "CompTable[0].Sf[1] = -1;\n",
        {"9:1 UnknownKey CompTable[0].Sf[1] = -1|"});
    sample.warning("a scale factor", with("Sf[0] = 1", "Sf[0] = 2"),
        {"6:0 Assumption a scale factor Sf[0] of 2|1; it is taken to multiply"});
    sample.applies({{{0}, -6}}, with("Sf[0] = 1", "Sf[0] = 2"));
    sample.warning(
        "another way of working", with("Ctrl = 7", "Ctrl = 3"), {"6:0 Assumption ctrl=3|7;"});
    sample.warning("a value twice", with("Sys.", "CompTable[0].Data[4] = 8;\nSys."),
        {"8:24 DuplicateValue value 4 again|each value once"});
    sample.warning("units that nobody says", file,
        {"2:0 UnitNotGiven a table in motor units|the setting counts-per-unit"}, FormatSettings());
    sample.refusesReading("counts of 0", counted("0").settings, "expected a number above 0");
    sample.refusesReading(
        "counts that are no number", counted("many").settings, "expected a number such as 0.5");

    const auto row = sample.problemRow();
    row("no table", "Sys.CompEnable = 1;\n", "0:0 Syntax |assignments to CompTable[0]");
    row("a comment without an end", file + "/* CompTable[1]\n",
        "0:0 Syntax a comment without an end|*/ behind it");
    row("two sources", with("Nx[1] = 0", "Nx[1] = 3"),
        "3:0 LimitExceeded a table of several sources|one source: in which order");
    row("no segments", with("CompTable[0].Nx[0] = 4; ", ""),
        "2:0 Syntax |nx[0] of the table: the number of segments");
    row("segments are no number", with("Nx[0] = 4", "Nx[0] = 4.5"), "3:22 NotANumber 4.5|");
    row("no segment", with("Nx[0] = 4", "Nx[0] = 0"), "2:0 LimitExceeded 0 segments over 200000|");
    row("no span", with("Dx[0] = 200000", "Dx[0] = 0"), "2:0 LimitExceeded 4 segments over 0|");
    row("a value is missing", with("4,8", "4"), "2:0 MissingPoint no value 4|5, as Nx[0] + 1 says");
    row("a gap", with("Data[0]", "Data[1]"), "2:0 MissingPoint no value 0|5, as Nx[0] + 1");
    row("too many values", with("4,8", "4,8,9"), "7:0 Contradiction 6 values|5, as Nx[0] + 1");
    row("a value that is none", with("12.5", "12,x"), "7:29 NotANumber x|a value of the table");
    row("a value that is not finite", with("12.5", "inf"), "7:26 NotANumber inf|");
    row("another element as target", with("Motor[1].CompPos.a", "Motor[1].CompDesPos.a"),
        "5:26 Contradiction Motor[1].CompDesPos.a|CompPos or CompPos2 of one motor");
    row("two motors", with("Motor[1].CompPos2", "Motor[2].CompPos2"),
        "5:71 Contradiction Motor[2].CompPos2.a|");
    row("no motor", with("Source[0] = 1", "Source[0] = EncTable[1].a"),
        "2:26 NotANumber EncTable[1].a|the number of the source motor");
    row("no number of the table", with("CompTable[0].Sou", "CompTable[x].Sou"),
        "2:1 Syntax CompTable[x].Source[0] = 1|an assignment such as CompTable[0].Nx[0] = 4");
    row("a list that goes on alone", with("-3,4,8", "-3,4;\n8"),
        "2:0 MissingPoint no value 4|5, as Nx[0] + 1 says\n8:1 Syntax 8|an assignment");

    NeutralTable manual =
        test::tableOf(SignConvention::Feedback, {test::evenAxis("1", "mm", -1, 0.5, 5)},
            {test::columnOf("2", "mm", {0, 0.125, -0.25, 0.5, 1})});
    sample.writes("an axis", {example(33)})
        .readWith(counted("1024").settings)
        .remarking({"Sys.CompEnable must be at least 1", "are assumptions"});
    sample.writes("another motor and table", {manual})
        .with({{"counts-per-unit", "1024"}, {"table", "2"}})
        .readWith(counted("1024").settings)
        .as("CompTable[2].Source[0] = 1;\nCompTable[2].Nx[0] = 4;\nCompTable[2].Nx[1] = 0;\n"
            "CompTable[2].Nx[2] = 0;\nCompTable[2].X0[0] = -1024;\nCompTable[2].Dx[0] = 2048;\n"
            "CompTable[2].Target[0] = Motor[2].CompPos.a;\n"
            "CompTable[2].Target[1] = Motor[2].CompPos2.a;\nCompTable[2].Sf[0] = 1;\n"
            "CompTable[2].Ctrl = 7;\nCompTable[2].OutCtrl = 0;\n"
            "CompTable[2].Data[0] = 0,128,-256,512,1024;\nSys.CompEnable = 3;\n")
        .remarking({"Sys.CompEnable must be at least 3"});
    sample.refuses("counts of counts",
        {changed(manual,
            [](NeutralTable& table) { table.axes[0].unit = table.columns[0].unit = "counts"; })},
        ErrorCode::InvalidArgument, "in counts already",
        FormatSettings{{"counts-per-unit", "1024"}});
    NeutralTable letters = changed(manual, [](NeutralTable& table) {
        table.axes[0].name = "X";
        table.columns[0].target = "Z";
    });
    sample.refuses(
        "motors that are no numbers", {letters}, ErrorCode::InvalidArgument, "source-motor");
    sample.refuses("a number that is too large", {manual}, ErrorCode::FormatCannotHold,
        "there is no number 256",
        FormatSettings{{"counts-per-unit", "1024"}, {"target-motor", "256"}});
}

} // namespace

class TestPowerPmac : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void countsBecomeUnitsByASetting()
    {
        READ_TABLE(table, format, file, counted("1000"));
        QCOMPARE(problemLines(*reading_table), std::string());
        QCOMPARE(table.axes[0].name + table.columns[0].target, std::string("11"));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{-100, -50, 0, 50, 100}));
        QCOMPARE(table.columns[0].values, (std::vector<double>{0, 0.0125, -0.003, 0.004, 0.008}));
        QCOMPARE(table.sign, SignConvention::Feedback);
    }

    void countsThatAreStatedForTheSourceAloneLeaveTheValuesInCounts()
    {
        READ_TABLE(table, format, file,
            test::readingWith({{"source-counts-per-unit", "1000"}, {"position-unit", "mm"}}));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{-100, -50, 0, 50, 100}));
        QCOMPARE(table.axes[0].unit, std::string("mm"));
        QCOMPARE(table.columns[0].values, (std::vector<double>{0, 12.5, -3, 4, 8}));
        QCOMPARE(table.columns[0].unit, std::string("counts"));
        QCOMPARE(problemLines(*reading_table),
            std::string("warning 2:0 UnitNotGiven a table in motor units|the setting "
                        "target-counts-per-unit, where a unit matters\n"));
    }

    void aUnitOfNumbersThatStayInCountsIsRefused()
    {
        const auto refused = format.read(file,
            test::readingWith({{"source-counts-per-unit", "1000"}, {"position-unit", "mm"},
                {"value-unit", "mm"}}));
        VERIFY_RESULT(refused);
        QVERIFY2(test::mentions(problemLines(*refused),
                     "0:0 Contradiction the setting value-unit for numbers in counts|the setting "
                     "target-counts-per-unit, which says how many of them are one unit"),
            problemLines(*refused).c_str());
    }

    void aMotorHasOneUnitForItsOneNumberOfCounts()
    {
        TableReadOptions options = counted("1000");
        options.settings["value-unit"] = "um";
        const auto refused = format.read(file, options);
        VERIFY_RESULT(refused);
        QCOMPARE(problemLines(*refused),
            std::string("0:0 Contradiction positions in mm and values in um|one unit, since the "
                        "controller adds the values to the positions\n"));
    }

    /// Runs are of measurements.
    void aValueThatIsThereTwiceIsNotSaidToBeOfARun()
    {
        const auto reading =
            format.read(with("Sys.", "CompTable[0].Data[4] = 8;\nSys."), counted("1"));
        VERIFY_RESULT(reading);
        QCOMPARE(reading->diagnostics.size(), std::size_t{1});
        QCOMPARE(textOf(reading->diagnostics.front()).english(),
            std::string("the same value is there twice: found value 4 again, expected each value "
                        "once; the last one counts; delete one of the two"));
    }

    void eachTableOfAFileIsRead()
    {
        const auto reading = format.read(
            file + with("// left", "// right") +
                [] {
                    std::string other = file;
                    for (std::size_t at = 0; (at = other.find("CompTable[0]", at)) != other.npos;)
                        other.replace(at, 12, "CompTable[7]");
                    return other;
                }(),
            counted("1"));
        VERIFY_RESULT(reading);
        QCOMPARE(reading->tables.size(), std::size_t{2});
        QCOMPARE(reading->tables[1].name, std::string("CompTable[7]"));
    }
};

AXISCOMP_TEST(TestPowerPmac)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_powerpmac

#include "tst_powerpmac.moc"
