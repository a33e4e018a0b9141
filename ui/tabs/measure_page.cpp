// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tabs/measure_page.h"

#include "ui/record/record_model.h"
#include "ui/style/symbols.h"
#include "ui/tabs/file_views.h"
#include "ui/tabs/measurement_files.h"
#include "ui/tabs/next_step.h"
#include "ui/tabs/run_values_view.h"
#include "ui/text/message_text.h"

#include <QBoxLayout>
#include <QFileInfo>
#include <QPushButton>
#include <QSplitter>

#include <algorithm>

namespace axiscomp::ui {

MeasurePage::MeasurePage(RecordModel& record, QWidget* parent)
    : QWidget(parent)
    , m_record(record)
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
    m_save->setObjectName(QStringLiteral("saveMeasurement"));
    m_save->setIcon(symbolIcon(Symbol::Save));
    auto* left = new QWidget;
    auto* layout = new QVBoxLayout(left);
    layout->setContentsMargins(0, 0, gap, 0);
    layout->addWidget(m_files, 1);
    layout->addWidget(m_save);
    layout->addWidget(m_nextStep);
    return left;
}

void MeasurePage::connectParts()
{
    connect(m_files, &MeasurementFiles::addRequested, this, &MeasurePage::addRequested);
    connect(m_save, &QPushButton::clicked, this, &MeasurePage::saveRequested);
    connect(m_views, &FileViews::mappingChosen, m_files, &MeasurementFiles::mapColumns);
    connect(m_files, &MeasurementFiles::currentChanged, this,
        [this] { m_views->show(m_files->currentFile(), m_files->currentReading()); });
    connect(&m_record, &RecordModel::changed, this, [this] {
        m_saved.reset();
        follow();
    });
    connect(&m_record, &RecordModel::stateChanged, this, &MeasurePage::follow);
}

void MeasurePage::retranslate()
{
    m_save->setText(tr("&Save as Runs…"));
    m_save->setToolTip(tr("All files as one CSV file, with what is excluded marked in it"));
    m_save->setAccessibleDescription(m_save->toolTip());
    m_files->setTitle(tr("Files"), tr("Files of the measurement"));
    m_views->setTabText(m_views->indexOf(m_values), tr("Values of all files"));
    m_views->retranslate();
    m_files->retranslate();
    m_values->retranslate();
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
    if (m_record.record().files.empty())
        m_nextStep->say(Tone::Information,
            tr("Add the files of a measurement, or go on to Write with a table that is there."));
    else if (m_record.isEvaluating() && !m_record.isMeasurementShown())
        m_nextStep->say(Tone::Information, tr("The files are being read …"));
    else if (refused != state.files.end())
        m_nextStep->say(Tone::Error, errorText(*refused->refusal));
    else if (state.refusal)
        m_nextStep->say(Tone::Error, errorText(*state.refusal));
    else if (m_saved && m_saved == state.measurement && !m_record.isEvaluating())
        m_nextStep->say(Tone::Success,
            tr("Saved as %1. Judge says what it is worth; the command axiscomp fit makes a table "
               "of "
               "it for Write.")
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
