// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/http/http_client.h"

#include "drivecomm/http/http_connection.h"

#include <QThread>

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
        connection = new HttpConnection(endpoint, certificateCheck);
        connection->moveToThread(&thread);
        QObject::connect(&thread, &QThread::finished, connection, &QObject::deleteLater);
        thread.setObjectName(QStringLiteral("drive http"));
        thread.start();
    }

    [[nodiscard]] Result<HttpReply> sendOnce(
        const HttpRequest& request, const ExchangeDeadline& running);
    [[nodiscard]] tl::unexpected<Error> late(const Exchange& exchange) const
    {
        return timeoutError(displayText(endpoint), exchange);
    }

    DriveEndpoint endpoint;
    CertificateCheck certificateCheck;
    QThread thread;
    HttpConnection* connection = nullptr; ///< lives on thread, deleted when it ends
};

HttpClient::HttpClient(DriveEndpoint endpoint, CertificateCheck certificateCheck)
    : d(std::make_unique<Private>(std::move(endpoint), std::move(certificateCheck)))
{
}

HttpClient::~HttpClient()
{
    d->thread.quit();
    d->thread.wait();
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
