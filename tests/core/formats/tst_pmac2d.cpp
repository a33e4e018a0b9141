// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_checks.h"
#include "tests/support/test_registry.h"

namespace tst_pmac2d {

using namespace axiscomp;
using test::applied;
using test::problemLines;

namespace {

const TableFamily& family = pmac_2d::format();

/// 2 rows and 3 columns of intervals: 4 x 3 points, the first of which has no entry.
const std::string file = "#3\nDEFINE COMP 2.3,#1D,#2D,#3,3000,4000\n"
                         "16 32 0\n"
                         "48 64 80 48\n"
                         "0 16 32 0\n";

std::string with(const std::string& from, const std::string& to)
{
    std::string text = file;
    return text.replace(text.find(from), from.size(), to);
}

TableReadOptions inMillimetres()
{
    TableReadOptions options;
    options.settings = {{"counts-per-unit", "1000"}, {"position-unit", "mm"}, {"value-unit", "mm"}};
    return options;
}

TableWriteOptions thousand()
{
    TableWriteOptions options;
    options.settings["counts-per-unit"] = "1000";
    return options;
}

/// Symmetric ranges round 0, where the value is 0.
NeutralTable plane()
{
    NeutralTable table;
    table.sign = SignConvention::Command;
    table.axes = {test::evenAxis("1", "mm", -10, 5, 5), test::evenAxis("2", "mm", -4, 2, 6)};
    table.columns = {test::waveColumn("3", "mm", 30, 0.05)};
    table.columns[0].values[2 + 2 * 5] = 0;
    return table;
}

} // namespace

class TestPmac2d : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void alongARowTheRowMotorMovesAndTheFirstEntryIsLeftOut()
    {
        READ_TABLE(table, family, file, inMillimetres());
        QCOMPARE(table.axes[0].name, std::string("1"));
        QCOMPARE(table.axes[0].knots, (std::vector<double>{0, 1, 2, 3}));
        QCOMPARE(table.axes[1].name, std::string("2"));
        QCOMPARE(table.axes[1].knots, (std::vector<double>{0, 2, 4}));
        QCOMPARE(table.columns[0].target, std::string("3"));
        QCOMPARE(applied(family, table, {0, 0}), 0.0);
        QCOMPARE(applied(family, table, {1, 0}), 0.001);
        QCOMPARE(applied(family, table, {0, 2}), 0.003);
        QCOMPARE(applied(family, table, {2, 2}), 0.005);
        QVERIFY2(reading_table->diagnostics.empty(), problemLines(*reading_table).c_str());
    }

    void itIsBilinearAndRollsOverAlongBothSources()
    {
        READ_TABLE(table, family, file, inMillimetres());
        QCOMPARE(applied(family, table, {1, 1}), 0.0025);
        QCOMPARE(applied(family, table, {4, 5}), 0.0025);
        QCOMPARE(applied(family, table, {-2, -2}), 0.004);
    }

    void motorsThatAreNotNamedAreTheAddressedOne()
    {
        READ_TABLE(one, family, with("#1D,#2D,#3", "#1"), inMillimetres());
        QCOMPARE(one.axes[0].name, std::string("1"));
        QCOMPARE(one.axes[1].name, std::string("3"));
        QCOMPARE(one.columns[0].target, std::string("3"));
        READ_TABLE(two, family, with("#1D,#2D,#3", "#5,#6"), inMillimetres());
        QCOMPARE(two.axes[1].name, std::string("6"));
        QCOMPARE(two.columns[0].target, std::string("3"));
    }

    void eachMotorMayHaveItsOwnCounts()
    {
        TableReadOptions options = inMillimetres();
        options.settings["column-counts-per-unit"] = "500";
        options.settings["target-counts-per-unit"] = "100";
        READ_TABLE(table, family, file, options);
        QCOMPARE(table.axes[0].knots[1], 1.0);
        QCOMPARE(table.axes[1].knots[1], 4.0);
        QCOMPARE(applied(family, table, {1, 0}), 0.01);
    }

    void whatIsWrittenCorrectsTheSame()
    {
        const NeutralTable table = plane();
        const auto written = family.write(std::array{table}, thousand());
        VERIFY_RESULT(written);
        QVERIFY(written->bytes.starts_with("#3\nDEFINE COMP 6.5,#1D,#2D,#3,25000,12000\n"));
        READ_TABLE(again, family, written->bytes, inMillimetres());
        QCOMPARE(again, written->held.front());
        for (double y = -4; y <= 6; y += 0.5)
            for (double x = -10; x <= 10; x += 1.25)
                QVERIFY(std::abs(applied(family, again, {x, y}) - applied(family, table, {x, y}))
                    <= 0.5 / 16000 + 1e-9);
    }

    void aTableThatRollsOverIsWrittenAsItIs()
    {
        READ_TABLE(table, family, file, inMillimetres());
        const auto written = family.write(std::array{table}, thousand());
        VERIFY_RESULT(written);
        QCOMPARE(written->bytes,
            std::string("#3\nDEFINE COMP 2.3,#1D,#2D,#3,3000,4000\n16 32 0\n48 64 80 48\n0 16 32 "
                        "0\n"));
        QCOMPARE(written->held.front(), table);
    }

    void aValueAtZeroIsRefused()
    {
        NeutralTable table = plane();
        table.columns[0].values[2 + 2 * 5] = 0.5;
        VERIFY_ERROR(family.write(std::array{table}, thousand()), ErrorCode::FormatCannotHold);
    }

    void axesThatAreNoNumbersNeedSettings()
    {
        NeutralTable table = plane();
        table.axes[1].name = "Y";
        const auto refused = family.write(std::array{table}, thousand());
        VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
        QVERIFY(test::describe(refused.error()).find("column-motor") != std::string::npos);
    }

    void aProblemNamesItsPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("problem"); // the beginning of the first one
        const auto row = [](const char* name, const std::string& text, const char* problem) {
            QTest::newRow(name) << QByteArray::fromStdString(text) << QByteArray(problem);
        };
        row("empty", "", "0:0 EmptyFile");
        row("one dimension", "DEFINE COMP 2,#1,#2,100\n1 0\n",
            "warning 1:1 Assumption a table of one");
        row("truncated", with("0 16 32 0\n", "0 16\n"), "2:0 MissingPoint 9 entries|11, as DEFINE");
        row("too many", with("0 16 32 0\n", "0 16 32 0 5\n"), "5:0 Contradiction 12 entries|11");
        row("no second span", with("3000,4000", "3000"), "2:1 Syntax DEFINE COMP 2.3");
        row("no rows", with("2.3,", "0.3,"), "2:13 LimitExceeded 0 entries");
        row("no columns", with("2.3,", "2.,"), "2:15 NotANumber |a number of entries");
        row("absurd", with("2.3,", "900000.900000,"), "2:0 MissingPoint 11 entries|810001800000");
        row("four motors", with("#3,3000", "#3,#4,3000"), "2:1 Syntax DEFINE COMP");
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

    void aFileIsRecognisedByItsDefinition()
    {
        QCOMPARE(family.recognise(file), Recognition::Certain);
        QCOMPARE(family.recognise("DEFINE COMP 4,#1,#2,10\n"), Recognition::No);
        QCOMPARE(family.recognise(file + "DEFINE COMP 4,#1,#2,10\n"), Recognition::Possible);
    }
};

AXISCOMP_TEST(TestPmac2d)

} // namespace tst_pmac2d

#include "tst_pmac2d.moc"
