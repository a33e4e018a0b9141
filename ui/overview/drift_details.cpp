// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/overview/drift_details.h"

#include "ui/dialogs/row_list.h"
#include "ui/overview/drift_text.h"
#include "ui/style/plain_label.h"
#include "ui/style/warning_list.h"
#include "ui/text/message_text.h"

#include <QBoxLayout>
#include <QHeaderView>
#include <QLabel>

namespace axiscomp::ui {

namespace {

enum DriftColumn { FieldColumn, OnDriveColumn, InFileColumn, DriftColumnCount };

} // namespace

DriftDetails::DriftDetails(QWidget* parent)
    : QWidget(parent)
    , m_title(new PlainLabel)
    , m_rows(new RowList("driftRows", DriftColumnCount))
    , m_warnings(new WarningList)
    , m_remarks(new PlainLabel)
{
    setObjectName(QStringLiteral("driftDetails"));
    m_title->setObjectName(QStringLiteral("driftTitle"));
    m_title->setWordWrap(true);
    m_rows->horizontalHeader()->setSectionResizeMode(FieldColumn, QHeaderView::ResizeToContents);
    m_rows->setSizeAdjustPolicy(QAbstractItemView::AdjustToContents);
    m_rows->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Maximum);
    m_warnings->setObjectName(QStringLiteral("driftWarnings"));
    m_remarks->setObjectName(QStringLiteral("driftRemarks"));
    m_remarks->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_title);
    layout->addWidget(m_rows);
    layout->addWidget(m_warnings);
    layout->addWidget(m_remarks);
    retranslate();
    clear();
}

void DriftDetails::retranslate()
{
    m_rows->setHorizontalHeaderLabels({tr("Field"), tr("On the drive"), tr("In the machine file")});
    m_rows->setAccessibleName(tr("How the axis differs from the machine file"));
}

void DriftDetails::clear()
{
    m_rows->setRowCount(0);
    m_warnings->setWarnings({});
    hide();
}

void DriftDetails::showDrift(const QString& name, const AxisDrift& drift, const MachineTable* table,
    std::span<const AxisEntry> axes)
{
    m_title->setText(
        tr("%1: %2", "axis, and how it stands to the machine file").arg(name, driftText(drift)));
    m_rows->setRowCount(0);
    QStringList warnings;
    QStringList remarks;
    if (drift.plan && drift.axis && drift.drive) {
        const MachineAxis& wanted = drift.drive->wanted.axes.at(*drift.axis);
        for (const DriftLine& line : driftLines(*drift.plan, wanted, axes))
            m_rows->addRow({line.field, line.before, line.after});
        warnings = driftWarnings(*drift.plan, table);
        remarks = driftRemarks(*drift.plan);
    } else if (drift.look && drift.look->problem) {
        warnings += errorText(*drift.look->problem);
    }
    m_rows->setVisible(m_rows->rowCount() > 0);
    m_warnings->setWarnings(warnings);
    m_remarks->setText(remarks.join(u'\n'));
    m_remarks->setVisible(!remarks.isEmpty());
    show();
}

} // namespace axiscomp::ui
