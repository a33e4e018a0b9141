// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/language.h"

#include <QCoreApplication>
#include <QDir>
#include <QLibraryInfo>
#include <QLocale>

/// Q_INIT_RESOURCE declares a function, which must not be in a namespace.
static void initialise()
{
    Q_INIT_RESOURCE(axiscomp_wizard);
}

namespace axiscomp::ui {

namespace {

const QLatin1StringView folderOfTexts(":/i18n");
const QLatin1StringView baseName("axiscomp");

} // namespace

void useWizardResources()
{
    initialise();
}

QIcon wizardIcon()
{
    useWizardResources();
    QIcon icon;
    for (const int size : {16, 24, 32, 48, 64, 128, 256})
        icon.addFile(QStringLiteral(":/axiscomp/icons/axis-compensation-wizard-%1.png").arg(size));
    return icon;
}

Language::Language(const QString& language, QObject* parent) : QObject(parent)
{
    select(language);
}

Language::~Language()
{
    // The program around the page goes on in its own language.
    QLocale::setDefault(m_systemDefault);
    for (const auto* translator : {&m_texts, &m_qtTexts}) {
        if (*translator)
            QCoreApplication::removeTranslator(translator->get());
    }
}

QStringList Language::available()
{
    useWizardResources();
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
    useWizardResources();
    m_selected = language;
    const QLocale locale = language.isEmpty() ? m_systemDefault : QLocale(language);
    // Numbers follow the language; without a choice they follow the system.
    QLocale::setDefault(locale);
    replace(m_qtTexts, locale, QStringLiteral("qtbase"),
        QLibraryInfo::path(QLibraryInfo::TranslationsPath));
    replace(m_texts, locale, baseName, folderOfTexts);
    // Also when nothing was installed: the numbers may look different. Qt brings the widgets one
    // event for all of these, when the program is idle.
    QEvent change(QEvent::LanguageChange);
    QCoreApplication::sendEvent(QCoreApplication::instance(), &change);
}

const QString& Language::selected() const
{
    return m_selected;
}

/// A translator is never loaded again while it is installed: other threads may be using it.
void Language::replace(std::unique_ptr<QTranslator>& translator, const QLocale& locale,
    const QString& name, const QString& folder)
{
    auto next = std::make_unique<QTranslator>();
    const bool isEnglish = locale.language() == QLocale::English;
    if (isEnglish || !next->load(locale, name, QStringLiteral("_"), folder))
        next.reset();
    if (next)
        QCoreApplication::installTranslator(next.get());
    if (translator)
        QCoreApplication::removeTranslator(translator.get());
    translator = std::move(next);
}

} // namespace axiscomp::ui
