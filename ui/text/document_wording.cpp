// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/document_wording.h"

#include "ui/text/language.h"

#include <QTranslator>

#include <algorithm>
#include <limits>

namespace axiscomp::ui {

ReportDocument inLanguageOf(ReportDocument document, const QLocale& locale)
{
    useWizardResources();
    const QString name = QLocale::languageToCode(locale.language());
    QTranslator translator;
    const bool isTranslated = Language::available().contains(name) && name != QStringLiteral("en")
        && translator.load(QStringLiteral("axiscomp_") + name, QStringLiteral(":/i18n"));
    axiscomp::Wording wording;
    wording.decimalSign = isTranslated ? locale.decimalPoint().front().toLatin1() : '.';
    wording.words = [&translator, isTranslated](
                        const TextPattern& pattern, std::optional<std::int64_t> count) {
        const int form = count
            ? static_cast<int>(std::clamp<std::int64_t>(*count, 0, std::numeric_limits<int>::max()))
            : -1;
        const QString words = isTranslated
            ? translator.translate(pattern.context, pattern.words, pattern.one, form)
            : QString();
        if (!words.isEmpty())
            return words.toStdString();
        return std::string(pattern.one != nullptr && count == 1 ? pattern.one : pattern.words);
    };
    return worded(
        std::move(document), wording, isTranslated ? name.toStdString() : std::string("en"));
}

} // namespace axiscomp::ui
