// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tabs/run_values_view.h"

#include "ui/record/record_model.h"
#include "ui/record/run_values_model.h"
#include "ui/style/plain_label.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QHeaderView>
#include <QPushButton>
#include <QShortcut>
#include <QTableView>

#include <algorithm>

namespace axiscomp::ui {

RunValuesView::RunValuesView(RecordModel& record, QWidget* parent)
    : QWidget(parent)
    , m_record(record)
    , m_model(new RunValuesModel(record, this))
    , m_summary(new PlainLabel)
    , m_table(new QTableView)
    , m_exclude(new QPushButton)
    , m_excludeRun(new QPushButton)
    , m_useAgain(new QPushButton)
{
    build();
    connect(m_exclude, &QPushButton::clicked, this, &RunValuesView::exclude);
    connect(m_excludeRun, &QPushButton::clicked, this, &RunValuesView::excludeRun);
    connect(m_useAgain, &QPushButton::clicked, this, &RunValuesView::useAgain);
    auto* key = new QShortcut(QKeySequence::Delete, m_table);
    key->setContext(Qt::WidgetShortcut);
    connect(key, &QShortcut::activated, this, &RunValuesView::exclude);
    connect(m_table->selectionModel(), &QItemSelectionModel::selectionChanged, this,
        &RunValuesView::follow);
    connect(m_table->selectionModel(), &QItemSelectionModel::currentChanged, this,
        &RunValuesView::follow);
    connect(m_model, &QAbstractItemModel::modelReset, this, &RunValuesView::fitTargets);
    connect(&record, &RecordModel::stateChanged, this, &RunValuesView::follow);
    retranslate();
}

void RunValuesView::fitTargets()
{
    if (m_model->columnCount() > 0)
        m_table->horizontalHeader()->setSectionResizeMode(
            RunValuesModel::targetColumn, QHeaderView::ResizeToContents);
    follow();
}

void RunValuesView::build()
{
    m_summary->setObjectName(QStringLiteral("runValuesSummary"));
    m_summary->setWordWrap(true);
    m_exclude->setObjectName(QStringLiteral("excludeValues"));
    m_excludeRun->setObjectName(QStringLiteral("excludeRun"));
    m_useAgain->setObjectName(QStringLiteral("useValuesAgain"));
    m_table->setObjectName(QStringLiteral("runValues"));
    m_table->setModel(m_model);
    m_table->setAlternatingRowColors(true);
    m_table->setTabKeyNavigation(false);
    m_table->setWordWrap(false);
    m_table->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_table->verticalHeader()->hide();
    m_table->verticalHeader()->setDefaultSectionSize(m_table->fontMetrics().height() + 6);
    m_table->horizontalHeader()->setHighlightSections(false);
    // Runs are of one width: thousands need not be looked at for it, and of the targets some.
    m_table->horizontalHeader()->setResizeContentsPrecision(20);
    m_table->horizontalHeader()->setDefaultSectionSize(
        m_table->fontMetrics().horizontalAdvance(QStringLiteral("✕ -9999.99")) + 12);
    auto* buttons = new QHBoxLayout;
    for (QPushButton* button : {m_exclude, m_excludeRun, m_useAgain})
        buttons->addWidget(button);
    buttons->addStretch(1);
    auto* layout = new QVBoxLayout(this);
    layout->addWidget(m_summary);
    layout->addWidget(m_table, 1);
    layout->addLayout(buttons);
}

void RunValuesView::retranslate()
{
    m_table->setAccessibleName(tr("Values of all files"));
    m_exclude->setText(tr("&Exclude"));
    m_exclude->setToolTip(tr("Leave the selected values out of every figure and table; in the "
                             "first column, whole targets (Del)"));
    m_excludeRun->setText(tr("Exclude W&hole Run"));
    m_excludeRun->setToolTip(tr("Leave out every value of the run of the current cell"));
    m_useAgain->setText(tr("Use A&gain"));
    m_useAgain->setToolTip(tr("Use the selected values again"));
    for (QPushButton* button : {m_exclude, m_excludeRun, m_useAgain})
        button->setAccessibleDescription(button->toolTip());
    m_model->retranslate();
    follow();
}

bool RunValuesView::isTooMuchSelected() const
{
    qint64 count = 0;
    for (const QItemSelectionRange& range : m_table->selectionModel()->selection())
        count += qint64(range.height()) * range.width();
    return count > mostSelected;
}

std::vector<Exclusion> RunValuesView::selected() const
{
    std::vector<Exclusion> cells;
    if (isTooMuchSelected())
        return cells;
    for (const QModelIndex& cell : m_table->selectionModel()->selectedIndexes())
        if (const auto exclusion = m_model->exclusionOf(cell))
            cells.push_back(*exclusion);
    return cells;
}

void RunValuesView::follow()
{
    const RecordState& state = m_record.state();
    const bool isTooMuch = isTooMuchSelected();
    const std::vector<Exclusion> cells = selected();
    m_exclude->setEnabled(!cells.empty());
    m_excludeRun->setEnabled(m_model->runOf(m_table->currentIndex()).has_value());
    m_useAgain->setEnabled(m_record.isLeftOut(cells));
    if (!state.measurement)
        m_summary->clear();
    else if (isTooMuch)
        m_summary->setText(
            tr("Too many cells are selected: at most %1 in one step. A whole target "
               "is its cell in the first column; \"Exclude Whole Run\" takes a whole run.")
                .arg(mostSelected));
    else
        m_summary->setText(
            tr("Values: %1, excluded: %2 (✕). ↑ up, ↓ down.")
                .arg(countText(state.measurement->values.size()), countText(state.excludedCount)));
}

void RunValuesView::exclude()
{
    // What is asked for about an earlier measurement is of no use for the next.
    if (m_record.isMeasurementShown())
        m_record.exclude(selected());
}

void RunValuesView::excludeRun()
{
    const auto run = m_model->runOf(m_table->currentIndex());
    if (run && m_record.isMeasurementShown())
        m_record.exclude({*run});
}

void RunValuesView::useAgain()
{
    m_record.useAgain(selected());
    m_table->setFocus(); // there is nothing left for the button that had it
}

} // namespace axiscomp::ui
