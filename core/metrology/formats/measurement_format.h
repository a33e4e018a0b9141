// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/metrology/measurement.h"
#include "core/text/diagnostic.h"

#include <optional>
#include <span>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

/// Which column of a CSV file is what: "target" is column "1" or "Position".
struct ColumnMapping {
    std::string role;
    std::string column; ///< its number from 1, or its name

    friend bool operator==(const ColumnMapping&, const ColumnMapping&) = default;
};

/// "target=1,direction=3,deviation=5". Errors: InvalidArgument.
[[nodiscard]] Result<std::vector<ColumnMapping>> columnMappingFromText(std::string_view text);

struct MeasurementReadOptions {
    std::vector<ColumnMapping> columns; ///< of a CSV file; empty: its header names them
    std::size_t skippedLines = 0; ///< before the header of a CSV file
    std::string unit; ///< of targets and encoder; empty: as the file says
    std::string valueUnit; ///< of deviations and reference; empty: as the file says
    enum class Values { AsFileSays, Deviation, Reference };
    Values values = Values::AsFileSays;
    bool takesDirectionFromOrder = false; ///< runs rise and fall; the file has no directions
    bool invertsReference = false; ///< the instrument counts the other way
    /// What a track moves after a turn before its samples count, in mm or deg. 0: 1 % of the range.
    double overrun = 0.0;
    std::size_t maximumBytes = std::size_t{1} << 30;
    std::size_t maximumDiagnostics = 100;
    std::stop_token stop;
};

struct MeasurementReading {
    std::optional<Measurement> measurement; ///< only without an error
    std::vector<Diagnostic> diagnostics; ///< in the order of the file
    std::size_t suppressed = 0; ///< further errors
    bool cancelled = false;

    [[nodiscard]] bool hasErrors() const;
};

/// What a format is. Lists, documentation and checks are made from this.
struct MeasurementFacts {
    std::string_view name = {}; ///< "renishaw": for --from
    std::string_view origin = {}; ///< "Renishaw laser software"
    TextPattern description = {};
    std::span<const std::string_view> extensions = {}; ///< ".rtl", the usual one first
    std::span<const MeasurementKind> kinds = {};
    std::span<const std::string_view> rules = {}; ///< sentences for documentation
    std::span<const std::string_view> assumptions = {}; ///< likewise; ours
};

enum class MeasurementRecognition { No, Possible, Certain };

struct MeasurementFormat {
    MeasurementFacts facts;
    /// text: the first bytes of the file, at most 64 KiB; may end in the middle of a line.
    MeasurementRecognition (*recognise)(std::string_view text) = nullptr;
    MeasurementReading (*read)(
        std::string_view text, const MeasurementReadOptions& options) = nullptr;
};

/// All of them, the program's own first.
[[nodiscard]] std::span<const MeasurementFormat* const> measurementFormats();

/// "runs, wide": their names, for sentences.
[[nodiscard]] std::string measurementFormatNames();

/// Whether a file is no table of corrections, whatever its name. beginning: as of recognise.
[[nodiscard]] bool isCertainMeasurement(std::string_view beginning);

/// By name, upper or lower case. Errors: UnknownFormat.
[[nodiscard]] Result<const MeasurementFormat*> measurementFormatNamed(std::string_view name);

/// What a file is read as when nobody says it: what its content is certain to be, else what it may
/// be if its extension fits too. text: the whole file or its beginning. A file whose columns are
/// mapped is CSV. Errors: UnknownFormat, FormatAmbiguous.
[[nodiscard]] Result<const MeasurementFormat*> chooseMeasurementFormat(
    std::string_view text, std::string_view fileName, const MeasurementReadOptions& options);

/// The beginning of a CSV file, for a person to say which column is what.
struct MeasurementPreview {
    std::vector<std::string> columns; ///< "Position [mm]"
    std::vector<std::vector<std::string>> rows; ///< as many cells as columns
};
/// text: the beginning of the file. Nothing for what is no CSV with a line of names.
[[nodiscard]] std::optional<MeasurementPreview> previewMeasurement(
    std::string_view text, std::size_t skippedLines, std::size_t mostRows);

/// The error for a file whose reading has errors: UnitMissing or InstrumentScale when that is all
/// that is wrong, else InvalidMeasurement.
[[nodiscard]] Error measurementError(const std::string& file, const MeasurementReading& reading);

/// The documented CSV of runs (docs/metrology.md), which reads back to the same values. Only for
/// runs and averages.
[[nodiscard]] std::string writeRunsCsv(const Measurement& measurement);

} // namespace axiscomp
