// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/row_table.h"

#include <QHeaderView>
#include <QTableView>

namespace axiscomp::ui {

QTableView* newRowTable(const char* name, QAbstractItemModel& model)
{
    auto* table = new QTableView;
    table->setObjectName(QLatin1StringView(name));
    table->setModel(&model);
    table->setSelectionBehavior(QAbstractItemView::SelectRows);
    table->setSelectionMode(QAbstractItemView::SingleSelection);
    table->setAlternatingRowColors(true);
    table->setShowGrid(false);
    table->setTabKeyNavigation(false);
    table->setWordWrap(false);
    table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    table->verticalHeader()->hide();
    table->verticalHeader()->setDefaultSectionSize(table->fontMetrics().height() + 6);
    table->horizontalHeader()->setHighlightSections(false);
    table->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    // Of a million rows some are enough to know how wide a column is.
    table->horizontalHeader()->setResizeContentsPrecision(20);
    return table;
}

} // namespace axiscomp::ui
