// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_request.h"
#include "ui/controller/wizard_options.h"
#include "ui/session/drive_connection.h"

#include <QObject>
#include <QPointer>
#include <QTimer>

#include <memory>
#include <optional>
#include <stop_token>
#include <vector>

namespace axiscomp::ui {

class WizardController;

/// What is known of a capture.
struct CaptureView {
    enum class Phase {
        None, ///< there is no capture
        Opening,
        Running,
        Paused,
        Ended, ///< its values can still be looked at
    };
    Phase phase = Phase::None;
    QString axisLabel;
    QString path; ///< of the file of the values
    std::shared_ptr<const MeasuringPlan> plan; ///< null before Running
    std::string compensation; ///< "off", "crc:1c291ca3"
    std::string reference; ///< as the file has it
    bool isTyped = false; ///< the reference is typed by a person
    std::string unit; ///< of what is typed
    ReferenceScale scale;
    int readingsPerValue = 1;
    bool isUnitAssumed = false; ///< of the axis
    bool isClockBehind = false;
    std::optional<FarthestResolution> resolution; ///< of a reference that is a Single

    // Of the last reading
    std::optional<CaptureReading> reading;
    CaptureSession::Event event = CaptureSession::Event::Moving;
    Text problem; ///< of Refused, NoReference and Stopped
    std::size_t averaged = 0;
    bool isTaken = false; ///< the axis still stands where it gave its last value
    bool isAsked = false; ///< a typed position is waited for
    bool isDoubted = false; ///< the one that was typed is to be typed once more
    Text typedProblem; ///< of what was typed last
    std::vector<CapturedValue> values; ///< that are in the file, in the order of the plan

    // What keeps it from reading
    std::optional<Error> lost; ///< the drive does not answer; it goes on when it does
    bool isWaiting = false; ///< the window does something else on the drive
    std::optional<Error> refusal; ///< why it ended; none: it is complete, or was stopped
    Text stopReason; ///< of an end that the axis caused

    [[nodiscard]] bool isComplete() const { return plan && values.size() == plan->steps.size(); }
};

/// Takes the values of a plan on the thread of a drive's session, reading by reading, between the
/// other things that the window does on that drive: while an operation runs, and while the drive is
/// lost, nothing is read. Goes on with its drive and axis whichever is current.
class CaptureFeed : public QObject {
    Q_OBJECT

public:
    /// controller must outlive the feed.
    CaptureFeed(WizardController& controller, const WizardOptions& options);
    ~CaptureFeed() override;

    [[nodiscard]] const CaptureView& view() const { return m_view; }
    /// A file is being written.
    [[nodiscard]] bool isActive() const;

    /// Of an axis of the current drive, when isActive() is not. serial: of a reference on a serial
    /// port. begun() or refused() follows.
    void begin(int axis, const QString& axisLabel, CaptureRequest request,
        SerialInstrumentRequest serial = {});
    void pause();
    void resume();
    /// The file stays; finished() follows.
    void stop();
    void undo();
    /// A position that the person has read, with a decimal point.
    void type(const QString& text);

Q_SIGNALS:
    void changed(); ///< view()
    void begun();
    void refused(const axiscomp::Error& error);
    /// The file is closed.
    void finished(const QString& path);

private:
    struct Run;
    struct Step;
    struct Opened;
    struct Orders;

    void opened(const Result<Opened>& opened);
    void tick();
    void read(const Orders& orders);
    void fail(const Error& error);
    void follow(const Step& step);
    void lose(const Error& error);
    void end(const std::optional<Error>& refusal, const Text& reason = {});
    void release();
    /// finished() follows, unless path is empty.
    void close(std::shared_ptr<Run> run, const QString& path);
    void followBusy();
    [[nodiscard]] bool isDriveBusy() const;

    WizardController& m_controller;
    const WizardOptions m_options;
    CaptureView m_view;
    QPointer<DriveConnection> m_connection;
    std::shared_ptr<Run> m_run; ///< used and destroyed on the session's thread
    std::stop_source m_stop;
    bool m_isUnderWay = false; ///< a reading
    int m_number = 0; ///< of the capture: answers to an earlier one do not count
    std::optional<std::string> m_typed; ///< for the next reading
    bool m_mustUndo = false;
    QTimer m_timer;
};

} // namespace axiscomp::ui
