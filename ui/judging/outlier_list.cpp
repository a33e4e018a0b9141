// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/judging/outlier_list.h"

#include "ui/record/outliers_model.h"
#include "ui/record/record_model.h"
#include "ui/style/plain_label.h"
#include "ui/style/row_table.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QHeaderView>
#include <QPushButton>
#include <QShortcut>
#include <QTableView>

namespace axiscomp::ui {

OutlierList::OutlierList(RecordModel& record, QWidget* parent)
    : QWidget(parent)
    , m_record(record)
    , m_model(new OutliersModel(record, this))
    , m_ruleLabel(new PlainLabel)
    , m_rule(new QComboBox)
    , m_table(newRowTable("outliers", *m_model))
    , m_excludeAll(new QPushButton)
    , m_exclude(new QPushButton)
    , m_useAgain(new QPushButton)
{
    build();
    connect(m_rule, &QComboBox::activated, this, [this](int index) {
        m_record.setOutlierRule(m_rule->itemData(index).value<OutlierRule>());
    });
    connect(m_excludeAll, &QPushButton::clicked, this, &OutlierList::excludeAll);
    connect(m_exclude, &QPushButton::clicked, this, &OutlierList::exclude);
    connect(m_useAgain, &QPushButton::clicked, this, &OutlierList::useAgain);
    auto* key = new QShortcut(QKeySequence::Delete, m_table);
    key->setContext(Qt::WidgetShortcut);
    connect(key, &QShortcut::activated, this, &OutlierList::exclude);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
        [this](const QModelIndex& current) {
            if (m_isSelecting || !current.isValid())
                return;
            m_selected = m_model->valuesOf(current.row());
            follow();
            Q_EMIT selectionChanged(m_selected);
        });
    connect(&record, &RecordModel::changed, this, &OutlierList::follow);
    connect(&record, &RecordModel::stateChanged, this, &OutlierList::follow);
    retranslate();
}

void OutlierList::build()
{
    m_rule->setObjectName(QStringLiteral("outlierRule"));
    m_ruleLabel->setBuddy(m_rule);
    for (const OutlierRule rule : {OutlierRule::PooledMad, OutlierRule::Grubbs, OutlierRule::None})
        m_rule->addItem(QString(), QVariant::fromValue(rule));
    m_rule->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    m_rule->setMinimumContentsLength(16);
    m_table->setMinimumHeight(5 * m_table->verticalHeader()->defaultSectionSize());
    m_excludeAll->setObjectName(QStringLiteral("excludeProposed"));
    m_exclude->setObjectName(QStringLiteral("excludeSelected"));
    m_useAgain->setObjectName(QStringLiteral("useSelectedAgain"));
    auto* choice = new QHBoxLayout;
    choice->addWidget(m_ruleLabel);
    choice->addWidget(m_rule, 1);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_exclude);
    buttons->addWidget(m_useAgain);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(choice);
    layout->addWidget(m_table, 1);
    layout->addWidget(m_excludeAll);
    layout->addLayout(buttons);
}

void OutlierList::retranslate()
{
    m_ruleLabel->setText(tr("&Outliers by"));
    const QStringList names{tr("pooled MAD, limit 4"), tr("Grubbs, 5 %"), tr("no rule")};
    for (int i = 0; i < names.size(); ++i)
        m_rule->setItemText(i, names[i]);
    m_rule->setAccessibleName(tr("Rule for outliers"));
    m_rule->setToolTip(tr("How values that do not fit the others are found; a proposal, nothing is "
                          "left out by it"));
    m_rule->setAccessibleDescription(m_rule->toolTip());
    m_table->setAccessibleName(tr("Proposed for exclusion, and excluded"));
    m_excludeAll->setText(tr("Exclude All &Proposed"));
    m_excludeAll->setToolTip(tr("Leave out every value that the rule proposes"));
    m_exclude->setText(tr("E&xclude"));
    m_exclude->setToolTip(
        tr("Leave out the value, run or target that is selected in list, plot or table (Del)"));
    m_useAgain->setText(tr("Use A&gain"));
    m_useAgain->setToolTip(tr("Use what is selected again"));
    for (QPushButton* button : {m_excludeAll, m_exclude, m_useAgain})
        button->setAccessibleDescription(button->toolTip());
    m_model->retranslate();
    follow();
}

void OutlierList::select(const std::optional<Exclusion>& values)
{
    m_selected = values;
    m_isSelecting = true;
    const int row = values ? m_model->rowOf(*values) : -1;
    if (row >= 0)
        m_table->setCurrentIndex(m_model->index(row, 0));
    else
        m_table->setCurrentIndex({});
    m_isSelecting = false;
    follow();
}

void OutlierList::follow()
{
    m_rule->setCurrentIndex(m_rule->findData(QVariant::fromValue(m_record.record().outlierRule)));
    const RecordState& state = m_record.state();
    const bool isJudged = state.judgement && m_record.isMeasurementShown();
    m_excludeAll->setEnabled(isJudged && !m_record.isEvaluating()
        && (!state.judgement->outliers.up.flagged.empty()
            || !state.judgement->outliers.down.flagged.empty()));
    const bool isLeftOut = m_selected && m_record.isLeftOut({*m_selected});
    // Of a run or a target some values may be in use still.
    m_exclude->setEnabled(isJudged && m_selected && (!isLeftOut || !isOneValue(*m_selected)));
    m_useAgain->setEnabled(isJudged && isLeftOut);
}

void OutlierList::exclude()
{
    if (m_exclude->isEnabled())
        m_record.exclude({*m_selected});
}

void OutlierList::useAgain()
{
    if (m_selected)
        m_record.useAgain({*m_selected});
}

/// What was proposed for an earlier record is of no use for the next.
void OutlierList::excludeAll()
{
    const RecordState& state = m_record.state();
    if (state.judgement && !m_record.isEvaluating() && m_record.isMeasurementShown())
        m_record.exclude(exclusionsOf(state.judgement->outliers));
}

} // namespace axiscomp::ui
