// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/record/reference_reading.h"

#include "core/table/target_axis.h"

#include <algorithm>
#include <cmath>

namespace axiscomp {

namespace {

/// How a table was made of a measurement.
struct TableMaking {
    const Measurement& measurement; ///< as it was used
    const FitSettings& settings;
    bool isCorrected = false; ///< for temperature, dead path, or drift beside the settings
    bool isMerged = false; ///< onto tables that were active
};

/// Whether the values of the table are what was measured: nothing was taken out of them, put to
/// them or smoothed.
bool isAsMeasured(const TableMaking& making)
{
    const FitSettings& settings = making.settings;
    const bool isInterpolated = settings.method == FitMethod::Linear
        || settings.method == FitMethod::Cubic || settings.method == FitMethod::Spline;
    const bool isCorrected = making.isCorrected || settings.drift;
    return settings.zero == FitZero::Keep && settings.slope == SlopeRemoval::Keep
        && settings.gain == 1.0 && !making.isMerged && isInterpolated && !isCorrected;
}

/// Whether the encoder stood there when the reference was read; between the targets nothing was.
bool isReadTarget(const Measurement& measurement, double position)
{
    if (!measurement.hasTargets() || hasRawReadings(measurement))
        return false;
    const double rounding = 1e-9 * (measurement.targets.back() - measurement.targets.front());
    return std::ranges::any_of(measurement.values, [&](const RunValue& value) {
        return value.isUsed && std::abs(measurement.targets[value.target] - position) <= rounding;
    });
}

bool isReadAt(const CompensationTable& table, const TableMaking& making, double position)
{
    const Measurement& measurement = making.measurement;
    return !correctsAnotherAxis(table.target, measurement.header.axis)
        && !measurement.againstFile.invertsReference && isAsMeasured(making)
        && isReadTarget(measurement, position);
}

bool isReadAtLargest(const CompensationTable& table, const TableMaking& making)
{
    if (table.values.empty() || table.grid.axes.size() != 1)
        return false;
    const auto largest =
        std::ranges::max_element(table.values, {}, [](float value) { return std::abs(value); });
    const auto index = static_cast<std::size_t>(largest - table.values.begin());
    return isReadAt(table, making, table.grid.axes.front().position(index));
}

/// Of a record that has all of it.
bool hasTableOfFit(const CalibrationRecord& record)
{
    return record.fit && record.before && !record.tables.empty();
}

TableMaking makingOf(const CalibrationRecord& record, const Measurement& measurement)
{
    const RecordedCorrections& corrections = record.before->corrections;
    return {measurement, record.fit->settings,
        corrections.temperature || corrections.deadPath || corrections.drift,
        !record.fit->active.empty()};
}

} // namespace

bool isReferenceRead(
    const CalibrationRecord& record, const Measurement& measurement, double position)
{
    return hasTableOfFit(record)
        && isReadAt(record.tables.front().table, makingOf(record, measurement), position);
}

bool isReferenceReadAtLargest(const CalibrationRecord& record)
{
    if (!hasTableOfFit(record))
        return false;
    const auto measurement = usedMeasurement(*record.before);
    return measurement
        && isReadAtLargest(record.tables.front().table, makingOf(record, *measurement));
}

bool isReferenceReadAtLargest(const Measurement& measurement, const CorrectionsBefore& corrections,
    const FitSettings& settings, const FitReport& report)
{
    const TableMaking making{measurement, settings, corrections.temperature || corrections.deadPath,
        report.state.active && !report.state.active->tables.empty()};
    return !report.tables.empty()
        && std::ranges::all_of(report.tables,
            [&](const FittedTable& made) { return isReadAtLargest(made.table, making); });
}

} // namespace axiscomp
