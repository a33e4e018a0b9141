// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/controller/action_rules.h"
#include "ui/controller/operation_runner.h"
#include "ui/controller/source_check.h"

#include <QObject>
#include <QTimer>

namespace axiscomp::ui {

/// What can be done now, and why not: looks at everything that decides it, and lets the rules
/// decide.
class WizardActions : public QObject {
    Q_OBJECT

public:
    /// All of these must outlive this.
    WizardActions(const DriveProfile& profile, const DriveList& drives, const AxisState& axis,
        const SetupModel& setup, const SourceCheck& sources, const TableSelection& tables,
        const OperationRunner& runner, LastOutcome& outcome);

    [[nodiscard]] const ActionStates& states() const { return m_states; }
    /// Something of it has changed. While flash wear makes the user wait it calls itself.
    void update();
    /// Who asks for what cannot be done now is told why.
    [[nodiscard]] bool mayStart(Action action);

Q_SIGNALS:
    void changed();

private:
    [[nodiscard]] ActionSnapshot snapshot() const;
    void lookAtDrive(ActionSnapshot& now) const;
    void lookAtUnfinished(ActionSnapshot& now) const;
    void lookAtSetup(ActionSnapshot& now) const;
    void lookAtTables(ActionSnapshot& now) const;

    const DriveProfile& m_profile;
    const DriveList& m_drives;
    const AxisState& m_axis;
    const SetupModel& m_setup;
    const SourceCheck& m_sources;
    const TableSelection& m_tables;
    const OperationRunner& m_runner;
    LastOutcome& m_outcome;
    ActionStates m_states;
    QTimer m_countdown;
};

} // namespace axiscomp::ui
