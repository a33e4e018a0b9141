// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/record_state.h"

#include "core/io/local_file.h"
#include "core/metrology/fit/measurement_fit.h"
#include "core/metrology/run_selection.h"

#include <QCryptographicHash>
#include <QFileInfo>

#include <algorithm>
#include <cmath>

namespace axiscomp::ui {

namespace {

MeasurementReadOptions readOptionsOf(const MeasurementChoices& choices, const std::stop_token& stop)
{
    MeasurementReadOptions options;
    options.columns = choices.columns;
    options.skippedLines = choices.skippedLines;
    options.unit = choices.unit;
    options.valueUnit = choices.valueUnit;
    options.values = choices.values;
    options.takesDirectionFromOrder = choices.takesDirectionFromOrder;
    options.invertsReference = choices.invertsReference;
    options.stop = stop;
    return options;
}

/// Errors: why there is no measurement.
Result<void> readInto(ReadMeasurement& read, const std::stop_token& stop)
{
    const QFileInfo info(read.file.path);
    const MeasurementChoices& choices = read.file.choices;
    const MeasurementReadOptions options = readOptionsOf(choices, stop);
    AXISCOMP_TRY(
        const auto bytes, loadFile(info.filesystemAbsoluteFilePath(), options.maximumBytes));
    const std::string_view text = asText(bytes);
    read.sha256 = QCryptographicHash::hash(
        QByteArrayView(text.data(), qsizetype(text.size())), QCryptographicHash::Sha256)
                      .toHex()
                      .toStdString();
    const std::string name = info.fileName().toStdString();
    AXISCOMP_TRY(read.format,
        choices.format.empty() ? chooseMeasurementFormat(text, name, options)
                               : measurementFormatNamed(choices.format));
    auto reading = std::make_shared<MeasurementReading>(read.format->read(text, options));
    if (reading->cancelled)
        return fail(ErrorCode::Cancelled);
    read.reading = reading;
    if (!reading->measurement)
        return fail(measurementError(name, *reading));
    read.upRuns = reading->measurement->runCount(Approach::Up);
    read.downRuns = reading->measurement->runCount(Approach::Down);
    return {};
}

ReadMeasurement readAgainOrKnown(const MeasurementFile& file,
    const std::vector<ReadMeasurement>& known, const std::stop_token& stop)
{
    const FileStamp stamp = stampOf(file.path);
    const auto same = std::ranges::find_if(
        known, [&](const ReadMeasurement& one) { return one.file == file && one.stamp == stamp; });
    if (same != known.end())
        return *same;
    ReadMeasurement read;
    read.file = file;
    read.stamp = stamp;
    if (const auto done = readInto(read, stop); !done)
        read.refusal = done.error();
    return read;
}

Result<Measurement> wholeOf(const Record& record, const std::vector<ReadMeasurement>& files)
{
    std::vector<Measurement> measurements;
    for (const ReadMeasurement& file : files)
        measurements.push_back(*file.measurement());
    return selected(measurements, record.swapsDirections, record.exclusions);
}

/// Of all values, which stand in one table.
FineUnit unitOf(const Measurement& measurement)
{
    double largest = 0.0;
    for (const RunValue& value : measurement.values)
        largest = std::max(largest, std::abs(value.deviation));
    const std::optional<double> shown[] = {largest};
    return fineUnit(shown, measurement.isAngular);
}

} // namespace

RecordState evaluated(
    const Record& record, std::vector<ReadMeasurement> known, const std::stop_token& stop)
{
    RecordState state;
    state.record = record;
    for (const MeasurementFile& file : record.files) {
        if (stop.stop_requested())
            return state;
        state.files.push_back(readAgainOrKnown(file, known, stop));
    }
    const bool areUsable = std::ranges::all_of(
        state.files, [](const ReadMeasurement& file) { return file.measurement() != nullptr; });
    if (!areUsable || state.files.empty() || stop.stop_requested())
        return state;
    auto whole = wholeOf(record, state.files);
    if (!whole) {
        state.refusal = whole.error();
        return state;
    }
    state.upRuns = whole->runCount(Approach::Up);
    state.downRuns = whole->runCount(Approach::Down);
    state.excludedCount = whole->excludedCount();
    state.hasRaw = hasRawReadings(*whole);
    state.unit = unitOf(*whole);
    state.measurement = std::make_shared<const Measurement>(std::move(*whole));
    if (!state.measurement->hasTargets() || stop.stop_requested())
        return state;
    JudgeOptions options;
    options.outlierRule = record.outlierRule;
    options.tolerances = record.tolerances;
    options.uncertainty = record.uncertainty;
    state.judgement = std::make_shared<const Judgement>(judge(*state.measurement, options));
    return state;
}

} // namespace axiscomp::ui
