// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/comparison_figures_model.h"

#include "ui/record/comparison_model.h"
#include "ui/record/judgement_cells.h"
#include "ui/style/symbols.h"
#include "ui/text/fine_scale.h"
#include "ui/text/translated_text.h"
#include "ui/text/value_text.h"

namespace axiscomp::ui {

namespace {

Iso230Figure figureOf(int row)
{
    return allIso230Figures()[static_cast<std::size_t>(row)];
}

const axiscomp::Verdict* verdictOf(const Comparison& comparison, int row)
{
    return axiscomp::verdictOf(comparison.verdicts, figureOf(row));
}

/// Of what stands in one row.
int decimalsOf(const Comparison& comparison, int row, const FineUnit& unit)
{
    return verdictDecimals({verdictOf(comparison, row),
                               axiscomp::verdictOf(comparison.verdictsOfAllValues, figureOf(row))},
        unit, FineScale::usualDecimals);
}

} // namespace

ComparisonFiguresModel::ComparisonFiguresModel(const ComparisonModel& comparison, QObject* parent)
    : QAbstractTableModel(parent)
    , m_comparison(comparison)
{
    connect(&comparison, &ComparisonModel::changed, this, &ComparisonFiguresModel::follow);
    follow();
}

void ComparisonFiguresModel::follow()
{
    const auto& comparison = m_comparison.state().comparison;
    const bool isThere = comparison != nullptr;
    const bool hasAllValues = comparison && comparison->hasExcluded();
    if (isThere != m_isThere || hasAllValues != m_hasAllValues) {
        beginResetModel();
        m_isThere = isThere;
        m_hasAllValues = hasAllValues;
        endResetModel();
    } else if (isThere) {
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, columnCount() - 1));
    }
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, columnCount() - 1);
}

void ComparisonFiguresModel::retranslate()
{
    follow();
}

std::optional<double> ComparisonFiguresModel::value(int row, int column) const
{
    const Comparison& comparison = *m_comparison.state().comparison;
    const Iso230Figure figure = figureOf(row);
    const auto& before = comparison.before[figure].value;
    const auto& after = comparison.after[figure].value;
    switch (column) {
    case Before:
        return before;
    case Predicted:
        return comparison.predicted ? (*comparison.predicted)[figure] : std::nullopt;
    case HeldOut:
        return comparison.heldOut && figure == comparison.promised
            ? std::optional(comparison.heldOut->range)
            : std::nullopt;
    case After:
        return after;
    case Change:
        return changeOf(before, after);
    case Limit: {
        const auto* verdict = verdictOf(comparison, row);
        return verdict ? std::optional(verdict->tolerance.value) : std::nullopt;
    }
    case AllBefore:
    case AllAfter:
        return comparison.hasExcluded() ? comparison.ofAllValues(column == AllAfter)[figure].value
                                        : std::nullopt;
    default:
        return std::nullopt;
    }
}

QString ComparisonFiguresModel::text(int row, int column) const
{
    const ComparisonState& state = m_comparison.state();
    if (column == Figure)
        return translated(figureText(figureOf(row)));
    if (column == Verdict) {
        const auto* verdict = verdictOf(*state.comparison, row);
        return verdict ? translated(verdictText(verdict->result)) : QString();
    }
    const auto shown = value(row, column);
    if (!shown)
        return column == Limit ? QString() : QStringLiteral("–");
    const QString digits =
        FineScale(state.unit).text(*shown, decimalsOf(*state.comparison, row, state.unit));
    const bool isMore = column == Change && *shown > 0.0 && !digits.startsWith(u'0');
    return isMore ? u'+' + digits : digits;
}

QString ComparisonFiguresModel::spoken(int row, int column) const
{
    const QString shown = text(row, column);
    if (column == Figure || column == Verdict)
        return shown;
    if (!value(row, column))
        return column == Limit ? tr("no tolerance") : tr("not defined");
    return shown + u' ' + FineScale(m_comparison.state().unit).symbol();
}

/// "accuracy A: before 18.57 µm, predicted 8.35 µm, after 9.10 µm, change -9.47 µm, tolerance 10.00
/// µm, passed"
QString ComparisonFiguresModel::sentence(int row) const
{
    QStringList parts;
    for (const int column :
        {Before, Predicted, HeldOut, After, Change, Limit, AllBefore, AllAfter}) {
        const bool isOfFew = column == HeldOut || column >= Limit;
        if (!isOfFew || value(row, column))
            parts +=
                tr("%1 %2", "column and its value").arg(columnName(column), spoken(row, column));
    }
    if (const QString verdict = text(row, Verdict); !verdict.isEmpty())
        parts += verdict;
    return tr("%1: %2", "figure and its values").arg(text(row, Figure), listText(parts));
}

QString ComparisonFiguresModel::columnName(int column)
{
    switch (column) {
    case Figure:
        return tr("Figure");
    case Before:
        return tr("Before");
    case Predicted:
        return tr("Predicted");
    case HeldOut:
        return tr("Held out");
    case After:
        return tr("After");
    case Change:
        return tr("Change");
    case Limit:
        return tr("Tolerance");
    case AllBefore:
        return tr("Before, all values");
    case AllAfter:
        return tr("After, all values");
    default:
        return tr("Verdict");
    }
}

int ComparisonFiguresModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() || !m_isThere ? 0 : static_cast<int>(iso230FigureCount);
}

int ComparisonFiguresModel::columnCount(const QModelIndex& parent) const
{
    if (parent.isValid())
        return 0;
    return m_hasAllValues ? ColumnCount : AllBefore;
}

QVariant ComparisonFiguresModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid) || !m_comparison.state().comparison)
        return {};
    const int row = index.row();
    const int column = index.column();
    if (role == Qt::DisplayRole)
        return text(row, column);
    if (role == Qt::ToolTipRole)
        return column == Figure ? text(row, column) : sentence(row);
    if (role == Qt::AccessibleTextRole)
        return column == Figure ? sentence(row)
            : column == Verdict ? text(row, column)
                                : columnName(column) + u' ' + spoken(row, column);
    if (role == Qt::TextAlignmentRole && column != Figure && column != Verdict)
        return QVariant::fromValue(Qt::AlignRight | Qt::AlignVCenter);
    if (role == Qt::DecorationRole && column == Verdict)
        if (const auto* verdict = verdictOf(*m_comparison.state().comparison, row))
            return cellIcon(toneOf(verdict->result));
    return {};
}

QVariant ComparisonFiguresModel::headerData(
    int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || section < 0 || section >= columnCount())
        return {};
    if (role == Qt::ToolTipRole && section == HeldOut)
        return tr("What is left at targets that the table was made without: the figure to believe");
    if (role == Qt::TextAlignmentRole && (section == Figure || section == Verdict))
        return QVariant::fromValue(Qt::AlignLeft | Qt::AlignVCenter);
    if (role != Qt::DisplayRole)
        return {};
    // It is the same for all columns.
    return section == Figure && m_isThere ? QStringLiteral("%1 [%2]").arg(
               columnName(section), FineScale(m_comparison.state().unit).symbol())
                                          : columnName(section);
}

} // namespace axiscomp::ui
