// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/slice_row.h"

#include "ui/data/table_view_model.h"
#include "ui/style/plain_label.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QLabel>
#include <QSignalBlocker>
#include <QSlider>

namespace axiscomp::ui {

SliceRow::SliceRow(TableViewModel& shown, QWidget* parent)
    : QWidget(parent)
    , m_shown(shown)
    , m_label(new PlainLabel)
    , m_dimension(new QComboBox)
    , m_index(new QSlider(Qt::Horizontal))
    , m_position(new PlainLabel)
{
    setObjectName(QStringLiteral("sliceRow"));
    m_dimension->setObjectName(QStringLiteral("sliceDimension"));
    m_index->setObjectName(QStringLiteral("sliceIndex"));
    m_position->setObjectName(QStringLiteral("slicePosition"));
    m_label->setBuddy(m_dimension);
    auto* layout = new QHBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_label);
    layout->addWidget(m_dimension);
    layout->addWidget(m_index, 1);
    layout->addWidget(m_position);
    connect(m_dimension, &QComboBox::activated, &m_shown,
        [this](int index) { m_shown.setSlice(index + 1, m_shown.sliceIndex()); });
    connect(m_index, &QSlider::valueChanged, &m_shown,
        [this](int index) { m_shown.setSlice(m_shown.sliceDimension(), index); });
    connect(&m_shown, &TableViewModel::changed, this, &SliceRow::follow);
    retranslate();
    follow();
}

void SliceRow::retranslate()
{
    m_label->setText(tr("Slice at"));
    m_index->setToolTip(tr("The slice that is shown"));
    m_index->setAccessibleName(tr("Slice"));
    m_index->setAccessibleDescription(m_index->toolTip());
    m_dimension->setToolTip(tr("The dimension that is held constant; the other two are shown"));
    m_dimension->setAccessibleName(tr("Sliced dimension"));
    m_dimension->setAccessibleDescription(m_dimension->toolTip());
}

void SliceRow::follow()
{
    setVisible(m_shown.isCut());
    if (!m_shown.isCut())
        return;
    const QSignalBlocker blockIndex(m_index);
    const Grid& grid = m_shown.table()->grid;
    m_dimension->clear();
    for (std::size_t n = 0; n < grid.axes.size(); ++n)
        m_dimension->addItem(dimensionName(grid, n));
    m_dimension->setCurrentIndex(m_shown.sliceDimension() - 1);
    const GridAxis& axis = grid.axes[static_cast<std::size_t>(m_shown.sliceDimension()) - 1];
    m_index->setMaximum(static_cast<int>(axis.size) - 1);
    m_index->setValue(m_shown.sliceIndex());
    const auto at = static_cast<std::size_t>(m_shown.sliceIndex());
    m_position->setText(positionText(axis, at) + unitSuffix(axis.unit));
}

} // namespace axiscomp::ui
