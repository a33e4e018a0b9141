// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"
#include "core/metrology/record/calibration_record.h"
#include "core/store/drive_store.h"
#include "core/store/measured_figures.h"

#include <optional>

namespace axiscomp {

// What this computer remembers of a record, so that an axis can be said to be how good as long as
// it has the table.

/// Of the table that was written by the record; nothing for one that was not written, and for
/// measurements without figures. time: of now.
[[nodiscard]] std::optional<MeasuredFigures> figuresToKeep(
    const CalibrationRecord& record, WallTime time);

/// Keeps them by drive, axis and CRC, where there are any that take the place of what is known
/// (takesPlaceOf). Errors: those of DriveStore.
[[nodiscard]] Result<void> keepFigures(
    DriveStore& store, const CalibrationRecord& record, WallTime time, Measuring measuring);

/// "measured 2026-11-20: accuracy A 14.3 um before, 3.2 um after (tolerance 5 um: passed)": each
/// figure that has a tolerance; where none has, A, or what there is of it. Behind them that values
/// are excluded, and that the last measurement covers less of the axis than the first one.
[[nodiscard]] Text measuredFiguresText(const MeasuredFigures& measured);
/// The first of them in short: "A 3.2 um, 14.3 um before".
[[nodiscard]] Text measuredFiguresCell(const MeasuredFigures& measured);

} // namespace axiscomp
