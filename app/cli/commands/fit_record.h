// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/input/judging_options.h"
#include "app/cli/input/measurement_input.h"
#include "core/metrology/record/calibration_record.h"

namespace axiscomp::app {

/// A measurement as a record holds it: as it was read, and what was asked for. input: with its
/// files. Errors: InvalidArgument.
[[nodiscard]] Result<RecordedMeasurement> recordedMeasurement(const MeasurementInput& input,
    const MeasurementInputOptions& options, const MadeCorrections& corrections);

/// The record that a fit begins: what was measured and how, the tables, and what they promise.
/// input: with its files. Errors: InvalidArgument.
[[nodiscard]] Result<CalibrationRecord> recordOfFit(const MeasurementInput& input,
    const MeasurementInputOptions& options, const MadeCorrections& corrections,
    const FitSettings& settings, const FitReport& report);

/// Whether a record can be begun in this file. One that exists is kept: it cannot be measured
/// again. Errors: InvalidArgument.
[[nodiscard]] Result<void> checkNewRecord(const std::string& file, const std::string& command);

} // namespace axiscomp::app
