// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/bytes.h"
#include "core/base/result.h"
#include "core/metrology/report/report_document.h"

namespace axiscomp::ui {

/// The document as PDF/A-1b on A4, in the language that its texts have. What stands before the
/// first page break is one page, made smaller where it would not fit; the rest takes as many as it
/// needs. Needs a QGuiApplication, and takes some tenths of a second: not for the window's thread.
/// Errors: InvalidArgument where no font is installed, or none that has a character of it.
[[nodiscard]] Result<Bytes> reportPdf(const ReportDocument& document);

} // namespace axiscomp::ui
