// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/language.h"

#include <QCoreApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>

namespace axiscomp::ui {

namespace {

const QLatin1StringView folderOfTexts(":/i18n");
const QLatin1StringView baseName("axiscomp");

} // namespace

Language::Language(const QString& language, QObject* parent) : QObject(parent)
{
    select(language);
}

Language::~Language()
{
    QCoreApplication::removeTranslator(&m_texts);
    QCoreApplication::removeTranslator(&m_qtTexts);
}

QStringList Language::available()
{
    QStringList languages{QStringLiteral("en")};
    const QStringList files =
        QDir(folderOfTexts)
            .entryList({baseName + QStringLiteral("_*.qm")}, QDir::Files, QDir::Name);
    for (const QString& file : files)
        languages += file.section(u'_', 1).section(u'.', 0, 0);
    languages.removeDuplicates();
    return languages;
}

QString Language::nativeName(const QString& language)
{
    QString name = QLocale(language).nativeLanguageName();
    if (name.startsWith(QStringLiteral("American ")))
        name = QStringLiteral("English");
    if (!name.isEmpty())
        name[0] = name[0].toUpper();
    return name.isEmpty() ? language : name;
}

void Language::select(const QString& language)
{
    m_selected = language;
    const QLocale locale = language.isEmpty() ? m_systemDefault : QLocale(language);
    // Numbers follow the language; without a choice they follow the system.
    QLocale::setDefault(locale);
    install(m_qtTexts, locale, QStringLiteral("qtbase"),
        QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    install(m_texts, locale, baseName, folderOfTexts);
    // Also when nothing was installed: the numbers may look different.
    QEvent change(QEvent::LanguageChange);
    QCoreApplication::sendEvent(QCoreApplication::instance(), &change);
}

const QString& Language::selected() const
{
    return m_selected;
}

void Language::install(
    QTranslator& translator, const QLocale& locale, const QString& name, const QString& folder)
{
    QCoreApplication::removeTranslator(&translator);
    const bool isEnglish = locale.language() == QLocale::English;
    if (isEnglish || !translator.load(locale, name, QStringLiteral("_"), folder)) {
        // An empty translator forgets what it had loaded before.
        static_cast<void>(translator.load(QString()));
        return;
    }
    QCoreApplication::installTranslator(&translator);
}

} // namespace axiscomp::ui
