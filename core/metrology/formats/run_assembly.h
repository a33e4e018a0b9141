// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/formats/measurement_csv.h"
#include "core/metrology/formats/measurement_format.h"
#include "core/text/text_file.h"
#include "core/text/token_scanner.h"

namespace axiscomp {

/// One value as a reader has it, in mm or deg.
struct RawRunValue {
    double target = 0.0;
    std::optional<double> reference; ///< position; the deviation follows from it
    RunValue value; ///< target is not set yet; run 0: the n-th value of its target and direction
};

/// Puts the values of a file together: finds the targets, counts runs, and looks for everything
/// that can be wrong with runs, whatever the format. measurement has kind, header and notes
/// already, and as targets those that were planned, in any order, where the file names targets
/// without values. Without errors it is complete.
void assembleRuns(std::vector<RawRunValue> values, const MeasurementReadOptions& options,
    Measurement& measurement, DiagnosticList& diagnostics);

/// Positions of the same moments, in mm or deg.
struct FollowedPositions {
    std::span<const double> encoder;
    std::span<const double> reference; ///< inverted already where the options say it
    bool areAngles = false;
};
/// The reference must follow the encoder one to one, within 1 % (least squares); anything else is
/// InstrumentScale, with what would explain it.
void checkInstrumentScale(const FollowedPositions& positions, const MeasurementReadOptions& options,
    DiagnosticList& diagnostics);

/// Values at positions along one or more axes, all in one unit.
struct SizedValues {
    std::span<const std::vector<double>> positions; ///< [axis][value]
    std::span<const double> values;
    std::string unit; ///< "mm" or "deg"
    std::size_t line = 0; ///< where the name of their column stands; 0: they are the whole file's
    std::size_t column = 0;
};
/// Warns of deviations that look like positions (ValuesLookLikePositions), or whose size does not
/// fit the travel (UnitSuspicious).
void checkValueSizes(const SizedValues& sized, DiagnosticList& diagnostics);

/// The unit of something for which the format itself has one (ofFile): that which the user states,
/// with a note where it is another one. what: "targets", "values". Nothing: it is no unit, which is
/// reported.
[[nodiscard]] std::optional<MeasurementUnit> unitOfFormat(std::string_view what,
    const std::string& stated, const std::string& ofFile, Measurement& measurement,
    DiagnosticList& diagnostics);
/// That targets and values are both lengths or both angles; what else is reported.
[[nodiscard]] bool areSameKind(
    const MeasurementUnit& targets, const MeasurementUnit& values, DiagnosticList& diagnostics);

/// That --values and --invert-reference suit what a file holds; what else is reported.
void checkStatedValues(
    const MeasurementReadOptions& options, bool holdsReference, DiagnosticList& diagnostics);

/// What every reader of a text does round its own `parse`: binary and oversized files, memory,
/// numbers beyond what a double holds.
[[nodiscard]] MeasurementReading readMeasurementText(std::string_view text,
    const MeasurementReadOptions& options,
    void (*parse)(std::string_view text, const MeasurementReadOptions& options,
        Measurement& measurement, DiagnosticList& diagnostics));

/// The reader of a format of runs, or of their means, which are put together from the values that
/// `values` finds in the text.
template <auto values, MeasurementKind kind = MeasurementKind::Runs>
MeasurementReading readRuns(std::string_view text, const MeasurementReadOptions& options)
{
    constexpr auto parse = [](std::string_view whole, const MeasurementReadOptions& how,
                               Measurement& measurement, DiagnosticList& diagnostics) {
        measurement.kind = kind;
        std::vector<RawRunValue> found = values(whole, how, measurement, diagnostics);
        if (!how.stop.stop_requested())
            assembleRuns(std::move(found), how, measurement, diagnostics);
    };
    return readMeasurementText(text, options, parse);
}

/// What a Reader that takes line after line has found in the end.
template <typename Reader>
std::vector<RawRunValue> valuesByLine(std::string_view text, const MeasurementReadOptions& options,
    Measurement& measurement, DiagnosticList& diagnostics)
{
    const TextInspection inspection(text, options.stop, diagnostics);
    if (diagnostics.hasErrors())
        return {};
    Reader reader(measurement, options, diagnostics, inspection.encoding());
    TextLines lines(inspection.body());
    while (const auto line = lines.next()) {
        if (options.stop.stop_requested())
            return {};
        reader.takeLine(*line);
    }
    return reader.values();
}

} // namespace axiscomp
