// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/http/http_connection.h"

#include "core/text/utf8.h"
#include "drivecomm/codec/json_parsing.h"

#include <QCryptographicHash>
#include <QDateTime>
#include <QHostAddress>
#include <QNetworkProxy>
#include <QSslCertificate>
#include <QSslSocket>

#include <algorithm>
#include <utility>

namespace axiscomp::drivecomm {

namespace {

constexpr qint64 writeAhead = 64 * 1024;
/// A server may be closing a connection that was idle for long, and a write that meets this could
/// not be repeated.
constexpr qint64 longestIdleForWriteMs = 1000;

bool isLoopback(const std::string& host)
{
    return host == "localhost" || QHostAddress(QString::fromStdString(host)).isLoopback();
}

std::string_view verb(HttpRequest::Method method)
{
    switch (method) {
    case HttpRequest::Method::Put:
        return "PUT";
    case HttpRequest::Method::Post:
        return "POST";
    case HttpRequest::Method::Get:
        break;
    }
    return "GET";
}

std::string fingerprintOf(const QSslCertificate& certificate)
{
    const QByteArray hex = certificate.digest(QCryptographicHash::Sha256).toHex();
    return sha256Fingerprint({hex.constData(), static_cast<std::size_t>(hex.size())}).value_or("");
}

/// What a stranger wrote into a certificate.
std::string nameOf(const QString& text)
{
    constexpr std::size_t longest = 200;
    const std::string name = shownText(text.toStdString());
    return name.empty() ? "?" : std::string(cutAtCharacter(name, longest));
}

std::uint64_t bodySize(const HttpRequest& request)
{
    std::uint64_t size = 0;
    for (const ByteView& piece : request.body)
        size += piece.size();
    return size;
}

} // namespace

HttpConnection::HttpConnection(DriveEndpoint endpoint, CertificateCheck certificateCheck)
    : m_endpoint(std::move(endpoint))
    , m_certificateCheck(std::move(certificateCheck))
    , m_isSecure(m_endpoint.kind == DriveEndpoint::Kind::Https)
{
}

std::string HttpConnection::head(const HttpRequest& request) const
{
    const bool isIPv6 = m_endpoint.host.find(':') != std::string::npos;
    std::string text = std::string(verb(request.method)) + ' ' + request.target + " HTTP/1.1\r\n";
    text += "Host: " + (isIPv6 ? '[' + m_endpoint.host + ']' : m_endpoint.host);
    if (m_endpoint.port != (m_isSecure ? 443 : 80))
        text += ':' + std::to_string(m_endpoint.port);
    text += "\r\nUser-Agent: axiscomp\r\nAccept: " + request.accept
        + "\r\nAccept-Encoding: identity\r\n";
    // A cache that keeps what a drive said before the last write would vouch for a state that is
    // gone. Pragma is for caches of HTTP/1.0.
    text += "Cache-Control: no-cache\r\nPragma: no-cache\r\n";
    if (!m_endpoint.user.empty() || !m_endpoint.password.empty()) {
        const auto secret = QByteArray::fromStdString(m_endpoint.user + ':' + m_endpoint.password);
        text += "Authorization: Basic " + secret.toBase64().toStdString() + "\r\n";
    }
    if (request.method != HttpRequest::Method::Get)
        text += "Content-Type: " + request.contentType
            + "\r\nContent-Length: " + std::to_string(bodySize(request)) + "\r\n";
    return text + "\r\n";
}

void HttpConnection::start(const std::shared_ptr<PendingHttp>& pending)
{
    m_pending = pending;
    m_parser.emplace(pending->request.replyLimit);
    m_head = head(pending->request);
    m_piece = 0;
    m_offset = 0;
    m_written = 0;
    if (pending->connection != PendingHttp::On::New && canBeUsedAgain(pending->request))
        begin();
    else if (pending->connection == PendingHttp::On::Kept)
        holdBack();
    else
        connectSocket();
}

void HttpConnection::holdBack()
{
    const auto pending = std::exchange(m_pending, nullptr);
    const std::scoped_lock lock(pending->mutex);
    pending->isHeldBack = true;
    pending->outcome = Result<HttpReply>(fail(ErrorCode::NotConnected));
    pending->changed.notify_all();
}

bool HttpConnection::canBeUsedAgain(const HttpRequest& request) const
{
    const bool isOpen = m_socket && m_isReady
        && m_socket->state() == QAbstractSocket::ConnectedState && m_socket->bytesAvailable() == 0;
    return isOpen
        && (request.method == HttpRequest::Method::Get
            || !m_idle.hasExpired(longestIdleForWriteMs));
}

void HttpConnection::connectSocket()
{
    makeSocket();
    const QString host = QString::fromStdString(m_endpoint.host);
    if (auto* secure = qobject_cast<QSslSocket*>(m_socket.get()))
        secure->connectToHostEncrypted(host, m_endpoint.port);
    else
        m_socket->connectToHost(host, m_endpoint.port);
}

void HttpConnection::makeSocket()
{
    if (m_socket) {
        m_socket->disconnect();
        m_socket->abort();
        m_socket.release()->deleteLater(); // it may be what called
    }
    m_isReady = false;
    m_sslErrors.clear();
    m_trust = CertificateTrust::Unknown;
    if (m_isSecure) {
        auto secure = std::make_unique<QSslSocket>();
        QSslSocket* socket = secure.get();
        connect(socket, &QSslSocket::encrypted, this, &HttpConnection::beginSecure);
        connect(socket, &QSslSocket::sslErrors, this,
            [this, socket](const QList<QSslError>& errors) { judge(*socket, errors); });
        m_socket = std::move(secure);
    } else {
        m_socket = std::make_unique<QTcpSocket>();
        connect(m_socket.get(), &QTcpSocket::connected, this, &HttpConnection::begin);
    }
    if (isLoopback(m_endpoint.host))
        m_socket->setProxy(QNetworkProxy::NoProxy);
    QTcpSocket* socket = m_socket.get();
    connect(socket, &QTcpSocket::bytesWritten, this, &HttpConnection::write);
    connect(socket, &QTcpSocket::readyRead, this, &HttpConnection::read);
    connect(socket, &QTcpSocket::errorOccurred, this, &HttpConnection::connectionFailed);
}

/// errors: what there is to say against the certificate; nothing may have been said yet.
void HttpConnection::judge(QSslSocket& socket, const QList<QSslError>& errors)
{
    if (m_certificateCheck)
        m_trust =
            m_certificateCheck(displayText(m_endpoint), fingerprintOf(socket.peerCertificate()));
    if (m_trust == CertificateTrust::Trusted)
        socket.ignoreSslErrors(errors);
    else
        m_sslErrors = errors;
}

/// Also a certificate that an authority vouches for is not the one that a person has trusted here.
void HttpConnection::beginSecure()
{
    auto& socket = static_cast<QSslSocket&>(*m_socket);
    if (m_trust == CertificateTrust::Unknown)
        judge(socket, {});
    if (m_trust != CertificateTrust::Changed)
        return begin();
    if (m_pending)
        finish(certificateRejected());
}

void HttpConnection::begin()
{
    if (!m_isReady)
        m_socket->setSocketOption(QAbstractSocket::LowDelayOption, 1);
    m_isReady = true;
    write();
}

void HttpConnection::write()
{
    if (!m_pending || !m_isReady)
        return;
    const HttpRequest& request = m_pending->request;
    while (m_socket->bytesToWrite() < writeAhead && m_piece <= request.body.size()) {
        const ByteView piece = m_piece == 0 ? asBytes(m_head) : request.body[m_piece - 1];
        const ByteView rest = piece.subspan(m_offset);
        const qint64 count = m_socket->write(reinterpret_cast<const char*>(rest.data()),
            std::min<qint64>(writeAhead, static_cast<qint64>(rest.size())));
        if (count < 0)
            return; // errorOccurred tells why
        m_offset += static_cast<std::size_t>(count);
        m_written += static_cast<std::uint64_t>(count);
        if (m_offset == piece.size()) {
            ++m_piece;
            m_offset = 0;
        }
    }
    if (request.body.empty())
        return;
    std::uint64_t before = m_head.size();
    for (std::size_t i = 0; i < request.watchedPiece; ++i)
        before += request.body[i].size();
    const std::uint64_t sent = m_written - static_cast<std::uint64_t>(m_socket->bytesToWrite());
    const std::uint64_t total = request.body[request.watchedPiece].size();
    if (sent > before)
        notify(std::min(sent - before, total), total);
}

void HttpConnection::read()
{
    if (!m_pending) { // nobody asked: what came would be taken for the next reply
        m_socket->abort();
        return;
    }
    while (m_socket->bytesAvailable() > 0 && m_parser->state() != HttpReplyParser::State::Failed) {
        const QByteArray bytes = m_socket->read(writeAhead);
        m_parser->feed({bytes.constData(), static_cast<std::size_t>(bytes.size())});
    }
    if (m_pending->request.method == HttpRequest::Method::Get && m_parser->announced())
        notify(m_parser->received(), *m_parser->announced());
    if (m_parser->state() == HttpReplyParser::State::Complete)
        return finish(m_parser->take());
    if (m_parser->state() == HttpReplyParser::State::Failed) {
        Error error{ErrorCode::Protocol,
            {{"endpoint", displayText(m_endpoint)}, {"expected", m_parser->expected()},
                {"quote", quoteOf(m_parser->found())}},
            {}};
        finish(fail(std::move(error)));
    }
}

void HttpConnection::connectionFailed(QAbstractSocket::SocketError error)
{
    if (!m_pending)
        return;
    read(); // what came before the end may be all that was due
    if (!m_pending)
        return;
    if (error == QAbstractSocket::RemoteHostClosedError)
        m_parser->end();
    if (m_parser->state() == HttpReplyParser::State::Complete)
        return finish(m_parser->take());
    finish(failure(error));
}

void HttpConnection::abort(const std::shared_ptr<PendingHttp>& pending)
{
    if (m_pending == pending)
        finish(fail(ErrorCode::Cancelled));
}

void HttpConnection::finish(Result<HttpReply> outcome)
{
    const bool wasSent = m_piece > m_pending->request.body.size() && m_socket->bytesToWrite() == 0;
    const bool isUsable = outcome && wasSent && m_parser->keepsConnection();
    const auto pending = std::exchange(m_pending, nullptr);
    if (!isUsable) {
        m_isReady = false;
        m_socket->abort();
    }
    m_idle.start();
    const std::scoped_lock lock(pending->mutex);
    pending->outcome = std::move(outcome);
    pending->changed.notify_all();
}

void HttpConnection::notify(std::uint64_t progress, std::uint64_t total)
{
    const std::scoped_lock lock(m_pending->mutex);
    if (progress <= m_pending->progress)
        return;
    m_pending->progress = progress;
    m_pending->total = total;
    m_pending->changed.notify_all();
}

tl::unexpected<Error> HttpConnection::failed(ErrorCode code, Text reason) const
{
    return fail(code, {{"endpoint", displayText(m_endpoint)}, {"reason", std::move(reason)}},
        m_socket->errorString().toStdString());
}

/// With all that a person needs to decide about the certificate.
tl::unexpected<Error> HttpConnection::certificateRejected() const
{
    const QSslCertificate certificate = static_cast<const QSslSocket&>(*m_socket).peerCertificate();
    QStringList reasons;
    for (const QSslError& each : m_sslErrors)
        reasons += each.errorString();
    reasons.removeDuplicates();
    Text reason = Verbatim{reasons.join(QStringLiteral("; ")).toStdString()};
    if (m_trust == CertificateTrust::Changed)
        reason = AXISCOMP_TEXT("Error", "it has CHANGED and is not the one that was trusted");
    const auto day = [](const QDateTime& time) {
        return time.toUTC().date().toString(Qt::ISODate).toStdString();
    };
    Error error{ErrorCode::CertificateRejected,
        {{"endpoint", displayText(m_endpoint)}, {"reason", std::move(reason)},
            {"fingerprint", fingerprintOf(certificate)},
            {"subject", nameOf(certificate.subjectDisplayName())},
            {"issuer", nameOf(certificate.issuerDisplayName())},
            {"validFrom", day(certificate.effectiveDate())},
            {"validUntil", day(certificate.expiryDate())},
            {"hasChanged", Verbatim{m_trust == CertificateTrust::Changed ? "yes" : "no"}}},
        m_socket->errorString().toStdString()};
    return fail(std::move(error));
}

Result<HttpReply> HttpConnection::failure(QAbstractSocket::SocketError error) const
{
    if (m_isReady) {
        const bool wasClosed = error == QAbstractSocket::RemoteHostClosedError;
        return failed(ErrorCode::ConnectionLost,
            wasClosed ? Text(AXISCOMP_TEXT("Error", "it was closed before the reply was complete"))
                      : Verbatim{m_socket->errorString().toStdString()});
    }
    if (!m_sslErrors.isEmpty())
        return certificateRejected();
    switch (error) {
    case QAbstractSocket::ConnectionRefusedError:
        return failed(ErrorCode::NotConnected,
            AXISCOMP_TEXT("Error",
                "nothing listens there; is the drive switched on, and is the address right?"));
    case QAbstractSocket::HostNotFoundError:
        return failed(ErrorCode::NotConnected,
            AXISCOMP_TEXT("Error", "the network does not know the name {name}")
                .with("name", m_endpoint.host));
    case QAbstractSocket::SslHandshakeFailedError:
    case QAbstractSocket::RemoteHostClosedError:
        if (m_isSecure)
            return failed(ErrorCode::NotConnected,
                AXISCOMP_TEXT("Error", "there is no https; try http://, or another port"));
        [[fallthrough]];
    default:
        return failed(ErrorCode::NotConnected, Verbatim{m_socket->errorString().toStdString()});
    }
}

} // namespace axiscomp::drivecomm
