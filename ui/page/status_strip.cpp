// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/status_strip.h"

#include "ui/controller/wizard_controller.h"
#include "ui/page/state_field.h"
#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"

#include <QBoxLayout>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>

namespace axiscomp::ui {

namespace {

constexpr int progressSteps = 1000;
} // namespace

StatusStrip::StatusStrip(WizardController& controller, QWidget* parent)
    : QWidget(parent)
    , m_controller(controller)
    , m_step(new PlainLabel)
    , m_progress(new QProgressBar)
    , m_cancel(new QPushButton)
    , m_state(new StateField(controller))
    , m_log(new QToolButton)
{
    setObjectName(QStringLiteral("statusStrip"));
    m_step->setObjectName(QStringLiteral("busyStep"));
    m_progress->setObjectName(QStringLiteral("busyProgress"));
    m_progress->setRange(0, progressSteps);
    m_progress->setFixedWidth(220);
    m_cancel->setObjectName(QStringLiteral("cancelButton"));
    m_cancel->setAutoDefault(true);
    m_log->setObjectName(QStringLiteral("logButton"));
    m_log->setIcon(symbolIcon(Symbol::Log));
    m_log->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    m_log->setCheckable(true);
    m_log->setAutoRaise(true);
    m_log->setFocusPolicy(Qt::TabFocus);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(8);
    layout->addWidget(m_log);
    layout->addWidget(m_step);
    layout->addWidget(m_progress);
    layout->addWidget(m_cancel);
    layout->addStretch(1);
    layout->addWidget(m_state);
    connect(m_cancel, &QPushButton::clicked, &controller, &WizardController::cancel);
    connect(m_log, &QToolButton::toggled, this, &StatusStrip::logToggled);
    connect(&controller, &WizardController::busyChanged, this, &StatusStrip::showBusy);
    retranslate();
}

void StatusStrip::retranslate()
{
    m_cancel->setText(tr("&Cancel"));
    m_cancel->setToolTip(tr("Stops the operation; a write is rolled back (Esc)"));
    m_cancel->setAccessibleDescription(m_cancel->toolTip());
    m_progress->setAccessibleName(tr("Progress"));
    m_log->setText(tr("&Log"));
    m_log->setToolTip(tr("Show the log (Ctrl+L)"));
    m_state->retranslate();
    showBusy();
}

void StatusStrip::setLogShown(bool isShown)
{
    const QSignalBlocker blocker(m_log);
    m_log->setChecked(isShown);
}

void StatusStrip::showBusy()
{
    const BusyState& busy = m_controller.busy();
    m_step->setText(busy.step);
    m_progress->setAccessibleDescription(busy.step);
    m_progress->setValue(static_cast<int>(busy.fraction * progressSteps));
    m_step->setVisible(busy.isBusy);
    m_progress->setVisible(busy.isBusy);
    m_cancel->setVisible(busy.isBusy);
    m_cancel->setEnabled(busy.canCancel);
}

} // namespace axiscomp::ui
