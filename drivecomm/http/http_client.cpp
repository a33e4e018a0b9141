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

    [[nodiscard]] Result<HttpReply> sendOnce(const HttpRequest& request,
        const ExchangeDeadline& running, PendingHttp::On connection, bool& isHeldBack);
    [[nodiscard]] Result<HttpReply> sendChecked(
        const HttpRequest& request, const ExchangeDeadline& running);
    [[nodiscard]] tl::unexpected<Error> late(const Exchange& exchange) const
    {
        return timeoutError(displayText(endpoint), exchange);
    }

    DriveEndpoint endpoint;
    CertificateCheck certificateCheck;
    std::function<Result<void>(const ExchangeDeadline&)> check;
    bool isChecked = false; ///< the connection that is kept
    bool isChecking = false;
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

Result<HttpReply> HttpClient::Private::sendOnce(const HttpRequest& request,
    const ExchangeDeadline& running, PendingHttp::On connectsTo, bool& isHeldBack)
{
    const Exchange& exchange = running.exchange;
    if (exchange.stop.stop_requested())
        return fail(ErrorCode::Cancelled);
    if (std::chrono::steady_clock::now() >= running.deadline)
        return late(exchange);
    startThread();
    const auto pending = std::make_shared<PendingHttp>(request, connectsTo);
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
    isHeldBack = pending->isHeldBack;
    return std::move(*pending->outcome);
}

/// Only one of the client's own connections may be asked without a check: the one that had it.
Result<HttpReply> HttpClient::Private::sendChecked(
    const HttpRequest& request, const ExchangeDeadline& running)
{
    using On = PendingHttp::On;
    bool isHeldBack = false;
    if (isChecking)
        return sendOnce(request, running, On::New, isHeldBack);
    if (!check)
        return sendOnce(request, running, On::Any, isHeldBack);
    if (isChecked) {
        auto reply = sendOnce(request, running, On::Kept, isHeldBack);
        if (!isHeldBack)
            return reply;
    }
    isChecked = false;
    isChecking = true;
    const auto checked = check(running);
    isChecking = false;
    if (!checked)
        return fail(checked.error());
    isChecked = true;
    isHeldBack = false;
    auto reply = sendOnce(request, running, On::Kept, isHeldBack);
    if (!isHeldBack)
        return reply;
    // A server that closes every connection: right after the check is the best there is.
    isChecked = false;
    return sendOnce(request, running, On::New, isHeldBack);
}

void HttpClient::checkConnections(
    std::function<Result<void>(const ExchangeDeadline&)> check, bool isChecked)
{
    d->check = std::move(check);
    d->isChecked = isChecked;
}

void HttpClient::takeAnyConnection()
{
    d->check = {};
}

Result<HttpReply> HttpClient::send(const HttpRequest& request, const ExchangeDeadline& running)
{
    auto reply = d->sendChecked(request, running);
    for (int i = 0; i < repeats && !d->isChecking && request.method == HttpRequest::Method::Get;
         ++i) {
        if (reply || reply.error().code != ErrorCode::ConnectionLost)
            break;
        reply = d->sendChecked(request, running);
    }
    return reply;
}

} // namespace axiscomp::drivecomm
