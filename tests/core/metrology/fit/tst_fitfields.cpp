// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/fit/fit_fields.h"
#include "core/metrology/fit/fitted_points.h"
#include "core/metrology/record/fit_record.h"
#include "tests/core/metrology/measurement_reading.h"
#include "tests/support/test_registry.h"
#include "tests/support/verify.h"

#include <QTest>

#include <array>
#include <cmath>

namespace tst_fitfields {

using namespace axiscomp;

namespace {

Measurement ofKind(MeasurementKind kind)
{
    Measurement measurement;
    measurement.kind = kind;
    if (kind == MeasurementKind::Points)
        measurement.points.axes = {"X", "Y"};
    return measurement;
}

/// Everything that can be said, whatever it is said of.
FitSettings everything()
{
    FitSettings settings;
    settings.direction = FitDirection::Negative;
    settings.method = FitMethod::Smooth;
    settings.smoothness = 0.5;
    settings.periods = {{10.0}, 3};
    settings.slope = SlopeRemoval::Ends;
    settings.zero = FitZero::Home;
    settings.home = 5.0;
    settings.drift = DriftRemoval::Trend;
    settings.lookupAt = LookupAt::Set;
    settings.grid = {{.points = 11}, {.points = 7}};
    settings.holdsEnds = true;
    settings.remove = BodyRemoval::Rigid;
    settings.farPoints = FarPoints::Smooth;
    settings.isRobust = true;
    settings.tolerances = {{Iso230Figure::A, 0.01}};
    return settings;
}

bool isNear(double a, double b)
{
    return std::abs(a - b) < 1e-7;
}

} // namespace

/// What is asked for which kind of measurement, and what is drawn beside a table.
class TestFitFields : public QObject {
    Q_OBJECT

private Q_SLOTS:
    void init() { test::failOnWarnings(); }

    /// Whatever was chosen for a measurement before, another kind is not refused because of it.
    void whatMeansNothingForAMeasurementIsNotSaidOfIt()
    {
        const FitSettings runs = settingsFor(ofKind(MeasurementKind::Runs), everything());
        QVERIFY(runs.remove == BodyRemoval::None && runs.farPoints == FarPoints::Refuse);
        QVERIFY(!runs.isRobust && runs.grid.size() == 1 && runs.grid.front().points == 11);
        QVERIFY(runs.smoothness == 0.5 && runs.periods.harmonics == 3 && runs.home == 5.0);
        QVERIFY(runs.drift == DriftRemoval::Trend && runs.slope == SlopeRemoval::Ends);

        const FitSettings track = settingsFor(ofKind(MeasurementKind::Track), everything());
        QVERIFY(track.method == FitMethod::Smooth && track.periods.periods.size() == 1);
        QVERIFY(!track.home && track.zero == FitZero::Automatic && track.tolerances.empty());
        QVERIFY(!track.drift && track.slope == SlopeRemoval::Keep && !track.isRobust);
        QVERIFY(track.farPoints == FarPoints::Smooth && track.direction == FitDirection::Negative);

        const FitSettings points = settingsFor(ofKind(MeasurementKind::Points), everything());
        QVERIFY(points.method == FitMethod::Linear && points.periods.periods.empty());
        QVERIFY(points.direction == FitDirection::Mean && points.grid.size() == 2);
        QVERIFY(points.remove == BodyRemoval::Rigid && points.isRobust);
        QVERIFY(points.smoothness == 0.5 && points.lookupAt == LookupAt::Set);
    }

    void aSmoothnessIsAskedForWhereTheMethodHasOne()
    {
        const Measurement runs = ofKind(MeasurementKind::Runs);
        FitSettings settings;
        QVERIFY(!fitFields(runs, settings).smoothness && !fitFields(runs, settings).harmonics);
        settings.method = FitMethod::Smooth;
        QVERIFY(fitFields(runs, settings).smoothness && !fitFields(runs, settings).harmonics);
        settings.periods.periods = {10.0};
        QVERIFY(fitFields(runs, settings).harmonics);
        settings.method = FitMethod::Harmonic;
        QVERIFY(fitFields(runs, settings).harmonics && !fitFields(runs, settings).periods);
        const Measurement track = ofKind(MeasurementKind::Track);
        QVERIFY(!fitFields(track, settings).within);
        settings.method = FitMethod::Smooth;
        QVERIFY(fitFields(track, settings).within);
        QVERIFY(!isMethodFor(MeasurementKind::Track, FitMethod::Cubic));
        QVERIFY(!isMethodFor(MeasurementKind::Points, FitMethod::Smooth));
    }

    /// Means and standard errors computed from the file with another program.
    void meansStandBesideTheTableWithTheirStandardErrors()
    {
        const auto reading = test::readAs("runs", test::publicMeasurement("b02_x.csv"));
        VERIFY_MEASUREMENT(reading);
        FitSettings settings;
        settings.zero = FitZero::Keep;
        settings.lookupAt = LookupAt::Encoder;
        const auto report = fitMeasurement(*reading.measurement, settings, {});
        VERIFY_RESULT(report);
        const auto points = fittedPoints(*reading.measurement, settings, *report);
        QCOMPARE(points.size(), std::size_t{9});
        QVERIFY(isNear(points[0].position, -20.0) && isNear(points[0].value, -0.0355909));
        QVERIFY(isNear(*points[0].standardError, 0.00045779));
        QVERIFY(
            isNear(points[4].value, -0.0358141) && isNear(*points[4].standardError, 0.00178738));
        for (const FittedPoint& point : points)
            QVERIFY(std::abs(point.residual) < 1e-8);
        FitSettings up = settings;
        up.direction = FitDirection::Positive;
        const auto ofUp = fitMeasurement(*reading.measurement, up, {});
        VERIFY_RESULT(ofUp);
        const auto upPoints = fittedPoints(*reading.measurement, up, *ofUp);
        QVERIFY(
            isNear(upPoints[8].value, 0.0399994) && isNear(*upPoints[8].standardError, 0.00037972));
    }

    /// Of a table with every second target the others are off by what the drive leaves.
    void whatRemainsIsWhatTheDriveLeaves()
    {
        Measurement runs;
        runs.targets = {0.0, 10.0, 20.0, 30.0, 40.0};
        const double values[] = {0.001, 0.004, 0.003, 0.001, 0.005};
        for (std::size_t i = 0; i < 5; ++i)
            for (const Approach direction : {Approach::Up, Approach::Down})
                runs.values.push_back({i, direction, 1, values[i]});
        sortValues(runs.values);
        FitSettings settings;
        settings.lookupAt = LookupAt::Encoder;
        settings.zero = FitZero::First;
        settings.grid = {{.points = 3}};
        const auto report = fitMeasurement(runs, settings, {});
        VERIFY_RESULT(report);
        const auto points = fittedPoints(runs, settings, *report);
        QCOMPARE(points.size(), std::size_t{5});
        QVERIFY(isNear(points[0].value, 0.0) && isNear(points[0].residual, 0.0));
        QVERIFY(
            isNear(points[1].value, 0.003) && isNear(points[1].residual, 0.002)); // between 0, 2
        QVERIFY(isNear(points[3].residual, -0.003)); // 0 between 2 and 4
        QVERIFY(!points[0].standardError);
    }

    /// A drive that looks up after its compensation finds the values at the reference positions.
    void aTrackStandsWhereTheDriveLooksItUp()
    {
        Measurement track;
        track.kind = MeasurementKind::Track;
        for (int i = 0; i <= 40; ++i)
            track.track.push_back({i * 1.0, i * 1.001 + 0.5, Approach::Up, {}});
        FitSettings settings;
        settings.zero = FitZero::Keep;
        settings.lookupAt = LookupAt::Set;
        settings.smoothness = 1e-6;
        settings.grid = {{.points = 9}};
        FoundState state;
        state.kind = FoundState::Kind::Irrelevant;
        const auto report = fitMeasurement(track, settings, state);
        VERIFY_RESULT(report);
        const auto points = fittedPoints(track, settings, *report);
        QCOMPARE(points.size(), std::size_t{41});
        QVERIFY(isNear(points[10].position, 10.51) && isNear(points[10].value, 0.51));
        QVERIFY(std::abs(points[10].residual) < 1e-5);
    }

    void aRecordBeginsWithWhatTheFitPromises()
    {
        const auto reading = test::readAs("runs", test::publicMeasurement("b02_x.csv"));
        VERIFY_MEASUREMENT(reading);
        FitSettings settings;
        settings.zero = FitZero::Keep;
        settings.lookupAt = LookupAt::Encoder;
        settings.drift = DriftRemoval::Offset;
        const auto report = fitMeasurement(*reading.measurement, settings, {});
        VERIFY_RESULT(report);
        RecordedMeasurement before;
        before.files.push_back({"b02_x.csv", "runs", "00", *reading.measurement});
        const CalibrationRecord record =
            recordOfFit(std::move(before), settings, *report, "axiscomp 1.0", WallTime{});
        QCOMPARE(record.tables.size(), std::size_t{1});
        QCOMPARE(record.tables.front().crc, tableCrc(report->tables.front().table));
        QVERIFY(record.before->corrections.drift == DriftRemoval::Offset);
        QVERIFY(isNear(*record.prediction->predicted[Iso230Figure::A], 0.0551810)
            || std::abs(*record.prediction->predicted[Iso230Figure::A] - 0.0551810) < 1e-6);
        QVERIFY(std::abs(record.prediction->heldOut->range - 0.0750335) < 1e-6);
        QVERIFY(record.fit->settings.lookupAt == LookupAt::Encoder);
    }
};

AXISCOMP_TEST(TestFitFields)

} // namespace tst_fitfields

#include "tst_fitfields.moc"
