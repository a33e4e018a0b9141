// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/record/calibration_record.h"
#include "tests/core/metrology/measurement_reading.h"

namespace axiscomp::test {

inline RecordedFile recordedFile(std::string_view format, const std::string& text)
{
    auto reading = readAs(format, text);
    return {"folder/x.csv", std::string(format), std::string(64, 'a'),
        reading.measurement.value_or(Measurement{})};
}

/// A record that has everything: numbers that need all their digits, one of each kind of
/// measurement, values that are not defined.
inline CalibrationRecord fullRecord()
{
    CalibrationRecord record;
    record.program = "axiscomp 1.0";
    record.time = *utcFromText("2026-11-21T08:02:23.25Z");
    record.notes = {"spindle \"X\"", "H\xc3\xb6he"};
    RecordedMeasurement before{{recordedFile("runs", publicMeasurement("b02_x.csv"))}};
    before.files.push_back(recordedFile("track", ""));
    before.files.back().measurement.kind = MeasurementKind::Track;
    before.files.back().measurement.track = {
        {0.1 + 0.2, 1e-310, Approach::Up, 1.0 / 3.0}, {2.0, -0.0, Approach::Down, std::nullopt}};
    before.files.push_back(before.files.back());
    Measurement& points = before.files.back().measurement;
    points.kind = MeasurementKind::Points;
    points.track.clear();
    points.points = {{"X", "Y"}, {{0.0, 1.0, 2.0}, {5.0, 6.0, 7.0}}, {"dX"}, {{1e-3, -2e-3, 0.1}}};
    Measurement& runs = before.files.front().measurement;
    runs.header = {"M1", "X", "XL-80", "12345", "Anna", "2026-11-20", "500 mm/min", "2 s",
        {MeasuredState::Kind::On, 0x1c291ca3}, 20.4, 20.9, 11.5e-6,
        MeasurementHeader::Corrected::None};
    runs.header.drive = "Triamec-616, serial number 1559";
    runs.notes = {"Flags: 0 0 2 0"};
    runs.published = {{"E", 0.09065, 5e-6, 12}};
    runs.halfPrintedUnit = 5e-6;
    runs.againstFile.invertsReference = true;
    runs.againstFile.takesAsDeviations = true;
    runs.againstFile.units = {{"reference", "nm", "um"}};
    runs.values[3].encoder = 12.34567890123456789;
    runs.values[4].output = -1e-3;
    runs.values[5].time = 1e9;
    runs.values[6].temperature = 20.5;
    runs.values[7].isUsed = false;
    before.swapsDirections = true;
    before.exclusions = {
        {Approach::Down, 1, 1}, {Approach::Up, std::nullopt, 3}, {std::nullopt, 7, std::nullopt}};
    before.corrections.temperature = TemperatureCorrection{20.9, 11.5e-6, 20.1, 1e-7, 5.0, true};
    before.corrections.deadPath =
        DeadPathCorrection{120.5, {98.1, 20.2, 44.0}, {{{Approach::Up, 1}, {98.2, 20.3, 45.0}}}};
    before.corrections.drift = DriftRemoval::Trend;
    record.before = before;

    CompensationTable table{"Table 1", "mm", {{{"X", "mm", -10.5, 0.1, 3}}},
        {0.1F, -1.17549435e-38F, 3.4028235e38F}, "X", {1}};
    RecordedFit fit;
    fit.settings.method = FitMethod::Smooth;
    fit.settings.smoothness = 0.1;
    fit.settings.periods = {{10.0, 4.0}, 2};
    fit.settings.turn = 360.0;
    fit.settings.slope = SlopeRemoval::LeastSquares;
    fit.settings.zero = FitZero::Position;
    fit.settings.zeroPosition = {12.5};
    fit.settings.home = 0.25;
    fit.settings.drift = DriftRemoval::Offset;
    fit.settings.lookupAt = LookupAt::Set;
    fit.settings.gain = 0.7;
    fit.settings.grid = {{51, 0.0, {}, {}}, {0, 2.5, 0.0, 500.0}};
    fit.settings.within = 1e-4;
    fit.settings.remove = BodyRemoval::RigidAlong;
    fit.settings.removeAlong = 1;
    fit.settings.farPoints = FarPoints::Nearest;
    fit.settings.isRobust = true;
    fit.settings.speed = 100.0;
    fit.settings.tolerances = {{Iso230Figure::A, 0.01}, {Iso230Figure::RUp, 0.004}};
    fit.settings.uncertainty = 0.0021;
    fit.settings.outlierRule = OutlierRule::Grubbs;
    fit.active = {table};
    record.fit = fit;
    record.tables = {{table, tableCrc(table)}};

    RecordedPrediction prediction;
    for (std::size_t i = 0; i + 1 < iso230FigureCount; ++i)
        prediction.before.values[i] = 1.0 / (3.0 + static_cast<double>(i));
    prediction.predicted.values[0] = 0.0334657;
    prediction.heldOut = HeldOut{{{25.3, 1e-3}, {50.1, -2e-3}}, 0.0209982, 0.0410688, 0.0750335};
    record.prediction = prediction;
    record.drive = RecordedDrive{
        "Triamec-616", 1559, "generic", 1, "X", {MeasuredState::Kind::Off, std::nullopt}};
    record.write = RecordedWrite{*utcFromText("2026-11-21T09:00:00Z"), "Small1", true, 0x00a1b2c3,
        RecordedWrite::Proof{true, 100, 1e-9, 2e-9, 0.75}, Grid{{{"", "", 0.1, 20.0, 3}}},
        TableUnits{"mm", {"mm"}}};
    RecordedAfter after{{{before.files.front()}}, prediction.predicted, true};
    record.after = {after, after};
    record.after[1].isAsPredicted.reset();
    record.after[1].tableCrc = 0x00a1b2c3;
    record.verdict =
        RecordedVerdict{{{{Iso230Figure::A, 0.01}, 0.0032, 0.0021, VerdictResult::Passed},
            {{Iso230Figure::B, 0.001}, std::nullopt, std::nullopt, VerdictResult::NotDefined}}};
    record.judging = RecordedJudging{OutlierRule::None, {{Iso230Figure::R, 0.002}}, 1.0 / 3.0, {}};
    record.draft = RecordedDraft{
        RecordedMeasurement{{before.files.front()}}, RecordedMeasurement{{before.files.front()}}};
    record.draft->before->exclusions = {{std::nullopt, 2, std::nullopt}};
    record.draft->isTableStated = true;
    return record;
}

} // namespace axiscomp::test
