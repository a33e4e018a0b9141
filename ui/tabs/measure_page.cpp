// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tabs/measure_page.h"

#include "ui/controller/wizard_settings.h"
#include "ui/measuring/measuring_actions.h"
#include "ui/page/file_lines_view.h"
#include "ui/page/problem_list.h"
#include "ui/record/measurement_files_model.h"
#include "ui/record/record_model.h"
#include "ui/style/plain_label.h"
#include "ui/style/symbols.h"
#include "ui/tabs/capture_panel.h"
#include "ui/tabs/column_preview.h"
#include "ui/tabs/column_proposal.h"
#include "ui/tabs/file_choices.h"
#include "ui/tabs/file_facts.h"
#include "ui/tabs/next_step.h"
#include "ui/tabs/run_values_view.h"
#include "ui/text/message_text.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QCheckBox>
#include <QFileInfo>
#include <QHeaderView>
#include <QPushButton>
#include <QScrollArea>
#include <QShortcut>
#include <QSplitter>
#include <QStackedWidget>
#include <QTabWidget>
#include <QTableView>

#include <algorithm>

namespace axiscomp::ui {

namespace {

constexpr int columnsTab = 1;
constexpr int problemTab = 2;
constexpr int valuesTab = 3;
constexpr int captureTab = 4;

} // namespace

MeasurePage::MeasurePage(RecordModel& record, QWidget* parent)
    : QWidget(parent)
    , m_record(record)
    , m_model(new MeasurementFilesModel(record, this))
    , m_program(new QPushButton)
    , m_capture(new QPushButton)
    , m_title(new PlainLabel)
    , m_add(new QPushButton)
    , m_files(new QTableView)
    , m_remove(new QPushButton)
    , m_swap(new QCheckBox)
    , m_choices(new FileChoices)
    , m_nextStep(new NextStep(QStringLiteral("measureHint")))
    , m_views(new QTabWidget)
    , m_facts(new FileFacts)
    , m_columns(new ColumnPreview)
    , m_proposal(new ColumnProposal)
    , m_values(new RunValuesView(record))
    , m_save(new QPushButton)
    , m_problemStack(new QStackedWidget)
    , m_problems(new ProblemList(nullptr, ProblemList::About::Measurement))
    , m_lines(new FileLinesView)
{
    setObjectName(QStringLiteral("measurePage"));
    build();
    connectParts();
    retranslate();
}

void MeasurePage::build()
{
    m_problemStack->addWidget(m_problems);
    m_problemStack->addWidget(m_lines);
    m_views->setObjectName(QStringLiteral("measureTabs"));
    m_views->addTab(m_facts, QString());
    m_views->addTab(buildColumns(), QString());
    m_views->addTab(m_problemStack, QString());
    m_views->addTab(m_values, QString());
    auto* columns = new QSplitter(Qt::Horizontal);
    columns->setObjectName(QStringLiteral("measureColumns"));
    columns->setChildrenCollapsible(false);
    columns->addWidget(buildLeft());
    columns->addWidget(m_views);
    columns->setStretchFactor(0, 0);
    columns->setStretchFactor(1, 1);
    columns->setSizes({456, 800});
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(columns);
}

QWidget* MeasurePage::buildLeft()
{
    constexpr int gap = 12;
    m_add->setObjectName(QStringLiteral("addMeasurement"));
    m_add->setIcon(symbolIcon(Symbol::Add));
    m_remove->setObjectName(QStringLiteral("removeMeasurement"));
    m_remove->setIcon(symbolIcon(Symbol::Remove));
    m_save->setObjectName(QStringLiteral("saveMeasurement"));
    m_save->setIcon(symbolIcon(Symbol::Save));
    m_swap->setObjectName(QStringLiteral("swapDirections"));
    m_files->setObjectName(QStringLiteral("measurementFiles"));
    m_files->setModel(m_model);
    m_files->setSelectionBehavior(QAbstractItemView::SelectRows);
    m_files->setSelectionMode(QAbstractItemView::SingleSelection);
    m_files->setAlternatingRowColors(true);
    m_files->setShowGrid(false);
    m_files->setTabKeyNavigation(false);
    m_files->setWordWrap(false);
    m_files->setHorizontalScrollMode(QAbstractItemView::ScrollPerPixel);
    m_files->verticalHeader()->hide();
    m_files->verticalHeader()->setDefaultSectionSize(m_files->fontMetrics().height() + 8);
    m_files->horizontalHeader()->setHighlightSections(false);
    m_files->horizontalHeader()->setDefaultAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    m_files->horizontalHeader()->setSectionResizeMode(QHeaderView::ResizeToContents);
    // The name gives way to the rest, whose whole is in its tool tip.
    m_files->horizontalHeader()->setSectionResizeMode(
        MeasurementFilesModel::File, QHeaderView::Stretch);
    m_files->horizontalHeader()->setMinimumSectionSize(
        m_files->fontMetrics().horizontalAdvance(QStringLiteral("measured.csv")));
    m_files->setMinimumHeight(5 * m_files->verticalHeader()->defaultSectionSize());

    auto* fields = new QWidget;
    auto* fieldLayout = new QVBoxLayout(fields);
    fieldLayout->setContentsMargins(0, 0, 0, 0);
    auto* buttons = new QHBoxLayout;
    buttons->addWidget(m_title, 1);
    buttons->addWidget(m_add);
    buttons->addWidget(m_remove);
    fieldLayout->addLayout(buttons);
    fieldLayout->addWidget(m_files, 1);
    fieldLayout->addWidget(m_swap);
    fieldLayout->addWidget(m_choices);
    auto* scroll = new QScrollArea;
    scroll->setObjectName(QStringLiteral("measureScroll"));
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setHorizontalScrollBarPolicy(Qt::ScrollBarAsNeeded);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(fields);
    auto* left = new QWidget;
    auto* layout = new QVBoxLayout(left);
    layout->setContentsMargins(0, 0, gap, 0);
    layout->addWidget(buildMeasuring());
    layout->addWidget(scroll, 1);
    layout->addWidget(m_save);
    layout->addWidget(m_nextStep);
    return left;
}

QWidget* MeasurePage::buildMeasuring()
{
    m_program->setObjectName(QStringLiteral("newProgram"));
    m_capture->setObjectName(QStringLiteral("captureValues"));
    auto* row = new QWidget;
    auto* layout = new QHBoxLayout(row);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_program);
    layout->addWidget(m_capture);
    layout->addStretch(1);
    row->hide();
    return row;
}

QWidget* MeasurePage::buildColumns()
{
    auto* columns = new QWidget;
    auto* layout = new QVBoxLayout(columns);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(0);
    layout->addWidget(m_proposal);
    layout->addWidget(m_columns, 1);
    return columns;
}

void MeasurePage::setMeasuring(MeasuringActions& measuring, WizardSettings& settings)
{
    m_measuring = &measuring;
    m_settings = &settings;
    m_capturePanel = new CapturePanel(measuring.feed());
    // Its digits are wider than a small screen has room for.
    auto* scroll = new QScrollArea;
    scroll->setObjectName(QStringLiteral("captureScroll"));
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(m_capturePanel);
    m_views->addTab(scroll, QString());
    m_program->parentWidget()->show();
    connect(m_program, &QPushButton::clicked, &measuring, &MeasuringActions::planMeasurement);
    connect(m_capture, &QPushButton::clicked, &measuring, &MeasuringActions::captureValues);
    connect(
        &measuring, &MeasuringActions::captureObstacleChanged, this, &MeasurePage::showMeasuring);
    connect(&measuring.feed(), &CaptureFeed::changed, this, &MeasurePage::showMeasuring);
    connect(&measuring.feed(), &CaptureFeed::begun, this,
        [this] { m_views->setCurrentIndex(captureTab); });
    connect(&measuring.feed(), &CaptureFeed::finished, this, &MeasurePage::takeCaptured);
    retranslate();
}

void MeasurePage::showMeasuring()
{
    if (!m_measuring)
        return;
    const CaptureView::Phase phase = m_measuring->feed().view().phase;
    m_views->setTabVisible(
        captureTab, phase != CaptureView::Phase::None && phase != CaptureView::Phase::Opening);
    const QString obstacle = m_measuring->captureObstacle();
    m_capture->setEnabled(obstacle.isEmpty());
    m_capture->setToolTip(obstacle.isEmpty()
            ? tr("Take the values of a plan while something else moves the axis")
            : obstacle);
    m_capture->setAccessibleDescription(m_capture->toolTip());
}

/// It may be among the files already, with fewer values.
void MeasurePage::takeCaptured(const QString& path)
{
    if (m_measuring->feed().view().values.empty())
        return;
    m_record.addFiles({path});
    m_record.readAgain();
}

void MeasurePage::chooseColumns(const std::vector<ColumnMapping>& columns)
{
    const auto file = currentFile();
    if (!file)
        return;
    MeasurementChoices choices = m_record.record().files[*file].choices;
    choices.columns = columns;
    m_record.setChoices(*file, choices);
    const QStringList header = m_columns->header();
    if (m_settings)
        m_settings->setColumnRoles(header, ColumnPreview::rolesOf(columns, header.size()));
}

void MeasurePage::proposeColumns()
{
    const auto file = currentFile();
    const QStringList header = m_columns->header();
    if (!file || !m_settings || header.isEmpty())
        return m_proposal->propose({});
    const auto columns = ColumnPreview::mappingOf(m_settings->columnRoles(header));
    const bool isChosen = columns == m_record.record().files[*file].choices.columns;
    m_proposal->propose(isChosen ? std::vector<ColumnMapping>() : columns);
}

void MeasurePage::connectParts()
{
    connect(m_add, &QPushButton::clicked, this, &MeasurePage::addRequested);
    connect(m_save, &QPushButton::clicked, this, &MeasurePage::saveRequested);
    connect(m_remove, &QPushButton::clicked, this, &MeasurePage::remove);
    auto* removeKey = new QShortcut(QKeySequence::Delete, m_files);
    removeKey->setContext(Qt::WidgetShortcut);
    connect(removeKey, &QShortcut::activated, this, &MeasurePage::remove);
    connect(m_swap, &QCheckBox::clicked, &m_record, &RecordModel::setDirectionsSwapped);
    connect(m_choices, &FileChoices::chosen, this, [this](const MeasurementChoices& choices) {
        if (const auto file = currentFile())
            m_record.setChoices(*file, choices);
    });
    connect(m_columns, &ColumnPreview::mappingChosen, this, &MeasurePage::chooseColumns);
    connect(m_columns, &ColumnPreview::previewed, this, &MeasurePage::proposeColumns);
    connect(m_proposal, &ColumnProposal::taken, this,
        [this] { chooseColumns(m_proposal->proposed()); });
    connect(m_problems, &ProblemList::opened, this,
        [this](const QString& path, const ProblemPlace& place) {
            m_lines->showProblem(path, place);
            m_problemStack->setCurrentWidget(m_lines);
        });
    connect(m_lines, &FileLinesView::stepRequested, m_problems, &ProblemList::step);
    connect(m_lines, &FileLinesView::closeRequested, this,
        [this] { m_problemStack->setCurrentWidget(m_problems); });
    connect(m_files->selectionModel(), &QItemSelectionModel::currentRowChanged, this,
        &MeasurePage::showFile);
    connect(&m_record, &RecordModel::changed, this, [this] {
        m_saved.reset();
        follow();
    });
    connect(&m_record, &RecordModel::stateChanged, this, &MeasurePage::follow);
}

void MeasurePage::retranslate()
{
    m_program->setText(tr("New &Program…"));
    m_program->setToolTip(
        tr("Plan the targets of a measurement, and a program for the control of the machine"));
    m_program->setAccessibleDescription(m_program->toolTip());
    m_capture->setText(tr("Cap&ture…"));
    m_title->setText(tr("Files"));
    m_add->setText(tr("&Add…"));
    m_add->setToolTip(tr("Add files of a measurement; they can also be dropped here (Ctrl+O)"));
    m_add->setAccessibleDescription(m_add->toolTip());
    m_remove->setText(tr("Re&move"));
    m_remove->setToolTip(tr("Take the selected file out of the measurement (Del)"));
    m_remove->setAccessibleDescription(m_remove->toolTip());
    m_save->setText(tr("&Save as Runs…"));
    m_save->setToolTip(tr("All files as one CSV file, with what is excluded marked in it"));
    m_save->setAccessibleDescription(m_save->toolTip());
    m_files->setAccessibleName(tr("Files of the measurement"));
    m_swap->setText(tr("E&xchange up and down in all files"));
    m_swap->setToolTip(tr("For files that name the directions the other way round"));
    m_swap->setAccessibleDescription(m_swap->toolTip());
    m_views->setTabText(0, tr("What the file says"));
    m_views->setTabText(1, tr("Columns"));
    m_views->setTabText(valuesTab, tr("Values of all files"));
    m_views->tabBar()->setAccessibleName(tr("Views of the file"));
    m_model->retranslate();
    m_choices->retranslate();
    m_facts->retranslate();
    m_columns->retranslate();
    m_problems->retranslate();
    m_lines->retranslate();
    m_values->retranslate();
    m_proposal->retranslate();
    if (m_capturePanel) {
        m_views->setTabText(captureTab, tr("Capture"));
        m_capturePanel->retranslate();
    }
    showMeasuring();
    follow();
}

std::optional<std::size_t> MeasurePage::currentFile() const
{
    const int row = m_files->currentIndex().row();
    const std::size_t count = m_record.record().files.size();
    return row >= 0 && static_cast<std::size_t>(row) < count
        ? std::optional(static_cast<std::size_t>(row))
        : std::nullopt;
}

const ReadMeasurement* MeasurePage::currentReading() const
{
    const auto file = currentFile();
    if (!file)
        return nullptr;
    const auto& readings = m_record.state().files;
    const auto found =
        std::ranges::find(readings, m_record.record().files[*file], &ReadMeasurement::file);
    return found == readings.end() ? nullptr : &*found;
}

void MeasurePage::remove()
{
    if (const auto file = currentFile())
        m_record.removeFile(*file);
}

void MeasurePage::follow()
{
    const std::size_t count = m_record.record().files.size();
    const bool isNew = count > m_fileCount;
    if (count > 0 && (isNew || !m_files->currentIndex().isValid()))
        m_files->setCurrentIndex(
            m_model->index(isNew ? static_cast<int>(count) - 1 : 0, MeasurementFilesModel::File));
    m_fileCount = count;
    m_swap->setChecked(m_record.record().swapsDirections);
    m_swap->setEnabled(count > 0);
    const RecordState& state = m_record.state();
    const bool hasTargets = state.measurement && state.measurement->hasTargets();
    m_save->setEnabled(hasTargets && !m_record.isEvaluating());
    m_views->setTabVisible(valuesTab, hasTargets);
    showFile();
    sayNextStep();
}

void MeasurePage::showFile()
{
    const auto file = currentFile();
    const MeasurementFile shown = file ? m_record.record().files[*file] : MeasurementFile{};
    m_remove->setEnabled(file.has_value());
    m_choices->setEnabled(file.has_value());
    m_choices->show(shown.choices);
    m_columns->show(shown.path, shown.choices);
    proposeColumns();
    const ReadMeasurement* reading = currentReading();
    m_facts->show(reading);
    showProblems(reading);
}

void MeasurePage::showProblems(const ReadMeasurement* reading)
{
    DataFile file;
    if (reading && reading->reading) {
        file.problemsPath = reading->file.path;
        file.problems = reading->reading->diagnostics;
        file.suppressedProblems = reading->reading->suppressed;
    } else if (reading && reading->refusal) {
        file.problemsPath = reading->file.path;
        file.problems.push_back(
            {Severity::Error, DiagnosticCode::IoError, 0, 0, textOf(*reading->refusal), {}, {}});
    }
    const bool hasErrors = reading && reading->refusal;
    const std::size_t count = file.problems.size() + file.suppressedProblems;
    m_views->setTabText(problemTab, tr("Problems (%1)").arg(countText(count)));
    m_views->setTabVisible(problemTab, count > 0);
    if (!m_problems->setProblems(file))
        return;
    m_problemStack->setCurrentWidget(m_problems);
    // Who gives the columns their roles sees the problems come and go.
    if (hasErrors && m_views->currentIndex() != columnsTab)
        m_views->setCurrentIndex(problemTab);
}

void MeasurePage::sayNextStep()
{
    const RecordState& state = m_record.state();
    const auto refused = std::ranges::find_if(
        state.files, [](const ReadMeasurement& file) { return file.refusal.has_value(); });
    if (m_record.record().files.empty())
        m_nextStep->say(Tone::Information,
            tr("Add the files of a measurement, take its values with Capture, or go on to Write "
               "with "
               "a table that is there."));
    else if (m_record.isEvaluating() && !m_record.isMeasurementShown())
        m_nextStep->say(Tone::Information, tr("The files are being read …"));
    else if (refused != state.files.end())
        m_nextStep->say(Tone::Error, errorText(*refused->refusal));
    else if (state.refusal)
        m_nextStep->say(Tone::Error, errorText(*state.refusal));
    else if (m_saved && m_saved == state.measurement && !m_record.isEvaluating())
        m_nextStep->say(Tone::Success,
            tr("Saved as %1. The commands axiscomp judge and axiscomp fit go on with it: figures "
               "of ISO 230-2, and a table for Write.")
                .arg(m_savedName));
    else if (!state.measurement->hasTargets())
        m_nextStep->say(Tone::Information,
            tr("Without targets there are no figures of ISO 230-2; the command axiscomp fit makes "
               "a table of it for Write."));
    else
        m_nextStep->say(Tone::Success,
            tr("The measurement can be used. Save it as runs for the commands axiscomp judge and "
               "axiscomp fit."));
}

void MeasurePage::showSaved(
    const QString& path, const std::shared_ptr<const Measurement>& measurement)
{
    m_saved = measurement;
    m_savedName = QFileInfo(path).fileName();
    sayNextStep();
}

} // namespace axiscomp::ui
