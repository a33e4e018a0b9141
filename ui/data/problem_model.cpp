// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/data/problem_model.h"

#include "ui/style/contrast.h"
#include "ui/style/symbols.h"
#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QGuiApplication>

namespace axiscomp::ui {

namespace {

QString placeText(std::size_t number)
{
    return number == 0 ? QStringLiteral("–") : countText(number);
}

QPixmap symbolOf(Severity severity)
{
    constexpr int size = 14;
    const bool isError = severity == Severity::Error;
    return symbolPixmap(isError ? Symbol::Error : Symbol::Warning,
        frameColor(isError ? Tone::Error : Tone::Warning, QGuiApplication::palette()), size,
        qGuiApp->devicePixelRatio());
}

} // namespace

void ProblemModel::setProblems(const std::vector<Diagnostic>& problems)
{
    beginResetModel();
    m_problems = problems;
    endResetModel();
}

ProblemPlace ProblemModel::place(int row) const
{
    const Diagnostic& problem = m_problems.at(static_cast<std::size_t>(row));
    return {
        problem.line, problem.column, problem.severity == Severity::Error, problemText(problem)};
}

void ProblemModel::retranslate()
{
    Q_EMIT headerDataChanged(Qt::Horizontal, 0, ColumnCount - 1);
    if (!m_problems.empty())
        Q_EMIT dataChanged(index(0, 0), index(rowCount() - 1, ColumnCount - 1));
}

int ProblemModel::rowCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : static_cast<int>(m_problems.size());
}

int ProblemModel::columnCount(const QModelIndex& parent) const
{
    return parent.isValid() ? 0 : ColumnCount;
}

QVariant ProblemModel::data(const QModelIndex& index, int role) const
{
    if (!checkIndex(index, CheckIndexOption::IndexIsValid))
        return {};
    const Diagnostic& problem = m_problems[static_cast<std::size_t>(index.row())];
    if (index.column() == Statement) {
        const bool isText = role == Qt::DisplayRole || role == Qt::ToolTipRole;
        return isText ? problemText(problem) : QVariant();
    }
    if (role == Qt::DisplayRole)
        return placeText(index.column() == Line ? problem.line : problem.column);
    if (index.column() != Line)
        return {};
    if (role == Qt::DecorationRole)
        return symbolOf(problem.severity);
    if (role == Qt::AccessibleTextRole) {
        const bool isError = problem.severity == Severity::Error;
        return (isError ? tr("error, line %1") : tr("warning, line %1"))
            .arg(placeText(problem.line));
    }
    return {};
}

QVariant ProblemModel::headerData(int section, Qt::Orientation orientation, int role) const
{
    if (orientation != Qt::Horizontal || role != Qt::DisplayRole)
        return {};
    switch (section) {
    case Line:
        return tr("Line");
    case FileColumn:
        return tr("Column");
    case Statement:
        return tr("Problem");
    default:
        return {};
    }
}

} // namespace axiscomp::ui
