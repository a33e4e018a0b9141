// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/multi_axis_plan_view.h"

#include "ui/data/column_mapping.h"
#include "ui/dialogs/row_list.h"
#include "ui/session/axis_list.h"
#include "ui/style/plain_label.h"
#include "ui/style/warning_list.h"
#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QHeaderView>
#include <QLabel>

#include <algorithm>
#include <iterator>
#include <limits>

namespace axiscomp::ui {

namespace {

enum PlanColumn { AxisColumn, BeforeColumn, AfterColumn, SlotColumn, PlanColumnCount };

QString persistencyWord(Persistency persistency)
{
    return persistency == Persistency::Persistent ? MultiAxisPlanView::tr("persistent")
                                                  : MultiAxisPlanView::tr("volatile");
}

QString beforeText(const CompensationSetup& setup, std::span<const AxisEntry> axes)
{
    QStringList lines{setup.slot.empty()
            ? MultiAxisPlanView::tr("no table")
            : MultiAxisPlanView::tr("%1D in %2, %3")
                  .arg(QString::number(setup.dimensionality), QString::fromStdString(setup.slot),
                      persistencyWord(setup.persistency))};
    lines += sourceLines(setup.sources, axes);
    return lines.join(u'\n');
}

QString afterText(const WritePlan& plan, std::span<const AxisEntry> axes)
{
    if (plan.changes.empty())
        return MultiAxisPlanView::tr("nothing: the drive already has all of this");
    QStringList lines;
    if (plan.table)
        lines += QStringLiteral("%1: %2").arg(
            QString::fromStdString(plan.table->name), gridText(plan.table->grid));
    else if (plan.after.slot.empty())
        lines += MultiAxisPlanView::tr("no table");
    lines += persistencyWord(plan.after.persistency);
    lines += sourceLines(plan.after.sources, axes);
    return lines.join(u'\n');
}

QString slotText(const WritePlan& plan)
{
    const QString slot = QString::fromStdString(plan.after.slot);
    switch (plan.slotReason) {
    case SlotReason::Empty:
        return MultiAxisPlanView::tr("%1 (empty)").arg(slot);
    case SlotReason::OwnPrevious:
        return MultiAxisPlanView::tr("%1 (held an earlier table of this axis)").arg(slot);
    case SlotReason::OverwriteOwn:
        return MultiAxisPlanView::tr("%1 (will be overwritten)").arg(slot);
    case SlotReason::Named:
    case SlotReason::KeepTable:
        break;
    }
    return slot;
}

} // namespace

QStringList sourceLines(std::span<const DimSource> sources, std::span<const AxisEntry> axes)
{
    QStringList lines;
    for (std::size_t n = 0; n < sources.size(); ++n) {
        const DimSource& source = sources[n];
        if (!source.isSet())
            continue;
        const QString name = source.path.empty()
            ? QStringLiteral("0x%1").arg(source.address, 8, 16, QChar(u'0'))
            : registerName(source.path, axes);
        lines += MultiAxisPlanView::tr("Dim%1: %2").arg(QString::number(n + 1), name);
    }
    return lines;
}

MultiAxisPlanView::MultiAxisPlanView(QWidget* parent)
    : QWidget(parent)
    , m_rows(new RowList("multiAxisPlanRows", PlanColumnCount))
    , m_warnings(new WarningList)
    , m_remarks(new PlainLabel)
    , m_accept(new QCheckBox)
{
    setObjectName(QStringLiteral("multiAxisPlan"));
    m_rows->horizontalHeader()->setSectionResizeMode(AxisColumn, QHeaderView::ResizeToContents);
    m_rows->horizontalHeader()->setSectionResizeMode(SlotColumn, QHeaderView::ResizeToContents);
    m_warnings->setObjectName(QStringLiteral("multiAxisWarnings"));
    m_remarks->setObjectName(QStringLiteral("multiAxisRemarks"));
    m_remarks->setWordWrap(true);
    m_remarks->hide();
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_rows, 1);
    m_accept->setObjectName(QStringLiteral("acceptLargeCorrections"));
    m_accept->hide();
    connect(m_accept, &QCheckBox::toggled, this, &MultiAxisPlanView::acceptedChanged);
    layout->addWidget(m_warnings);
    layout->addWidget(m_remarks);
    layout->addWidget(m_accept);
    retranslate();
}

void MultiAxisPlanView::retranslate()
{
    m_rows->setHorizontalHeaderLabels({tr("Axis"), tr("On the drive"), tr("New"), tr("Slot")});
    m_rows->setAccessibleName(tr("What will be written"));
    m_accept->setText(tr("These large corrections are &right: their unit has been checked"));
}

void MultiAxisPlanView::clear()
{
    m_rows->setRowCount(0);
    m_warnings->setWarnings({});
    m_remarks->hide();
    m_accept->hide();
    m_accept->setChecked(false);
}

bool MultiAxisPlanView::isAccepted() const
{
    return m_accept->isHidden() || m_accept->isChecked();
}

void MultiAxisPlanView::showPlans(std::span<const WritePlan> plans, std::span<const AxisEntry> axes)
{
    clear();
    QStringList warnings;
    QStringList remarks;
    bool hasLarge = false;
    for (const WritePlan& plan : plans) {
        m_rows->addRow({axisNameAmong(axes, plan.axis), beforeText(plan.before, axes),
            afterText(plan, axes), slotText(plan)});
        hasLarge = hasLarge || !plan.largeCorrections.empty();
        const auto ofAxis = [name = axisNameAmong(axes, plan.axis)](const Text& text) {
            return tr("%1: %2", "axis and remark").arg(name, sentenceText(text));
        };
        for (const auto* texts : {&plan.largeCorrections, &plan.warnings})
            std::ranges::transform(*texts, std::back_inserter(warnings), ofAxis);
        std::ranges::transform(plan.unitRemarks, std::back_inserter(remarks), ofAxis);
    }
    m_warnings->setWarnings(warnings);
    m_remarks->setText(remarks.join(u'\n'));
    m_remarks->setVisible(!remarks.isEmpty());
    m_accept->setVisible(hasLarge);
}

QString MultiAxisPlanView::costText(std::span<const WritePlan> plans)
{
    int operations = 0;
    for (const WritePlan& plan : plans)
        operations += plan.flashOperations;
    if (operations == 0)
        return tr("Uses no flash operation.");
    const int left = plans.front().flashBudget.left;
    return left == std::numeric_limits<int>::max()
        ? tr("Flash operations in total: %1.").arg(operations)
        : tr("Flash operations: %1 used, %2 left right after.")
              .arg(operations)
              .arg(left - operations);
}

} // namespace axiscomp::ui
