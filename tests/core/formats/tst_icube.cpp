// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_icube {

using namespace axiscomp;
using test::applied;
using test::mentions;

namespace {

const TableFormat& format = icube::format();

/// The example of the manual.
const std::string example = "0.00 0.001\n0.25 0.001\n0.50 0.001\n1.00 0.002\n5.00 0.002\n"
                            "7.00 0.001\n8.00 0.000\n9.00 -0.001\n9.25 -0.002\n10.00 0.001\n";

const TableReadOptions inMillimetres = test::readingWith({{"position-unit", "mm"}});

FormatSettings rotary(std::string range)
{
    return {{"position-unit", "deg"}, {"wrap-range", std::move(range)}};
}

NeutralTable table(std::vector<double> knots, std::vector<double> values)
{
    return test::commandTable({test::axisOf("", "mm", std::move(knots))},
        {test::columnOf("#1", "mm", std::move(values))});
}

void describe(test::FormatSample& sample)
{
    sample.facts = "command is published; 1 to 1 dimensions, any knots; "
                   "points any, columns 1, tables 1, bytes 999999; holds wrap";
    sample.text = example;
    sample.reading = inMillimetres;
    sample.spareBytes = example.size() - 17; // two points are a table
    sample.applies({{{6.0}, 0.0015}, {{8.5}, -0.0005}, {{-3.999}, 0.001}, {{-4.00}, 0.001}});
    sample.applies({{{-5.0}, 0.004}, {{1e6}, 0.001}}, "-4 0.004\n0 0\n10 0.001\n");
    sample.recognises(
        Recognition::Possible, {example, "Master,Offset\n0,1\n1,1\n", example + "11.0"});
    sample.recognises(Recognition::No,
        {"0 1 2\n1 1 2\n", "1 3\n0 0.1\n1 0.1\n2 0.1\n", "0,1\n", "a\nb\nc\nd\ne\nf\n0,1\n1,1\n"});
    const std::string headers = "Axis1, compensation\nMaster;Offset\n0,0.1\n1,0.2\n";
    sample.applies({{{0.5}, 0.15}}, headers);
    sample.warning("leading lines that are not two numbers are headers", headers, {});
    sample.warning("a header that may be a point", "0,0.1,7\n1,0.1\n2,0.2\n", {"1:0 Assumption"});
    sample.warning("a point with a Unicode minus", "\u221210,0.1\n0,0\n10,0.2\n",
        {"1:0 Assumption \"\u221210,0.1\", which is taken to be a header"});
    sample.warning("points in quotation marks", "\"0\",\"0.1\"\n\"1\",\"0.1\"\n2,0\n3,0\n",
        {"1:0 Assumption 2 lines that are taken to be headers, the first of them"});
    sample.warning(
        "a unit in the header", "Position [um],Offset (um)\n0,0.1\n1,0.2\n", {}, FormatSettings());
    sample.warning(
        "a unit of the positions", "Position [um],Offset\n0,0.1\n1,0.2\n", {}, FormatSettings());
    sample.warning("a unit of the offsets alone", "Position,Offset [um]\n0,0.1\n1,0.2\n",
        {"0:0 UnitNotGiven"}, FormatSettings());
    sample.problem("another unit of the offsets alone than in the settings",
        "Position,Offset [um]\n0,0.1\n1,0.2\n",
        "0:0 Contradiction numbers in um, as the file says|mm, as the setting says", {},
        FormatSettings{{"position-unit", "mm"}});
    sample.problem("two units in the header", "Position [mm],Offset [um]\n0,0.1\n1,0.2\n",
        "1:0 Contradiction Position [mm],Offset [um]|one unit for positions and offsets");
    sample.problem("another unit in the header than in the settings",
        "Position [um],Offset [um]\n0,0.1\n1,0.2\n",
        "0:0 Contradiction numbers in um, as the file says|mm, as the setting says");
    sample.warning("a unit that nobody says", example, {"0:0 UnitNotGiven"}, FormatSettings());

    const FormatSettings twoUnits{{"position-unit", "mm"}, {"value-unit", "um"}};
    sample.problem("two units", example, "0:0 Contradiction", "", twoUnits);
    sample.refuses("two units", {table({0, 1}, {0, 0})}, ErrorCode::InvalidArgument, "", twoUnits);
    sample.refuses("another kind of unit", {table({0, 1}, {0, 0.5})}, ErrorCode::InvalidArgument,
        "", FormatSettings{{"position-unit", "deg"}});
    sample.refusesReading("no wrap range", rotary("0"), "");
    sample.refusesReading("a negative wrap range", rotary("-1"), "");
    sample
        .writes(
            "uneven positions", {table({-7.5, 0, 0.1, 3, 1000.125}, {0.1, -0.02, 0, 1e-7, 0.3})})
        .as("-7.5,0.1\n0,-0.02\n0.1,0\n3,0.0000001\n1000.125,0.3\n");
    NeutralTable named = table({0, 90, 360}, {0.5, 2, 0.5});
    named.axes[0].name = "C";
    named.axes[0].unit = "deg";
    named.axes[0].wrap = 360;
    named.columns[0].target = "C";
    named.columns[0].unit = "mdeg";
    named.notes = {"measured"};
    NeutralTable nameless = table({0, 90, 360}, {0.0005, 0.002, 0.0005});
    nameless.axes[0].unit = nameless.columns[0].unit = "deg";
    nameless.axes[0].wrap = 360;
    sample.writes("a rotary axis", {named})
        .as("0,0.0005\n90,0.002\n360,0.0005\n")
        .readWith(rotary("360"))
        .becoming(nameless);
    NeutralTable axis1 = table({0, 1}, {0, 0.001});
    axis1.axes[0].name = axis1.columns[0].target = "Axis1";
    sample.writes("the name of the file", {axis1})
        .remarking({"Axis1PosComp.CSV", "in mm"})
        .becoming(table({0, 1}, {0, 0.001}));
    const auto in = [](const char* unit, std::vector<double> knots, std::vector<double> values) {
        NeutralTable result = table(std::move(knots), std::move(values));
        result.axes[0].unit = result.columns[0].unit = unit;
        return result;
    };
    sample.writes("in micrometres", {table({0, 1}, {0, 0.5})})
        .with({{"position-unit", "um"}})
        .readWith({{"position-unit", "um"}})
        .as("0,0\n1000,500\n")
        .becoming(in("um", {0, 1000}, {0, 500}));
    sample.writes("in metres, and no digits more", {table({0, 2.3}, {0, 0.7})})
        .with({{"position-unit", "m"}})
        .readWith({{"position-unit", "m"}})
        .as("0,0\n0.0023,0.0007\n")
        .becoming(in("m", {0, 0.0023}, {0, 0.0007}));

    const auto turn = [](std::vector<double> values, std::optional<double> wrap) {
        NeutralTable result = table({0, 180, 360}, std::move(values));
        result.axes[0].wrap = wrap;
        return result;
    };
    const FormatSettings oneTurn{{"wrap-range", "360"}};
    sample.writes("the wrap range of the setting", {turn({0, 1, 0}, {})})
        .with(oneTurn)
        .readWith({{"position-unit", "mm"}, {"wrap-range", "360"}})
        .becoming(turn({0, 1, 0}, 360));
    sample.refuses("another wrap range than the setting's", {turn({0, 1, 0}, 720)},
        ErrorCode::InvalidArgument, "", oneTurn);
    sample.refuses("no wrap range", {turn({0, 1, 0}, 720)}, ErrorCode::InvalidArgument, "",
        FormatSettings{{"wrap-range", "0"}});
    const auto cannotHold = ErrorCode::FormatCannotHold;
    sample.refuses("position + offset turns", {turn({0, -180, 0}, {})}, cannotHold, "4900");
    sample.refuses("not a whole revolution", {turn({0, 1, 0}, 361)}, cannotHold, "4902");
    sample.refuses("ends differ", {turn({0, 1, 0.1}, 360)}, cannotHold, "4902");
    NeutralTable cross = table({0, 180, 360}, {0, 1, 0});
    cross.axes[0].name = "X";
    cross.columns[0].target = "Y";
    sample.refuses("cross compensation", {cross}, cannotHold, "X to Y");

    const auto row = [&sample](const char* name, const char* text, const char* line,
                         const char* number = "4900") { sample.problem(name, text, line, number); };
    row("headers only", "Master,Slave\nof Axis1\n", "0:0 Syntax |lines of two numbers");
    row("decimal commas", "Position;Offset\n0,25;0,001\n0,5;0,002\n",
        "2:0 Syntax 0,25;0,001|lines of two numbers");
    row("one point", "X,Y\n0,0.1\n", "2:0 TooFewPoints 1 point|at least 2");
    row("offset missing", "0,0.1\n1\n", "2:0 ColumnCount 1 number|two numbers");
    row("offset empty", "0,0.1\n1,\n", "2:3 NotANumber |an offset");
    row("cut off", "0,0.1\n1,0.\n2,-", "3:3 NotANumber -|an offset");
    row("three numbers", "0,0.1\n1,0.1,5\n", "2:0 ColumnCount 3 numbers|two numbers");
    row("position is none", "0,0.1\nx1,0.1\n", "2:1 NotANumber x1|a position");
    row("offset is none", "0 0.1\n1 0.1mm\n", "2:3 NotANumber 0.1mm|an offset");
    row("not finite", "0 0.1\n1 inf\n", "2:3 NotANumber inf|an offset");
    row("duplicate", "0,0.1\n1,0.1\n1,0.1\n",
        "3:0 NotMonotonic 1 after 1|strictly increasing positions");
    row("duplicate at the beginning", "1,0.1\n1,0.1\n2,0.1\n",
        "2:0 NotMonotonic 1 after 1|strictly increasing positions");
    row("turns down", "0,0\n5,0\n4,0\n",
        "3:0 NotMonotonic 4 after 5|strictly increasing positions");
    row("turns up", "5,0\n0,0\n1,0\n", "3:0 NotMonotonic 1 after 0|strictly decreasing positions");
    row("sum turns", "0,0.5\n1,0.25\n2,-1\n",
        "3:0 NotMonotonic position + offset 1 after 1.25|strictly increasing");
    row("sum stands", "0,0\n1,-1\n", "2:0 NotMonotonic position + offset 0 after 0|strictly");
    row("sum of decreasing positions turns", "2,0\n1,1.5\n0,0\n",
        "2:0 NotMonotonic position + offset 2.5 after 2|strictly decreasing");
    row("further problems", "0,0\n1,a\n2\n3,b\n",
        "2:3 NotANumber a|an offset such as 0.001 #4900\n3:0 ColumnCount 1 number|two numbers such "
        "as 0.25,0.001: position and offset #4900\n4:3 NotANumber b|an offset");
    sample.problem("a rotary table that is too short", "0,0\n359.999,0\n",
        "2:0 NotPeriodic positions from 0 to 359.999|a span of exactly 360", "4902", rotary("360"));
    sample.problem("a rotary table that is too long", "0,0\n361,0\n",
        "2:0 NotPeriodic positions from 0 to 361", "4902", rotary("360"));
    sample.problem("a rotary table with another offset at its end", "0,0\n180,1\n360,0.001\n",
        "3:0 NotPeriodic the offsets 0 and 0.001 at the ends", "4902", rotary("360"));
}

} // namespace

class TestIcube : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theExampleOfTheManualIsRead()
    {
        READ_TABLE(read, format, example, inMillimetres);
        QCOMPARE(read.axes[0].knots, (std::vector<double>{0, 0.25, 0.5, 1, 5, 7, 8, 9, 9.25, 10}));
        QCOMPARE(read.columns[0].values,
            (std::vector<double>{
                0.001, 0.001, 0.001, 0.002, 0.002, 0.001, 0, -0.001, -0.002, 0.001}));
        QCOMPARE(read.axes[0].unit, std::string("mm"));
        QCOMPARE(read.columns[0].unit, std::string("mm"));
    }

    void everySeparatorIsRead_data()
    {
        QTest::addColumn<QByteArray>("text");
        const auto row = [](const char* name, const char* text) {
            QTest::newRow(name) << QByteArray(text);
        };
        row("comma", "0,0.25\n1,-0.25\n");
        row("comma and blank", "0, 0.25\r\n1,  -0.25\r\n");
        row("semicolon", "0;0.25\n1;-0.25");
        row("tab", "0\t0.25\n1\t-0.25\n");
        row("blanks", "  0   0.25\n 1  -0.25 \n");
        row("empty lines", "\n0,0.25\n\n1,-0.25\n\n");
    }
    void everySeparatorIsRead()
    {
        QFETCH(QByteArray, text);
        READ_TABLE(read, format, text.toStdString(), inMillimetres);
        QCOMPARE(read.axes[0].knots, (std::vector<double>{0, 1}));
        QCOMPARE(read.columns[0].values, (std::vector<double>{0.25, -0.25}));
    }

    void decreasingPositionsAreReadAscending()
    {
        READ_TABLE(read, format, "10,0.3\n4,0.2\n0,0.1\n", inMillimetres);
        QCOMPARE(read.axes[0].knots, (std::vector<double>{0, 4, 10}));
        QCOMPARE(read.columns[0].values, (std::vector<double>{0.1, 0.2, 0.3}));
    }

    void aRotaryAxisSpansItsWrapRangeExactly()
    {
        READ_TABLE(read, format, "0,0.1\n100,0.2\n360,0.1\n", test::readingWith(rotary("360")));
        QCOMPARE(read.axes[0].wrap, std::optional<double>(360.0));
        QCOMPARE(applied(format, read, {-310.0}), 0.15);
        QCOMPARE(applied(format, read, {820.0}), 0.2);
        READ_TABLE(down, format, "180,0.1\n0,0.2\n-180,0.1\n", test::readingWith(rotary("360")));
        QCOMPARE(applied(format, down, {360.0}), 0.2);
    }

    void lessThanAMegabyteIsReadAndMoreIsNotWritten()
    {
        std::string text;
        for (int i = 0; text.size() < 1'000'000; ++i)
            text += std::to_string(i) + ",0.00001\n";
        text.resize(text.rfind('\n', 999'000) + 1);
        READ_TABLE(read, format, text, inMillimetres);
        QVERIFY(read.pointCount() > 50'000);

        const auto written =
            format.write(std::array{table(evenKnots(60'000), std::vector(60'000, 1e-3 / 3))}, {});
        VERIFY_ERROR(written, ErrorCode::FormatCannotHold);
        QVERIFY(mentions(sentence(written.error()), "999999"));
    }

private:
    static std::vector<double> evenKnots(int count)
    {
        std::vector<double> knots;
        for (int i = 0; i < count; ++i)
            knots.push_back(i);
        return knots;
    }
};

AXISCOMP_TEST(TestIcube)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_icube

#include "tst_icube.moc"
