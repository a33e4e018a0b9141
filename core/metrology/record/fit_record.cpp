// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/record/fit_record.h"

#include "core/neutral/drive_note.h"
#include "core/neutral/lookup_note.h"
#include "core/table/missing_points.h"

#include <utility>

namespace axiscomp {

CalibrationRecord recordOfFit(RecordedMeasurement before, const FitSettings& settings,
    const FitReport& report, const std::string& program, WallTime time)
{
    CalibrationRecord record;
    record.program = program;
    record.time = time;
    before.corrections.drift = settings.drift;
    record.before = std::move(before);
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

std::vector<std::string> notesOfFit(const std::string& sources, const Measurement& measurement,
    const FitSettings& settings, const FitReport& report)
{
    std::vector<std::string> notes{"made of " + sources, lookupNote(report.lookupAt),
        report.state.text.english(), "method " + std::string(madeBy(measurement, settings))};
    if (driveSerialOf(measurement.header))
        notes.push_back(driveNote(measurement.header.drive));
    for (const FittedTable& made : report.tables)
        if (const CompensationTable& table = made.table; !table.filled.empty())
            notes.push_back(filledNote(table.name, table.filled.size(), table.values.size()));
    return notes;
}

} // namespace axiscomp
