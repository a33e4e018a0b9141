// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/fit_record.h"

#include "app/common/arguments.h"

#include <filesystem>

namespace axiscomp::app {

namespace {

Result<RecordedMeasurement> recordedMeasurement(const MeasurementInput& input,
    const MeasurementInputOptions& options, const MadeCorrections& corrections,
    const FitSettings& settings)
{
    RecordedMeasurement recorded;
    for (std::size_t n = 0; n < input.sources.size(); ++n) {
        const MeasurementSource& source = input.sources[n];
        recorded.files.push_back({source.file, source.format, source.sha256, input.files[n]});
    }
    recorded.swapsDirections = options.swapsDirections;
    if (!options.excluded.empty()) {
        AXISCOMP_TRY(recorded.exclusions, exclusionsFromText(options.excluded));
    }
    recorded.corrections = {
        corrections.corrections.temperature, corrections.corrections.deadPath, settings.drift};
    return recorded;
}

} // namespace

Result<CalibrationRecord> recordOfFit(const MeasurementInput& input,
    const MeasurementInputOptions& options, const MadeCorrections& corrections,
    const FitSettings& settings, const FitReport& report)
{
    CalibrationRecord record;
    record.program = "axiscomp " AXISCOMP_VERSION;
    record.time = std::chrono::system_clock::now();
    AXISCOMP_TRY(record.before, recordedMeasurement(input, options, corrections, settings));
    // What the file left open was stated by a person, or taken for granted.
    record.notes = {report.state.text.english()};
    if (!report.state.assumption.isEmpty())
        record.notes.push_back(report.state.assumption.english());
    record.fit = RecordedFit{settings};
    record.fit->settings.lookupAt = report.lookupAt;
    if (report.state.active)
        record.fit->active = report.state.active->tables;
    for (const FittedTable& made : report.tables)
        record.tables.push_back({made.table, tableCrc(made.table)});
    if (report.before && report.predicted)
        record.prediction = RecordedPrediction{
            figureValues(*report.before), figureValues(*report.predicted), report.heldOut};
    return record;
}

Result<void> checkNewRecord(const std::string& file, const std::string& command)
{
    std::error_code ignored;
    if (!std::filesystem::exists(file, ignored))
        return {};
    return wrongUsage(
        file + " exists already, and a record is not replaced: name another file", command);
}

} // namespace axiscomp::app
