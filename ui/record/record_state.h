// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"
#include "core/metrology/fine_quantity.h"
#include "core/metrology/judge/judgement.h"
#include "ui/data/data_file_loader.h"
#include "ui/record/deviation_series.h"
#include "ui/record/record.h"

#include <QStringList>

#include <memory>
#include <optional>
#include <stop_token>
#include <string>
#include <vector>

namespace axiscomp::ui {

/// What reading one file gave.
struct ReadMeasurement {
    MeasurementFile file; ///< as which it was read
    FileStamp stamp; ///< from before it was read
    const MeasurementFormat* format = nullptr; ///< null: not known, or the file is not readable
    std::shared_ptr<const MeasurementReading> reading; ///< null: likewise
    std::optional<Error> refusal; ///< why there is no measurement
    std::string sha256; ///< of the bytes that were read, in hexadecimal digits
    /// What it was when it could be used last, of one that cannot be used now.
    std::shared_ptr<const ReadMeasurement> lastUsable = {};
    // Counted once: of a million values that takes longer than a picture may be late.
    int upRuns = 0;
    int downRuns = 0;

    [[nodiscard]] const Measurement* measurement() const
    {
        return reading && reading->measurement ? &*reading->measurement : nullptr;
    }
};

/// Values of a measurement with targets, as plot and tables show them.
struct JudgedValues {
    DeviationSeries series; ///< without a measurement: there are none
    FineUnit unit; ///< of the figures of its targets
};

struct FitOutcome;

/// What a record comes to.
struct RecordState {
    Record record; ///< of which it is
    std::vector<ReadMeasurement> files; ///< one for each of the record
    /// Paths of those that have changed on disk, where a value that was there before is no longer
    /// at its place: what was left out and corrected would be other values. Empty where a file has
    /// only grown.
    QStringList changedFiles;
    /// All files as one, without what was left out; null when one of them cannot be used.
    std::shared_ptr<const Measurement> measurement;
    std::shared_ptr<const Judgement> judgement; ///< of a measurement with targets
    JudgedValues used; ///< of those in use; what judgement is about
    JudgedValues all; ///< the same without exclusions
    FineUnit offsetUnit; ///< of the offsets of its runs
    // By how much the corrections of the record have changed a value at most, in mm.
    std::optional<double> largestByTemperature;
    std::optional<double> largestByDeadPath;
    std::optional<Error> refusal; ///< why the files are no measurement together
    FineUnit unit; ///< in which the deviations of measurement are shown
    std::vector<int> upRunNumbers = {}; ///< of measurement, ascending
    std::vector<int> downRunNumbers = {};
    std::size_t excludedCount = 0; ///< its values that are not used
    bool hasRaw = false; ///< hasRawReadings(*measurement)
    /// The table of a measurement, or of an earlier one while RecordModel::isFitting(); null: there
    /// is no measurement.
    std::shared_ptr<const FitOutcome> fit;
};

/// Reads what `known` does not have yet, joins and judges it. known: of the files before, and of
/// others that were read earlier; of one file that stands there twice the first counts. Takes as
/// long as the files are large: not for the window's thread. Cut short by `stop`.
[[nodiscard]] RecordState evaluated(
    const Record& record, std::vector<ReadMeasurement> known, const std::stop_token& stop);

/// The files as one measurement, with what was left out marked and without the corrections of the
/// record. All files can be used. Copies all values: not for the window's thread. Errors: why they
/// are no measurement together.
[[nodiscard]] Result<Measurement> uncorrected(
    const Record& record, const std::vector<ReadMeasurement>& files);

} // namespace axiscomp::ui
