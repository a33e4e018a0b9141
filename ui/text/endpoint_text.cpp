// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/text/endpoint_text.h"

#include <QRegularExpression>

namespace axiscomp::ui {

QString shownEndpoint(const QString& endpoint)
{
    const QString text = endpoint.trimmed();
    const QString separator = QStringLiteral("://");
    const qsizetype scheme = text.indexOf(separator);
    const qsizetype begin = scheme < 0 ? 0 : scheme + separator.size();
    // A password may hold anything, also an @ or a / of its own: the last @ ends it. Without a
    // scheme it may also be the path of a port.
    const qsizetype at =
        scheme < 0 ? text.left(text.indexOf(u'/')).lastIndexOf(u'@') : text.lastIndexOf(u'@');
    if (at < begin)
        return text;
    return text.left(begin) + text.mid(at + 1);
}

QString completedEndpoint(const QString& typed)
{
    // user:password@ may be before it; a host is a name, an IPv4 address, or an IPv6 one in
    // brackets.
    static const QRegularExpression host(QStringLiteral(
        "\\A(?:[^/?#\\s]*@)?(?:\\[[0-9A-Fa-f:.]+\\]|[A-Za-z0-9][A-Za-z0-9._-]*)(?::[0-9]+)?/?\\z"));
    const QString text = typed.trimmed();
    if (text == QStringLiteral("demo") || !host.match(text).hasMatch())
        return text;
    return QStringLiteral("http://") + text;
}

bool isDemoEndpoint(const QString& endpoint)
{
    return endpoint.trimmed().startsWith(QStringLiteral("demo:"), Qt::CaseInsensitive);
}

} // namespace axiscomp::ui
