// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/judging/judge_page.h"

#include "ui/judging/corrections_dialog.h"
#include "ui/judging/judge_outlook.h"
#include "ui/judging/limit_fields.h"
#include "ui/judging/outlier_list.h"
#include "ui/plot/deviation_plot.h"
#include "ui/plot/drift_plot.h"
#include "ui/record/drift_models.h"
#include "ui/record/figures_models.h"
#include "ui/record/record_model.h"
#include "ui/record/remark_models.h"
#include "ui/style/plain_label.h"
#include "ui/style/row_table.h"
#include "ui/style/tone_label.h"
#include "ui/tabs/next_step.h"
#include "ui/tabs/tab_columns.h"
#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QSplitter>
#include <QTabWidget>
#include <QTableView>

#include <algorithm>

namespace axiscomp::ui {

namespace {

enum View { FiguresView, TargetsView, RunsView, DriftView, ConditionsView, WarningsView };

} // namespace

JudgePage::JudgePage(RecordModel& record, QWidget* parent)
    : QWidget(parent)
    , m_record(record)
    , m_targets(new TargetFiguresModel(record, this))
    , m_limits(new LimitFields(record))
    , m_outliers(new OutlierList(record))
    , m_nextStep(new NextStep(QStringLiteral("judgeHint")))
    , m_limitsTitle(new PlainLabel)
    , m_correctionsText(new PlainLabel)
    , m_corrections(new QPushButton)
    , m_heading(new ToneLabel)
    , m_showsAll(new QCheckBox)
    , m_plot(new DeviationPlot)
    , m_drift(new DriftPlot)
    , m_plots(new QTabWidget)
    , m_views(new QTabWidget)
{
    setObjectName(QStringLiteral("judgePage"));
    build();
    connectParts();
    retranslate();
}

void JudgePage::build()
{
    QWidget* const chosen = buildLeft();
    fillWithColumns(*this, QStringLiteral("judgeColumns"), chosen, buildRight());
}

QWidget* JudgePage::buildLeft()
{
    constexpr int gap = 12;
    auto* fields = new QWidget;
    auto* fieldLayout = new QVBoxLayout(fields);
    fieldLayout->setContentsMargins(0, 0, 0, 0);
    fieldLayout->addWidget(m_limitsTitle);
    fieldLayout->addWidget(m_limits);
    fieldLayout->addWidget(m_outliers, 1);
    m_correctionsText->setObjectName(QStringLiteral("correctionsText"));
    m_correctionsText->setWordWrap(true);
    m_corrections->setObjectName(QStringLiteral("corrections"));
    auto* corrections = new QHBoxLayout;
    corrections->addWidget(m_correctionsText, 1);
    corrections->addWidget(m_corrections);
    fieldLayout->addLayout(corrections);
    auto* scroll = new QScrollArea;
    scroll->setObjectName(QStringLiteral("judgeScroll"));
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(fields);
    auto* left = new QWidget;
    auto* layout = new QVBoxLayout(left);
    layout->setContentsMargins(0, 0, gap, 0);
    layout->addWidget(scroll, 1);
    layout->addWidget(m_nextStep);
    return left;
}

QWidget* JudgePage::buildRight()
{
    m_heading->setObjectName(QStringLiteral("judgeHeading"));
    m_heading->setWordWrap(true);
    m_showsAll->setObjectName(QStringLiteral("showAllValues"));
    m_plots->setObjectName(QStringLiteral("judgePlots"));
    m_plots->setDocumentMode(true);
    m_plots->addTab(m_plot, QString());
    m_plots->addTab(m_drift, QString());
    m_views->setObjectName(QStringLiteral("judgeTabs"));
    m_views->setDocumentMode(true);
    addTable("figures", new FiguresModel(m_record, this));
    addTable("targetFigures", m_targets);
    addTable("runDrift", new RunDriftModel(m_record, this));
    addTable("drift", new DriftModel(m_record, this));
    addTable("conditions", new ConditionsModel(m_record, this));
    addTable("judgeWarnings", new JudgeWarningsModel(m_record, this));
    auto* top = new QHBoxLayout;
    top->addWidget(m_heading, 1);
    top->addWidget(m_showsAll);
    auto* rows = new QSplitter(Qt::Vertical);
    rows->setObjectName(QStringLiteral("judgeRows"));
    rows->setChildrenCollapsible(false);
    rows->addWidget(m_plots);
    rows->addWidget(m_views);
    rows->setStretchFactor(0, 3);
    rows->setStretchFactor(1, 2);
    rows->setSizes({380, 260});
    auto* right = new QWidget;
    auto* layout = new QVBoxLayout(right);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addLayout(top);
    layout->addWidget(rows, 1);
    return right;
}

void JudgePage::addTable(const char* name, JudgementTableModel* model)
{
    QTableView* view = newRowTable(name, *model);
    m_tables.push_back({model, view});
    m_views->addTab(view, QString());
    connect(view->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
        [this, model](const QModelIndex& current) {
            if (!m_isSelecting && current.isValid())
                if (const auto values = model->valuesOf(current.row()))
                    select(values);
        });
}

void JudgePage::connectParts()
{
    connect(m_outliers, &OutlierList::selectionChanged, this, &JudgePage::select);
    connect(m_plot, &DeviationPlot::selectionChanged, this,
        [this](const std::optional<DeviationPlace>& place) {
            select(place ? std::optional(place->values) : std::nullopt);
        });
    connect(m_drift, &DriftPlot::selectionChanged, this, &JudgePage::select);
    auto* key = new QShortcut(QKeySequence::Delete, &m_plot->picture());
    key->setContext(Qt::WidgetShortcut);
    connect(key, &QShortcut::activated, m_outliers, &OutlierList::exclude);
    connect(m_corrections, &QPushButton::clicked, this, &JudgePage::askForCorrections);
    connect(m_showsAll, &QCheckBox::toggled, this, [this](bool showsAll) {
        m_targets->setShowsAll(showsAll);
        showPlots();
    });
    connect(&m_record, &RecordModel::changed, this, &JudgePage::follow);
    connect(&m_record, &RecordModel::stateChanged, this, &JudgePage::follow);
}

void JudgePage::retranslate()
{
    m_limitsTitle->setText(tr("Tolerances, and the uncertainty U (k = 2)"));
    m_showsAll->setText(tr("All &values"));
    m_showsAll->setToolTip(tr("Show plot and targets as if nothing were excluded"));
    m_showsAll->setAccessibleDescription(m_showsAll->toolTip());
    m_corrections->setText(tr("&Corrections…"));
    m_corrections->setToolTip(
        tr("Bring the values to 20 °C, or correct them for the dead path of an interferometer"));
    m_corrections->setAccessibleDescription(m_corrections->toolTip());
    m_plots->setTabText(0, tr("Deviation"));
    m_plots->setTabText(1, tr("Drift"));
    m_plots->tabBar()->setAccessibleName(tr("Plots"));
    m_views->tabBar()->setAccessibleName(tr("Tables"));
    const QStringList names{tr("Figures"), tr("Targets"), tr("Runs"), tr("Drift in numbers"),
        tr("Conditions"), tr("Warnings")};
    for (int i = 0; i < names.size(); ++i) {
        m_views->setTabText(i, names[i]);
        m_tables[static_cast<std::size_t>(i)].view->setAccessibleName(names[i]);
        m_tables[static_cast<std::size_t>(i)].model->retranslate();
    }
    m_limits->retranslate();
    m_outliers->retranslate();
    m_plot->retranslate();
    m_drift->retranslate();
    follow();
}

PageTabs::Mark JudgePage::mark() const
{
    return judgeOutlook(m_record).mark;
}

void JudgePage::follow()
{
    const RecordState& state = m_record.state();
    const JudgeOutlook outlook = judgeOutlook(m_record);
    m_nextStep->say(outlook.tone, outlook.nextStep);
    const std::size_t warnings = state.judgement ? state.judgement->warnings.size() : 0;
    m_views->setTabVisible(WarningsView, warnings > 0);
    m_views->setTabText(WarningsView, tr("Warnings (%1)").arg(countText(warnings)));
    m_showsAll->setEnabled(state.judgement && state.judgement->ofAllValues);
    if (!m_showsAll->isEnabled())
        m_showsAll->setChecked(false);
    showHeading();
    showCorrections();
    showPlots();
}

void JudgePage::showCorrections()
{
    const RecordState& state = m_record.state();
    m_corrections->setEnabled(!state.files.empty() && !m_record.record().files.empty());
    QStringList made;
    if (state.measurement)
        for (const Text& text : correctionTexts(state.measurement->againstFile,
                 state.record.corrections, state.largestByTemperature, state.largestByDeadPath))
            made += sentenceText(text);
    m_correctionsText->setText(made.isEmpty() ? tr("No corrections.") : made.join(u' '));
}

/// Of the first file: as read, before anything was made of it. What is typed is of the files of
/// now: others may come meanwhile, as from a capture that ends.
void JudgePage::askForCorrections()
{
    const auto& files = m_record.state().files;
    const Measurement* measurement = files.empty() ? nullptr : files.front().measurement();
    if (!measurement)
        return;
    Measurement stated;
    stated.header = measurement->header;
    stated.isAngular = measurement->isAngular;
    if (const auto& whole = m_record.state().measurement) { // numbers that not all files say
        stated.header.materialTemperature = whole->header.materialTemperature;
        stated.header.expansion = whole->header.expansion;
    }
    m_correctionsDialog = new CorrectionsDialog(stated, m_record.record().corrections, this);
    connect(m_correctionsDialog, &CorrectionsDialog::deadPathRequested, this,
        &JudgePage::deadPathRequested);
    connect(
        m_correctionsDialog, &CorrectionsDialog::chosen, &m_record, &RecordModel::setCorrections);
    connect(&m_record, &RecordModel::changed, m_correctionsDialog,
        [this, dialog = m_correctionsDialog.data(), asked = m_record.record().files] {
            if (m_record.record().files != asked)
                dialog->reject();
        });
    connect(&m_record, &RecordModel::filesChanged, m_correctionsDialog, &CorrectionsDialog::reject);
    m_correctionsDialog->open();
}

void JudgePage::readDeadPath(const QString& path)
{
    if (m_correctionsDialog)
        m_correctionsDialog->readDeadPath(path);
}

/// What the figures are, before anybody reads them.
void JudgePage::showHeading()
{
    const RecordState& state = m_record.state();
    if (!state.judgement) {
        m_heading->clear();
        return;
    }
    const auto& warnings = state.judgement->warnings;
    const auto excluded =
        std::ranges::find(warnings, std::string_view("ValuesExcluded"), &JudgeWarning::name);
    m_heading->setTone(excluded == warnings.end() ? std::nullopt : std::optional(Tone::Warning));
    m_heading->setText(excluded == warnings.end() ? tr("Figures of ISO 230-2:2014")
                                                  : sentenceText(excluded->text));
}

/// A picture that nobody sees is not made.
void JudgePage::showPlots()
{
    if (!isVisible()) {
        m_arePlotsOld = true;
        return;
    }
    m_arePlotsOld = false;
    const RecordState& state = m_record.state();
    m_plot->setSeries({m_showsAll->isChecked() ? state.all.series : state.used.series});
    m_drift->setJudgement(state.judgement, state.measurement && state.measurement->isAngular);
    select(m_selected);
}

void JudgePage::showEvent(QShowEvent* event)
{
    QWidget::showEvent(event);
    if (m_arePlotsOld)
        showPlots();
}

void JudgePage::select(const std::optional<Exclusion>& values)
{
    m_selected = values;
    m_isSelecting = true;
    m_plot->select(values ? std::optional(DeviationPlace{0, *values}) : std::nullopt);
    m_drift->select(values);
    m_outliers->select(values);
    for (const Table& table : m_tables) {
        const int row = values ? table.model->rowOf(*values) : -1;
        if (row >= 0)
            table.view->setCurrentIndex(table.model->index(row, 0));
        else if (table.model->rowCount() > 0 && table.model->valuesOf(0))
            table.view->setCurrentIndex({});
    }
    m_isSelecting = false;
}

} // namespace axiscomp::ui
