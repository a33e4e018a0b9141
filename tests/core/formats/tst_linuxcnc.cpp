// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_sample.h"
#include "tests/support/test_registry.h"

namespace tst_linuxcnc {

using namespace axiscomp;
using test::applied;

namespace {

const TableFormat& format = linuxcnc::format();

/// The example in the source of the controller.
const std::string example = "0.000000 0.000000 -0.001279\n0.100000 0.098742  0.051632\n"
                            "0.200000 0.171529  0.194216\n";

FormatSettings typeIs(std::string type)
{
    return {{"position-unit", "mm"}, {"type", std::move(type)}};
}
TableReadOptions ofType(std::string type)
{
    return test::readingWith(typeIs(std::move(type)));
}

NeutralTable table(std::vector<double> knots, std::vector<double> forward,
    std::optional<std::vector<double>> reverse = std::nullopt)
{
    NeutralTable result = test::commandTable({test::axisOf("", "mm", std::move(knots))},
        {test::columnOf("#1", "mm", std::move(forward))});
    if (reverse) {
        result.columns.resize(2);
        result.columns[0].direction = Direction::Positive;
        result.columns[1] = {{}, "#1", "mm", Direction::Negative, std::move(*reverse)};
    }
    return result;
}

std::string lines(int count)
{
    std::string text;
    for (int i = 0; i < count; ++i)
        text += std::to_string(i) + " 0.001 0.002\n";
    return text;
}

void describe(test::FormatSample& sample)
{
    sample.facts = "command is read in program code; 1 to 1 dimensions, any knots; "
                   "points 256, columns 1, tables 1, bytes 67108864; holds directions";
    sample.text = "0 1 5\n10 3 7\n30 4 8\n";
    sample.reading = ofType("1");
    sample.spareBytes = sample.text.size() - 12; // two points are a table
    sample.applies({{{5.0}, 2.0}, {{20.0}, 7.5, 1}, {{-1.0}, 1.0}, {{1e9}, 4.0}, {{-1.0}, 5.0, 1}});
    sample.recognises(Recognition::Possible, {example, example + "0.3 0.2"});
    sample.recognises(Recognition::No,
        {"2 2 2\n0 0 1\n1 0 2\n", "0 1\n1 1\n", "0,1,1\n1,1,1\n", "a b c\n0 1 1\n1 1 1\n",
            lines(257)});
    sample.warning("what follows the third number is left out", "0 1 1 ; start\n10\t3 3\n",
        {"1:7 Assumption"});
    sample.warning("trims that are read as positions", "0 0.001 0.001\n1 0.002 0.003\n2 0 0.004\n",
        {"3:0 Assumption"}, typeIs("0"));
    sample.warning("positions that are read as trims", example, {"0:0 Assumption"});
    sample.warning("no type", example, {"0:0 Assumption"}, FormatSettings{{"position-unit", "mm"}});
    sample.refusesReading("type 2", typeIs("2"), "the setting type is");
    const auto row = sample.problemRow();
    row("trims are not taken for positions", "0 0.001 0.001\n1 0.002 0.001\n2 0.001 0.001\n",
        "2:0 Contradiction a measured position that does not increase|increasing ones; if these "
        "are trims, the setting type=1",
        "", FormatSettings());
    row("a trim beyond a double", "-1e308 1e308 1e308\n0 1.1e308 1.1e308\n", "0:0 NotFinite", "",
        typeIs("0"));

    sample.writing.fileName = "x.comp";
    std::vector<double> knots;
    std::vector<double> forward;
    std::vector<double> reverse;
    for (int i = 0; i < 256; ++i) {
        knots.push_back(-100.7 + i * 1.3 + (i % 3) * 0.01);
        forward.push_back(0.01 * std::sin(i));
        reverse.push_back(0.01 * std::cos(i));
    }
    for (const char* type : {"1", "0"}) {
        const double allowance = *type == '0' ? 1e-12 : 0.0;
        sample.writes(std::string("one direction, type ") + type, {table(knots, forward)})
            .with({{"type", type}})
            .readWith(typeIs(type))
            .within(allowance);
        sample.writes(std::string("two directions, type ") + type, {table(knots, forward, reverse)})
            .with({{"type", type}})
            .readWith(typeIs(type))
            .within(allowance);
    }
    const NeutralTable measured = table({0, 0.1, 0.2}, {0, 0.001258, 0.028471});
    sample.writes("positions without the digits of rounding", {measured})
        .readWith(typeIs("0"))
        .within(1e-12)
        .as("0 0 0\n0.1 0.098742 0.098742\n0.2 0.171529 0.171529\n");
    sample.writes("trims", {measured})
        .with({{"type", "1"}})
        .as("0 0 0\n0.1 0.001258 0.001258\n0.2 0.028471 0.028471\n")
        .remarking({"COMP_FILE = x.comp", "COMP_FILE_TYPE = 1", "BACKLASH"});
    sample
        .writes("directions that turn out equal", {table({0, 1}, {0, 0.5}, std::vector{0.0, 0.5})})
        .with({{"type", "1"}})
        .becoming(table({0, 1}, {0, 0.5}));
    NeutralTable inches = table({0, 1}, {0, 0.001});
    inches.axes[0].unit = inches.columns[0].unit = "inch";
    sample.writes("inches", {table({0, 25.4}, {0, 0.0254})})
        .with({{"type", "1"}, {"position-unit", "inch"}})
        .readWith({{"type", "1"}, {"position-unit", "inch"}})
        .as("0 0 0\n1 0.001 0.001\n")
        .becoming(inches)
        .within(1e-12);

    const auto cannotHold = ErrorCode::FormatCannotHold;
    sample.refuses("a trim beyond a double", {table({-1e308, 0}, {1e308, 1})}, cannotHold);
    NeutralTable cross = table({0, 1}, {0, 0.5});
    cross.axes[0].name = "X";
    cross.columns[0].target = "Y";
    sample.refuses("another axis", {cross}, cannotHold);
    NeutralTable pair = table({0, 1}, {0, 0.5}, std::vector{0.0, 0.5});
    pair.columns[1].direction = Direction::Positive;
    sample.refuses("one direction twice", {pair}, cannotHold);
    pair.columns.pop_back();
    sample.refuses("half a pair", {pair}, cannotHold);

    row("header", "nominal forward reverse\n0 1 1\n1 1 1\n",
        "1:0 Syntax nominal forward reverse|three numbers: nominal forward reverse; the "
        "controller stops");
    row("comment", "0 1 1\n# comment\n1 1 1\n", "2:0 Syntax # comment|three numbers");
    row("empty line", "0 1 1\n\n1 1 1\n", "2:0 Syntax |three numbers");
    row("commas", "0,1,1\n1,1,1\n", "1:0 Syntax 0,1,1|three numbers");
    row("two numbers", "0 1 1\n1 1\n2 1 1\n", "2:0 Syntax 1 1|three numbers");
    row("decimal commas", "0,0 1,0 1,0\n", "1:0 Syntax 0,0 1,0 1,0|three numbers");
    row("not finite", "0 1 1\n1 nan 1\n", "2:0 Syntax 1 nan 1|three numbers");
    row("cut off", "0 1 1\n1 1 1\n2 1", "3:0 Syntax 2 1|three numbers");
    row("one line", "0 1 1\n", "1:0 TooFewPoints 1 position|at least 2");
    row("not increasing", "0 1 1\n2 1 1\n1 1 1\n", "3:0 NotMonotonic 1 after 2|strictly");
    row("duplicate", "0 1 1\n0 1 1\n1 1 1\n", "2:0 NotMonotonic 0 after 0|strictly");
    row("decreasing", "2 1 1\n1 1 1\n0 1 1\n", "2:0 NotMonotonic 1 after 2|strictly");
    row("further problems", "0 1 1\na\nb\n",
        "2:0 Syntax a|three numbers: nominal forward reverse; the controller stops reading here "
        "without a message\n3:0 Syntax b|three numbers");
}

} // namespace

class TestLinuxcnc : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void ofType0TheTrimIsNominalMinusMeasured()
    {
        READ_TABLE(read, format, example, ofType("0"));
        QCOMPARE(read.axes[0].knots, (std::vector<double>{0, 0.1, 0.2}));
        QCOMPARE(read.columns.size(), std::size_t(2));
        QVERIFY(read.columns[0].direction == Direction::Positive);
        QVERIFY(read.columns[1].direction == Direction::Negative);
        QCOMPARE(read.columns[0].values, (std::vector<double>{0, 0.1 - 0.098742, 0.2 - 0.171529}));
        QCOMPARE(read.columns[1].values[0], 0.001279);
    }

    void ofType1TheNumbersAreTrims()
    {
        READ_TABLE(read, format, "0 0.001 -0.002\n10 0.003 0\n", ofType("1"));
        QCOMPARE(read.columns[0].values, (std::vector<double>{0.001, 0.003}));
        QCOMPARE(read.columns[1].values, (std::vector<double>{-0.002, 0}));
    }

    void theTrimIsAddedToTheCommand()
    {
        READ_TABLE(read, format, example, ofType("0"));
        // The axis stood at 0.098742 when it was sent to 0.1: it must be sent further.
        QVERIFY(applied(format, read, {0.1}) > 0.0);
    }

    void equalDirectionsAreOneColumn()
    {
        READ_TABLE(trims, format, "0 1 1\n10 3 3\n", ofType("1"));
        QCOMPARE(trims.columns.size(), std::size_t(1));
        QVERIFY(trims.columns[0].direction == Direction::Both);
        READ_TABLE(measured, format, "0 0.1 0.1\n10 10.2 10.2\n", ofType("0"));
        QCOMPARE(measured.columns.size(), std::size_t(1));
        QCOMPARE(measured.columns[0].values[0], -0.1);
    }

    void withoutATypeItIs0WithAWarning()
    {
        TableReadOptions options;
        options.settings = {{"position-unit", "mm"}};
        const auto reading = format.read(example, options);
        VERIFY_RESULT(reading);
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::Assumption, 0));
        READ_TABLE(read, format, example, options);
        READ_TABLE(known, format, example, ofType("0"));
        COMPARE_TABLES(read, known, 0.0);
        QVERIFY(!test::hasProblem(*reading_known, DiagnosticCode::Assumption, 0));
    }

    void atMost256LinesAreRead()
    {
        READ_TABLE(read, format, lines(256), ofType("1"));
        QCOMPARE(read.pointCount(), std::size_t(256));
        const auto reading = format.read(lines(300), ofType("1"));
        VERIFY_RESULT(reading);
        QVERIFY(reading->tables.empty());
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::LimitExceeded, 257));
    }

    void twoMegabytesOfLinesAreRefusedAsAWhole()
    {
        const auto reading = format.read(lines(150'000), ofType("1"));
        VERIFY_RESULT(reading);
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::LimitExceeded, 257));
    }
};

AXISCOMP_TEST(TestLinuxcnc)
AXISCOMP_FORMAT(format, describe)

} // namespace tst_linuxcnc

#include "tst_linuxcnc.moc"
