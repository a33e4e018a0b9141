// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/environment.h"
#include "core/csv/calibration_csv.h"
#include "core/drive/drive_profile.h"
#include "core/formats/table_format.h"

#include <CLI/App.hpp>

#include <memory>
#include <optional>

namespace axiscomp::app {

/// The options that say which table is meant, common to all commands that read one.
struct TableInputOptions {
    std::string command; ///< "axiscomp inspect": for hints
    std::string file; ///< "-": standard input
    std::string from; ///< empty: by content and extension
    std::vector<std::string> settings; ///< KEY=VALUE, what the file does not say
    bool acceptsUneven = false; ///< a calibration file's positions need not be even
    int dimensions = 0; ///< 0: not given
    std::string fill; ///< nearest, plane, smooth; empty: points without a value are an error
    bool crops = false;
    double snap = 0.0; ///< see CsvOptions
    StatedUnits units; ///< likewise; they come before the settings
    std::string table; ///< name or number; empty: the only one
    std::string profile; ///< path; empty: the built-in one
};

void addDimensionsOption(CLI::App& command, TableInputOptions& options);
void addFromOption(CLI::App& command, TableInputOptions& options); ///< and --set-in
/// --fill, --crop, --snap
void addIncompleteGridOptions(CLI::App& command, TableInputOptions& options);
CLI::Option* addTableOption(CLI::App& command, TableInputOptions& options);
void addProfileOption(CLI::App& command, std::string& profile);

/// The named profile, or the built-in one, which must outlive nothing.
[[nodiscard]] Result<DriveProfile> profileOf(const std::string& file);

/// "KEY=VALUE" pairs. Errors: InvalidArgument.
[[nodiscard]] Result<FormatSettings> settingsOf(
    const std::vector<std::string>& pairs, const std::string& command);

/// A file of any known format.
struct TableInput {
    const TableFormat* format = nullptr;
    std::optional<CalibrationData> data; ///< of the product's own formats, without an error
    std::vector<std::vector<double>> knots; ///< see CsvReading, with acceptsUneven
    std::vector<NeutralTable> tables; ///< of all other formats, empty with an error
    std::vector<Diagnostic> diagnostics;
    std::size_t suppressed = 0; ///< further errors that are not listed
    bool persistent = false;
    std::size_t bytes = 0; ///< of a TAM table file

    [[nodiscard]] bool isValid() const { return data || !tables.empty(); }
};

/// "input.csv", "<stdin>": as diagnostics name it.
[[nodiscard]] std::string displayName(const std::string& file);

/// Reads; diagnostics are reported to the environment and kept. Errors: UnknownFormat,
/// FormatAmbiguous, InvalidArgument when the number of dimensions is needed and missing,
/// DimensionMismatch, FileNotReadable, FileTooLarge, InvalidTable, Cancelled.
[[nodiscard]] Result<TableInput> inspectInput(
    Environment& environment, const TableInputOptions& options);

/// The same, and a file with errors is an error: InvalidCalibration.
[[nodiscard]] Result<TableInput> readInput(
    Environment& environment, const TableInputOptions& options);

/// The index of the table that was asked for. Errors: TableNotFound, InvalidArgument when there are
/// several and none was named.
[[nodiscard]] Result<std::size_t> chooseTable(
    const CalibrationData& data, const TableInputOptions& options);

/// The tables of the file, of any format.
[[nodiscard]] std::vector<NeutralTable> neutralTables(const TableInput& input);

/// Every column of the file (a pair of directions is one) as a table of its own.
[[nodiscard]] std::vector<NeutralTable> neutralColumns(const TableInput& input);

/// One of these.
struct ChosenColumn {
    NeutralTable table;
    std::shared_ptr<const NeutralTable> beside; ///< as sourcesBeside has them
};
/// --table by name, target or number, of what separateColumns makes. Errors as chooseTable.
[[nodiscard]] Result<ChosenColumn> chosenColumn(
    const std::vector<NeutralTable>& tables, const TableInputOptions& options);

} // namespace axiscomp::app
