// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/environment.h"
#include "core/metrology/formats/measurement_format.h"

#include <CLI/App.hpp>

namespace axiscomp::app {

/// The options that say which measurement is meant, common to all commands that read one.
struct MeasurementInputOptions {
    std::string command; ///< "axiscomp judge": for hints
    std::vector<std::string> files; ///< "-": standard input
    std::string from; ///< empty: by content and extension
    std::string columns;
    std::size_t skippedLines = 0;
    std::string unit;
    std::string valueUnit;
    std::string values; ///< empty, deviation or reference
    std::string directionFrom; ///< empty, or order
    bool invertsReference = false;
    double overrun = 0.0;
    std::string excluded; ///< "down:1:1,run:up:3"
    bool swapsDirections = false;
    bool keepsFiles = false; ///< in MeasurementInput::files
};

/// FILE..., --from, --columns, --unit ...
void addMeasurementOptions(CLI::App& command, MeasurementInputOptions& options);

/// A file that a measurement came from.
struct MeasurementSource {
    std::string file;
    std::string format;
    std::string sha256; ///< of its bytes, in hexadecimal digits
};

/// [{"file", "format", "sha256"}]
[[nodiscard]] Json sourcesJson(const std::vector<MeasurementSource>& sources);
/// "x.rtl (renishaw), y.csv (runs)"
[[nodiscard]] std::string sourcesText(const std::vector<MeasurementSource>& sources);

struct MeasurementInput {
    Measurement measurement;
    std::vector<MeasurementSource> sources;
    std::vector<Diagnostic> warnings;
    /// Each file as it was read, in the order of the sources, where the options keep them.
    std::vector<Measurement> files;
};

/// SHA-256 of the bytes of a file, as of a MeasurementSource. Errors: FileNotReadable,
/// FileTooLarge, Cancelled.
[[nodiscard]] Result<std::string> measurementSha256(
    Environment& environment, const std::string& file);

/// Reads the files and makes one measurement of them, with directions exchanged and values excluded
/// as asked for. Diagnostics are reported. Errors: UnknownFormat, FormatAmbiguous, FileNotReadable,
/// FileTooLarge, InvalidMeasurement, UnitMissing, InstrumentScale, InvalidArgument, Cancelled.
[[nodiscard]] Result<MeasurementInput> readMeasurements(
    Environment& environment, const MeasurementInputOptions& options);

} // namespace axiscomp::app
