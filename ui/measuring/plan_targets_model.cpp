// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measuring/plan_targets_model.h"

#include "ui/measuring/plan_text.h"
#include "ui/text/value_text.h"

namespace axiscomp::ui {

void PlanTargetsModel::setPlan(const std::shared_ptr<const MeasuringPlan>& plan)
{
    beginResetModel();
    m_targets = plan ? targetsOf(*plan) : std::vector<double>();
    m_isAngular = plan && plan->isAngular;
    endResetModel();
}

void PlanTargetsModel::retranslate()
{
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
    if (!m_targets.empty())
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

int PlanTargetsModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_targets.size());
}

int PlanTargetsModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QString PlanTargetsModel::text(const QModelIndex& cell) const
{
    const auto row = static_cast<std::size_t>(cell.row());
    if (cell.column() == Number)
        return countText(row + 1);
    if (cell.column() == Target)
        return planPositionText(m_targets[row]);
    return row == 0 ? QStringLiteral("–") : planPositionText(m_targets[row] - m_targets[row - 1]);
}

QVariant PlanTargetsModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    if (role == Qt::DisplayRole)
        return text(index);
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

QVariant PlanTargetsModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    const std::string unit = m_isAngular ? "°" : "mm";
    switch (section) {
    case Number:
        return tr("No.");
    case Target:
        return withUnit(tr("Target"), unit);
    default:
        return withUnit(tr("Distance"), unit);
    }
}

} // namespace axiscomp::ui
