// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/metrology/report/report_document.h"

namespace axiscomp::app {

// What draws PDF needs Qt Gui and fonts, for which no other command should wait: it is a module
// that `axiscomp report` loads when it writes PDF.

inline constexpr const char* reportModuleName = "axiscomp-report-pdf";
/// Its only function, of the type ReportModuleFunction.
inline constexpr const char* reportModuleFunction = "axiscompReportPdf";
using ReportModuleFunction = void (*)(const ReportDocument& document, Result<Bytes>& pdf);

} // namespace axiscomp::app
