// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/dialogs/export_configuration_dialog.h"

#include "core/drive/drive_profile.h"
#include "ui/dialogs/multi_axis_plan_view.h"
#include "ui/dialogs/row_list.h"
#include "ui/dialogs/several_writes_dialog.h"
#include "ui/dialogs/station_choice.h"
#include "ui/outcome/multi_axis_outcome.h"
#include "ui/style/busy_mark.h"
#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"
#include "ui/style/tone_label.h"
#include "ui/text/message_text.h"

#include <QBoxLayout>
#include <QEvent>
#include <QFileInfo>
#include <QHeaderView>
#include <QLabel>
#include <QPushButton>

#include <algorithm>

namespace axiscomp::ui {

namespace {

enum ParameterColumn {
    ParameterAxisColumn,
    ParameterSlotColumn,
    SourcesColumn,
    ParameterColumnCount
};

/// With the paths of those that the drive offers as sources.
std::vector<DimSource> namedSources(
    const AxisParameters& axis, const std::vector<DimSource>& shortlist)
{
    std::vector<DimSource> sources;
    for (const std::uint32_t address : axis.sources) {
        const auto known = std::ranges::find(shortlist, address, &DimSource::address);
        sources.push_back(known == shortlist.end() ? DimSource{address, {}} : *known);
    }
    return sources;
}

} // namespace

ExportConfigurationDialog::ExportConfigurationDialog(
    WizardController& controller, const DriveProfile& profile, QString path, QWidget* parent)
    : QDialog(parent)
    , m_controller(controller)
    , m_profile(profile)
    , m_path(std::move(path))
    , m_axes(controller.usableAxes())
    , m_job([this](const Result<std::string>& text) {
        m_text = text;
        showState();
    })
    , m_introduction(wrappedLabel("exportConfigurationIntroduction"))
    , m_station(new StationChoice(m_path, StationChoice::Direction::ToFile, m_axes.front()))
    , m_title(new PlainLabel)
    , m_rows(new RowList("parameterRows", ParameterColumnCount))
    , m_busy(new BusyMark)
    , m_reason(wrappedLabel("exportConfigurationReason"))
    , m_save(new QPushButton)
    , m_cancel(new QPushButton)
{
    setObjectName(QStringLiteral("exportConfigurationDialog"));
    setAttribute(Qt::WA_DeleteOnClose);
    build();
    follow();
    readDrive();
    retranslate();
}

ExportConfigurationDialog::~ExportConfigurationDialog()
{
    m_controller.dropParameters();
}

void ExportConfigurationDialog::build()
{
    QFont titleFont = m_title->font();
    titleFont.setBold(true);
    m_title->setFont(titleFont);
    m_rows->horizontalHeader()->setSectionResizeMode(
        ParameterAxisColumn, QHeaderView::ResizeToContents);
    m_rows->horizontalHeader()->setSectionResizeMode(
        ParameterSlotColumn, QHeaderView::ResizeToContents);
    m_save->setObjectName(QStringLiteral("saveConfigurationButton"));
    m_save->setDefault(true);
    m_cancel->setObjectName(QStringLiteral("cancelConfigurationButton"));
    m_cancel->setAutoDefault(false);
    auto* state = new QHBoxLayout;
    state->addWidget(m_reason, 1);
    state->addWidget(m_busy);
    auto* buttons = new QHBoxLayout;
    buttons->addStretch(1);
    buttons->addWidget(m_save);
    buttons->addWidget(m_cancel);
    auto* layout = new QVBoxLayout(this);
    layout->setSpacing(10);
    layout->addWidget(m_introduction);
    layout->addWidget(m_station);
    layout->addWidget(m_title);
    layout->addWidget(m_rows, 1);
    layout->addLayout(state);
    layout->addLayout(buttons);
    resize(760, 480);
}

void ExportConfigurationDialog::follow()
{
    using Dialog = ExportConfigurationDialog;
    connect(m_station, &StationChoice::changed, this, &Dialog::compute);
    connect(m_save, &QPushButton::clicked, this, &QDialog::accept);
    connect(m_cancel, &QPushButton::clicked, this, &QDialog::reject);
    connect(this, &QDialog::accepted, this,
        [this] { Q_EMIT chosen(m_station->configuration(), **m_text); });
    connect(&m_controller, &WizardController::parametersRead, this, &Dialog::takeParameters);
    connect(&m_controller, &WizardController::actionsChanged, this, &Dialog::readAgain);
    for (const auto changed :
        {&WizardController::currentAxisChanged, &WizardController::axesChanged})
        connect(&m_controller, changed, this, &Dialog::leaveLostDrive);
}

void ExportConfigurationDialog::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    QDialog::changeEvent(event);
}

void ExportConfigurationDialog::retranslate()
{
    setWindowTitle(tr("Export to TAM Configuration"));
    m_introduction->setText(
        tr("Puts the table and source parameters of %1 into %2. Everything else in the file stays "
           "as it is; nothing on the drive changes.")
            .arg(m_axes.front().driveName, QFileInfo(m_path).fileName()));
    m_station->retranslate();
    m_title->setText(tr("What the drive has"));
    m_rows->setAccessibleName(m_title->text());
    m_rows->setHorizontalHeaderLabels({tr("Axis"), tr("Slot"), tr("Sources")});
    m_save->setText(tr("&Save As…"));
    m_cancel->setText(tr("&Cancel"));
    m_cancel->setToolTip(tr("Change nothing and go back (Esc)"));
    m_cancel->setAccessibleDescription(m_cancel->toolTip());
    showParameters();
    showState();
}

void ExportConfigurationDialog::readDrive()
{
    m_isAsked = m_controller.readParameters();
}

/// A drive that could not be read, or was not there, may be there again.
void ExportConfigurationDialog::readAgain()
{
    const auto& parameters = m_controller.parameters();
    const bool hasFailed = !m_isAsked || (parameters && !*parameters);
    if (hasFailed && m_controller.action(Action::ExportConfiguration).isEnabled)
        readDrive();
    showState();
}

void ExportConfigurationDialog::takeParameters()
{
    showParameters();
    compute();
}

void ExportConfigurationDialog::showParameters()
{
    m_rows->setRowCount(0);
    const auto& parameters = m_controller.parameters();
    if (!parameters || !*parameters)
        return;
    for (const AxisParameters& axis : (*parameters)->axes) {
        const auto sources = namedSources(axis, m_controller.sourceShortlist());
        m_rows->addRow({axisNameAmong(m_axes, axis.axis),
            axis.slot.empty() ? tr("no table") : QString::fromStdString(axis.slot),
            sourceLines(sources, m_axes).join(u'\n')});
    }
}

void ExportConfigurationDialog::compute()
{
    m_job.cancel();
    m_text.reset();
    const auto& parameters = m_controller.parameters();
    if (m_station->obstacle().isEmpty() && parameters && *parameters) {
        m_job.start([configuration = m_station->configuration(), station = m_station->station(),
                        parameters = **parameters, profile = m_profile](const std::stop_token&) {
            return withParameters(asText(configuration->bytes), configuration->stations.at(station),
                parameters, profile, configuration->fileName);
        });
    }
    showState();
}

/// The connection was removed, or leads to another drive.
void ExportConfigurationDialog::leaveLostDrive()
{
    if (!m_controller.isCurrentDrive(m_axes.front()))
        reject();
}

bool ExportConfigurationDialog::isSame() const
{
    return m_text && *m_text && **m_text == asText(m_station->configuration()->bytes);
}

bool ExportConfigurationDialog::isError() const
{
    const auto& parameters = m_controller.parameters();
    return m_station->hasFailed() || (parameters && !*parameters) || (m_text && !*m_text);
}

QString ExportConfigurationDialog::reason() const
{
    if (const QString obstacle = m_station->obstacle(); !obstacle.isEmpty())
        return obstacle;
    const auto& parameters = m_controller.parameters();
    if (!m_isAsked)
        return m_controller.action(Action::ExportConfiguration).reason;
    if (!parameters)
        return tr("The drive is being read …");
    if (!*parameters)
        return errorText(parameters->error());
    if (!m_text)
        return tr("Comparing …");
    if (!*m_text)
        return errorText(m_text->error());
    return isSame() ? tr("The configuration has all of this already.")
                    : tr("In the file, only Table and Dim1Source to Dim3Source of these axes "
                         "will change.");
}

void ExportConfigurationDialog::showState()
{
    const auto& parameters = m_controller.parameters();
    const bool isComputing =
        m_station->obstacle().isEmpty() && parameters && *parameters && !m_text;
    m_busy->setBusy(m_station->isReading() || (m_isAsked && !parameters) || isComputing);
    m_reason->setText(reason());
    m_reason->setTone(isError() ? std::optional(Tone::Error) : std::nullopt);
    m_save->setEnabled(m_text && *m_text && !isSame());
    m_save->setToolTip(
        m_save->isEnabled() ? tr("Choose where to save the configuration") : reason());
    m_save->setAccessibleDescription(m_save->toolTip());
}

} // namespace axiscomp::ui
