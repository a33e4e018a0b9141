// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_checks.h"
#include "tests/support/test_registry.h"

namespace tst_aerotech1d {

using namespace axiscomp;
using test::applied;
using test::problemLines;

namespace {

const TableFamily& family = aerotech_1d::format();

const std::string file = "; stage 12\n"
                         ":START 1 SAMPLEDIST=5 POSUNIT=METRIC CORUNIT=METRIC/1000\n"
                         ":START OFFSET=10 ' where it begins\n"
                         "1 2\n"
                         "  -4 ; middle\n"
                         ":END\n";

std::string with(const std::string& from, const std::string& to)
{
    std::string text = file;
    return text.replace(text.find(from), from.size(), to);
}

NeutralTable ownTable(const std::string& axis, std::size_t count = 25)
{
    NeutralTable table;
    table.sign = SignConvention::Command;
    table.axes = {test::evenAxis(axis, "mm", -20.5, 0.3, count)};
    table.columns = {test::waveColumn(axis, "mm", count, 0.01)};
    return table;
}

} // namespace

class TestAerotech1d : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void positionKIsDistanceTimesKLessTheOffset()
    {
        READ_TABLE(table, family, file, {});
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
        READ_TABLE(table, family, file, {});
        QCOMPARE(table.columns[0].unit, std::string("mm"));
        QCOMPARE(table.columns[0].values, (std::vector<double>{0.001, 0.002, -0.004}));
        READ_TABLE(positions, family, with("POSUNIT=METRIC", "posunit = METRIC/10"), {});
        QCOMPARE(positions.axes[0].knots, (std::vector<double>{-1, -0.5, 0}));
    }

    void aNegativeDistanceCountsDownwards()
    {
        READ_TABLE(table, family, with("SAMPLEDIST=5", "SAMPLEDIST=-5"), {});
        QCOMPARE(table.axes[0].knots, (std::vector<double>{-20, -15, -10}));
        QCOMPARE(table.columns[0].values, (std::vector<double>{-0.004, 0.002, 0.001}));
    }

    void negcorTurnsTheSign()
    {
        READ_TABLE(table, family, with("OFFSET=10", "OFFSET = 10 NEGCOR"), {});
        QCOMPARE(table.columns[0].values, (std::vector<double>{-0.001, -0.002, 0.004}));
    }

    void itIsLinearBetweenThePointsAndHeldOutside()
    {
        READ_TABLE(table, family, file, {});
        QCOMPARE(applied(family, table, {-7.5}), 0.0015);
        QCOMPARE(applied(family, table, {-100}), 0.001);
        QCOMPARE(applied(family, table, {100}), -0.004);
    }

    void unitsAreThoseOfTheFileOrOfASetting()
    {
        READ_TABLE(english, family, with("POSUNIT=METRIC", "POSUNIT=ENGLISH"), {});
        QCOMPARE(english.axes[0].unit, std::string("inch"));
        TableReadOptions options;
        options.settings["rotary-axes"] = "4, 1";
        READ_TABLE(rotary, family, file, options);
        QCOMPARE(rotary.axes[0].unit, std::string("deg"));
        QCOMPARE(rotary.columns[0].unit, std::string("deg"));
        const std::string primary = with("METRIC CORUNIT=METRIC/1000", "PRIMARY CORUNIT=COUNTS");
        READ_TABLE(unknown, family, primary, {});
        QCOMPARE(unknown.axes[0].unit, std::string());
        QVERIFY(test::hasProblem(*reading_unknown, DiagnosticCode::UnitNotGiven, 2));
        options.settings["primary-unit"] = "um";
        READ_TABLE(known, family, primary, options);
        QCOMPARE(known.columns[0].unit, std::string("um"));
        QVERIFY(known.columns[0].values[2] == -4 && reading_known->diagnostics.empty());
        READ_TABLE(silent, family, with(" POSUNIT=METRIC", ""), {});
        QCOMPARE(silent.axes[0].unit, std::string());
        QVERIFY(test::hasProblem(*reading_silent, DiagnosticCode::UnitNotGiven, 2));
    }

    void unknownOptionsAndHomeOffsetsAreWarnings()
    {
        READ_TABLE(table, family,
            with("OFFSET=10", "OFFSET=10 HOMEOFFSET=2 HOMEDIRECTION=0 COLOUR=RED SERIALNUMBER=7"),
            {});
        QCOMPARE(table.axes[0].knots[0], -10.0);
        QVERIFY(test::hasProblem(*reading_table, DiagnosticCode::Assumption, 3));
        QVERIFY(test::hasProblem(*reading_table, DiagnosticCode::UnknownKey, 3));
        QCOMPARE(reading_table->diagnostics.size(), std::size_t(2));
    }

    void severalTablesAreWrittenAndReadBackTheSame()
    {
        NeutralTable rotary = ownTable("4", 2);
        rotary.axes[0].unit = "deg";
        rotary.columns[0].unit = "deg";
        NeutralTable noted = ownTable("2", 11);
        noted.notes = {"warm machine"};
        const std::array tables{ownTable("1"), noted, rotary};
        const auto written = family.write(tables, {});
        VERIFY_RESULT(written);
        TableReadOptions options;
        options.settings["rotary-axes"] = "4";
        const auto again = family.read(written->bytes, options);
        VERIFY_RESULT(again);
        QCOMPARE(again->tables.size(), tables.size());
        QCOMPARE(again->tables, written->held);
        for (std::size_t i = 0; i < tables.size(); ++i) {
            COMPARE_TABLES(again->tables[i], tables[i], 1e-12);
            QCOMPARE(again->tables[i].columns[0].values, tables[i].columns[0].values);
            QCOMPARE(again->tables[i].notes, tables[i].notes);
        }
    }

    void theFileHasTheFormOfTheManual()
    {
        NeutralTable table = ownTable("3", 2);
        table.axes[0].knots = {-0.5, 2};
        table.columns[0].unit = "um";
        table.columns[0].values = {0.01, -2};
        const auto written = family.write(std::array{table}, {});
        VERIFY_RESULT(written);
        QCOMPARE(written->bytes,
            std::string(":START 3 SAMPLEDIST=2.5 POSUNIT=METRIC CORUNIT=METRIC\n"
                        ":START OFFSET=0.5\n0.00001 -0.002\n:END\n"));
    }

    void primaryUnitsKeepTheNumbers()
    {
        NeutralTable table = ownTable("1", 3);
        table.axes[0].unit = "um";
        TableWriteOptions options;
        options.settings["units"] = "primary";
        const auto written = family.write(std::array{table}, options);
        VERIFY_RESULT(written);
        QVERIFY(written->bytes.find("POSUNIT=PRIMARY CORUNIT=PRIMARY") != std::string::npos);
        const NeutralTable& held = written->held.front();
        QCOMPARE(held.axes[0].unit, std::string("um"));
        QCOMPARE(held.columns[0].unit, std::string("um")); // one is added to the other
        QVERIFY(std::abs(held.columns[0].values[1] - 1000 * table.columns[0].values[1]) < 1e-9);
    }

    void anAxisThatIsNoNumberNeedsTheSetting()
    {
        const auto refused = family.write(std::array{ownTable("X")}, {});
        VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
        QVERIFY(test::describe(refused.error()).find("the setting axis") != std::string::npos);
        TableWriteOptions options;
        options.settings["axis"] = "2";
        const auto written = family.write(std::array{ownTable("X")}, options);
        VERIFY_RESULT(written);
        QCOMPARE(written->held.front().axes[0].name, std::string("2"));
        const std::array both{ownTable("1"), ownTable("1")};
        VERIFY_ERROR(family.write(both, {}), ErrorCode::FormatCannotHold);
    }

    void aTableForAnotherAxisIsRefused()
    {
        NeutralTable cross = ownTable("1");
        cross.columns[0].target = "2";
        VERIFY_ERROR(family.write(std::array{cross}, {}), ErrorCode::FormatCannotHold);
        NeutralTable modulo = ownTable("1");
        modulo.axes[0].wrap = 100;
        VERIFY_ERROR(checkHolds(family.facts, std::array{modulo}), ErrorCode::FormatCannotHold);
    }

    void aProblemNamesItsPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("problem"); // the beginning of the first one
        const auto row = [](const char* name, const std::string& text, const char* problem) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(problem);
        };
        row("empty", "", "0:0 EmptyFile");
        row("binary", std::string(":START 1\0", 9), "1:0 NotText");
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
        row("no value", with("SAMPLEDIST=5", "SAMPLEDIST"),
            "2:10 Syntax SAMPLEDIST|SAMPLEDIST= and");
        row("key without a name", with("OFFSET=10", "= 10"), "3:8 Syntax = 10|KEY=VALUE");
        row("nothing behind =", with("OFFSET=10 ' where it begins", "OFFSET="),
            "3:8 Syntax OFFSET=|KEY=VALUE");
        row("unit", with("POSUNIT=METRIC", "POSUNIT=FURLONG"),
            "2:23 Syntax FURLONG|POSUNIT=METRIC");
        row("divided by 0", with("METRIC/1000", "METRIC/0"), "2:38 Syntax METRIC/0|CORUNIT=METRIC");
        row("twice", with("OFFSET=10", "OFFSET=10 OFFSET=11"),
            "3:18 Contradiction OFFSET a second time|each option once");
        row("a value that is none", with("-4", "-4x"), "5:3 NotANumber -4x|a correction");
        row("one value", ":START 1 SAMPLEDIST=5\n7\n:END\n", "1:0 TooFewPoints 1 corrections|");
        row("values beyond a double", with("METRIC/1000", "METRIC/1e-310"),
            "2:0 LimitExceeded a correction that is too large");
        row("positions beyond a double", with("SAMPLEDIST=5", "SAMPLEDIST=1e308"),
            "2:0 NotMonotonic inf after 1e+308|");
        row("positions that are the same", with("OFFSET=10", "OFFSET=1e300"),
            "2:0 NotMonotonic -1e+300 after -1e+300|strictly increasing");
    }
    void aProblemNamesItsPlace()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, problem);
        TableReadOptions options;
        options.settings["primary-unit"] = "mm";
        const auto reading = family.read(text.toStdString(), options);
        VERIFY_RESULT(reading);
        QVERIFY(reading->tables.empty());
        const std::string found = problemLines(*reading);
        QVERIFY2(found.starts_with(problem.toStdString()), found.c_str());
    }

    void aFileIsRecognisedByItsFirstDirective()
    {
        QCOMPARE(family.recognise(file), Recognition::Certain);
        QCOMPARE(family.recognise(":START2D 1 2 1 2 5 5 3\n"), Recognition::No);
        QCOMPARE(family.recognise(":START\n"), Recognition::No);
        QCOMPARE(family.recognise("1 2 3\n" + file), Recognition::No);
        QCOMPARE(family.recognise(""), Recognition::No);
    }

    void twoMegabytesAreReadWhole()
    {
        std::string text = ":START 1 SAMPLEDIST=0.1 POSUNIT=METRIC CORUNIT=METRIC\n";
        for (int i = 0; i < 260000; ++i)
            text += i % 10 == 9 ? "0.00123\n" : "-0.0012 ";
        QVERIFY(text.size() > 2'000'000);
        READ_TABLE(table, family, text + ":END\n", {});
        QCOMPARE(table.pointCount(), std::size_t(260000));
    }
};

AXISCOMP_TEST(TestAerotech1d)

} // namespace tst_aerotech1d

#include "tst_aerotech1d.moc"
