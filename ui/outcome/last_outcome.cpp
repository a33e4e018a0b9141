// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/outcome/last_outcome.h"

#include <utility>

namespace axiscomp::ui {

void LastOutcome::show(const std::function<Outcome()>& make)
{
    const Outcome shown = make();
    m_log.add(
        shown.isError         ? LogLine::Kind::Error
            : shown.isWarning ? LogLine::Kind::Warning
                              : LogLine::Kind::Information,
        [make] { return make().text; }, shown.detail);
    m_make = make;
    m_until = Until::PutAway;
    if (shown.text == m_outcome.text && shown.isError == m_outcome.isError
        && shown.isWarning == m_outcome.isWarning)
        return;
    m_outcome = shown;
    Q_EMIT changed();
}

void LastOutcome::refuse(const Wording& reason)
{
    show([reason] { return Outcome{reason(), true, {}}; });
}

void LastOutcome::showOfChoice(const std::function<Outcome()>& make)
{
    show(make);
    m_until = Until::ChoiceChanged;
}

void LastOutcome::choiceChanged()
{
    dismissAt(Until::ChoiceChanged);
}

void LastOutcome::showOfConnection(const std::function<Outcome()>& make)
{
    show(make);
    m_until = Until::ConnectedAgain;
}

void LastOutcome::connectedAgain()
{
    dismissAt(Until::ConnectedAgain);
}

void LastOutcome::dismissAt(Until moment)
{
    if (m_until == moment)
        dismiss();
}

void LastOutcome::dismiss()
{
    if (!std::exchange(m_make, nullptr))
        return;
    m_outcome = {};
    Q_EMIT changed();
}

void LastOutcome::dismissSuccess()
{
    if (!m_outcome.isError && !m_outcome.isWarning)
        dismiss();
}

void LastOutcome::retranslate()
{
    if (m_make)
        m_outcome = m_make();
}

} // namespace axiscomp::ui
