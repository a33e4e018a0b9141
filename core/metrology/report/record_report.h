// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/record/calibration_record.h"
#include "core/metrology/report/report_content.h"

#include <filesystem>
#include <optional>

namespace axiscomp {

/// What a record says, as the page shows it. Its last measurement with the table active is the one
/// after; its first table is the one shown. Errors: InvalidArgument for exclusions and corrections
/// that its measurements do not allow.
[[nodiscard]] Result<ReportContent> reportContent(
    const CalibrationRecord& record, const std::string& programVersion);

enum class ReportFormat { Pdf, Html };
/// By the extension of the file (.pdf, .html, .htm), capital or small; nothing for another one.
[[nodiscard]] std::optional<ReportFormat> reportFormatOf(const std::filesystem::path& file);

} // namespace axiscomp
