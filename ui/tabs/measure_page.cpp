// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tabs/measure_page.h"

#include "ui/controller/wizard_settings.h"
#include "ui/measuring/measuring_actions.h"
#include "ui/record/record_model.h"
#include "ui/style/symbols.h"
#include "ui/tabs/capture_panel.h"
#include "ui/tabs/file_views.h"
#include "ui/tabs/measurement_files.h"
#include "ui/tabs/next_step.h"
#include "ui/tabs/run_values_view.h"
#include "ui/tabs/tab_columns.h"
#include "ui/text/message_text.h"

#include <QBoxLayout>
#include <QFileInfo>
#include <QPushButton>
#include <QScrollArea>

#include <algorithm>

namespace axiscomp::ui {

MeasurePage::MeasurePage(RecordModel& record, QWidget* parent)
    : QWidget(parent)
    , m_record(record)
    , m_program(new QPushButton)
    , m_capture(new QPushButton)
    , m_files(new MeasurementFiles(record))
    , m_nextStep(new NextStep(QStringLiteral("measureHint")))
    , m_views(new FileViews)
    , m_values(new RunValuesView(record))
    , m_save(new QPushButton)
{
    setObjectName(QStringLiteral("measurePage"));
    build();
    connectParts();
    retranslate();
}

void MeasurePage::build()
{
    m_views->setObjectName(QStringLiteral("measureTabs"));
    m_views->addTab(m_values, QString());
    fillWithColumns(*this, QStringLiteral("measureColumns"), buildLeft(), m_views);
}

QWidget* MeasurePage::buildLeft()
{
    constexpr int gap = 12;
    m_save->setObjectName(QStringLiteral("saveMeasurement"));
    m_save->setIcon(symbolIcon(Symbol::Save));
    auto* left = new QWidget;
    auto* layout = new QVBoxLayout(left);
    layout->setContentsMargins(0, 0, gap, 0);
    layout->addWidget(buildMeasuring());
    layout->addWidget(m_files, 1);
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

void MeasurePage::setMeasuring(MeasuringActions& measuring, WizardSettings& settings)
{
    m_measuring = &measuring;
    m_views->remember(settings);
    m_capturePanel = new CapturePanel(measuring.feed());
    // Its digits are wider than a small screen has room for.
    auto* scroll = new QScrollArea;
    scroll->setObjectName(QStringLiteral("captureScroll"));
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus);
    scroll->setWidget(m_capturePanel);
    m_captureView = scroll;
    m_views->addTab(scroll, QString());
    m_program->parentWidget()->show();
    connect(m_program, &QPushButton::clicked, &measuring, &MeasuringActions::planMeasurement);
    connect(m_capture, &QPushButton::clicked, &measuring, &MeasuringActions::captureValues);
    connect(
        &measuring, &MeasuringActions::captureObstacleChanged, this, &MeasurePage::showMeasuring);
    connect(&measuring.feed(), &CaptureFeed::changed, this, &MeasurePage::showMeasuring);
    connect(&measuring.feed(), &CaptureFeed::begun, this, [this] {
        m_isCapturingForRecord = true;
        m_views->setCurrentWidget(m_captureView);
    });
    connect(&measuring.feed(), &CaptureFeed::finished, this, &MeasurePage::takeCaptured);
    retranslate();
}

void MeasurePage::showMeasuring()
{
    if (!m_measuring)
        return;
    const CaptureView::Phase phase = m_measuring->feed().view().phase;
    m_views->setTabVisible(m_views->indexOf(m_captureView),
        phase != CaptureView::Phase::None && phase != CaptureView::Phase::Opening);
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
    if (!m_isCapturingForRecord) {
        m_capturedForAnother = QFileInfo(path).fileName();
        return sayNextStep();
    }
    m_record.addFiles({path});
    m_record.readAgain();
}

void MeasurePage::connectParts()
{
    connect(m_files, &MeasurementFiles::addRequested, this, &MeasurePage::addRequested);
    connect(m_save, &QPushButton::clicked, this, &MeasurePage::saveRequested);
    connect(m_views, &FileViews::mappingChosen, m_files, &MeasurementFiles::mapColumns);
    connect(m_files, &MeasurementFiles::currentChanged, this,
        [this] { m_views->show(m_files->currentFile(), m_files->currentReading()); });
    connect(&m_record, &RecordModel::opened, this, [this] { m_isCapturingForRecord = false; });
    connect(&m_record, &RecordModel::changed, this, [this] {
        m_saved.reset();
        m_capturedForAnother.clear();
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
    m_save->setText(tr("&Save as Runs…"));
    m_save->setToolTip(tr("All files as one CSV file, with what is excluded marked in it"));
    m_save->setAccessibleDescription(m_save->toolTip());
    m_files->setTitle(tr("Files"), tr("Files of the measurement"));
    m_views->setTabText(m_views->indexOf(m_values), tr("Values of all files"));
    m_views->retranslate();
    m_files->retranslate();
    m_values->retranslate();
    if (m_capturePanel) {
        m_views->setTabText(m_views->indexOf(m_captureView), tr("Capture"));
        m_capturePanel->retranslate();
    }
    showMeasuring();
    follow();
}

void MeasurePage::follow()
{
    const RecordState& state = m_record.state();
    const bool hasTargets = state.measurement && state.measurement->hasTargets();
    m_save->setEnabled(hasTargets && !m_record.isEvaluating());
    m_views->setTabVisible(m_views->indexOf(m_values), hasTargets);
    sayNextStep();
}

void MeasurePage::sayNextStep()
{
    const RecordState& state = m_record.state();
    const auto refused = std::ranges::find_if(
        state.files, [](const ReadMeasurement& file) { return file.refusal.has_value(); });
    if (!m_capturedForAnother.isEmpty())
        m_nextStep->say(Tone::Warning,
            tr("%1 was captured for the record that was open before, and is not added to this one.")
                .arg(m_capturedForAnother));
    else if (m_record.record().files.empty())
        m_nextStep->say(Tone::Information,
            tr("Add the files of a measurement, take its values with Capture, or go on to Write "
               "with a table that is there."));
    else if (m_record.isEvaluating() && !m_record.isMeasurementShown())
        m_nextStep->say(Tone::Information, tr("The files are being read …"));
    else if (refused != state.files.end())
        m_nextStep->say(Tone::Error, errorText(*refused->refusal));
    else if (state.refusal)
        m_nextStep->say(Tone::Error, errorText(*state.refusal));
    else if (m_saved && m_saved == state.measurement && !m_record.isEvaluating())
        m_nextStep->say(Tone::Success,
            state.record.corrections == CorrectionsBefore{}
                ? tr("Saved as %1. Judge says what it is worth, and Fit makes a table of it.")
                      .arg(m_savedName)
                : tr("Saved as %1 with the values of the files: the corrections are not in it.")
                      .arg(m_savedName));
    else if (!state.measurement->hasTargets())
        m_nextStep->say(Tone::Information,
            tr("Without targets there are no figures of ISO 230-2; Fit makes a table of it."));
    else
        m_nextStep->say(Tone::Success, tr("The measurement can be used. Go on to Judge and Fit."));
}

void MeasurePage::showSaved(
    const QString& path, const std::shared_ptr<const Measurement>& measurement)
{
    m_saved = measurement;
    m_savedName = QFileInfo(path).fileName();
    sayNextStep();
}

} // namespace axiscomp::ui
