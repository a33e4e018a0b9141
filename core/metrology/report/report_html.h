// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/report/report_document.h"

#include <string>

namespace axiscomp {

/// One file of HTML 5 in UTF-8: plots as SVG within it, no scripts, nothing from elsewhere.
/// Printed, it fills A4 as the PDF does.
[[nodiscard]] std::string reportHtml(const ReportDocument& document);

} // namespace axiscomp
