// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/several_writes_dialog.h"

#include "ui/dialogs/multi_axis_plan_view.h"
#include "ui/outcome/multi_axis_outcome.h"
#include "ui/style/busy_mark.h"
#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"
#include "ui/style/tone_label.h"

#include <QBoxLayout>
#include <QEvent>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include <algorithm>

namespace axiscomp::ui {

namespace {

constexpr int writingSteps = 1000;

} // namespace

void sayLeaving(QPushButton& button, Leaving leaving, const QString& stopping)
{
    switch (leaving) {
    case Leaving::Cancels:
        button.setText(SeveralWritesDialog::tr("&Cancel"));
        button.setToolTip(SeveralWritesDialog::tr("Change nothing and go back (Esc)"));
        break;
    case Leaving::StopsWrites:
        button.setText(SeveralWritesDialog::tr("S&top"));
        button.setToolTip(stopping);
        break;
    case Leaving::Closes:
        button.setText(SeveralWritesDialog::tr("C&lose"));
        button.setToolTip(SeveralWritesDialog::tr("Go back to the page (Esc)"));
        break;
    }
    button.setAccessibleDescription(button.toolTip());
}

ToneLabel* wrappedLabel(const char* name)
{
    auto* label = new ToneLabel;
    label->setObjectName(QLatin1StringView(name));
    label->setWordWrap(true);
    return label;
}

SeveralWritesDialog::SeveralWritesDialog(
    WizardController& controller, Action action, QWidget* parent)
    : QDialog(parent)
    , m_controller(controller)
    , m_action(action)
    , m_axes(controller.usableAxes())
    , m_introduction(wrappedLabel("multiAxisIntroduction"))
    , m_choices(new QVBoxLayout)
    , m_planTitle(new PlainLabel)
    , m_plan(new MultiAxisPlanView)
    , m_busy(new BusyMark)
    , m_reason(wrappedLabel("multiAxisReason"))
    , m_progress(new QProgressBar)
    , m_write(new QPushButton)
    , m_close(new QPushButton)
{
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    follow();
}

SeveralWritesDialog::~SeveralWritesDialog()
{
    m_controller.dropSeveral();
}

void SeveralWritesDialog::begin()
{
    retranslate();
    plan();
}

QString SeveralWritesDialog::driveName() const
{
    return m_axes.empty() ? QString() : m_axes.front().driveName;
}

void SeveralWritesDialog::build()
{
    QFont titleFont = m_planTitle->font();
    titleFont.setBold(true);
    m_planTitle->setFont(titleFont);
    m_progress->setObjectName(QStringLiteral("multiAxisProgress"));
    m_progress->setRange(0, writingSteps);
    m_write->setObjectName(QStringLiteral("writeSeveralButton"));
    m_write->setDefault(true);
    m_close->setObjectName(QStringLiteral("closeSeveralButton"));
    m_close->setAutoDefault(false);
    auto* state = new QHBoxLayout;
    state->addWidget(m_reason, 1);
    state->addWidget(m_busy);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_progress, 1);
    buttons->addStretch(1);
    buttons->addWidget(m_write);
    buttons->addWidget(m_close);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(10);
    m_choices->setSpacing(layout->spacing());
    layout->addWidget(m_introduction);
    layout->addLayout(m_choices);
    layout->addWidget(m_planTitle);
    layout->addWidget(m_plan, 1);
    layout->addLayout(state);
    layout->addLayout(buttons);
    resize(940, 620);
}

void SeveralWritesDialog::follow()
{
    connect(m_plan, &MultiAxisPlanView::acceptedChanged, this, &SeveralWritesDialog::showButtons);
    connect(m_write, &QPushButton::clicked, this, &SeveralWritesDialog::write);
    connect(m_close, &QPushButton::clicked, this, &SeveralWritesDialog::reject);
    connect(&m_controller, &WizardController::multiAxisPlanned, this,
        [this] { enter(State::Planned); });
    connect(&m_controller, &WizardController::multiAxisWritten, this, &SeveralWritesDialog::end);
    connect(&m_controller, &WizardController::busyChanged, this, &SeveralWritesDialog::showBusy);
    connect(
        &m_controller, &WizardController::actionsChanged, this, &SeveralWritesDialog::planAgain);
    for (const auto changed :
        {&WizardController::currentAxisChanged, &WizardController::axesChanged})
        connect(&m_controller, changed, this, &SeveralWritesDialog::leaveLostDrive);
}

void SeveralWritesDialog::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDialog::changeEvent(event);
}

void SeveralWritesDialog::retranslate()
{
    retranslateChoices();
    m_planTitle->setText(tr("What will be written"));
    m_plan->retranslate();
    m_progress->setAccessibleName(tr("Progress"));
    m_write->setText(tr("&Write All"));
    enter(m_state);
}

void SeveralWritesDialog::plan()
{
    m_controller.dropSeveral();
    m_plan->clear();
    const bool isAsked = obstacle().isEmpty() && ask();
    enter(isAsked ? State::Planning : State::Choosing);
}

/// A drive that could not be asked, or was not there, may be there again.
void SeveralWritesDialog::planAgain()
{
    const auto& plans = m_controller.multiAxisPlans();
    const bool hasFailed = m_state == State::Planned && plans && !*plans;
    if (m_state != State::Choosing && !hasFailed)
        return;
    if (m_controller.action(m_action).isEnabled && obstacle().isEmpty())
        plan();
    else
        showReason();
}

void SeveralWritesDialog::write()
{
    if (!m_write->isEnabled())
        return;
    m_state = State::Writing; // showBusy() is called from within
    m_controller.writeMultiAxis(m_plan->isAccepted());
    enter(m_controller.busy().isBusy ? State::Writing : State::Choosing);
}

void SeveralWritesDialog::showBusy()
{
    if (m_state != State::Writing)
        return;
    const BusyState& busy = m_controller.busy();
    m_progress->setValue(qRound(busy.fraction * writingSteps));
    showReason();
    showButtons();
}

/// The connection was removed, or leads to another drive: nobody says any more what becomes of the
/// writes.
void SeveralWritesDialog::leaveLostDrive()
{
    if (m_axes.empty() || !m_controller.isCurrentDrive(m_axes.front()))
        QDialog::reject();
}

void SeveralWritesDialog::end()
{
    enter(State::Ended);
    m_close->setFocus();
}

void SeveralWritesDialog::reject()
{
    if (m_state != State::Writing) {
        QDialog::reject();
        return;
    }
    if (m_controller.busy().canCancel)
        m_controller.cancel();
}

void SeveralWritesDialog::enter(State state)
{
    m_state = state;
    const bool isChoosable = state != State::Writing && state != State::Ended;
    setChoosable(isChoosable);
    const auto& plans = m_controller.multiAxisPlans();
    if (state == State::Planned && plans && *plans) {
        m_plan->showPlans(**plans, m_axes);
    }
    m_busy->setBusy(state == State::Planning || state == State::Writing
        || (state == State::Choosing && isWaiting()));
    m_progress->setVisible(state == State::Writing);
    showReason();
    showButtons();
}

void SeveralWritesDialog::showButtons()
{
    const auto& plans = m_controller.multiAxisPlans();
    const bool hasChanges = m_state == State::Planned && plans && *plans
        && std::ranges::any_of(
            **plans, [](const WritePlan& plan) { return !plan.changes.empty(); });
    m_write->setEnabled(hasChanges && m_plan->isAccepted());
    m_write->setVisible(m_state != State::Ended);
    m_write->setToolTip(m_write->isEnabled() ? tr("Write these to the drive now")
            : hasChanges                     ? tr("Confirm the large corrections first")
                                             : reason());
    m_write->setAccessibleDescription(m_write->toolTip());
    m_close->setEnabled(m_state != State::Writing || m_controller.busy().canCancel);
    sayLeaving(*m_close,
        m_state == State::Writing     ? Leaving::StopsWrites
            : m_state == State::Ended ? Leaving::Closes
                                      : Leaving::Cancels,
        tr("Stops the writes; the current one is rolled back (Esc)"));
}

QString SeveralWritesDialog::reason() const
{
    const auto& plans = m_controller.multiAxisPlans();
    switch (m_state) {
    case State::Choosing: {
        const QString obstacleText = obstacle();
        return obstacleText.isEmpty() ? m_controller.action(m_action).reason : obstacleText;
    }
    case State::Planning:
        return tr("Asking the drive what would change …");
    case State::Planned:
        if (!plans)
            break;
        if (!*plans)
            return multiAxisErrorText(plans->error(), m_axes);
        if (std::ranges::all_of(
                **plans, [](const WritePlan& plan) { return plan.changes.empty(); }))
            return tr("The drive already has all of this.");
        return MultiAxisPlanView::costText(**plans);
    case State::Writing:
        return m_controller.busy().step;
    case State::Ended:
        return m_controller.outcome();
    }
    return {};
}

bool SeveralWritesDialog::isError() const
{
    const auto& plans = m_controller.multiAxisPlans();
    return (m_state == State::Choosing && isObstacleAnError())
        || (m_state == State::Planned && plans && !*plans)
        || (m_state == State::Ended && m_controller.isOutcomeAnError());
}

void SeveralWritesDialog::showReason()
{
    m_reason->setText(reason());
    m_reason->setTone(isError() ? std::optional(Tone::Error) : std::nullopt);
}

} // namespace axiscomp::ui
