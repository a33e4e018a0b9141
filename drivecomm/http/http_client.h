// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_link.h"
#include "drivecomm/http/http_reply_parser.h"
#include "drivecomm/link/certificate_check.h"
#include "drivecomm/link/drive_endpoint.h"
#include "drivecomm/link/exchange_deadline.h"

#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace axiscomp::drivecomm {

struct HttpRequest {
    enum class Method { Get, Put, Post };
    Method method = Method::Get;
    std::string target; ///< "/registers?prefix=Axes", percent-encoded
    std::string accept = "application/json";
    std::string contentType; ///< of the body
    std::vector<ByteView> body; ///< its pieces; they must live until send returns
    std::size_t watchedPiece = 0; ///< the piece of the body whose bytes are the progress
    std::uint64_t replyLimit = std::uint64_t{1} << 20; ///< bytes of the reply's body
    bool reportsProgress = false;
};

/// HTTP/1.1 to one host, blocking, one request at a time. The network runs on a thread of its own:
/// the caller needs no event loop, and none runs while it waits. Never follows a redirect. A GET is
/// repeated after ConnectionLost, twice at most and within the deadline; PUT and POST never are.
class HttpClient {
public:
    explicit HttpClient(DriveEndpoint endpoint, CertificateCheck certificateCheck = {});
    ~HttpClient();
    HttpClient(const HttpClient&) = delete;
    HttpClient& operator=(const HttpClient&) = delete;

    /// Any complete reply, whatever its status. Errors: NotConnected, ConnectionLost, Timeout,
    /// Protocol, CertificateRejected, Cancelled.
    [[nodiscard]] Result<HttpReply> send(
        const HttpRequest& request, const ExchangeDeadline& running);

    /// Who answers may be another one on another connection. A request on a new connection goes out
    /// after check has said yes, whose own requests are the first there. A server that closes each
    /// connection is asked before each request. isChecked: the present connection need not be.
    void checkConnections(
        std::function<Result<void>(const ExchangeDeadline&)> check, bool isChecked);
    /// As before there was a check.
    void takeAnyConnection();

private:
    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace axiscomp::drivecomm
