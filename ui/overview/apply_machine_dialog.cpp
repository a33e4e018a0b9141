// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/overview/apply_machine_dialog.h"

#include "core/machine/machine_texts.h"
#include "ui/controller/machine_application.h"
#include "ui/controller/machine_controller.h"
#include "ui/controller/wizard_controller.h"
#include "ui/dialogs/row_list.h"
#include "ui/dialogs/several_writes_dialog.h"
#include "ui/outcome/outcome_text.h"
#include "ui/overview/drift_text.h"
#include "ui/style/busy_mark.h"
#include "ui/style/tone_label.h"
#include "ui/style/warning_list.h"
#include "ui/text/message_text.h"
#include "ui/text/translated_text.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QEvent>
#include <QFileInfo>
#include <QHeaderView>
#include <QProgressBar>
#include <QPushButton>
#include <QScrollArea>

#include <algorithm>

namespace axiscomp::ui {

namespace {

constexpr int applyingSteps = 1000;
enum ApplyColumn { AxisOfDrive, HeldNow, AsInFile, ApplyColumnCount };

} // namespace

ApplyMachineDialog::ApplyMachineDialog(WizardController& controller, QWidget* parent)
    : QDialog(parent)
    , m_controller(controller)
    , m_machine(controller.machine())
    , m_introduction(wrappedLabel("applyIntroduction"))
    , m_activates(new QCheckBox)
    , m_allowsMissing(new QCheckBox)
    , m_rows(new RowList("applyRows", ApplyColumnCount))
    , m_warnings(new WarningList)
    , m_remarks(wrappedLabel("applyRemarks"))
    , m_busy(new BusyMark)
    , m_reason(wrappedLabel("applyReason"))
    , m_progress(new QProgressBar)
    , m_apply(new QPushButton)
    , m_close(new QPushButton)
{
    setObjectName(QStringLiteral("applyMachineDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    connect(m_activates, &QCheckBox::toggled, &m_machine, &MachineController::setActivates);
    connect(m_allowsMissing, &QCheckBox::toggled, this, &ApplyMachineDialog::refresh);
    connect(m_apply, &QPushButton::clicked, this, &ApplyMachineDialog::apply);
    connect(m_close, &QPushButton::clicked, this, &ApplyMachineDialog::reject);
    for (const auto changed : {&MachineController::fileChanged, &MachineController::driftChanged})
        connect(&m_machine, changed, this, &ApplyMachineDialog::refresh);
    connect(&controller, &WizardController::busyChanged, this, &ApplyMachineDialog::refresh);
    const MachineApplication* application = &m_machine.application();
    connect(application, &MachineApplication::progressed, this, &ApplyMachineDialog::refresh);
    connect(application, &MachineApplication::ended, this, &ApplyMachineDialog::end);
    retranslate();
    m_machine.planAgain();
}

/// Without the dialog activations are only compared.
ApplyMachineDialog::~ApplyMachineDialog()
{
    m_machine.disconnect(this);
    m_machine.setActivates(false);
}

void ApplyMachineDialog::build()
{
    m_activates->setObjectName(QStringLiteral("applyActivates"));
    m_allowsMissing->setObjectName(QStringLiteral("applyAllowsMissing"));
    m_rows->horizontalHeader()->setSectionResizeMode(AxisOfDrive, QHeaderView::ResizeToContents);
    m_warnings->setObjectName(QStringLiteral("applyWarnings"));
    m_progress->setObjectName(QStringLiteral("applyProgress"));
    m_progress->setRange(0, applyingSteps);
    m_apply->setObjectName(QStringLiteral("applyButton"));
    m_apply->setDefault(true);
    m_close->setObjectName(QStringLiteral("closeApplyButton"));
    m_close->setAutoDefault(false);
    // What stands in the way of many axes scrolls; what there is to press stays.
    auto* notes = new QWidget;
    auto* notesLayout = new QVBoxLayout(notes);
    notesLayout->setContentsMargins(0, 0, 8, 0);
    notesLayout->addWidget(m_warnings);
    notesLayout->addWidget(m_remarks);
    notesLayout->addStretch(1);
    auto* scroll = new QScrollArea;
    scroll->setObjectName(QStringLiteral("applyNotes"));
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    scroll->setWidget(notes);
    auto* state = new QHBoxLayout;
    state->addWidget(m_reason, 1);
    state->addWidget(m_busy);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_progress, 1);
    buttons->addStretch(1);
    buttons->addWidget(m_apply);
    buttons->addWidget(m_close);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(10);
    layout->addWidget(m_introduction);
    layout->addWidget(m_activates);
    layout->addWidget(m_allowsMissing);
    layout->addWidget(m_rows, 3);
    layout->addWidget(scroll, 2);
    layout->addLayout(state);
    layout->addLayout(buttons);
    resize(940, 620);
}

void ApplyMachineDialog::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDialog::changeEvent(event);
}

void ApplyMachineDialog::retranslate()
{
    setWindowTitle(tr("Apply Machine File"));
    m_introduction->setText(tr("What %1 says is written to all drives that differ from it, or to "
                               "none. Each axis is backed up first, verified, and put back when "
                               "its write fails.")
                                .arg(QFileInfo(m_machine.path()).fileName()));
    m_activates->setText(tr("Also &switch compensations on and off where the file says so"));
    m_activates->setToolTip(
        tr("Tries to prove each axis that it switches on, and names those of which nothing is "
           "proved; without it the file's “active” is only compared"));
    m_activates->setAccessibleDescription(m_activates->toolTip());
    m_allowsMissing->setText(tr("Leave &out drives that do not answer"));
    m_allowsMissing->setToolTip(tr("Otherwise nothing is written while one does not answer"));
    m_allowsMissing->setAccessibleDescription(m_allowsMissing->toolTip());
    m_rows->setHorizontalHeaderLabels({tr("Axis"), tr("On the drive"), tr("In the machine file")});
    m_rows->setAccessibleName(tr("What will be written"));
    m_progress->setAccessibleName(tr("Progress"));
    m_apply->setText(tr("&Apply"));
    refresh();
}

void ApplyMachineDialog::refresh()
{
    const bool isPlanning = m_state == State::Planning;
    if (isPlanning)
        fillPlans();
    else
        fillOutcomes();
    const auto& drives = m_machine.drives();
    const auto saysActive = [](const MachineAxis& axis) { return axis.isActive.has_value(); };
    m_activates->setVisible(std::ranges::any_of(drives, [&](const MachineDriveState& drive) {
        return std::ranges::any_of(drive.wanted.axes, saysActive);
    }));
    m_activates->setEnabled(isPlanning);
    const bool isMissing = std::ranges::any_of(drives, [](const MachineDriveState& drive) {
        return !drive.isConnected || (drive.look && drive.look->isMissing());
    });
    m_allowsMissing->setVisible(isMissing || m_allowsMissing->isChecked());
    m_allowsMissing->setEnabled(isPlanning);
    m_busy->setBusy(
        isPlanning ? m_machine.isReading() || m_machine.isAsking() : m_state == State::Writing);
    m_progress->setVisible(m_state == State::Writing);
    m_progress->setValue(qRound(m_machine.application().fraction() * applyingSteps));
    showReason();
    showButtons();
}

void ApplyMachineDialog::fillPlans()
{
    QList<QStringList> rows;
    QStringList remarks;
    for (const MachineDriveState& drive : m_machine.drives()) {
        if (!drive.look || !drive.look->plan)
            continue;
        rows += plannedRows(drive);
        for (const AxisPlan& plan : drive.look->plan->axes)
            for (const QString& remark : driftRemarks(plan))
                remarks +=
                    tr("%1: %2", "axis and remark")
                        .arg(axisOfDriveText(qString(drive.look->plan->drive.name), plan.name),
                            remark);
    }
    m_rows->setRows(rows);
    if (const QStringList now = warnings(); now != m_warnings->warnings())
        m_warnings->setWarnings(now);
    m_remarks->setText(remarks.join(u'\n'));
    m_remarks->setVisible(!remarks.isEmpty());
}

/// Axes that nothing happens to are not listed.
QList<QStringList> ApplyMachineDialog::plannedRows(const MachineDriveState& drive) const
{
    QList<QStringList> rows;
    std::vector<AxisEntry> axes;
    std::ranges::copy_if(m_controller.axes(), std::back_inserter(axes),
        [&](const AxisEntry& entry) { return entry.endpoint == drive.endpoint; });
    const auto& plans = drive.look->plan->axes;
    for (std::size_t n = 0; n < plans.size(); ++n) {
        if (!m_machine.isToBeChanged(plans[n]))
            continue;
        AxisPlan plan = plans[n];
        if (!m_machine.activates())
            plan.switches.reset();
        QStringList before;
        QStringList after;
        for (const DriftLine& line : driftLines(plan, drive.wanted.axes[n], axes)) {
            before += tr("%1: %2", "field and value").arg(line.field, line.before);
            after += tr("%1: %2", "field and value").arg(line.field, line.after);
        }
        rows += QStringList{axisOfDriveText(qString(drive.look->plan->drive.name), plan.name),
            before.join(u'\n'), after.join(u'\n')};
    }
    return rows;
}

QStringList ApplyMachineDialog::warnings() const
{
    QStringList warnings;
    const auto add = [&](const MachineDriveState& drive, std::optional<std::size_t> axis,
                         const QString& what) {
        warnings +=
            tr("%1: %2", "drive or axis, and warning").arg(machinePlaceText(drive, axis), what);
    };
    for (const auto& obstacle : m_machine.obstacles(m_allowsMissing->isChecked()))
        add(*obstacle.drive, obstacle.problem.axis, errorText(obstacle.problem.error));
    for (const MachineDriveState& drive : m_machine.drives()) {
        if (!drive.isConnected)
            add(drive, {}, tr("This drive is not among the connections any more."));
        if (!drive.look || !drive.look->plan)
            continue;
        const auto& plans = drive.look->plan->axes;
        for (std::size_t n = 0; n < plans.size(); ++n) {
            AxisPlan noted = plans[n];
            if (noted.problem)
                continue;
            noted.obstacle.reset(); // is there already
            for (const QString& warning : driftWarnings(noted, nullptr))
                add(drive, n, warning);
        }
    }
    return warnings;
}

void ApplyMachineDialog::fillOutcomes()
{
    m_rows->setHorizontalHeaderLabels({tr("Axis"), tr("Outcome"), tr("It holds")});
    m_rows->setAccessibleName(tr("What has become of each axis"));
    QList<QStringList> rows;
    QStringList failures;
    QStringList proofs;
    for (const MachineApplication::Written& written : m_machine.application().drives()) {
        const QString& drive = written.planned.name;
        const auto& plans = written.planned.look->plan->axes;
        for (std::size_t n = 0; n < plans.size(); ++n) {
            const QString name = axisOfDriveText(drive, plans[n].name);
            if (n >= written.outcomes.size()) {
                const QString step = !written.isUnderWay ? tr("not known")
                    : written.step.isEmpty()             ? tr("waits")
                                                         : stepText(written.step);
                rows += QStringList{name, step, QString()};
                continue;
            }
            const AxisOutcome& outcome = written.outcomes[n];
            rows += QStringList{name, translated(outcomeText(outcome)),
                outcome.now ? translated(heldText(*outcome.now)) : tr("not known")};
            if (outcome.problem)
                failures += tr("%1: %2", "axis and problem").arg(name, errorText(*outcome.problem));
            else if (outcome.activation && outcome.activation->proof)
                (outcome.activation->notProved() ? failures : proofs) +=
                    tr("%1: %2", "axis and proof").arg(name, proofText(*outcome.activation));
        }
        if (written.problem)
            failures += tr("%1: %2", "drive and problem").arg(drive, errorText(*written.problem));
    }
    m_rows->setRows(rows);
    if (failures != m_warnings->warnings())
        m_warnings->setWarnings(failures);
    m_remarks->setText(proofs.join(u'\n'));
    m_remarks->setVisible(!proofs.isEmpty());
}

QString ApplyMachineDialog::costText() const
{
    int operations = 0;
    for (const MachineDriveState& drive : m_machine.drives())
        if (drive.look && drive.look->plan)
            for (const AxisPlan& plan : drive.look->plan->axes)
                operations += plan.plan.flashOperations;
    return operations == 0 ? tr("Uses no flash operation.")
                           : tr("Flash operations in total: %1.").arg(operations);
}

void ApplyMachineDialog::showReason()
{
    const MachineApplication& application = m_machine.application();
    if (m_state == State::Writing) {
        m_reason->setTone({});
        m_reason->setText(application.isStopping()
                ? tr("Stopping: each drive ends where it is safe …")
                : tr("Writing …"));
        return;
    }
    if (m_state == State::Ended) {
        const Outcome outcome = application.outcome();
        m_reason->setTone(outcome.isError ? Tone::Error
                : outcome.isWarning       ? Tone::Warning
                                          : Tone::Success);
        m_reason->setText(outcome.text);
        return;
    }
    const bool allowsMissing = m_allowsMissing->isChecked();
    const QString obstacle = m_machine.applyObstacle(allowsMissing);
    const auto& file = m_machine.file();
    const bool isError = (file && file->refusal) || !m_machine.obstacles(allowsMissing).empty();
    m_reason->setTone(isError && !obstacle.isEmpty() ? std::optional(Tone::Error) : std::nullopt);
    m_reason->setText(obstacle.isEmpty() ? costText() : obstacle);
}

void ApplyMachineDialog::showButtons()
{
    const QString obstacle = m_machine.applyObstacle(m_allowsMissing->isChecked());
    m_apply->setEnabled(m_state == State::Planning && obstacle.isEmpty());
    m_apply->setVisible(m_state != State::Ended);
    m_apply->setToolTip(m_apply->isEnabled() ? tr("Write these to the drives now") : obstacle);
    m_apply->setAccessibleDescription(m_apply->toolTip());
    m_close->setEnabled(m_state != State::Writing || !m_machine.application().isStopping());
    sayLeaving(*m_close,
        m_state == State::Writing     ? Leaving::StopsWrites
            : m_state == State::Ended ? Leaving::Closes
                                      : Leaving::Cancels,
        tr("Stops the writes; those under way are rolled back (Esc)"));
}

void ApplyMachineDialog::apply()
{
    if (!m_machine.applyObstacle(m_allowsMissing->isChecked()).isEmpty())
        return;
    m_state = State::Writing;
    m_machine.apply();
}

void ApplyMachineDialog::end()
{
    if (m_state != State::Writing)
        return;
    m_state = State::Ended;
    refresh();
    m_close->setFocus();
}

void ApplyMachineDialog::reject()
{
    if (m_state == State::Writing)
        m_machine.application().stop();
    else
        QDialog::reject();
}

} // namespace axiscomp::ui
