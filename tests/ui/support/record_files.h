// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/fit/measurement_fit.h"
#include "core/metrology/formats/measurement_format.h"
#include "core/metrology/record/calibration_record.h"
#include "core/text/crc_text.h"
#include "tests/support/file_content.h"
#include "tests/ui/support/measurement_files.h"

#include <QByteArray>
#include <QCryptographicHash>

#include <functional>

namespace axiscomp::test {

/// What `axiscomp fit --record --measured-with off --lookup-at encoder --zero keep` begins of a
/// public measurement: the table at its targets. Of b02_x the figures stand in docs/metrology.md.
[[nodiscard]] inline CalibrationRecord recordOfFit(const char* name = "b02_x")
{
    const std::string text = contentOf(publicMeasurement(name).toStdString());
    const auto format = measurementFormatNamed("runs");
    auto reading = format ? (*format)->read(text, {}) : MeasurementReading{};
    if (!reading.measurement)
        qFatal("%s cannot be read", name);
    CalibrationRecord record;
    record.program = "axiscomp 1.0";
    record.time = WallTime(std::chrono::seconds(1'763'712'000));
    record.notes = {"measured off: stated by a person"};
    const QByteArray digest =
        QCryptographicHash::hash(QByteArray::fromStdString(text), QCryptographicHash::Sha256);
    record.before = RecordedMeasurement{
        {{std::string(name) + ".csv", "runs", digest.toHex().toStdString(), *reading.measurement}}};
    FitSettings settings;
    settings.zero = FitZero::Keep;
    settings.lookupAt = LookupAt::Encoder;
    const auto report = fitMeasurement(*reading.measurement, settings, FoundState{});
    if (!report)
        qFatal("%s has no table", name);
    record.fit = RecordedFit{settings};
    CompensationTable table = report->tables.front().table;
    record.tables = {{table, tableCrc(table)}};
    record.prediction = RecordedPrediction{
        figureValues(*report->before), figureValues(*report->predicted), report->heldOut};
    return record;
}

/// A measurement over the targets of b02_x, two runs in each direction: mean(i) in um at target i,
/// and half a um above and below it. So s is 1/sqrt(2) um everywhere. state: "crc:1c291ca3"; empty:
/// it does not say which table was active.
[[nodiscard]] inline QByteArray afterMeasurement(
    const QByteArray& state, const std::function<double(int)>& mean)
{
    QByteArray text = "// axiscomp runs: 1\n";
    if (!state.isEmpty())
        text += "// compensation: " + state + '\n';
    text += "target [mm],direction,run,deviation [um]\n";
    for (const char* direction : {"+", "-"})
        for (int run = 1; run <= 2; ++run)
            for (int i = 0; i < 9; ++i)
                text += QByteArray::number(-20 + 5 * i) + ',' + direction + ','
                    + QByteArray::number(run) + ','
                    + QByteArray::number(mean(i) + (run == 1 ? 0.5 : -0.5), 'g', 17) + '\n';
    return text;
}

/// 0 and 1 um in turn: M = 1 um, A = 1 + 4/sqrt(2) = 3.83 um.
[[nodiscard]] inline QByteArray goodAfterMeasurement(const QByteArray& state)
{
    return afterMeasurement(state, [](int i) { return i % 2; });
}

[[nodiscard]] inline QByteArray stateOf(const CalibrationRecord& record)
{
    return "crc:" + QByteArray::fromStdString(crcText(record.tables.front().crc));
}

} // namespace axiscomp::test
