// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "ui/record/record_state.h"

#include <array>
#include <memory>
#include <string>
#include <vector>

namespace axiscomp::ui {

/// What a file .axcal is in the window: the measurement and its second one.
struct OpenedRecord {
    Record record;
    Record after;

    friend bool operator==(const OpenedRecord&, const OpenedRecord&) = default;
};

/// Both refer to what they are opened from. The second measurement is the one that is not kept yet,
/// else the last one that is. The choices of the fit are those of the table; where it is looked up
/// and what was active while it was measured are to be said anew.
[[nodiscard]] OpenedRecord opened(const std::shared_ptr<const CalibrationRecord>& calibration);

/// The files of a measurement as they were read, and what was said of them. There is at least one.
/// Errors: of the first file that cannot be used.
[[nodiscard]] Result<RecordedMeasurement> recordedMeasurement(const RecordState& state);

/// Whether two are the same but for members that this version does not know, and for the drift that
/// was taken out for a table.
[[nodiscard]] bool isSameMeasurement(const RecordedMeasurement& a, const RecordedMeasurement& b);

/// SHA-256 of the files of a measurement and its second one, as they were read; empty: of one that
/// cannot be read.
using FileDigests = std::array<std::vector<std::string>, 2>;
[[nodiscard]] FileDigests fileDigests(const RecordState& record, const RecordState& after);
/// Whether a file was read that is another one by now; one that cannot be read is none.
[[nodiscard]] bool haveChanged(const FileDigests& now, const FileDigests& known);

/// Everything that a record in the window comes to.
struct RecordParts {
    RecordState record; ///< of the newest Record
    RecordState after; ///< likewise
    /// What the file holds, or what was begun: for all that the window does not change.
    std::shared_ptr<const CalibrationRecord> base;
    /// Nothing differs from base: it is what comes out, byte for byte.
    bool isUnchanged = false;
    /// Files that cannot be used are left out, where they are an error otherwise.
    bool leavesOutUnusable = false;
};
/// What is to be saved. Copies all values: not for the window's thread. Errors: as
/// recordedMeasurement.
[[nodiscard]] Result<CalibrationRecord> assembled(const RecordParts& parts);

} // namespace axiscomp::ui
