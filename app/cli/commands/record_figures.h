// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/environment.h"
#include "core/metrology/record/calibration_record.h"
#include "core/store/measured_figures.h"

namespace axiscomp {
class DriveStore;
}

namespace axiscomp::app {

/// Keeps the figures of a record for `status`. The record has them in any case: a store that cannot
/// take them is a warning.
void keepFiguresOrWarn(Environment& environment, DriveStore& store, const CalibrationRecord& record,
    Measuring measuring);
/// Those of a new measurement, in the store of this user.
void keepFiguresOrWarn(Environment& environment, const CalibrationRecord& record);

} // namespace axiscomp::app
