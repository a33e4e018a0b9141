// SPDX-License-Identifier: GPL-3.0-or-later
#include "machine_window.h"
#include "ui/compensation_wizard.h"

#include <QAction>
#include <QApplication>
#include <QFile>
#include <QSettings>
#include <QTextStream>
#include <QTimer>

using axiscomp::ui::CompensationWizard;

/// Opens the wizard by the menu entry of the example, and waits for the axes of the demo drive. The
/// argument is a file for the settings.
int main(int argc, char** argv)
{
    QApplication application(argc, argv);
    QSettings settings(QApplication::arguments().value(1), QSettings::IniFormat);
    MachineWindow window(settings);
    window.show();
    window.findChild<QAction*>(QStringLiteral("axisCompensationAction"))->trigger();
    CompensationWizard* wizard = window.axisCompensation();
    if (!wizard || !wizard->isVisible())
        return 1;
    auto& controller = wizard->controller();
    QTextStream out(stdout);
    QObject::connect(&controller, &axiscomp::ui::WizardController::statusChanged, wizard, [&] {
        if (!controller.status())
            return;
        for (const auto& axis : controller.axes())
            out << "axis " << axis.label << '\n';
        out << "icon " << !wizard->window()->windowIcon().isNull() << '\n';
        out << "German " << QFile::exists(QStringLiteral(":/i18n/axiscomp_de.qm")) << '\n';
        out.flush();
        window.close();
        QApplication::exit(window.isVisible() ? 3 : 0);
    });
    QTimer::singleShot(std::chrono::seconds(60), &application, [] { QApplication::exit(2); });
    return QApplication::exec();
}
