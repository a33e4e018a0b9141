// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/axis_operations.h"
#include "ui/controller/action_rules.h"
#include "ui/session/axis_entry.h"

#include <QObject>

#include <memory>
#include <optional>
#include <vector>

namespace axiscomp::ui {

class PreviewPanel;
class WizardController;

/// From the Write button to the write: asks for the plan, shows it where it has to be shown, and
/// has it carried out when it is confirmed. A plan that no longer fits is put away.
class WriteFlow : public QObject {
    Q_OBJECT

public:
    WriteFlow(WizardController& controller, PreviewPanel& panel, QObject* parent = nullptr);

    /// The Write button, or its key: also confirms a list that is shown.
    void proceed(std::vector<Text> doubts = {});
    /// The same for the deletion of the axis's table.
    void proceedToDelete();
    /// The same for going back to the state before the last write.
    void proceedToRestore();
    /// The same for a backup that was chosen, as soon as its axis is the current one and read.
    void restore(const BackupChoice& choice, const AxisEntry& target);
    void back();
    [[nodiscard]] bool isPreviewing() const;

Q_SIGNALS:
    void previewingChanged(bool isPreviewing);

private:
    void begin(Action action, std::vector<Text> doubts = {});
    void take();
    void present();
    void confirm();
    void showPreview(bool isShown);
    void restoreChosen();
    [[nodiscard]] std::shared_ptr<const CompensationTable> fileTable() const;

    WizardController& m_controller;
    PreviewPanel& m_panel;
    Action m_action = Action::Write; ///< what the plan is of
    std::optional<BackupChoice> m_choice; ///< waits for its axis
    AxisEntry m_target; ///< which that is
    bool m_isPlanning = false;
    std::shared_ptr<const CompensationTable> m_table; ///< the file's, when the plan was asked for
};

} // namespace axiscomp::ui
