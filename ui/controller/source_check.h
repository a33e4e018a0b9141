// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/controller/drive_list.h"
#include "ui/controller/setup_model.h"

#include <QObject>

#include <array>

namespace axiscomp::ui {

/// Turns what the user enters as a source into a register of the current axis's drive; the setup
/// gets it when the drive has one, and its field's problem otherwise.
class SourceCheck : public QObject {
    Q_OBJECT

public:
    /// All of these must outlive the check.
    SourceCheck(const DriveList& drives, SetupModel& setup, WizardLog& log);

    /// text: path, tam:// URI or hex address; empty: no source. checked() follows, twice when the
    /// drive has to be asked.
    void choose(int dimension, const QString& text);
    [[nodiscard]] bool isBeingChecked(int dimension) const;
    /// The text that was refused is not there any more.
    void forgetProblem(int dimension);
    /// What is being checked is not wanted any more, and problems are over.
    void forget();
    /// Announces the problems in another language.
    void retranslate();

Q_SIGNALS:
    void checked(int dimension);

private:
    struct Pending {
        bool isBeingChecked = false;
        int number = 0; ///< the newest check counts
    };
    [[nodiscard]] Pending& pending(int dimension);
    void accept(int dimension, const DimSource& source);
    void refuse(int dimension, const Wording& problem);

    const DriveList& m_drives;
    SetupModel& m_setup;
    WizardLog& m_log;
    std::array<Pending, 3> m_pending;
};

} // namespace axiscomp::ui
