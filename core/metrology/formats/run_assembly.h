// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/formats/measurement_format.h"

namespace axiscomp {

/// One value as a reader has it, in mm or deg.
struct RawRunValue {
    double target = 0.0;
    std::optional<double> reference; ///< position; the deviation follows from it
    RunValue value; ///< target is not set yet; run 0: the n-th value of its target and direction
};

/// Puts the values of a file together: finds the targets, counts runs, and looks for everything
/// that can be wrong with runs, whatever the format. measurement has kind, header and notes
/// already. Without errors it is complete.
void assembleRuns(std::vector<RawRunValue> values, const MeasurementReadOptions& options,
    Measurement& measurement, DiagnosticList& diagnostics);

/// The reference must follow the encoder one to one, within 1 % (least squares); anything else is
/// InstrumentScale, with what would explain it. Positions in the same unit.
void checkInstrumentScale(std::span<const double> encoder, std::span<const double> reference,
    DiagnosticList& diagnostics);

/// What every reader of a text does round its own `parse`: binary and oversized files, memory,
/// numbers beyond what a double holds.
[[nodiscard]] MeasurementReading readMeasurementText(std::string_view text,
    const MeasurementReadOptions& options,
    void (*parse)(std::string_view text, const MeasurementReadOptions& options,
        Measurement& measurement, DiagnosticList& diagnostics));

} // namespace axiscomp
