// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/measurement_fit.h"
#include "core/metrology/run_selection.h"
#include "core/table/lookup.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <algorithm>
#include <cmath>

namespace tst_temperaturefit {

using namespace axiscomp;

namespace {

constexpr double expansion = 11.5e-6;

/// A scale that expands, and a bend that does not.
double errorAt(double position, double temperature)
{
    return expansion * (temperature - 20.0) * position + 1e-8 * position * (position - 500.0);
}

/// 11 targets from 0 to 500 mm, a run up and one down at each temperature.
template <typename Error> Measurement measured(const std::vector<double>& temperatures, Error error)
{
    Measurement runs;
    runs.header.axis = "X";
    for (int i = 0; i <= 10; ++i)
        runs.targets.push_back(50.0 * i);
    for (const Approach direction : {Approach::Up, Approach::Down})
        for (std::size_t i = 0; i < runs.targets.size(); ++i)
            for (std::size_t n = 0; n < temperatures.size(); ++n) {
                RunValue value{
                    i, direction, static_cast<int>(n) + 1, error(runs.targets[i], temperatures[n])};
                value.temperature = temperatures[n];
                runs.values.push_back(value);
            }
    sortValues(runs.values);
    return runs;
}

FitSettings byTemperature(FitZero zero = FitZero::Keep)
{
    FitSettings settings;
    settings.lookupAt = LookupAt::Encoder;
    settings.zero = zero;
    settings.isByTemperature = true;
    return settings;
}

Result<FitReport> fitted(const Measurement& measurement, const FitSettings& settings)
{
    return fitMeasurement(measurement, settings, FoundState{});
}

void verifyRefused(const Result<FitReport>& report, std::string_view words)
{
    QVERIFY(!report);
    const std::string text = sentence(report.error());
    QVERIFY2(text.find(words) != std::string::npos, text.c_str());
}

bool isSaid(const FitReport& report, std::string_view name, std::string_view words)
{
    return std::ranges::any_of(report.remarks, [&](const FitRemark& remark) {
        return remark.name == name && remark.text.english().find(words) != std::string::npos;
    });
}

} // namespace

/// AN140 1.1 names the temperature as an input of a table. The machine here has a closed form.
class TestTemperatureFit : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    /// Up and down by 10 um from target to target, and 60 um of reversal when it is warm.
    void aTableOverTemperatureSaysWhatATableOfRunsSays()
    {
        Measurement runs = measured({20.0, 26.0}, [](double position, double) {
            return std::fmod(position, 100.0) == 0.0 ? 0.005 : -0.005;
        });
        for (RunValue& value : runs.values)
            if (*value.temperature > 25.0)
                value.deviation += value.direction == Approach::Up ? 0.03 : -0.03;
        FitSettings settings = byTemperature();
        settings.home = 250.0;
        const auto report = fitted(runs, settings);
        VERIFY_RESULT(report);
        QVERIFY(isSaid(*report, "BetweenTargets", "measure at more targets"));
        QVERIFY(isSaid(*report, "MostlyReversal", "up to 30.000 um remains in each direction"));
        QVERIFY(isSaid(*report, "LittleImprovement", "less than a fifth"));
        QVERIFY(isSaid(*report, "ValueAtHome", "at 20 degC: dX adds"));
        QVERIFY(isSaid(*report, "ValueAtHome", "at 26 degC: dX adds"));
        QVERIFY(!isSaid(*report, "ValuesExcluded", ""));
        runs.values.front().isUsed = false;
        const auto without = fitted(runs, settings);
        QVERIFY(!without); // the first target has no value of one direction
    }

    /// A run that starts 30 um beside the four others of its state, of which each has its own
    /// place.
    void eachThermalStateIsJudgedByItself()
    {
        Measurement runs =
            measured({20.0, 20.01, 20.02, 20.03, 20.04, 26.0, 26.01, 26.02, 26.03, 26.04},
                [](double position, double temperature) {
                    return errorAt(position, temperature)
                        + (temperature > 25.0 ? 1.0 : 0.0) * 1e-3 * (temperature - 26.0);
                });
        const auto drifting = fitted(runs, byTemperature());
        VERIFY_RESULT(drifting);
        QVERIFY(!isSaid(*drifting, "OutliersLeftIn", ""));
        for (RunValue& value : runs.values)
            if (value.target == 5 && value.run == 3)
                value.deviation += 0.03;
        const auto report = fitted(runs, byTemperature());
        VERIFY_RESULT(report);
        QVERIFY(isSaid(*report, "OutliersLeftIn", "2 values"));
    }

    void whatJoinedFilesSayOfTheirMachineIsSaidOnce()
    {
        Measurement cold = measured({20.0}, &errorAt);
        Measurement warm = measured({26.0}, &errorAt);
        cold.header.machine = "M1";
        warm.header.machine = "M2";
        const std::array files{cold, warm};
        const auto whole = joined(files);
        VERIFY_RESULT(whole);
        const auto report = fitted(*whole, byTemperature());
        VERIFY_RESULT(report);
        QVERIFY(isSaid(*report, "OtherMachine", "the files are of different machines: M1"));
        QCOMPARE(std::ranges::count(report->remarks, "OtherMachine", &FitRemark::name), 1);
    }

    void aLineJoinsUpToFourStates()
    {
        const auto report = fitted(measured({20.0, 23.0, 26.0}, &errorAt), byTemperature());
        VERIFY_RESULT(report);
        const CompensationTable& table = report->tables.front().table;
        QCOMPARE(table.grid.dimensions(), 2);
        QCOMPARE(table.grid.axes[1].unit, std::string("degC"));
        QCOMPARE(table.grid.axes[1].size, 2U);
        QCOMPARE(table.grid.axes[1].start, 20.0);
        QCOMPARE(table.grid.axes[1].last(), 26.0);
        QCOMPARE(table.target, std::string("X"));
        const Lookup lookup(table, Outside::Hold);
        for (const double position : {0.0, 50.0, 500.0})
            for (const double temperature : {20.0, 21.5, 26.0})
                QVERIFY(std::abs(lookup.at(std::vector<double>{position, temperature})
                            - errorAt(position, temperature))
                    < 1e-9);
        // Outside of what was measured the ends hold.
        QVERIFY(
            std::abs(lookup.at(std::vector<double>{500.0, 40.0}) - errorAt(500.0, 26.0)) < 1e-9);
    }

    /// 0.05 sin(x / 80), which is 0.1 um higher for each kelvin: the axis stands without the zero
    /// of the instrument, at every temperature.
    void theZeroOfTheInstrumentMovesNoStateAtTheSetPosition()
    {
        FitSettings settings = byTemperature(FitZero::First);
        settings.lookupAt = LookupAt::Set;
        std::vector<float> without;
        for (const double ofInstrument : {0.0, 0.9, 17.3}) {
            const auto report = fitted(measured({20.0, 23.0},
                                           [ofInstrument](double position, double temperature) {
                                               return 0.05 * std::sin(position / 80.0)
                                                   + 1e-4 * (temperature - 20.0) + ofInstrument;
                                           }),
                settings);
            VERIFY_RESULT(report);
            const auto& values = report->tables.front().table.values;
            if (without.empty())
                without = values;
            QCOMPARE(values.size(), without.size());
            for (std::size_t i = 0; i < values.size(); ++i)
                QVERIFY(std::abs(values[i] - without[i]) < 1e-8F);
            QVERIFY(*(*report->predicted)[Iso230Figure::M].value < 1e-7);
        }
    }

    /// A drive's old table knows nothing of the temperature.
    void nothingIsMergedOverTemperature()
    {
        Measurement runs = measured({20.0, 23.0, 26.0}, &errorAt);
        KnownTables old{Verbatim{"old.csv"}, {{}}, {1}};
        old.tables.front().grid.axes = {{"X", "mm", 0.0, 50.0, 11}};
        old.tables.front().values.assign(11, 0.0F);
        verifyRefused(fitMeasurement(runs, byTemperature(), {FoundState::Kind::On, &old, {}, {}}),
            "with the compensation off");
        for (RunValue& value : runs.values)
            value.encoder = runs.targets[value.target];
        verifyRefused(
            fitMeasurement(runs, byTemperature(), {FoundState::Kind::Irrelevant, &old, {}, {}}),
            "leave out --onto");
    }

    void withFewerThanFiveStatesTheLineIsThatOfLeastSquares()
    {
        // At 500 mm 0, 1, 5 um at 20, 22, 24 degrees: the line is -0.5, 2, 4.5 um.
        const auto error = [](double position, double temperature) {
            const double um = temperature < 21.0 ? 0.0 : temperature < 23.0 ? 1.0 : 5.0;
            return um * 1e-3 * position / 500.0;
        };
        const auto report = fitted(measured({20.0, 22.0, 24.0}, error), byTemperature());
        VERIFY_RESULT(report);
        const Lookup lookup(report->tables.front().table, Outside::Hold);
        QVERIFY(std::abs(lookup.at(std::vector<double>{500.0, 20.0}) + 0.0005) < 1e-9);
        QVERIFY(std::abs(lookup.at(std::vector<double>{500.0, 24.0}) - 0.0045) < 1e-9);
        QVERIFY(std::abs(report->tables.front().residualLargest - 0.001) < 1e-9);
        // 0, 3, 3 um at 20, 21, 26 degrees: 7 / 20.667 um/K through 2 um at 22.333 degrees.
        const auto uneven =
            fitted(measured({20.0, 21.0, 26.0},
                       [](double position, double temperature) {
                           return (temperature < 20.5 ? 0.0 : 0.003) * position / 500.0;
                       }),
                byTemperature());
        VERIFY_RESULT(uneven);
        const Lookup line(uneven->tables.front().table, Outside::Hold);
        QVERIFY(std::abs(line.at(std::vector<double>{500.0, 20.0}) - 0.00120967742) < 1e-9);
        QVERIFY(std::abs(line.at(std::vector<double>{500.0, 26.0}) - 0.00324193548) < 1e-9);
    }

    void moreStatesAreJoinedFromOneToTheNext()
    {
        const auto bent = [](double position, double temperature) {
            return 1e-6 * position * std::pow(temperature - 22.0, 2);
        };
        const auto report = fitted(measured({20.0, 21.0, 22.0, 23.0, 24.0}, bent), byTemperature());
        VERIFY_RESULT(report);
        const CompensationTable& table = report->tables.front().table;
        QCOMPARE(table.grid.axes[1].size, 5U);
        const Lookup lookup(table, Outside::Hold);
        for (const double temperature : {20.0, 21.0, 22.0, 23.0, 24.0})
            QVERIFY(std::abs(lookup.at(std::vector<double>{500.0, temperature})
                        - bent(500.0, temperature))
                < 1e-9);
        QCOMPARE(report->tables.front().residualLargest, 0.0);
    }

    /// The zero moves with the temperature, and the drive has to follow it.
    void theZeroIsThatOfTheStateNearestTo20Degrees()
    {
        const auto drifting = [](double position, double temperature) {
            return 0.010 + 0.001 * (temperature - 20.0) + 1e-6 * position;
        };
        const auto report =
            fitted(measured({26.0, 20.5, 23.0}, drifting), byTemperature(FitZero::First));
        VERIFY_RESULT(report);
        const Lookup lookup(report->tables.front().table, Outside::Hold);
        QVERIFY(std::abs(lookup.at(std::vector<double>{0.0, 20.5})) < 1e-9);
        QVERIFY(std::abs(lookup.at(std::vector<double>{0.0, 26.0}) - 0.0055) < 1e-9);
        QVERIFY(std::abs(report->tables.front().removedConstant - 0.0105) < 1e-9);
        QVERIFY(std::ranges::any_of(report->remarks, [](const FitRemark& remark) {
            return remark.name == "InstrumentZeroKept" && remark.isWarning;
        }));
    }

    void theFiguresAreForetoldForEachRunAtItsTemperature()
    {
        const auto report = fitted(measured({20.0, 23.0, 26.0}, &errorAt), byTemperature());
        VERIFY_RESULT(report);
        // A table without temperature would leave half of 34.5 um.
        QVERIFY((*report->before)[Iso230Figure::R].value.value_or(0.0) > 0.06);
        QVERIFY((*report->predicted)[Iso230Figure::A].value.value_or(1.0) < 1e-8);
        QVERIFY(report->heldOut.has_value());
        QVERIFY(report->sign.english().find("at 20 degC") == 0);
    }

    /// Of 0, 1, 5 um at 500 mm the line leaves 0.5, -1, 0.5 um: the mean of all runs is 0, and at
    /// 22 degrees the axis is 1 um off.
    void whatTheLineLeavesOfAStateIsForetold()
    {
        const auto error = [](double position, double temperature) {
            const double um = temperature < 21.0 ? 0.0 : temperature < 23.0 ? 1.0 : 5.0;
            return um * 1e-3 * position / 500.0;
        };
        FitSettings settings = byTemperature();
        settings.tolerances = {{Iso230Figure::M, 0.0005}};
        const auto report = fitted(measured({20.0, 22.0, 24.0}, error), settings);
        VERIFY_RESULT(report);
        QVERIFY(std::abs(*(*report->before)[Iso230Figure::M].value - 0.005) < 1e-12);
        for (const Iso230Figure figure : {Iso230Figure::M, Iso230Figure::E})
            QVERIFY(std::abs(*(*report->predicted)[figure].value - 0.001) < 1e-8);
        QVERIFY(!report->isWithinTolerances());
        // By Python, the rms of (0.5, 1, 0.5) x (0.1 .. 0.9): the ends are not left out, but count
        QVERIFY(std::abs(report->heldOut->range - 0.001) < 1e-8);
        QVERIFY(std::abs(report->heldOut->largest - 0.001) < 1e-8);
        QVERIFY(std::abs(report->heldOut->rms - 0.00039791121) < 1e-8);
        QVERIFY(std::ranges::count(report->remarks, "FiguresOfStates", &FitRemark::name) == 1);
    }

    void theGridTakesASecondNumberForTheTemperature()
    {
        FitSettings settings = byTemperature();
        settings.grid = {{.distance = 100.0}, {.distance = 2.5}};
        auto report = fitted(measured({20.0, 23.0, 26.0}, &errorAt), settings);
        VERIFY_RESULT(report);
        const Grid& grid = report->tables.front().table.grid;
        QCOMPARE(grid.axes[0].size, 6U);
        QCOMPARE(grid.axes[1].size, 4U); // at most 2.5 apart, from one end to the other
        QCOMPARE(grid.axes[1].distance, 2.0);
        settings.grid[1] = {.points = 7};
        report = fitted(measured({20.0, 23.0, 26.0}, &errorAt), settings);
        VERIFY_RESULT(report);
        QCOMPARE(report->tables.front().table.grid.axes[1].distance, 1.0);
        settings.mostPoints = 41;
        verifyRefused(fitted(measured({20.0, 23.0, 26.0}, &errorAt), settings), "has 42 points");
        settings.grid[1] = {.distance = 1e-300}; // more than a number of points can be
        verifyRefused(
            fitted(measured({20.0, 23.0, 26.0}, &errorAt), settings), "and a table holds 41");
    }

    void whatCannotTellTheTemperatureIsRefused()
    {
        verifyRefused(fitted(measured({20.0, 20.9}, &errorAt), byTemperature()),
            "2 thermal states that span 0.9 K");
        verifyRefused(fitted(measured({20.0, 20.4, 20.8, 21.2}, &errorAt), byTemperature()),
            "in one thermal state");
        Measurement restless = measured({20.0, 23.0}, &errorAt);
        for (std::size_t n = 0; n < restless.values.size(); ++n)
            *restless.values[n].temperature += n % 4 < 2 ? 0.8 : -0.8;
        verifyRefused(fitted(restless, byTemperature()), "let the machine settle");
        Measurement without = measured({20.0, 23.0}, &errorAt);
        without.values[3].temperature.reset();
        verifyRefused(fitted(without, byTemperature()), "1 value has no temperature");
        Measurement shorter = measured({20.0, 23.0}, &errorAt);
        for (RunValue& value : shorter.values)
            value.isUsed = value.run == 1 || value.target < 10;
        verifyRefused(fitted(shorter, byTemperature()), "measure the same range");
        Measurement track;
        track.kind = MeasurementKind::Track;
        track.track = {{0.0, 0.0}, {1.0, 1.0}, {2.0, 2.0}};
        verifyRefused(fitted(track, byTemperature()), "runs with targets");
    }
};

AXISCOMP_TEST(TestTemperatureFit)

} // namespace tst_temperaturefit

#include "tst_temperaturefit.moc"
