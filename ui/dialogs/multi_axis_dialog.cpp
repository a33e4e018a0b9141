// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/multi_axis_dialog.h"

#include "ui/controller/column_mapping.h"
#include "ui/controller/multi_axis_outcome.h"
#include "ui/dialogs/column_mapping_table.h"
#include "ui/dialogs/multi_axis_plan_view.h"
#include "ui/style/busy_mark.h"
#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QEvent>
#include <QFileInfo>
#include <QLabel>
#include <QProgressBar>
#include <QPushButton>

#include <algorithm>

namespace axiscomp::ui {

namespace {

constexpr int writingSteps = 1000;
enum SourcesEntry { KeepSources, PageSources };

QLabel* wrappedLabel(const char* name)
{
    auto* label = new PlainLabel;
    label->setObjectName(QLatin1StringView(name));
    label->setWordWrap(true);
    return label;
}

} // namespace

MultiAxisDialog::MultiAxisDialog(WizardController& controller, QWidget* parent)
    : QDialog(parent)
    , m_controller(controller)
    , m_axes(controller.usableAxes())
    , m_introduction(wrappedLabel("multiAxisIntroduction"))
    , m_columns(new ColumnMappingTable(controller.dataFile().data, m_axes))
    , m_sourcesLabel(new PlainLabel)
    , m_sources(new QComboBox)
    , m_persistency(wrappedLabel("multiAxisPersistency"))
    , m_planTitle(new PlainLabel)
    , m_plan(new MultiAxisPlanView)
    , m_busy(new BusyMark)
    , m_reason(wrappedLabel("multiAxisReason"))
    , m_progress(new QProgressBar)
    , m_write(new QPushButton)
    , m_close(new QPushButton)
{
    setObjectName(QStringLiteral("multiAxisDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    fillSources();
    follow();
    retranslate();
    plan();
}

MultiAxisDialog::~MultiAxisDialog()
{
    m_controller.dropSeveral();
}

void MultiAxisDialog::build()
{
    m_sources->setObjectName(QStringLiteral("multiAxisSources"));
    m_sources->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_sourcesLabel->setBuddy(m_sources);
    QFont titleFont = m_planTitle->font();
    titleFont.setBold(true);
    m_planTitle->setFont(titleFont);
    m_progress->setObjectName(QStringLiteral("multiAxisProgress"));
    m_progress->setRange(0, writingSteps);
    m_write->setObjectName(QStringLiteral("writeSeveralButton"));
    m_write->setDefault(true);
    m_close->setObjectName(QStringLiteral("closeSeveralButton"));
    m_close->setAutoDefault(false);
    auto* sources = new QHBoxLayout;
    sources->addWidget(m_sourcesLabel);
    sources->addWidget(m_sources, 1);
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
    layout->addWidget(m_introduction);
    layout->addWidget(m_columns);
    layout->addLayout(sources);
    layout->addWidget(m_persistency);
    layout->addWidget(m_planTitle);
    layout->addWidget(m_plan, 1);
    layout->addLayout(state);
    layout->addLayout(buttons);
    resize(940, 620);
}

void MultiAxisDialog::follow()
{
    connect(m_columns, &ColumnMappingTable::choiceChanged, this, &MultiAxisDialog::plan);
    connect(m_sources, &QComboBox::activated, this, &MultiAxisDialog::plan);
    connect(m_plan, &MultiAxisPlanView::acceptedChanged, this, &MultiAxisDialog::showButtons);
    connect(m_write, &QPushButton::clicked, this, &MultiAxisDialog::write);
    connect(m_close, &QPushButton::clicked, this, &MultiAxisDialog::reject);
    connect(&m_controller, &WizardController::multiAxisPlanned, this, &MultiAxisDialog::takePlans);
    connect(&m_controller, &WizardController::multiAxisWritten, this, &MultiAxisDialog::end);
    connect(&m_controller, &WizardController::busyChanged, this, &MultiAxisDialog::showBusy);
    connect(&m_controller, &WizardController::actionsChanged, this, &MultiAxisDialog::planAgain);
    connect(&m_controller, &WizardController::currentAxisChanged, this,
        &MultiAxisDialog::leaveLostDrive);
}

void MultiAxisDialog::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDialog::changeEvent(event);
}

void MultiAxisDialog::retranslate()
{
    setWindowTitle(tr("Write Several Axes"));
    m_introduction->setText(
        tr("Writes columns of %1 to axes of %2, one after the other. All writes are checked before "
           "the first one begins; each one makes a backup and is verified.")
            .arg(QFileInfo(m_controller.dataFile().path).fileName(),
                m_axes.empty() ? QString() : m_axes.front().driveName));
    m_columns->retranslate();
    m_sourcesLabel->setText(tr("&Sources"));
    m_sources->setItemText(KeepSources, tr("Each axis keeps its sources"));
    m_sources->setToolTip(tr("The registers that supply the positions for the tables"));
    m_sources->setAccessibleDescription(m_sources->toolTip());
    if (m_sources->count() > PageSources)
        m_sources->setItemText(PageSources,
            tr("The same for all, as on the page: %1")
                .arg(sourceLines(m_controller.sourcesForSeveral(), m_axes)
                         .join(QStringLiteral(", "))));
    m_persistency->setText(m_controller.setup().edited().persistency == Persistency::Persistent
            ? tr("Persistent, as on the page: all tables are stored in flash.")
            : tr("Volatile, as on the page: a reboot of the drive restores the stored state."));
    m_planTitle->setText(tr("What will be written"));
    m_plan->retranslate();
    m_progress->setAccessibleName(tr("Progress"));
    m_write->setText(tr("&Write All"));
    enter(m_state);
}

void MultiAxisDialog::fillSources()
{
    m_sources->addItem(QString());
    if (m_controller.sourcesForSeveral().empty())
        return;
    m_sources->addItem(QString());
    m_sources->setCurrentIndex(PageSources);
}

std::vector<ColumnForAxis> MultiAxisDialog::chosen() const
{
    std::vector<ColumnForAxis> columns;
    const std::vector<AxisChoice> choices = m_columns->choices();
    for (std::size_t n = 0; n < choices.size(); ++n) {
        if (choices[n])
            columns.push_back({static_cast<int>(n), *choices[n]});
    }
    return columns;
}

QString MultiAxisDialog::obstacle() const
{
    return assignmentObstacle(m_columns->choices(), m_axes);
}

void MultiAxisDialog::plan()
{
    m_controller.dropSeveral();
    m_plan->clear();
    m_asked = chosen();
    const bool isAsked = obstacle().isEmpty()
        && m_controller.planMultiAxis(m_asked, m_sources->currentIndex() == KeepSources);
    enter(isAsked ? State::Planning : State::Choosing);
}

/// A drive that could not be asked, or was not there, may be there again.
void MultiAxisDialog::planAgain()
{
    const auto& plans = m_controller.multiAxisPlans();
    const bool hasFailed = m_state == State::Planned && plans && !*plans;
    if (m_state != State::Choosing && !hasFailed)
        return;
    if (m_controller.action(Action::WriteSeveral).isEnabled && obstacle().isEmpty())
        plan();
    else
        showReason();
}

void MultiAxisDialog::takePlans()
{
    enter(State::Planned);
}

void MultiAxisDialog::write()
{
    if (!m_write->isEnabled())
        return;
    m_state = State::Writing; // showBusy() is called from within
    m_controller.writeMultiAxis(m_plan->isAccepted());
    enter(m_controller.busy().isBusy ? State::Writing : State::Choosing);
}

void MultiAxisDialog::showBusy()
{
    if (m_state != State::Writing)
        return;
    const BusyState& busy = m_controller.busy();
    m_progress->setValue(qRound(busy.fraction * writingSteps));
    showReason();
    showButtons();
}

/// The connection was removed: nobody says any more what becomes of the writes.
void MultiAxisDialog::leaveLostDrive()
{
    const auto now = m_controller.usableAxes();
    const bool isAnother =
        !now.empty() && !m_axes.empty() && now.front().endpoint != m_axes.front().endpoint;
    if (m_controller.currentAxis() < 0 || isAnother)
        QDialog::reject();
}

void MultiAxisDialog::end()
{
    enter(State::Ended);
    m_close->setFocus();
}

void MultiAxisDialog::reject()
{
    if (m_state != State::Writing) {
        QDialog::reject();
        return;
    }
    if (m_controller.busy().canCancel)
        m_controller.cancel();
}

void MultiAxisDialog::enter(State state)
{
    m_state = state;
    const bool isChoosable = state != State::Writing && state != State::Ended;
    m_columns->setChoosable(isChoosable);
    m_sources->setEnabled(isChoosable);
    const auto& plans = m_controller.multiAxisPlans();
    if (state == State::Planned && plans && *plans) {
        m_plan->showPlans(**plans, m_axes);
    }
    m_busy->setBusy(state == State::Planning || state == State::Writing);
    m_progress->setVisible(state == State::Writing);
    showReason();
    showButtons();
}

void MultiAxisDialog::showButtons()
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
    switch (m_state) {
    case State::Writing:
        m_close->setText(tr("S&top"));
        m_close->setToolTip(tr("Stops the writes; the current one is rolled back (Esc)"));
        break;
    case State::Ended:
        m_close->setText(tr("C&lose"));
        m_close->setToolTip(tr("Go back to the page (Esc)"));
        break;
    default:
        m_close->setText(tr("&Cancel"));
        m_close->setToolTip(tr("Change nothing and go back (Esc)"));
        break;
    }
    m_close->setAccessibleDescription(m_close->toolTip());
}

QString MultiAxisDialog::reason() const
{
    const auto& plans = m_controller.multiAxisPlans();
    switch (m_state) {
    case State::Choosing: {
        const QString obstacleText = obstacle();
        return obstacleText.isEmpty() ? m_controller.action(Action::WriteSeveral).reason
                                      : obstacleText;
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

void MultiAxisDialog::showReason()
{
    m_reason->setText(reason());
    const auto& plans = m_controller.multiAxisPlans();
    const bool isError = (m_state == State::Planned && plans && !*plans)
        || (m_state == State::Ended && m_controller.isOutcomeAnError());
    QPalette shown = palette();
    if (isError)
        shown.setColor(QPalette::WindowText, textColor(Tone::Error, shown));
    m_reason->setPalette(shown);
}

} // namespace axiscomp::ui
