// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_aerotech1d {

using namespace axiscomp;
using test::changed;
using test::problemLines;

namespace {

const TableFormat& format = aerotech_1d::format();

const std::string file = "; stage 12\n"
                         ":START 1 SAMPLEDIST=5 POSUNIT=METRIC CORUNIT=METRIC/1000\n"
                         ":START OFFSET=10 ' where it begins\n"
                         "1 2\n"
                         "  -4 ; middle\n"
                         ":END\n";

const auto with = test::changing(file);

NeutralTable ownTable(const std::string& axis, std::size_t count = 25)
{
    return test::commandTable({test::evenAxis(axis, "mm", -20.5, 0.3, count)},
        {test::waveColumn(axis, "mm", count, 0.01)});
}

void describe(test::FormatSample& sample)
{
    sample.facts = "command is published; 1 to 1 dimensions, even knots; "
                   "points any, columns 1, tables any, bytes 67108864; holds units notes";
    sample.text = file;
    sample.comment = "; ";
    sample.spareBytes = 1;
    sample.applies({{{-7.5}, 0.0015}, {{-100}, 0.001}, {{100}, -0.004}});
    sample.recognises(Recognition::Certain, {file});
    sample.recognises(Recognition::No, {":START2D 1 2 1 2 5 5 3\n", ":START\n", "1 2 3\n" + file});
    // As vendors' tools write it.
    const std::string banner = "***************************\r\n"
                               "  Aerotech Metrologie, Pr\xFC"
                               "fstand 3\r\n"
                               "***************************\r\n"
        + file;
    sample.recognises(Recognition::Certain, {banner});
    sample.applies({{{-7.5}, 0.0015}}, banner);
    const std::string homed =
        with("OFFSET=10", "OFFSET=10 HOMEOFFSET=2 HOMEDIRECTION=0 COLOUR=RED SERIALNUMBER=7");
    sample.applies({{{-7.5}, 0.0015}}, homed);
    sample.warning("home offset and unknown options", homed,
        {"3:47 UnknownKey COLOUR|", "3:18 Assumption HOMEOFFSET 2|"});

    sample.warning("two tables of one axis, which the controller adds", file + file,
        {"0:0 Assumption several tables of 1"});
    sample.warning("values in counts", with("CORUNIT=METRIC", "CORUNIT=COUNTS"),
        {"2:38 UnitNotGiven CORUNIT COUNTS/1000|the setting counts-per-unit, where a unit "
         "matters"});
    sample.warning("tables of two axes", file + with(":START 1 ", ":START 2 "), {});

    // Commas that can only separate: of numbers with points, of three numbers, before a blank.
    sample.warning("commas between numbers with points", with("1 2\n", "0.5,1.5\n"), {});
    sample.warning("commas between whole numbers", with("1 2\n", "1,2,3\n5,6\n"), {});
    sample.warning("commas and blanks", with("1 2\n", "1, 2,\n"), {});
    sample.warning(
        "commas between options", with("SAMPLEDIST=5 POSUNIT", "SAMPLEDIST=5,POSUNIT"), {});

    const NeutralTable noted =
        changed(ownTable("2", 11), [](NeutralTable& table) { table.notes = {"warm machine"}; });
    const NeutralTable rotary = test::commandTable(
        {test::evenAxis("4", "deg", -20.5, 0.3, 2)}, {test::waveColumn("4", "deg", 2, 0.01)});
    sample.writes("one table", {ownTable("1")}).within(0, 1e-12);
    sample.writes("several tables", {ownTable("1"), noted, rotary})
        .within(0, 1e-12)
        .readWith({{"rotary-axes", "4"}});
    sample
        .writes("the form of the manual",
            {test::commandTable({test::evenAxis("3", "mm", -0.5, 2.5, 2)},
                {test::columnOf("3", "um", {0.01, -2})})})
        .as(":START 3 SAMPLEDIST=2.5 POSUNIT=METRIC CORUNIT=METRIC\n"
            ":START OFFSET=0.5\n0.00001 -0.002\n:END\n")
        .becoming(test::commandTable({test::evenAxis("3", "mm", -0.5, 2.5, 2)},
            {test::columnOf("3", "mm", {0.00001, -0.002})}));
    // The column was in mm: one is added to the other, so that both have the unit of the positions.
    const SourceAxis axis = test::evenAxis("1", "um", -20.5, 0.3, 3);
    sample
        .writes(
            "primary units", {test::commandTable({axis}, {test::waveColumn("1", "mm", 3, 0.01)})})
        .with({{"units", "primary"}})
        .readWith({{"primary-unit", "um"}})
        .containing({"POSUNIT=PRIMARY CORUNIT=PRIMARY"})
        .becoming(test::commandTable({axis}, {test::waveColumn("1", "um", 3, 10)}))
        .within(1e-10);
    sample.writes("what the controller adds", {ownTable("1"), ownTable("1")}).within(0, 1e-12);
    sample.writes("an axis that is no number", {ownTable("X")})
        .with({{"axis", "2"}})
        .becoming(ownTable("2"))
        .within(0, 1e-12);
    sample.refuses("an axis that is no number", {ownTable("X")}, ErrorCode::InvalidArgument,
        "the setting axis");
    sample.refuses("another axis",
        {changed(ownTable("1"), [](NeutralTable& table) { table.columns[0].target = "2"; })},
        ErrorCode::FormatCannotHold);

    sample.reading.settings["primary-unit"] = "mm";
    const auto row = sample.problemRow();
    row("comments only", "; nothing\n", "0:0 Syntax |a table that begins with :START");
    row("truncated", file.substr(0, file.find(":END")),
        "0:0 Syntax |:END of the table that begins in line 2");
    row("no end before the next", file.substr(0, file.find(":END")) + file,
        "7:1 Syntax :START 1 SAMPLEDIST=5 POSUNIT=METRIC COR…|:END of the table that begins "
        "in line 2");
    row("no start", "1 2 3\n", "1:1 Syntax 1 2 3|a table that begins with :START");
    row("end alone", ":END\n" + file, "1:1 Syntax :END|:START before :END");
    row("two dimensions", ":START2D 1 2 1 2 5 5 3\n",
        "1:1 Syntax :START2D|:START or :END; tables of one and of two dimensions");
    row("no axis", with(":START 1 ", ":START "), "2:1 Syntax :START SAMPLEDIST");
    row("axis 0", with(":START 1 ", ":START 0 "), "2:8 Syntax 0|the number of one axis");
    row("two axes", with(":START 1 ", ":START 1 2 "), "2:8 Syntax 1|the number of one axis");
    row("no distance", with("SAMPLEDIST=5 ", ""), "2:0 Syntax |SAMPLEDIST= and the distance");
    row("distance 0", with("SAMPLEDIST=5", "SAMPLEDIST=0"), "2:0 Syntax |SAMPLEDIST=");
    row("distance that is none", with("SAMPLEDIST=5", "SAMPLEDIST=five"),
        "2:21 NotANumber five|the number of SAMPLEDIST");
    row("no value", with("SAMPLEDIST=5", "SAMPLEDIST"), "2:10 Syntax SAMPLEDIST|SAMPLEDIST= and");
    row("key without a name", with("OFFSET=10", "= 10"), "3:8 Syntax = 10|KEY=VALUE");
    row("nothing behind =", with("OFFSET=10 ' where it begins", "OFFSET="),
        "3:8 Syntax OFFSET=|KEY=VALUE");
    row("unit", with("POSUNIT=METRIC", "POSUNIT=FURLONG"), "2:23 Syntax FURLONG|POSUNIT=METRIC");
    row("divided by 0", with("METRIC/1000", "METRIC/0"), "2:38 Syntax METRIC/0|CORUNIT=METRIC");
    row("two units of which a setting says one",
        with("METRIC CORUNIT=METRIC", "PRIMARY CORUNIT=SECONDARY"),
        "2:39 UnitNotGiven two kinds of units in one table|the settings primary-unit and "
        "secondary-unit");
    sample.problem("values without a unit at positions in counts",
        with("METRIC CORUNIT=METRIC", "COUNTS CORUNIT=PRIMARY"),
        "2:38 UnitNotGiven two kinds of units in one table|the settings counts-per-unit and "
        "primary-unit",
        {}, FormatSettings{});
    sample.problem("inches of a rotary axis",
        with("METRIC CORUNIT=METRIC", "METRIC CORUNIT=ENGLISH"),
        "2:38 Contradiction CORUNIT ENGLISH of the rotary axis 1|METRIC, which is degrees there",
        {}, FormatSettings{{"rotary-axes", "1"}});
    sample.refusesReading("no counts", {{"counts-per-unit", "0"}}, "expected a number above 0");
    sample.refusesReading(
        "counts that are no number", {{"counts-per-unit", "x"}}, "expected a number such as 0.5");
    row("twice", with("OFFSET=10", "OFFSET=10 OFFSET=11"),
        "3:18 Contradiction OFFSET a second time|each option once");
    row("a value that is none", with("-4", "-4x"), "5:3 NotANumber -4x|a correction");
    row("decimal commas", with("1 2\n  -4", "0,5 1,5\n  -4,5"),
        "4:1 NotANumber 0,5|decimal points, and blanks between the numbers");
    row("a distance with a decimal comma", with("SAMPLEDIST=5", "SAMPLEDIST=10,5"),
        "2:21 NotANumber 10,5|a number with a decimal point");
    row("NEGCOR with a value", with("OFFSET=10", "OFFSET=10 NEGCOR=0"),
        "3:25 Syntax 0|NEGCOR without a value, or no NEGCOR");
    row("one value", ":START 1 SAMPLEDIST=5\n7\n:END\n", "1:0 TooFewPoints 1 correction|");
    row("values beyond a double", with("METRIC/1000", "METRIC/1e-310"),
        "2:0 LimitExceeded a correction that is too large");
    row("positions beyond a double", with("SAMPLEDIST=5", "SAMPLEDIST=1e308"),
        "2:0 NotMonotonic inf after 1e+308|");
    row("positions that are the same", with("OFFSET=10", "OFFSET=1e300"),
        "2:0 NotMonotonic -1e+300 after -1e+300|strictly increasing");
}

} // namespace

class TestAerotech1d : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void positionKIsDistanceTimesKLessTheOffset()
    {
        READ_TABLE(table, format, file, {});
        QCOMPARE(table.axes[0].name, std::string("1"));
        QCOMPARE(table.axes[0].unit, std::string("mm"));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{-10, -5, 0}));
        QCOMPARE(table.columns[0].target, std::string("1"));
        QCOMPARE(table.notes, (std::vector<std::string>{"stage 12"}));
        QCOMPARE(table.sign, SignConvention::Command);
        QVERIFY2(reading_table->diagnostics.empty(), problemLines(*reading_table).c_str());
    }

    void aUnitMayBeDividedByANumber()
    {
        READ_TABLE(table, format, file, {});
        QCOMPARE(table.columns[0].unit, std::string("mm"));
        QCOMPARE(table.columns[0].values, (std::vector<double>{0.001, 0.002, -0.004}));
        READ_TABLE(positions, format, with("POSUNIT=METRIC", "posunit = METRIC/10"), {});
        QCOMPARE(positions.axes[0].knots, (std::vector<double>{-1, -0.5, 0}));
    }

    void aNegativeDistanceCountsDownwards()
    {
        READ_TABLE(table, format, with("SAMPLEDIST=5", "SAMPLEDIST=-5"), {});
        QCOMPARE(table.axes[0].knots, (std::vector<double>{-20, -15, -10}));
        QCOMPARE(table.columns[0].values, (std::vector<double>{-0.004, 0.002, 0.001}));
    }

    void negcorTurnsTheSign()
    {
        READ_TABLE(table, format, with("OFFSET=10", "OFFSET = 10 NEGCOR"), {});
        QCOMPARE(table.columns[0].values, (std::vector<double>{-0.001, -0.002, 0.004}));
    }

    void unitsAreThoseOfTheFileOrOfASetting()
    {
        READ_TABLE(english, format, with("POSUNIT=METRIC", "POSUNIT=ENGLISH"), {});
        QCOMPARE(english.axes[0].unit, std::string("inch"));
        TableReadOptions options;
        options.settings["rotary-axes"] = "4, 1";
        READ_TABLE(rotary, format, file, options);
        QCOMPARE(rotary.axes[0].unit, std::string("deg"));
        QCOMPARE(rotary.columns[0].unit, std::string("deg"));
        const std::string primary = with("METRIC CORUNIT=METRIC/1000", "PRIMARY CORUNIT=COUNTS");
        READ_TABLE(unknown, format, primary, {});
        QCOMPARE(unknown.axes[0].unit, std::string());
        QCOMPARE(unknown.columns[0].unit, std::string("counts"));
        QVERIFY(test::hasProblem(*reading_unknown, DiagnosticCode::UnitNotGiven, 2));
        options.settings["primary-unit"] = "um";
        READ_TABLE(counted, format, primary, options);
        QCOMPARE(counted.columns[0].unit, std::string("counts"));
        options.settings["counts-per-unit"] = "2";
        READ_TABLE(known, format, primary, options);
        QCOMPARE(known.axes[0].unit, std::string("um"));
        QCOMPARE(known.columns[0].unit, std::string("um"));
        QVERIFY(known.columns[0].values[2] == -2 && reading_known->diagnostics.empty());
        options.settings["secondary-unit"] = "inch";
        READ_TABLE(both, format,
            with("METRIC CORUNIT=METRIC/1000", "PRIMARY CORUNIT=SECONDARY/1000"), options);
        QCOMPARE(both.axes[0].unit, std::string("um"));
        QCOMPARE(both.columns[0].unit, std::string("inch"));
        READ_TABLE(silent, format, with(" POSUNIT=METRIC", ""), {});
        QCOMPARE(silent.axes[0].unit, std::string());
        QVERIFY(test::hasProblem(*reading_silent, DiagnosticCode::UnitNotGiven, 2));
    }
};

AXISCOMP_TEST(TestAerotech1d)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_aerotech1d

#include "tst_aerotech1d.moc"
