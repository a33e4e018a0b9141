// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/conversion/import_choices.h"
#include "core/conversion/table_choice.h"
#include "core/csv/calibration_csv.h"
#include "core/table/table_layout.h"

#include <filesystem>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>

namespace axiscomp {

struct TableImportRequest {
    std::filesystem::path file;
    int dimensions = 1; ///< of a calibration file, which does not say
    ImportChoices choices;
    const TableLayout* layout = nullptr; ///< of TAM tables
    std::stop_token stop;
    std::function<void(double fraction)> progress; ///< may be empty
    /// Which table of the file is meant, where it is one: the drive need not be able to hold the
    /// others. tables: the name that each gets on the drive, and as its text that of the file.
    /// Empty: all of them.
    std::function<Result<std::size_t>(std::span<const TableName> tables)> choose = {};
};

/// What became of a file of any known format on its way to tables of the drive.
struct TableImport {
    const TableFormat* format = nullptr; ///< as which it was read; null: it is a measurement
    std::vector<const TableFormat*> candidates; ///< that its content allows
    std::shared_ptr<const CalibrationData> data; ///< only without an error; each column a table
    std::vector<Diagnostic> problems; ///< of the file, warnings too
    std::size_t suppressedProblems = 0;
    /// Why the choices do not suffice: other ones may.
    std::optional<Error> refusal;
    /// Of the values of the file, as stated or as it says itself; nothing: as its format says.
    std::optional<SignConvention> sign;
    std::vector<Text> report; ///< of conversions
    UsedPlace usedPlace; ///< what of ImportChoices::place the data was made for
    std::optional<FullGrid> fullGrid; ///< what a calibration file is instead (calibration_csv.h)
    int sourceAxes = 0; ///< of the tables of the file, 0: there are none
    bool hasDirections = false;
    bool hasWrap = false;
    bool isCancelled = false;
};

/// Reads the file and converts each of its columns to what the drive adds to the encoder position,
/// on an even grid. Takes long; to be called off the window's thread.
[[nodiscard]] TableImport importTables(const TableImportRequest& request);

} // namespace axiscomp
