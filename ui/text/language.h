// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QIcon>
#include <QLocale>
#include <QObject>
#include <QString>
#include <QTranslator>

#include <functional>
#include <memory>

namespace axiscomp::ui {

/// Makes the library's icons (:/axiscomp/icons) and translations (:/i18n) known to Qt. A static
/// library's resources are left out of a program that never asks for them. May be called often.
void useWizardResources();

/// The icon of the program, in every size.
[[nodiscard]] QIcon wizardIcon();

/// A text as the function that makes it, in the language of the moment in which it is called. What
/// is kept for longer than that is kept in this form: the language may change while the window is
/// open.
using Wording = std::function<QString()>;

/// The language of the page's texts and numbers, changed while the program runs. Translations are
/// the resources `:/i18n/axiscomp_<language>.qm`; the texts in the sources are English.
class Language : public QObject {
    Q_OBJECT

public:
    /// As select().
    explicit Language(const QString& language, QObject* parent = nullptr);
    ~Language() override;

    /// "en" and every language that there is a translation for.
    [[nodiscard]] static QStringList available();
    /// "Deutsch"
    [[nodiscard]] static QString nativeName(const QString& language);

    /// Empty: the system's, English when there is no translation for it. Every widget gets a
    /// LanguageChange event.
    void select(const QString& language);
    /// As selected: empty for the system's.
    [[nodiscard]] const QString& selected() const;

private:
    static void replace(std::unique_ptr<QTranslator>& translator, const QLocale& locale,
        const QString& name, const QString& folder);

    QString m_selected;
    QLocale m_systemDefault;
    std::unique_ptr<QTranslator> m_texts;
    std::unique_ptr<QTranslator> m_qtTexts;
};

} // namespace axiscomp::ui
