// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/wizard_settings.h"

#include "ui/endpoint_text.h"

#include <QDir>
#include <QFileInfo>
#include <QSettings>

namespace axiscomp::ui {

namespace {

constexpr qsizetype longestRecentList = 8;
const QLatin1StringView endpointsKey("endpoints");
const QLatin1StringView recentKey("recentFiles");
const QLatin1StringView languageKey("language");
const QLatin1StringView skipPreviewKey("skipPreviewForVolatile");
const QLatin1StringView splitterKey("splitter/");

} // namespace

WizardSettings::WizardSettings(QSettings* settings) : m_settings(settings) { }

bool WizardSettings::isKept() const
{
    return m_settings != nullptr;
}

QString WizardSettings::key(QLatin1StringView name) const
{
    return QLatin1StringView("compensationWizard/") + name;
}

QStringList WizardSettings::endpoints() const
{
    return m_settings ? m_settings->value(key(endpointsKey)).toStringList() : QStringList();
}

void WizardSettings::setEndpoints(const QStringList& endpoints)
{
    if (!m_settings)
        return;
    QStringList shown;
    for (const QString& endpoint : endpoints)
        shown += shownEndpoint(endpoint);
    m_settings->setValue(key(endpointsKey), shown);
}

QStringList WizardSettings::recentFiles() const
{
    return m_settings ? m_settings->value(key(recentKey)).toStringList() : QStringList();
}

void WizardSettings::addRecentFile(const QString& path)
{
    if (!m_settings || path.isEmpty())
        return;
    QStringList files = recentFiles();
    const QString absolute = QFileInfo(path).absoluteFilePath();
    files.removeAll(absolute);
    files.prepend(absolute);
    m_settings->setValue(key(recentKey), files.mid(0, longestRecentList));
}

QString WizardSettings::folder() const
{
    const QStringList files = recentFiles();
    return files.isEmpty() ? QDir::homePath() : QFileInfo(files.front()).absolutePath();
}

QString WizardSettings::language() const
{
    return m_settings ? m_settings->value(key(languageKey)).toString() : QString();
}

void WizardSettings::setLanguage(const QString& language)
{
    if (m_settings)
        m_settings->setValue(key(languageKey), language);
}

bool WizardSettings::isPreviewSkippedForVolatile() const
{
    return m_settings && m_settings->value(key(skipPreviewKey)).toBool();
}

void WizardSettings::setPreviewSkippedForVolatile(bool isSkipped)
{
    if (m_settings)
        m_settings->setValue(key(skipPreviewKey), isSkipped);
}

QByteArray WizardSettings::splitter(const QString& name) const
{
    return m_settings ? m_settings->value(key(splitterKey) + name).toByteArray() : QByteArray();
}

void WizardSettings::setSplitter(const QString& name, const QByteArray& state)
{
    if (m_settings)
        m_settings->setValue(key(splitterKey) + name, state);
}

} // namespace axiscomp::ui
