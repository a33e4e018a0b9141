// SPDX-License-Identifier: GPL-3.0-or-later
#include "machine_window.h"

#include "core/store/drive_store.h"
#include "drivecomm/capture/serial_instrument.h"
#include "drivecomm/link_factory.h"
#include "drivecomm/profile/profile_loader.h"
#include "ui/compensation_wizard.h"
#include "ui/text/language.h"

#include <QCloseEvent>
#include <QLabel>
#include <QMenuBar>
#include <QVBoxLayout>

using axiscomp::ui::CompensationWizard;

namespace {

/// The wizard knows no kind of drive and no kind of connection: this is where both come in.
axiscomp::ui::WizardOptions wizardOptions()
{
    const axiscomp::DriveProfile& profile = axiscomp::drivecomm::genericProfile();
    axiscomp::ui::WizardOptions options;
    options.profile = &profile;
    options.storeRoot = axiscomp::DriveStore::defaultRoot();
    options.linkFactory =
        [&profile](
            const std::string& address) -> axiscomp::Result<std::unique_ptr<axiscomp::DriveLink>> {
        const auto endpoint = axiscomp::drivecomm::parseEndpoint(address);
        if (!endpoint)
            return axiscomp::fail(endpoint.error());
        return axiscomp::drivecomm::makeLink(*endpoint, profile);
    };
    options.instrumentFactory = axiscomp::drivecomm::openSerialInstrument;
    return options;
}

} // namespace

/// The wizard is a widget like any other; what it needs of the window around it is that it is asked
/// before it closes.
class MachineWindow::AssistantWindow final : public QWidget {
public:
    AssistantWindow(QSettings& settings, QWidget* parent)
        : QWidget(parent, Qt::Window)
        , wizard(new CompensationWizard(wizardOptions(), &settings, this))
    {
        setAttribute(Qt::WA_DeleteOnClose);
        setWindowIcon(axiscomp::ui::wizardIcon());
        resize(1280, 800);
        auto* layout = new QVBoxLayout(this);
        layout->setContentsMargins(0, 0, 0, 0);
        layout->addWidget(wizard);
        connect(wizard, &CompensationWizard::titleChanged, this,
            [this](const QString& title, bool isModified) {
                setWindowTitle(title);
                setWindowModified(isModified);
            });
        connect(wizard, &CompensationWizard::closeRequested, this, &QWidget::close);
    }

    CompensationWizard* const wizard;

protected:
    void closeEvent(QCloseEvent* event) override { event->setAccepted(wizard->mayClose()); }
};

MachineWindow::MachineWindow(QSettings& settings) : m_settings(settings)
{
    setObjectName(QStringLiteral("machineWindow"));
    setWindowTitle(tr("Machine Tool"));
    resize(640, 400);
    auto* text = new QLabel(tr("What this program does with machines goes here."));
    text->setAlignment(Qt::AlignCenter);
    setCentralWidget(text);
    QMenu* assistant = menuBar()->addMenu(tr("&Assistant"));
    QAction* compensation =
        assistant->addAction(axiscomp::ui::wizardIcon(), tr("&Axis Compensation Wizard"));
    compensation->setObjectName(QStringLiteral("axisCompensationAction"));
    connect(compensation, &QAction::triggered, this, &MachineWindow::showAxisCompensation);
}

MachineWindow::~MachineWindow() = default;

void MachineWindow::showAxisCompensation()
{
    if (!m_assistant)
        m_assistant = new AssistantWindow(m_settings, this);
    m_assistant->show();
    m_assistant->raise();
    m_assistant->activateWindow();
}

CompensationWizard* MachineWindow::axisCompensation() const
{
    return m_assistant ? m_assistant->wizard : nullptr;
}

void MachineWindow::closeEvent(QCloseEvent* event)
{
    // A write that is running, or changes that are not written: the wizard asks.
    event->setAccepted(!m_assistant || m_assistant->close());
}
