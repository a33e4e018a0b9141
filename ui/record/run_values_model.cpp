// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/run_values_model.h"

#include "ui/record/record_model.h"
#include "ui/text/fine_scale.h"
#include "ui/text/run_value_text.h"
#include "ui/text/value_text.h"

namespace axiscomp::ui {

RunValuesModel::RunValuesModel(const RecordModel& record, QObject* parent)
    : QAbstractTableModel(parent)
    , m_record(record)
{
    connect(&record, &RecordModel::stateChanged, this, &RunValuesModel::follow);
    follow();
}

/// What is selected stays so while only the use of values changes.
void RunValuesModel::follow()
{
    const RecordState& state = m_record.state();
    const bool hasTargets = state.measurement && state.measurement->hasTargets();
    const int rows = hasTargets ? static_cast<int>(state.measurement->targets.size()) : 0;
    if (rows != m_rows || state.upRunNumbers != m_ups || state.downRunNumbers != m_downs) {
        beginResetModel();
        m_rows = rows;
        m_ups = state.upRunNumbers;
        m_downs = state.downRunNumbers;
        endResetModel();
        return;
    }
    if (m_rows == 0)
        return;
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
}

void RunValuesModel::retranslate()
{
    follow();
}

std::optional<std::pair<Approach, int>> RunValuesModel::runOfColumn(int column) const
{
    if (column <= targetColumn)
        return std::nullopt;
    const auto place = static_cast<std::size_t>(column - targetColumn - 1);
    if (place < m_ups.size())
        return std::pair(Approach::Up, m_ups[place]);
    if (place < m_ups.size() + m_downs.size())
        return std::pair(Approach::Down, m_downs[place - m_ups.size()]);
    return std::nullopt;
}

const RunValue* RunValuesModel::valueOf(const QModelIndex& cell) const
{
    const auto run = runOfColumn(cell.column());
    const auto& measurement = m_record.state().measurement;
    if (!cell.isValid() || !run || !measurement)
        return nullptr;
    return findValue(*measurement, run->first, static_cast<std::size_t>(cell.row()), run->second);
}

std::optional<Exclusion> RunValuesModel::exclusionOf(const QModelIndex& cell) const
{
    if (!cell.isValid())
        return std::nullopt;
    const auto target = static_cast<std::size_t>(cell.row()) + 1;
    if (cell.column() == targetColumn)
        return Exclusion{{}, target, {}};
    const RunValue* value = valueOf(cell);
    return value ? std::optional(Exclusion{value->direction, target, value->run}) : std::nullopt;
}

std::optional<Exclusion> RunValuesModel::runOf(const QModelIndex& cell) const
{
    const auto run = cell.isValid() ? runOfColumn(cell.column()) : std::nullopt;
    return run ? std::optional(Exclusion{run->first, {}, run->second}) : std::nullopt;
}

QString RunValuesModel::text(const QModelIndex& cell) const
{
    if (cell.column() == targetColumn)
        return numberText(
            m_record.state().measurement->targets.at(static_cast<std::size_t>(cell.row())));
    const RunValue* value = valueOf(cell);
    if (!value)
        return QStringLiteral("–");
    const FineScale scale(m_record.state().unit);
    return value->isUsed ? scale.text(value->deviation)
                         : QStringLiteral("✕ ") + scale.text(value->deviation);
}

QString RunValuesModel::spoken(const QModelIndex& cell) const
{
    if (cell.column() == targetColumn)
        return tr("target %1 at %2")
            .arg(countText(static_cast<std::size_t>(cell.row()) + 1), text(cell));
    const RunValue* value = valueOf(cell);
    if (!value)
        return tr("no value");
    return runValueText(*value, FineScale(m_record.state().unit), false);
}

int RunValuesModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : m_rows;
}

int RunValuesModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() || m_rows == 0 ? 0
                                           : 1 + static_cast<int>(m_ups.size() + m_downs.size());
}

QVariant RunValuesModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    if (role == Qt::DisplayRole)
        return text(index);
    if (role == Qt::ToolTipRole || role == Qt::AccessibleTextRole)
        return spoken(index);
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

QVariant RunValuesModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    const auto& measurement = m_record.state().measurement;
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole || !measurement)
        return {};
    if (section == targetColumn)
        return withUnit(tr("Target"), measurement->isAngular ? "°" : "mm");
    const auto run = runOfColumn(section);
    if (!run)
        return {};
    const QString arrow = run->first == Approach::Up ? QStringLiteral("↑") : QStringLiteral("↓");
    return QStringLiteral("%1 %2 [%3]")
        .arg(arrow)
        .arg(run->second)
        .arg(FineScale(m_record.state().unit).symbol());
}

} // namespace axiscomp::ui
