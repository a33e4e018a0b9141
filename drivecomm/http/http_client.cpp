// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/http/http_client.h"

#include "drivecomm/http/http_connection.h"

#include <QCoreApplication>
#include <QEventLoop>

#include <future>
#include <thread>

namespace axiscomp::drivecomm {

namespace {

constexpr int repeats = 2;

} // namespace

struct HttpClient::Private {
    Private(DriveEndpoint theEndpoint, CertificateCheck theCheck)
        : endpoint(std::move(theEndpoint))
        , certificateCheck(std::move(theCheck))
    {
    }

    void startThread()
    {
        if (connection)
            return;
        std::promise<void> ready;
        thread = std::thread([this, &ready] { run(ready); });
        ready.get_future().wait();
    }

    void run(std::promise<void>& ready)
    {
        QEventLoop loop;
        HttpConnection own(endpoint, certificateCheck);
        eventLoop = &loop;
        connection = &own;
        ready.set_value();
        loop.exec();
        QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete); // of this thread
    }

    void end()
    {
        if (!connection)
            return;
        QMetaObject::invokeMethod(eventLoop, &QEventLoop::quit, Qt::QueuedConnection);
        thread.join();
    }

    [[nodiscard]] Result<HttpReply> sendOnce(
        const HttpRequest& request, const ExchangeDeadline& running);
    [[nodiscard]] tl::unexpected<Error> late(const Exchange& exchange) const
    {
        return timeoutError(displayText(endpoint), exchange);
    }

    DriveEndpoint endpoint;
    CertificateCheck certificateCheck;
    /// Not a QThread: when that one has been waited for, it may not have let go of what OpenSSL
    /// keeps for each thread, and the program's end would come in between.
    std::thread thread;
    QEventLoop* eventLoop = nullptr; ///< these two live on thread, until it ends
    HttpConnection* connection = nullptr;
};

HttpClient::HttpClient(DriveEndpoint endpoint, CertificateCheck certificateCheck)
    : d(std::make_unique<Private>(std::move(endpoint), std::move(certificateCheck)))
{
}

HttpClient::~HttpClient()
{
    d->end();
}

Result<HttpReply> HttpClient::Private::sendOnce(
    const HttpRequest& request, const ExchangeDeadline& running)
{
    const Exchange& exchange = running.exchange;
    if (exchange.stop.stop_requested())
        return fail(ErrorCode::Cancelled);
    if (std::chrono::steady_clock::now() >= running.deadline)
        return late(exchange);
    startThread();
    const auto pending = std::make_shared<PendingHttp>(request);
    const auto post = [this](auto action) {
        QMetaObject::invokeMethod(connection, std::move(action), Qt::QueuedConnection);
    };
    post([connection = connection, pending] { connection->start(pending); });

    std::unique_lock lock(pending->mutex);
    std::uint64_t reported = 0;
    while (!pending->outcome) {
        const bool woken = pending->changed.wait_until(lock, exchange.stop, running.deadline,
            [&] { return pending->outcome || pending->progress != reported; });
        if (!woken)
            break;
        if (pending->progress == reported)
            continue;
        reported = pending->progress;
        const std::uint64_t total = pending->total;
        if (!request.reportsProgress || !exchange.progress)
            continue;
        lock.unlock();
        exchange.progress(reported, total);
        lock.lock();
    }
    if (!pending->outcome) {
        // The request's bytes are the caller's: nothing may touch them after this function.
        post([connection = connection, pending] { connection->abort(pending); });
        pending->changed.wait(lock, [&] { return pending->outcome.has_value(); });
        if (exchange.stop.stop_requested())
            return fail(ErrorCode::Cancelled);
        return late(exchange);
    }
    return std::move(*pending->outcome);
}

Result<HttpReply> HttpClient::send(const HttpRequest& request, const ExchangeDeadline& running)
{
    auto reply = d->sendOnce(request, running);
    for (int i = 0; i < repeats && request.method == HttpRequest::Method::Get; ++i) {
        if (reply || reply.error().code != ErrorCode::ConnectionLost)
            break;
        reply = d->sendOnce(request, running);
    }
    return reply;
}

} // namespace axiscomp::drivecomm
