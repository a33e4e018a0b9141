// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/page/write_flow.h"

#include "ui/controller/wizard_controller.h"
#include "ui/page/preview_panel.h"
#include "ui/page/write_preview.h"

#include <utility>

namespace axiscomp::ui {

WriteFlow::WriteFlow(WizardController& controller, PreviewPanel& panel, QObject* parent)
    : QObject(parent)
    , m_controller(controller)
    , m_panel(panel)
{
    connect(&controller, &WizardController::planReady, this, &WriteFlow::take);
    connect(&controller, &WizardController::outcomeChanged, this, [this] {
        if (m_controller.isOutcomeAnError())
            m_isPlanning = false;
    });
    connect(&controller, &WizardController::currentAxisChanged, this, [this] {
        m_choice.reset();
        back();
    });
    connect(&controller, &WizardController::selectedTableChanged, this, [this] {
        if (fileTable() != m_table)
            back();
    });
    connect(&controller.setup(), &SetupModel::fieldChanged, this, &WriteFlow::back);
    connect(&controller, &WizardController::actionsChanged, this, [this] {
        if (!m_controller.action(m_action).isEnabled && !m_controller.busy().isBusy)
            back();
    });
    connect(&controller, &WizardController::statusChanged, this, &WriteFlow::restoreChosen);
    connect(&controller, &WizardController::busyChanged, this, &WriteFlow::restoreChosen);
    connect(&panel.writePreview(), &WritePreview::confirmed, this, &WriteFlow::confirm);
    connect(&panel.writePreview(), &WritePreview::backRequested, this, &WriteFlow::back);
}

void WriteFlow::proceed(std::vector<Text> doubts)
{
    if (isPreviewing()) {
        confirm();
        return;
    }
    begin(Action::Write, std::move(doubts));
}

void WriteFlow::proceedToDelete()
{
    back();
    begin(Action::DeleteTable);
}

void WriteFlow::proceedToRestore()
{
    back();
    begin(Action::RestorePrevious);
}

void WriteFlow::restore(const BackupChoice& choice, const AxisEntry& target)
{
    back();
    m_choice = choice;
    m_target = target;
    restoreChosen();
}

void WriteFlow::restoreChosen()
{
    const auto& status = m_controller.status();
    if (!m_choice || !status || status->axis.index != m_choice->axis || m_controller.busy().isBusy
        || !m_controller.isCurrentDrive(m_target))
        return;
    const BackupChoice choice = *std::exchange(m_choice, std::nullopt);
    m_action = Action::RestoreBackup;
    m_isPlanning = true;
    m_table = fileTable();
    m_controller.planRestoration(choice); // or says why not
}

void WriteFlow::begin(Action action, std::vector<Text> doubts)
{
    if (!m_controller.action(action).isEnabled)
        return;
    m_action = action;
    m_isPlanning = true;
    m_table = fileTable();
    if (action == Action::DeleteTable)
        m_controller.planDeletion();
    else if (action == Action::RestorePrevious)
        m_controller.planRestoration();
    else
        m_controller.planWrite(std::move(doubts));
}

void WriteFlow::back()
{
    m_isPlanning = false;
    showPreview(false);
}

std::shared_ptr<const CompensationTable> WriteFlow::fileTable() const
{
    return m_controller.setup().edited().table.fileTable ? m_controller.selectedTable() : nullptr;
}

bool WriteFlow::isPreviewing() const
{
    return m_panel.isWritePreviewShown();
}

void WriteFlow::take()
{
    const auto& plan = m_controller.plan();
    if (!m_isPlanning || !plan)
        return;
    m_isPlanning = false;
    const bool isVolatile =
        plan->flashOperations == 0 && plan->after.persistency == Persistency::Volatile;
    const bool hasRemarks =
        !plan->warnings.empty() || !plan->unitRemarks.empty() || !plan->largeCorrections.empty();
    if (m_action == Action::Write && isVolatile && !hasRemarks
        && m_panel.writePreview().isSkippedForVolatile())
        m_controller.write();
    else
        present();
}

/// The preview takes the focus. Where that takes what is being typed, the plan is of other fields.
void WriteFlow::present()
{
    showPreview(true);
    if (!m_controller.plan())
        m_controller.refuseOldPlan();
}

void WriteFlow::confirm()
{
    if (!isPreviewing() || !m_panel.writePreview().isAccepted())
        return;
    showPreview(false);
    m_controller.write(true);
}

void WriteFlow::showPreview(bool isShown)
{
    if (isShown == isPreviewing())
        return;
    m_panel.showWritePreview(isShown);
    if (isPreviewing() == isShown) // not put away again meanwhile
        Q_EMIT previewingChanged(isShown);
}

} // namespace axiscomp::ui
