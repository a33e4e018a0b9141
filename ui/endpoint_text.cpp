// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/endpoint_text.h"

namespace axiscomp::ui {

QString shownEndpoint(const QString& endpoint)
{
    const QString text = endpoint.trimmed();
    const QString separator = QStringLiteral("://");
    const qsizetype scheme = text.indexOf(separator);
    const qsizetype begin = scheme < 0 ? 0 : scheme + separator.size();
    qsizetype end = text.indexOf(u'/', begin);
    if (end < 0)
        end = text.size();
    // A password may hold an @ of its own: the last one ends it.
    const qsizetype at = text.lastIndexOf(u'@', end - 1);
    if (at < begin)
        return text;
    return text.left(begin) + text.mid(at + 1);
}

bool isDemoEndpoint(const QString& endpoint)
{
    return endpoint.trimmed().startsWith(QStringLiteral("demo:"), Qt::CaseInsensitive);
}

} // namespace axiscomp::ui
