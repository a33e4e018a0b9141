// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/web/web_server.h"

#include "drivecomm/virtualdrive/web/access.h"
#include "drivecomm/virtualdrive/web/body.h"
#include "drivecomm/virtualdrive/web/connection_relay.h"
#include "drivecomm/virtualdrive/web/guarded_server.h"
#include "drivecomm/virtualdrive/web/request_handler.h"
#include "drivecomm/virtualdrive/web/socket.h"

#include <algorithm>
#include <atomic>
#include <condition_variable>
#include <mutex>
#include <thread>

namespace axiscomp::drivecomm {

namespace {

using Fate = ConnectionRelay::Fate;

constexpr std::chrono::seconds keepAlive{30};
constexpr std::uint64_t formOverhead = 64 * 1024;
constexpr std::uint64_t mostJson = 256 * 1024;

httplib::Headers defaultHeaders()
{
    return {{"Cache-Control", "no-cache"}, {"X-Content-Type-Options", "nosniff"},
        {"Referrer-Policy", "same-origin"},
        {"Content-Security-Policy",
            "default-src 'none'; style-src 'unsafe-inline'; form-action 'self'; base-uri 'none'; "
            "frame-ancestors 'none'"}};
}

void flipBytes(std::string& body)
{
    for (const std::size_t place : {std::size_t{0}, body.size() / 2, body.size() - 1})
        body[place] = static_cast<char>(body[place] ^ 0x15);
}

} // namespace

struct WebServer::Private {
    Private(VirtualDrive& theDrive, const DriveProfile& profile, FaultPlan& theFaults,
        const WebServerOptions& theOptions)
        : drive(theDrive)
        , faults(theFaults)
        , options(theOptions)
        , access(options.host, options.user, options.password)
        , handler(drive, profile)
        , transferPath(profile.web.transfer)
    {
        for (const TableSlot& slot : profile.tableSlots)
            largestForm = std::max<std::uint64_t>(largestForm, slot.maximumSize + formOverhead);
    }
    ~Private();

    [[nodiscard]] std::string address(std::uint16_t port) const
    {
        return (isSecure() ? "https://" : "http://") + hostAndPort(options.host, port);
    }
    [[nodiscard]] bool isSecure() const { return !options.certificateFile.empty(); }
    [[nodiscard]] tl::unexpected<Error> refused(std::string reason) const
    {
        return fail(ErrorCode::InvalidEndpoint,
            {{"endpoint", address(options.port)}, {"reason", std::move(reason)}});
    }

    [[nodiscard]] ServerGuard guard() const;
    [[nodiscard]] Result<int> bind();
    [[nodiscard]] Result<void> start();
    void configure();
    void serve(const httplib::Request& from, httplib::Response& to,
        const httplib::ContentReader* contentReader);
    void respond(const httplib::Request& from, httplib::Response& to, const WebRequest& request);
    void refuse(const WebRequest& request, const WebAccess::Denial& denial, httplib::Response& to);
    static void put(const WebReply& reply, httplib::Response& to);
    [[nodiscard]] std::uint64_t mostBytes(const WebRequest& request) const
    {
        return request.path == transferPath ? largestForm : mostJson;
    }
    void waitFor(std::chrono::milliseconds delay);

    VirtualDrive& drive;
    FaultPlan& faults;
    WebServerOptions options;
    WebAccess access;
    RequestHandler handler;
    std::string transferPath;
    std::uint64_t largestForm = formOverhead;
    std::atomic<int> wrongPasswords = 0; ///< since the last right one

    std::unique_ptr<httplib::Server> server;
    std::unique_ptr<ConnectionRelay> relay;
    std::thread thread;
    std::atomic<bool> ended = false;
    std::mutex mutex;
    std::condition_variable stopped;
    bool stopping = false;
};

WebServer::Private::~Private()
{
    {
        const std::scoped_lock lock(mutex);
        stopping = true;
    }
    stopped.notify_all();
    if (!thread.joinable())
        return;
    // No thread of the server waits for a client any more; but one may be about to decide over its
    // connection, so that the relay itself has to stay.
    relay->stop();
    while (!server->is_running() && !ended) // stop() is lost on a server that is still starting
        std::this_thread::yield();
    server->stop();
    thread.join();
}

ServerGuard WebServer::Private::guard() const
{
    // Nothing is known of what the client would rather read.
    const auto refusal = [this](const HeadFault& fault) {
        const WebReply reply = handler.refusal({}, rejected(fault.reason), fault.status);
        std::string text = "HTTP/1.1 " + std::to_string(reply.status) + " Refused\r\n";
        for (const auto& [name, value] : defaultHeaders())
            text += name + ": " + value + "\r\n";
        return text + "Connection: close\r\nContent-Type: " + reply.contentType
            + "\r\nContent-Length: " + std::to_string(reply.body.size()) + "\r\n\r\n" + reply.body;
    };
    return {options.patience, keepAlive, refusal};
}

Result<int> WebServer::Private::bind()
{
    int port = 0;
    if (isSecure()) {
        auto secure = std::make_unique<GuardedServer<httplib::SSLServer>>(
            guard(), options.certificateFile.c_str(), options.privateKeyFile.c_str());
        if (!secure->is_valid())
            return refused("the certificate " + options.certificateFile + " and the key "
                + options.privateKeyFile + " cannot be used; both must be PEM files that fit");
        port = secure->bindToLoopback();
        server = std::move(secure);
    } else {
        auto plain = std::make_unique<GuardedServer<httplib::Server>>(guard());
        port = plain->bindToLoopback();
        server = std::move(plain);
    }
    if (port <= 0)
        return refused("no free port for the server");
    return port;
}

Result<void> WebServer::Private::start()
{
    if (options.certificateFile.empty() != options.privateKeyFile.empty())
        return refused("https needs both a certificate and its private key");
    AXISCOMP_TRY(const auto serverPort, bind());
    configure();
    auto started = ConnectionRelay::start(options.host, options.port,
        static_cast<std::uint16_t>(serverPort), faults, options.patience);
    if (!started) {
        Error error = started.error();
        error.context.set("endpoint", address(options.port));
        return fail(std::move(error));
    }
    relay = std::move(*started);
    thread = std::thread([this] {
        server->listen_after_bind();
        ended = true;
    });
    return {};
}

void WebServer::Private::configure()
{
    server->new_task_queue = [] { return new ConnectionThreads(ConnectionRelay::mostConnections); };
    server->set_default_headers(defaultHeaders());
    const auto plain = [this](const httplib::Request& from, httplib::Response& to) {
        serve(from, to, nullptr);
    };
    const auto withBody = [this](const httplib::Request& from, httplib::Response& to,
                              const httplib::ContentReader& reader) { serve(from, to, &reader); };
    const std::string anything = ".*";
    server->Get(anything, plain);
    server->Options(anything, plain);
    server->Post(anything, withBody);
    server->Put(anything, withBody);
    server->Patch(anything, withBody);
    server->Delete(anything, withBody);
    // Without a length httplib would read until the client closes.
    server->set_pre_routing_handler([this](const httplib::Request& from, httplib::Response& to) {
        const bool hasBody =
            from.has_header("Content-Length") || from.has_header("Transfer-Encoding");
        if (from.method == "GET" || from.method == "HEAD" || from.method == "OPTIONS" || hasBody)
            return httplib::Server::HandlerResponse::Unhandled;
        put(handler.refusal(requestWithoutBody(from), rejected("Content-Length is missing"), 411),
            to);
        return httplib::Server::HandlerResponse::Handled;
    });
    // A client that asks before it sends is told before it has.
    server->set_expect_100_continue_handler(
        [this](const httplib::Request& from, httplib::Response& to) {
            const WebRequest request = requestWithoutBody(from);
            const auto size = from.get_header_value<std::uint64_t>("Content-Length");
            if (const auto denial = access.denial(request))
                refuse(request, *denial, to);
            else if (size > mostBytes(request))
                put(handler.refusal(request, rejected("the request is too large"), 413), to);
            else
                return 100;
            return to.status;
        });
    // What httplib refuses by itself has no body yet.
    server->set_error_handler([this](const httplib::Request& from, httplib::Response& to) {
        if (!to.body.empty() || from.method == "HEAD")
            return;
        put(handler.refusal(
                requestWithoutBody(from), rejected("the request is malformed"), to.status),
            to);
    });
    server->set_exception_handler(
        [this](const httplib::Request& from, httplib::Response& to, std::exception_ptr) {
            put(handler.refusal(requestWithoutBody(from), rejected("the server failed"), 500), to);
        });
}

void WebServer::Private::serve(const httplib::Request& from, httplib::Response& to,
    const httplib::ContentReader* contentReader)
{
    WebRequest request = requestWithoutBody(from);
    if (contentReader) {
        const BodyEnd end = readBody(from, *contentReader, mostBytes(request), request);
        request.isMalformed = end == BodyEnd::Malformed;
        if (end == BodyEnd::Endless) {
            relay->decide(static_cast<std::uint16_t>(from.remote_port), Fate::Cut);
            return;
        }
    }
    respond(from, to, request);
}

void WebServer::Private::respond(
    const httplib::Request& from, httplib::Response& to, const WebRequest& request)
{
    relay->keepUntilReply(static_cast<std::uint16_t>(from.remote_port));
    if (const auto denial = access.denial(request))
        return refuse(request, *denial, to);
    wrongPasswords = 0;
    if (request.isMalformed || request.isTooLarge) {
        put(handler.answer(request), to);
        return;
    }
    const FaultPlan::Decision decision = faults.next(request.method != "GET");
    const auto connection = static_cast<std::uint16_t>(from.remote_port);
    if (decision.storeWrong)
        drive.storeNextWrong();
    WebReply reply = decision.rejectCode
        ? handler.refusal(request, errorAskedFor(*decision.rejectCode))
        : handler.answer(request);
    waitFor(decision.delay);
    if (decision.reboot) {
        drive.reboot();
        relay->decide(connection, Fate::Cut);
    } else if (decision.noReply) {
        relay->decide(connection, Fate::Silent);
    } else if (decision.garble && reply.body.empty()) {
        relay->decide(connection, Fate::GarbledHead);
    } else if (decision.garble) {
        flipBytes(reply.body);
    }
    put(reply, to);
}

/// Who tries passwords has to wait for each answer after the first few.
void WebServer::Private::refuse(
    const WebRequest& request, const WebAccess::Denial& denial, httplib::Response& to)
{
    constexpr int freeTries = 5;
    constexpr std::chrono::milliseconds pause{1000};
    put(handler.refusal(request, denial.error, denial.status), to);
    if (denial.status != 401)
        return;
    to.set_header("WWW-Authenticate", "Basic realm=\"drive\", charset=\"UTF-8\"");
    if (!request.authorization.empty() && ++wrongPasswords > freeTries)
        waitFor(pause);
}

void WebServer::Private::put(const WebReply& reply, httplib::Response& to)
{
    to.status = reply.status;
    for (const auto& [name, value] : reply.headers)
        to.set_header(name, value);
    if (reply.status != 204 && reply.status != 304)
        to.set_content(reply.body, reply.contentType);
}

void WebServer::Private::waitFor(std::chrono::milliseconds delay)
{
    std::unique_lock lock(mutex);
    stopped.wait_for(lock, delay, [this] { return stopping; });
}

WebServer::WebServer(std::unique_ptr<Private> theD) : d(std::move(theD)) { }

WebServer::~WebServer() = default;

Result<std::unique_ptr<WebServer>> WebServer::start(VirtualDrive& drive,
    const DriveProfile& profile, FaultPlan& faults, const WebServerOptions& options)
{
    auto made = std::make_unique<Private>(drive, profile, faults, options);
    AXISCOMP_CHECK(made->start());
    return std::unique_ptr<WebServer>(new WebServer(std::move(made)));
}

std::uint16_t WebServer::port() const
{
    return d->relay->port();
}

bool WebServer::isOnLoopbackOnly() const
{
    return d->relay->isOnLoopback();
}

std::string WebServer::url() const
{
    return d->address(port());
}

} // namespace axiscomp::drivecomm
