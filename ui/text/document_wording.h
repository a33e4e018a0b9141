// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/report/report_document.h"

#include <QLocale>

namespace axiscomp::ui {

/// The document in the language of a locale, English where there is no translation for it. On any
/// thread: it uses none of the window's translations.
[[nodiscard]] ReportDocument inLanguageOf(ReportDocument document, const QLocale& locale);

} // namespace axiscomp::ui
