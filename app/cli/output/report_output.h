// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/metrology/report/report_document.h"

#include <string>

namespace axiscomp::app {

/// language: one of textLanguages().
[[nodiscard]] ReportDocument inLanguage(ReportDocument document, const std::string& language);

/// Whether the module that draws PDF is installed.
[[nodiscard]] bool drawsPdf();

/// The document as PDF, by the module that is loaded for it. Errors: FileNotReadable when the
/// module is not installed; InvalidArgument where no font is, or none that has a character of it.
[[nodiscard]] Result<Bytes> drawnAsPdf(const ReportDocument& document);

} // namespace axiscomp::app
