// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/file_filters.h"
#include "ui/text/translated_text.h"
#include "ui/text/value_text.h"

#include "core/formats/table_format.h"

#include <QCoreApplication>
#include <QStringList>

namespace axiscomp::ui {

namespace {

QStringList patternsOf(const FormatFacts& facts)
{
    QStringList patterns;
    for (const std::string_view extension : facts.extensions)
        patterns += u'*' + qString(extension);
    return patterns;
}

/// Round brackets would end the name of an entry.
QString entry(QString name, const QStringList& patterns)
{
    name.replace(u'(', u'[').replace(u')', u']');
    return QStringLiteral("%1 (%2)").arg(name, patterns.join(u' '));
}

} // namespace

QString openFilter()
{
    QStringList all;
    QStringList entries;
    for (const TableFormat* format : tableFormats()) {
        if (!format->read)
            continue;
        const QStringList patterns = patternsOf(format->facts);
        entries += entry(formatText(*format), patterns);
        for (const QString& pattern : patterns) {
            if (!all.contains(pattern, Qt::CaseInsensitive))
                all += pattern;
        }
    }
    entries.prepend(entry(QCoreApplication::translate("FileFilter", "Compensation data"), all));
    entries += QCoreApplication::translate("FileFilter", "All files (*)");
    return entries.join(QStringLiteral(";;"));
}

QString saveFilter(const TableFormat& format)
{
    return entry(formatText(format), patternsOf(format.facts));
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
