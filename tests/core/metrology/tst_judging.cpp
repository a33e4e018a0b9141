// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fine_quantity.h"
#include "core/metrology/judge/corrections.h"
#include "core/metrology/judge/judgement.h"
#include "core/metrology/run_selection.h"
#include "tests/core/metrology/measurement_reading.h"
#include "tests/support/test_registry.h"

#include <cmath>
#include <random>

namespace tst_judging {

using namespace axiscomp;
using Figure = Iso230Figure;

namespace {

constexpr double tolerance = 1e-6; // mm

Measurement publicRuns(const std::string& name)
{
    return test::readAs("runs", test::publicMeasurement(name)).measurement.value_or(Measurement{});
}

double value(const Iso230Figures& figures, Figure figure)
{
    return figures[figure].value.value_or(std::nan(""));
}

/// As many targets, evenly over the length, with random values.
Measurement noisy(std::size_t targets, double length, int runs, unsigned seed = 1)
{
    std::mt19937 random(seed);
    std::normal_distribution<double> normal(0.0, 0.001);
    Measurement measurement;
    for (std::size_t i = 0; i < targets; ++i)
        measurement.targets.push_back(
            length * static_cast<double>(i) / static_cast<double>(targets - 1));
    for (std::size_t i = 0; i < targets; ++i)
        for (const Approach direction : {Approach::Up, Approach::Down})
            for (int run = 1; run <= runs; ++run) {
                RunValue one;
                one.target = i;
                one.direction = direction;
                one.run = run;
                one.deviation = normal(random);
                measurement.values.push_back(one);
            }
    sortValues(measurement.values);
    return measurement;
}

std::optional<bool> metOf(const std::vector<ComplianceLine>& lines, std::string_view rule)
{
    for (const ComplianceLine& line : lines)
        if (line.rule == rule)
            return line.isMet;
    return std::nullopt;
}

} // namespace

class tst_Judging : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    void outliersOfAPublicMeasurement()
    {
        const Measurement measurement = publicRuns("ess_mcu1025.csv");
        const Outliers outliers = findOutliers(measurement, OutlierRule::PooledMad);
        QVERIFY(outliers.up.flagged.empty());
        QCOMPARE(outliers.down.flagged.size(), std::size_t{2});
        const Outlier& first = outliers.down.flagged[0];
        const Outlier& second = outliers.down.flagged[1];
        QCOMPARE(first.target, std::size_t{0});
        QCOMPARE(first.run, 1);
        QVERIFY2(std::abs(first.score - 19.951) < 5e-4, std::to_string(first.score).c_str());
        QCOMPARE(second.target, std::size_t{1});
        QCOMPARE(second.run, 1);
        QVERIFY2(std::abs(second.score - 17.500) < 5e-4, std::to_string(second.score).c_str());
        QCOMPARE(exclusionText(exclusionOf(first)), "down:1:1");
    }

    void measurementsInOrderHaveNoOutliers()
    {
        for (const char* name : {"bifrost.csv", "b02_y.csv"}) {
            const Outliers outliers = findOutliers(publicRuns(name), OutlierRule::PooledMad);
            QVERIFY2(outliers.up.flagged.empty() && outliers.down.flagged.empty(), name);
        }
    }

    void manyOutliersAreADisturbedMeasurement()
    {
        // 30 targets with 5 runs: a fifth are 30 values.
        const auto disturbed = [](std::size_t targets) {
            Measurement measurement = noisy(30, 100.0, 5);
            for (RunValue& one : measurement.values)
                if (one.direction == Approach::Up && one.target < targets && one.run <= 2)
                    one.deviation += one.run == 1 ? 1.0 : -1.0;
            return findOutliers(measurement, OutlierRule::PooledMad);
        };
        const Outliers fifth = disturbed(15);
        QCOMPARE(fifth.up.flagged.size(), std::size_t{30});
        QVERIFY(!fifth.up.isDisturbed);
        const Outliers more = disturbed(16);
        QVERIFY(more.up.flagged.empty());
        QVERIFY(more.up.isDisturbed);
        QVERIFY(!more.down.isDisturbed);
    }

    void noGroupKeepsFewerThanThreeValues()
    {
        Measurement measurement = noisy(10, 100.0, 3);
        QVERIFY(!findOutliers(measurement, OutlierRule::PooledMad).up.isUndecided);
        measurement.values.front().deviation += 1.0;
        const Outliers outliers = findOutliers(measurement, OutlierRule::PooledMad);
        QVERIFY(outliers.up.flagged.empty());
        // "none" would not be so.
        QVERIFY(outliers.up.isUndecided && !outliers.down.isUndecided);
        const Judgement judgement = judge(measurement, {});
        QCOMPARE(judgement.warnings.size(), std::size_t{1});
        QCOMPARE(judgement.warnings[0].name, std::string("OutliersNotTested"));
    }

    void whereAllOthersAreEqualNothingIsUnusual()
    {
        Measurement measurement = noisy(10, 100.0, 5);
        for (RunValue& one : measurement.values)
            one.deviation = 0.0;
        QVERIFY(!findOutliers(measurement, OutlierRule::PooledMad).up.isUndecided);
        measurement.values.front().deviation = 0.089;
        QVERIFY(findOutliers(measurement, OutlierRule::PooledMad).up.isUndecided);
    }

    void residualsOfSmallGroupsCountAsMuch()
    {
        // Up: 20 targets with values -1 0 1 (n = 3), one with -2.6 and five at 0.52 (n = 6).
        // Without the factor sqrt(n / (n - 1)) sigma is 1.4826 instead of 1.8158.
        Measurement measurement = noisy(21, 100.0, 6);
        std::erase_if(
            measurement.values, [](const RunValue& one) { return one.target < 20 && one.run > 3; });
        for (RunValue& one : measurement.values)
            one.deviation = one.target < 20 ? one.run - 2.0 : one.run == 1 ? -2.6 : 0.52;
        const Outliers outliers = findOutliers(measurement, OutlierRule::PooledMad);
        QVERIFY(std::abs(*outliers.up.sigma - 1.4826 * std::sqrt(1.5)) < 1e-12);
    }

    void grubbsTestsEachGroup()
    {
        // (x - mean) / s of 0 0 0 1 is 1.5, of 0 0 0 0 1 is 1.7889: limits 1.4812 and 1.7150.
        Measurement measurement = noisy(2, 1.0, 4);
        for (RunValue& one : measurement.values)
            one.deviation = one.target == 0 && one.run == 2 ? 1.0 : 0.0;
        const Outliers outliers = findOutliers(measurement, OutlierRule::Grubbs);
        QCOMPARE(outliers.up.flagged.size(), std::size_t{1});
        QCOMPARE(outliers.up.flagged[0].run, 2);
        QVERIFY(std::abs(outliers.up.flagged[0].score - 1.5) < 1e-12);
        // 0 1 2 3: 1.1619 is below the limit.
        for (RunValue& one : measurement.values)
            one.deviation = one.run;
        QVERIFY(findOutliers(measurement, OutlierRule::Grubbs).up.flagged.empty());
        QVERIFY(!findOutliers(measurement, OutlierRule::Grubbs).up.isUndecided);
        QVERIFY(findOutliers(noisy(2, 1.0, 11), OutlierRule::Grubbs).up.isUndecided);
    }

    void driftIsSuspectedWhereItIs()
    {
        for (const char* name : {"bifrost.csv", "b02_x.csv", "b02_y.csv", "ess_mcu1025.csv"}) {
            const bool drifts = std::string_view(name).starts_with("b02");
            const Measurement measurement = publicRuns(name);
            QCOMPARE(driftOf(measurement, Approach::Up).isSuspected, drifts);
            QCOMPARE(driftOf(measurement, Approach::Down).isSuspected, drifts);
        }
    }

    void driftOfAPublicMeasurement()
    {
        const Measurement measurement = publicRuns("b02_y.csv");
        const DirectionDrift up = driftOf(measurement, Approach::Up);
        const DirectionDrift down = driftOf(measurement, Approach::Down);
        QVERIFY(std::abs(*up.firstToLast + 0.0122526) < tolerance);
        QVERIFY(std::abs(*down.firstToLast + 0.0132020) < tolerance);
        const Iso230Figures without =
            iso230Figures(withoutDrift(measurement, DriftRemoval::Offset));
        QVERIFY(std::abs(value(without, Figure::A) - 0.1139873) < tolerance);
        QVERIFY(std::abs(value(without, Figure::R) - 0.0330848) < tolerance);
        for (const TargetFigures& target : without.targets)
            QVERIFY(std::abs(*target.mean - *iso230Figures(measurement).targets[target.target].mean)
                < 1e-12);
    }

    void trendOverTimeAndTemperature()
    {
        // 2 um for each run, a run every half hour, 0.1 K warmer each time.
        Measurement measurement = noisy(3, 10.0, 4);
        for (RunValue& one : measurement.values) {
            one.deviation = 0.002 * one.run;
            one.time = 1800.0 * one.run;
            one.temperature = 20.0 + 0.1 * one.run;
        }
        const DirectionDrift drift = driftOf(measurement, Approach::Up);
        QVERIFY(std::abs(*drift.trendPerRun - 0.002) < 1e-12);
        QVERIFY(std::abs(*drift.trendPerHour - 0.004) < 1e-12);
        QVERIFY(std::abs(*drift.trendPerKelvin - 0.02) < 1e-9);
        const Measurement level = withoutDrift(measurement, DriftRemoval::Trend);
        for (const RunValue& one : level.values)
            QVERIFY(std::abs(one.deviation - 0.005) < 1e-12);
    }

    void uncertaintyOfTheExample()
    {
        const auto budget = uncertaintyBudgetFromJson(
            R"({"length": 500, "device": 0.0002, "devicePpm": 0.5, "misalignment": 0.5,
                "expansion": 11.5e-6, "temperatureRange": 0.4, "temperature": 22.5,
                "expansionRange": 2e-6, "environment": 0.0006})",
            1.0);
        VERIFY_RESULT(budget);
        QVERIFY(std::abs(uncertaintyOf(*budget).total - 0.0021191) < 1e-7);
        VERIFY_ERROR(
            uncertaintyBudgetFromJson(R"({"lenght": 1})", 1.0), ErrorCode::InvalidArgument);
        VERIFY_ERROR(
            uncertaintyBudgetFromJson(R"({"device": -1})", 1.0), ErrorCode::InvalidArgument);
        const auto own = uncertaintyBudgetFromJson(R"({"devicePpm": 1})", 2000.0);
        VERIFY_RESULT(own);
        QVERIFY(std::abs(uncertaintyOf(*own).total - 0.002) < 1e-12);
    }

    /// A coefficient is never assumed, and neither is what is multiplied by it.
    void aBudgetThatLacksHalfOfATermIsRefused_data()
    {
        QTest::addColumn<QByteArray>("budget");
        QTest::addColumn<QByteArray>("words"); // empty: it is complete
        QTest::newRow("no coefficient")
            << QByteArray(R"({"device": 0.0002, "temperatureRange": 2})")
            << QByteArray("temperatureRange: this counts only with expansion, which is missing");
        QTest::newRow("no range of the temperature")
            << QByteArray(R"({"device": 0.0002, "expansion": 11.5e-6})")
            << QByteArray("expansion: this counts only with temperatureRange");
        QTest::newRow("no temperature")
            << QByteArray(R"({"device": 0.0002, "expansionRange": 2e-6})")
            << QByteArray("expansionRange: this counts only with temperature, which is missing");
        QTest::newRow("no range of the coefficient")
            << QByteArray(R"({"device": 0.0002, "temperature": 25, "expansion": 11.5e-6})")
            << QByteArray("this counts only with");
        QTest::newRow("nothing") << QByteArray("{}")
                                 << QByteArray("it states no term of the uncertainty");
        QTest::newRow("a length alone")
            << QByteArray(R"({"length": 500})") << QByteArray("it states no term");
        QTest::newRow("a device without any") << QByteArray(R"({"device": 0})") << QByteArray();
        QTest::newRow("both") << QByteArray(R"({"expansion": 11.5e-6, "temperatureRange": 2})")
                              << QByteArray();
    }
    void aBudgetThatLacksHalfOfATermIsRefused()
    {
        QFETCH(const QByteArray, budget);
        QFETCH(const QByteArray, words);
        const auto read = uncertaintyBudgetFromJson(budget.toStdString(), 500.0);
        if (words.isEmpty()) {
            VERIFY_RESULT(read);
            return;
        }
        VERIFY_ERROR(read, ErrorCode::InvalidArgument);
        const std::string said = sentence(read.error());
        QVERIFY2(said.find(words.toStdString()) != std::string::npos, said.c_str());
    }

    void aToleranceIsMetBeyondTheUncertaintyOnly()
    {
        const Measurement measurement = publicRuns("bifrost.csv"); // A 0.0185713
        const Iso230Figures figures = iso230Figures(measurement);
        const auto resultOf = [&](const char* text, std::optional<double> u) {
            const auto tolerances = tolerancesFromText(text, false);
            return tolerances ? verdicts(figures, *tolerances, u).front().result
                              : VerdictResult::NotDefined;
        };
        QCOMPARE(resultOf("A=18.6um", std::nullopt), VerdictResult::Passed);
        QCOMPARE(resultOf("A=18.5um", std::nullopt), VerdictResult::Failed);
        QCOMPARE(resultOf("A=20.6um", 0.002), VerdictResult::Passed);
        QCOMPARE(resultOf("A=20.5um", 0.002), VerdictResult::Undecided);
        QCOMPARE(resultOf("A=16.6um", 0.002), VerdictResult::Undecided);
        QCOMPARE(resultOf("A=16.5um", 0.002), VerdictResult::Failed);
        QCOMPARE(resultOf("A=0.0186", std::nullopt), VerdictResult::Passed); // mm
        // Larger than any figure, but not defined.
        Measurement oneWay = measurement;
        std::erase_if(
            oneWay.values, [](const RunValue& one) { return one.direction == Approach::Down; });
        const Tolerance large{Figure::A, 1e9};
        QCOMPARE(verdicts(iso230Figures(oneWay), std::span(&large, 1), {}).front().result,
            VerdictResult::NotDefined);
    }

    /// An instrument that shows tenths of a micrometre meets a limit often, and a double has no
    /// tenths; of positions at 500 mm it has less of them still.
    void aFigureAtItsToleranceIsWithinIt_data()
    {
        QTest::addColumn<double>("zero"); // mm
        QTest::addColumn<double>("low"); // um above it, likewise the next one
        QTest::addColumn<double>("high");
        QTest::addColumn<QByteArray>("tolerance");
        QTest::addColumn<double>("uncertainty"); // um
        QTest::addColumn<QByteArray>("result");
        QTest::newRow("13.3 - 3.3")
            << 0.0 << 3.3 << 13.3 << QByteArray("E=10um") << 0.0 << QByteArray("passed");
        QTest::newRow("8.9 + 1.1")
            << 0.0 << -1.1 << 8.9 << QByteArray("E=10um") << 0.0 << QByteArray("passed");
        QTest::newRow("0.4 - 0.1")
            << 0.0 << 0.1 << 0.4 << QByteArray("E=0.3um") << 0.0 << QByteArray("passed");
        QTest::newRow("0.4 - 0.1 at 500 mm")
            << 500.0 << 0.1 << 0.4 << QByteArray("E=0.3um") << 0.0 << QByteArray("passed");
        QTest::newRow("a picometre above")
            << 0.0 << 0.0 << 10.000001 << QByteArray("E=10um") << 0.0 << QByteArray("failed");
        QTest::newRow("with U at it")
            << 0.0 << 0.0 << 10.0 << QByteArray("E=10.2um") << 0.2 << QByteArray("passed");
        QTest::newRow("without U at it")
            << 0.0 << 0.0 << 10.0 << QByteArray("E=9.6um") << 0.4 << QByteArray("undecided");
        QTest::newRow("without U above it")
            << 0.0 << 0.0 << 10.0 << QByteArray("E=9.599um") << 0.4 << QByteArray("failed");
    }
    void aFigureAtItsToleranceIsWithinIt()
    {
        QFETCH(const double, zero);
        QFETCH(const double, low);
        QFETCH(const double, high);
        QFETCH(const QByteArray, tolerance);
        QFETCH(const double, uncertainty);
        QFETCH(const QByteArray, result);
        Measurement measurement = noisy(2, 100.0, 1);
        for (RunValue& one : measurement.values)
            one.deviation = zero + 1e-3 * (one.target == 0 ? low : high);
        const auto limits = tolerancesFromText(tolerance.toStdString(), false);
        VERIFY_RESULT(limits);
        const auto stated = uncertainty > 0.0 ? std::optional(1e-3 * uncertainty) : std::nullopt;
        const Verdict verdict = verdicts(iso230Figures(measurement), *limits, stated).front();
        QCOMPARE(verdictName(verdict.result), std::string_view(result.constData()));
    }

    void tolerancesAreReadWithTheirUnits()
    {
        const auto tolerances = tolerancesFromText("A=10um, r+=4 um,Bm=0.001", false);
        VERIFY_RESULT(tolerances);
        QVERIFY(tolerances->at(0) == (Tolerance{Figure::A, 0.01}));
        QVERIFY(tolerances->at(1) == (Tolerance{Figure::RUp, 0.004}));
        QVERIFY(tolerances->at(2) == (Tolerance{Figure::MeanReversal, 0.001}));
        VERIFY_RESULT(tolerancesFromText("A=5arcsec", true));
        for (const char* bad : {"", "A", "A=", "F=1um", "A=10s", "A=-1um", "A=1um;R=2um", "A=1deg"})
            VERIFY_ERROR(tolerancesFromText(bad, false), ErrorCode::InvalidArgument);
    }

    void aLimitWithoutAUnitIsSaidAsWhatItIsTaken()
    {
        const auto said = assumedUnits("A=10, R=4um,M=0,E=0.5", false);
        QCOMPARE(said.size(), std::size_t{2});
        QCOMPARE(
            said[0].english(), std::string("A=10 has no unit and is taken as 10 mm, 10000 um"));
        QCOMPARE(
            said[1].english(), std::string("E=0.5 has no unit and is taken as 0.5 mm, 500 um"));
        QCOMPARE(assumedUnits("U=2", true).at(0).english(),
            std::string("U=2 has no unit and is taken as 2 deg, 7200 arcsec"));
        QVERIFY(assumedUnits("budget.json", false).empty());
    }

    void temperatureBringsPositionsTo20Degrees()
    {
        Measurement measurement = noisy(3, 1000.0, 2);
        for (RunValue& one : measurement.values)
            one.deviation = 0.0;
        TemperatureCorrection correction{.materialCelsius = 22.0, .expansionPerKelvin = 11.5e-6};
        correction.isConfirmed = true;
        const auto corrected = correctedForTemperature(measurement, correction);
        VERIFY_RESULT(corrected);
        // 1000 mm of a scale that is 2 K too warm: 1000 / (1 + 23e-6) - 1000.
        for (const RunValue& one : corrected->values) {
            const double expected =
                measurement.targets[one.target] / (1.0 + 23e-6) - measurement.targets[one.target];
            QVERIFY(std::abs(one.deviation - expected) < 1e-12);
        }
        QCOMPARE(corrected->header.corrected, MeasurementHeader::Corrected::To20Celsius);
        VERIFY_ERROR(correctedForTemperature(*corrected, correction), ErrorCode::InvalidArgument);
        correction.isConfirmed = false;
        VERIFY_ERROR(correctedForTemperature(measurement, correction), ErrorCode::InvalidArgument);
        measurement.header.corrected = MeasurementHeader::Corrected::None;
        VERIFY_RESULT(correctedForTemperature(measurement, correction));
        correction.materialCelsius = 295.15; // kelvin
        VERIFY_ERROR(correctedForTemperature(measurement, correction), ErrorCode::InvalidArgument);
        correction.materialCelsius = 22.0;
        correction.expansionPerKelvin = 11.5;
        VERIFY_ERROR(correctedForTemperature(measurement, correction), ErrorCode::InvalidArgument);
        measurement.isAngular = true;
        VERIFY_ERROR(correctedForTemperature(measurement, correction), ErrorCode::InvalidArgument);
    }

    void withoutADatumTheFirstTargetDoesNotMove()
    {
        Measurement measurement;
        measurement.targets = {200.0, 300.0};
        measurement.values = {{0, Approach::Up, 1, 0.0}, {1, Approach::Up, 1, 0.0}};
        TemperatureCorrection correction{
            .materialCelsius = 22.0, .expansionPerKelvin = 11.5e-6, .isConfirmed = true};
        QCOMPARE(datumOf(correction, measurement), 200.0);
        QCOMPARE(datumOf(correction, {}), 0.0);
        auto corrected = correctedForTemperature(measurement, correction);
        VERIFY_RESULT(corrected);
        QCOMPARE(corrected->values.front().deviation, 0.0);
        correction.datum = 300.0;
        QCOMPARE(datumOf(correction, measurement), 300.0);
        corrected = correctedForTemperature(measurement, correction);
        VERIFY_RESULT(corrected);
        QVERIFY(corrected->values.front().deviation > 0.0);
        QCOMPARE(corrected->values.back().deviation, 0.0);
    }

    void aCorrectionToldNamesAllThatItFollowsFrom()
    {
        const auto told = [](const TemperatureCorrection& correction, UnitLetters letters) {
            return correctionTexts({}, {.temperature = correction}, 0.01275, std::nullopt, letters)
                .at(0)
                .english();
        };
        TemperatureCorrection correction{.materialCelsius = 25.0, .expansionPerKelvin = 11.5e-6};
        QCOMPARE(told(correction, UnitLetters::Ascii),
            std::string("to 20 C, scale at 25 C with 11.5 um/(m K): values changed by up to "
                        "12.75 um"));
        correction.datum = 100.0;
        QCOMPARE(told(correction, UnitLetters::Ascii),
            std::string("to 20 C, scale at 25 C with 11.5 um/(m K), datum at 100 mm: values "
                        "changed by up to 12.75 um"));
        correction.referenceCelsius = 30.0;
        correction.referenceExpansionPerKelvin = 1e-5;
        QCOMPARE(told(correction, UnitLetters::Page),
            std::string("to 20 °C, scale at 25 °C with 11.5 µm/(m·K), reference at 30 °C with "
                        "10 µm/(m·K), datum at 100 mm: values changed by up to 12.75 µm"));
    }

    void theDeadPathFollowsTheAir()
    {
        // By the modified Edlen equation 1.00027137 for 20 C, 101.325 kPa and 50 %.
        QVERIFY(std::abs(refractiveIndex({101.325, 20.0, 50.0}) - 1.00027137) < 1e-7);
        Measurement measurement = noisy(2, 10.0, 2);
        for (RunValue& one : measurement.values)
            one.deviation = 0.0;
        DeadPathCorrection correction{.lengthMm = 100.0, .atZero = {101.325, 20.0, 50.0}};
        for (const Approach direction : {Approach::Up, Approach::Down})
            correction.duringRun[{direction, 1}] = {101.325, 21.0, 50.0};
        VERIFY_ERROR(correctedForDeadPath(measurement, correction), ErrorCode::InvalidArgument);
        for (const Approach direction : {Approach::Up, Approach::Down})
            correction.duringRun[{direction, 2}] = correction.atZero;
        const auto corrected = correctedForDeadPath(measurement, correction);
        VERIFY_RESULT(corrected);
        for (const RunValue& one : corrected->values) {
            // About 1 ppm for 1 K: 0.93 um for a metre, 0.093 um for 100 mm.
            const double expected = one.run == 2 ? 0.0 : 0.0000954;
            QVERIFY2(std::abs(one.deviation - expected) < 2e-6,
                std::to_string(1e6 * one.deviation).c_str());
        }
        const CorrectionsBefore alone{.deadPath = correction};
        const auto made = axiscomp::corrected(measurement, alone);
        VERIFY_RESULT(made);
        QVERIFY(made->largestByDeadPath && !made->largestByTemperature);
        // By Python: -100 (n(101.325, 21, 50) / n(101.325, 20, 50) - 1).
        QVERIFY(std::abs(*made->largestByDeadPath - 9.550276226510945e-05) < 1e-12);
    }

    void airThatCannotBeIsRefused()
    {
        const Measurement measurement = noisy(2, 10.0, 1);
        DeadPathCorrection correction{.lengthMm = 100.0};
        for (const Approach direction : {Approach::Up, Approach::Down})
            correction.duringRun[{direction, 1}] = {};
        VERIFY_RESULT(correctedForDeadPath(measurement, correction));
        for (const AirState& air : {AirState{1013.25, 20.0, 50.0}, AirState{760.0, 20.0, 50.0},
                 AirState{101.3, 293.15, 50.0}, AirState{101.3, 20.0, -1.0},
                 AirState{101.3, 20.0, 101.0}, AirState{std::nan(""), 20.0, 50.0}}) {
            DeadPathCorrection wrong = correction;
            wrong.atZero = air;
            VERIFY_ERROR(correctedForDeadPath(measurement, wrong), ErrorCode::InvalidArgument);
            wrong = correction;
            wrong.duringRun[{Approach::Down, 1}] = air;
            VERIFY_ERROR(correctedForDeadPath(measurement, wrong), ErrorCode::InvalidArgument);
        }
        correction.lengthMm = 2e5;
        VERIFY_ERROR(correctedForDeadPath(measurement, correction), ErrorCode::InvalidArgument);
    }

    /// The dead path first: what it leaves is brought to 20 deg C.
    void correctionsSayByHowMuchTheyChangeAtMost()
    {
        Measurement measurement = noisy(3, 1000.0, 1);
        for (RunValue& one : measurement.values)
            one.deviation = 0.0;
        measurement.values.back().isUsed = false;
        CorrectionsBefore both{
            TemperatureCorrection{
                .materialCelsius = 22.0, .expansionPerKelvin = 11.5e-6, .isConfirmed = true},
            DeadPathCorrection{.lengthMm = -1000.0}};
        for (const Approach direction : {Approach::Up, Approach::Down})
            both.deadPath->duringRun[{direction, 1}] = {101.325, 21.0, 50.0};
        const auto made = axiscomp::corrected(measurement, both);
        VERIFY_RESULT(made);
        QVERIFY(std::abs(*made->largestByDeadPath - 0.0009550276226510945) < 1e-12);
        // By Python: (1000 + d) / (1 + 23e-6) - 1000 - d, with d = -0.000955028.
        QVERIFY(std::abs(*made->largestByTemperature - 0.022999449047163445) < 1e-11);
        const auto none = axiscomp::corrected(measurement, {});
        VERIFY_RESULT(none);
        QVERIFY(none->measurement == measurement);
        QVERIFY(!none->largestByDeadPath && !none->largestByTemperature);
    }

    void conditionsOfTheStandard()
    {
        const auto conditions = [](const Measurement& m, std::optional<double> period) {
            return complianceOf(m, iso230Figures(m), period);
        };
        Measurement good = noisy(9, 400.0, 5);
        const auto lines = conditions(good, 80.0);
        QCOMPARE(metOf(lines, "targets"), std::optional(true));
        QCOMPARE(metOf(lines, "runs"), std::optional(true));
        QCOMPARE(metOf(lines, "bidirectional"), std::optional(true));
        QCOMPARE(metOf(lines, "period"), std::optional(true)); // 50 mm apart
        QCOMPARE(metOf(lines, "feed"), std::optional(false));
        QCOMPARE(metOf(conditions(good, 50.0), "period"), std::optional(false));
        QCOMPARE(metOf(conditions(good, {}), "period"), std::optional<bool>());
        QCOMPARE(metOf(conditions(noisy(4, 400.0, 5), {}), "targets"), std::optional(false));
        QCOMPARE(metOf(conditions(noisy(7, 1500.0, 5), {}), "targets"), std::optional(false));
        QCOMPARE(metOf(conditions(noisy(8, 1500.0, 5), {}), "targets"), std::optional(true));
        QCOMPARE(metOf(conditions(noisy(8, 1500.0, 4), {}), "runs"), std::optional(false));
        QCOMPARE(metOf(conditions(noisy(13, 3000.0, 1), {}), "targets"), std::optional(true));
        QCOMPARE(metOf(conditions(noisy(13, 3000.0, 1), {}), "runs"), std::optional(true));
        // Uneven targets, and a mean of 250 mm that leaves most of the axis out.
        Measurement uneven = noisy(13, 3000.0, 1);
        uneven.targets[5] -= 75.0;
        uneven.targets[6] += 75.0;
        QCOMPARE(metOf(conditions(uneven, {}), "targets"), std::optional(true));
        for (std::size_t n = 1; n < 12; ++n)
            uneven.targets[n] = static_cast<double>(n);
        QCOMPARE(metOf(conditions(uneven, {}), "targets"), std::optional(false));
        Measurement turn = noisy(8, 360.0, 5);
        turn.isAngular = true;
        QCOMPARE(metOf(conditions(turn, {}), "targets"), std::optional(true));
        Measurement half = noisy(4, 180.0, 5);
        half.isAngular = true;
        QCOMPARE(metOf(conditions(half, {}), "targets"), std::optional(false));
        std::erase_if(good.values,
            [](const RunValue& one) { return one.direction == Approach::Down && one.target == 3; });
        QCOMPARE(metOf(conditions(good, {}), "bidirectional"), std::optional(false));
    }

    /// That they differ is no reason to say that none is stated.
    void theTemperatureIsStatedWhereEachJoinedFileStatesOne()
    {
        std::array files{noisy(9, 400.0, 5, 1), noisy(9, 400.0, 5, 2)};
        const auto isStated = [&files] {
            const Measurement whole = joined(files).value_or(Measurement{});
            return metOf(complianceOf(whole, iso230Figures(whole), {}), "environment");
        };
        QCOMPARE(isStated(), std::optional(false));
        files[0].header.materialTemperature = 20.5;
        QCOMPARE(isStated(), std::optional(false));
        files[1].header.materialTemperature = 24.5;
        QCOMPARE(isStated(), std::optional(true));
        files[1].header.materialTemperature.reset();
        files[1].header.airTemperature = 24.5;
        QCOMPARE(isStated(), std::optional(true));
    }

    /// What people write of a machine is no proof.
    void filesOfDifferentMachinesAreAWarning()
    {
        std::array files{noisy(9, 400.0, 5, 1), noisy(9, 400.0, 5, 2), noisy(9, 400.0, 5, 3)};
        const auto warnings = [&files] {
            std::vector<std::string> said;
            for (const JudgeWarning& warning :
                judge(joined(files).value_or(Measurement{}), {}).warnings)
                if (warning.name.starts_with("Other"))
                    said.push_back(std::string(warning.name) + ": " + warning.text.english());
            return said;
        };
        files[0].header.machine = "M1";
        files[2].header.machine = "m1";
        QCOMPARE(warnings(), std::vector<std::string>{});
        files[2].header.machine = "M2";
        files[0].header.serial = "888";
        files[1].header.serial = "999";
        QCOMPARE(warnings(),
            (std::vector<std::string>{
                "OtherMachine: the files are of different machines: M1 (file 1), M2 (file 3)",
                "OtherSerial: the files have different serial numbers: 888 (file 1), 999 (file "
                "2)"}));
    }

    /// Of every value that figures are made of.
    void temperaturesOfTheValuesAreStated()
    {
        Measurement measurement = noisy(9, 400.0, 5);
        const auto isStated = [&measurement] {
            return metOf(complianceOf(measurement, iso230Figures(measurement), {}), "environment");
        };
        QCOMPARE(isStated(), std::optional(false));
        for (std::size_t i = 1; i < measurement.values.size(); ++i)
            measurement.values[i].temperature = 20.0 + 0.01 * static_cast<double>(i);
        QCOMPARE(isStated(), std::optional(false));
        measurement.values[0].isUsed = false;
        QCOMPARE(isStated(), std::optional(true));
        const auto range = temperaturesOfValues(measurement);
        QVERIFY(range && range->lowest == 20.01);
        QCOMPARE(range->highest, 20.0 + 0.01 * static_cast<double>(measurement.values.size() - 1));
        measurement.header.airTemperature = 20.0;
        measurement.values.back().temperature.reset();
        QCOMPARE(isStated(), std::optional(true));
    }

    void resultsInAFileAreCompared()
    {
        Measurement measurement = publicRuns("b02_x.csv");
        measurement.halfPrintedUnit = 0.5e-5;
        const auto publish = [&measurement](const char* name, double number) {
            measurement.published.push_back({name, number, 0.5e-5, 1});
        };
        publish("B", 0.03358);
        publish("EUp", 0.09065);
        publish("EDown", 0.09803);
        publish("E", 0.09065);
        publish("A", 0.13528);
        const PublishedCheck check = checkPublished(measurement, iso230Figures(measurement));
        QCOMPARE(check.comparisons.size(), std::size_t{5});
        QCOMPARE(check.contradictions.size(), std::size_t{1});
        QCOMPARE(check.contradictions[0].english(),
            "the file says systematic deviation E = 0.09065 mm, which is less than its own "
            "systematic deviation E, down = 0.09803 mm; computed from its values: 0.12285 mm");
        measurement.published[0].value = 0.0338;
        const PublishedCheck other = checkPublished(measurement, iso230Figures(measurement));
        QCOMPARE(other.contradictions[0].english(),
            "the file says reversal value B = 0.03380 mm; computed from its values: 0.03358 mm");
    }

    void vdiOfASmallMeasurement()
    {
        // Two targets: up 0 2 | down 1 3 and up 4 4 | down 0 0. s = sqrt 2 | sqrt 2 and 0 | 0.
        Measurement measurement = noisy(2, 1.0, 2);
        const double values[2][2][2] = {{{0, 2}, {1, 3}}, {{4, 4}, {0, 0}}};
        for (RunValue& one : measurement.values)
            one.deviation =
                values[one.target][static_cast<std::size_t>(one.direction)][one.run - 1];
        const auto vdi = vdi3441Figures(iso230Figures(measurement));
        QVERIFY(vdi.has_value());
        const double ps = 6.0 * std::sqrt(2.0);
        QCOMPARE(vdi->uMax, 4.0);
        QCOMPARE(vdi->uMean, 2.5);
        QCOMPARE(vdi->psMax, ps);
        QCOMPARE(vdi->psMean, ps / 2.0);
        QCOMPARE(vdi->pa, 0.5);
        // Means 1.5 and 2; half widths (1 + ps)/2 and 2.
        QCOMPARE(vdi->p, 1.5 + (1.0 + ps) / 2.0 - (1.5 - (1.0 + ps) / 2.0));
    }

    /// Values that stand in one table have one unit, which suits the largest.
    void aFigureIsShownInTheUnitThatSuitsIt()
    {
        const auto shown = [](double value, bool isAngular = false) {
            const Quantity quantity = fineQuantity(value, isAngular);
            return quantity.digits + " " + quantity.unit;
        };
        QCOMPARE(shown(0.0123456), "12.346 um");
        QCOMPARE(shown(100e-6), "0.100 um");
        QCOMPARE(shown(-99.9994e-6), "-99.999 nm");
        QCOMPARE(shown(0.4321e-6), "0.432 nm");
        QCOMPARE(shown(5e-9), "0.005 nm");
        QCOMPARE(shown(-4.9e-9), "0.000 um");
        QCOMPARE(shown(0.0), "0.000 um");
        QCOMPARE(shown(1e-6, true), "0.004 arcsec");
        const std::optional<double> both[] = {3e-7, std::nullopt, -0.002};
        const FineUnit unit = fineUnit(both, false);
        QCOMPARE(unit.digits(3e-7) + unit.name, "0.000um");
        QCOMPARE(unit.digits(-0.002, 2) + unit.name, "-2.00um");
        QCOMPARE(std::string(fineUnit(std::span(both).first(2), false).symbol), "nm");
    }

    void aFigureAndItsLimitReadDifferentlyWhereTheyDiffer()
    {
        const auto shown = [](double value, double limit) {
            const auto both = comparedQuantities(value, limit, false);
            return both.value.digits + " " + both.value.unit + " / " + both.limit.digits + " "
                + both.limit.unit;
        };
        QCOMPARE(shown(0.0186, 0.018), "18.600 um / 18.000 um");
        QCOMPARE(shown(0.7e-6, 0.001), "0.700 nm / 1.000 um");
        QCOMPARE(shown(0.0051350003, 0.005135), "5.1350003 um / 5.1350000 um");
        QCOMPARE(shown(99.9999e-6, 100e-6), "0.0999999 um / 0.1000000 um");
        QCOMPARE(shown(0.005135, 0.005135), "5.135 um / 5.135 um");
        QCOMPARE(shown(0.0133 - 0.0033, 0.01), "10.000 um / 10.000 um"); // by the last bit only
        QCOMPARE(shown(-0.0100004, 0.01), "-10.0004 um / 10.0000 um"); // by its size
    }

    /// 10.0004 + 0.5 is above 10.5.
    void aVerdictReadsAsItWasDecided()
    {
        const auto shown = [](double value, double limit, std::optional<double> uncertainty) {
            const Verdict verdict{{Figure::E, limit}, value, uncertainty};
            const ComparedDigits digits = verdictDigits(verdict, false, 3);
            return digits.value.digits(value, digits.decimals) + " / "
                + digits.limit.digits(limit, digits.decimals) + " / "
                + digits.uncertainty.digits(uncertainty.value_or(0.0), digits.decimals) + " "
                + digits.uncertainty.name;
        };
        QCOMPARE(shown(0.0100004, 0.0105, 0.0005), "10.0004 / 10.5000 / 0.5000 um"); // undecided
        QCOMPARE(shown(0.0110004, 0.0105, 0.0005), "11.0004 / 10.5000 / 0.5000 um"); // failed
        QCOMPARE(shown(0.01, 0.0105, 0.0005), "10.000 / 10.500 / 0.500 um"); // passed
        QCOMPARE(shown(0.0100004, 0.0105, std::nullopt), "10.000 / 10.500 / 0.000 um");
        QCOMPARE(shown(0.0100004, 0.0105, 0.00005), "10.000 / 10.500 / 50.000 nm");
    }

    void aJudgementSaysWhatIsDoubtful()
    {
        Measurement measurement = publicRuns("b02_y.csv");
        measurement.values.front().isUsed = false;
        const Judgement judgement = judge(measurement, {});
        std::vector<std::string> names;
        for (const JudgeWarning& warning : judgement.warnings)
            names.emplace_back(warning.name);
        QCOMPARE(names,
            (std::vector<std::string>{"ValuesExcluded", "DriftSuspected", "DriftSuspected"}));
        QCOMPARE(judgement.warnings[0].text.english(),
            "1 value excluded, not an evaluation by ISO 230-2");
        QVERIFY(judgement.ofAllValues.has_value());
        QVERIFY(std::abs(value(*judgement.ofAllValues, Figure::A) - 0.1257168) < tolerance);
        QVERIFY(judgement.withoutOffsets.has_value());
        QVERIFY(judgement.isWithinTolerances());
        QVERIFY(judgement.verdictsOfAllValues.empty());
    }

    /// Without the two that do not fit, A is 89.27 um in place of 204.76, and R 58.28 um.
    void aVerdictThatAllValuesWouldChangeIsAWarning()
    {
        Measurement measurement = publicRuns("ess_mcu1025.csv");
        JudgeOptions options;
        options.tolerances = {{Figure::A, 0.1}, {Figure::R, 0.3}};
        QVERIFY(judge(measurement, options).verdictsOfAllValues.empty());
        const std::array unfit{Exclusion{Approach::Down, 1, 1}, Exclusion{Approach::Down, 2, 1}};
        VERIFY_RESULT(exclude(measurement, unfit));
        const Judgement judgement = judge(measurement, options);
        QVERIFY(judgement.isWithinTolerances());
        QCOMPARE(judgement.verdictsOfAllValues.size(), std::size_t{2});
        QCOMPARE(judgement.verdictsOfAllValues[0].result, VerdictResult::Failed);
        QCOMPARE(judgement.verdictsOfAllValues[1].result, VerdictResult::Passed);
        std::vector<std::string> said;
        for (const JudgeWarning& warning : judgement.warnings)
            if (warning.name == "OtherVerdict")
                said.push_back(warning.text.english());
        QCOMPARE(said,
            (std::vector<std::string>{
                "of all values accuracy A is 204.759 um (tolerance 100.000 um: failed)"}));
    }

    void whatIsHeldOutAboveTheToleranceReadsSo()
    {
        Verdict verdict{{Figure::M, 0.005}, 0.0, std::nullopt, VerdictResult::Undecided};
        const auto shown = [&verdict](double heldOut) {
            verdict.heldOut = heldOut;
            const ComparedDigits digits = heldOutDigits(verdict, false, 3);
            return digits.value.digits(heldOut, digits.decimals) + " " + digits.value.name;
        };
        QCOMPARE(shown(0.006), "6.000 um");
        QCOMPARE(shown(0.0050004), "5.0004 um");
        verdict.uncertainty = 0.0001;
        QCOMPARE(shown(0.00490004), "4.90004 um");
    }

    void aRowHasTheDigitsThatEachOfItsVerdictsNeeds()
    {
        const Verdict far{{Figure::E, 0.0105}, 0.005, std::nullopt};
        const Verdict near{{Figure::E, 0.0105}, 0.0105004, std::nullopt};
        const Verdict byU{{Figure::E, 0.0105}, 0.01000004, 0.0005};
        const FineUnit um;
        QCOMPARE(verdictDecimals({}, um, 2), 2);
        QCOMPARE(verdictDecimals({&far, nullptr}, um, 2), 2);
        QCOMPARE(verdictDecimals({&near, &far}, um, 2), 4);
        QCOMPARE(verdictDecimals({&far, &byU}, um, 2), 5);
        const Verdict undefined{{Figure::E, 0.0105}, std::nullopt, std::nullopt};
        QCOMPARE(verdictDecimals({&undefined}, um, 2), 2);
        const std::array all{Verdict{{Figure::A, 0.01}, {}, {}}, near};
        QCOMPARE(verdictOf(all, Figure::E), &all[1]);
        QVERIFY(!verdictOf(all, Figure::M));
    }

    /// U brings it above the tolerance by less than three decimals show.
    void aVerdictOfAllValuesReadsAsItWasDecided()
    {
        const Verdict inUse{{Figure::A, 0.0105}, 0.005, 0.0005, VerdictResult::Passed};
        const Verdict ofAll{{Figure::A, 0.0105}, 0.0100004, 0.0005, VerdictResult::Undecided};
        const auto warnings = otherVerdicts(std::array{inUse}, std::array{ofAll}, false);
        QCOMPARE(warnings.size(), std::size_t{1});
        QCOMPARE(warnings[0].text.english(),
            "of all values accuracy A is 10.0004 um (tolerance 10.5000 um: undecided)");
    }
};

AXISCOMP_TEST(tst_Judging)

} // namespace tst_judging

#include "tst_judging.moc"
