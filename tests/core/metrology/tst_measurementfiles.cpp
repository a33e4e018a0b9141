// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/joined_files.h"
#include "core/metrology/judge/iso230.h"
#include "core/metrology/run_selection.h"
#include "core/text/number_text.h"
#include "tests/core/metrology/measurement_reading.h"
#include "tests/support/test_registry.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <random>
#include <sstream>

namespace tst_measurementfiles {

using namespace axiscomp;
using Figure = Iso230Figure;

namespace {

Measurement publicRuns(const std::string& name)
{
    return test::readAs("runs", test::publicMeasurement(name)).measurement.value_or(Measurement{});
}

std::vector<std::string> linesOf(const std::string& text)
{
    std::vector<std::string> lines;
    std::istringstream stream(text);
    for (std::string line; std::getline(stream, line);)
        lines.push_back(line);
    return lines;
}

double valueAt(const Measurement& m, Approach direction, std::size_t target, int run)
{
    for (const RunValue& value : m.values)
        if (value.direction == direction && value.target == target && value.run == run)
            return value.deviation;
    return std::nan("");
}

std::string inColumns(const Measurement& m, bool isReference, char separator, bool isCommaDecimal)
{
    std::string text = isReference ? "// values: reference\n" : "// values: deviation\n";
    const std::string between(1, separator);
    text += "target_mm";
    const int runs = m.runCount(Approach::Up);
    for (const char* direction : {"up", "down"})
        for (int run = 1; run <= runs; ++run)
            text += between + direction + std::to_string(run) + (isReference ? " [mm]" : " [um]");
    text += "\n";
    for (std::size_t target = 0; target < m.targets.size(); ++target) {
        std::string line = shortestText(m.targets[target]);
        for (const Approach direction : {Approach::Up, Approach::Down})
            for (int run = 1; run <= runs; ++run) {
                const double deviation = valueAt(m, direction, target, run);
                line += between
                    + shortestText(
                        isReference ? m.targets[target] + deviation : 1000.0 * deviation);
            }
        if (isCommaDecimal)
            std::ranges::replace(line, '.', ',');
        text += line + "\n";
    }
    return text;
}

/// The same targets, each value larger by this.
Measurement measuredAgain(Measurement measurement, double difference)
{
    for (RunValue& value : measurement.values)
        value.deviation += difference;
    return measurement;
}

std::string asRtl(const Measurement& m)
{
    std::string text = "HEADER:: \r\nFile type  : rtl \r\nOwner : none\r\nVersion no : 1 \r\n\r\n"
                       "TARGET DATA:: \r\nFiletype  : ISO \r\nTarget-count: "
        + std::to_string(m.targets.size()) + " \r\nTargets : \r\n";
    for (std::size_t i = 0; i < m.targets.size(); ++i)
        text += shortestText(m.targets[i]) + (i % 4 == 3 ? "\r\n" : "  ");
    const int cycles = m.runCount(Approach::Up);
    text += "\r\nFlags: 0 0 2 0 \r\n\r\nUSER-TEXT:: \r\nMachine: B02\r\nSerial No: 7\r\nAxis: X\r\n"
            "Location: hall 3\r\nTITLE: first\r\n\r\nRUNS:: \r\nRun-count: "
        + std::to_string(2 * cycles) + " \r\n\r\nDEVIATIONS:: \r\nRun Target Data: \r\n";
    for (int cycle = 1; cycle <= cycles; ++cycle) {
        for (std::size_t i = 0; i < m.targets.size(); ++i)
            text += "  " + std::to_string(2 * cycle - 1) + "   " + std::to_string(i + 1) + "  "
                + shortestText(1000.0 * valueAt(m, Approach::Up, i, cycle)) + "\r\n";
        for (std::size_t i = m.targets.size(); i-- > 0;)
            text += "  " + std::to_string(2 * cycle) + "   " + std::to_string(i + 1) + "  "
                + shortestText(1000.0 * valueAt(m, Approach::Down, i, cycle)) + "\r\n";
    }
    return text
        + "\r\nEQUIPMENT:: \r\nSomething : 1 2 3\r\nENVIRONMENT:: \r\nAir temp   : 20.1 \r\n"
          "EOF::\r\n";
}

std::string asEcmc(const Measurement& m)
{
    std::string text = "TEST_DATA=# Input data file for ISO230-2 calcs\n# comment\nUNIT=mm\n"
                       "CYCLES=5\nPOSITIONS="
        + std::to_string(m.targets.size()) + "\nREF_PV=IOC:Enc01\n";
    for (std::size_t i = 0; i < m.targets.size(); ++i)
        text += "TGT_DATA[" + std::to_string(i + 1) + "]=" + shortestText(m.targets[i]) + "\n";
    for (const RunValue& value : m.values)
        text += std::string(value.direction == Approach::Up ? "REF_DATA_FWD[" : "REF_DATA_BWD[")
            + std::to_string(value.target + 1) + "," + std::to_string(value.run)
            + "]=" + shortestText(m.targets[value.target] + value.deviation) + "\n";
    return text;
}

bool haveSameFigures(const Measurement& a, const Measurement& b)
{
    const Iso230Figures first = iso230Figures(a);
    const Iso230Figures second = iso230Figures(b);
    return std::ranges::all_of(allIso230Figures(), [&](Figure figure) {
        return first[figure].value && second[figure].value
            && std::abs(*first[figure].value - *second[figure].value) < 1e-9;
    });
}

} // namespace

class tst_MeasurementFiles : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void everyFormatCarriesTheSameFigures_data()
    {
        QTest::addColumn<QString>("format");
        QTest::addColumn<QByteArray>("text");
        const Measurement m = publicRuns("b02_x.csv");
        const auto row = [](const char* name, const char* format, const std::string& text) {
            QTest::newRow(name) << QString::fromLatin1(format) << QByteArray::fromStdString(text);
        };
        row("written again", "runs", writeRunsCsv(m));
        row("wide, deviations in um", "wide", inColumns(m, false, ',', false));
        row("wide, positions", "wide", inColumns(m, true, ',', false));
        row("wide, decimal comma", "wide", inColumns(m, false, ';', true));
        row("rtl", "renishaw", asRtl(m));
        row("ecmc", "ecmc", asEcmc(m));
        std::vector<std::string> lines = linesOf(test::publicMeasurement("b02_x.csv"));
        std::mt19937 random(7);
        std::shuffle(lines.begin() + 3, lines.end(), random);
        std::string shuffled;
        for (const std::string& line : lines)
            shuffled += line + "\n";
        row("lines shuffled", "runs", shuffled);
    }
    void everyFormatCarriesTheSameFigures()
    {
        QFETCH(const QString, format);
        QFETCH(const QByteArray, text);
        const auto chosen = chooseMeasurementFormat(text.toStdString(), "m.dat", {});
        VERIFY_RESULT(chosen);
        QCOMPARE(QString::fromStdString(std::string((*chosen)->facts.name)), format);
        const MeasurementReading reading = (*chosen)->read(text.toStdString(), {});
        VERIFY_MEASUREMENT(reading);
        QVERIFY2(reading.diagnostics.empty(), test::describe(reading).join('\n').constData());
        QVERIFY(haveSameFigures(*reading.measurement, publicRuns("b02_x.csv")));
    }

    void writingAndReadingGivesTheSameMeasurement()
    {
        const MeasurementReading first = test::readAs("runs",
            "// machine: M1\n// axis: X\n// instrument: XL-80\n// serial: 12\n// operator: me\n"
            "// date: 2026-11-21T09:30:00\n// feed: 1000 mm/min\n// dwell: 2 s\n"
            "// compensation: crc:1c291ca3\n// air temperature: 20.4\n"
            "// material temperature: 20.9 C\n// expansion: 11.5e-6\n// corrected: none\n// a "
            "note\n// note: sign: of rain\n"
            "target [mm],direction,run,deviation [um],encoder [mm],output "
            "[um],time,temperature,use\n"
            "0,+,1,0.21,0.001,3,10,20.5,1\n25.31,up,1,1.05,25.3,,11,,0\n0,bwd,1,2,,,,,\n"
            "25.31,-1,1,3,,,,,1\n");
        VERIFY_MEASUREMENT(first);
        const MeasurementHeader& header = first.measurement->header;
        QCOMPARE(header.machine, "M1");
        QCOMPARE(header.compensation.tableCrc, std::optional<std::uint32_t>(0x1c291ca3));
        QCOMPARE(header.materialTemperature, std::optional(20.9));
        QCOMPARE(header.corrected, MeasurementHeader::Corrected::None);
        QCOMPARE(first.measurement->notes, (std::vector<std::string>{"a note", "sign: of rain"}));
        QCOMPARE(first.measurement->excludedCount(), std::size_t{1});
        const MeasurementReading second = test::readAs("runs", writeRunsCsv(*first.measurement));
        VERIFY_MEASUREMENT(second);
        QVERIFY(second.measurement->header == header);
        QCOMPARE(second.measurement->notes, first.measurement->notes);
        QCOMPARE(second.measurement->targets, first.measurement->targets);
        QCOMPARE(second.measurement->values.size(), std::size_t{4});
        for (std::size_t i = 0; i < 4; ++i) {
            RunValue expected = first.measurement->values[i];
            expected.line = second.measurement->values[i].line;
            QVERIFY(second.measurement->values[i] == expected);
        }
    }

    void lengthsBecomeMillimetresAndAnglesDegrees()
    {
        const auto first = [](const std::string& text) {
            const MeasurementReading reading = test::readAs("runs", text);
            return reading.measurement ? *reading.measurement : Measurement{};
        };
        const Measurement inch = first("target [inch],direction,deviation [um]\n1,+,2.54\n2,+,0\n");
        QCOMPARE(inch.targets, (std::vector<double>{25.4, 50.8}));
        QCOMPARE(inch.values.front().deviation, 0.00254);
        const Measurement turn =
            first("target [rad],direction,deviation [arcsec]\n0,+,3.6\n3,+,0\n");
        QVERIFY(turn.isAngular);
        QCOMPARE(turn.targets.back(), 3.0 * 180.0 / std::numbers::pi);
        QVERIFY(std::abs(turn.values.front().deviation - 0.001) < 1e-15);
    }

    void aUnitBehindTheNameIsThatOfBrackets_data()
    {
        QTest::addColumn<QByteArray>("target");
        QTest::addColumn<QByteArray>("deviation");
        for (const auto& [target, deviation] : {std::pair("mm", "um"), {"m", "nm"}, {"INCH", "uin"},
                 {"in", "mil"}, {"um", "\u00b5m"}, {"rad", "mrad"}, {"deg", "arcsec"}})
            QTest::addRow("%s", target) << QByteArray(target) << QByteArray(deviation);
    }
    /// Any other one is asked for in brackets, and the name stays what it is.
    void aUnitBehindTheNameIsThatOfBrackets()
    {
        QFETCH(const QByteArray, target);
        QFETCH(const QByteArray, deviation);
        const auto file = [&](const char* before, const char* behind) {
            const auto column = [&](const char* name, const QByteArray& unit) {
                return name + (before + unit + behind);
            };
            return ("// values: deviation\n" + column("target", target) + ","
                + column("up_1", deviation) + "," + column("down1", deviation)
                + "\n0,0.1,0.2\n1,0.3,0.4\n2,0.5,0.7\n")
                .toStdString();
        };
        const std::string text = file("_", "");
        const auto format = chooseMeasurementFormat(text, "w.csv", {});
        VERIFY_RESULT(format);
        const MeasurementReading behind = (*format)->read(text, {});
        const MeasurementReading inBrackets = test::readAs("wide", file(" [", "]"));
        VERIFY_MEASUREMENT(behind);
        VERIFY_MEASUREMENT(inBrackets);
        QVERIFY(*behind.measurement == *inBrackets.measurement);
    }

    void aDirectionBehindTheNameIsNoUnit()
    {
        MeasurementReadOptions options;
        options.columns = *columnMappingFromText("target=place_mm, direction=way, deviation=e_rev");
        options.valueUnit = "um";
        const MeasurementReading reading =
            test::readAs("runs", "place_mm,way,e_rev\n0,-,1\n10,-,2\n", options);
        VERIFY_MEASUREMENT(reading);
        QVERIFY(!reading.measurement->isAngular);
        QCOMPARE(reading.measurement->targets.back(), 10.0);
        QCOMPARE(reading.measurement->values.front().deviation, 0.001);
        QVERIFY(reading.measurement->againstFile.units.empty());
    }

    void temperaturesBecomeDegreesCelsius_data()
    {
        QTest::addColumn<QByteArray>("column");
        QTest::addColumn<QByteArray>("number");
        QTest::newRow("no unit") << QByteArray("temperature") << QByteArray("20.5");
        QTest::newRow("C") << QByteArray("temperature [C]") << QByteArray("20.5");
        QTest::newRow("degree sign") << QByteArray("temperature [\u00b0C]") << QByteArray("20.5");
        QTest::newRow("K") << QByteArray("temperature [K]") << QByteArray("293.65");
        QTest::newRow("F") << QByteArray("Temperature [degF]") << QByteArray("68.9");
    }
    void temperaturesBecomeDegreesCelsius()
    {
        QFETCH(const QByteArray, column);
        QFETCH(const QByteArray, number);
        const MeasurementReading reading = test::readAs("runs",
            ("target [mm],direction,deviation [um]," + column + "\n0,+,1," + number + "\n10,+,1,\n")
                .toStdString());
        VERIFY_MEASUREMENT(reading);
        QVERIFY(std::abs(reading.measurement->values[0].temperature.value_or(0.0) - 20.5) < 1e-9);
        QVERIFY(!reading.measurement->values[1].temperature);
    }

    void timesBecomeSeconds_data()
    {
        QTest::addColumn<QByteArray>("column");
        QTest::addColumn<QByteArray>("begin");
        QTest::addColumn<QByteArray>("end");
        const auto row = [](const char* column, const char* begin, const char* end) {
            QTest::newRow(column) << QByteArray(column) << QByteArray(begin) << QByteArray(end);
        };
        row("time", "10", "5410");
        row("time [s]", "10", "5410");
        row("time [ms]", "10000", "5410000");
        row("time [min]", "1", "91");
        row("time [h]", "0.5", "2");
        row("time [UTC]", "2026-11-21T09:30:00", "2026-11-21T11:00:00");
    }
    /// An hour and a half in every unit.
    void timesBecomeSeconds()
    {
        QFETCH(const QByteArray, column);
        QFETCH(const QByteArray, begin);
        QFETCH(const QByteArray, end);
        const MeasurementReading reading = test::readAs("runs",
            ("target [mm],direction,deviation [um]," + column + "\n0,+,1," + begin + "\n10,+,1,"
                + end + "\n")
                .toStdString());
        VERIFY_MEASUREMENT(reading);
        const std::vector<RunValue>& values = reading.measurement->values;
        QVERIFY(values[0].time && values[1].time);
        QVERIFY(std::abs(*values[1].time - *values[0].time - 5400.0) < 1e-9);
        std::string track = "encoder [mm],reference [mm]," + column.toStdString() + "\n";
        for (int i = 0; i < 20; ++i)
            track += std::to_string(i) + "," + std::to_string(i) + ","
                + (i < 19 ? begin : end).toStdString() + "\n";
        const MeasurementReading samples = test::readAs("track", track);
        VERIFY_MEASUREMENT(samples);
        const std::vector<TrackSample>& taken = samples.measurement->track;
        QVERIFY(std::abs(*taken.back().time - *taken.front().time - 5400.0) < 1e-9);
    }

    /// They say theirs by their columns.
    void aKindChangesNoTrackAndNoPoints()
    {
        std::string track = "// kind: runs\nencoder [mm],reference [mm]\n";
        for (int i = 0; i < 20; ++i)
            track += std::to_string(i) + "," + std::to_string(i) + "\n";
        const MeasurementReading samples = test::readAs("track", track);
        VERIFY_MEASUREMENT(samples);
        QCOMPARE(samples.measurement->kind, MeasurementKind::Track);
        const MeasurementReading points = test::readAs(
            "points", "// kind: averages\nX [mm],Y [mm],dX [um]\n0,0,0\n40,0,4\n0,20,0\n");
        VERIFY_MEASUREMENT(points);
        QCOMPARE(points.measurement->kind, MeasurementKind::Points);
    }

    void aReferenceBecomesADeviation()
    {
        const MeasurementReading reading = test::readAs(
            "runs", "target [mm],direction,reference [mm]\n0,+,0.001\n10,+,9.998\n20,+,20.05\n");
        VERIFY_MEASUREMENT(reading);
        QVERIFY(std::abs(reading.measurement->values[1].deviation + 0.002) < 1e-12);
    }

    void correctionsAreTheOppositeOfDeviations()
    {
        const MeasurementReading reading = test::readAs("runs",
            "// sign: correction\ntarget [mm],direction,value [mm]\n0,+,0.25\n10,+,0\n100,-,0\n");
        VERIFY_MEASUREMENT(reading);
        QCOMPARE(reading.measurement->values[0].deviation, -0.25);
    }

    /// A correction of x um at each X: the axis went too far by its opposite.
    void twoStatementsOfOneThingMustSayTheSame()
    {
        const auto read = [](const std::string& first, const std::string& second) {
            const std::string lines = "target [mm],direction,run,deviation [um]\n"
                                      "0,+,1,0.1\n10,+,1,0.2\n20,+,1,0.3\n";
            return test::readAs("runs", "// " + first + "\n// " + second + "\n" + lines);
        };
        const std::pair<const char*, const char*> different[] = {{"axis: X", "axis: Y"},
            {"compensation: off", "compensation: on"},
            {"compensation: crc:1c291ca3", "Compensation: crc:1c291ca4"},
            {"corrected: none", "corrected: 20C"}, {"values: deviation", "values: reference"},
            {"sign: correction", "sign: deviation"},
            {"air temperature: 20.4", "air temperature: 20.5"},
            {"material temperature: 20.4", "material temperature: 20.5"},
            {"expansion: 11.5e-6", "expansion: 11e-6"}};
        for (const auto& [first, second] : different) {
            const MeasurementReading reading = read(first, second);
            QVERIFY2(!reading.measurement, second);
            QVERIFY2(std::ranges::any_of(reading.diagnostics,
                         [](const Diagnostic& one) {
                             return one.code == DiagnosticCode::Contradiction;
                         }),
                second);
        }
        const std::pair<const char*, const char*> same[] = {{"axis: X", "Axis: x"},
            {"compensation: crc:1c291ca3", "compensation: crc:1C291CA3"},
            {"corrected: 20C", "corrected: 20 C"},
            {"air temperature: 20.4", "air temperature: 20.40 C"},
            {"expansion: 11.5e-6", "expansion: 1.15e-5 1/K"}};
        for (const auto& [first, second] : same)
            QVERIFY2(read(first, second).measurement.has_value(), second);
    }

    void correctionsAtPointsAreTheOppositeOfDeviations()
    {
        const auto valuesOf = [](const std::string& sign) {
            const MeasurementReading reading = test::readAs("points",
                sign + "X [mm],Y [mm],dX [um],Yr [mm]\n0,0,0,0.004\n40,0,4,0.004\n0,20,0,20.004\n");
            return reading.measurement ? reading.measurement->points.values
                                       : std::vector<std::vector<double>>(2);
        };
        const auto deviations = valuesOf("");
        const auto corrections = valuesOf("// sign: correction\n");
        QCOMPARE(deviations[0], (std::vector<double>{0.0, 0.004, 0.0}));
        QCOMPARE(corrections[0], (std::vector<double>{-0.0, -0.004, -0.0}));
        QCOMPARE(corrections[1], deviations[1]); // positions of the reference have no sign
        QVERIFY(std::abs(deviations[1].back() - 0.004) < 1e-12);
    }

    void statementsBehindTheValuesThatChangeNothingAreNoFault_data()
    {
        QTest::addColumn<QString>("format");
        QTest::addColumn<QByteArray>("text");
        const auto row = [](const char* name, const char* format, const char* text) {
            QTest::newRow(name) << QString::fromLatin1(format) << QByteArray(text);
        };
        row("said again", "runs",
            "// sign: correction\n// values: deviation\ntarget [mm],direction,value [um]\n"
            "0,+,1\n10,+,2\n// sign: correction\n// values: deviation\n");
        row("as it is without them", "runs",
            "target [mm],direction,deviation [um]\n0,+,1\n// sign: deviation\n10,+,2\n"
            "// values: deviation\n");
        row("positions by the name of the column", "runs",
            "target [mm],direction,reference [mm]\n0,+,0.001\n10,+,10.002\n"
            "// values: reference\n// sign: deviation\n");
        row("columns of runs", "wide",
            "// values: reference\ntarget [mm],up1 [mm]\n0,0.001\n10,10.002\n"
            "// values: reference\n// sign: deviation\n");
        row("points of the reference", "points",
            "X [mm],Y [mm],Xr [mm]\n0,0,0.001\n10,0,10.002\n// sign: deviation\n"
            "// values: reference\n");
        row("notes and temperatures", "runs",
            "target [mm],direction,deviation [um]\n0,+,1\n// a truck went by\n10,+,2\n"
            "// material temperature: 20.9\n// corrected: none\n// compensation: off\n");
    }
    void statementsBehindTheValuesThatChangeNothingAreNoFault()
    {
        QFETCH(const QString, format);
        QFETCH(const QByteArray, text);
        const MeasurementReading reading = test::readAs(format.toStdString(), text.toStdString());
        VERIFY_MEASUREMENT(reading);
        QVERIFY2(reading.diagnostics.empty(), test::describe(reading).join('\n').constData());
    }

    /// What the user states counts before the file, wherever it stands there.
    void aStatedKindOfValuesCountsBeforeALateComment()
    {
        MeasurementReadOptions options;
        options.values = MeasurementReadOptions::Values::Reference;
        for (const char* format : {"runs", "wide"}) {
            const std::string column = format == std::string("runs") ? "direction,value" : "up1";
            const std::string way = format == std::string("runs") ? ",+" : "";
            const MeasurementReading reading = test::readAs(format,
                "target [mm]," + column + " [mm]\n0" + way + ",0.001\n10" + way
                    + ",10.002\n// values: deviation\n",
                options);
            VERIFY_MEASUREMENT(reading);
            QVERIFY(std::abs(reading.measurement->values[1].deviation - 0.002) < 1e-12);
        }
    }

    void aStatedKindOfValuesAgainstTheFileIsSaid_data()
    {
        using Values = MeasurementReadOptions::Values;
        QTest::addColumn<QString>("format");
        QTest::addColumn<QByteArray>("text");
        QTest::addColumn<Values>("stated");
        QTest::addColumn<QByteArray>("said");
        const QByteArray reference =
            "values taken as positions of the reference, the file says deviations";
        const QByteArray deviation =
            "values taken as deviations, the file says positions of the reference";
        const QByteArray runs = "target [mm],direction,value [mm]\n0,+,0.001\n10,+,10.002\n";
        QTest::newRow("a comment of runs")
            << "runs"
            << "// values: deviation\n" + runs << Values::Reference << reference;
        QTest::newRow("a comment of columns of runs")
            << "wide"
            << QByteArray("// values: reference\ntarget [mm],up1 [mm]\n0,0.001\n10,0.002\n")
            << Values::Deviation << deviation;
        QTest::newRow("a column reference")
            << "runs" << QByteArray("target [mm],direction,reference [mm]\n0,+,0.001\n10,+,0.002\n")
            << Values::Deviation << deviation;
        QTest::newRow("a column deviation")
            << "runs"
            << QByteArray("target [mm],direction,deviation [mm]\n0,+,0.001\n10,+,10.002\n")
            << Values::Reference << reference;
        QTest::newRow("the same as the comment")
            << "runs"
            << "// values: reference\n" + runs << Values::Reference << QByteArray();
        QTest::newRow("a column that says nothing")
            << "runs" << runs << Values::Reference << QByteArray();
    }
    void aStatedKindOfValuesAgainstTheFileIsSaid()
    {
        QFETCH(const QString, format);
        QFETCH(const QByteArray, text);
        QFETCH(const MeasurementReadOptions::Values, stated);
        MeasurementReadOptions options;
        options.values = stated;
        const MeasurementReading reading =
            test::readAs(format.toStdString(), text.toStdString(), options);
        VERIFY_MEASUREMENT(reading);
        QByteArrayList said;
        for (const Text& phrase : againstFileTexts(reading.measurement->againstFile))
            said += QByteArray::fromStdString(phrase.english());
        QTEST(said.join('\n'), "said");
    }

    void aColumnThatContradictsTheCommentOnItsValuesIsRefused()
    {
        for (const auto& [comment, column] :
            {std::pair{"reference", "deviation"}, std::pair{"deviation", "reference"}}) {
            const MeasurementReading reading = test::readAs("runs",
                std::string("// values: ") + comment + "\ntarget [mm],direction," + column
                    + " [mm]\n0,+,0\n10,+,10\n");
            QVERIFY(!reading.measurement);
            QCOMPARE(reading.diagnostics.front().code, DiagnosticCode::Contradiction);
        }
    }

    void commentsBetweenHeaderAndValuesHoldForAllValues()
    {
        const std::string head = "target [mm],direction,value [mm]\n";
        const MeasurementReading turned =
            test::readAs("runs", head + "// sign: correction\n\n0,+,0.25\n100,+,0.5\n");
        VERIFY_MEASUREMENT(turned);
        QCOMPARE(turned.measurement->values[0].deviation, -0.25);
        QCOMPARE(turned.measurement->values[1].deviation, -0.5);
        const MeasurementReading positions =
            test::readAs("runs", head + "// values: reference\n0,+,0.25\n100,+,100.5\n");
        VERIFY_MEASUREMENT(positions);
        QCOMPARE(positions.measurement->values[1].deviation, 0.5);
        const MeasurementReading wide = test::readAs("wide",
            "target [mm],up1 [mm]\n// values: reference\n0,0.25\n// the second\n100,100.5\n");
        VERIFY_MEASUREMENT(wide);
        QCOMPARE(wide.measurement->values[1].deviation, 0.5);
        QCOMPARE(wide.measurement->values[1].line, std::size_t{5});
        QCOMPARE(wide.measurement->notes, std::vector<std::string>{"the second"});
    }

    void theColumnAxisNamesTheAxis()
    {
        const auto axisOf = [](const char* format, const std::string& text,
                                const MeasurementReadOptions& options = {}) {
            const MeasurementReading reading = test::readAs(format, text, options);
            return reading.measurement && reading.measurement->notes.empty()
                ? reading.measurement->header.axis
                : test::describe(reading).join('\n').toStdString();
        };
        const std::string runs = "Axis,target [mm],direction,deviation [um]\n";
        QCOMPARE(axisOf("runs", runs + "X,0,+,1\nx,9,+,2\n,20,+,3\n"), "X");
        QCOMPARE(axisOf("runs", "// axis: Y axis\n" + runs + "Y,0,+,1\nY,9,+,2\n"), "Y axis");
        QCOMPARE(axisOf("runs", "// axis: X\n" + runs + "1,0,+,1\n1,9,+,2\n"), "X");
        QCOMPARE(
            axisOf("wide", "// values: deviation\ntarget [mm],axis,up1 [um]\n0,Z,1\n9,Z,1\n"), "Z");
        QCOMPARE(axisOf("points", "X [mm],Y [mm],axis,dX [um]\n0,0,X,1\n9,0,X,1\n"), "X");
        MeasurementReadOptions mapped;
        mapped.columns = *columnMappingFromText("target=2,direction=3,deviation=4");
        QCOMPARE(axisOf("runs", runs + "X,0,+,1\nX,9,+,2\n", mapped), "X");
        mapped.columns = *columnMappingFromText("target=2,direction=3,deviation=4,axis=1");
        QCOMPARE(axisOf("runs", "Name,Pos [mm],Way,Error [um]\nX,0,+,1\nX,9,+,2\n", mapped), "X");
    }

    void theUnitOfEcmcDataIsNamedInAnyLetters()
    {
        for (const char* key : {"UNIT", "unit", "Unit"}) {
            const MeasurementReading reading = test::readAs("ecmc",
                std::string(key)
                    + "=um\nTGT_DATA[1]=0\nTGT_DATA[2]=5000\nREF_DATA_FWD[1,1]=0\n"
                      "REF_DATA_FWD[2,1]=5002\n");
            VERIFY_MEASUREMENT(reading);
            QVERIFY(std::abs(reading.measurement->targets.back() - 5.0) < 1e-12);
            QVERIFY(std::abs(reading.measurement->values[1].deviation - 0.002) < 1e-12);
        }
    }

    void aDirectionAloneIsItsFirstRun()
    {
        const std::string text = "// values: deviation\ntarget [mm],up [um],up2 [um],Down [um]\n"
                                 "0,1,2,3\n9,4,5,6\n";
        const MeasurementReading reading = test::readAs("wide", text);
        VERIFY_MEASUREMENT(reading);
        QCOMPARE(reading.measurement->runCount(Approach::Up), 2);
        QCOMPARE(valueAt(*reading.measurement, Approach::Up, 1, 1), 0.004);
        QCOMPARE(valueAt(*reading.measurement, Approach::Up, 1, 2), 0.005);
        QCOMPARE(valueAt(*reading.measurement, Approach::Down, 1, 1), 0.006);
        const auto means = chooseMeasurementFormat("target [mm],up [um],down [um]\n", "m.csv", {});
        VERIFY_RESULT(means);
        QCOMPARE((*means)->facts.name, std::string_view("wide"));
    }

    void pointsOfAnglesAreDegrees()
    {
        const MeasurementReading reading = test::readAs(
            "points", "X [arcmin],Y [deg],dX [arcsec]\n0,0,1.8\n2400,0,1.8\n0,20,3.6\n");
        VERIFY_MEASUREMENT(reading);
        QVERIFY(reading.measurement->isAngular);
        QVERIFY(std::abs(reading.measurement->points.positions[0][1] - 40.0) < 1e-12);
        QVERIFY(std::abs(reading.measurement->points.values[0][2] - 0.001) < 1e-15);
    }

    void runsAreCountedWhereTheFileDoesNot()
    {
        const MeasurementReading reading = test::readAs("runs",
            "target [mm],direction,deviation [um]\n0,+,1\n9,+,2\n0,+,3\n9,+,4\n9,-,5\n0,-,6\n");
        VERIFY_MEASUREMENT(reading);
        QCOMPARE(valueAt(*reading.measurement, Approach::Up, 0, 2), 0.003);
        QCOMPARE(reading.measurement->runCount(Approach::Down), 1);
    }

    void runsAreCountedWhateverTheirNumbersAre()
    {
        // Passes that are numbered through: up 1 and 3, down 2 and 4.
        const MeasurementReading reading = test::readAs("runs",
            "target [mm],direction,run,deviation [um]\n0,+,1,0.1\n10,+,1,0.2\n0,-,2,0.3\n"
            "10,-,2,0.4\n0,+,3,0.1\n10,+,3,0.3\n0,-,4,0.2\n10,-,4,0.1\n");
        VERIFY_MEASUREMENT(reading);
        const Measurement& one = *reading.measurement;
        QCOMPARE(one.runCount(Approach::Up), 2);
        QCOMPARE(one.runCount(Approach::Down), 2);
        QVERIFY(reading.diagnostics.empty()); // no UnequalRuns
        // Joined, no run of one file becomes part of one of the other.
        Measurement other = one;
        for (RunValue& value : other.values)
            value.deviation += 0.001;
        const std::vector<Measurement> both{one, other};
        const auto whole = joined(both);
        VERIFY_RESULT(whole);
        QCOMPARE(whole->runCount(Approach::Up), 4);
        QCOMPARE(whole->lastRun(Approach::Up), 6);
        QCOMPARE(whole->runCount(Approach::Down), 4);
    }

    void anyCsvIsReadByItsColumns()
    {
        MeasurementReadOptions options;
        options.columns = *columnMappingFromText("target=1, direction=Way, deviation=4");
        options.skippedLines = 2;
        options.unit = "mm";
        options.valueUnit = "um";
        const std::string text = "5530 software\nnothing\nPos;Way;x;Err\n0;+;junk;0,5\n10,5;+;;1\n";
        const auto format = chooseMeasurementFormat(text, "k.csv", options);
        VERIFY_RESULT(format);
        const MeasurementReading reading = (*format)->read(text, options);
        VERIFY_MEASUREMENT(reading);
        QCOMPARE(reading.measurement->targets.back(), 10.5);
        QCOMPARE(reading.measurement->values.front().deviation, 0.0005);
        QCOMPARE(reading.measurement->notes, std::vector<std::string>{"column not used: x"});
    }

    void aStatedUnitCountsBeforeTheFile()
    {
        MeasurementReadOptions options;
        options.valueUnit = "mm";
        const MeasurementReading reading = test::readAs(
            "runs", "target [mm],direction,deviation [um]\n0,+,0.25\n100,+,0.5\n", options);
        VERIFY_MEASUREMENT(reading);
        QCOMPARE(reading.measurement->values.front().deviation, 0.25);
        QVERIFY(reading.measurement->againstFile.units
            == (std::vector<StatedUnit>{{"deviation", "mm", "um"}}));
        const auto said = againstFileTexts(reading.measurement->againstFile);
        QCOMPARE(said.size(), std::size_t{1});
        QCOMPARE(said[0].english(), std::string("unit of deviation taken as mm, the file says um"));
        QVERIFY(writeRunsCsv(*reading.measurement).find("// " + said[0].english() + "\n")
            != std::string::npos);
    }

    /// Files that have units by their format: 1 inch is 25.4 mm, 2 of a value are 0.002 mm.
    void aStatedUnitCountsBeforeTheFormat()
    {
        MeasurementReadOptions options;
        options.unit = "inch";
        options.valueUnit = "um";
        const MeasurementReading means = test::readAs("api-pos",
            "Position Forward Directional Avg Error\n0 1\n1 2\n"
            "Position Reverse Directional Avg Error\n0 1\n1 2\n",
            options);
        VERIFY_MEASUREMENT(means);
        QVERIFY(std::abs(means.measurement->targets.back() - 25.4) < 1e-12);
        QVERIFY(std::abs(means.measurement->values[1].deviation - 0.002) < 1e-15);
        QVERIFY(means.measurement->againstFile.units
            == (std::vector<StatedUnit>{{"targets", "inch", "mm"}, {"values", "um", "mm"}}));
        options.valueUnit = "mm";
        const std::string rtl =
            "HEADER::\nFile type: rtl\nTARGET DATA::\nTarget-count: 2\nTargets : 0 10\n"
            "DEVIATIONS::\nRun Target Data:\n1 1 0.001\n1 2 0.002\nEOF::\n";
        const MeasurementReading runs = test::readAs("renishaw", rtl, options);
        VERIFY_MEASUREMENT(runs);
        QVERIFY(std::abs(runs.measurement->targets.back() - 254.0) < 1e-12);
        QVERIFY(std::abs(runs.measurement->values[1].deviation - 0.002) < 1e-15);
        options.unit = "mm";
        options.valueUnit = "um";
        const MeasurementReading readings = test::readAs("ecmc",
            "TGT_DATA[1]=0\nTGT_DATA[2]=10\nREF_DATA_FWD[1,1]=0\nREF_DATA_FWD[2,1]=10002\n",
            options);
        VERIFY_MEASUREMENT(readings);
        QVERIFY(std::abs(readings.measurement->values[1].deviation - 0.002) < 1e-12);
        options.valueUnit = "deg";
        const QByteArrayList said = test::describe(test::readAs("renishaw", rtl, options));
        QVERIFY2(said.size() == 1 && said.front().startsWith("0:0 UnitMixed"),
            said.join('\n').constData());
    }

    void directionsFollowFromTheOrder()
    {
        MeasurementReadOptions options;
        options.takesDirectionFromOrder = true;
        const MeasurementReading there = test::readAs("runs",
            "target [mm],deviation [um]\n0,1\n5,2\n9,3\n9,4\n5,5\n0,6\n0,7\n5,8\n9,9\n", options);
        VERIFY_MEASUREMENT(there);
        QCOMPARE(there.measurement->runCount(Approach::Up), 2);
        QCOMPARE(there.measurement->runCount(Approach::Down), 1);
        QCOMPARE(valueAt(*there.measurement, Approach::Down, 2, 1), 0.004);
        QCOMPARE(valueAt(*there.measurement, Approach::Up, 2, 2), 0.009);
        // One way only: each run begins anew.
        const MeasurementReading oneWay = test::readAs(
            "runs", "target [mm],deviation [um]\n0,1\n5,2\n9,3\n0,4\n5,5\n9,6\n", options);
        VERIFY_MEASUREMENT(oneWay);
        QCOMPARE(oneWay.measurement->runCount(Approach::Up), 2);
        QCOMPARE(oneWay.measurement->runCount(Approach::Down), 0);
    }

    void anglesOfRenishawAreMilliradians()
    {
        const MeasurementReading reading = test::readAs("renishaw",
            "HEADER::\nFile type: rta\nTARGET DATA::\nTarget-count: 2\nTargets : 0 90\nFlags: 0 0 "
            "2 "
            "0\nRUNS::\nRun-count: 2\nDEVIATIONS::\nRun Target Data:\n1 1 0.5\n1 2 1\n2 2 1\n2 1 "
            "0\nEOF::\n");
        VERIFY_MEASUREMENT(reading);
        QVERIFY(reading.measurement->isAngular);
        // 0.5 mrad are 103.132 arc seconds (206.265 for one mrad)
        QVERIFY(std::abs(reading.measurement->values[0].deviation * 3600.0 - 103.1324) < 1e-4);
    }

    void returnsOfAUnidirectionalRenishawFileAreLeftOut()
    {
        const std::string text = "HEADER::\nFile type: rtl\nTARGET DATA::\nTarget-count: "
                                 "2\nTargets : 0 90\nFlags: 0 1 2 "
                                 "0\nRUNS::\nRun-count: 4\nDEVIATIONS::\nRun Target Data:\n1 1 "
                                 "0.5\n1 2 1\n2 2 0\n2 1 0\n"
                                 "3 1 0.5\n3 2 1\n4 2 0\n4 1 0\nEOF::\n";
        const MeasurementReading reading = test::readAs("renishaw", text);
        VERIFY_MEASUREMENT(reading);
        QCOMPARE(reading.measurement->runCount(Approach::Up), 2);
        QCOMPARE(reading.measurement->runCount(Approach::Down), 0);
        QCOMPARE(reading.diagnostics.size(), std::size_t{1});
        QCOMPARE(reading.diagnostics[0].code, DiagnosticCode::LeftOut);
    }

    void aCommaBetweenPositionsCountsWhereTheFileSaysHowMany()
    {
        const MeasurementReading reading = test::readAs("renishaw",
            "HEADER::\nFile type: rtl\nTARGET DATA::\nTarget-count: 3\nTargets : 0,25, 50\nFlags: "
            "0 1 2 0\nDEVIATIONS::\nRun Target Data:\n1 1 1\n1 2 2\n1 3 3\nEOF::\n");
        VERIFY_MEASUREMENT(reading);
        QCOMPARE(reading.measurement->targets, (std::vector<double>{0.0, 25.0, 50.0}));
        QVERIFY(reading.diagnostics.empty());
    }

    /// Two cycles whose lines stand by target and run: every run rises.
    void linesThatWereSortedByTargetAreDoubtful()
    {
        std::string text =
            "HEADER::\nFile type: rtl\nTARGET DATA::\nTarget-count: 3\nTargets : 0 25 "
            "50\nFlags: 0 0 2 0\nRUNS::\nRun-count: 4\nDEVIATIONS::\nRun Target Data:\n";
        for (const char* target : {"1", "2", "3"})
            for (const char* run : {"1", "2", "3", "4"})
                text += std::string(run) + " " + target + " 0.5\n";
        const MeasurementReading reading = test::readAs("renishaw", text + "EOF::\n");
        VERIFY_MEASUREMENT(reading);
        QCOMPARE(reading.measurement->runCount(Approach::Up), 4);
        QVERIFY(std::ranges::any_of(reading.diagnostics, [](const Diagnostic& diagnostic) {
            return diagnostic.code == DiagnosticCode::DirectionsDoubtful;
        }));
        const MeasurementReading both = test::readAs("renishaw", asRtl(publicRuns("bifrost.csv")));
        QVERIFY(std::ranges::none_of(both.diagnostics, [](const Diagnostic& diagnostic) {
            return diagnostic.code == DiagnosticCode::DirectionsDoubtful;
        }));
    }

    void renishawTextsAreKept()
    {
        const MeasurementReading reading =
            test::readAs("renishaw", asRtl(publicRuns("bifrost.csv")));
        VERIFY_MEASUREMENT(reading);
        QCOMPARE(reading.measurement->header.machine, "B02");
        QCOMPARE(reading.measurement->header.axis, "X");
        QCOMPARE(reading.measurement->header.airTemperature, std::optional(20.1));
        const auto& notes = reading.measurement->notes;
        QVERIFY(std::ranges::find(notes, "Flags: 0 0 2 0") != notes.end());
        QVERIFY(std::ranges::find(notes, "Location: hall 3") != notes.end());
    }

    /// It is only told, and what is written must be readable.
    void aTemperatureThatNoMachineHasStaysANote()
    {
        std::string text = asRtl(publicRuns("bifrost.csv"));
        const std::string entry = "Air temp   : 20.1";
        text.replace(text.find(entry), entry.size(), "Air temp   : 293.25");
        const MeasurementReading reading = test::readAs("renishaw", text);
        VERIFY_MEASUREMENT(reading);
        QVERIFY(!reading.measurement->header.airTemperature);
        QVERIFY(std::ranges::find(reading.measurement->notes, "Air temp   : 293.25")
            != reading.measurement->notes.end());
        VERIFY_MEASUREMENT(test::readAs("runs", writeRunsCsv(*reading.measurement)));
    }

    void textsOfRenishawFilesMayBeChinese()
    {
        const auto machineOf = [](const std::string& machine) {
            std::string text = asRtl(publicRuns("bifrost.csv"));
            text.replace(text.find("Machine: B02"), 12, "Machine: " + machine);
            const MeasurementReading reading = test::readAs("renishaw", text);
            return reading.measurement ? reading.measurement->header.machine : std::string();
        };
        QCOMPARE(machineOf("\xBB\xFA\xB4\xB2"), "\u673A\u5E8A"); // GBK
        QCOMPARE(machineOf("Fr\xE4se"), "Fr\u00E4se"); // Windows-1252
        QCOMPARE(machineOf("Fr\u00E4se"), "Fr\u00E4se"); // UTF-8
    }

    void meansOfApiGiveBothDirections()
    {
        const MeasurementReading reading = test::readAs("api-pos",
            "API XD\r\nPosition   \tBidirectional Avg Error\r\n0.0\t0.001\r\n10.0\t0.003\r\n\r\n"
            "Position   \tForward Directional Avg Error\r\n0.0\t0.002\r\n10.0\t0.0035\r\n");
        VERIFY_MEASUREMENT(reading);
        QCOMPARE(reading.measurement->kind, MeasurementKind::Averages);
        QCOMPARE(valueAt(*reading.measurement, Approach::Up, 1, 1), 0.0035);
        QVERIFY(std::abs(valueAt(*reading.measurement, Approach::Down, 1, 1) - 0.0025) < 1e-15);
        const Iso230Figures figures = iso230Figures(*reading.measurement);
        QVERIFY(std::abs(*figures[Figure::B].value - 0.002) < 1e-15);
        QVERIFY(!figures[Figure::A].value);
    }

    void meansStayMeansInAFileOfRuns()
    {
        const std::string block = " Directional Avg Error\n0 0.001\n100 0.002\n200 0.004\n";
        const MeasurementReading means =
            test::readAs("api-pos", "Position Forward" + block + "Position Reverse" + block);
        VERIFY_MEASUREMENT(means);
        const std::string text = writeRunsCsv(*means.measurement);
        QVERIFY(text.find("\n// kind: averages\n") != std::string::npos);
        MeasurementReading again = test::readAs("runs", text);
        VERIFY_MEASUREMENT(again);
        QCOMPARE(again.measurement->kind, MeasurementKind::Averages);
        QVERIFY(again.measurement->notes == means.measurement->notes);
        // Two of them would be two runs, of which repeatability follows.
        Measurement other = *again.measurement;
        other.values.front().deviation += 1e-4;
        QVERIFY(!joined(std::vector<Measurement>{*again.measurement, other}));
        const MeasurementReading wide = test::readAs("wide",
            "// values: deviation\n// Kind: Averages\ntarget [mm],up1 [um],down1 [um]\n0,1,2\n"
            "9,1,2\n");
        VERIFY_MEASUREMENT(wide);
        QCOMPARE(wide.measurement->kind, MeasurementKind::Averages);
        QVERIFY(publicRuns("b02_x.csv").kind == MeasurementKind::Runs);
        QVERIFY(writeRunsCsv(publicRuns("b02_x.csv")).find("kind") == std::string::npos);
    }

    void whatStandsBetweenAndBehindTheMeansOfApiIsANote()
    {
        const MeasurementReading reading = test::readAs("api-pos",
            "API XD\n2026-11-21 09:30\nPosition Forward Directional Avg Error\n---- ----\n"
            "0 0.001\n+500 -.002\n\nPosition Reverse Directional Avg Error\n-- --\n"
            "0 0.001\n500 0.004\n-----\nStandard deviation at each position\n0 0.1 0.2\n"
            "500 0.1 0.2\nend of 21 Nov\n");
        VERIFY_MEASUREMENT(reading);
        QCOMPARE(reading.measurement->values.size(), std::size_t{4});
        QCOMPARE(valueAt(*reading.measurement, Approach::Up, 1, 1), -0.002);
        QCOMPARE(reading.measurement->notes.size(), std::size_t{9});
    }

    /// 4 inch are 101.6 mm, and 0.1 mil is 0.00254 mm.
    void aUnitThatMeansOfApiSayHasToBeStatedOfBoth()
    {
        const std::string blocks = "Position Forward Directional Avg Error\n0 0\n4 0.1\n"
                                   "Position Reverse Directional Avg Error\n0 0\n4 0.1\n";
        for (const char* line : {"Units: inch\n", "UNIT=Inch\n", "Units in\n"}) {
            MeasurementReadOptions options;
            options.unit = "inch";
            const auto half = test::readAs("api-pos", line + blocks, options);
            QVERIFY(!half.measurement && half.diagnostics.size() == 1);
            QCOMPARE(half.diagnostics[0].code, DiagnosticCode::UnitMissing);
            options.valueUnit = "mil";
            const auto whole = test::readAs("api-pos", line + blocks, options);
            VERIFY_MEASUREMENT(whole);
            QVERIFY(std::abs(whole.measurement->targets.back() - 101.6) < 1e-12);
            QVERIFY(std::abs(valueAt(*whole.measurement, Approach::Up, 1, 1) - 0.00254) < 1e-12);
            QVERIFY(!whole.measurement->againstFile.units.empty());
            QCOMPARE(whole.measurement->againstFile.units.back().what, std::string("values"));
            QCOMPARE(whole.measurement->againstFile.units.back().stated, std::string("mil"));
        }
        for (const char* line : {"Units: mm\n", "Units Millimeter\n", "Unit 4\n"})
            VERIFY_MEASUREMENT(test::readAs("api-pos", line + blocks));
    }

    void aReportIsReadAsPrinted()
    {
        const MeasurementReading reading = test::readAs("ecmc-report",
            "# ISO 230-2 motion test\n\n### Data forward direction\n\ni |tgt_pos(i) "
            "[mm]|ref_pos(i,1) "
            "[mm]|ref_pos(i,2) [mm]|\n--- |--- |--- |--- |\n1|0.0|0.00100|0.00200|\n"
            "2|10.0|10.00300|10.00300|\n\n### Data backward direction\n\ni |tgt_pos(i) "
            "[mm]|ref_pos(i,1) [mm]|ref_pos(i,2) [mm]|\n--- |--- |--- |--- |\n"
            "1|0.0|-0.00100|-.00100|\n2|10.0|10.00000|10.00200|\n\n### Positioning\n\nB(i) = "
            "something [mm]\n\n**B = Axis reversal error [mm]**\n\n**B = 0.00250 [mm]**\n\nE_fwd = "
            "0.00150 [mm]\n");
        VERIFY_MEASUREMENT(reading);
        QCOMPARE(reading.diagnostics.size(), std::size_t{1});
        QCOMPARE(reading.diagnostics[0].code, DiagnosticCode::DirectionsDoubtful);
        QVERIFY(std::abs(valueAt(*reading.measurement, Approach::Up, 0, 2) - 0.002) < 1e-15);
        QVERIFY(std::abs(valueAt(*reading.measurement, Approach::Down, 0, 2) + 0.001) < 1e-15);
        QCOMPARE(reading.measurement->published.size(), std::size_t{2});
        QCOMPARE(reading.measurement->published[0].value, 0.0025);
        QCOMPARE(reading.measurement->published[0].halfUnit, 0.5e-5);
        QCOMPARE(reading.measurement->published[1].name, "EUp");
        QCOMPARE(reading.measurement->halfPrintedUnit, 0.5e-5);
    }

    void aTrackTakesItsDirectionFromTheMotion()
    {
        std::string text = "encoder [mm],reference [mm]\n";
        for (int i = 0; i <= 100; ++i)
            text += std::to_string(i) + "," + std::to_string(i) + "\n";
        for (int i = 99; i >= 0; --i)
            text += std::to_string(i) + "," + std::to_string(i) + ".001\n";
        MeasurementReadOptions options;
        options.overrun = 5.0;
        const MeasurementReading reading = test::readAs("track", text, options);
        VERIFY_MEASUREMENT(reading);
        const std::vector<TrackSample>& track = reading.measurement->track;
        // Up from 5 to 100, down from 95 to 0.
        QCOMPARE(track.size(), std::size_t{96 + 96});
        QCOMPARE(track.front().encoder, 5.0);
        QCOMPARE(track[95].direction, Approach::Up);
        QCOMPARE(track[96].encoder, 95.0);
        QCOMPARE(track[96].direction, Approach::Down);
        QCOMPARE(reading.diagnostics[0].code, DiagnosticCode::LeftOut);
        QCOMPARE(reading.diagnostics[0].found.arguments().integer("count"),
            std::optional<std::int64_t>(9));
    }

    void pointsHoldValuesOrReferences()
    {
        const MeasurementReading reading = test::readAs("points",
            "X [mm],Y [mm],Xr [mm],dY [um]\n0,0,0.001,5\n10,0,9.999,6\n0,10,0,7\n0,10,0,7\n");
        VERIFY_MEASUREMENT(reading);
        const MeasuredPoints& points = reading.measurement->points;
        QCOMPARE(points.axes, (std::vector<std::string>{"X", "Y"}));
        QCOMPARE(points.columns, (std::vector<std::string>{"dX", "dY"}));
        QCOMPARE(points.size(), std::size_t{4});
        QVERIFY(std::abs(points.values[0][1] + 0.001) < 1e-12);
        QCOMPARE(points.values[1][2], 0.007);
    }

    void whatWasAskedForAgainstAFileIsSaidOfTheWhole()
    {
        MeasurementReadOptions options;
        options.invertsReference = true;
        const MeasurementReading inverted = test::readAs("runs",
            "target [mm],direction,reference [mm]\n0,+,0\n50,+,-50.001\n100,+,-100.001\n", options);
        VERIFY_MEASUREMENT(inverted);
        const MeasurementReading plain = test::readAs(
            "runs", "target [mm],direction,reference [mm]\n0,+,0\n50,+,50.002\n100,+,100.002\n");
        VERIFY_MEASUREMENT(plain);
        QCOMPARE(plain.measurement->againstFile, AgainstFile());
        const std::array both{*plain.measurement, *inverted.measurement};
        const auto whole = selected(both, true, {});
        VERIFY_RESULT(whole);
        std::vector<std::string> said;
        for (const Text& text : againstFileTexts(whole->againstFile))
            said.push_back(text.english());
        QCOMPARE(said,
            (std::vector<std::string>{
                "up and down exchanged", "reference taken with the opposite sign"}));
        const std::string csv = writeRunsCsv(*whole);
        QVERIFY2(csv.find("// up and down exchanged\n// reference taken") != std::string::npos,
            csv.c_str());
        std::string samples = "encoder [mm],reference [mm]\n";
        for (int n = 0; n < 40; ++n)
            samples += std::to_string(n) + ",-" + std::to_string(n) + "\n";
        const MeasurementReading track = test::readAs("track", samples, options);
        VERIFY_MEASUREMENT(track);
        QVERIFY(track.measurement->againstFile.invertsReference);
        const MeasurementReading points = test::readAs("points",
            "X [mm],Y [mm],Xr [mm]\n0,0,0\n10,0,-10\n0,10,0\n10,10,-10\n20,0,-20\n20,10,-20\n",
            options);
        VERIFY_MEASUREMENT(points);
        QVERIFY(points.measurement->againstFile.invertsReference);
    }

    void filesAreJoinedRunAfterRun()
    {
        const Measurement one = publicRuns("bifrost.csv");
        const Measurement two = measuredAgain(one, 1e-4);
        const Measurement three = measuredAgain(one, 2e-4);
        const std::array both{one, two};
        const auto whole = joined(both);
        VERIFY_RESULT(whole);
        QCOMPARE(whole->runCount(Approach::Up), 10);
        QCOMPARE(whole->values.size(), std::size_t{100});
        QCOMPARE(valueAt(*whole, Approach::Down, 2, 8), valueAt(two, Approach::Down, 2, 3));
        Measurement on = two;
        on.header.compensation.kind = MeasuredState::Kind::On;
        Measurement off = three;
        off.header.compensation.kind = MeasuredState::Kind::Off;
        const std::array different{on, off};
        VERIFY_ERROR(joined(different), ErrorCode::InvalidArgument);
        Measurement silent = one;
        silent.header.compensation = {};
        const std::array behindOne{silent, on, off};
        VERIFY_ERROR(joined(behindOne), ErrorCode::InvalidArgument);
        const std::array alike{silent, on, measuredAgain(silent, 2e-4)};
        VERIFY_RESULT(joined(alike));
    }

    void filesOfTwoDrivesAreNotJoined()
    {
        Measurement one = publicRuns("bifrost.csv");
        one.header.drive = "Mill, serial number 4711";
        Measurement other = measuredAgain(one, 1e-4);
        other.header.drive = "serial number 4712";
        const std::array two{one, other};
        const auto refused = joined(two);
        VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
        QVERIFY(sentence(refused.error()).find("serial number 4711 and of the one with 4712")
            != std::string::npos);
        other.header.drive = "Lathe, serial number 4711";
        const std::array same{one, other};
        const auto whole = joined(same);
        VERIFY_RESULT(whole);
        QCOMPARE(driveSerialOf(whole->header), std::optional<std::int32_t>(4711));
        one.header.drive = "Mill";
        const std::array nameFirst{one, other};
        const auto told = joined(nameFirst);
        VERIFY_RESULT(told);
        QCOMPARE(driveSerialOf(told->header), std::optional<std::int32_t>(4711));
    }

    void theDriveThatMeasuredIsReadAndWrittenAgain()
    {
        const auto read = test::readAs("runs",
            "// axiscomp runs: 1\n// drive: Mill, serial number 850618\n"
            "target [mm],direction,run,deviation [um]\n0,+,1,1\n10,+,1,2\n");
        QVERIFY(read.measurement);
        const Measurement& measurement = *read.measurement;
        QCOMPARE(measurement.header.drive, std::string("Mill, serial number 850618"));
        QCOMPARE(driveSerialOf(measurement.header), std::optional<std::int32_t>(850618));
        QVERIFY(measurement.notes.empty());
        const auto again = test::readAs("runs", writeRunsCsv(measurement));
        QVERIFY(again.measurement);
        QCOMPARE(again.measurement->header.drive, measurement.header.drive);
        const auto twice = test::readAs("runs",
            "// axiscomp runs: 1\n// drive: Mill, serial number 1\n// drive: Mill, serial number "
            "2\ntarget [mm],direction,run,deviation [um]\n0,+,1,1\n10,+,1,2\n");
        QVERIFY(!twice.measurement);
        for (const char* const unknown : {"Mill", "serial number", "serial number 12x"}) {
            MeasurementHeader header;
            header.drive = unknown;
            QVERIFY(!driveSerialOf(header));
        }
    }

    /// It gives each line the separators of the longest one.
    /// It gives each line the separators of the longest one.
    void aFileThatASpreadsheetHasSavedSaysTheSame()
    {
        for (const char* const text :
            {"// axiscomp runs: 1,,,\n// axis: X,,,\n// drive: Mill, serial number 850618,,\n"
             "// compensation: off,,,\ntarget [mm],direction,run,deviation [um]\n"
             "0,+,1,1\n10,+,1,2\n",
                "// axiscomp runs: 1;;;\n// axis: X;;;\n// drive: Mill, serial number 850618;;;\n"
                "// compensation: off;;;\ntarget [mm];direction;run;deviation [um]\n"
                "0;+;1;1\n10;+;1;2\n"}) {
            const auto read = test::readAs("runs", text);
            VERIFY_MEASUREMENT(read);
            const MeasurementHeader& header = read.measurement->header;
            QCOMPARE(header.axis, std::string("X"));
            QCOMPARE(header.drive, std::string("Mill, serial number 850618"));
            QCOMPARE(header.compensation, MeasuredState(MeasuredState::Kind::Off));
            QCOMPARE(driveSerialOf(header), std::optional<std::int32_t>(850618));
        }
        MeasurementHeader recorded; // by a program that kept the separators
        recorded.drive = "Mill, serial number 850618,,";
        QCOMPARE(driveSerialOf(recorded), std::optional<std::int32_t>(850618));
    }

    /// Neither does the silent one say it, nor may it be stated otherwise.
    void aStateThatOnlySomeFilesSayIsKeptOfThose()
    {
        Measurement silent = publicRuns("bifrost.csv");
        silent.header.compensation = {};
        Measurement on = measuredAgain(silent, 1e-4);
        on.header.compensation = {MeasuredState::Kind::On, 0x11111111};
        for (const auto& files : {std::array{silent, on}, std::array{on, silent}}) {
            const auto whole = joined(files);
            VERIFY_RESULT(whole);
            QCOMPARE(whole->header.compensation.kind, MeasuredState::Kind::NotSaid);
            QVERIFY(whole->header.compensationOfSome == on.header.compensation);
        }
        const std::array bothOn{on, measuredAgain(on, 1e-4)};
        const auto said = joined(bothOn);
        VERIFY_RESULT(said);
        QVERIFY(said->header.compensation == on.header.compensation);
        QCOMPARE(said->header.compensationOfSome.kind, MeasuredState::Kind::NotSaid);
    }

    /// One of them would be corrected twice, or not at all.
    void filesThatAreCorrectedDifferentlyAreNotJoined()
    {
        using Corrected = MeasurementHeader::Corrected;
        const Corrected all[] = {Corrected::NotSaid, Corrected::None, Corrected::To20Celsius};
        for (const Corrected first : all)
            for (const Corrected second : all) {
                std::array both{
                    publicRuns("bifrost.csv"), measuredAgain(publicRuns("bifrost.csv"), 1e-4)};
                both[0].header.corrected = first;
                both[1].header.corrected = second;
                const auto whole = joined(both);
                QCOMPARE(whole.has_value(), first == second);
                if (whole)
                    QCOMPARE(whole->header.corrected, first);
                else
                    QVERIFY(
                        sentence(whole.error()).find("// corrected: none") != std::string::npos);
            }
    }

    void theTemperatureOfTheScaleIsThatOfAllFilesOrNone()
    {
        std::array both{publicRuns("bifrost.csv"), measuredAgain(publicRuns("bifrost.csv"), 1e-4)};
        both[0].header.materialTemperature = both[1].header.materialTemperature = 22.0;
        both[0].header.expansion = 11.5e-6;
        const auto whole = joined(both);
        VERIFY_RESULT(whole);
        QCOMPARE(whole->header.materialTemperature, std::optional(22.0));
        QVERIFY(!whole->header.expansion);
    }

    void aTemperatureOfOneFileIsNotThatOfAll()
    {
        std::array both{publicRuns("bifrost.csv"), measuredAgain(publicRuns("bifrost.csv"), 1e-4)};
        both[0].header.airTemperature = 20.1;
        both[1].header.airTemperature = 27.9;
        both[0].header.instrument.clear();
        both[1].header.instrument = "XL";
        const auto whole = joined(both);
        VERIFY_RESULT(whole);
        QVERIFY(!whole->header.airTemperature);
        QCOMPARE(whole->header.instrument, "XL");
        const std::vector<std::string>& notes = whole->notes;
        QVERIFY(std::ranges::find(notes, "file 1, air temperature: 20.1") != notes.end());
        QVERIFY(std::ranges::find(notes, "file 2, air temperature: 27.9") != notes.end());
    }

    /// Repeatability would be that of half as many runs.
    /// In the order of the files. What is not said is no contradiction, but for a number.
    void whatJoinedFilesSayIsToldOfEach()
    {
        const Measurement one = publicRuns("bifrost.csv");
        std::array three{one, measuredAgain(one, 1e-4), measuredAgain(one, 2e-4)};
        const auto whole = [&] { return joined(three).value_or(Measurement{}); };
        using Header = MeasurementHeader;
        QVERIFY(joined({three.data(), 1})->joined.empty());
        QCOMPARE(saidByFiles(one, &Header::machine).size(), std::size_t{1});
        three[0].header.machine = "M1";
        three[1].header.machine = " m1";
        QVERIFY(!areDifferent(saidByFiles(whole(), &Header::machine)));
        three[1].header.machine = "M2";
        three[2].header.machine = "m1 ";
        const TextsOfFiles machines = saidByFiles(whole(), &Header::machine);
        QVERIFY(areDifferent(machines));
        QCOMPARE(machines.size(), std::size_t{2});
        QCOMPARE(machines[0].said, std::string("M1"));
        QCOMPARE(machines[0].files, (std::vector<std::size_t>{0, 2}));
        QCOMPARE(machines[1].said, std::string("M2"));
        QVERIFY(!areDifferent(saidByFiles(whole(), &Header::airTemperature)));
        three[1].header.airTemperature = 20.5;
        QVERIFY(areDifferent(saidByFiles(whole(), &Header::airTemperature)));
        three[0].header.airTemperature = three[2].header.airTemperature = 20.5;
        QVERIFY(!areDifferent(saidByFiles(whole(), &Header::airTemperature)));
    }

    void theSameMeasurementIsNotJoinedTwice()
    {
        const Measurement one = publicRuns("bifrost.csv");
        const std::array files{one, measuredAgain(one, 1e-4), one};
        const auto refused = joined(files);
        VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
        QVERIFY2(sentence(refused.error()).find("file 3 holds the same measurement as file 1")
                != std::string::npos,
            sentence(refused.error()).c_str());
    }

    void filesOfTwoAxesAreNotJoined()
    {
        std::array both{publicRuns("bifrost.csv"), measuredAgain(publicRuns("bifrost.csv"), 1e-4)};
        both[0].header.axis = "X";
        both[1].header.axis = "Y";
        const auto refused = joined(both);
        VERIFY_ERROR(refused, ErrorCode::InvalidArgument);
        QVERIFY(sentence(refused.error()).find("of axis X and of axis Y") != std::string::npos);
        both[1].header.axis.clear();
        VERIFY_RESULT(joined(both));
    }

    void theAxisOfJoinedFilesIsTheFirstThatIsSaid()
    {
        const Measurement one = publicRuns("bifrost.csv");
        std::array files{one, measuredAgain(one, 1e-4), measuredAgain(one, 2e-4)};
        files[0].header.axis.clear();
        files[1].header.axis = "X";
        files[2].header.axis = "Y";
        VERIFY_ERROR(joined(files), ErrorCode::InvalidArgument);
        files[2].header.axis.clear();
        const auto whole = joined(files);
        VERIFY_RESULT(whole);
        QCOMPARE(whole->header.axis, "X");
    }

    void exclusionsAreReadAndChecked()
    {
        const auto exclusions = exclusionsFromText("down:1:1, run:up:3,target:7");
        VERIFY_RESULT(exclusions);
        QCOMPARE(exclusions->size(), std::size_t{3});
        QVERIFY(exclusions->at(0) == (Exclusion{Approach::Down, 1, 1}));
        QVERIFY(exclusions->at(1) == (Exclusion{Approach::Up, {}, 3}));
        QVERIFY(exclusions->at(2) == (Exclusion{{}, 7, {}}));
        for (const char* bad :
            {"", "down", "down:0:1", "side:1:1", "run:up", "target:x", "down:1:1:1"})
            VERIFY_ERROR(exclusionsFromText(bad), ErrorCode::InvalidArgument);
        Measurement m = publicRuns("bifrost.csv");
        const Exclusion missing{Approach::Up, {}, 6};
        VERIFY_ERROR(exclude(m, std::span(&missing, 1)), ErrorCode::InvalidArgument);
    }

    void eachValueIsLeftOutAlone()
    {
        const Measurement whole = publicRuns("bifrost.csv");
        for (std::size_t n = 0; n < whole.values.size(); ++n) {
            const RunValue& value = whole.values[n];
            Measurement m = whole;
            const Exclusion one{value.direction, value.target + 1, value.run};
            QVERIFY(exclude(m, std::span(&one, 1)));
            for (std::size_t other = 0; other < m.values.size(); ++other)
                QCOMPARE(m.values[other].isUsed, other != n);
        }
        Measurement m = whole;
        const Exclusion missing{Approach::Down, m.targets.size() + 1, 1};
        VERIFY_ERROR(exclude(m, std::span(&missing, 1)), ErrorCode::InvalidArgument);
    }
};

AXISCOMP_TEST(tst_MeasurementFiles)

} // namespace tst_measurementfiles

#include "tst_measurementfiles.moc"
