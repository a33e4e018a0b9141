// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/status_strip.h"

#include "core/drive/drive_profile.h"
#include "ui/controller/wizard_controller.h"
#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QLabel>
#include <QLocale>
#include <QProgressBar>
#include <QPushButton>
#include <QSignalBlocker>
#include <QToolButton>

#include <algorithm>

namespace axiscomp::ui {

namespace {

constexpr int progressSteps = 1000;
constexpr int stripSymbolSize = 14;

/// In the user's language; a word that the profile does not have is shown as it is.
QString stateText(const AxisInfo& axis)
{
    switch (axis.state) {
    case CompensationState::Disabled:
        return StatusStrip::tr("compensation off");
    case CompensationState::Evaluating:
        return StatusStrip::tr("compensation evaluating");
    case CompensationState::Ramping:
        return StatusStrip::tr("compensation ramping");
    case CompensationState::Active:
        return StatusStrip::tr("compensation active");
    case CompensationState::Error:
        return StatusStrip::tr("compensation error");
    case CompensationState::Unknown:
        break;
    }
    return QString::fromStdString(axis.stateWord);
}

Tone toneOf(const AxisStatus& status)
{
    if (status.isOn())
        return Tone::Success;
    return status.axis.state == CompensationState::Error ? Tone::Error : Tone::Information;
}

QString indexText(const AxisStatus& status)
{
    QStringList indices;
    for (int n = 0; n < status.setup.dimensionality; ++n)
        indices += QLocale().toString(status.indices.at(static_cast<std::size_t>(n)), 'f', 2);
    return indices.join(QStringLiteral(" / "));
}

} // namespace

StatusStrip::StatusStrip(WizardController& controller, QWidget* parent)
    : QWidget(parent)
    , m_controller(controller)
    , m_step(new PlainLabel)
    , m_progress(new QProgressBar)
    , m_cancel(new QPushButton)
    , m_stateSymbol(new PlainLabel)
    , m_state(new PlainLabel)
    , m_live(new PlainLabel)
    , m_log(new QToolButton)
{
    setObjectName(QStringLiteral("statusStrip"));
    m_step->setObjectName(QStringLiteral("busyStep"));
    m_progress->setObjectName(QStringLiteral("busyProgress"));
    m_progress->setRange(0, progressSteps);
    m_progress->setFixedWidth(220);
    m_cancel->setObjectName(QStringLiteral("cancelButton"));
    m_cancel->setAutoDefault(true);
    m_state->setObjectName(QStringLiteral("compensationState"));
    m_live->setObjectName(QStringLiteral("liveValues"));
    m_live->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
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
    layout->addWidget(m_stateSymbol);
    layout->addWidget(m_state);
    layout->addSpacing(8);
    layout->addWidget(m_live);
    connect(m_cancel, &QPushButton::clicked, &controller, &WizardController::cancel);
    connect(m_log, &QToolButton::toggled, this, &StatusStrip::logToggled);
    connect(&controller, &WizardController::busyChanged, this, &StatusStrip::showBusy);
    connect(&controller, &WizardController::liveChanged, this, &StatusStrip::showLive);
    connect(&controller, &WizardController::statusChanged, this, &StatusStrip::showLive);
    connect(&controller, &WizardController::currentAxisChanged, this, &StatusStrip::showLive);
    connect(&controller, &WizardController::drivesChanged, this, &StatusStrip::showLive);
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
    m_state->setToolTip(tr("The state of the compensation of this axis"));
    m_live->setToolTip(tr("Live values of the drive: the compensation output and the table index"));
    showBusy();
    showLive();
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

/// What was read before the connection was lost says nothing about now.
bool StatusStrip::isConnected() const
{
    const int axis = m_controller.currentAxis();
    if (axis < 0)
        return false;
    const QString& endpoint = m_controller.axes().at(static_cast<std::size_t>(axis)).endpoint;
    return std::ranges::any_of(m_controller.drives(), [&](const DriveState& drive) {
        return drive.endpoint == endpoint && drive.connection == DriveState::Connection::Connected;
    });
}

void StatusStrip::showLive()
{
    const auto& status = m_controller.status();
    const bool isLive = status && isConnected();
    m_stateSymbol->setVisible(isLive);
    m_state->setVisible(isLive);
    m_live->setVisible(isLive);
    if (!isLive)
        return;
    const Tone tone = toneOf(*status);
    const QColor color =
        tone == Tone::Information ? mutedTextColor(palette()) : frameColor(tone, palette());
    const Symbol symbol = tone == Tone::Error ? Symbol::Error
        : tone == Tone::Success               ? Symbol::Success
                                              : Symbol::Information;
    m_stateSymbol->setPixmap(symbolPixmap(symbol, color, stripSymbolSize, devicePixelRatioF()));
    m_state->setText(stateText(status->axis));
    m_live->setText(
        tr("Output %1 · Index %2")
            .arg(smallValueText(status->output, status->axis.unit), indexText(*status)));
}

} // namespace axiscomp::ui
