// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/measuring/capture_dialog.h"
#include "ui/measuring/capture_feed.h"

#include <QObject>
#include <QPointer>

#include <memory>

namespace axiscomp::ui {

class FileActions;
class PlanDialog;
class WizardSettings;

/// Planning a measurement and taking its values, from the page: the dialogs, and what they hand to
/// each other.
class MeasuringActions : public QObject {
    Q_OBJECT

public:
    /// All references must outlive this; window is what dialogs belong to.
    MeasuringActions(WizardController& controller, const WizardOptions& options,
        const FileActions& files, const WizardSettings& settings, QWidget& window);

    [[nodiscard]] CaptureFeed& feed() { return m_feed; }
    void planMeasurement();
    /// Asks what is to be captured; what the feed does follows.
    void captureValues();
    /// Why values cannot be captured now, a translated sentence; empty: they can.
    [[nodiscard]] QString captureObstacle() const;

Q_SIGNALS:
    void captureObstacleChanged();

private:
    [[nodiscard]] QString folder() const;

    WizardController& m_controller;
    const FileActions& m_files;
    const WizardSettings& m_settings;
    QWidget& m_window;
    bool m_hasSerial;
    CaptureFeed m_feed;
    CaptureChoices m_choices; ///< for the next capture
    QString m_folder; ///< of the last file; empty: none was chosen yet
    QPointer<PlanDialog> m_plan;
    QPointer<CaptureDialog> m_capture;
};

} // namespace axiscomp::ui
