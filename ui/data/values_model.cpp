// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/data/values_model.h"

#include "ui/text/value_text.h"

namespace axiscomp::ui {

ValuesModel::ValuesModel(const TableViewModel& shown, QObject* parent)
    : QAbstractTableModel(parent)
    , m_shown(shown)
    , m_table(shown.drawn())
{
    connect(&shown, &TableViewModel::changed, this, &ValuesModel::follow);
}

int ValuesModel::rowCount(const QModelIndex& parent) const
{
    if (parent.isValid() || !m_table)
        return 0;
    return static_cast<int>(m_table->grid.axes[isMap() ? 1 : 0].size);
}

int ValuesModel::columnCount(const QModelIndex& parent) const
{
    if (parent.isValid() || !m_table)
        return 0;
    return isMap() ? static_cast<int>(m_table->grid.axes[0].size) : ColumnCount;
}

QVariant ValuesModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const GridPoint point = pointOf(index);
    switch (role) {
    case Qt::DisplayRole:
        return !isMap() && index.column() == Position
            ? positionText(m_table->grid.axes[0], point.i)
            : valueText(m_table->values[point.i + point.j * m_table->grid.axes[0].size]);
    case Qt::TextAlignmentRole:
        return QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
        return m_shown.pointText(point);
    default:
        return {};
    }
}

QVariant ValuesModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    const bool isHorizontal = orientation == Qt::Horizontal;
    if (!m_table || section < 0 || section >= (isHorizontal ? columnCount() : rowCount()))
        return {};
    const auto index = static_cast<std::size_t>(section);
    if (role == Qt::ToolTipRole && (isMap() || !isHorizontal))
        return tr("Index %1").arg(section);
    if (role != Qt::DisplayRole)
        return {};
    if (isMap())
        return positionText(m_table->grid.axes[isHorizontal ? 0 : 1], index);
    return isHorizontal ? columnName(static_cast<Column>(section)) : QString::number(section);
}

GridPoint ValuesModel::pointOf(const QModelIndex& index) const
{
    const auto row = static_cast<std::size_t>(index.row());
    return isMap() ? GridPoint{static_cast<std::size_t>(index.column()), row} : GridPoint{row, 0};
}

QModelIndex ValuesModel::indexOf(const GridPoint& point) const
{
    return isMap() ? index(static_cast<int>(point.j), static_cast<int>(point.i))
                   : index(static_cast<int>(point.i), Value);
}

QString ValuesModel::columnName(Column column) const
{
    if (!m_table)
        return {};
    if (column == Position)
        return withUnit(m_shown.nameOf(0), m_table->grid.axes[0].unit);
    return withUnit(
        m_shown.content() == TableContent::Difference ? tr("difference") : tr("compensation"),
        m_table->unit);
}

void ValuesModel::retranslate()
{
    if (m_table)
        Q_EMIT headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
}

void ValuesModel::follow()
{
    const auto& now = m_shown.drawn();
    if (!now || !m_table || now->grid.axes != m_table->grid.axes) {
        beginResetModel();
        m_table = now;
        endResetModel();
        return;
    }
    // On the same grid selection and scrolling stay where they are.
    m_table = now;
    retranslate();
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

} // namespace axiscomp::ui
