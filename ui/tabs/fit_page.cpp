// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tabs/fit_page.h"

#include "core/axis/proposals.h"
#include "core/neutral/drive_note.h"
#include "core/table/target_axis.h"
#include "core/write/lookup_side.h"
#include "ui/data/table_view_model.h"
#include "ui/dialogs/setting_fields.h"
#include "ui/plot/fit_plot.h"
#include "ui/plot/table_plot.h"
#include "ui/record/record_model.h"
#include "ui/style/busy_mark.h"
#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"
#include "ui/tabs/fit_form.h"
#include "ui/tabs/fit_results.h"
#include "ui/tabs/next_step.h"
#include "ui/tabs/tab_columns.h"
#include "ui/text/free_key.h"
#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QAbstractButton>
#include <QBoxLayout>
#include <QComboBox>
#include <QPushButton>
#include <QScrollArea>
#include <QSplitter>
#include <QStackedWidget>

#include <algorithm>

namespace axiscomp::ui {

FitPage::FitPage(RecordModel& record, QWidget* parent)
    : QWidget(parent)
    , m_record(record)
    , m_form(new FitForm)
    , m_columnLabel(new PlainLabel)
    , m_column(new QComboBox)
    , m_use(new QPushButton)
    , m_save(new QPushButton)
    , m_nextStep(new NextStep(QStringLiteral("fitHint")))
    , m_busy(new BusyMark)
    , m_title(new PlainLabel)
    , m_pictures(new QStackedWidget)
    , m_nothing(new QWidget)
    , m_plot(new FitPlot)
    , m_results(new FitResults)
{
    setObjectName(QStringLiteral("fitPage"));
    build();
    connectParts();
    retranslate();
    follow();
}

void FitPage::build()
{
    QWidget* const chosen = buildLeft();
    fillWithColumns(*this, QStringLiteral("fitColumns"), chosen, buildRight());
}

QWidget* FitPage::buildLeft()
{
    constexpr int gap = 12;
    m_column->setObjectName(QStringLiteral("fitColumn"));
    m_columnLabel->setBuddy(m_column);
    m_use->setObjectName(QStringLiteral("useAsTable"));
    m_save->setObjectName(QStringLiteral("saveFittedTable"));
    m_save->setIcon(symbolIcon(Symbol::Save));
    auto* scroll = new QScrollArea;
    scroll->setObjectName(QStringLiteral("fitScroll"));
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(m_form);
    auto* left = new QWidget;
    auto* layout = new QVBoxLayout(left);
    layout->setContentsMargins(0, 0, gap, 0);
    layout->addWidget(scroll, 1);
    auto* column = new QHBoxLayout;
    column->addWidget(m_columnLabel);
    column->addWidget(m_column, 1);
    layout->addLayout(column);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_use, 1);
    buttons->addWidget(m_save, 1);
    layout->addLayout(buttons);
    layout->addWidget(m_nextStep);
    return left;
}

QWidget* FitPage::buildRight()
{
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_title->setObjectName(QStringLiteral("fitTitle"));
    auto* heading = new QHBoxLayout;
    heading->addWidget(m_title, 1);
    heading->addWidget(m_busy);
    m_pictures->addWidget(m_nothing);
    m_pictures->addWidget(m_plot);
    auto* upper = new QWidget;
    auto* upperLayout = new QVBoxLayout(upper);
    upperLayout->setContentsMargins(4, 0, 0, 0);
    upperLayout->addLayout(heading);
    upperLayout->addWidget(m_pictures, 1);
    auto* rows = new QSplitter(Qt::Vertical);
    rows->setObjectName(QStringLiteral("fitRows"));
    rows->setChildrenCollapsible(false);
    rows->addWidget(upper);
    rows->addWidget(m_results);
    rows->setStretchFactor(0, 3);
    rows->setStretchFactor(1, 2);
    rows->setSizes({380, 240});
    return rows;
}

void FitPage::connectParts()
{
    connect(m_form, &FitForm::chosen, &m_record, &RecordModel::setFit);
    connect(m_form, &FitForm::fileWanted, this, &FitPage::fileWanted);
    connect(m_form, &FitForm::rowsChanged, this, &FitPage::nameKeys);
    connect(m_form, &FitForm::problemChanged, this, [this] {
        offerUse();
        sayNextStep();
    });
    connect(&m_record, &RecordModel::opened, m_form, &FitForm::forgetTyped);
    connect(m_column, &QComboBox::activated, this, &FitPage::chooseColumn);
    connect(m_use, &QPushButton::clicked, this, [this] {
        if (const auto outcome = current())
            Q_EMIT useRequested(outcome, static_cast<std::size_t>(m_column->currentIndex()));
    });
    connect(m_save, &QPushButton::clicked, this, [this] {
        if (const auto outcome = current())
            Q_EMIT saveRequested(outcome, static_cast<std::size_t>(m_column->currentIndex()));
    });
    for (const auto changed :
        {&RecordModel::changed, &RecordModel::stateChanged, &RecordModel::fitChanged})
        connect(&m_record, changed, this, &FitPage::follow);
}

void FitPage::takeFile(const QString& path, bool isOnto)
{
    FitChoices choices = m_record.fitChoices();
    if (isOnto) {
        choices.onto = FitChoices::Onto::File;
        choices.ontoFile = path;
    } else {
        choices.measuredWith = FitChoices::MeasuredWith::File;
        choices.measuredWithFile = path;
    }
    m_record.setFit(choices, isOnto ? tr("Merge onto") : tr("Measured with"));
}

bool FitPage::isPending() const
{
    return m_record.isFitting() || (m_record.isEvaluating() && !m_record.record().files.empty());
}

std::shared_ptr<const FitOutcome> FitPage::current() const
{
    const auto& outcome = m_record.state().fit;
    return outcome && outcome->report && !isPending() && m_form->problem().isEmpty() ? outcome
                                                                                     : nullptr;
}

FitPage::State FitPage::state() const
{
    const auto& outcome = m_record.state().fit;
    if (!outcome || (outcome->refusal && !outcome->settings.lookupAt))
        return State::Empty;
    const bool hasWarnings = outcome->refusal
        || std::ranges::any_of(outcome->report->remarks, &FitRemark::isWarning)
        || !outcome->report->isWithinTolerances() || !axisDoubt().isEmpty();
    return hasWarnings ? State::Warning : State::Ready;
}

void FitPage::follow()
{
    m_form->show(m_record.fitChoices(), m_record.state(), m_record.drive());
    m_form->setEnabled(m_record.isMeasurementShown());
    const bool isOld = isPending();
    m_busy->setBusy(isOld);
    showOutcome();
    m_plot->setOutdated(isOld);
    m_results->setOutdated(isOld);
    if (m_map)
        m_map->setEnabled(!isOld);
    offerUse();
    sayNextStep();
    Q_EMIT stateChanged();
}

void FitPage::showOutcome()
{
    auto outcome = m_record.state().fit;
    if (outcome && !outcome->report)
        outcome = nullptr;
    m_title->setText(isPending() ? (outcome ? tr("An earlier table; a new one is being made …")
                                            : tr("The table is being made …"))
            : outcome            ? tr("Table and measurement")
                                 : tr("No table"));
    if (outcome == m_drawn)
        return;
    m_drawn = outcome;
    offerColumns();
    const bool isMap = outcome && outcome->tables.front().table->grid.dimensions() > 1;
    m_plot->show(isMap ? nullptr : outcome);
    showMap(isMap ? outcome : nullptr);
    if (!isMap)
        m_pictures->setCurrentWidget(outcome ? static_cast<QWidget*>(m_plot) : m_nothing);
    m_results->setVisible(outcome != nullptr);
    m_results->show(outcome, static_cast<std::size_t>(std::max(m_column->currentIndex(), 0)));
}

void FitPage::showMap(const std::shared_ptr<const FitOutcome>& outcome)
{
    if (!outcome && !m_map)
        return;
    if (!m_map) {
        m_shown = new TableViewModel(this);
        m_map = new TablePlot(*m_shown);
        m_map->setObjectName(QStringLiteral("fitMap"));
        m_pictures->addWidget(m_map);
        nameKeys();
    }
    if (outcome)
        m_pictures->setCurrentWidget(m_map);
    const auto column = static_cast<std::size_t>(std::max(m_column->currentIndex(), 0));
    m_shown->setTables(outcome ? outcome->tables[column].table : nullptr, nullptr);
    m_map->setValuesOrigin({true, outcome ? notesOf(*outcome) : std::vector<std::string>(), {}});
    m_map->setMeasured(outcome ? outcome->drawing.places : std::vector<std::array<double, 3>>());
}

/// The one for the current axis, unless the user has chosen another.
void FitPage::offerColumns()
{
    m_column->clear();
    if (!m_drawn)
        return;
    std::vector<CompensationTable> tables;
    for (const FittedTable& made : m_drawn->report->tables) {
        tables.push_back({made.table.name, made.table.unit, {}, {}, made.table.target, {}});
        m_column->addItem(qString(made.table.name));
    }
    int index = m_column->findText(m_chosenColumn);
    const auto& axis = m_record.drive().axis;
    if (index < 0 && axis)
        index = static_cast<int>(
            proposedTable(tables, std::span(&axis->axis, 1), axis->axis.index).value_or(0));
    m_column->setCurrentIndex(std::max(index, 0));
}

void FitPage::chooseColumn(int index)
{
    m_chosenColumn = m_column->itemText(index);
    showMap(m_drawn && m_drawn->tables.front().table->grid.dimensions() > 1 ? m_drawn : nullptr);
    m_results->show(m_drawn, static_cast<std::size_t>(index));
}

void FitPage::setObstacle(const QString& obstacle)
{
    if (obstacle == m_obstacle)
        return;
    m_obstacle = obstacle;
    offerUse();
}

void FitPage::offerUse()
{
    const auto outcome = current();
    const bool hasColumns = m_column->count() > 1;
    m_columnLabel->setVisible(hasColumns);
    m_column->setVisible(hasColumns);
    m_use->setEnabled(outcome && m_obstacle.isEmpty());
    m_save->setEnabled(outcome != nullptr);
    m_use->setToolTip(!outcome ? tr("There is no table yet")
            : m_obstacle.isEmpty()
            ? tr("Take the table over to Write, as if it had been read from a file")
            : m_obstacle);
    m_save->setToolTip(outcome ? tr("As a file of the drive or of another controller")
                               : tr("There is no table yet"));
    for (QPushButton* button : {m_use, m_save})
        button->setAccessibleDescription(button->toolTip());
}

/// A table of another drive or axis than the current one, or one that it would look up on the other
/// side of the compensation.
QString FitPage::axisDoubt() const
{
    const auto& outcome = m_record.state().fit;
    const FitDrive& drive = m_record.drive();
    if (!outcome || !outcome->report || !drive.profile || !drive.axis)
        return {};
    const auto measured = checkMeasuredDrive(
        driveSerialOf(outcome->request.measurement->header), drive.axis->serialNumber);
    if (!measured)
        return errorText(measured.error());
    const std::string& target = outcome->report->tables.front().table.target;
    if (outcome->report->tables.size() == 1 && areDifferentAxes(target, drive.axis->axis.name))
        return tr("The table corrects axis %1, and the current axis is %2: it is refused there. "
                  "Choose the axis that was measured.")
            .arg(QString::fromStdString(target), QString::fromStdString(drive.axis->axis.name));
    const auto checked =
        checkLookupSource(outcome->report->lookupAt, *drive.profile, drive.axis->source);
    return checked ? QString() : errorText(checked.error());
}

void FitPage::sayNextStep()
{
    const auto& outcome = m_record.state().fit;
    const QString problem = m_form->problem();
    if (m_record.record().files.empty())
        m_nextStep->say(Tone::Information,
            tr("Add the files of a measurement on Measure; here a table is made of it."));
    else if (!problem.isEmpty())
        m_nextStep->say(Tone::Error, problem);
    else if (isPending())
        m_nextStep->say(Tone::Information, tr("The table is being made …"));
    else if (!outcome)
        m_nextStep->say(Tone::Error, tr("The files on Measure cannot be used."));
    else if (outcome->refusal && !outcome->settings.lookupAt)
        m_nextStep->say(Tone::Information,
            tr("Choose where the drive looks its table up: it decides where the values belong."));
    else if (outcome->refusal)
        m_nextStep->say(Tone::Error, errorText(*outcome->refusal));
    else if (const QString doubt = axisDoubt(); !doubt.isEmpty())
        m_nextStep->say(Tone::Warning, doubt);
    else if (state() == State::Warning)
        m_nextStep->say(Tone::Warning,
            tr("Read the warnings; then the table can be used: it is taken over to Write."));
    else
        m_nextStep->say(Tone::Success,
            tr("The table can be used: it is taken over to Write, where nothing is written before "
               "you say so."));
}

QSet<QChar> FitPage::keysAround() const
{
    QSet<QChar> used;
    const auto use = [&used](const QString& text) {
        if (const QChar key = keyOf(text); !key.isNull())
            used.insert(key);
    };
    // Pages of other tabs are out of sight.
    const QWidget* pages = parentWidget();
    const auto isAround = [&](const QWidget* widget) {
        return !pages || !pages->isAncestorOf(widget) || (m_map && m_map->isAncestorOf(widget));
    };
    for (const auto* button : window()->findChildren<QAbstractButton*>())
        if (isAround(button) && !isAncestorOf(button) && button->isVisibleTo(window()))
            use(button->text());
    for (const auto* label : window()->findChildren<QLabel*>())
        if (label->buddy() && isAround(label) && !isAncestorOf(label)
            && label->isVisibleTo(window()))
            use(label->text());
    if (m_map)
        for (const auto* button : m_map->findChildren<QAbstractButton*>())
            use(button->text());
    return used;
}

void FitPage::nameKeys()
{
    QSet<QChar> used = keysAround();
    m_use->setText(withFreeKey(tr("Use as Table"), used));
    m_save->setText(withFreeKey(tr("Save Table…"), used));
    m_columnLabel->setText(withFreeKey(tr("Column"), used));
    m_form->retranslate(used);
}

void FitPage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    nameKeys();
}

void FitPage::retranslate()
{
    nameKeys();
    // What stands around this page may be translated after it.
    QMetaObject::invokeMethod(this, &FitPage::nameKeys, Qt::QueuedConnection);
    m_column->setAccessibleName(tr("Column"));
    m_column->setToolTip(tr("Which column of the points is shown and used"));
    m_column->setAccessibleDescription(m_column->toolTip());
    m_plot->retranslate();
    m_results->retranslate();
    showOutcome();
    offerUse();
    sayNextStep();
}

} // namespace axiscomp::ui
