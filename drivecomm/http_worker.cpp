// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/http_worker.h"

#include "drivecomm/http_body.h"
#include "drivecomm/json_text.h"

#include <QHostAddress>
#include <QNetworkProxy>
#include <QNetworkReply>
#include <QSslConfiguration>
#include <QUrl>

#include <algorithm>

namespace axiscomp::drivecomm {

namespace {

constexpr qint64 readBuffer = 256 * 1024;

bool isLoopback(const std::string& host)
{
    return host == "localhost" || QHostAddress(QString::fromStdString(host)).isLoopback();
}

std::string header(const QNetworkReply& reply, const char* name)
{
    return reply.rawHeader(name).toStdString();
}

std::string mediaType(std::string contentType)
{
    contentType.resize(std::min(contentType.find(';'), contentType.size()));
    std::erase(contentType, ' ');
    std::ranges::transform(contentType, contentType.begin(),
        [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return contentType;
}

/// The reply is complete and the error says no more than its status.
bool repeatsStatus(QNetworkReply::NetworkError error)
{
    return error == QNetworkReply::NoError
        || (error > QNetworkReply::UnknownProxyError && error != QNetworkReply::ContentReSendError
            && error != QNetworkReply::ProtocolFailure);
}

void notify(PendingHttp& pending, std::uint64_t progress, std::uint64_t total)
{
    const std::scoped_lock lock(pending.mutex);
    if (progress <= pending.progress)
        return;
    pending.progress = progress;
    pending.total = total;
    pending.changed.notify_all();
}

} // namespace

HttpWorker::HttpWorker(DriveEndpoint endpoint) : m_endpoint(std::move(endpoint)) { }

QNetworkRequest HttpWorker::networkRequest(const HttpRequest& request) const
{
    QUrl url = QUrl::fromEncoded(QByteArray::fromStdString(request.target), QUrl::StrictMode);
    url.setScheme(m_endpoint.kind == DriveEndpoint::Kind::Https ? QStringLiteral("https")
                                                                : QStringLiteral("http"));
    url.setHost(QString::fromStdString(m_endpoint.host));
    url.setPort(m_endpoint.port);
    QNetworkRequest result(url);
    result.setAttribute(
        QNetworkRequest::RedirectPolicyAttribute, QNetworkRequest::ManualRedirectPolicy);
    result.setAttribute(QNetworkRequest::Http2AllowedAttribute, false);
    result.setAttribute(QNetworkRequest::CookieLoadControlAttribute, QNetworkRequest::Manual);
    result.setAttribute(QNetworkRequest::CookieSaveControlAttribute, QNetworkRequest::Manual);
    result.setAttribute(QNetworkRequest::AuthenticationReuseAttribute, QNetworkRequest::Manual);
    result.setAttribute(QNetworkRequest::DoNotBufferUploadDataAttribute, true);
    result.setRawHeader("Accept", QByteArray::fromStdString(request.accept));
    // Qt would unpack what is compressed, and the length of the reply would mean nothing.
    result.setRawHeader("Accept-Encoding", "identity");
    if (!m_endpoint.user.empty() || !m_endpoint.password.empty()) {
        const QByteArray secret =
            QByteArray::fromStdString(m_endpoint.user + ":" + m_endpoint.password);
        result.setRawHeader("Authorization", "Basic " + secret.toBase64());
    }
    return result;
}

void HttpWorker::start(const std::shared_ptr<PendingHttp>& pending)
{
    if (!m_network) {
        m_network = std::make_unique<QNetworkAccessManager>();
        if (isLoopback(m_endpoint.host))
            m_network->setProxy(QNetworkProxy::NoProxy);
    }
    const HttpRequest& request = pending->request;
    QNetworkRequest networked = networkRequest(request);
    if (request.method == HttpRequest::Method::Get) {
        pending->reply = m_network->get(networked);
    } else {
        const std::uint64_t total =
            request.body.empty() ? 0 : request.body.at(request.watchedPiece).size();
        pending->body = new HttpBody(request.body, request.watchedPiece,
            [p = pending.get(), total](std::uint64_t read) { notify(*p, read, total); });
        networked.setHeader(
            QNetworkRequest::ContentTypeHeader, QByteArray::fromStdString(request.contentType));
        networked.setHeader(QNetworkRequest::ContentLengthHeader, pending->body->total());
        pending->reply = request.method == HttpRequest::Method::Put
            ? m_network->put(networked, pending->body)
            : m_network->post(networked, pending->body);
        pending->body->setParent(pending->reply);
    }
    QNetworkReply* reply = pending->reply;
    reply->setReadBufferSize(readBuffer);
    connect(reply, &QNetworkReply::requestSent, reply, [pending] { pending->wasSent = true; });
    connect(reply, &QNetworkReply::sslErrors, reply,
        [pending](const QList<QSslError>& errors) { pending->sslErrors = errors; });
    connect(reply, &QNetworkReply::readyRead, reply, [this, pending] { receive(*pending); });
    connect(reply, &QNetworkReply::finished, this, [this, pending] { finish(*pending); });
    if (reply->isFinished())
        finish(*pending);
}

void HttpWorker::abort(const std::shared_ptr<PendingHttp>& pending)
{
    if (pending->reply)
        pending->reply->abort();
    finish(*pending);
}

void HttpWorker::receive(PendingHttp& pending)
{
    if (!pending.reply || !pending.reply->isOpen() || pending.tooMuch)
        return;
    const std::uint64_t limit = pending.request.replyLimit;
    const auto total = pending.reply->header(QNetworkRequest::ContentLengthHeader).toULongLong();
    const QByteArray bytes = pending.reply->readAll();
    pending.received.append(bytes.constData(), static_cast<std::size_t>(bytes.size()));
    if (pending.received.size() > limit || total > limit) {
        pending.tooMuch = true;
        pending.reply->abort();
        return;
    }
    if (pending.request.method == HttpRequest::Method::Get && total > 0)
        notify(pending, pending.received.size(), total);
}

void HttpWorker::finish(PendingHttp& pending)
{
    if (!pending.reply)
        return;
    receive(pending);
    if (!pending.reply) // receive ended it
        return;
    auto result = outcome(pending);
    QNetworkReply* reply = pending.reply;
    pending.reply = nullptr;
    reply->disconnect();
    // Qt may still ask for the rest of the body, whose bytes are the caller's.
    if (pending.body)
        pending.body->letGo();
    pending.body = nullptr;
    reply->deleteLater();
    const std::scoped_lock lock(pending.mutex);
    pending.outcome = std::move(result);
    pending.changed.notify_all();
}

Result<HttpReply> HttpWorker::outcome(PendingHttp& pending) const
{
    const QNetworkReply& reply = *pending.reply;
    const int status = reply.attribute(QNetworkRequest::HttpStatusCodeAttribute).toInt();
    if (pending.tooMuch) {
        return with(ErrorCode::Protocol, "expected",
            "at most " + std::to_string(pending.request.replyLimit) + " bytes", pending);
    }
    if (status == 0 || !repeatsStatus(reply.error()))
        return failure(pending);
    HttpReply result;
    result.status = status;
    result.contentType = mediaType(header(reply, "Content-Type"));
    result.location = header(reply, "Location");
    result.retryAfter = header(reply, "Retry-After");
    result.hasEnd = reply.hasRawHeader("Content-Length")
        || mediaType(header(reply, "Transfer-Encoding")) == "chunked";
    result.body = std::move(pending.received);
    return result;
}

tl::unexpected<Error> HttpWorker::with(
    ErrorCode code, const char* key, std::string text, const PendingHttp& pending) const
{
    Error error{code, {{"endpoint", displayText(m_endpoint)}, {key, std::move(text)}}, {}};
    if (code == ErrorCode::Protocol)
        error.context["quote"] = quoteOf(pending.received);
    error.detail = pending.reply->errorString().toStdString();
    return fail(std::move(error));
}

tl::unexpected<Error> HttpWorker::failure(const PendingHttp& pending) const
{
    const bool maySent = pending.wasSent || (pending.body && pending.body->wasRead());
    switch (pending.reply->error()) {
    case QNetworkReply::ConnectionRefusedError:
        return with(ErrorCode::NotConnected, "reason",
            "nothing listens there; is the drive switched on, and is the address right?", pending);
    case QNetworkReply::HostNotFoundError:
        return with(ErrorCode::NotConnected, "reason",
            "the network does not know the name " + m_endpoint.host, pending);
    case QNetworkReply::SslHandshakeFailedError: {
        if (pending.sslErrors.isEmpty())
            return with(ErrorCode::NotConnected, "reason",
                "there is no https; try http://, or another port", pending);
        QStringList reasons;
        for (const QSslError& each : pending.sslErrors)
            reasons += each.errorString();
        reasons.removeDuplicates();
        return with(ErrorCode::CertificateRejected, "reason",
            reasons.join(QStringLiteral("; ")).toStdString(), pending);
    }
    case QNetworkReply::ProtocolFailure:
    case QNetworkReply::ProtocolInvalidOperationError:
    case QNetworkReply::ProtocolUnknownError: {
        auto error = with(ErrorCode::Protocol, "expected", "an HTTP reply", pending);
        if (pending.received.empty())
            error.value().context["quote"] = "something else";
        return error;
    }
    case QNetworkReply::RemoteHostClosedError:
    case QNetworkReply::ContentReSendError:
        break;
    default:
        if (!maySent)
            return with(ErrorCode::NotConnected, "reason",
                pending.reply->errorString().toStdString(), pending);
        return with(ErrorCode::ConnectionLost, "reason", pending.reply->errorString().toStdString(),
            pending);
    }
    return with(ErrorCode::ConnectionLost, "reason", "it was closed before the reply was complete",
        pending);
}

} // namespace axiscomp::drivecomm
