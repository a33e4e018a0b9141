// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/record_state.h"

#include "core/base/sha256.h"
#include "core/io/local_file.h"
#include "core/metrology/fit/measurement_fit.h"
#include "core/metrology/run_selection.h"

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

/// As a record holds it.
void takeRecorded(ReadMeasurement& read)
{
    const RecordedFile& recorded = *read.file.recorded;
    if (const auto format = measurementFormatNamed(recorded.format))
        read.format = *format;
    read.sha256 = recorded.sha256;
    auto reading = std::make_shared<MeasurementReading>();
    reading->measurement = recorded.measurement;
    read.upRuns = reading->measurement->runCount(Approach::Up);
    read.downRuns = reading->measurement->runCount(Approach::Down);
    read.reading = std::move(reading);
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
    read.sha256 = sha256Of(bytes);
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
    const FileStamp stamp = file.recorded ? FileStamp{} : stampOf(file.path);
    const auto same = std::ranges::find_if(
        known, [&](const ReadMeasurement& one) { return one.file == file && one.stamp == stamp; });
    if (same != known.end())
        return *same;
    ReadMeasurement read;
    read.file = file;
    read.stamp = stamp;
    if (file.recorded)
        takeRecorded(read);
    else if (const auto done = readInto(read, stop); !done)
        read.refusal = done.error();
    const auto before = std::ranges::find(known, file, &ReadMeasurement::file);
    if (!read.measurement() && before != known.end())
        read.lastUsable = before->measurement() ? std::make_shared<const ReadMeasurement>(*before)
                                                : before->lastUsable;
    return read;
}

/// Whether a measurement has every value of an earlier one at its place.
bool hasAllOf(const Measurement& now, const Measurement& before)
{
    if (!before.hasTargets())
        return now == before;
    if (now.kind != before.kind || now.isAngular != before.isAngular || now.header != before.header
        || now.targets.size() < before.targets.size()
        || !std::equal(before.targets.begin(), before.targets.end(), now.targets.begin()))
        return false;
    auto at = now.values.begin(); // both stand in the same order
    for (RunValue value : before.values) {
        at = std::find_if(at, now.values.end(), [&](const RunValue& one) {
            return one.direction == value.direction && one.target == value.target
                && one.run == value.run;
        });
        if (at == now.values.end())
            return false;
        value.line = at->line;
        if (value != *at)
            return false;
    }
    return true;
}

/// See RecordState. All files can be used.
QStringList changedFiles(const Record& record, const std::vector<ReadMeasurement>& known,
    const std::vector<ReadMeasurement>& files)
{
    QStringList changed;
    std::vector<ReadMeasurement> before;
    std::vector<ReadMeasurement> after;
    for (const ReadMeasurement& file : files) {
        const auto found = std::ranges::find(known, file.file, &ReadMeasurement::file);
        if (found == known.end())
            continue; // nothing can have been said of it yet
        before.push_back(found->lastUsable ? *found->lastUsable : *found);
        after.push_back(file);
        if (before.back().sha256 != file.sha256)
            changed += file.file.path;
    }
    const bool isKnown = std::ranges::all_of(
        before, [](const ReadMeasurement& file) { return file.measurement() != nullptr; });
    if (changed.isEmpty() || !isKnown)
        return changed;
    Record plain;
    plain.swapsDirections = record.swapsDirections;
    const auto then = uncorrected(plain, before);
    const auto now = uncorrected(plain, after);
    return then && now && hasAllOf(*now, *then) ? QStringList() : changed;
}

Result<CorrectedMeasurement> wholeOf(
    const Record& record, const std::vector<ReadMeasurement>& files)
{
    AXISCOMP_TRY(auto whole, uncorrected(record, files));
    return corrected(std::move(whole), record.corrections);
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

JudgeOptions judgeOptionsOf(const Record& record, const Measurement& measurement)
{
    JudgeOptions options;
    options.outlierRule = record.outlierRule;
    options.wantsVdi = true;
    // A limit of 10 um is none of an angle.
    if (record.areLimitsAngles == measurement.isAngular) {
        options.tolerances = record.tolerances;
        options.uncertainty = record.uncertainty;
    }
    return options;
}

JudgedValues judgedValues(DeviationSeries series)
{
    const Iso230Figures shown = fromDatum(*series.figures, series.curves->datum);
    const FineUnit unit = fineUnit(valuesOfTargets(shown), series.measurement->isAngular);
    return {std::move(series), unit};
}

/// Plot and tables of them are made here: of a million values that takes its time.
void judgeInto(RecordState& state)
{
    const auto& measurement = state.measurement;
    const auto judgement = std::make_shared<const Judgement>(
        judge(*measurement, judgeOptionsOf(state.record, *measurement)));
    state.judgement = judgement;
    std::vector<std::optional<double>> offsets;
    for (const DirectionDrift* drift : {&judgement->driftUp, &judgement->driftDown})
        offsets.insert(offsets.end(), drift->offset.begin(), drift->offset.end());
    state.offsetUnit = fineUnit(offsets, measurement->isAngular);
    const std::shared_ptr<const Outliers> outliers(judgement, &judgement->outliers);
    const auto figuresOf = [&](const Iso230Figures& figures) {
        return std::shared_ptr<const Iso230Figures>(judgement, &figures);
    };
    state.used = judgedValues(deviationSeries(measurement, figuresOf(judgement->figures), outliers,
        statedDatum(state.record.corrections.temperature)));
    state.all = judgement->ofAllValues
        ? judgedValues(seriesOfAllValues(state.used.series, figuresOf(*judgement->ofAllValues)))
        : state.used;
}

} // namespace

Result<Measurement> uncorrected(const Record& record, const std::vector<ReadMeasurement>& files)
{
    std::vector<Measurement> measurements;
    for (const ReadMeasurement& file : files)
        measurements.push_back(*file.measurement());
    return selected(measurements, record.swapsDirections, record.exclusions);
}

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
    state.changedFiles = changedFiles(record, known, state.files);
    auto whole = wholeOf(record, state.files);
    if (!whole) {
        state.refusal = whole.error();
        return state;
    }
    state.largestByTemperature = whole->largestByTemperature;
    state.largestByDeadPath = whole->largestByDeadPath;
    const auto measurement = std::make_shared<const Measurement>(std::move(whole->measurement));
    state.upRunNumbers = measurement->runNumbers(Approach::Up);
    state.downRunNumbers = measurement->runNumbers(Approach::Down);
    state.excludedCount = measurement->excludedCount();
    state.hasRaw = hasRawReadings(*measurement);
    state.unit = unitOf(*measurement);
    state.measurement = measurement;
    if (measurement->hasTargets() && !stop.stop_requested())
        judgeInto(state);
    return state;
}

} // namespace axiscomp::ui
