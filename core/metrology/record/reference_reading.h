// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/record/calibration_record.h"

namespace axiscomp {

// A person compares the sign of a table with what the machine's reference shows. What it showed may
// be told only where it was read.

/// Whether the first table of the record has at this position what the reference said there: an
/// encoder stood there when it was read, and nothing was taken out, put to it, smoothed or
/// corrected. measurement: that the table was made of, as it was used.
[[nodiscard]] bool isReferenceRead(
    const CalibrationRecord& record, const Measurement& measurement, double position);
/// The same at the largest value of that table; false for one of several dimensions, and for a
/// record whose measurement cannot be used.
[[nodiscard]] bool isReferenceReadAtLargest(const CalibrationRecord& record);
/// The same of every table of a fit, of which no record has been begun. measurement: as it was
/// fitted, after these corrections.
[[nodiscard]] bool isReferenceReadAtLargest(const Measurement& measurement,
    const CorrectionsBefore& corrections, const FitSettings& settings, const FitReport& report);

} // namespace axiscomp
