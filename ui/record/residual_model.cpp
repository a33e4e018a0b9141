// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/residual_model.h"

#include "ui/record/comparison_model.h"
#include "ui/text/fine_scale.h"
#include "ui/text/translated_text.h"
#include "ui/text/value_text.h"

namespace axiscomp::ui {

ResidualModel::ResidualModel(const ComparisonModel& comparison, QObject* parent)
    : QAbstractTableModel(parent)
    , m_comparison(comparison)
{
    connect(&comparison, &ComparisonModel::changed, this, &ResidualModel::follow);
    follow();
}

void ResidualModel::follow()
{
    const auto& comparison = m_comparison.state().comparison;
    const int rows = comparison ? static_cast<int>(comparison->residual.size()) : 0;
    if (rows != m_rows) {
        beginResetModel();
        m_rows = rows;
        endResetModel();
    } else if (rows > 0) {
        Q_EMIT dataChanged(index(0, 0), index(rows - 1, ColumnCount - 1));
    }
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
}

void ResidualModel::retranslate()
{
    follow();
}

QString ResidualModel::text(int row, int column) const
{
    const ComparisonState& state = m_comparison.state();
    const RemainingError& error = state.comparison->residual[static_cast<std::size_t>(row)];
    const FineScale scale(state.unit);
    if (column == Target)
        return numberText(error.position);
    if (column == Left)
        return scale.text(fromDatum(error.value, state.datums.after));
    return error.standardError ? scale.text(*error.standardError) : QStringLiteral("–");
}

/// "at 45.6 mm: -0.31 µm, standard error 0.08 µm"
QString ResidualModel::spoken(int row) const
{
    const ComparisonState& state = m_comparison.state();
    const RemainingError& error = state.comparison->residual[static_cast<std::size_t>(row)];
    const FineScale scale(state.unit);
    const QString place = numberText(error.position) + unitSuffix(state.isAngular ? "°" : "mm");
    const QString left = scale.textWithUnit(fromDatum(error.value, state.datums.after));
    return error.standardError ? tr("at %1: %2, standard error %3")
                                     .arg(place, left, scale.textWithUnit(*error.standardError))
                               : tr("at %1: %2, standard error not defined").arg(place, left);
}

int ResidualModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : m_rows;
}

int ResidualModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant ResidualModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid) || !m_comparison.state().comparison)
        return {};
    if (role == Qt::DisplayRole)
        return text(index.row(), index.column());
    if (role == Qt::ToolTipRole || (role == Qt::AccessibleTextRole && index.column() == Target))
        return spoken(index.row());
    if (role == Qt::TextAlignmentRole)
        return QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
    return {};
}

QVariant ResidualModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    const ComparisonState& state = m_comparison.state();
    if (orientation == Qt::Horizontal && role == Qt::ToolTipRole && section == Left
        && state.datums.after)
        return translated(datumText(*state.datums.after, state.isAngular));
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    if (section == Target)
        return withUnit(tr("Target"), state.isAngular ? "°" : "mm");
    const QString name = section == Left ? tr("Left") : tr("Standard error");
    return QStringLiteral("%1 [%2]").arg(name, FineScale(state.unit).symbol());
}

} // namespace axiscomp::ui
