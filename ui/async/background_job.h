// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFuture>
#include <QFutureWatcher>
#include <QObject>
#include <QPromise>
#include <QThreadPool>

#include <functional>
#include <memory>
#include <optional>
#include <stop_token>
#include <utility>

namespace axiscomp::ui {

/// Computes something off the window's thread; watch the future with a context object. The function
/// refers to nothing that may go away.
template <typename T> [[nodiscard]] QFuture<T> inBackground(std::function<T()> function)
{
    auto promise = std::make_shared<QPromise<T>>();
    promise->start();
    QFuture<T> future = promise->future();
    QThreadPool::globalInstance()->start([promise, function = std::move(function)] {
        promise->addResult(function());
        promise->finish();
    });
    return future;
}

/// Gives back the memory of a value on another thread: of a million numbers that takes longer than
/// a picture may be late. Nobody else should have what it shares with others any more.
template <typename T> void letGo(T value)
{
    const auto held = std::make_shared<T>(std::move(value));
    static_cast<void>(inBackground<bool>([held] {
        *held = {};
        return true;
    }));
}

/// Calls handler(result) on the context's thread when the future has its result; not when it was
/// cancelled, and not after the context's end. Always from the event loop, never before this
/// returns, and in the order in which the futures ended: QFuture::then would call at once when the
/// future has already ended.
template <typename T, typename Handler>
void whenDone(const QFuture<T>& future, QObject* context, Handler handler)
{
    auto* watcher = new QFutureWatcher<T>(context);
    QObject::connect(watcher, &QFutureWatcherBase::finished, context,
        [watcher, handler = std::move(handler)]() mutable {
            watcher->deleteLater();
            if (!watcher->isCanceled())
                handler(watcher->result());
        });
    watcher->setFuture(future);
}

/// Computes off the window's thread, one thing at a time: a new request asks the one that runs to
/// stop, and of those made meanwhile only the newest is carried out. Only the result of the newest
/// is reported. Never waits, not even in its destructor.
template <typename T> class NewestJob {
public:
    /// Refers to nothing that may go away.
    using Function = std::function<T(const std::stop_token&)>;
    using Handler = std::function<void(const T&)>;

    explicit NewestJob(Handler handler) : m_handler(std::move(handler)) { }
    ~NewestJob() { m_stop.request_stop(); }
    NewestJob(const NewestJob&) = delete;
    NewestJob& operator=(const NewestJob&) = delete;

    void start(Function function)
    {
        m_stop.request_stop();
        m_next = std::move(function);
        if (!m_isRunning)
            run();
    }
    /// Nothing is reported for what is cancelled.
    void cancel()
    {
        m_stop.request_stop();
        m_next.reset();
        m_isWanted = false;
    }

private:
    void run()
    {
        m_stop = std::stop_source();
        m_isRunning = true;
        m_isWanted = true;
        const auto result =
            inBackground<T>([function = *std::exchange(m_next, std::nullopt),
                                stop = m_stop.get_token()] { return function(stop); });
        whenDone(result, &m_context, [this](const T& value) { finish(value); });
    }
    void finish(const T& value)
    {
        m_isRunning = false;
        if (m_next)
            run();
        else if (std::exchange(m_isWanted, false))
            m_handler(value);
    }

    Handler m_handler;
    QObject m_context;
    std::stop_source m_stop;
    std::optional<Function> m_next;
    bool m_isRunning = false;
    bool m_isWanted = false; ///< the result of the one that runs
};

} // namespace axiscomp::ui
