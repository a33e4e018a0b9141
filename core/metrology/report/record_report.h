// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/record/calibration_record.h"
#include "core/metrology/report/report_content.h"

namespace axiscomp {

/// What a record says, as the page shows it. Its last measurement with the table active is the one
/// after; its first table is the one shown. Errors: InvalidArgument for exclusions and corrections
/// that its measurements do not allow.
[[nodiscard]] Result<ReportContent> reportContent(
    const CalibrationRecord& record, const std::string& programVersion);

} // namespace axiscomp
