// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/texts/program_texts.h"

#include "core/text/wanted_languages.h"

#include <QDir>
#include <QLocale>
#include <QTranslator>

#include <algorithm>
#include <limits>

/// Q_INIT_RESOURCE declares a function, which must not be in a namespace.
static void useTranslations()
{
    Q_INIT_RESOURCE(axiscomp_texts);
}

namespace axiscomp::app {

namespace {

const QLatin1StringView folderOfTexts(":/axiscomp-texts");

} // namespace

std::vector<std::string> textLanguages()
{
    useTranslations();
    std::vector<std::string> languages{"en"};
    const QStringList files = QDir(folderOfTexts).entryList(QDir::Files, QDir::Name);
    for (const QString& file : files)
        languages.push_back(file.section(u'_', 1).section(u'.', 0, 0).toStdString());
    return languages;
}

std::string languageOfEnvironment()
{
    const std::vector<std::string> known = textLanguages();
    for (const std::string& wanted : wantedLanguages())
        if (std::ranges::find(known, wanted) != known.end())
            return wanted;
    return "en";
}

struct ProgramTexts::Translation {
    QTranslator translator;
    char decimalSign = '.';
};

ProgramTexts::ProgramTexts(const std::string& language)
{
    useTranslations();
    const QString name = QString::fromStdString(language);
    auto translation = std::make_unique<Translation>();
    if (!translation->translator.load(QStringLiteral("axiscomp_") + name, QString(folderOfTexts)))
        return;
    translation->decimalSign = QLocale(name).decimalPoint().front().toLatin1();
    m_translation = std::move(translation);
}

ProgramTexts::~ProgramTexts() = default;

std::string ProgramTexts::help(const std::string& text) const
{
    const QString words =
        m_translation ? m_translation->translator.translate("Help", text.c_str()) : QString();
    return words.isEmpty() ? text : words.toStdString();
}

Wording ProgramTexts::wording() const
{
    Wording wording;
    if (m_translation)
        wording.decimalSign = m_translation->decimalSign;
    wording.words = [this](const TextPattern& pattern, std::optional<std::int64_t> count) {
        const int form = count
            ? static_cast<int>(std::clamp<std::int64_t>(*count, 0, std::numeric_limits<int>::max()))
            : -1;
        const QString words = m_translation
            ? m_translation->translator.translate(pattern.context, pattern.words, pattern.one, form)
            : QString();
        if (!words.isEmpty())
            return words.toStdString();
        return std::string(pattern.one != nullptr && count == 1 ? pattern.one : pattern.words);
    };
    return wording;
}

} // namespace axiscomp::app
