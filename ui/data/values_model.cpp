// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/data/values_model.h"

#include "core/table/lookup.h"
#include "ui/text/value_text.h"

#include <algorithm>
#include <cstddef>
#include <functional>
#include <vector>

namespace axiscomp::ui {

ValuesModel::ValuesModel(const TableViewModel& shown, QObject* parent)
    : QAbstractTableModel(parent)
    , m_shown(shown)
    , m_table(shown.drawn())
    , m_second(shown.second())
{
    chooseScales();
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
    if (isMap())
        return static_cast<int>(m_table->grid.axes[0].size);
    return m_second ? ColumnCount : OnDrive;
}

QVariant ValuesModel::data(const QModelIndex& index, int role) const
{
    if (!index.isValid())
        return {};
    const GridPoint point = pointOf(index);
    switch (role) {
    case Qt::DisplayRole:
        return !isMap() && index.column() == Position
            ? alignedPositionText(m_table->grid.axes[0], point.i)
            : scaleOf(index).text(static_cast<double>(valueAt(index)));
    case ShareRole:
        return !isMap() && index.column() == Position
            ? QVariant()
            : std::clamp(static_cast<double>(valueAt(index)) / m_shown.scale(), -1.0, 1.0);
    case Qt::TextAlignmentRole:
        return QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
    case Qt::ToolTipRole:
    case Qt::AccessibleTextRole:
        return m_shown.pointText(point);
    default:
        return {};
    }
}

float ValuesModel::valueAt(const QModelIndex& index) const
{
    const GridPoint point = pointOf(index);
    const float value = m_table->values[point.i + point.j * m_table->grid.axes[0].size];
    if (isMap() || index.column() == Value)
        return value;
    const auto onDrive =
        static_cast<float>(Lookup(*m_second).at(m_table->grid.axes[0].position(point.i)));
    return index.column() == OnDrive ? onDrive : value - onDrive;
}

const ValueScale& ValuesModel::scaleOf(const QModelIndex& index) const
{
    if (isMap() || index.column() == Value)
        return m_shown.valueScale();
    return index.column() == OnDrive ? m_scaleOnDrive : m_scaleOfChange;
}

/// The selected table may have fewer decimals than the drive's, or than their difference.
void ValuesModel::chooseScales()
{
    if (!m_second)
        return;
    const bool isSameGrid = m_second->grid.axes == m_table->grid.axes;
    const std::vector<float> onDrive = isSameGrid ? m_second->values : valuesAtPointsOf(*m_table);
    m_scaleOnDrive = m_shown.valueScale().beside(onDrive);
    std::vector<float> change(onDrive.size());
    std::ranges::transform(m_table->values, onDrive, change.begin(), std::minus());
    m_scaleOfChange = m_shown.valueScale().beside(change, differenceNoise(*m_table, *m_second));
}

/// Of the drive's table, at the points of another one.
std::vector<float> ValuesModel::valuesAtPointsOf(const CompensationTable& table) const
{
    const GridAxis& axis = table.grid.axes[0];
    std::vector<double> places(axis.size);
    for (std::size_t i = 0; i < places.size(); ++i)
        places[i] = axis.position(i);
    std::vector<double> values(places.size());
    Lookup(*m_second).atEach(places, values);
    return {values.begin(), values.end()};
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
        return isHorizontal ? positionText(m_table->grid.axes[0], index)
                            : alignedPositionText(m_table->grid.axes[1], index);
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
    const bool isDifference = m_shown.content() == TableContent::Difference || column == Change;
    return withUnit(column == OnDrive ? tr("on the drive")
            : isDifference            ? tr("difference")
                                      : tr("compensation"),
        m_shown.valueScale().unit());
}

void ValuesModel::retranslate()
{
    if (m_table)
        Q_EMIT headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
}

void ValuesModel::follow()
{
    const auto& now = m_shown.drawn();
    const TableViewModel::Table second = m_shown.second();
    const bool hasSameColumns = (second != nullptr) == (m_second != nullptr);
    if (!now || !m_table || now->grid.axes != m_table->grid.axes || !hasSameColumns) {
        beginResetModel();
        m_table = now;
        m_second = second;
        chooseScales();
        endResetModel();
        return;
    }
    // On the same grid selection and scrolling stay where they are.
    m_table = now;
    m_second = second;
    chooseScales();
    retranslate();
    Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
}

} // namespace axiscomp::ui
