// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measuring/plan_steps_model.h"

#include "ui/measuring/plan_text.h"
#include "ui/text/fine_scale.h"
#include "ui/text/translated_text.h"
#include "ui/text/value_text.h"

#include <QFont>

#include <algorithm>

namespace axiscomp::ui {

namespace {

FineUnit unitOfValues(const std::vector<CapturedValue>& values, bool isAngular)
{
    std::vector<std::optional<double>> shown;
    shown.reserve(values.size());
    for (const CapturedValue& value : values)
        shown.emplace_back(value.deviation);
    return fineUnit(shown, isAngular);
}

} // namespace

void PlanStepsModel::show(
    const std::shared_ptr<const MeasuringPlan>& plan, const std::vector<CapturedValue>& values)
{
    const FineUnit unit = unitOfValues(values, plan && plan->isAngular);
    const bool isOtherUnit = unit.factor != m_unit.factor;
    if (plan != m_plan) {
        beginResetModel();
        m_plan = plan;
        m_values = values;
        m_unit = unit;
        endResetModel();
        return;
    }
    const std::size_t before = m_values.size();
    m_values = values;
    m_unit = unit;
    if (!m_plan || m_plan->steps.empty())
        return;
    if (isOtherUnit) {
        Q_EMIT headerDataChanged(Qt::Horizontal, Deviation, Deviation);
        announce(0, m_plan->steps.size() - 1);
    } else {
        const auto [first, last] = std::minmax({before, values.size()});
        announce(first > 0 ? first - 1 : 0, last);
    }
}

void PlanStepsModel::announce(std::size_t first, std::size_t last)
{
    const std::size_t end = m_plan->steps.size() - 1;
    Q_EMIT dataChanged(index(static_cast<int>(std::min(first, end)), 0),
        index(static_cast<int>(std::min(last, end)), ColumnCount - 1));
}

int PlanStepsModel::dueRow() const
{
    return m_plan && m_values.size() < m_plan->steps.size() ? static_cast<int>(m_values.size())
                                                            : -1;
}

void PlanStepsModel::retranslate()
{
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
    if (rowCount() > 0)
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

int PlanStepsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() || !m_plan ? 0 : static_cast<int>(m_plan->steps.size());
}

int PlanStepsModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString PlanStepsModel::text(const QModelIndex& cell) const
{
    const auto row = static_cast<std::size_t>(cell.row());
    const MeasuringStep& step = m_plan->steps[row];
    switch (cell.column()) {
    case Step:
        return cell.row() == dueRow() ? QStringLiteral("▶ %1").arg(step.step)
                                      : QString::number(step.step);
    case Run:
        return (step.direction == axiscomp::Approach::Up ? QStringLiteral("↑ %1")
                                                         : QStringLiteral("↓ %1"))
            .arg(step.run);
    case Target:
        return planPositionText(step.target);
    case Approach:
        return planPositionText(step.approach);
    default:
        return row < m_values.size() ? FineScale(m_unit).text(m_values[row].deviation)
                                     : QStringLiteral("–");
    }
}

/// "step 12, up, target 45.600 mm, due"
QString PlanStepsModel::spoken(const QModelIndex& cell) const
{
    const auto row = static_cast<std::size_t>(cell.row());
    const MeasuringStep& step = m_plan->steps[row];
    const QString words = tr("step %1, %2, target %3")
                              .arg(step.step)
                              .arg(translated(approachText(step.direction)),
                                  planPositionText(step.target, m_plan->isAngular));
    const QString state = cell.row() == dueRow() ? tr("due")
        : row < m_values.size() ? FineScale(m_unit).textWithUnit(m_values[row].deviation)
                                : tr("not taken yet");
    return words + QStringLiteral(", ") + state;
}

QVariant PlanStepsModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    if (role == Qt::DisplayRole)
        return text(index);
    if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole)
        return spoken(index);
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::FontRole && index.row() == dueRow()) {
        QFont font;
        font.setBold(true);
        return font;
    }
    return {};
}

QVariant PlanStepsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    const std::string unit = m_plan && m_plan->isAngular ? "°" : "mm";
    switch (section) {
    case Step:
        return tr("Step");
    case Run:
        return tr("Run");
    case Target:
        return withUnit(tr("Target"), unit);
    case Approach:
        return withUnit(tr("Comes from"), unit);
    default:
        return withUnit(tr("Deviation"), FineScale(m_unit).symbol().toStdString());
    }
}

} // namespace axiscomp::ui
