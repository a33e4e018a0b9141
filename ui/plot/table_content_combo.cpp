// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/table_content_combo.h"

#include "ui/data/table_view_model.h"

#include <QStandardItemModel>

namespace axiscomp::ui {

TableContentCombo::TableContentCombo(TableViewModel& shown, QWidget* parent)
    : QComboBox(parent)
    , m_shown(shown)
{
    for (const TableContent content :
        {TableContent::Selected, TableContent::Drive, TableContent::Difference})
        addItem(QString(), static_cast<int>(content));
    setSizeAdjustPolicy(QComboBox::AdjustToContents); // another language has longer words
    retranslate();
    follow();
    connect(this, &QComboBox::activated, &m_shown, [this](int index) {
        m_shown.setContent(static_cast<TableContent>(itemData(index).toInt()));
    });
    connect(&m_shown, &TableViewModel::changed, this, &TableContentCombo::follow);
}

void TableContentCombo::retranslate()
{
    setItemText(0, tr("Selected table"));
    setItemText(1, tr("Table on the drive"));
    setItemText(2, tr("Selected - drive"));
    setToolTip(tr("Which values are shown"));
    setAccessibleName(tr("Values shown"));
    setAccessibleDescription(toolTip());
}

void TableContentCombo::follow()
{
    const auto* items = qobject_cast<QStandardItemModel*>(model());
    for (int i = 0; i < count(); ++i)
        items->item(i)->setEnabled(m_shown.canShow(static_cast<TableContent>(itemData(i).toInt())));
    setCurrentIndex(findData(static_cast<int>(m_shown.content())));
}

} // namespace axiscomp::ui
