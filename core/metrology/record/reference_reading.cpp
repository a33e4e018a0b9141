// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/record/reference_reading.h"

#include "core/metrology/record/fit_record.h"
#include "core/table/target_axis.h"

#include <algorithm>
#include <cmath>
#include <utility>

namespace axiscomp {

namespace {

/// Whether the values of the table are what was measured: nothing was taken out of them, put to
/// them or smoothed.
bool isAsMeasured(const RecordedFit& fit, const RecordedCorrections& corrections)
{
    const FitSettings& settings = fit.settings;
    const bool isInterpolated = settings.method == FitMethod::Linear
        || settings.method == FitMethod::Cubic || settings.method == FitMethod::Spline;
    const bool isCorrected =
        corrections.temperature || corrections.deadPath || corrections.drift || settings.drift;
    return settings.zero == FitZero::Keep && settings.slope == SlopeRemoval::Keep
        && settings.gain == 1.0 && fit.active.empty() && isInterpolated && !isCorrected;
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

bool isReadAtLargest(const CalibrationRecord& record, const Measurement& measurement)
{
    const CompensationTable& table = record.tables.front().table;
    if (table.values.empty() || table.grid.axes.size() != 1)
        return false;
    const auto largest =
        std::ranges::max_element(table.values, {}, [](float value) { return std::abs(value); });
    const auto index = static_cast<std::size_t>(largest - table.values.begin());
    return isReferenceRead(record, measurement, table.grid.axes.front().position(index));
}

} // namespace

bool isReferenceRead(
    const CalibrationRecord& record, const Measurement& measurement, double position)
{
    return record.fit && record.before && !record.tables.empty()
        && !correctsAnotherAxis(record.tables.front().table.target, measurement.header.axis)
        && !measurement.againstFile.invertsReference
        && isAsMeasured(*record.fit, record.before->corrections)
        && isReadTarget(measurement, position);
}

bool isReferenceReadAtLargest(const CalibrationRecord& record)
{
    if (!record.before || record.tables.empty())
        return false;
    const auto measurement = usedMeasurement(*record.before);
    return measurement && isReadAtLargest(record, *measurement);
}

bool isReferenceReadAtLargest(const Measurement& measurement, const CorrectionsBefore& corrections,
    const FitSettings& settings, const FitReport& report)
{
    RecordedMeasurement before;
    before.corrections = {corrections.temperature, corrections.deadPath};
    CalibrationRecord record = recordOfFit(std::move(before), settings, report, {}, {});
    return std::ranges::all_of(report.tables, [&](const FittedTable& made) {
        record.tables.front().table = made.table;
        return isReadAtLargest(record, measurement);
    });
}

} // namespace axiscomp
