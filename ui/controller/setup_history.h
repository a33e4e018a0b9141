// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/controller/setup_model.h"
#include "ui/data/data_file_model.h"

#include <QObject>
#include <QUndoStack>

#include <vector>

namespace axiscomp::ui {

class TableSelection;

/// What the user has changed in the fields and with the open file, to be undone and done again. The
/// drive is never reached: only what is edited goes back. A field that the user has left alone
/// follows the drive, also when other fields are undone.
class SetupHistory : public QObject {
    Q_OBJECT

public:
    /// Both must outlive the history.
    SetupHistory(SetupModel& setup, TableSelection& tables);
    ~SetupHistory() override;

    /// What undo() and redo() would do, a translated phrase ("Table"); empty: there is nothing.
    [[nodiscard]] QString undoText() const;
    [[nodiscard]] QString redoText() const;
    void undo();
    void redo();
    /// The axis is another one, or the drive has what was edited.
    void clear();

Q_SIGNALS:
    void changed();

private:
    struct State {
        EditedSetup edited;
        OpenedFile file;
    };
    class Step;

    [[nodiscard]] State now() const;
    void note();
    void follow();
    [[nodiscard]] EditedSetup inFileOfNow(const State& state) const;
    void apply(const State& state, const std::vector<Field>& fields, bool withFile);
    [[nodiscard]] QString textOf(int step) const;

    SetupModel& m_setup;
    TableSelection& m_tables;
    QUndoStack m_steps;
    State m_last; ///< before the next change
    bool m_isApplying = false;
};

} // namespace axiscomp::ui
