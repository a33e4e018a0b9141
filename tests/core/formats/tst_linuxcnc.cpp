// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_checks.h"
#include "tests/support/test_registry.h"

namespace tst_linuxcnc {

using namespace axiscomp;
using test::applied;
using test::problemLines;

namespace {

const TableFamily& family = linuxcnc::format();

/// The example in the source of the controller.
const std::string example = "0.000000 0.000000 -0.001279\n0.100000 0.098742  0.051632\n"
                            "0.200000 0.171529  0.194216\n";

TableReadOptions ofType(std::string type)
{
    TableReadOptions options;
    options.settings = {{"position-unit", "mm"}, {"type", std::move(type)}};
    return options;
}

TableWriteOptions asType(std::string type)
{
    TableWriteOptions options;
    options.settings = {{"type", std::move(type)}};
    options.fileName = "x.comp";
    return options;
}

NeutralTable table(std::vector<double> knots, std::vector<double> forward,
    std::optional<std::vector<double>> reverse = std::nullopt)
{
    NeutralTable result;
    result.sign = SignConvention::Command;
    result.axes.resize(1);
    result.axes[0].unit = "mm";
    result.axes[0].knots = std::move(knots);
    result.columns.resize(reverse ? 2 : 1);
    result.columns[0].unit = "mm";
    result.columns[0].values = std::move(forward);
    if (reverse) {
        result.columns[0].direction = Direction::Positive;
        result.columns[1] = {{}, {}, "mm", Direction::Negative, std::move(*reverse), 0.0};
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

bool mentions(const std::string& text, std::string_view part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

class TestLinuxcnc : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void ofType0TheTrimIsNominalMinusMeasured()
    {
        READ_TABLE(read, family, example, ofType("0"));
        QCOMPARE(read.axes[0].knots, (std::vector<double>{0, 0.1, 0.2}));
        QCOMPARE(read.columns.size(), std::size_t(2));
        QVERIFY(read.columns[0].direction == Direction::Positive);
        QVERIFY(read.columns[1].direction == Direction::Negative);
        QCOMPARE(read.columns[0].values, (std::vector<double>{0, 0.1 - 0.098742, 0.2 - 0.171529}));
        QCOMPARE(read.columns[1].values[0], 0.001279);
    }

    void ofType1TheNumbersAreTrims()
    {
        READ_TABLE(read, family, "0 0.001 -0.002\n10 0.003 0\n", ofType("1"));
        QCOMPARE(read.columns[0].values, (std::vector<double>{0.001, 0.003}));
        QCOMPARE(read.columns[1].values, (std::vector<double>{-0.002, 0}));
    }

    void theTrimIsAddedToTheCommand()
    {
        QVERIFY(family.facts.sign == SignConvention::Command);
        QVERIFY(family.facts.signEvidence == Evidence::Code);
        READ_TABLE(read, family, example, ofType("0"));
        QVERIFY(read.sign == SignConvention::Command);
        // The axis stood at 0.098742 when it was sent to 0.1: it must be sent further.
        QVERIFY(applied(family, read, {0.1}) > 0.0);
    }

    void betweenThePointsTheTrimIsLinearAndOutsideTheEndsAreHeld()
    {
        READ_TABLE(read, family, "0 1 5\n10 3 7\n30 4 8\n", ofType("1"));
        QCOMPARE(applied(family, read, {5.0}), 2.0);
        QCOMPARE(applied(family, read, {20.0}, 1), 7.5);
        QCOMPARE(applied(family, read, {-1.0}), 1.0);
        QCOMPARE(applied(family, read, {1e9}), 4.0);
        QCOMPARE(applied(family, read, {-1.0}, 1), 5.0);
    }

    void equalDirectionsAreOneColumn()
    {
        READ_TABLE(trims, family, "0 1 1\n10 3 3\n", ofType("1"));
        QCOMPARE(trims.columns.size(), std::size_t(1));
        QVERIFY(trims.columns[0].direction == Direction::Both);
        READ_TABLE(measured, family, "0 0.1 0.1\n10 10.2 10.2\n", ofType("0"));
        QCOMPARE(measured.columns.size(), std::size_t(1));
        QCOMPARE(measured.columns[0].values[0], -0.1);
    }

    void withoutATypeItIs0WithAWarning()
    {
        TableReadOptions options;
        options.settings = {{"position-unit", "mm"}};
        const auto reading = family.read(example, options);
        VERIFY_RESULT(reading);
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::Assumption, 0));
        READ_TABLE(read, family, example, options);
        READ_TABLE(known, family, example, ofType("0"));
        COMPARE_TABLES(read, known, 0.0);
        QVERIFY(!test::hasProblem(*reading_known, DiagnosticCode::Assumption, 0));
    }

    void withoutATypeTrimsAreNotTakenForPositions()
    {
        const auto reading = family.read("0 0.001 0.001\n1 0.002 0.001\n2 0.001 0.001\n", {});
        VERIFY_RESULT(reading);
        QVERIFY(reading->tables.empty());
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::Contradiction, 2));
        QVERIFY(mentions(problemLines(*reading), "type=1"));
    }

    void aTypeThatTheNumbersContradictIsAWarning()
    {
        const auto trims = family.read("0 0.001 0.001\n1 0.002 0.003\n2 0 0.004\n", ofType("0"));
        VERIFY_RESULT(trims);
        QCOMPARE(trims->tables.size(), std::size_t(1));
        QVERIFY(test::hasProblem(*trims, DiagnosticCode::Assumption, 3));
        const auto positions = family.read(example, ofType("1"));
        VERIFY_RESULT(positions);
        QVERIFY(test::hasProblem(*positions, DiagnosticCode::Assumption, 0));
        VERIFY_ERROR(family.read(example, ofType("2")), ErrorCode::InvalidArgument);
    }

    void whatFollowsTheThirdNumberIsLeftOutWithAWarning()
    {
        const auto reading = family.read("0 1 1 ; start\n10\t3 3\n", ofType("1"));
        VERIFY_RESULT(reading);
        QCOMPARE(reading->tables.size(), std::size_t(1));
        QCOMPARE(problemLines(*reading).substr(0, 21), std::string("warning 1:7 Assumptio"));
    }

    void atMost256LinesAreRead()
    {
        READ_TABLE(read, family, lines(256), ofType("1"));
        QCOMPARE(read.pointCount(), std::size_t(256));
        const auto reading = family.read(lines(300), ofType("1"));
        VERIFY_RESULT(reading);
        QVERIFY(reading->tables.empty());
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::LimitExceeded, 257));
    }

    void theLineAtWhichTheControllerStopsIsReported_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("problem"); // the beginning of the first one
        const auto row = [](const char* name, const char* text, const char* problem) {
            QTest::newRow(name) << QByteArray(text) << QByteArray(problem);
        };
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
    }
    void theLineAtWhichTheControllerStopsIsReported() { checkProblem(); }

    void aProblemNamesItsPlace_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("problem");
        const auto row = [](const char* name, const char* text, const char* problem) {
            QTest::newRow(name) << QByteArray(text) << QByteArray(problem);
        };
        row("empty", "", "0:0 EmptyFile");
        row("blank", "\n \n\t\n", "0:0 EmptyFile");
        row("binary", "\x7f\x45\x4c\x46\x01\x01\x01", "0:0 NotText");
        row("one line", "0 1 1\n", "1:0 TooFewPoints 1 positions of the joint|at least 2");
        row("not increasing", "0 1 1\n2 1 1\n1 1 1\n", "3:0 NotMonotonic 1 after 2|strictly");
        row("duplicate", "0 1 1\n0 1 1\n1 1 1\n", "2:0 NotMonotonic 0 after 0|strictly");
        row("decreasing", "2 1 1\n1 1 1\n0 1 1\n", "2:0 NotMonotonic 1 after 2|strictly");
    }
    void aProblemNamesItsPlace() { checkProblem(); }

    void furtherProblemsAreReportedAsWell()
    {
        const auto reading = family.read("0 1 1\na\nb\n", ofType("1"));
        VERIFY_RESULT(reading);
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::Syntax, 2));
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::Syntax, 3));
    }

    void aTrimBeyondADoubleIsRefused()
    {
        const auto reading = family.read("-1e308 1e308 1e308\n0 1.1e308 1.1e308\n", ofType("0"));
        VERIFY_RESULT(reading);
        QVERIFY(reading->tables.empty());
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::NotFinite, 0));
        const NeutralTable huge = table({-1e308, 0}, {1e308, 1});
        VERIFY_ERROR(family.write(std::array{huge}, {}), ErrorCode::FormatCannotHold);
    }

    void emptyLinesAtTheEndDoNoHarm()
    {
        READ_TABLE(read, family, "0 1 1\r\n1 1 1\r\n\r\n  \r\n", ofType("1"));
        QCOMPARE(read.pointCount(), std::size_t(2));
    }

    void whatIsWrittenIsReadBackTheSame_data()
    {
        QTest::addColumn<QByteArray>("type");
        QTest::addColumn<bool>("hasDirections");
        for (const char* type : {"0", "1"})
            for (const bool hasDirections : {false, true})
                QTest::addRow("type %s, %s", type, hasDirections ? "two directions" : "one")
                    << QByteArray(type) << hasDirections;
    }
    void whatIsWrittenIsReadBackTheSame()
    {
        QFETCH(QByteArray, type);
        QFETCH(bool, hasDirections);
        std::vector<double> knots;
        std::vector<double> forward;
        std::vector<double> reverse;
        for (int i = 0; i < 256; ++i) {
            knots.push_back(-100.7 + i * 1.3 + (i % 3) * 0.01);
            forward.push_back(0.01 * std::sin(i));
            reverse.push_back(0.01 * std::cos(i));
        }
        const NeutralTable source =
            hasDirections ? table(knots, forward, reverse) : table(knots, forward);
        const auto written = family.write(std::array{source}, asType(type.toStdString()));
        VERIFY_RESULT(written);
        READ_TABLE(again, family, written->bytes, ofType(type.toStdString()));
        COMPARE_TABLES(again, source, type == "0" ? 1e-12 : 0.0);
        QVERIFY(written->held.front() == again);
    }

    void measuredPositionsAreWrittenWithoutTheDigitsOfRounding()
    {
        const NeutralTable source = table({0, 0.1, 0.2}, {0, 0.001258, 0.028471});
        const auto standard = family.write(std::array{source}, {});
        VERIFY_RESULT(standard);
        QCOMPARE(
            standard->bytes, std::string("0 0 0\n0.1 0.098742 0.098742\n0.2 0.171529 0.171529\n"));
        const auto trims = family.write(std::array{source}, asType("1"));
        VERIFY_RESULT(trims);
        QCOMPARE(
            trims->bytes, std::string("0 0 0\n0.1 0.001258 0.001258\n0.2 0.028471 0.028471\n"));
    }

    void directionsThatTurnOutEqualAreHeldAsOneColumn()
    {
        const auto written =
            family.write(std::array{table({0, 1}, {0, 0.5}, std::vector{0.0, 0.5})}, asType("1"));
        VERIFY_RESULT(written);
        QCOMPARE(written->held.front().columns.size(), std::size_t(1));
        READ_TABLE(again, family, written->bytes, ofType("1"));
        QVERIFY(written->held.front() == again);
    }

    void theRemarksAreTheLinesOfTheIniFile()
    {
        const auto written = family.write(std::array{table({0, 1}, {0, 0.5})}, asType("1"));
        VERIFY_RESULT(written);
        std::string remarks;
        for (const std::string& remark : written->remarks)
            remarks += remark + '\n';
        QVERIFY2(mentions(remarks, "COMP_FILE = x.comp"), remarks.c_str());
        QVERIFY2(mentions(remarks, "COMP_FILE_TYPE = 1"), remarks.c_str());
        QVERIFY2(mentions(remarks, "BACKLASH"), remarks.c_str());
    }

    void theMachineUnitIsWhatTheSettingSays()
    {
        TableWriteOptions options = asType("1");
        options.settings["position-unit"] = "inch";
        const auto written = family.write(std::array{table({0, 25.4}, {0, 0.0254})}, options);
        VERIFY_RESULT(written);
        QCOMPARE(written->bytes, std::string("0 0 0\n1 0.001 0.001\n"));
    }

    void aTableThatTheControllerCannotHoldIsRefused()
    {
        NeutralTable cross = table({0, 1}, {0, 0.5});
        cross.axes[0].name = "X";
        cross.columns[0].target = "Y";
        VERIFY_ERROR(family.write(std::array{cross}, {}), ErrorCode::FormatCannotHold);
        NeutralTable half = table({0, 1}, {0, 0.5}, std::vector{0.0, 0.5});
        half.columns.pop_back();
        VERIFY_ERROR(family.write(std::array{half}, {}), ErrorCode::FormatCannotHold);
        NeutralTable twice = table({0, 1}, {0, 0.5}, std::vector{0.0, 0.5});
        twice.columns[1].direction = Direction::Positive;
        VERIFY_ERROR(family.write(std::array{twice}, {}), ErrorCode::FormatCannotHold);
        std::vector<double> knots(257);
        for (std::size_t i = 0; i < knots.size(); ++i)
            knots[i] = static_cast<double>(i);
        const auto tooMany =
            checkHolds(family.facts, std::array{table(knots, std::vector<double>(257))});
        VERIFY_ERROR(tooMany, ErrorCode::FormatCannotHold);
        QVERIFY(mentions(sentence(tooMany.error()), "256"));
        VERIFY_RESULT(checkHolds(
            family.facts, std::array{table({0, 1, 5}, {0, 0, 1}, std::vector{0.0, 1.0, 0.0})}));
    }

    void aFileIsRecognisedByItsTriplets()
    {
        QCOMPARE(family.recognise(example), Recognition::Possible);
        QCOMPARE(family.recognise(example + "0.3 0.2"), Recognition::Possible); // cut off
        QCOMPARE(family.recognise("2 2 2\n0 0 1\n1 0 2\n"), Recognition::No); // softMC
        QCOMPARE(family.recognise("0 1\n1 1\n"), Recognition::No);
        QCOMPARE(family.recognise("0,1,1\n1,1,1\n"), Recognition::No);
        QCOMPARE(family.recognise("a b c\n0 1 1\n1 1 1\n"), Recognition::No);
        QCOMPARE(family.recognise(lines(257)), Recognition::No);
        QCOMPARE(family.recognise(""), Recognition::No);
    }

    void twoMegabytesOfLinesAreRefusedAsAWhole()
    {
        const auto reading = family.read(lines(150'000), ofType("1"));
        VERIFY_RESULT(reading);
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::LimitExceeded, 257));
    }

private:
    void checkProblem()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, problem);
        const auto reading = family.read(text.toStdString(), ofType("1"));
        VERIFY_RESULT(reading);
        QVERIFY(reading->tables.empty());
        const std::string found = problemLines(*reading);
        QVERIFY2(found.starts_with(problem.toStdString()), found.c_str());
    }
};

AXISCOMP_TEST(TestLinuxcnc)

} // namespace tst_linuxcnc

#include "tst_linuxcnc.moc"
