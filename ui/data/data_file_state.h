// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/conversion/axis_place.h"
#include "core/csv/calibration_csv.h"
#include "core/formats/table_format.h"
#include "core/metrology/fit/lookup_frame.h"
#include "core/text/diagnostic.h"

#include <QString>

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace axiscomp::ui {

/// The open file of compensation data.
struct DataFile {
    QString path; ///< of data; of the file that was tried when there is none; empty: none is open
    std::shared_ptr<const CalibrationData> data; ///< only of a file without errors
    const TableFormat* format = nullptr; ///< as which data was read
    std::vector<Text> report; ///< of the conversion of data
    UsedPlace usedPlace; ///< what of the axis's place data was made for
    std::vector<Diagnostic> problems;
    std::size_t suppressedProblems = 0;
    std::optional<FullGrid> fullGrid; ///< what the file with the problems is instead
    QString problemsPath; ///< the file that has the problems: after a bad one, not that of data
    /// A calibration file that was tried beside the open one and cannot be used: in another
    /// dimensionality it may. Empty: there is none.
    QString refusedPath;
    bool isReading = false;
    QString readingPath; ///< the file that is being read
    double progress = 0.0;
    bool hasChangedOnDisk = false;
    /// Not of a file: it was made here, and path is what it is called.
    bool isMade = false;
    bool isComputed = false; ///< as in WriteRequest
    /// Where the drive has to look the tables up; nothing: that is not known.
    std::optional<LookupAt> lookupAt;
    /// Serial number of the drive whose measurement the tables were made of; nothing: not known.
    std::optional<std::int32_t> measuredDrive;
    std::optional<Error> noteProblem; ///< why what the file says of these two is no statement
};

/// Tables that were made here, to be used as if they had been read from a file.
struct MadeTables {
    QString name; ///< what they are called: "Fit of x.csv"
    std::shared_ptr<const CalibrationData> data; ///< the wanted table first
    std::vector<LoadedTable> tables; ///< of data
    std::optional<LookupAt> lookupAt;
    bool isComputed = false; ///< as in WriteRequest
};

} // namespace axiscomp::ui
