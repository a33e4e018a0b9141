// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/outcome/outcome_text.h"
#include "ui/outcome/wizard_log.h"

#include <QObject>

#include <functional>

namespace axiscomp::ui {

/// What the last operation has come to, or why the last wish was refused: one sentence, kept as the
/// function that makes it, because the language may change.
class LastOutcome : public QObject {
    Q_OBJECT

public:
    /// log must outlive this.
    explicit LastOutcome(WizardLog& log) : m_log(log) { }

    /// Empty when there is none.
    [[nodiscard]] const Outcome& get() const { return m_outcome; }
    /// Takes the place of the one before, and goes to the log.
    void show(const std::function<Outcome()>& make);
    /// As show(), an error.
    void refuse(const Wording& reason);
    /// As show(): why what is chosen cannot be done, until something else is chosen.
    void showOfChoice(const std::function<Outcome()>& make);
    void choiceChanged();
    /// As show(): that the drive cannot be asked, until it is connected again. Not for what an
    /// operation has left on the drive.
    void showOfConnection(const std::function<Outcome()>& make);
    void connectedAgain();
    /// There is none any more.
    void dismiss();
    /// What it says of the drive may no longer be so.
    void dismissSuccess();
    /// Makes the sentence anew. changed() is not emitted: one that the user has put away stays
    /// away.
    void retranslate();

Q_SIGNALS:
    void changed();

private:
    enum class Until { PutAway, ChoiceChanged, ConnectedAgain };
    void dismissAt(Until moment);

    WizardLog& m_log;
    Outcome m_outcome;
    std::function<Outcome()> m_make; ///< none: there is no outcome
    Until m_until = Until::PutAway;
};

} // namespace axiscomp::ui
