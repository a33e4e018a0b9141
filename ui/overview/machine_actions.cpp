// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/overview/machine_actions.h"

#include "ui/controller/machine_controller.h"
#include "ui/controller/wizard_controller.h"
#include "ui/overview/apply_machine_dialog.h"
#include "ui/overview/save_machine_dialog.h"

#include <QFileInfo>

#include <utility>

namespace axiscomp::ui {

MachineActions::MachineActions(WizardController& controller,
    std::function<const FilePicker&()> picker, std::function<QString()> folder, QWidget& window)
    : m_controller(controller)
    , m_picker(std::move(picker))
    , m_folder(std::move(folder))
    , m_window(window)
{
}

/// That of the machine file that is open, else where the last file was.
QString MachineActions::startFolder() const
{
    const QString path = m_controller.machine().path();
    return path.isEmpty() ? m_folder() : QFileInfo(path).absolutePath();
}

void MachineActions::askAndOpen()
{
    m_picker()(m_window,
        {FileQuestion::Purpose::OpenMachine, tr("Open Machine File"),
            tr("Machine files (*.toml)") + QStringLiteral(";;") + tr("All files (*)"),
            startFolder()},
        [this](const QString& path) { open(path); });
}

void MachineActions::open(const QString& path)
{
    m_controller.machine().open(path);
    Q_EMIT overviewRequested();
}

void MachineActions::planAgain()
{
    m_controller.machine().planAgain();
    Q_EMIT overviewRequested();
}

void MachineActions::close()
{
    m_controller.machine().close();
}

void MachineActions::apply()
{
    if (m_applying) {
        m_applying->raise();
        m_applying->activateWindow();
        return;
    }
    if (m_controller.machine().path().isEmpty() || m_controller.machine().application().isRunning())
        return;
    m_applying = new ApplyMachineDialog(m_controller, &m_window);
    m_applying->open();
}

void MachineActions::save()
{
    (new SaveMachineDialog(m_controller, m_picker(), startFolder(), &m_window))->open();
}

} // namespace axiscomp::ui
