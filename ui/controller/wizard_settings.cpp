// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/wizard_settings.h"

#include "ui/text/endpoint_text.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSettings>

#include <algorithm>

namespace axiscomp::ui {

namespace {

constexpr qsizetype longestRecentList = 8;
constexpr qsizetype mostEndpoints = 64;
constexpr qsizetype longestEntry = 4096; // a path
const QLatin1StringView endpointsKey("endpoints");
const QLatin1StringView recentKey("recentFiles");
const QLatin1StringView languageKey("language");
const QLatin1StringView skipPreviewKey("skipPreviewForVolatile");
const QLatin1StringView splitterKey("splitter/");
const QLatin1StringView columnsKey("columnRoles");
constexpr qsizetype mostHeaders = 32;
constexpr qsizetype mostKnownColumns = 256;
const QLatin1StringView headerName("header");
const QLatin1StringView rolesName("roles");

QByteArray columnsEntry(const QStringList& header, const QStringList& roles)
{
    return QJsonDocument(QJsonObject{{headerName, QJsonArray::fromStringList(header)},
                             {rolesName, QJsonArray::fromStringList(roles)}})
        .toJson(QJsonDocument::Compact);
}

QStringList stringsOf(const QJsonValue& list)
{
    QStringList strings;
    for (const QJsonValue& each : list.toArray())
        strings += each.toString();
    return strings;
}

/// A list that anybody may have edited.
QStringList limited(QStringList list, qsizetype most)
{
    list.removeIf([](const QString& entry) { return entry.size() > longestEntry; });
    return list.mid(0, most);
}

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
    if (!m_settings)
        return {};
    return limited(m_settings->value(key(endpointsKey)).toStringList(), mostEndpoints);
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
    if (!m_settings)
        return {};
    return limited(m_settings->value(key(recentKey)).toStringList(), longestRecentList);
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

QStringList WizardSettings::columnRoles(const QStringList& header) const
{
    if (!m_settings || header.isEmpty())
        return {};
    const QStringList entries =
        limited(m_settings->value(key(columnsKey)).toStringList(), mostHeaders);
    for (const QString& entry : entries) {
        const QJsonObject known = QJsonDocument::fromJson(entry.toUtf8()).object();
        QStringList roles = stringsOf(known[rolesName]);
        if (stringsOf(known[headerName]) == header && roles.size() == header.size())
            return roles;
    }
    return {};
}

void WizardSettings::setColumnRoles(const QStringList& header, const QStringList& roles)
{
    if (!m_settings || header.isEmpty() || header.size() > mostKnownColumns)
        return;
    QStringList entries = limited(m_settings->value(key(columnsKey)).toStringList(), mostHeaders);
    entries.removeIf([&](const QString& entry) {
        const QJsonObject known = QJsonDocument::fromJson(entry.toUtf8()).object();
        return stringsOf(known[headerName]) == header;
    });
    const bool isChosen =
        std::ranges::any_of(roles, [](const QString& role) { return !role.isEmpty(); });
    if (isChosen)
        entries.prepend(QString::fromUtf8(columnsEntry(header, roles)));
    m_settings->setValue(key(columnsKey), entries.mid(0, mostHeaders));
}

} // namespace axiscomp::ui
