// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/http/http_client.h"
#include "drivecomm/http/http_reply_parser.h"

#include <QElapsedTimer>
#include <QObject>
#include <QSslError>
#include <QTcpSocket>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>

class QSslSocket;

namespace axiscomp::drivecomm {

/// One request on its way, shared by the thread that waits for it and the thread of the network.
struct PendingHttp {
    /// On which connection it may go out.
    enum class On {
        Any, ///< the one that is kept, where it can be used again
        Kept, ///< that one only
        New,
    };
    explicit PendingHttp(const HttpRequest& theRequest, On theConnection = On::Any)
        : request(theRequest)
        , connection(theConnection)
    {
    }
    const HttpRequest& request; ///< valid until outcome is there
    const On connection;
    std::mutex mutex;
    std::condition_variable_any changed;
    std::optional<Result<HttpReply>> outcome;
    bool isHeldBack = false; ///< there was no Kept connection: nothing was sent
    std::uint64_t progress = 0;
    std::uint64_t total = 0;
};

/// The connection of an HttpClient, kept between requests; lives on the network's thread. Not
/// QNetworkAccessManager: that sends a request again by itself when the connection closes before
/// the reply, a PUT too, and cannot say what came when it was not HTTP (docs/protocol.md).
class HttpConnection final : public QObject {
public:
    HttpConnection(DriveEndpoint endpoint, CertificateCheck certificateCheck);

    void start(const std::shared_ptr<PendingHttp>& pending);
    /// Gives pending an outcome at once, if it has none.
    void abort(const std::shared_ptr<PendingHttp>& pending);

private:
    [[nodiscard]] bool canBeUsedAgain(const HttpRequest& request) const;
    void holdBack();
    void connectSocket();
    void makeSocket();
    void judge(QSslSocket& socket, const QList<QSslError>& errors);
    void begin();
    void beginSecure();
    void write();
    void read();
    void connectionFailed(QAbstractSocket::SocketError error);
    void finish(Result<HttpReply> outcome);
    void notify(std::uint64_t progress, std::uint64_t total);
    [[nodiscard]] std::string head(const HttpRequest& request) const;
    [[nodiscard]] Result<HttpReply> failure(QAbstractSocket::SocketError error) const;
    [[nodiscard]] tl::unexpected<Error> failed(ErrorCode code, Text reason) const;
    [[nodiscard]] tl::unexpected<Error> certificateRejected() const;

    DriveEndpoint m_endpoint;
    CertificateCheck m_certificateCheck;
    bool m_isSecure;
    std::unique_ptr<QTcpSocket> m_socket; ///< a QSslSocket for https only: http needs no OpenSSL
    QElapsedTimer m_idle; ///< since the last reply
    QList<QSslError> m_sslErrors; ///< that nobody has decided to accept
    CertificateTrust m_trust = CertificateTrust::Unknown;

    // Of the request on its way:
    std::shared_ptr<PendingHttp> m_pending;
    std::optional<HttpReplyParser> m_parser;
    std::string m_head;
    std::size_t m_piece = 0; ///< 0 is the head, 1 the first of the body
    std::size_t m_offset = 0;
    std::uint64_t m_written = 0; ///< handed to the socket
    bool m_isReady = false; ///< connected, so that something may have been sent
};

} // namespace axiscomp::drivecomm
