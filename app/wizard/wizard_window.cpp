// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/wizard/wizard_window.h"

#include <QBoxLayout>
#include <QCloseEvent>
#include <QScreen>
#include <QSettings>

namespace axiscomp::app {

namespace {

const QLatin1StringView geometryKey("window/geometry");
constexpr QSize usualSize(1280, 800);
constexpr QSize largestFirstSize(1680, 1050);

/// Most of the screen, but not more than the page has use for.
QSize firstSize(const QSize& available)
{
    return (available * 0.85)
        .expandedTo(usualSize)
        .boundedTo(largestFirstSize)
        .boundedTo(available);
}

} // namespace

WizardWindow::WizardWindow(const ui::WizardOptions& options, QSettings& settings)
    : m_settings(settings)
    , m_wizard(new ui::CompensationWizard(options, &settings, this))
{
    setObjectName(QStringLiteral("wizardWindow"));
    setWindowTitle(tr("[*]Axis Compensation Wizard"));
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_wizard);
    connect(m_wizard, &ui::CompensationWizard::titleChanged, this,
        [this](const QString& title, bool isModified) {
            setWindowTitle(title);
            setWindowModified(isModified);
        });
    connect(m_wizard, &ui::CompensationWizard::closeRequested, this, &QWidget::close);
    if (!restoreGeometry(settings.value(geometryKey).toByteArray()))
        resize(firstSize(screen()->availableSize()));
    keepOnScreen();
}

/// A size that no screen has may come from another computer, or from a text of a drive.
void WizardWindow::keepOnScreen()
{
    if (!isMaximized() && !isFullScreen())
        resize(size().boundedTo(screen()->availableSize()));
}

ui::CompensationWizard& WizardWindow::wizard()
{
    return *m_wizard;
}

void WizardWindow::closeEvent(QCloseEvent* event)
{
    if (!m_wizard->mayClose()) {
        event->ignore();
        return;
    }
    keepOnScreen();
    m_settings.setValue(geometryKey, saveGeometry());
    event->accept();
}

} // namespace axiscomp::app
