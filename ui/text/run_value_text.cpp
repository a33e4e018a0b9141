// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/run_value_text.h"

#include "ui/text/fine_scale.h"
#include "ui/text/translated_text.h"

#include <QCoreApplication>

namespace axiscomp::ui {

namespace {

QString inWords(const char* text)
{
    return QCoreApplication::translate("RunValueText", text);
}

} // namespace

QString runValueText(const RunValue& value, const FineScale& scale, bool isProposedForExclusion)
{
    const QString words = inWords(QT_TRANSLATE_NOOP("RunValueText", "%1, target %2, run %3, %4"))
                              .arg(translated(approachText(value.direction)))
                              .arg(value.target + 1)
                              .arg(value.run)
                              .arg(scale.textWithUnit(value.deviation));
    if (!value.isUsed)
        return words + QStringLiteral(", ")
            + inWords(QT_TRANSLATE_NOOP("RunValueText", "excluded"));
    if (isProposedForExclusion)
        return words + QStringLiteral(", ")
            + inWords(QT_TRANSLATE_NOOP("RunValueText", "proposed for exclusion"));
    return words;
}

} // namespace axiscomp::ui
