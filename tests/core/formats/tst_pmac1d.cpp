// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_checks.h"
#include "tests/support/test_registry.h"

namespace tst_pmac1d {

using namespace axiscomp;
using test::applied;
using test::problemLines;

namespace {

const TableFamily& family = pmac_1d::format();

const std::string file = "; bowed screw\n"
                         "CLOSE\nDELETE COMP\n"
                         "#1\n"
                         "DEFINE COMP 4,#1D,#2,4000 ; 4 entries\n"
                         "160 -80\n"
                         "32\n"
                         "0 // the last one\n"
                         "I51=1\n";

std::string with(const std::string& from, const std::string& to)
{
    std::string text = file;
    return text.replace(text.find(from), from.size(), to);
}

TableReadOptions inMillimetres(const std::string& counts = "1000")
{
    TableReadOptions options;
    options.settings = {{"counts-per-unit", counts}, {"position-unit", "mm"}, {"value-unit", "mm"}};
    return options;
}

TableWriteOptions thousand()
{
    TableWriteOptions options;
    options.settings["counts-per-unit"] = "1000";
    return options;
}

NeutralTable closedTable()
{
    NeutralTable table;
    table.sign = SignConvention::Command;
    table.axes = {test::evenAxis("3", "mm", 0, 2.5, 25)};
    table.axes[0].wrap = 60;
    table.columns = {test::waveColumn("3", "mm", 25, 0.05)};
    table.columns[0].values.front() = 0;
    table.columns[0].values.back() = 0;
    return table;
}

/// From -20 to 30, 0 at 0, different at both ends.
NeutralTable openTable()
{
    NeutralTable table;
    table.sign = SignConvention::Command;
    table.axes = {test::evenAxis("1", "mm", -20, 5, 11)};
    table.columns = {test::waveColumn("1", "mm", 11, 0.05)};
    table.columns[0].values[4] = 0;
    return table;
}

} // namespace

class TestPmac1d : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void entriesAreSixteenthsOfACountAndTheOneForZeroIsLeftOut()
    {
        READ_TABLE(table, family, file, {});
        QCOMPARE(table.axes[0].name, std::string("1"));
        QCOMPARE(table.axes[0].unit, std::string("counts"));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{0, 1000, 2000, 3000, 4000}));
        QCOMPARE(table.columns[0].target, std::string("2"));
        QCOMPARE(table.columns[0].values, (std::vector<double>{0, 10, -5, 2, 0}));
        QCOMPARE(table.columns[0].step, 1.0 / 16);
        QCOMPARE(table.notes, (std::vector<std::string>{"bowed screw"}));
        QCOMPARE(problemLines(*reading_table),
            std::string("warning 5:0 UnitNotGiven a table in counts|the setting counts-per-unit, "
                        "where a unit matters\n"));
    }

    void countsBecomeUnitsByASetting()
    {
        READ_TABLE(table, family, file, inMillimetres());
        QCOMPARE(table.axes[0].knots, (std::vector<double>{0, 1, 2, 3, 4}));
        QCOMPARE(table.axes[0].unit, std::string("mm"));
        QCOMPARE(table.columns[0].values[1], 0.01);
        QVERIFY2(reading_table->diagnostics.empty(), problemLines(*reading_table).c_str());
        TableReadOptions options = inMillimetres();
        options.settings["target-counts-per-unit"] = "2000";
        READ_TABLE(other, family, file, options);
        QCOMPARE(other.axes[0].knots[1], 1.0);
        QCOMPARE(other.columns[0].values[1], 0.005);
    }

    void itIsLinearBetweenTheEntriesAndRollsOver()
    {
        READ_TABLE(table, family, file, {});
        QCOMPARE(applied(family, table, {500}), 5.0);
        QCOMPARE(applied(family, table, {4500}), 5.0);
        QCOMPARE(applied(family, table, {-1000}), 2.0);
        QCOMPARE(applied(family, table, {-39000}), 10.0);
    }

    void motorsThatAreNotNamedAreTheAddressedOne()
    {
        READ_TABLE(own, family, with("4,#1D,#2,4000", "4,4000"), {});
        QCOMPARE(own.axes[0].name, std::string("1"));
        QCOMPARE(own.columns[0].target, std::string("1"));
        READ_TABLE(source, family, "#7 def comp 2 , #3 , 100\n1 0\n", {});
        QCOMPARE(source.axes[0].name, std::string("3"));
        QCOMPARE(source.columns[0].target, std::string("7"));
        READ_TABLE(none, family, "DEFINE COMP 2,100\n1 0\n", {});
        QCOMPARE(none.axes[0].name, std::string());
        QVERIFY(test::hasProblem(*reading_none, DiagnosticCode::Assumption, 1));
    }

    void aLastEntryOtherThanZeroIsAWarning()
    {
        READ_TABLE(table, family, with("0 // the last", "7 // the last"), inMillimetres());
        QVERIFY(test::hasProblem(*reading_table, DiagnosticCode::NotPeriodic, 5));
        QCOMPARE(table.columns[0].values.back(), 7.0 / 16000);
    }

    void severalTablesOfAFileAreReadAndThoseOfTwoDimensionsLeftOut()
    {
        const auto reading = family.read(
            "DEFINE COMP 2.2,#1,#2,#3,10,10\n1 2 3 4 5 6 7 8\n" + file + file, inMillimetres());
        VERIFY_RESULT(reading);
        QCOMPARE(reading->tables.size(), std::size_t(2));
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::Assumption, 1));
    }

    void whatIsWrittenIsReadBackWithinHalfAStep()
    {
        const auto written = family.write(std::array{closedTable()}, thousand());
        VERIFY_RESULT(written);
        QVERIFY(written->bytes.starts_with("#3\nDEFINE COMP 24,#3D,#3,60000\n"));
        READ_TABLE(again, family, written->bytes, inMillimetres());
        QCOMPARE(again, written->held.front());
        COMPARE_TABLES(again, closedTable(), 0.5 / 16000 + 1e-12);
        QVERIFY(again.columns[0].values != closedTable().columns[0].values);
    }

    void negativePositionsAreWrittenBehindThePositiveOnes()
    {
        const NeutralTable table = openTable();
        const auto written = family.write(std::array{table}, thousand());
        VERIFY_RESULT(written);
        QVERIFY(written->bytes.starts_with("#1\nDEFINE COMP 11,#1D,#1,55000\n"));
        const NeutralTable& held = written->held.front();
        for (double x = -20; x <= 30; x += 1.25)
            QVERIFY(std::abs(applied(family, held, {x}) - applied(family, table, {x}))
                <= 0.5 / 16000 + 1e-9);
        NeutralTable closed = table;
        closed.columns[0].values.back() = closed.columns[0].values.front();
        const auto shorter = family.write(std::array{closed}, thousand());
        VERIFY_RESULT(shorter);
        QVERIFY(shorter->bytes.starts_with("#1\nDEFINE COMP 10,#1D,#1,50000\n"));
    }

    void theFileHasTheFormOfTheManual()
    {
        NeutralTable table = closedTable();
        table.axes[0] = test::evenAxis("1", "mm", 0, 1, 4);
        table.axes[0].wrap = 3;
        table.columns[0].target = "2";
        table.columns[0].unit = "um";
        table.columns[0].values = {0, 1, -2, 0};
        table.notes = {"note"};
        TableWriteOptions options = thousand();
        options.settings["position"] = "actual";
        options.settings["value-unit"] = "mm";
        const auto written = family.write(std::array{table}, options);
        VERIFY_RESULT(written);
        QCOMPARE(written->bytes, std::string("; note\n#2\nDEFINE COMP 3,#1,#2,3000\n16 -32 0\n"));
        QVERIFY(written->remarks.back().find("I51=1") != std::string::npos);
    }

    void whatTheFormatCannotHoldIsRefused_data()
    {
        QTest::addColumn<int>("change");
        QTest::addColumn<QByteArray>("reason");
        QTest::addRow("a value at 0") << 0 << QByteArray("takes it to be 0");
        QTest::addRow("no point at 0") << 1 << QByteArray("is no point of source 1");
        QTest::addRow("0 is not reached") << 2 << QByteArray("does not reach");
        QTest::addRow("too large an entry") << 3 << QByteArray("24 bits");
        QTest::addRow("too long a span") << 4 << QByteArray("counts");
        QTest::addRow("an open period") << 5 << QByteArray("differ by");
        QTest::addRow("no such motor") << 6 << QByteArray("there is no motor 33");
    }
    void whatTheFormatCannotHoldIsRefused()
    {
        QFETCH(int, change);
        QFETCH(QByteArray, reason);
        NeutralTable table = change == 5 ? closedTable() : openTable();
        if (change == 0)
            table.columns[0].values[4] = 0.01;
        if (change == 1)
            for (double& knot : table.axes[0].knots)
                knot += 1;
        if (change == 2)
            for (double& knot : table.axes[0].knots)
                knot += 500;
        if (change == 3)
            table.columns[0].values[2] = 600;
        if (change == 4)
            table.axes[0] = test::evenAxis("1", "mm", -4e6, 1e6, 11);
        if (change == 5)
            table.columns[0].values.back() = 1;
        TableWriteOptions options = thousand();
        if (change == 6)
            options.settings["source-motor"] = "33";
        const auto refused = family.write(std::array{table}, options);
        VERIFY_ERROR(refused, ErrorCode::FormatCannotHold);
        const std::string text = test::describe(refused.error());
        QVERIFY2(text.find(reason.toStdString()) != std::string::npos, text.c_str());
    }

    void countsPerUnitAreNeededAndAboveZero()
    {
        VERIFY_ERROR(family.write(std::array{closedTable()}, {}), ErrorCode::InvalidArgument);
        TableWriteOptions options = thousand();
        options.settings["target-counts-per-unit"] = "0";
        VERIFY_ERROR(family.write(std::array{closedTable()}, options), ErrorCode::InvalidArgument);
        VERIFY_ERROR(family.read(file, inMillimetres("-5")), ErrorCode::InvalidArgument);
    }

    void motorsThatAreNoNumbersNeedASetting()
    {
        NeutralTable table = closedTable();
        table.axes[0].name = "X";
        table.columns[0].target = "X";
        const auto refused = family.write(std::array{table}, thousand());
        VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
        QVERIFY(test::describe(refused.error()).find("source-motor") != std::string::npos);
        TableWriteOptions options = thousand();
        options.settings["source-motor"] = "4";
        const auto written = family.write(std::array{table}, options);
        VERIFY_RESULT(written);
        QCOMPARE(written->held.front().columns[0].target, std::string("4"));
    }

    void aProblemNamesItsPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("problem"); // the beginning of the first one
        const auto row = [](const char* name, const std::string& text, const char* problem) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(problem);
        };
        row("empty", "", "0:0 EmptyFile");
        row("binary", std::string("DEFINE\0COMP", 11), "1:0 NotText");
        row("no table", "CLOSE\n", "0:0 Syntax |DEFINE COMP for a table of one dimension");
        row("truncated", file.substr(0, file.find("32")),
            "5:0 MissingPoint 2 entries|4, as DEFINE");
        row("too many", with("32\n", "32 33 34\n"),
            "7:0 Contradiction 5 entries|4, as DEFINE COMP");
        row("further ones", with("I51=1", "5"),
            "9:1 Contradiction further entries: 5|4, as DEFINE");
        row("entries alone", "1 2 3\n", "1:1 Contradiction further entries: 1 2 3|DEFINE COMP in");
        row("absurd", with("COMP 4,", "COMP 1000000000,"),
            "5:13 LimitExceeded 1000000000 entries|1 to 1000000");
        row("no size", with("COMP 4,", "COMP ,"), "5:13 NotANumber |a number of entries");
        row("no entries", with("COMP 4,", "COMP 0,"), "5:13 LimitExceeded 0 entries");
        row("no span", with("#2,4000", "#2"),
            "5:1 Syntax DEFINE COMP 4,#1D,#2|DEFINE COMP entries");
        row("span 0", with("#2,4000", "#2,0"), "5:22 LimitExceeded a span of 0|at least 1 count");
        row("span not whole", with("#2,4000", "#2,4000.5"),
            "5:22 NotANumber 4000.5|a span in counts");
        row("three motors", with("#2,4000", "#2,#3,4000"), "5:1 Syntax DEFINE COMP");
        row("motor 33", with("#2,4000", "#33,4000"), "5:19 Syntax #33|the number of a motor");
        row("a decimal", with("-80", "-80.5"), "6:5 NotANumber -80.5|a whole number of 1/16 count");
        row("not a number", with("-80", "-8O"), "6:5 NotANumber -8O|");
    }
    void aProblemNamesItsPlace()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, problem);
        const auto reading = family.read(text.toStdString(), inMillimetres());
        VERIFY_RESULT(reading);
        QVERIFY(reading->tables.empty());
        const std::string found = problemLines(*reading);
        QVERIFY2(found.starts_with(problem.toStdString()), found.c_str());
    }

    void numbersThatNoDoubleHoldsAreRefused()
    {
        const auto reading = family.read(file, inMillimetres("1e-310"));
        VERIFY_RESULT(reading);
        QVERIFY(reading->tables.empty());
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::LimitExceeded, 5));
    }

    void otherCommandsAreAWarning()
    {
        READ_TABLE(table, family, "M145=1\nDEFINE BLCOMP 2,100\n1 2\n" + file, inMillimetres());
        QCOMPARE(table.axes[0].knots.size(), std::size_t(5));
        QVERIFY(test::hasProblem(*reading_table, DiagnosticCode::UnknownKey, 1));
        QVERIFY(test::hasProblem(*reading_table, DiagnosticCode::UnknownKey, 2));
    }

    void aFileIsRecognisedByItsDefinition()
    {
        QCOMPARE(family.recognise(file), Recognition::Certain);
        QCOMPARE(family.recognise("DEFINE COMP 4.4,#1,#2,#3,10,10\n"), Recognition::No);
        QCOMPARE(family.recognise("#define COMP 1\nint main()\n"), Recognition::No);
        QCOMPARE(family.recognise("1 2\n0 1\n1 1\n"), Recognition::No);
    }

    void twoMegabytesAreReadWhole()
    {
        std::string text = "#1 DEFINE COMP 400000,400000000\n";
        for (int i = 1; i <= 400000; ++i)
            text += i % 10 == 0 ? "1234\n" : "-567 ";
        QVERIFY(text.size() > 2'000'000);
        READ_TABLE(table, family, text, inMillimetres());
        QCOMPARE(table.pointCount(), std::size_t(400001));
    }
};

AXISCOMP_TEST(TestPmac1d)

} // namespace tst_pmac1d

#include "tst_pmac1d.moc"
