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
    for (qsizetype column = 0; column < texts.size(); ++column) {
        auto* item = new QTableWidgetItem(texts[column]);
        item->setToolTip(texts[column]);
        item->setTextAlignment(Qt::AlignLeft | Qt::AlignTop);
        setItem(row, static_cast<int>(column), item);
    }
}

} // namespace axiscomp::ui
