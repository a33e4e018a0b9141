// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/controller_combo.h"

#include "ui/text/message_text.h"

#include <QSignalBlocker>

namespace axiscomp::ui {

namespace {

/// The name of the company is enough here; what stands in brackets is not.
QString controllerText(const TableFormat& format)
{
    const std::string_view name = format.facts.controller;
    return QString::fromUtf8(name.data(), static_cast<qsizetype>(name.size()))
        .section(QStringLiteral(" ("), 0, 0);
}

QVariant dataOf(const TableFormat* format)
{
    return QVariant::fromValue(static_cast<const void*>(format));
}

} // namespace

ControllerCombo::ControllerCombo(QWidget* parent)
    : QComboBox(parent)
    , m_job([this](const Result<CompensationTable>& applied) { take(applied); })
{
    setObjectName(QStringLiteral("appliedBy"));
    fill();
    connect(this, &QComboBox::currentIndexChanged, this, &ControllerCombo::compute);
    retranslate();
}

const TableFormat* ControllerCombo::format() const
{
    return static_cast<const TableFormat*>(currentData().value<const void*>());
}

/// A controller that cannot have the table is not offered.
void ControllerCombo::fill()
{
    const QSignalBlocker blocker(this);
    const QVariant before = currentData();
    clear();
    addItem(QString(), dataOf(nullptr));
    if (m_table) {
        for (const TableFormat* format : controllersFor(m_table->grid.dimensions()))
            addItem(QString(), dataOf(format));
    }
    setCurrentIndex(std::max(findData(before), 0));
    setEnabled(m_table != nullptr);
    retranslate();
}

void ControllerCombo::retranslate()
{
    for (int i = 0; i < count(); ++i) {
        const auto* format = static_cast<const TableFormat*>(itemData(i).value<const void*>());
        setItemText(i,
            format ? tr("As applied by %1").arg(controllerText(*format)) : tr("As on the drive"));
    }
    setToolTip(tr("The table as the drive applies it, or converted to another controller's "
                  "convention: its sign, and its rules beyond the ends"));
    setAccessibleName(tr("Applied by"));
    setAccessibleDescription(toolTip());
}

void ControllerCombo::setTable(const Table& table, const AxisPlace& place)
{
    if (table == m_table && place == m_place)
        return;
    const bool isSameKind =
        table && m_table && table->grid.dimensions() == m_table->grid.dimensions();
    m_table = table;
    m_place = place;
    if (!isSameKind)
        fill();
    compute();
}

void ControllerCombo::compute()
{
    m_job.cancel();
    m_problem.reset();
    m_shown = m_table;
    const TableFormat* const chosen = format();
    if (chosen && m_table)
        m_job.start([table = m_table, place = m_place, chosen](const std::stop_token&) {
            return tableAsAppliedBy(*table, place, chosen->facts);
        });
    Q_EMIT changed();
}

void ControllerCombo::take(const Result<CompensationTable>& applied)
{
    if (applied)
        m_shown = std::make_shared<const CompensationTable>(*applied);
    else
        m_problem = applied.error();
    Q_EMIT changed();
}

QString ControllerCombo::problem() const
{
    return m_problem ? errorText(*m_problem) : QString();
}

} // namespace axiscomp::ui
