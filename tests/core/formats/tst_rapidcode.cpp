// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_sample.h"
#include "tests/data/formats/rapidcode_compensator.h"
#include "tests/support/test_registry.h"

#include <QFile>

namespace tst_rapidcode {

using namespace axiscomp;
using test::joined;
using test::mentions;

namespace {

const TableFormat& format = rapidcode::format();
const TableFormat& headerFormat = rapidcode_header::format();

/// The example of the documentation: 5 x 21 points.
NeutralTable twoAxes()
{
    NeutralTable table = test::commandTable(
        {test::evenAxis("X", "mm", 0, 50000, 5), test::evenAxis("Y", "mm", 25000, 10000, 21)},
        {test::waveColumn("Z", "mm", 105, 0.5)});
    table.name = "flatness";
    table.notes = {"measured with a probe"};
    return table;
}

TableWriteOptions counts(std::string perUnit)
{
    return test::writingWith({{"counts-per-unit", std::move(perUnit)}});
}

std::string oneAxisText(const std::string& grid, const std::string& rows)
{
    return "# RapidCode compensator table\n" + grid
        + "# input.1.unit = mm\n# output.unit = mm\n# output.counts-per-unit = 1000\n" + rows;
}

const std::string grid = "# input.1.min = 10\n# input.1.max = 40\n# input.1.delta = 10\n";

void refuseCounts(test::FormatSample& sample)
{
    sample.refuses(
        "0 counts per unit", {twoAxes()}, ErrorCode::InvalidArgument, "", counts("0").settings);
}

void describe(test::FormatSample& sample)
{
    const std::string flat = oneAxisText(grid, "5,5,5,5\n");
    sample.facts = "command is published; 1 to 2 dimensions, even knots; "
                   "points 4000000, columns 1, tables 1, bytes 67108864; holds names units notes";
    sample.text = oneAxisText(grid, "0,10,0,0\n");
    sample.writing = counts("1000");
    sample.spareBytes = 1;
    sample.applies({{{12.5}, 0.0025}});
    sample.applies({{{10.0}, 0.005}, {{9.999}, 0.0}, {{40.0}, 0.005}, {{40.001}, 0.0}}, flat);
    sample.recognises(Recognition::Certain, {flat});
    sample.recognises(Recognition::No, {"# something else\n1,2\n"});
    sample.warning("an unknown entry, and no units",
        "# RapidCode compensator table\n" + grid
            + "# imput.2.axis = Y\n# for people\n# output.counts-per-unit = 1\n1,2,3,4\n",
        {"5:3 UnknownKey imput.2.axis|", "0:0 UnitNotGiven no entry input.1.unit|",
            "0:0 UnitNotGiven no entry output.unit|"});

    NeutralTable fine = twoAxes();
    fine.axes[0] = test::evenAxis("X", "mm", -0.3, 0.1, 7);
    fine.columns = {test::waveColumn("Z", "um", 147, 1.0)};
    NeutralTable line = fine;
    line.axes.resize(1);
    line.columns = {test::waveColumn("Z", "um", 7, 1.0)};
    const FormatSettings inMicrometres{{"counts-per-unit", "81.92"}, {"value-unit", "um"}};
    sample.writes("the example of the documentation", {twoAxes()}).within(0.5 / 1000 + 1e-12);
    NeutralTable counted = twoAxes();
    for (std::size_t i = 0; i < 105; ++i)
        counted.columns[0].values[i] = static_cast<double>(i) / 1000.0;
    sample.writes("5 x 21 points, the first axis fastest", {counted})
        .containing({"# input.1.min = 0\n# input.1.max = 200000\n# input.1.delta = 50000\n",
            "# input.2.min = 25000\n# input.2.max = 225000\n# input.2.delta = 10000\n",
            "\n0,1,2,3,4\n5,6,7,8,9\n", "\n100,101,102,103,104\n"});
    NeutralTable microns = twoAxes();
    microns.columns = {test::waveColumn("Z", "um", 105, 500.0)};
    sample.writes("values in the unit of the positions", {microns})
        .containing({"# output.unit = mm\n"})
        .remarking({"1000 counts for 1 mm"})
        .becoming(twoAxes())
        .within(0.5 / 1000 + 1e-12);
    sample.refuses("values in an angle", {microns}, ErrorCode::InvalidArgument, "",
        FormatSettings{{"counts-per-unit", "1000"}, {"value-unit", "deg"}});
    NeutralTable lines = counted;
    lines.axes[0].name = " X = 1\n# input.1.min = 7 ";
    lines.columns[0].target = "Z\r\n5,5";
    lines.notes = {"two\nlines", "", "a = b"};
    NeutralTable cleaned = counted;
    cleaned.axes[0].name = "X = 1 # input.1.min = 7";
    cleaned.columns[0].target = "other"; // what the file says is no name of an axis
    cleaned.notes = {"two lines", "a = b"};
    sample.writes("names and notes stay on their line", {lines}).becoming(cleaned);
    sample.writes("1D", {line}).with(inMicrometres).within(0.5 / 81.92 + 1e-12);
    sample.writes("2D", {fine}).with(inMicrometres).within(0.5 / 81.92 + 1e-12);
    sample.writes("negative counts per unit", {twoAxes()})
        .with({{"counts-per-unit", "-2000"}})
        .within(0.5 / 2000 + 1e-12);
    refuseCounts(sample);
    sample.refuses("counts beyond 32 bits", {twoAxes()}, ErrorCode::FormatCannotHold, "2147483647",
        counts("1e10").settings);
    const auto contradicts = [&sample](const char* key, const char* value, const char* place) {
        sample.problem(std::string("another ") + key, oneAxisText(grid, "0,2,-3,0\n"), place, "",
            FormatSettings{{key, value}});
    };
    contradicts("counts-per-unit", "999", "7:0 Contradiction");
    contradicts("position-unit", "um", "5:0 Contradiction");
    contradicts("value-unit", "um", "6:0 Contradiction");

    const auto withGrid = [](const char* min, const char* max, const char* delta) {
        return oneAxisText("# input.1.min = " + std::string(min) + "\n# input.1.max = " + max
                + "\n# input.1.delta = " + delta + "\n",
            "1,2\n");
    };
    const auto row = sample.problemRow();
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
        "# RapidCode compensator table\n" + grid + "# output.counts-per-unit = 1e-300\n1,2,3,1e9\n",
        "0:0 NotFinite values of the table|numbers that a computer can hold");
    row("no counts per unit", "# RapidCode compensator table\n" + grid + "0,2,-3,0\n",
        "0:0 UnitNotGiven");
    row("a range of three and a third", withGrid("0", "10", "3"), "4:0 Contradiction");
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

void describeHeader(test::FormatSample& sample)
{
    sample.facts = "command is published; 1 to 2 dimensions, even knots; "
                   "points 4000000, columns 1, tables 1, bytes 67108864; holds";
    sample.writing = counts("1000");
    sample.writes("the example of the documentation", {twoAxes()}).within(0.5 / 1000 + 1e-12);
    refuseCounts(sample);
    for (const char* name : {"1st", "my table", "a-b", "\u00e4", "namespace"})
        sample.refuses(std::string("the namespace ") + name, {twoAxes()},
            ErrorCode::InvalidArgument, "",
            FormatSettings{{"counts-per-unit", "1000"}, {"name", name}});
}

} // namespace

class TestRapidcode : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    /// 0 / -1000 and -0 are a zero as any other.
    void aZeroHasNoSign()
    {
        for (const auto& [perUnit, row] :
            {std::pair("-1000", "0,-10,0,0\n"), std::pair("1000", "-0,10,-0,0\n")}) {
            const std::string text = test::with(oneAxisText(grid, row), "counts-per-unit = 1000",
                std::string("counts-per-unit = ") + perUnit);
            READ_TABLE(table, rapidcode::format(), text, {});
            const std::vector<double>& values = table.columns[0].values;
            QCOMPARE(values, (std::vector<double>{0, 0.01, 0, 0}));
            QVERIFY(std::ranges::none_of(values, [](double value) { return std::signbit(value); }));
        }
    }

    void theRangeIsAnIntegerMultipleOfTheDelta()
    {
        READ_TABLE(decimal, format,
            oneAxisText(
                "# input.1.min = 0\n# input.1.max = 0.3\n# input.1.delta = 0.1\n", "1,2,3,4\n"),
            {});
        QVERIFY(decimal.axes[0].knots.back() == 0.3); // 3 * 0.1 is more
    }

    void theMaximumIsTheLastPositionWithoutTheRoundingOfDoubles()
    {
        NeutralTable table = test::commandTable(
            {test::evenAxis("X", "mm", 0, 0.3, 4)}, {test::waveColumn("Z", "mm", 4, 0.5)});
        QVERIFY(table.axes[0].knots.back() < 0.9);
        for (const TableFormat* each : {&format, &headerFormat}) {
            const auto written = each->write(std::array{table}, counts("1000"));
            VERIFY_RESULT(written);
            QVERIFY(!mentions(written->bytes, "0.89999"));
            QVERIFY(written->held.front().axes[0].knots.back() == 0.9);
        }
    }

    void valuesAreRawCountsOfTheOutputAxis()
    {
        READ_TABLE(table, format, oneAxisText(grid, "0,2,-3,2500\n"), {});
        QCOMPARE(table.columns[0].values, (std::vector<double>{0, 0.002, -0.003, 2.5}));
        QCOMPARE(table.columns[0].unit, std::string("mm"));
        QVERIFY(table.sign == SignConvention::Command);
    }

    void countsWithDecimalsAreRead()
    {
        READ_TABLE(table, format, oneAxisText(grid, "0,2.5,-3,0\n"), {});
        QCOMPARE(table.columns[0].values[1], 0.0025);
    }

    void countsPerUnitComeFromTheSettingWhereTheFileIsSilent()
    {
        const std::string text = "# RapidCode compensator table\n" + grid + "0,2,-3,0\n";
        READ_TABLE(table, format, text,
            test::readingWith(
                {{"counts-per-unit", "2000"}, {"position-unit", "mm"}, {"value-unit", "um"}}));
        QCOMPARE(table.columns[0].values[1], 0.001);
        QCOMPARE(table.columns[0].unit, std::string("um"));
        QCOMPARE(table.axes[0].unit, std::string("mm"));
    }

    void theInputMustBeTheCommandPositionWhenItIsTheOutput()
    {
        NeutralTable own = twoAxes();
        own.columns[0].target = "X";
        for (const TableFormat* each : {&format, &headerFormat}) {
            const auto written = each->write(std::array{own}, counts("1000"));
            VERIFY_RESULT(written);
            QVERIFY(mentions(written->bytes, "its command position must be the input"));
            QVERIFY(mentions(joined(written->remarks), "its command position must be the input"));
            const auto cross = each->write(std::array{twoAxes()}, counts("1000"));
            VERIFY_RESULT(cross);
            QVERIFY(!mentions(cross->bytes, "must be the input"));
        }
    }

    void theHeaderCompilesAndHoldsTheTable()
    {
        static_assert(z_flatness::points == 105);
        static_assert(z_flatness::firstPoints * z_flatness::secondPoints == z_flatness::points);
        static_assert(z_flatness::firstMaximum - z_flatness::firstMinimum
            == z_flatness::firstDelta * (z_flatness::firstPoints - 1));
        TableWriteOptions options = counts("1000");
        options.settings["name"] = "z_flatness";
        const auto written = headerFormat.write(std::array{twoAxes()}, options);
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
        const auto written = headerFormat.write(std::array{table}, counts("1000"));
        VERIFY_RESULT(written);
        QVERIFY(mentions(written->bytes, "namespace compensator {"));
        QVERIFY(mentions(written->bytes, "constexpr int points = 5;"));
        QVERIFY(mentions(written->bytes, "{\n    8, 9, 1, -8, -10,\n};"));
        QVERIFY(!mentions(written->bytes, "second"));
    }
};

AXISCOMP_TEST(TestRapidcode)
AXISCOMP_FORMAT(format, describe)
AXISCOMP_FORMAT(headerFormat, describeHeader)

} // namespace tst_rapidcode

#include "tst_rapidcode.moc"
