// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/compensation_table.h"
#include "core/table/missing_points.h"
#include "core/table/table_units.h"
#include "core/text/diagnostic.h"

#include <cstddef>
#include <filesystem>
#include <functional>
#include <optional>
#include <stop_token>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

/// What a calibration file holds: compensation tables over one grid (docs/calibration-csv.md,
/// AN140 2.3).
struct CalibrationData {
    Grid grid;
    std::vector<CompensationTable>
        tables; ///< at least one, each with the same grid, in column order
    std::vector<std::string> notes; ///< the comment lines without their slashes
};

struct CsvOptions {
    int dimensions = 1; ///< 1, 2 or 3: chosen by the user, never guessed
    bool acceptsUneven = false; ///< positions that are not evenly spaced are no error: see knots
    /// With another choice than Refuse a point may have no line, and a value may be an empty cell,
    /// nan or `#N/A`.
    MissingPoints missing = MissingPoints::Refuse;
    StatedUnits units = {}; ///< in place of those of the header
    /// How far positions may be off the grid, in their unit: closer ones are one. 0: half of the
    /// last decimal printed.
    double snap = 0.0;
    std::size_t maximumCells = 64'000'000; ///< rows x columns; above: TooLarge
    std::size_t maximumBytes = std::size_t{1}
        << 30; ///< file size; above: TooLarge, nothing is read
    std::size_t maximumDiagnostics = 100;
    /// Each reads pieces of the file; 0: one on each processor. What comes out does not depend on
    /// these two.
    std::size_t threads = 0;
    std::size_t pieceBytes = std::size_t{1} << 17U; ///< at most 256 KiB
    std::stop_token stop;
    std::function<void(double fraction)>
        progress; ///< 0..1, on the calling thread, a few hundred times
};

/// What the lines are when they are no grid of the dimensionality that was chosen.
struct FullGrid {
    int dimensions = 2;
    std::vector<std::size_t> points; ///< per dimension

    friend bool operator==(const FullGrid&, const FullGrid&) = default;
};

struct CsvReading {
    std::optional<CalibrationData> data; ///< only without an error
    /// A full grid of more dimensions than were chosen; never of fewer, since positions would
    /// become corrections. The diagnostics are then that, and the first error.
    std::optional<FullGrid> fullGrid;
    /// Of each dimension, only with acceptsUneven and with data. Where they are uneven, the grid of
    /// the data has their number, their first and their mean distance.
    std::vector<std::vector<double>> knots;
    std::vector<Diagnostic> diagnostics; ///< errors and warnings, in the order of the file
    std::size_t suppressed = 0; ///< further errors above maximumDiagnostics
    bool cancelled = false;

    [[nodiscard]] bool hasErrors() const;
};

/// text need not end in a line end; it is not kept.
[[nodiscard]] CsvReading parseCalibrationCsv(std::string_view text, const CsvOptions& options);

/// Reads and parses; a file that cannot be read gives IoError.
[[nodiscard]] CsvReading readCalibrationCsv(
    const std::filesystem::path& file, const CsvOptions& options);

/// A calibration file that parses back to the same data (positions and values in shortest exact
/// form). threads: as shareWork has them; the text does not depend on it.
[[nodiscard]] std::string writeCalibrationCsv(const CalibrationData& data, std::size_t threads = 0);

/// The notes of a file that is none of this kind: what states something in a calibration file,
/// target: or sign:, becomes mere text.
[[nodiscard]] std::vector<std::string> withoutStatements(std::vector<std::string> notes);
/// "note: target: Z": a comment that states nothing.
[[nodiscard]] std::string mereNote(std::string_view note);

/// The example file of AN140 2.3 for 1, 2 or 3 dimensions; parses back without a warning.
[[nodiscard]] std::string exampleCalibrationCsv(int dimensions, int tables = 2);

} // namespace axiscomp
