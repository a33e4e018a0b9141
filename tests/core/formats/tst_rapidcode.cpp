// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_checks.h"
#include "tests/data/formats/rapidcode_compensator.h"
#include "tests/support/test_registry.h"

#include <QFile>

namespace tst_rapidcode {

using namespace axiscomp;
using test::applied;
using test::problemLines;

namespace {

const TableFamily& family = rapidcode::format();
const TableFamily& headerFamily = rapidcode_header::format();

bool mentions(const std::string& text, std::string_view part)
{
    return text.find(part) != std::string::npos;
}

std::string joined(const std::vector<std::string>& lines)
{
    std::string text;
    for (const std::string& line : lines)
        text += line + '\n';
    return text;
}

/// The example of the documentation: 5 x 21 points.
NeutralTable twoAxes()
{
    NeutralTable table;
    table.name = "flatness";
    table.sign = SignConvention::Command;
    table.notes = {"measured with a probe"};
    table.axes = {
        test::evenAxis("X", "mm", 0, 50000, 5), test::evenAxis("Y", "mm", 25000, 10000, 21)};
    table.columns = {test::waveColumn("Z", "mm", 105, 0.5)};
    return table;
}

TableWriteOptions counts(std::string perUnit)
{
    TableWriteOptions options;
    options.settings = {{"counts-per-unit", std::move(perUnit)}};
    return options;
}

std::string oneAxisText(const std::string& grid, const std::string& rows)
{
    return "# RapidCode compensator table\n" + grid
        + "# input.1.unit = mm\n# output.unit = mm\n# output.counts-per-unit = 1000\n" + rows;
}

const std::string grid = "# input.1.min = 10\n# input.1.max = 40\n# input.1.delta = 10\n";

} // namespace

class TestRapidcode : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theFiveByTwentyOnePointsOfTheExampleHaveTheFirstAxisFastest()
    {
        NeutralTable table = twoAxes();
        for (std::size_t i = 0; i < 105; ++i)
            table.columns[0].values[i] = static_cast<double>(i) / 1000.0;
        const auto written = family.write(std::array{table}, counts("1000"));
        VERIFY_RESULT(written);
        const std::string& text = written->bytes;
        QVERIFY2(mentions(text,
                     "# input.1.min = 0\n# input.1.max = 200000\n"
                     "# input.1.delta = 50000\n"),
            text.c_str());
        QVERIFY2(mentions(text,
                     "# input.2.min = 25000\n# input.2.max = 225000\n"
                     "# input.2.delta = 10000\n"),
            text.c_str());
        QVERIFY2(mentions(text, "\n0,1,2,3,4\n5,6,7,8,9\n"), text.c_str());
        QVERIFY2(text.ends_with("\n100,101,102,103,104\n"), text.c_str());
        READ_TABLE(again, family, text, {});
        QCOMPARE(again.pointCount(), std::size_t(105));
        QCOMPARE(applied(family, again, {50000, 35000}), 0.006);
    }

    void theRangeIsAnIntegerMultipleOfTheDelta()
    {
        const auto reading = family.read(
            oneAxisText("# input.1.min = 0\n# input.1.max = 10\n# input.1.delta = 3\n", "1,2,3\n"),
            {});
        VERIFY_RESULT(reading);
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::Contradiction, 4));
        READ_TABLE(decimal, family,
            oneAxisText(
                "# input.1.min = 0.1\n# input.1.max = 0.4\n# input.1.delta = 0.1\n", "1,2,3,4\n"),
            {});
        QCOMPARE(decimal.axes[0].knots.back(), 0.4);
    }

    void valuesAreRawCountsOfTheOutputAxis()
    {
        READ_TABLE(table, family, oneAxisText(grid, "0,2,-3,2500\n"), {});
        QCOMPARE(table.columns[0].values, (std::vector<double>{0, 0.002, -0.003, 2.5}));
        QCOMPARE(table.columns[0].unit, std::string("mm"));
        QCOMPARE(table.columns[0].step, 0.001);
        QVERIFY(table.sign == SignConvention::Command);
    }

    void countsWithDecimalsAreRead()
    {
        READ_TABLE(table, family, oneAxisText(grid, "0,2.5,-3,0\n"), {});
        QCOMPARE(table.columns[0].values[1], 0.0025);
        QCOMPARE(table.columns[0].step, 0.0);
    }

    void countsPerUnitMayBeNegative()
    {
        NeutralTable table = twoAxes();
        const auto written = family.write(std::array{table}, counts("-2000"));
        VERIFY_RESULT(written);
        READ_TABLE(again, family, written->bytes, {});
        COMPARE_TABLES(again, table, 0.5 / 2000);
    }

    void countsPerUnitComeFromTheSettingWhereTheFileIsSilent()
    {
        const std::string text = "# RapidCode compensator table\n" + grid + "0,2,-3,0\n";
        const auto silent = family.read(text, {});
        VERIFY_RESULT(silent);
        QVERIFY(silent->tables.empty());
        QVERIFY(test::hasProblem(*silent, DiagnosticCode::UnitNotGiven, 0));
        TableReadOptions options;
        options.settings = {
            {"counts-per-unit", "2000"}, {"position-unit", "mm"}, {"value-unit", "um"}};
        READ_TABLE(table, family, text, options);
        QCOMPARE(table.columns[0].values[1], 0.001);
        QCOMPARE(table.columns[0].unit, std::string("um"));
        QCOMPARE(table.axes[0].unit, std::string("mm"));
    }

    void settingsThatContradictTheFileAreRefused_data()
    {
        QTest::addColumn<QByteArray>("key");
        QTest::addColumn<QByteArray>("value");
        QTest::addColumn<int>("line");
        QTest::newRow("counts") << QByteArray("counts-per-unit") << QByteArray("999") << 7;
        QTest::newRow("position unit") << QByteArray("position-unit") << QByteArray("um") << 5;
        QTest::newRow("value unit") << QByteArray("value-unit") << QByteArray("um") << 6;
    }
    void settingsThatContradictTheFileAreRefused()
    {
        QFETCH(QByteArray, key);
        QFETCH(QByteArray, value);
        QFETCH(int, line);
        TableReadOptions options;
        options.settings = {{key.toStdString(), value.toStdString()}};
        const auto reading = family.read(oneAxisText(grid, "0,2,-3,0\n"), options);
        VERIFY_RESULT(reading);
        QVERIFY(reading->tables.empty());
        QVERIFY(test::hasProblem(
            *reading, DiagnosticCode::Contradiction, static_cast<std::size_t>(line)));
    }

    void outsideOfTheRangeThereIsNoCorrection()
    {
        READ_TABLE(table, family, oneAxisText(grid, "5,5,5,5\n"), {});
        QCOMPARE(applied(family, table, {10.0}), 0.005);
        QCOMPARE(applied(family, table, {9.999}), 0.0);
        QCOMPARE(applied(family, table, {40.0}), 0.005);
        QCOMPARE(applied(family, table, {40.001}), 0.0);
    }

    void betweenThePointsTheValueIsLinear()
    {
        READ_TABLE(table, family, oneAxisText(grid, "0,10,0,0\n"), {});
        QCOMPARE(applied(family, table, {12.5}), 0.0025);
    }

    void theInputMustBeTheCommandPositionWhenItIsTheOutput()
    {
        NeutralTable own = twoAxes();
        own.columns[0].target = "X";
        for (const TableFamily* each : {&family, &headerFamily}) {
            const auto written = each->write(std::array{own}, counts("1000"));
            VERIFY_RESULT(written);
            QVERIFY(mentions(written->bytes, "its command position must be the input"));
            QVERIFY(mentions(joined(written->remarks), "its command position must be the input"));
            const auto cross = each->write(std::array{twoAxes()}, counts("1000"));
            VERIFY_RESULT(cross);
            QVERIFY(!mentions(cross->bytes, "must be the input"));
        }
    }

    void whatIsWrittenIsReadBackTheSameWithinOneCount_data()
    {
        QTest::addColumn<int>("dimensions");
        QTest::addRow("1D") << 1;
        QTest::addRow("2D") << 2;
    }
    void whatIsWrittenIsReadBackTheSameWithinOneCount()
    {
        QFETCH(int, dimensions);
        NeutralTable table = twoAxes();
        table.axes.resize(static_cast<std::size_t>(dimensions));
        table.axes[0] = test::evenAxis("X", "mm", -0.3, 0.1, 7);
        table.columns = {test::waveColumn("Z", "um", table.pointCount(), 1.0)};
        TableWriteOptions options = counts("81.92");
        options.settings["value-unit"] = "um";
        const auto written = family.write(std::array{table}, options);
        VERIFY_RESULT(written);
        READ_TABLE(again, family, written->bytes, {});
        COMPARE_TABLES(again, table, 0.5 / 81.92 + 1e-12);
        QCOMPARE(again.name, table.name);
        QCOMPARE(again.notes, table.notes);
        QVERIFY(written->held.front() == again);
    }

    void valuesTakeTheUnitOfThePositionsUnlessASettingSaysAnother()
    {
        NeutralTable table = twoAxes();
        table.columns = {test::waveColumn("Z", "um", 105, 500.0)};
        const auto written = family.write(std::array{table}, counts("1000"));
        VERIFY_RESULT(written);
        QVERIFY(mentions(written->bytes, "# output.unit = mm\n"));
        QVERIFY2(mentions(joined(written->remarks), "1000 counts for 1 mm"),
            joined(written->remarks).c_str());
        READ_TABLE(again, family, written->bytes, {});
        QVERIFY(std::abs(again.columns[0].values[0] * 1e3 - table.columns[0].values[0]) <= 0.5);
        TableWriteOptions inAngles = counts("1000");
        inAngles.settings["value-unit"] = "deg";
        VERIFY_ERROR(family.write(std::array{table}, inAngles), ErrorCode::InvalidArgument);
    }

    void namesAndNotesStayOnTheirLine()
    {
        NeutralTable table = twoAxes();
        table.axes[0].name = " X = 1\n# input.1.min = 7 ";
        table.columns[0].target = "Z\r\n5,5";
        table.notes = {"two\nlines", "", "a = b"};
        const auto written = family.write(std::array{table}, counts("1000"));
        VERIFY_RESULT(written);
        READ_TABLE(again, family, written->bytes, {});
        QVERIFY(written->held.front() == again);
        QCOMPARE(again.axes[0].name, std::string("X = 1 # input.1.min = 7"));
        QCOMPARE(again.notes, (std::vector<std::string>{"two lines", "a = b"}));
    }

    void countsPerUnitAreNeededForWriting()
    {
        for (const TableFamily* each : {&family, &headerFamily}) {
            VERIFY_ERROR(each->write(std::array{twoAxes()}, {}), ErrorCode::InvalidArgument);
            VERIFY_ERROR(
                each->write(std::array{twoAxes()}, counts("0")), ErrorCode::InvalidArgument);
            VERIFY_ERROR(
                each->write(std::array{twoAxes()}, counts("many")), ErrorCode::InvalidArgument);
        }
    }

    void countsBeyondThirtyTwoBitsAreRefused()
    {
        const auto written = family.write(std::array{twoAxes()}, counts("1e10"));
        VERIFY_ERROR(written, ErrorCode::FormatCannotHold);
        QVERIFY(mentions(sentence(written.error()), "2147483647"));
    }

    void whatTheFactsRefuseIsRefused()
    {
        NeutralTable uneven = twoAxes();
        uneven.axes[0].knots[1] += 1;
        VERIFY_ERROR(checkHolds(family.facts, std::array{uneven}), ErrorCode::FormatCannotHold);
        NeutralTable wrapped = twoAxes();
        wrapped.axes[0].wrap = 250000;
        VERIFY_ERROR(
            checkHolds(headerFamily.facts, std::array{wrapped}), ErrorCode::FormatCannotHold);
        NeutralTable space = twoAxes();
        space.axes.push_back(space.axes[0]);
        VERIFY_ERROR(checkHolds(family.facts, std::array{space}), ErrorCode::FormatCannotHold);
        VERIFY_RESULT(checkHolds(family.facts, std::array{twoAxes()}));
    }

    void aProblemNamesItsPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("problem"); // the beginning of the first one
        const auto row = [](const char* name, const std::string& text, const char* problem) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(problem);
        };
        const auto withGrid = [](const char* min, const char* max, const char* delta) {
            return oneAxisText("# input.1.min = " + std::string(min) + "\n# input.1.max = " + max
                    + "\n# input.1.delta = " + delta + "\n",
                "1,2\n");
        };
        row("empty", "", "0:0 EmptyFile");
        row("binary", "# RapidCode\x01\x02\x03\x04", "0:0 NotText");
        row("no entries", "1,2,3\n", "1:0 Syntax |a line \"# input.1.min = NUMBER\"");
        row("no delta", oneAxisText("# input.1.min = 0\n# input.1.max = 1\n", "1,2\n"),
            "1:0 Syntax |a line \"# input.1.delta = NUMBER\"");
        row("half a second input", oneAxisText(grid + "# input.2.axis = Y\n", "1,2,3,4\n"),
            "1:0 Syntax |a line \"# input.2.min = NUMBER\"");
        row("no number", withGrid("x", "1", "1"), "2:17 NotANumber x|a number for input.1.min");
        row("empty number", withGrid("", "1", "1"), "2:17 NotANumber |a number for input.1.min");
        row("not finite", withGrid("0", "inf", "1"), "3:17 NotANumber inf");
        row("no range", withGrid("1", "1", "1"), "4:0 Contradiction 1 to 1 by 1|a maximum above");
        row("delta 0", withGrid("0", "1", "0"), "4:0 Contradiction 0 to 1 by 0|a maximum above");
        row("delta backwards", withGrid("0", "1", "-1"), "4:0 Contradiction 0 to 1 by -1|");
        row("not a multiple", withGrid("0", "1", "0.3"),
            "4:0 Contradiction 0 to 1 by 0.3|a range that is an integer multiple");
        row("delta above the range", withGrid("0", "1", "4"), "4:0 Contradiction 0 to 1 by 4|");
        row("a thousand million points", withGrid("0", "1e9", "1"),
            "4:0 LimitExceeded 0 to 1000000000 by 1|at most 4000000 points");
        row("infinitely many points", withGrid("-1e308", "1e308", "1e-300"), "4:0 LimitExceeded");
        row("positions that are not different", withGrid("1e17", "100000000000000004", "4"),
            "4:0 Contradiction");
        row("positions without a difference",
            oneAxisText("# input.1.min = 1e17\n# input.1.max = 1.0000000000000006e17\n"
                        "# input.1.delta = 4\n",
                "1,2,3,4,5,6,7,8,9,10,11,12,13,14,15,16,17\n"),
            "0:0 NotFinite positions of the axis|numbers that a computer can tell");
        row("values beyond a double",
            "# RapidCode compensator table\n" + grid
                + "# output.counts-per-unit = 1e-300\n1,2,3,1e9\n",
            "0:0 NotFinite values of the table|numbers that a computer can hold");
        row("twice", oneAxisText(grid + "# input.1.min = 3\n", "1,2,3,4\n"),
            "5:3 Contradiction a second input.1.min|each entry once");
        row("0 counts",
            "# RapidCode compensator table\n" + grid + "# output.counts-per-unit = 0\n1,2,3,4\n",
            "5:0 Contradiction 0 counts per unit");
        row("too few values", oneAxisText(grid, "1,2,3\n"), "8:0 ColumnCount 3 values|4, one for");
        row("too many values", oneAxisText(grid, "1,2,3,4,5\n"), "8:0 ColumnCount 5 values|4,");
        row("a value is none", oneAxisText(grid, "1,2, x,4\n"), "8:6 NotANumber x|a number of");
        row("a value is missing", oneAxisText(grid, "1,,3,4\n"), "8:3 NotANumber |a number of");
        row("too many lines", oneAxisText(grid, "1,2,3,4\n1,2,3,4\n"),
            "9:0 Contradiction 2 lines of counts|one line");
        row("no lines", oneAxisText(grid, ""), "0:0 MissingPoint 0 lines of counts|one line");
        row("cut off",
            oneAxisText(grid + "# input.2.min = 0\n# input.2.max = 2\n# input.2.delta = 1\n",
                "1,2,3,4\n1,2,3,4\n"),
            "0:0 MissingPoint 2 lines of counts|3, one for each position of the second axis");
    }
    void aProblemNamesItsPlace()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, problem);
        TableReadOptions options;
        options.settings = {{"position-unit", "mm"}, {"value-unit", "mm"}};
        const auto reading = family.read(text.toStdString(), options);
        VERIFY_RESULT(reading);
        QVERIFY(reading->tables.empty());
        const std::string found = problemLines(*reading);
        QVERIFY2(found.starts_with(problem.toStdString()), found.c_str());
    }

    void unknownEntriesAndMissingUnitsAreWarnings()
    {
        const auto reading = family.read("# RapidCode compensator table\n" + grid
                + "# imput.2.axis = Y\n# for people\n# output.counts-per-unit = 1\n1,2,3,4\n",
            {});
        VERIFY_RESULT(reading);
        QCOMPARE(reading->tables.size(), std::size_t(1));
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::UnknownKey, 5));
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::UnitNotGiven, 0));
    }

    void aFileIsRecognisedByItsFirstLine()
    {
        const auto written = family.write(std::array{twoAxes()}, counts("1000"));
        VERIFY_RESULT(written);
        QCOMPARE(family.recognise(written->bytes), Recognition::Certain);
        QCOMPARE(family.recognise("# something else\n1,2\n"), Recognition::No);
        QCOMPARE(family.recognise(""), Recognition::No);
        QVERIFY(guessFamily(written->bytes, "x.csv").families.front() == &family);
        QVERIFY(headerFamily.read == nullptr && headerFamily.recognise == nullptr);
    }

    void theHeaderCompilesAndHoldsTheTable()
    {
        static_assert(z_flatness::points == 105);
        static_assert(z_flatness::firstPoints * z_flatness::secondPoints == z_flatness::points);
        static_assert(z_flatness::firstMaximum - z_flatness::firstMinimum
            == z_flatness::firstDelta * (z_flatness::firstPoints - 1));
        TableWriteOptions options = counts("1000");
        options.settings["name"] = "z_flatness";
        const auto written = headerFamily.write(std::array{twoAxes()}, options);
        VERIFY_RESULT(written);
        QFile file(
            QStringLiteral(AXISCOMP_SOURCE_FOLDER "/tests/data/formats/rapidcode_compensator.h"));
        QVERIFY2(file.open(QIODevice::ReadOnly), qPrintable(file.errorString()));
        QCOMPARE(QByteArray::fromStdString(written->bytes), file.readAll());
        const std::vector<double>& values = written->held.front().columns[0].values;
        for (std::size_t i = 0; i < values.size(); ++i)
            QCOMPARE(values[i], z_flatness::table[i] / 1000.0);
    }

    void theHeaderOfOneAxisHasNoSecond()
    {
        NeutralTable table = twoAxes();
        table.axes.resize(1);
        table.columns = {test::waveColumn("X", "mm", 5, 0.01)};
        const auto written = headerFamily.write(std::array{table}, counts("1000"));
        VERIFY_RESULT(written);
        QVERIFY(mentions(written->bytes, "namespace compensator {"));
        QVERIFY(mentions(written->bytes, "constexpr int points = 5;"));
        QVERIFY(mentions(written->bytes, "{\n    8, 9, 1, -8, -10,\n};"));
        QVERIFY(!mentions(written->bytes, "second"));
    }

    void theNamespaceMustBeACppName()
    {
        for (const char* name : {"1st", "my table", "a-b", "\u00e4", "namespace"}) {
            TableWriteOptions options = counts("1000");
            options.settings["name"] = name;
            VERIFY_ERROR(
                headerFamily.write(std::array{twoAxes()}, options), ErrorCode::InvalidArgument);
        }
    }

    void twoMegabytesAreReadWhole()
    {
        std::string text = "# RapidCode compensator table\n# input.1.min = 0\n"
                           "# input.1.max = 499\n# input.1.delta = 1\n# input.2.min = 0\n"
                           "# input.2.max = 999\n# input.2.delta = 1\n"
                           "# output.counts-per-unit = 1000\n";
        for (int y = 0; y < 1000; ++y)
            for (int x = 0; x < 500; ++x)
                text += std::to_string(x - y) + (x == 499 ? '\n' : ',');
        READ_TABLE(table, family, text, {});
        QCOMPARE(table.pointCount(), std::size_t(500000));
    }
};

AXISCOMP_TEST(TestRapidcode)

} // namespace tst_rapidcode

#include "tst_rapidcode.moc"
