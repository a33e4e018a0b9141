// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/judgement_table_model.h"

#include "ui/record/record_model.h"
#include "ui/style/symbols.h"
#include "ui/text/value_text.h"

namespace axiscomp::ui {

JudgementTableModel::JudgementTableModel(const RecordModel& record, QObject* parent)
    : QAbstractTableModel(parent)
    , m_record(record)
{
    connect(&record, &RecordModel::stateChanged, this, &JudgementTableModel::follow);
}

const RecordState& JudgementTableModel::state() const
{
    return m_record.state();
}

/// What is selected stays so while only numbers change.
void JudgementTableModel::follow()
{
    const int count = state().judgement ? rows() : 0;
    const int width = state().judgement ? columns() : 0;
    if (count != m_rows || width != m_columns) {
        beginResetModel();
        m_rows = count;
        m_columns = width;
        endResetModel();
        return;
    }
    if (m_rows == 0)
        return;
    Q_EMIT dataChanged(index(0, 0), index(m_rows - 1, m_columns - 1));
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, m_columns - 1);
}

void JudgementTableModel::retranslate()
{
    follow();
}

int JudgementTableModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : m_rows;
}

int JudgementTableModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : m_columns;
}

std::optional<Exclusion> JudgementTableModel::valuesOf(int) const
{
    return std::nullopt;
}

int JudgementTableModel::rowOf(const Exclusion&) const
{
    return -1;
}

bool JudgementTableModel::isNumber(int) const
{
    return false;
}

std::optional<Tone> JudgementTableModel::tone(int, int) const
{
    return std::nullopt;
}

/// "accuracy A, 18.57 µm, tolerance: 10.00 µm, verdict: failed"
QString JudgementTableModel::spoken(int row) const
{
    QStringList parts;
    for (int column = 0; column < m_columns; ++column)
        if (const QString words = text(row, column); !words.isEmpty())
            parts +=
                heading(column).isEmpty() ? words : heading(column) + QStringLiteral(": ") + words;
    return listText(parts);
}

QVariant JudgementTableModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid) || !state().judgement)
        return {};
    const int row = index.row();
    const int column = index.column();
    if (role == Qt::DisplayRole)
        return text(row, column);
    if (role == Qt::ToolTipRole)
        return spoken(row);
    if (role == Qt::AccessibleTextRole)
        return column == 0 ? spoken(row)
                           : heading(column) + QStringLiteral(": ") + text(row, column);
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(
            (isNumber(column) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    if (role == Qt::DecorationRole)
        if (const auto mark = tone(row, column))
            return cellIcon(*mark);
    return {};
}

QVariant JudgementTableModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= m_columns)
        return {};
    if (role == Qt::DisplayRole)
        return heading(section);
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(
            (isNumber(section) ? Qt::AlignRight : Qt::AlignLeft) | Qt::AlignVCenter);
    return {};
}

} // namespace axiscomp::ui
