// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QByteArray>
#include <QStringList>

class QSettings;

namespace axiscomp::ui {

/// What the page remembers between two starts. Without a QSettings it remembers nothing.
class WizardSettings {
public:
    /// May be null; must outlive this.
    explicit WizardSettings(QSettings* settings);

    [[nodiscard]] bool isKept() const;
    /// Addresses as the user gave them, without users and passwords.
    [[nodiscard]] QStringList endpoints() const;
    void setEndpoints(const QStringList& endpoints);
    /// Newest first.
    [[nodiscard]] QStringList recentFiles() const;
    void addRecentFile(const QString& path);
    /// Where the last file was.
    [[nodiscard]] QString folder() const;
    /// "de"; empty: the system's.
    [[nodiscard]] QString language() const;
    void setLanguage(const QString& language);
    [[nodiscard]] bool isPreviewSkippedForVolatile() const;
    void setPreviewSkippedForVolatile(bool isSkipped);
    /// Of a splitter, by its name.
    [[nodiscard]] QByteArray splitter(const QString& name) const;
    void setSplitter(const QString& name, const QByteArray& state);

    /// The roles that were chosen last for the columns of files with this header, one for each
    /// column, empty ones among them; empty: none were.
    [[nodiscard]] QStringList columnRoles(const QStringList& header) const;
    /// Empty: they are forgotten.
    void setColumnRoles(const QStringList& header, const QStringList& roles);

private:
    [[nodiscard]] QString key(QLatin1StringView name) const;

    QSettings* m_settings;
};

} // namespace axiscomp::ui
