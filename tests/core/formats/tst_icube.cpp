// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/core/formats/format_checks.h"
#include "tests/support/test_registry.h"

namespace tst_icube {

using namespace axiscomp;
using test::applied;
using test::problemLines;

namespace {

const TableFamily& family = icube::format();

/// The example of the manual.
const std::string example = "0.00 0.001\n0.25 0.001\n0.50 0.001\n1.00 0.002\n5.00 0.002\n"
                            "7.00 0.001\n8.00 0.000\n9.00 -0.001\n9.25 -0.002\n10.00 0.001\n";

TableReadOptions inMillimetres()
{
    TableReadOptions options;
    options.settings = {{"position-unit", "mm"}};
    return options;
}

TableReadOptions rotary(std::string range)
{
    TableReadOptions options;
    options.settings = {{"position-unit", "deg"}, {"wrap-range", std::move(range)}};
    return options;
}

NeutralTable table(std::vector<double> knots, std::vector<double> values)
{
    NeutralTable result;
    result.sign = SignConvention::Command;
    result.axes.resize(1);
    result.axes[0].unit = "mm";
    result.axes[0].knots = std::move(knots);
    result.columns.resize(1);
    result.columns[0].unit = "mm";
    result.columns[0].values = std::move(values);
    return result;
}

bool mentions(const std::string& text, std::string_view part)
{
    return text.find(part) != std::string::npos;
}

} // namespace

class TestIcube : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void theExampleOfTheManualIsRead()
    {
        READ_TABLE(read, family, example, inMillimetres());
        QCOMPARE(read.axes[0].knots, (std::vector<double>{0, 0.25, 0.5, 1, 5, 7, 8, 9, 9.25, 10}));
        QCOMPARE(read.columns[0].values,
            (std::vector<double>{
                0.001, 0.001, 0.001, 0.002, 0.002, 0.001, 0, -0.001, -0.002, 0.001}));
        QCOMPARE(read.axes[0].unit, std::string("mm"));
        QCOMPARE(read.columns[0].unit, std::string("mm"));
    }

    void theOffsetIsAddedToTheCommand()
    {
        QVERIFY(family.facts.sign == SignConvention::Command);
        READ_TABLE(read, family, example, inMillimetres());
        QVERIFY(read.sign == SignConvention::Command);
    }

    void betweenThePointsTheOffsetIsLinear()
    {
        READ_TABLE(read, family, example, inMillimetres());
        QCOMPARE(applied(family, read, {6.0}), 0.0015);
        QCOMPARE(applied(family, read, {8.5}), -0.0005);
    }

    void outsideOfTheTableTheOffsetAtTheEndIsHeld()
    {
        READ_TABLE(read, family, "-4 0.004\n0 0\n10 0.001\n", inMillimetres());
        QCOMPARE(applied(family, read, {-5.0}), 0.004);
        QCOMPARE(applied(family, read, {1e6}), 0.001);
        READ_TABLE(manual, family, example, inMillimetres());
        QCOMPARE(applied(family, manual, {-3.999}), 0.001);
        QCOMPARE(applied(family, manual, {-4.00}), 0.001);
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
        row("byte-order mark",
            "\xEF\xBB\xBF"
            "0,0.25\n1,-0.25\n");
        row("empty lines", "\n0,0.25\n\n1,-0.25\n\n");
    }
    void everySeparatorIsRead()
    {
        QFETCH(QByteArray, text);
        READ_TABLE(read, family, text.toStdString(), inMillimetres());
        QCOMPARE(read.axes[0].knots, (std::vector<double>{0, 1}));
        QCOMPARE(read.columns[0].values, (std::vector<double>{0.25, -0.25}));
    }

    void leadingLinesThatAreNotTwoNumbersAreHeaders()
    {
        const auto reading =
            family.read("Axis1, compensation\nMaster;Offset\n0,0.1\n1,0.2\n", inMillimetres());
        VERIFY_RESULT(reading);
        QCOMPARE(problemLines(*reading), std::string());
        QCOMPARE(reading->tables.front().pointCount(), std::size_t(2));
    }

    void aHeaderThatMayBeAPointIsReported()
    {
        const auto reading = family.read("0,0.1,7\n1,0.1\n2,0.2\n", inMillimetres());
        VERIFY_RESULT(reading);
        QCOMPARE(reading->tables.size(), std::size_t(1));
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::Assumption, 1));
    }

    void decreasingPositionsAreReadAscending()
    {
        READ_TABLE(read, family, "10,0.3\n4,0.2\n0,0.1\n", inMillimetres());
        QCOMPARE(read.axes[0].knots, (std::vector<double>{0, 4, 10}));
        QCOMPARE(read.columns[0].values, (std::vector<double>{0.1, 0.2, 0.3}));
    }

    void aRotaryAxisSpansItsWrapRangeExactly()
    {
        READ_TABLE(read, family, "0,0.1\n100,0.2\n360,0.1\n", rotary("360"));
        QCOMPARE(read.axes[0].wrap, std::optional<double>(360.0));
        QCOMPARE(applied(family, read, {-310.0}), 0.15);
        QCOMPARE(applied(family, read, {820.0}), 0.2);
        READ_TABLE(down, family, "180,0.1\n0,0.2\n-180,0.1\n", rotary("360"));
        QCOMPARE(applied(family, down, {360.0}), 0.2);
    }

    void aWrapRangeThatIsNoneIsRefused()
    {
        VERIFY_ERROR(family.read("0,0\n1,0\n", rotary("0")), ErrorCode::InvalidArgument);
        VERIFY_ERROR(family.read("0,0\n1,0\n", rotary("-1")), ErrorCode::InvalidArgument);
        VERIFY_ERROR(family.read("0,0\n1,0\n", rotary("all")), ErrorCode::InvalidArgument);
    }

    void aProblemNamesItsPlaceAndTheNumberOfTheController_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("problem"); // the beginning of the first one
        QTest::addColumn<QByteArray>("number");
        const auto row = [](const char* name, const char* text, const char* problem,
                             const char* number = "#4900") {
            QTest::newRow(name) << QByteArray(text) << QByteArray(problem) << QByteArray(number);
        };
        row("empty", "", "0:0 EmptyFile", "");
        row("blank", " \n\t\n", "0:0 EmptyFile", "");
        row("binary", "\x01\x02\x03\x04\x05\x06", "0:0 NotText", "");
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
        row("turns up", "5,0\n0,0\n1,0\n",
            "3:0 NotMonotonic 1 after 0|strictly decreasing positions");
        row("sum turns", "0,0.5\n1,0.25\n2,-1\n",
            "3:0 NotMonotonic position + offset 1 after 1.25|strictly increasing");
        row("sum stands", "0,0\n1,-1\n", "2:0 NotMonotonic position + offset 0 after 0|strictly");
        row("sum of decreasing positions turns", "2,0\n1,1.5\n0,0\n",
            "2:0 NotMonotonic position + offset 2.5 after 2|strictly decreasing");
    }
    void aProblemNamesItsPlaceAndTheNumberOfTheController()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, problem);
        QFETCH(QByteArray, number);
        const auto reading = family.read(text.toStdString(), inMillimetres());
        VERIFY_RESULT(reading);
        QVERIFY(reading->tables.empty());
        const std::string found = problemLines(*reading);
        QVERIFY2(found.starts_with(problem.toStdString()), found.c_str());
        const std::string line = found.substr(0, found.find('\n'));
        QVERIFY2(line.ends_with(number.toStdString()), line.c_str());
        QCOMPARE(mentions(line, "#"), !number.isEmpty());
    }

    void aRotaryTableThatDoesNotCloseHasTheNumber4902_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("problem");
        QTest::newRow("too short") << QByteArray("0,0\n359.999,0\n")
                                   << QByteArray("positions from 0 to 359.999|a span of exactly "
                                                 "360");
        QTest::newRow("too long") << QByteArray("0,0\n361,0\n")
                                  << QByteArray("positions from 0 to 361");
        QTest::newRow("other offset") << QByteArray("0,0\n180,1\n360,0.001\n")
                                      << QByteArray("the offsets 0 and 0.001 at the ends");
    }
    void aRotaryTableThatDoesNotCloseHasTheNumber4902()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, problem);
        const auto reading = family.read(text.toStdString(), rotary("360"));
        VERIFY_RESULT(reading);
        QVERIFY(reading->tables.empty());
        const auto line = static_cast<std::size_t>(text.count('\n'));
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::NotPeriodic, line, "4902"));
        QVERIFY(mentions(problemLines(*reading), problem.toStdString()));
    }

    void furtherProblemsAreReportedAsWell()
    {
        const auto reading = family.read("0,0\n1,a\n2\n3,b\n", inMillimetres());
        VERIFY_RESULT(reading);
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::NotANumber, 2, "4900"));
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::ColumnCount, 3, "4900"));
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::NotANumber, 4, "4900"));
    }

    void aFileOfOneMegabyteIsTooLarge()
    {
        std::string text;
        for (int i = 0; text.size() < 1'000'000; ++i)
            text += std::to_string(i) + ",0.00001\n";
        const auto reading = family.read(text, inMillimetres());
        VERIFY_RESULT(reading);
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::TooLarge, 0));
        text.resize(text.rfind('\n', 999'000) + 1);
        READ_TABLE(read, family, text, inMillimetres());
        QVERIFY(read.pointCount() > 50'000);

        const auto written =
            family.write(std::array{table(evenKnots(60'000), std::vector(60'000, 1e-3 / 3))}, {});
        VERIFY_ERROR(written, ErrorCode::FormatCannotHold);
        QVERIFY(mentions(sentence(written.error()), "999999"));
    }

    void aUnitThatNobodySaysIsAWarning()
    {
        const auto reading = family.read(example, {});
        VERIFY_RESULT(reading);
        QCOMPARE(reading->tables.size(), std::size_t(1));
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::UnitNotGiven, 0));
    }

    void positionsAndOffsetsHaveOneUnit()
    {
        TableReadOptions options;
        options.settings = {{"position-unit", "mm"}, {"value-unit", "um"}};
        const auto reading = family.read(example, options);
        VERIFY_RESULT(reading);
        QVERIFY(test::hasProblem(*reading, DiagnosticCode::Contradiction, 0));
        TableWriteOptions writing;
        writing.settings = options.settings;
        VERIFY_ERROR(
            family.write(std::array{table({0, 1}, {0, 0})}, writing), ErrorCode::InvalidArgument);
    }

    void whatIsWrittenIsReadBackTheSame()
    {
        const NeutralTable uneven = table({-7.5, 0, 0.1, 3, 1000.125}, {0.1, -0.02, 0, 1e-7, 0.3});
        const auto written = family.write(std::array{uneven}, {});
        VERIFY_RESULT(written);
        QCOMPARE(
            written->bytes, std::string("-7.5,0.1\n0,-0.02\n0.1,0\n3,0.0000001\n1000.125,0.3\n"));
        READ_TABLE(again, family, written->bytes, inMillimetres());
        COMPARE_TABLES(again, uneven, 0.0);
        QVERIFY(written->held.front() == again);
    }

    void whatIsHeldIsWhatTheReaderGivesBack()
    {
        NeutralTable named = table({0, 90, 360}, {0.5, 2, 0.5});
        named.name = "C axis";
        named.notes = {"measured"};
        named.axes[0].name = "C";
        named.axes[0].unit = "deg";
        named.axes[0].wrap = 360;
        named.columns[0].name = "Table 1";
        named.columns[0].target = "C";
        named.columns[0].unit = "mdeg";
        const auto written = family.write(std::array{named}, {});
        VERIFY_RESULT(written);
        QCOMPARE(written->bytes, std::string("0,0.0005\n90,0.002\n360,0.0005\n"));
        READ_TABLE(again, family, written->bytes, rotary("360"));
        QVERIFY(written->held.front() == again);
    }

    void theRemarksSayTheNameOfTheFileAndTheUnit()
    {
        NeutralTable named = table({0, 1}, {0, 0.001});
        named.axes[0].name = named.columns[0].target = "Axis1";
        const auto written = family.write(std::array{named}, {});
        VERIFY_RESULT(written);
        std::string remarks;
        for (const std::string& remark : written->remarks)
            remarks += remark + '\n';
        QVERIFY2(mentions(remarks, "Axis1PosComp.CSV"), remarks.c_str());
        QVERIFY2(mentions(remarks, "in mm"), remarks.c_str());
    }

    void theUserUnitsAreWhatTheSettingSays()
    {
        TableWriteOptions options;
        options.settings = {{"position-unit", "um"}};
        const auto written = family.write(std::array{table({0, 1}, {0, 0.5})}, options);
        VERIFY_RESULT(written);
        QCOMPARE(written->bytes, std::string("0,0\n1000,500\n"));
        options.settings = {{"position-unit", "m"}};
        const auto small = family.write(std::array{table({0, 2.3}, {0, 0.7})}, options);
        VERIFY_RESULT(small);
        QCOMPARE(small->bytes, std::string("0,0\n0.0023,0.0007\n")); // and no digits more
        options.settings = {{"position-unit", "deg"}};
        VERIFY_ERROR(
            family.write(std::array{table({0, 1}, {0, 0.5})}, options), ErrorCode::InvalidArgument);
    }

    void aTableThatTheControllerRefusesIsNotWritten_data()
    {
        QTest::addColumn<QByteArray>("what");
        QTest::addColumn<QByteArray>("reason");
        QTest::newRow("position + offset turns") << QByteArray("turn") << QByteArray("4900");
        QTest::newRow("cross compensation") << QByteArray("cross") << QByteArray("X to Y");
        QTest::newRow("not a whole revolution") << QByteArray("open") << QByteArray("4902");
        QTest::newRow("ends differ") << QByteArray("ends") << QByteArray("4902");
    }
    void aTableThatTheControllerRefusesIsNotWritten()
    {
        QFETCH(QByteArray, what);
        QFETCH(QByteArray, reason);
        NeutralTable refused = table({0, 180, 360}, {0, 1, 0});
        if (what == "turn")
            refused.columns[0].values = {0, -180, 0};
        if (what == "cross") {
            refused.axes[0].name = "X";
            refused.columns[0].target = "Y";
        }
        if (what == "open" || what == "ends")
            refused.axes[0].wrap = what == "open" ? 361 : 360;
        if (what == "ends")
            refused.columns[0].values[2] = 0.1;
        const auto written = family.write(std::array{refused}, {});
        VERIFY_ERROR(written, ErrorCode::FormatCannotHold);
        const std::string text = sentence(written.error());
        QVERIFY2(mentions(text, reason.toStdString()), text.c_str());
    }

    void theWrapRangeOfTheSettingMustBeThatOfTheTable()
    {
        NeutralTable closed = table({0, 180, 360}, {0, 1, 0});
        TableWriteOptions options;
        options.settings = {{"wrap-range", "360"}};
        const auto written = family.write(std::array{closed}, options);
        VERIFY_RESULT(written);
        QCOMPARE(written->held.front().axes[0].wrap, std::optional<double>(360.0));
        closed.axes[0].wrap = 720;
        VERIFY_ERROR(family.write(std::array{closed}, options), ErrorCode::InvalidArgument);
        options.settings = {{"wrap-range", "0"}};
        VERIFY_ERROR(family.write(std::array{closed}, options), ErrorCode::InvalidArgument);
    }

    void whatTheFactsRefuseIsRefused()
    {
        NeutralTable plane = table({0, 1}, {0, 0, 0, 0});
        plane.axes.push_back(plane.axes[0]);
        VERIFY_ERROR(checkHolds(family.facts, std::array{plane}), ErrorCode::FormatCannotHold);
        NeutralTable both = table({0, 1}, {0, 0});
        both.columns.push_back(both.columns[0]);
        both.columns[0].direction = Direction::Positive;
        both.columns[1].direction = Direction::Negative;
        VERIFY_ERROR(checkHolds(family.facts, std::array{both}), ErrorCode::FormatCannotHold);
        VERIFY_RESULT(checkHolds(family.facts, std::array{table({0, 1, 5}, {0, 0, 0})}));
    }

    void aFileIsRecognisedByItsPairs()
    {
        QCOMPARE(family.recognise(example), Recognition::Possible);
        QCOMPARE(family.recognise("Master,Offset\n0,1\n1,1\n"), Recognition::Possible);
        QCOMPARE(family.recognise(example + "11.0"), Recognition::Possible); // cut off
        QCOMPARE(family.recognise("0 1 2\n1 1 2\n"), Recognition::No);
        QCOMPARE(family.recognise("1 3\n0 0.1\n1 0.1\n2 0.1\n"), Recognition::No); // softMC
        QCOMPARE(family.recognise("0,1\n"), Recognition::No);
        QCOMPARE(family.recognise("a\nb\nc\nd\ne\nf\n0,1\n1,1\n"), Recognition::No);
        QCOMPARE(family.recognise(""), Recognition::No);
    }

    void readingCanBeStopped()
    {
        std::stop_source stop;
        stop.request_stop();
        TableReadOptions options = inMillimetres();
        options.stop = stop.get_token();
        const auto reading = family.read(example, options);
        VERIFY_RESULT(reading);
        QVERIFY(reading->cancelled && reading->tables.empty());
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

} // namespace tst_icube

#include "tst_icube.moc"
