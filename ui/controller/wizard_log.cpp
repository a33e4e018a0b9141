// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/controller/wizard_log.h"

#include "ui/controller/outcome_text.h"
#include "ui/text/message_text.h"

namespace axiscomp::ui {

void WizardLog::add(LogLine::Kind kind, const Wording& text, const QString& detail)
{
    if (m_lines.size() == capacity)
        m_lines.erase(m_lines.begin());
    m_lines.push_back({++m_count, std::chrono::system_clock::now(), kind, text, detail});
    Q_EMIT added();
}

void WizardLog::add(const Error& error)
{
    add(
        LogLine::Kind::Error, [error] { return errorText(error); }, errorOutcome(error).detail);
}

} // namespace axiscomp::ui
