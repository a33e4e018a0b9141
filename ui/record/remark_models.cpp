// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/remark_models.h"

#include "ui/record/record_model.h"
#include "ui/text/message_text.h"
#include "ui/text/translated_text.h"

namespace axiscomp::ui {

ConditionsModel::ConditionsModel(const RecordModel& record, QObject* parent)
    : JudgementTableModel(record, parent)
{
    follow();
}

int ConditionsModel::rows() const
{
    return static_cast<int>(state().judgement->compliance.size());
}

int ConditionsModel::columns() const
{
    return 2;
}

QString ConditionsModel::heading(int column) const
{
    return column == 0 ? tr("Condition of ISO 230-2") : tr("Met?");
}

QString ConditionsModel::text(int row, int column) const
{
    const ComplianceLine& line = state().judgement->compliance[static_cast<std::size_t>(row)];
    if (column == 1)
        return translated(complianceText(line.isMet));
    const QString condition = translated(line.text);
    return line.isAssumed ? tr("%1 (assumption)").arg(condition) : condition;
}

std::optional<Tone> ConditionsModel::tone(int row, int column) const
{
    if (column != 1)
        return std::nullopt;
    const auto& isMet = state().judgement->compliance[static_cast<std::size_t>(row)].isMet;
    return !isMet ? Tone::Information : *isMet ? Tone::Success : Tone::Warning;
}

JudgeWarningsModel::JudgeWarningsModel(const RecordModel& record, QObject* parent)
    : JudgementTableModel(record, parent)
{
    follow();
}

int JudgeWarningsModel::rows() const
{
    return static_cast<int>(state().judgement->warnings.size());
}

int JudgeWarningsModel::columns() const
{
    return 1;
}

QString JudgeWarningsModel::heading(int) const
{
    return tr("Warning");
}

QString JudgeWarningsModel::text(int row, int) const
{
    return sentenceText(state().judgement->warnings[static_cast<std::size_t>(row)].text);
}

std::optional<Tone> JudgeWarningsModel::tone(int, int) const
{
    return Tone::Warning;
}

} // namespace axiscomp::ui
