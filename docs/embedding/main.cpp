// SPDX-License-Identifier: GPL-3.0-or-later
#include "machine_window.h"

#include <QApplication>
#include <QSettings>

int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    QApplication::setOrganizationName(QStringLiteral("example"));
    QApplication::setApplicationName(QStringLiteral("machine-tool"));
    QSettings settings;
    MachineWindow window(settings);
    window.show();
    return QApplication::exec();
}
