// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/judge/iso230.h"
#include "tests/core/metrology/measurement_reading.h"
#include "tests/support/test_registry.h"

#include <array>
#include <cmath>

namespace tst_measurementproblems {

using namespace axiscomp;

namespace {

const std::string head = "target [mm],direction,run,deviation [um]\n";

/// A Renishaw file of two targets with these lines of deviations.
std::string rtl(const std::string& deviations, const std::string& counts = "2 2",
    const std::string& type = "rtl")
{
    const std::size_t blank = counts.find(' ');
    return "HEADER::\nFile type: " + type + "\nTARGET DATA::\nTarget-count: "
        + counts.substr(0, blank) + "\nTargets : 0 90\nFlags: 0 0 2 0\nRUNS::\nRun-count: "
        + counts.substr(blank + 1) + "\nDEVIATIONS::\nRun Target Data:\n" + deviations + "EOF::\n";
}

/// One with these lines of targets.
std::string rtlOf(const std::string& targets, const std::string& deviations)
{
    return "HEADER::\nFile type: rtl\nTARGET DATA::\n" + targets
        + "Flags: 0 0 2 0\nDEVIATIONS::\nRun Target Data:\n" + deviations + "EOF::\n";
}

} // namespace

class tst_MeasurementProblems : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void everyErrorIsNamedWithItsPlace_data()
    {
        QTest::addColumn<QString>("format");
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArrayList>("expected"); // beginnings
        const auto row = [](const char* name, const char* format, const std::string& text,
                             const QByteArrayList& expected) {
            QTest::newRow(name) << QString::fromLatin1(format) << QByteArray::fromStdString(text)
                                << expected;
        };
        row("no values", "runs", "target [mm],direction,run\n0,+,1\n",
            {"1:0 MissingColumn neither deviation nor reference|either a column deviation"});
        row("both values", "runs", "target [mm],direction,deviation [um],reference [mm]\n0,+,1,1\n",
            {"1:0 MissingColumn both deviation and reference|"});
        row("two of a kind", "runs", "target [mm],direction,error [um],value [um]\n0,+,1,1\n",
            {"1:4 MissingColumn two columns for deviation|one; name the columns with --columns"});
        row("points that may be between thousands", "runs",
            "target [mm];direction;deviation [um]\n0;+;1\n500;+;1\n1.000;+;1\n",
            {"4:1 MixedDecimals 1.000 in a column with 500|numbers that show whether the point"});
        row("no direction", "runs", "target [mm],deviation [um]\n0,1\n1,1\n",
            {"1:0 MissingColumn no column direction|a column direction with + and -, or "
             "--direction-from order"});
        row("no units", "runs", "target,direction,deviation\n0,+,1\n1,+,1\n",
            {"1:1 UnitMissing column target|a unit in brackets behind the name, such as target "
             "[mm]",
                "1:3 UnitMissing column deviation|"});
        row("unknown unit", "runs", "target [mm],direction,deviation [furlong]\n0,+,1\n",
            {"1:3 UnitMissing the unit furlong of column deviation|a length or an angle"});
        row("length and angle", "runs", "target [deg],direction,deviation [um]\n0,+,1\n1,+,1\n",
            {"1:3 UnitMixed column deviation|an angle as the targets are"});
        row("a length and an angle as axes", "points", "X [mm],Y [deg],dX [um]\n0,0,1\n1,0,1\n",
            {"1:2 UnitMixed column Y|a length as the first axis has"});
        row("an angle and a length as axes", "points", "X [deg],Y [mm],dX [arcsec]\n0,0,1\n1,0,1\n",
            {"1:2 UnitMixed column Y|an angle as the first axis has"});
        row("no temperature", "runs",
            "target [mm],direction,deviation [um],temperature [mK]\n0,+,1,291150\n1,+,1,291150\n",
            {"1:4 Syntax temperature [mK]|a temperature in C, K or F"});
        row("kelvin without a unit", "runs",
            "target [mm],direction,deviation [um],temperature\n0,+,1,291.15\n1,+,1,20\n",
            {"2:4 Syntax 291.15|a temperature in C, K or F"});
        row("deg C with the unit of kelvin", "runs",
            "target [mm],direction,deviation [um],temperature [K]\n0,+,1,20\n1,+,1,293\n",
            {"2:4 Syntax 20|a temperature in C, K or F"});
        row("a machine at 291 deg C", "runs", "// material temperature: 291\n" + head + "0,+,1,1\n",
            {"1:0 Syntax 291|a temperature in deg C"});
        row("no time", "runs", "target [mm],direction,deviation [um],time [d]\n0,+,1,1\n1,+,1,2\n",
            {"1:4 Syntax time [d]|a time in s, ms, min or h"});
        row("bad direction", "runs", head + "0,sideways,1,1\n1,+,1,1\n",
            {"2:2 BadDirection sideways|+ or -, up or down, forward or backward"});
        row("bad run", "runs", head + "0,+,0,1\n1,+,1.5,1\n2,+,x,1\n",
            {"2:3 BadRun 0|a whole number from 1", "3:3 BadRun 1.5|", "4:3 BadRun x|"});
        row("a value twice", "runs", head + "0,+,1,1\n5,+,1,1\n0.0,up,1,2\n",
            {"4:0 DuplicateValue target 0 mm, up, run 1 in line 2 and in line 4|one value "
             "for each target, direction and run, or a number for each run"});
        row("a mean twice", "runs", "// kind: averages\n" + head + "0,+,1,1\n5,+,1,1\n0,+,2,2\n",
            {"5:0 DuplicateValue target 0 mm, up, run 2 in line 3 and in line 5|one mean for each "
             "target and direction"});
        row("a block of means twice", "api-pos",
            "Position Forward Directional Avg Error\n0 0.001\n9 0.002\n"
            "Position Reverse Directional Avg Error\n0 0.001\n9 0.002\n"
            "Position Forward Directional Avg Error\n0 0.001\n",
            {"8:0 DuplicateValue target 0 mm, up, run 1 in line 2 and in line 8|one mean"});
        row("no kind", "runs", "// kind: means\n" + head + "0,+,1,1\n1,+,1,1\n",
            {"1:0 Syntax means|kind: runs, or kind: averages"});
        row("two kinds", "runs", "// kind: averages\n// kind: runs\n" + head + "0,+,1,1\n1,+,1,1\n",
            {"2:0 Contradiction kind: runs, and kind: averages in line 1|one statement of it"});
        row("one target", "runs", head + "5,+,1,1\n5,+,2,1\n5,-,1,1\n",
            {"0:0 TooFewTargets 1 target|at least 2 different positions"});
        row("no lines", "runs", head, {"0:0 TooFewTargets 0 targets|"});
        row("words", "runs", head + "0,+,1,abc\n1,+,1,1\n", {"2:4 NotANumber abc|"});
        row("short line", "runs", head + "0,+,1\n1,+,1,1\n", {"2:0 ColumnCount 3 columns|4 as in"});
        row("not a state", "runs", "// compensation: perhaps\n" + head + "0,+,1,1\n1,+,1,1\n",
            {"1:0 Syntax perhaps|compensation: off, on, or crc:"});
        row("not a sign", "runs", "// sign: minus\n" + head + "0,+,1,1\n1,+,1,1\n",
            {"1:0 Syntax minus|sign: deviation"});
        row("a sign behind the values", "runs", head + "0,+,1,1\n1,+,1,1\n// sign: correction\n",
            {"4:0 Syntax sign: correction|this statement before the header"});
        row("a sign between the values", "runs",
            "// sign: correction\n" + head + "0,+,1,1\n// Sign: Deviation\n1,+,1,1\n",
            {"4:0 Syntax sign: Deviation|this statement before the header"});
        row("a sign within columns of runs", "wide",
            "// values: deviation\ntarget [mm],up1 [um]\n0,1\n// sign: correction\n1,1\n",
            {"4:0 Syntax sign: correction|this statement before the header"});
        row("a sign behind points", "points",
            "X [mm],Y [mm],dX [um]\n0,0,1\n1,0,1\n// sign: correction\n",
            {"4:0 Syntax sign: correction|this statement before the header"});
        row("a sign of positions", "runs",
            "// sign: correction\ntarget [mm],direction,reference [mm]\n0,+,0.001\n9,+,9.002\n",
            {"1:0 Contradiction sign: correction, and positions of the reference|no sign with"});
        row("a sign behind positions", "runs",
            "target [mm],direction,reference [mm]\n0,+,0.001\n9,+,9.002\n// sign: correction\n",
            {"4:0 Contradiction sign: correction, and positions of the reference|no sign with"});
        row("a sign of columns of positions", "wide",
            "// values: reference\n// sign: correction\ntarget [mm],up1 [mm]\n0,0.001\n9,9.002\n",
            {"2:0 Contradiction sign: correction, and positions of the reference|no sign with"});
        row("a sign of points of the reference", "points",
            "// sign: correction\nX [mm],Y [mm],Xr [mm]\n0,0,0.001\n9,0,9.002\n",
            {"1:0 Contradiction sign: correction, and positions of the reference|no sign with"});
        row("positions, which is said behind them", "runs",
            "target [mm],direction,value [mm]\n0,+,0\n10,+,10\n// values: reference\n",
            {"4:0 Syntax values: reference|this statement before the header"});
        row("positions, which is said between them", "wide",
            "// values: deviation\ntarget [mm],up1 [mm]\n0,0\n// values: reference\n10,10\n",
            {"4:0 Syntax values: reference|this statement before the header"});
        row("a kind behind the values", "wide",
            "target [mm],up1 [um]\n0,1\n1,1\n// values: deviation\n",
            {"1:0 MissingColumn columns of runs that are either deviations or positions|which it "
             "is: // values: deviation or // values: reference before the header"});
        const std::string ofAxes = "axis,target [mm],direction,deviation [um]\n";
        row("lines of two axes", "runs", ofAxes + "X,0,+,1\nx,9,+,2\nY,0,+,11\nY,9,+,12\n",
            {"4:1 Contradiction axis Y, and axis X in line 2|the measurement of one axis; make"});
        row("lines of two numbers of axes", "wide",
            "// values: deviation\ntarget [mm],axis,up1 [um]\n0,1,1\n9,,1\n0,2,1\n",
            {"5:2 Contradiction axis 2, and axis 1 in line 3|"});
        row("points of two axes", "points", "X [mm],Y [mm],axis,dX [um]\n0,0,X,1\n9,0,Y,1\n",
            {"3:3 Contradiction axis Y, and axis X in line 2|"});
        row("lines of another axis", "runs", "// axis: X\n" + ofAxes + "Y,0,+,1\nY,9,+,2\n",
            {"3:1 Contradiction axis Y, and axis X in line 1|"});
        row("another axis behind the lines", "runs", ofAxes + "Y,0,+,1\nY,9,+,2\n// axis: X\n",
            {"4:0 Contradiction axis X, and axis Y in line 2|"});
        row("two statements", "runs",
            "// axis: X\n// sign: deviation\n// axis: Y\n" + head + "0,+,1,1\n1,+,1,1\n",
            {"3:0 Contradiction axis: Y, and axis: X in line 1|one statement of it"});
        row("not a kind", "wide", "target [mm],up1 [um],down1 [um]\n0,1,1\n1,1,1\n",
            {"1:0 MissingColumn columns of runs that are either deviations or positions|which it "
             "is: // values:"});
        row("wide without a unit", "wide", "// values: deviation\ntarget_mm,up1\n0,1\n1,1\n",
            {"2:2 UnitMissing column up1|"});
        row("other count of targets", "renishaw", rtl("1 1 1\n1 2 1\n2 2 1\n2 1 1\n", "3 2"),
            {"4:0 CountMismatch Target-count: 3, but 2 are there|"});
        row("other count of runs", "renishaw", rtl("1 1 1\n1 2 1\n2 2 1\n2 1 1\n", "2 4"),
            {"8:0 CountMismatch Run-count: 4, but 2 are there|"});
        row("unknown target", "renishaw", rtl("1 1 1\n1 2 1\n2 3 1\n2 1 1\n"),
            {"13:3 UnknownTargetNumber 3|a number from 1 to 2"});
        row("a run without a direction", "renishaw", rtl("1 1 1\n1 2 1\n1 1 2\n2 1 1\n2 2 1\n"),
            {"11:0 BadDirection 1|a run whose target"});
        row("not of the type", "renishaw", rtl("1 1 1\n1 2 1\n2 2 1\n2 1 1\n", "2 2", "rts"),
            {"0:0 Syntax rts|File type: rtl or rta"});
        // 0 and 25.31 mm with decimal commas, or 0, 0, 25 and 31: nothing says which.
        row("a decimal comma", "renishaw", rtlOf("Targets : 0,0  25,3100\n", "1 1 1\n1 2 1\n"),
            {"4:11 Syntax 0,0|positions with a decimal point",
                "4:0 CountMismatch 4 targets, but deviations of 2|", "4:0 Syntax"});
        row("a decimal comma beside a count", "renishaw",
            rtlOf("Target-count: 2\nTargets : 0 25,3100\n", "1 1 1\n1 2 1\n"),
            {"4:0 CountMismatch Target-count: 2, but 3 are there|"});
        row("a target without a value", "renishaw",
            rtlOf("Targets : 0 25 3100\n", "1 1 1\n1 2 1\n"),
            {"4:0 CountMismatch 3 targets, but deviations of 2|a deviation of every target"});
        row("targets out of order", "renishaw",
            rtlOf("Target-count: 3\nTargets : 0 50 25\n", "1 1 1\n1 2 1\n1 3 1\n"), {"5:0 Syntax"});
        row("only means of both", "api-pos", "Position Bidirectional Avg Error\n0 1\n1 1\n",
            {"0:0 Syntax no block of a direction|"});
        const std::string both = "Position Bidirectional Avg Error\n0 0.001\n500 0.001\n";
        const std::string forward = "Position Forward Directional Avg Error\n0 0.001\n500 0.002\n";
        row("signs between the thousands", "api-pos", both + "1,000.0 0.001\n" + forward,
            {"4:0 Syntax 1,000.0 0.001|a position and an error in mm, with decimal points"});
        row("decimal commas", "api-pos",
            "Position Forward Directional Avg Error\n0,0 0,1\n9,0 0,1\n",
            {"2:0 Syntax 0,0 0,1|", "3:0 Syntax 9,0 0,1|"});
        row("three columns", "api-pos", both + forward + "900 0.1 .1\n-.5* 0\n",
            {"7:0 Syntax 900 0.1 .1|", "8:0 Syntax -.5* 0|"});
        row("a mean of both alone", "api-pos", both + "900 0.001\n" + forward,
            {"4:0 CountMismatch a position without a forward mean|the same positions in both"});
        row("another unit", "api-pos", "Units: mm\nUnits: inch\n" + forward,
            {"2:0 UnitMissing Units: inch|mm, or both units stated",
                "4:0 CountMismatch a position without a bidirectional mean|",
                "5:0 CountMismatch a position without a bidirectional mean|"});
        row("cycles", "ecmc",
            "CYCLES=2\nTGT_DATA[1]=0\nTGT_DATA[2]=1\nREF_DATA_FWD[1,1]=0\nREF_DATA_FWD[2,1]=1\n",
            {"0:0 CountMismatch CYCLES: 2, but 1 are there|"});
        row("no such target", "ecmc",
            "TGT_DATA[1]=0\nTGT_DATA[2]=1\nREF_DATA_FWD[1,1]=0\nREF_DATA_FWD[3,1]=1\n",
            {"4:0 UnknownTargetNumber 3|"});
        row("short track", "track", "encoder [mm],reference [mm]\n0,0\n1,1\n",
            {"0:0 TooFewPoints 2 samples|at least 20 samples"});
        row("a workbook", "runs", "PK\x03\x04 and so on", {"0:0 NotText a spreadsheet workbook"});
    }
    void everyErrorIsNamedWithItsPlace()
    {
        QFETCH(const QString, format);
        QFETCH(const QByteArray, text);
        QFETCH(const QByteArrayList, expected);
        const MeasurementReading reading = test::readAs(format.toStdString(), text.toStdString());
        const QByteArrayList found = test::describe(reading);
        QVERIFY(!reading.measurement);
        QVERIFY(reading.hasErrors());
        QVERIFY2(found.size() == expected.size(), found.join('\n').constData());
        for (qsizetype i = 0; i < found.size(); ++i)
            QVERIFY2(found[i].startsWith(expected[i]), found.join('\n').constData());
        for (const Diagnostic& diagnostic : reading.diagnostics)
            QVERIFY2(message(diagnostic).ends_with(')'), message(diagnostic).c_str());
    }

    void everyDoubtIsAWarning_data()
    {
        QTest::addColumn<QString>("format");
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("expected");
        const auto row = [](const char* name, const std::string& text, const char* expected,
                             const char* format = "runs") {
            QTest::newRow(name) << QString::fromLatin1(format) << QByteArray::fromStdString(text)
                                << QByteArray(expected);
        };
        row("incomplete", head + "0,+,1,1\n9,+,1,2\n9,+,2,3\n",
            "0:0 IncompleteRuns no value for up:1:2|a value for every target in every run");
        row("unequal", head + "0,+,1,1\n9,+,1,2\n0,+,2,3\n9,+,2,3\n9,-,1,1\n0,-,1,1\n",
            "0:0 UnequalRuns 2 up and 1 down|as many in each direction");
        row("positions",
            "target [mm],direction,run,deviation [mm]\n0,+,1,0.001\n10,+,1,10\n20,+,1,19.999\n",
            "0:0 ValuesLookLikePositions values that rise by 0.9999 with the target|deviations");
        row("too large", head + "0,+,1,1\n10,+,1,150\n",
            "0:0 UnitSuspicious a largest deviation "
            "of 0.15 mm over 10 mm|at most 1 % of "
            "the travel");
        row("too small", head + "0,+,1,1e-6\n10,+,1,0\n",
            "0:0 UnitSuspicious a largest deviation of 1e-09 mm over 10 mm|more than a billionth");
        row("positions at points",
            "X [mm],Y [mm],dX [um],dY [mm]\n0,0,1,0.001\n10,0,2,0\n0,20,1,20\n10,20,2,19.999\n",
            "1:4 ValuesLookLikePositions values that rise by 0.99995 with the position|deviations",
            "points");
        row("a column that is no run",
            "// values: deviation\ntarget [mm],up1 [um],run2 up [um],mean "
            "[um],T\n0,1,1,,20\n9,1,,,21\n",
            "2:3 LeftOut column run2 up|for a run its direction and number", "wide");
        row("a direction beside its first run",
            "// values: deviation\ntarget [mm],up [um],up1 [um],down1 [um]\n0,1,1,1\n9,1,1,1\n",
            "2:2 LeftOut column up|for a run its direction and number", "wide");
        row("a second data set",
            rtl("1 1 1\n1 2 1\n2 2 1\n2 1 1\n") + "\nEOF::\n\x1A\n"
                + rtl("1 1 9\n1 2 9\n2 2 9\n2 1 9\n"),
            "19:0 LeftOut further sections behind EOF::|one measurement in a file", "renishaw");
        row("too large at points", "X [mm],Y [mm],dX [um]\n0,0,1\n10,0,201\n0,20,1\n10,20,1\n",
            "1:3 UnitSuspicious a largest deviation of 0.201 mm over 20 mm|at most 1 % of the "
            "travel",
            "points");
    }
    void everyDoubtIsAWarning()
    {
        QFETCH(const QString, format);
        QFETCH(const QByteArray, text);
        QFETCH(const QByteArray, expected);
        const MeasurementReading reading = test::readAs(format.toStdString(), text.toStdString());
        VERIFY_MEASUREMENT(reading);
        const QByteArrayList found = test::describe(reading);
        QVERIFY2(
            found.size() == 1 && found.front().startsWith(expected), found.join('\n').constData());
        QCOMPARE(reading.diagnostics.front().severity, Severity::Warning);
    }

    void aTargetWithoutAnyValueIsMissing_data()
    {
        QTest::addColumn<QString>("format");
        QTest::addColumn<QByteArray>("text");
        const auto row = [](const char* format, const std::string& text) {
            QTest::newRow(format) << QString::fromLatin1(format) << QByteArray::fromStdString(text);
        };
        row("wide",
            "// values: deviation\ntarget [mm],up1 [um],up2 [um],down1 [um],down2 [um]\n"
            "0,0,1,2,3\n10,5,6,7,8\n20,,,,\n30,9,10,11,12\n");
        row("renishaw",
            rtlOf("Target-count: 4\nTargets : 0 10 20 30\n",
                "1 1 0\n1 2 5\n1 4 9\n2 4 11\n2 2 7\n2 1 2\n"
                "3 1 1\n3 2 6\n3 4 10\n4 4 12\n4 2 8\n4 1 3\n"));
        std::string ecmc = "CYCLES=2\nPOSITIONS=4\nTGT_DATA[1]=0\nTGT_DATA[2]=10\nTGT_DATA[3]=20\n"
                           "TGT_DATA[4]=30\n";
        for (const char* const direction : {"FWD", "BWD"})
            for (const char* const cycle : {"1", "2"})
                for (const auto& [number, position] :
                    {std::pair("1", "0.001"), std::pair("2", "10.002"), std::pair("4", "30.003")})
                    ecmc += std::string("REF_DATA_") + direction + "[" + number + "," + cycle
                        + "]=" + position + "\n";
        row("ecmc", ecmc);
        row("runs",
            head
                + "0,+,1,0\n10,+,1,5\n20,+,1,\n30,+,1,9\n0,+,2,1\n10,+,2,6\n30,+,2,10\n"
                  "0,-,1,2\n10,-,1,7\n30,-,1,11\n0,-,2,3\n10,-,2,8\n30,-,2,12\n");
    }
    void aTargetWithoutAnyValueIsMissing()
    {
        QFETCH(const QString, format);
        QFETCH(const QByteArray, text);
        const MeasurementReading reading = test::readAs(format.toStdString(), text.toStdString());
        VERIFY_MEASUREMENT(reading);
        const QByteArrayList found = test::describe(reading);
        QVERIFY2(found.size() == 2
                && found[0].startsWith(
                    "0:0 IncompleteRuns no value for up:3:1, up:3:2 (2 are missing)|")
                && found[1].startsWith(
                    "0:0 IncompleteRuns no value for down:3:1, down:3:2 (2 are missing)|"),
            found.join('\n').constData());
        // The numbers of the others are those of the file, and so it is when it is written.
        const Measurement& measurement = *reading.measurement;
        QCOMPARE(measurement.targets, (std::vector<double>{0.0, 10.0, 20.0, 30.0}));
        const auto again = test::readAs("runs", writeRunsCsv(measurement));
        VERIFY_MEASUREMENT(again);
        QCOMPARE(again.measurement->targets, measurement.targets);
        for (const AxisFigure& figure : iso230Figures(measurement).axis)
            QVERIFY(!figure.value);
        QCOMPARE(iso230Figures(measurement).targets.size(), std::size_t{3});
    }

    /// Where runs are counted by their lines, an empty cell would change their numbers.
    void aMissingValueOfARunWithoutANumberIsRefused()
    {
        const auto reading = test::readAs(
            "runs", "target [mm],direction,deviation [um]\n0,+,1\n9,+,\n0,+,2\n9,+,1\n");
        QVERIFY(!reading.measurement);
        QVERIFY(test::describe(reading).front().startsWith("3:3 NotANumber"));
    }

    /// What is left out by a person is another thing: the figures are those of the others.
    void aTargetThatIsLeftOutLeavesTheFiguresOfTheOthers()
    {
        auto reading =
            test::readAs("runs", head + "0,+,1,1\n9,+,1,2\n20,+,1,5\n20,-,1,5\n9,-,1,2\n0,-,1,1\n");
        VERIFY_MEASUREMENT(reading);
        for (RunValue& value : reading.measurement->values)
            value.isUsed = value.target != 2;
        QVERIFY(iso230Figures(*reading.measurement)[Iso230Figure::M].value.has_value());
    }

    void aWrongScaleIsExplained_data()
    {
        QTest::addColumn<double>("factor");
        QTest::addColumn<QByteArray>("explanation");
        QTest::newRow("other way") << -1.0 << QByteArray("the instrument counts the other way");
        QTest::newRow("um") << 1000.0 << QByteArray("1000 times smaller, as um for mm");
        QTest::newRow("m") << 0.001 << QByteArray("1000 times larger, as m for mm");
        QTest::newRow("inch") << 25.4 << QByteArray("reference is in mm and the encoder in inch");
        QTest::newRow("half") << 0.5 << QByteArray("it counts half");
        QTest::newRow("double") << 2.0 << QByteArray("it counts double");
        QTest::newRow("radians") << 57.29578 << QByteArray("encoder in radians");
        QTest::newRow("anything") << 1.3 << QByteArray("1 within 1 %; check which columns");
    }
    void aWrongScaleIsExplained()
    {
        QFETCH(const double, factor);
        QFETCH(const QByteArray, explanation);
        std::string text = "target [mm],direction,run,reference [mm],encoder [mm]\n";
        for (int i = 0; i < 5; ++i)
            text += std::to_string(10 * i) + ",+,1," + std::to_string(10.0 * i * factor) + ","
                + std::to_string(10 * i) + "\n";
        const MeasurementReading reading = test::readAs("runs", text);
        QVERIFY(!reading.measurement);
        const QByteArrayList found = test::describe(reading);
        QCOMPARE(found.size(), 1);
        QVERIFY2(found.front().startsWith("0:0 InstrumentScale the reference moves"),
            found.front().constData());
        QVERIFY2(found.front().contains(explanation), found.front().constData());
        QCOMPARE(measurementError("m.csv", reading).code, ErrorCode::InstrumentScale);
    }

    /// Approached from below, the target 0 is at 359.9999 for an instrument that counts one turn.
    void anInstrumentThatBeginsAgainAfterATurnIsNamed()
    {
        const auto explanationOf = [](const std::string& first, const std::string& unit) {
            std::string text = "target [" + unit + "],direction,run,reference [" + unit
                + "]\n0,+,1," + first + "\n";
            for (int i = 1; i < 12; ++i)
                text += std::to_string(30 * i) + ",+,1," + std::to_string(30 * i) + ".0001\n";
            const MeasurementReading reading = test::readAs("runs", text);
            return reading.measurement ? QByteArray() : test::describe(reading).front();
        };
        const QByteArray turn = "since the instrument begins again at 360 deg: let it count on";
        QVERIFY2(explanationOf("359.9999", "deg").contains(turn),
            explanationOf("359.9999", "deg").constData());
        // Of another value, or of a length, it is no turn.
        for (const QByteArray& other :
            {explanationOf("300", "deg"), explanationOf("359.9999", "mm")})
            QVERIFY2(other.contains("InstrumentScale") && !other.contains(turn), other.constData());
        QVERIFY(explanationOf("-0.0001", "deg").isEmpty());
    }

    void anEncoderOfAnotherUnitThanTheTargetsIsRefused_data()
    {
        QTest::addColumn<double>("factor");
        QTest::newRow("other way") << -1.0;
        QTest::newRow("inch") << 1.0 / 25.4;
        QTest::newRow("um") << 1000.0;
        QTest::newRow("two percent") << 1.02;
        QTest::newRow("does not move") << 0.0;
    }
    /// The deviations are right, so that nothing else in the file tells it.
    void anEncoderOfAnotherUnitThanTheTargetsIsRefused()
    {
        QFETCH(const double, factor);
        std::string text = "target [mm],direction,run,deviation [um],encoder [mm]\n";
        for (int i = 0; i < 5; ++i)
            text += std::to_string(10 * i) + ",+,1," + std::to_string(0.3 * i) + ","
                + std::to_string(10.0 * i * factor) + "\n";
        const MeasurementReading reading = test::readAs("runs", text);
        QVERIFY(!reading.measurement);
        const QByteArrayList found = test::describe(reading);
        QCOMPARE(found.size(), 1);
        QVERIFY2(found.front().startsWith("0:0 InstrumentScale the encoder moves"),
            found.front().constData());
        QCOMPARE(measurementError("m.csv", reading).code, ErrorCode::InstrumentScale);
    }

    void anEncoderThatIsWrongIsNotBlamedOnTheReference()
    {
        std::string text = "target [mm],direction,run,reference [mm],encoder [mm]\n";
        for (int i = 0; i < 5; ++i)
            text += std::to_string(25.4 * i) + ",+,1," + std::to_string(25.4 * i) + ","
                + std::to_string(i) + "\n";
        const QByteArrayList found = test::describe(test::readAs("runs", text));
        QCOMPARE(found.size(), 1);
        QVERIFY2(found.front().startsWith("0:0 InstrumentScale the encoder moves"),
            found.front().constData());
    }

    void tabsBetweenColumnsAreNamed()
    {
        const MeasurementReading reading = test::readAs(
            "runs", "target [mm]\tdirection\trun\tdeviation [um]\n0\t+\t1\t1.5\n10\t+\t1\t2\n");
        QVERIFY(!reading.measurement);
        QCOMPARE(test::describe(reading),
            QByteArrayList{
                "1:0 MissingColumn 1 column|columns separated by , or ; instead of tabs"});
    }

    /// Also without the line "// axiscomp runs": which columns there are is not the question.
    void aFileWithTabsIsToldSoWhateverItsColumnsAre()
    {
        for (const char* text : {"target [mm]\tdirection\tdeviation [um]\n0\t+\t1,5\n10\t+\t2\n",
                 "encoder [mm]\treference [mm]\n0\t0\n1\t1\n", "X [mm]\tY [mm]\tdX [um]\n0\t0\t1\n",
                 "target [mm]\tup1 [um]\tdown1 [um]\n0\t1\t2\n"}) {
            const auto format = chooseMeasurementFormat(text, "x.txt", {});
            VERIFY_RESULT(format);
            QCOMPARE(test::describe((*format)->read(text, {})),
                QByteArrayList{
                    "1:0 MissingColumn 1 column|columns separated by , or ; instead of tabs"});
        }
    }

    void aReferenceIsInvertedWhenAskedFor()
    {
        MeasurementReadOptions options;
        options.invertsReference = true;
        const MeasurementReading reading = test::readAs("runs",
            "target [mm],direction,run,reference [mm]\n0,+,1,0\n10,+,1,-10.001\n20,+,1,-20\n",
            options);
        VERIFY_MEASUREMENT(reading);
        QVERIFY(std::abs(reading.measurement->values[1].deviation - 0.001) < 1e-12);
    }

    void aReferenceThatIsInvertedByMistakeSaysSo()
    {
        MeasurementReadOptions options;
        options.invertsReference = true;
        const std::array<std::array<const char*, 2>, 2> files{
            {{"runs",
                 "target [mm],direction,run,reference [mm]\n0,+,1,0.001\n10,+,1,10.02\n"
                 "20,+,1,20.001\n"},
                {"points", "X [mm],Y [mm],Xr [mm]\n0,0,0\n40,0,40.004\n0,20,0\n40,20,40.004\n"}}};
        for (const auto& [format, text] : files) {
            VERIFY_MEASUREMENT(test::readAs(format, text));
            const QByteArrayList said = test::describe(test::readAs(format, text, options));
            QVERIFY2(said.size() == 1
                    && said.front().startsWith("0:0 InstrumentScale the reference moves -1")
                    && said.front().contains("leave --invert-reference out"),
                said.join('\n').constData());
        }
    }

    /// Points whose reference counts the other way are 0.004 mm too far at 40 mm.
    void theReferenceOfPointsIsInvertedWhenAskedFor()
    {
        MeasurementReadOptions options;
        options.invertsReference = true;
        const MeasurementReading reading = test::readAs("points",
            "X [mm],Y [mm],Xr [mm]\n0,0,0\n40,0,-40.004\n0,20,0\n40,20,-40.004\n", options);
        VERIFY_MEASUREMENT(reading);
        QVERIFY(std::abs(reading.measurement->points.values[0][1] - 0.004) < 1e-12);
    }

    void whatIsStatedOfOtherValuesIsRefused_data()
    {
        QTest::addColumn<QString>("format");
        QTest::addColumn<QByteArray>("text");
        const auto row = [](const char* format, const std::string& text) {
            QTest::newRow(format) << QString::fromLatin1(format) << QByteArray::fromStdString(text);
        };
        row("runs", head + "0,+,1,1\n10,+,1,1\n");
        row("renishaw", rtl("1 1 1\n1 2 1\n2 2 1\n2 1 1\n"));
        row("api-pos",
            "Position Forward Directional Avg Error\n0 0.001\n10 0.001\n"
            "Position Reverse Directional Avg Error\n0 0.001\n10 0.001\n");
        row("points", "X [mm],Y [mm],dX [um]\n0,0,1\n10,0,1\n0,10,1\n");
    }
    void whatIsStatedOfOtherValuesIsRefused()
    {
        QFETCH(const QString, format);
        QFETCH(const QByteArray, text);
        MeasurementReadOptions options;
        VERIFY_MEASUREMENT(test::readAs(format.toStdString(), text.toStdString(), options));
        options.invertsReference = true;
        const QByteArrayList said =
            test::describe(test::readAs(format.toStdString(), text.toStdString(), options));
        QVERIFY2(said.size() == 1 && said.front().contains("MissingColumn deviations|positions of"),
            said.join('\n').constData());
    }

    void aFactorWithinOnePercentIsTheMachines()
    {
        const MeasurementReading reading = test::readAs("runs",
            "target [mm],direction,run,reference [mm]\n0,+,1,0\n10,+,1,10.05\n20,+,1,20.1\n");
        VERIFY_MEASUREMENT(reading);
    }

    void theErrorSaysWhatIsMissing()
    {
        const MeasurementReading units =
            test::readAs("runs", "target,direction,deviation\n0,+,1\n1,+,1\n");
        QCOMPARE(measurementError("m.csv", units).code, ErrorCode::UnitMissing);
        const MeasurementReading other = test::readAs("runs", head + "0,x,1,1\n");
        QCOMPARE(measurementError("m.csv", other).code, ErrorCode::InvalidMeasurement);
        QCOMPARE(measurementError("m.csv", other).context.integer("count"),
            std::optional<std::int64_t>(1));
    }

    void aFileOfNoFormatIsNotGuessed()
    {
        VERIFY_ERROR(chooseMeasurementFormat("a,b\n1,2\n", "x.csv", {}), ErrorCode::UnknownFormat);
        VERIFY_ERROR(
            chooseMeasurementFormat("a\tb\n1\t2\n", "x.csv", {}), ErrorCode::UnknownFormat);
        VERIFY_ERROR(measurementFormatNamed("excel"), ErrorCode::UnknownFormat);
        for (const char* bad : {"", "target", "=1", "target=", "target=1,,"})
            VERIFY_ERROR(columnMappingFromText(bad), ErrorCode::InvalidArgument);
    }

    void whatIsNoTextIsSaidInsteadOfAnUnknownFormat_data()
    {
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<QByteArray>("expected"); // the beginning
        QTest::newRow("empty") << QByteArray() << QByteArray("0:0 EmptyFile");
        QTest::newRow("blank lines") << QByteArray("\r\n \r\n") << QByteArray("0:0 EmptyFile");
        QTest::newRow("UTF-16") << QByteArray("\xFF\xFEt\0a\0", 6)
                                << QByteArray("0:0 NotText UTF-16 text");
        QTest::newRow("workbook") << QByteArray("PK\x03\x04rest")
                                  << QByteArray("0:0 NotText a spreadsheet workbook");
    }
    void whatIsNoTextIsSaidInsteadOfAnUnknownFormat()
    {
        QFETCH(QByteArray, text);
        QFETCH(QByteArray, expected);
        const auto format = chooseMeasurementFormat(text.toStdString(), "a.csv", {});
        QVERIFY(format.has_value());
        const QByteArrayList said = test::describe((*format)->read(text.toStdString(), {}));
        QCOMPARE(said.size(), qsizetype{1});
        QVERIFY2(said.front().startsWith(expected), said.front().constData());
    }

    void aFileThatNamesItsFormatIsReadAsThat()
    {
        const std::string text = "//axiscomp runs: 1\nZiel [mm],direction,run,deviation [um]\n";
        const auto format = chooseMeasurementFormat(text, "a.csv", {});
        QVERIFY(format.has_value());
        QCOMPARE((*format)->facts.name, std::string_view("runs"));
        const QByteArrayList said = test::describe((*format)->read(text, {}));
        QVERIFY2(!said.empty() && said.front().startsWith("2:0 MissingColumn no column target"),
            said.join('\n').constData());
    }

    void linesInAnyOrderAreRead()
    {
        // 1000 targets, 50 runs in each direction, in an order that jumps about.
        std::string text = head;
        constexpr std::uint64_t count = 100'000;
        for (std::uint64_t n = 0; n < count; ++n) {
            const std::uint64_t i = n * 7919U % count;
            const std::uint64_t target = i % 1000;
            const std::uint64_t run = i / 1000 % 50 + 1;
            text += std::to_string(target) + (i >= count / 2 ? ",-," : ",+,") + std::to_string(run)
                + ",0.5\n";
        }
        const MeasurementReading reading = test::readAs("runs", text);
        VERIFY_MEASUREMENT(reading);
        QVERIFY2(reading.diagnostics.empty(), test::describe(reading).join('\n').constData());
        QCOMPARE(reading.measurement->values.size(), std::size_t{count});
        QCOMPARE(reading.measurement->runCount(Approach::Down), 50);
    }
};

AXISCOMP_TEST(tst_MeasurementProblems)

} // namespace tst_measurementproblems

#include "tst_measurementproblems.moc"
