// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measuring/capture_feed.h"

#include "ui/async/background_job.h"
#include "ui/controller/wizard_controller.h"

#include <utility>

namespace axiscomp::ui {

/// What readings are made with. It is emptied on the session's thread, so that it does not matter
/// who keeps it longest.
struct CaptureFeed::Run {
    std::optional<CaptureRun> capture;
    std::optional<CaptureClock> clock;
};

struct CaptureFeed::Opened {
    std::shared_ptr<Run> run;
    std::shared_ptr<const MeasuringPlan> plan;
    std::vector<CapturedValue> values;
    std::string compensation;
    std::string reference;
    bool isUnitAssumed = false;
    bool isClockBehind = false;
    std::optional<FarthestResolution> resolution;
};

/// What a person has asked for since the last reading.
struct CaptureFeed::Orders {
    bool reads = true;
    bool undoes = false;
    std::optional<std::string> typed;
};

struct CaptureFeed::Step {
    bool hasRead = false;
    CaptureNews news;
    CaptureReading reading;
    CaptureSession::Event event = CaptureSession::Event::Moving;
    Text problem;
    std::size_t averaged = 0;
    bool isTaken = false;
    bool isLost = false;
    bool isAsked = false;
    bool isDoubted = false;
    std::optional<Text> typedProblem; ///< none: nothing was typed
    std::optional<Error> undoProblem;
    std::optional<Error> readProblem;
    std::optional<std::vector<CapturedValue>> values; ///< none: as they were
};

namespace {

OperationOptions quiet(OperationOptions options)
{
    options.progress = {};
    return options;
}

} // namespace

CaptureFeed::CaptureFeed(WizardController& controller, const WizardOptions& options)
    : m_controller(controller)
    , m_options(options)
{
    m_timer.setInterval(options.captureInterval);
    connect(&m_timer, &QTimer::timeout, this, &CaptureFeed::tick);
    connect(&controller, &WizardController::busyChanged, this, &CaptureFeed::followBusy);
    connect(&controller, &WizardController::drivesChanged, this, &CaptureFeed::followBusy);
}

CaptureFeed::~CaptureFeed()
{
    m_stop.request_stop();
    disconnect(this, nullptr, nullptr, nullptr);
    release();
}

bool CaptureFeed::isActive() const
{
    return m_view.phase == CaptureView::Phase::Opening
        || m_view.phase == CaptureView::Phase::Running
        || m_view.phase == CaptureView::Phase::Paused;
}

void CaptureFeed::begin(
    int axis, const QString& axisLabel, CaptureRequest request, SerialInstrumentRequest serial)
{
    DriveConnection* connection = m_controller.connection();
    if (isActive() || !connection)
        return;
    const QString path = QString::fromStdString(request.file.string());
    const bool isTyped = request.reference.kind == CaptureReference::Kind::Typed;
    const std::string usualUnit = request.plan.isAngular ? "deg" : "mm";
    m_view = {};
    m_view.phase = CaptureView::Phase::Opening;
    m_view.axisLabel = axisLabel;
    m_view.path = path;
    m_view.isTyped = isTyped;
    m_view.scale = request.reference.scale;
    m_view.unit = m_view.scale.unit.empty() ? usualUnit : m_view.scale.unit;
    m_view.readingsPerValue = request.rules.readings;
    m_connection = connection;
    m_stop = std::stop_source();
    m_isUnderWay = false;
    m_typed.reset();
    m_mustUndo = false;
    request.openInstrument = [factory = m_options.instrumentFactory, serial = std::move(serial),
                                 scale = request.reference.scale,
                                 isAngular = request.plan.isAngular,
                                 dwell = request.rules.dwell]() -> Result<Instrument> {
        return factory(serial, scale, isAngular, dwell);
    };
    connect(&connection->session(), &DriveSession::closing, this, [this, number = m_number + 1] {
        if (number == m_number && isActive())
            end(Error{ErrorCode::NotConnected,
                {{"endpoint", Verbatim{m_view.axisLabel.toStdString()}},
                    {"reason", AXISCOMP_TEXT("Error", "the connection was removed")}},
                {}});
    });
    const auto open = [axis, request = std::move(request), steady = m_options.captureClock](
                          AxisCompensator& compensator,
                          const OperationOptions& options) -> Result<Opened> {
        AXISCOMP_TRY(auto run, compensator.beginCapture(axis, request, quiet(options)));
        Opened opened;
        opened.plan = std::make_shared<const MeasuringPlan>(run.plan());
        opened.values.assign(run.values().begin(), run.values().end());
        opened.compensation = run.readings().state();
        opened.reference = run.reference();
        opened.isUnitAssumed = run.readings().isUnitAssumed();
        opened.resolution = farthestResolution(run.readings(), run.plan());
        CaptureClock clock(
            opened.values, std::chrono::system_clock::now().time_since_epoch(), steady);
        opened.isClockBehind = clock.isBehind();
        opened.run = std::make_shared<Run>();
        opened.run->capture.emplace(std::move(run));
        opened.run->clock.emplace(std::move(clock));
        return opened;
    };
    whenDone(connection->session().run<Opened>(open, m_stop.get_token()), this,
        [this, number = ++m_number](const Result<Opened>& opened) {
            if (number == m_number && m_view.phase == CaptureView::Phase::Opening)
                this->opened(opened);
            else if (opened)
                close(opened->run, {}); // it was stopped before
        });
    Q_EMIT changed();
}

void CaptureFeed::opened(const Result<Opened>& opened)
{
    if (!opened) {
        m_view = {};
        m_connection = nullptr;
        Q_EMIT changed();
        Q_EMIT refused(opened.error());
        return;
    }
    m_run = opened->run;
    m_view.plan = opened->plan;
    m_view.values = opened->values;
    m_view.compensation = opened->compensation;
    m_view.reference = opened->reference;
    m_view.isUnitAssumed = opened->isUnitAssumed;
    m_view.isClockBehind = opened->isClockBehind;
    m_view.resolution = opened->resolution;
    m_view.phase = CaptureView::Phase::Running;
    Q_EMIT begun();
    if (m_view.isComplete())
        return end({});
    m_timer.start();
    Q_EMIT changed();
}

bool CaptureFeed::isDriveBusy() const
{
    return m_controller.busy().isBusy && m_controller.connection() == m_connection;
}

/// What somebody waits for goes first; a reading that is under way is given up for it.
void CaptureFeed::followBusy()
{
    if (!isActive() || !m_run)
        return;
    const bool isWaiting = isDriveBusy();
    if (isWaiting && !m_view.isWaiting)
        m_stop.request_stop();
    m_view.isWaiting = isWaiting;
    // While nothing is read nobody else would say that the drive is there again.
    if (m_connection && m_connection->isConnected())
        m_view.lost.reset();
    else if (m_connection && m_connection->problem() && !m_view.lost)
        m_view.lost = m_connection->problem();
    Q_EMIT changed();
}

void CaptureFeed::tick()
{
    const bool isPossible = isActive() && m_run && !m_isUnderWay && m_connection
        && m_connection->isConnected() && !isDriveBusy();
    if (!isPossible)
        return;
    Orders orders;
    orders.reads = m_view.phase == CaptureView::Phase::Running;
    if (!orders.reads && !m_mustUndo)
        return;
    orders.undoes = std::exchange(m_mustUndo, false);
    if (orders.reads)
        orders.typed = std::exchange(m_typed, std::nullopt);
    read(orders);
}

void CaptureFeed::read(const Orders& orders)
{
    m_isUnderWay = true;
    m_stop = std::stop_source();
    const auto operation = [run = m_run, orders](AxisCompensator& compensator,
                               const OperationOptions& options) -> Result<Step> {
        Step step;
        CaptureRun& capture = *run->capture;
        const std::size_t before = capture.taken();
        if (orders.undoes)
            if (auto undone = capture.undo(); !undone)
                step.undoProblem = std::move(undone).error();
        if (orders.typed)
            step.typedProblem = capture.type(*orders.typed);
        if (orders.reads) {
            auto news = compensator.readCapture(
                capture, [&] { return run->clock->now(); }, quiet(options));
            step.hasRead = news && !capture.isLost();
            if (news)
                step.news = *std::move(news);
            else
                step.readProblem = std::move(news).error();
        }
        step.reading = capture.lastReading();
        step.event = capture.lastEvent();
        step.problem = capture.lastProblem();
        step.averaged = capture.averaged();
        step.isTaken = capture.isTaken();
        step.isLost = capture.isLost();
        step.isAsked = capture.isAsked();
        step.isDoubted = capture.isDoubted();
        if (orders.undoes || capture.taken() != before)
            step.values.emplace(capture.values().begin(), capture.values().end());
        return step;
    };
    whenDone(m_connection->session().run<Step>(operation, m_stop.get_token()), this,
        [this, orders, number = m_number](const Result<Step>& step) {
            if (number != m_number)
                return;
            m_isUnderWay = false;
            if (step)
                return follow(*step);
            // Nothing of it was carried out: there was no link.
            m_mustUndo = m_mustUndo || orders.undoes;
            if (!m_typed)
                m_typed = orders.typed;
            fail(step.error());
        });
}

void CaptureFeed::fail(const Error& error)
{
    // It was given up for something that somebody waits for.
    if (error.code == ErrorCode::Cancelled)
        return;
    if (isUnreachable(error.code))
        return lose(error);
    end(error);
}

void CaptureFeed::follow(const Step& step)
{
    if (step.values)
        m_view.values = *step.values;
    if (step.typedProblem)
        m_view.typedProblem = *step.typedProblem;
    m_view.isAsked = step.isAsked;
    m_view.isDoubted = step.isDoubted;
    if (step.undoProblem)
        return end(step.undoProblem);
    if (step.readProblem)
        fail(*step.readProblem);
    else if (step.news.error)
        lose(*step.news.error);
    if (!isActive())
        return;
    if (step.hasRead) {
        m_view.lost.reset();
        m_view.reading = step.reading;
        m_view.event = step.event;
        m_view.problem = step.problem;
        m_view.averaged = step.averaged;
        m_view.isTaken = step.isTaken;
        if (!step.isAsked && step.event == CaptureSession::Event::Moving)
            m_view.typedProblem = {};
    }
    if (step.news.kind == CaptureNews::Kind::Stopped)
        return end({}, step.news.text);
    if (step.news.kind == CaptureNews::Kind::Done)
        return end({});
    Q_EMIT changed();
}

void CaptureFeed::lose(const Error& error)
{
    if (m_view.lost)
        return;
    m_view.lost = error;
    if (m_connection)
        m_connection->lose(error);
    Q_EMIT changed();
}

void CaptureFeed::pause()
{
    if (m_view.phase != CaptureView::Phase::Running)
        return;
    m_view.phase = CaptureView::Phase::Paused;
    m_view.isAsked = false;
    m_view.typedProblem = {};
    m_typed.reset();
    Q_EMIT changed();
}

void CaptureFeed::resume()
{
    if (m_view.phase != CaptureView::Phase::Paused)
        return;
    m_view.phase = CaptureView::Phase::Running;
    Q_EMIT changed();
    tick();
}

void CaptureFeed::stop()
{
    if (!isActive())
        return;
    m_stop.request_stop();
    end({});
}

void CaptureFeed::undo()
{
    if (!isActive() || m_view.values.empty())
        return;
    m_mustUndo = true;
    tick();
}

void CaptureFeed::type(const QString& text)
{
    if (m_view.phase != CaptureView::Phase::Running)
        return;
    m_typed = text.toStdString();
    tick();
}

void CaptureFeed::end(const std::optional<Error>& refusal, const Text& reason)
{
    m_timer.stop();
    if (m_view.phase == CaptureView::Phase::Opening) {
        ++m_number;
        m_view = {};
        Q_EMIT changed();
        Q_EMIT refused(refusal.value_or(Error{ErrorCode::Cancelled, {}, {}}));
        return;
    }
    m_view.phase = CaptureView::Phase::Ended;
    m_view.refusal = refusal;
    m_view.stopReason = reason;
    m_view.isAsked = false;
    m_view.isWaiting = false;
    Q_EMIT changed();
    release();
}

void CaptureFeed::release()
{
    ++m_number;
    if (m_run)
        close(std::exchange(m_run, nullptr), m_view.path);
}

/// The file is closed, and a serial port, on the session's thread behind what is under way there;
/// when the session ends, by what is destroyed with it.
void CaptureFeed::close(std::shared_ptr<Run> run, const QString& path)
{
    if (!m_connection)
        return;
    const auto empty = [run = std::move(run)](AxisCompensator&, const OperationOptions&) {
        run->capture.reset();
        return Result<bool>(true);
    };
    auto* watcher = new QFutureWatcher<Result<bool>>(this);
    connect(watcher, &QFutureWatcherBase::finished, this, [this, watcher, path] {
        watcher->deleteLater();
        if (!path.isEmpty())
            Q_EMIT finished(path);
    });
    watcher->setFuture(m_connection->session().run<bool>(empty));
}

} // namespace axiscomp::ui
