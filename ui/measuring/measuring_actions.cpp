// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measuring/measuring_actions.h"

#include "ui/controller/wizard_controller.h"
#include "ui/controller/wizard_settings.h"
#include "ui/measuring/plan_dialog.h"
#include "ui/page/file_actions.h"

#include <QFileInfo>

namespace axiscomp::ui {

MeasuringActions::MeasuringActions(WizardController& controller, const WizardOptions& options,
    const FileActions& files, const WizardSettings& settings, QWidget& window)
    : m_controller(controller)
    , m_files(files)
    , m_settings(settings)
    , m_window(window)
    , m_hasSerial(static_cast<bool>(options.instrumentFactory))
    , m_feed(controller, options)
{
    for (const auto changed : {&WizardController::currentAxisChanged,
             &WizardController::axesChanged, &WizardController::statusChanged})
        connect(&controller, changed, this, &MeasuringActions::captureObstacleChanged);
    connect(&m_feed, &CaptureFeed::begun, this, &MeasuringActions::captureObstacleChanged);
    connect(&m_feed, &CaptureFeed::finished, this, &MeasuringActions::captureObstacleChanged);
}

QString MeasuringActions::folder() const
{
    return m_folder.isEmpty() ? m_settings.folder() : m_folder;
}

void MeasuringActions::planMeasurement()
{
    if (m_plan)
        return m_plan->raise();
    const AxisInfo axis = m_controller.status() ? m_controller.status()->axis : AxisInfo();
    m_plan = new PlanDialog(measuredAxis(axis), m_files.picker(), folder(), &m_window);
    connect(m_plan, &PlanDialog::saved, this,
        [this](
            const QString& path, const std::shared_ptr<const MeasuringPlan>& plan, bool isProgram) {
            m_folder = QFileInfo(path).absolutePath();
            const bool isSame = m_choices.plan && *m_choices.plan == *plan;
            if (isProgram && isSame)
                return; // it may be in a file of its own
            m_choices.plan = plan;
            m_choices.planPath = isProgram ? QString() : path;
            if (!isSame)
                m_choices.valuesPath.clear();
        });
    m_plan->open();
}

QString MeasuringActions::captureObstacle() const
{
    if (m_feed.isActive())
        return tr("Values are being captured: stop that first");
    if (m_controller.currentAxis() < 0 || !m_controller.status())
        return tr("Choose a drive and an axis first");
    return {};
}

void MeasuringActions::captureValues()
{
    if (m_capture || !captureObstacle().isEmpty())
        return;
    m_capture = new CaptureDialog(
        m_controller, m_feed, m_choices, m_files.picker(), folder(), m_hasSerial, &m_window);
    connect(m_capture, &CaptureDialog::begun, this, [this](const CaptureChoices& choices) {
        m_choices = choices;
        m_folder = QFileInfo(choices.valuesPath).absolutePath();
    });
    m_capture->open();
}

} // namespace axiscomp::ui
