// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_heidenhaincom530 {

using namespace axiscomp;
using test::changed;
using test::problemLines;

namespace {

const TableFormat& format = heidenhain_com_530::format();

const std::string example = "BEGIN AXIS-Y.COM  DATUM:-90.0000 DISTANCE:+6.5536\n"
                            "NR                  X          Y          Z\n"
                            "0       -90.0000               +0.0000\n"
                            "1       -83.4464               +0.0021\n"
                            "2       -76.8928               +0.0035\n"
                            "3       -70.3392               -0.0012\n"
                            "4       -63.7856               -0.0042\n"
                            "[END]\n";
const auto with = test::changing(example);

/// The published table Y = F(Z), with two lines without a value.
const std::string published = "BEGIN AXIS-Z.COM  DATUM:-990.0000 DISTANCE:+16.3840\n"
                              "NR                  X          Y          Z\n"
                              "0       -990.0000              +0.0000\n"
                              "1       -973.6160              -0.0600\n"
                              "2       -957.2320              -0.0900\n"
                              "3       -940.8480\n"
                              "4       -924.4640\n"
                              "5       -908.0800              -0.1200\n"
                              "6       -891.6960              -0.1200\n"
                              "7       -875.3120              -0.1000\n"
                              "8       -858.9280              -0.0900\n"
                              "[END]\n";

NeutralTable exampleTable(double distance = 6.5536)
{
    return test::tableOf(SignConvention::Feedback, {test::evenAxis("Y", "mm", -90, distance, 5)},
        {test::columnOf("Y", "mm", {0, 0.0021, 0.0035, -0.0012, -0.0042})});
}

void describeWriting(test::FormatSample& sample)
{
    sample.writes("the layout of a public writer", {exampleTable()})
        .as(example)
        .remarking(
            {"no text says the sign of a .COM table", "config.cma, in the column of axis Y"});
    sample.writes("another distance", {exampleTable(5)})
        .with({{"any-distance", "yes"}})
        .containing({"DATUM:-90.0000 DISTANCE:+5.0000\n", "\n4       -70.0000"});
    sample.writes("the smallest power of two", {changed(exampleTable(0.0001), [](NeutralTable& t) {
        t.columns[0].values.assign(5, 0.5);
    })});
    sample.refuses("a distance that is no power of two", {exampleTable(5)},
        ErrorCode::FormatCannotHold, "the next ones are 3.2768 mm and 6.5536 mm");
    sample.refuses("a small distance", {exampleTable(0.00015)}, ErrorCode::FormatCannotHold,
        "the next ones are 0.0001 mm and 0.0002 mm");
    sample.refuses("a distance of more decimals", {exampleTable(1.0 / 3)},
        ErrorCode::FormatCannotHold, "has more than 4 decimals",
        FormatSettings{{"any-distance", "yes"}});
    sample.refuses("a number wider than its column",
        {changed(exampleTable(), [](NeutralTable& t) { t.columns[0].values[1] = 12345.5; })},
        ErrorCode::FormatCannotHold, "more digits than a column holds");
    sample.refuses("no letter",
        {changed(
            exampleTable(), [](NeutralTable& t) { t.axes[0].name = t.columns[0].target = "1"; })},
        ErrorCode::InvalidArgument, "give the setting axis");
}

void describe(test::FormatSample& sample)
{
    sample.facts = "feedback is assumed; 1 to 1 dimensions, even knots; points 256, columns 9, "
                   "tables 1, bytes 67108864; holds names units";
    sample.text = example;
    sample.spareBytes = 1;
    sample.warnedBytes = 128; // without the end the lines before it are a table
    sample.applies(
        {{{-981.808}, -0.03}, {{-940.848}, -0.10}, {{-924.464}, -0.11}, {{-1e6}, 0}, {{0}, -0.09}},
        published);
    sample.applies({{{-76.8928}, 0.0035}, {{-63.7856}, -0.0042}});
    sample.recognises(Recognition::Certain, {example, published});
    sample.recognises(Recognition::No,
        {"BEGIN AXIS_Y.COM MM\n", "DATUM:-90 DISTANCE:+6\n", "BEGIN AXIS-Y.COM DATUM:1"});
    sample.warning("no end", with("[END]\n", ""), {"0:0 Assumption no line [END]|that line"});
    sample.warning("values that change too much", with("+0.0021", "+0.1030"),
        {"4:0 LargeGradient values of Y that change by 0.103|at most 0.1024 from line to line"});
    describeWriting(sample);

    const auto row = sample.problemRow();
    row("the other layout", with("  DATUM:-90.0000 DISTANCE:+6.5536", " MM"),
        "1:1 Syntax BEGIN AXIS-Y.COM MM|the format heidenhain-com to read it");
    row("another first line", with("BEGIN", "START"), "1:1 Syntax START AXIS-Y.COM");
    row("a datum that is none", with("DATUM:-90.0000", "DATUM:-90,0"), "1:25 NotANumber -90,0|a");
    row("a distance that is none", with("DISTANCE:+6.5536", "DISTANCE:"), "1:43 NotANumber |a");
    row("a distance of 0", with("DISTANCE:+6.5536", "DISTANCE: 0"),
        "1:1 LimitExceeded a distance of 0|a distance above 0");
    row("a position that does not fit", with("-76.8928", "-76.8929"),
        "5:9 Contradiction -76.8929|-76.8928, as DATUM and DISTANCE say for line 2");
    row("a number of a line that does not fit", with("\n2 ", "\n3 "),
        "5:9 Contradiction -76.8928|-70.3392, as DATUM and DISTANCE say for line 3");
    row("a value left of the axes", with("1       -83.4464               ", "1       -83.4464 1  "),
        "4:18 Syntax 1|a value below the header of an axis");
    row("no position", with("1       -83.4464", "1               "), "4:1 Syntax 1    ");
    row("a tab", with("-83.4464 ", "-83.4464\t"), "4:17 Syntax a tab|blanks");
    row("no headers", "BEGIN AXIS-Y.COM DATUM:0 DISTANCE:1\n[END]\n",
        "0:0 Syntax |a line of headers");
}

} // namespace

class TestHeidenhainCom530 : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theExampleIsRead()
    {
        READ_TABLE(table, format, example, {});
        COMPARE_TABLES(table, exampleTable(), 0.0);
    }

    void thePublishedTableIsThatOfAnotherAxis()
    {
        READ_TABLE(table, format, published, {});
        QVERIFY2(reading_table->diagnostics.empty(), problemLines(*reading_table).c_str());
        QCOMPARE(table.axes[0].name, std::string("Z"));
        QCOMPARE(table.columns[0].target, std::string("Y"));
        QVERIFY(!ownAxis(table, table.columns[0]));
        QCOMPARE(table.axes[0].knots.size(), std::size_t(7));
    }

    /// DISTANCE / 64 of the published table is 0.256, also over lines without a value.
    void theLimitCountsFromLineToLine()
    {
        const auto steep = [](const char* value) {
            const auto reading =
                format.read(test::with(published, "-0.1200", value), TableReadOptions{});
            return problemLines(reading.value());
        };
        QCOMPARE(steep("-0.3400"), std::string());
        QVERIFY(steep("-0.9000").find("LargeGradient") != std::string::npos);
        QVERIFY(steep("-0.9000").find("at most 0.256") != std::string::npos);
    }

    void steepValuesAreARemarkOfWriting()
    {
        NeutralTable table = exampleTable();
        table.columns[0].values[1] = 0.2;
        WRITE_TABLE(written, format, table, {});
        QVERIFY(test::mentions(test::joined(written->remarks), "DISTANCE / 64"));
    }
};

AXISCOMP_TEST(TestHeidenhainCom530)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_heidenhaincom530

#include "tst_heidenhaincom530.moc"
