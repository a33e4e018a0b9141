// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/session/drive_session.h"

#include "core/drive/loss_tracking_link.h"
#include "ui/async/progress_relay.h"
#include "ui/text/endpoint_text.h"

#include <QTemporaryDir>
#include <QThread>

#include <mutex>

namespace axiscomp::ui {

namespace {

/// What both threads see.
struct Shared {
    std::atomic<bool> isEnding = false;
    std::mutex mutex;
    std::stop_source running{std::nostopstate}; ///< of the operation that runs now

    void stopRunning()
    {
        std::stop_source operation{std::nostopstate};
        {
            const std::lock_guard lock(mutex);
            operation = running;
        }
        operation.request_stop();
    }

    /// False: the session is ending, do not begin.
    [[nodiscard]] bool begin(const std::stop_source& operation)
    {
        const std::lock_guard lock(mutex);
        running = operation;
        return !isEnding;
    }

    void end()
    {
        const std::lock_guard lock(mutex);
        running = std::stop_source{std::nostopstate};
    }
};

} // namespace

/// Lives on the session's thread and owns everything that talks to the drive.
class DriveSession::Worker : public QObject {
public:
    Worker(std::shared_ptr<Shared> shared, ProgressRelay& relay, std::string endpoint,
        LinkFactory factory, const DriveProfile& profile, const std::filesystem::path& storeRoot,
        std::chrono::milliseconds timeout)
        : m_shared(std::move(shared))
        , m_relay(relay)
        , m_endpoint(std::move(endpoint))
        , m_factory(std::move(factory))
        , m_profile(profile)
        , m_store(storeRoot)
        , m_timeout(timeout)
    {
    }

    void run(const Job& job, const std::stop_token& stop)
    {
        std::stop_source operation;
        if (!m_shared->begin(operation))
            return; // its promise dies with it: the future ends as cancelled
        {
            const std::stop_callback forward(stop, [&operation] { operation.request_stop(); });
            OperationOptions options;
            options.timeout = m_timeout;
            options.stop = operation.get_token();
            options.progress = [this](const Progress& progress) {
                m_relay.report(QString::fromStdString(progress.step), progress.fraction);
            };
            m_relay.clear();
            job(compensator(), options);
            m_relay.clear();
        }
        m_shared->end();
        if (m_link && m_link->isLost()) {
            m_compensator.reset();
            m_link.reset();
        }
    }

private:
    [[nodiscard]] Result<AxisCompensator*> compensator()
    {
        if (m_compensator)
            return m_compensator.get();
        AXISCOMP_TRY(auto link, m_factory(m_endpoint));
        m_link = std::make_unique<GuardedLink>(std::move(link), m_shared->isEnding);
        m_compensator = std::make_unique<AxisCompensator>(*m_link, m_profile, m_store);
        return m_compensator.get();
    }

    std::shared_ptr<Shared> m_shared;
    ProgressRelay& m_relay;
    std::string m_endpoint;
    LinkFactory m_factory;
    const DriveProfile& m_profile;
    DriveStore m_store;
    std::chrono::milliseconds m_timeout;
    std::unique_ptr<GuardedLink> m_link;
    std::unique_ptr<AxisCompensator> m_compensator;
};

struct DriveSession::Private {
    QString endpoint;
    std::unique_ptr<QTemporaryDir> demoStore;
    std::filesystem::path storeRoot;
    std::shared_ptr<Shared> shared = std::make_shared<Shared>();
    ProgressRelay relay;
    Worker* worker = nullptr; ///< deletes itself on its thread, when that ends
    QThread thread;
};

DriveSession::DriveSession(QString endpoint, LinkFactory factory, const DriveProfile& profile,
    std::filesystem::path storeRoot, std::chrono::milliseconds timeout, QObject* parent)
    : QObject(parent)
    , d(new Private)
{
    d->endpoint = endpoint.trimmed();
    d->storeRoot = std::move(storeRoot);
    if (isDemo()) {
        d->demoStore = std::make_unique<QTemporaryDir>();
        d->storeRoot = d->demoStore->path().toStdString();
    }
    d->worker = new Worker(d->shared, d->relay, d->endpoint.toStdString(), std::move(factory),
        profile, d->storeRoot, timeout);
    d->worker->moveToThread(&d->thread);
    connect(&d->thread, &QThread::finished, d->worker, &QObject::deleteLater);
    connect(&d->thread, &QThread::finished, this, &DriveSession::closed);
    connect(&d->relay, &ProgressRelay::progressed, this, &DriveSession::progressed);
    d->thread.setObjectName(QStringLiteral("drive session"));
    d->thread.start();
}

DriveSession::~DriveSession()
{
    close();
    d->thread.wait();
}

QString DriveSession::endpoint() const
{
    return shownEndpoint(d->endpoint);
}

bool DriveSession::isDemo() const
{
    return isDemoEndpoint(d->endpoint);
}

std::filesystem::path DriveSession::storeRoot() const
{
    return d->storeRoot;
}

void DriveSession::post(Job job, std::stop_token stop)
{
    if (d->shared->isEnding)
        return;
    QMetaObject::invokeMethod(
        d->worker,
        [worker = d->worker, job = std::move(job), stop = std::move(stop)] {
            worker->run(job, stop);
        },
        Qt::QueuedConnection);
}

void DriveSession::stop()
{
    d->shared->stopRunning();
}

void DriveSession::close()
{
    if (!d->shared->isEnding)
        Q_EMIT closing();
    d->shared->isEnding = true;
    d->shared->stopRunning();
    d->thread.quit();
}

bool DriveSession::isClosed() const
{
    return d->thread.isFinished();
}

} // namespace axiscomp::ui
