// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/file_filters.h"
#include "ui/text/translated_text.h"
#include "ui/text/value_text.h"

#include "core/formats/table_format.h"
#include "core/metrology/formats/measurement_format.h"

#include <QCoreApplication>
#include <QStringList>

#include <span>

namespace axiscomp::ui {

namespace {

QStringList patternsOf(std::span<const std::string_view> extensions)
{
    QStringList patterns;
    for (const std::string_view extension : extensions)
        patterns += u'*' + qString(extension);
    return patterns;
}

/// Round brackets would end the name of an entry.
QString entry(QString name, const QStringList& patterns)
{
    name.replace(u'(', u'[').replace(u')', u']');
    return QStringLiteral("%1 (%2)").arg(name, patterns.join(u' '));
}

/// One for each format, one for all of them before, one for all files behind.
class FilterEntries {
public:
    void add(const QString& name, std::span<const std::string_view> extensions)
    {
        const QStringList patterns = patternsOf(extensions);
        m_entries += entry(name, patterns);
        for (const QString& pattern : patterns) {
            if (!m_all.contains(pattern, Qt::CaseInsensitive))
                m_all += pattern;
        }
    }
    [[nodiscard]] QString withAll(const QString& name) const
    {
        QStringList entries = m_entries;
        entries.prepend(entry(name, m_all));
        entries += QCoreApplication::translate("FileFilter", "All files (*)");
        return entries.join(QStringLiteral(";;"));
    }

private:
    QStringList m_all;
    QStringList m_entries;
};

} // namespace

QString openFilter()
{
    FilterEntries entries;
    for (const TableFormat* format : tableFormats()) {
        if (format->read)
            entries.add(formatText(*format), format->facts.extensions);
    }
    return entries.withAll(QCoreApplication::translate("FileFilter", "Compensation data"));
}

QString measurementFilter()
{
    FilterEntries entries;
    for (const MeasurementFormat* format : measurementFormats())
        entries.add(measurementFormatText(*format), format->facts.extensions);
    return entries.withAll(QCoreApplication::translate("FileFilter", "Measurements"));
}

QString measurementFormatText(const MeasurementFormat& format)
{
    return qString(format.facts.name) + QStringLiteral(": ") + translated(format.facts.description);
}

QString saveFilter(const TableFormat& format)
{
    return entry(formatText(format), patternsOf(format.facts.extensions));
}

QString formatText(const TableFormat& format)
{
    return qString(format.facts.controller) + QStringLiteral(": ")
        + translated(format.facts.description);
}

QString extensionOf(const TableFormat& format)
{
    return format.facts.extensions.empty() ? QString() : qString(format.facts.extensions.front());
}

} // namespace axiscomp::ui
