// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/record/calibration_record.h"

namespace axiscomp {

/// The record that a fit begins: what was measured and how, the tables, and what they promise.
/// before: with its files. settings: those of the fit, of one direction or of the mean, since a
/// record is of a drive; its removal of drift is among the corrections of the measurement. program:
/// and its version, "axiscomp 1.0".
[[nodiscard]] CalibrationRecord recordOfFit(RecordedMeasurement before, const FitSettings& settings,
    const FitReport& report, const std::string& program, WallTime time);

/// What a person reads in the file of the table, and what a write holds the drive to: where it has
/// to look the table up, and which one was measured. sources: the files of the measurement and what
/// they hold.
[[nodiscard]] std::vector<std::string> notesOfFit(const std::string& sources,
    const Measurement& measurement, const FitSettings& settings, const FitReport& report);

} // namespace axiscomp
