// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/row_list.h"

#include <QHeaderView>

namespace axiscomp::ui {

RowList::RowList(const char* name, int columns, QWidget* parent) : QTableWidget(parent)
{
    setObjectName(QLatin1StringView(name));
    setColumnCount(columns);
    verticalHeader()->hide();
    setEditTriggers(QAbstractItemView::NoEditTriggers);
    setSelectionMode(QAbstractItemView::NoSelection);
    setFocusPolicy(Qt::TabFocus);
    setTabKeyNavigation(false);
    setWordWrap(true);
    setShowGrid(false);
    setAlternatingRowColors(true);
    horizontalHeader()->setHighlightSections(false);
    horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Stretch);
    verticalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
}

void RowList::addRow(const QStringList& texts)
{
    const int row = rowCount();
    insertRow(row);
    for (qsizetype column = 0; column < texts.size(); ++column)
        setCell(row, static_cast<int>(column), texts[column]);
}

void RowList::setRows(const QList<QStringList>& rows)
{
    setRowCount(static_cast<int>(rows.size()));
    for (int row = 0; row < rowCount(); ++row)
        for (int column = 0; column < columnCount(); ++column)
            setCell(row, column, rows[row].value(column));
}

void RowList::setCell(int row, int column, const QString& text)
{
    QTableWidgetItem* cell = item(row, column);
    if (cell && cell->text() == text)
        return;
    if (!cell) {
        cell = new QTableWidgetItem;
        cell->setTextAlignment(Qt::AlignLeft | Qt::AlignTop);
        setItem(row, column, cell);
    }
    cell->setText(text);
    cell->setToolTip(text);
}

} // namespace axiscomp::ui
