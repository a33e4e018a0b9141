// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/http_client.h"

#include <QNetworkAccessManager>
#include <QObject>
#include <QSslError>

#include <condition_variable>
#include <memory>
#include <mutex>
#include <optional>

class QNetworkReply;

namespace axiscomp::drivecomm {

class HttpBody;

/// One request on its way, shared by the thread that waits and the thread of the network.
struct PendingHttp {
    explicit PendingHttp(const HttpRequest& theRequest) : request(theRequest) { }
    const HttpRequest& request; ///< valid until outcome is there
    std::mutex mutex;
    std::condition_variable_any changed;
    std::optional<Result<HttpReply>> outcome;
    std::uint64_t progress = 0;
    std::uint64_t total = 0;

    // Of the network's thread alone:
    QNetworkReply* reply = nullptr;
    HttpBody* body = nullptr;
    std::string received;
    QList<QSslError> sslErrors;
    bool wasSent = false;
    bool tooMuch = false;
};

/// Makes the requests of an HttpClient; every function is called on the network's thread.
class HttpWorker final : public QObject {
public:
    explicit HttpWorker(DriveEndpoint endpoint);

    void start(const std::shared_ptr<PendingHttp>& pending);
    /// Gives pending an outcome at once.
    void abort(const std::shared_ptr<PendingHttp>& pending);

private:
    [[nodiscard]] QNetworkRequest networkRequest(const HttpRequest& request) const;
    void receive(PendingHttp& pending);
    void finish(PendingHttp& pending);
    [[nodiscard]] Result<HttpReply> outcome(PendingHttp& pending) const;
    [[nodiscard]] tl::unexpected<Error> failure(const PendingHttp& pending) const;
    [[nodiscard]] tl::unexpected<Error> with(
        ErrorCode code, const char* key, std::string text, const PendingHttp& pending) const;

    DriveEndpoint m_endpoint;
    std::unique_ptr<QNetworkAccessManager> m_network;
};

} // namespace axiscomp::drivecomm
