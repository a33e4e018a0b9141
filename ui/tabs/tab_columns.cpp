// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tabs/tab_columns.h"

#include <QSplitter>
#include <QVBoxLayout>

namespace axiscomp::ui {

void fillWithColumns(QWidget& tab, const QString& name, QWidget* chosen, QWidget* outcome)
{
    auto* columns = new QSplitter(Qt::Horizontal);
    columns->setObjectName(name);
    columns->setChildrenCollapsible(false);
    columns->addWidget(chosen);
    columns->addWidget(outcome);
    columns->setStretchFactor(0, 0);
    columns->setStretchFactor(1, 1);
    columns->setSizes({456, 800});
    auto* layout = new QVBoxLayout(&tab);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(columns);
}

} // namespace axiscomp::ui
