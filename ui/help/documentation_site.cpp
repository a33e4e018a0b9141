// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/help/documentation_site.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QStandardPaths>

namespace axiscomp::ui {

QString installedDocumentation()
{
    const QString page = QStringLiteral("doc/axiscomp-doc/html/index.html");
    const QString besideProgram = QDir::cleanPath(
        QCoreApplication::applicationDirPath() + QStringLiteral("/../share/") + page);
    return QFile::exists(besideProgram)
        ? besideProgram
        : QStandardPaths::locate(QStandardPaths::GenericDataLocation, page);
}

} // namespace axiscomp::ui
