// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/connection_relay.h"

#include "drivecomm/virtualdrive/socket.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <algorithm>
#include <atomic>
#include <cerrno>
#include <chrono>
#include <list>
#include <map>
#include <mutex>
#include <optional>
#include <thread>
#include <vector>

namespace axiscomp::drivecomm {

namespace {

using Clock = std::chrono::steady_clock;
using Fate = ConnectionRelay::Fate;

constexpr std::size_t bufferSize = 64 * 1024;
constexpr std::size_t mostConnections = 128;
/// For a client to read the end of a reply before bytes of its own, unread, reset the connection.
constexpr std::chrono::seconds farewell{2};
/// httplib takes a client that has said all it wants to say for one that is gone, and does not
/// answer it: it learns of that only when nothing was said on either side for this time.
constexpr std::chrono::milliseconds silence{250};

/// Bytes on their way from one socket to the other.
struct Lane {
    std::vector<char> bytes;
    std::size_t begin = 0;
    bool sourceEnded = false;
    bool endPassedOn = false;
    bool discards = false;

    [[nodiscard]] bool isEmpty() const { return begin == bytes.size(); }
    [[nodiscard]] bool wantsToRead() const { return !sourceEnded && isEmpty(); }
};

struct Connection {
    Socket client;
    Socket server;
    std::uint16_t serverSidePort = 0;
    Lane request;
    Lane reply;
    std::optional<Fate> fate;
    Clock::time_point lastPassed = Clock::now();
    std::optional<Clock::time_point> endRequestAt;
    std::optional<Clock::time_point> closeAt;
    bool isDead = false;
};

/// A socket of which nothing is wanted is left out: its hang-up would wake poll again and again.
pollfd watch(const Socket& socket, const Lane& readFrom, const Lane& writtenTo)
{
    const int events = (readFrom.wantsToRead() ? POLLIN : 0) | (writtenTo.isEmpty() ? 0 : POLLOUT);
    return {events == 0 ? -1 : socket.get(), static_cast<short>(events), 0};
}

/// False when the connection is broken.
bool readInto(Lane& lane, const Socket& source)
{
    lane.bytes.resize(bufferSize);
    lane.begin = 0;
    const ssize_t count = ::recv(source.get(), lane.bytes.data(), lane.bytes.size(), 0);
    const int error = errno;
    lane.bytes.resize(count > 0 && !lane.discards ? static_cast<std::size_t>(count) : 0);
    if (count == 0)
        lane.sourceEnded = true;
    return count >= 0 || error == EAGAIN || error == EINTR;
}

} // namespace

struct ConnectionRelay::Private {
    Private(Socket theListener, std::uint16_t theServerPort, FaultPlan& theFaults)
        : listener(std::move(theListener))
        , wake(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC))
        , serverPort(theServerPort)
        , faults(theFaults)
        , thread([this] { run(); })
    {
    }
    ~Private()
    {
        stopping = true;
        ring();
        thread.join();
    }

    void ring() const
    {
        const std::uint64_t one = 1;
        [[maybe_unused]] const ssize_t written = ::write(wake.get(), &one, sizeof one);
    }

    void run();
    void handle(Connection& connection, short clientEvents, short serverEvents);
    void applyFates();
    void accept();
    void pass(Connection& connection, Lane& lane, const Socket& target);
    static void passEnd(Connection& connection, Lane& lane, const Socket& target);
    [[nodiscard]] int timeUntilNextAction() const;

    Socket listener;
    Socket wake;
    std::uint16_t serverPort;
    FaultPlan& faults;
    std::list<Connection> connections;
    std::mutex mutex;
    std::map<std::uint16_t, Fate> decided;
    std::atomic<bool> stopping = false;
    std::thread thread;
};

void ConnectionRelay::Private::run()
{
    std::vector<pollfd> polled;
    while (!stopping) {
        polled.clear();
        polled.push_back({wake.get(), POLLIN, 0});
        const bool hasRoom = connections.size() < mostConnections;
        polled.push_back({hasRoom ? listener.get() : -1, POLLIN, 0});
        for (const Connection& each : connections) {
            polled.push_back(watch(each.client, each.request, each.reply));
            polled.push_back(watch(each.server, each.reply, each.request));
        }
        if (::poll(polled.data(), polled.size(), timeUntilNextAction()) < 0)
            continue;
        std::uint64_t rings = 0;
        [[maybe_unused]] const ssize_t read = ::read(wake.get(), &rings, sizeof rings);
        std::size_t i = 2;
        for (Connection& each : connections) {
            handle(each, polled[i].revents, polled[i + 1].revents);
            i += 2;
        }
        applyFates();
        std::erase_if(connections, [](const Connection& each) { return each.isDead; });
        if ((polled[1].revents & POLLIN) != 0)
            accept();
    }
    connections.clear();
}

void ConnectionRelay::Private::accept()
{
    Connection connection;
    connection.client = acceptFrom(listener);
    if (!connection.client.isOpen())
        return;
    connection.server = connectToLoopback(serverPort);
    if (!connection.server.isOpen())
        return;
    connection.serverSidePort = localPort(connection.server);
    connections.push_back(std::move(connection));
}

int ConnectionRelay::Private::timeUntilNextAction() const
{
    std::optional<Clock::time_point> next;
    for (const Connection& each : connections)
        for (const auto& time : {each.closeAt, each.endRequestAt})
            if (time && (!next || *time < *next))
                next = time;
    if (!next)
        return -1;
    const auto wait = std::chrono::ceil<std::chrono::milliseconds>(*next - Clock::now());
    return static_cast<int>(std::max<std::int64_t>(wait.count(), 0));
}

/// Decisions are made before the server replies, so whatever is read from it after this knows them.
void ConnectionRelay::Private::applyFates()
{
    const std::scoped_lock lock(mutex);
    if (decided.empty())
        return;
    for (Connection& each : connections) {
        const auto place = decided.find(each.serverSidePort);
        if (place == decided.end())
            continue;
        each.fate = place->second;
        each.isDead = each.fate == Fate::Cut;
        each.request.discards = each.reply.discards = each.fate == Fate::Silent;
    }
    // What is left is about connections that have ended; their ports will be used again.
    decided.clear();
}

void ConnectionRelay::Private::handle(Connection& c, short clientEvents, short serverEvents)
{
    constexpr short readable = POLLIN | POLLHUP | POLLERR;
    if (c.isDead)
        return;
    if ((clientEvents & readable) != 0 && c.request.wantsToRead()
        && !readInto(c.request, c.client)) {
        c.isDead = true;
        return;
    }
    if ((serverEvents & readable) != 0 && c.reply.wantsToRead()) {
        applyFates();
        if (c.isDead || !readInto(c.reply, c.server)) {
            // What the server still wanted to say is lost with it; the client must notice.
            c.isDead = c.fate != Fate::Silent;
            c.reply.sourceEnded = true;
            return;
        }
        if (c.fate == Fate::GarbledHead && !c.reply.isEmpty()) {
            for (std::size_t i = 0; i < std::min<std::size_t>(c.reply.bytes.size(), 8); i += 3)
                c.reply.bytes[i] = static_cast<char>(c.reply.bytes[i] ^ 0x15);
            c.fate.reset();
        }
    }
    pass(c, c.request, c.server);
    if (!c.isDead)
        pass(c, c.reply, c.client);
    if (c.isDead)
        return;
    const bool clientIsGone = c.request.sourceEnded && c.request.isEmpty();
    if (c.fate == Fate::Silent) {
        c.isDead = clientIsGone;
        return;
    }
    if (c.reply.endPassedOn) {
        c.request.discards = true;
        if (!c.closeAt)
            c.closeAt = Clock::now() + farewell;
        c.isDead = clientIsGone || Clock::now() >= *c.closeAt;
    }
}

void ConnectionRelay::Private::pass(Connection& c, Lane& lane, const Socket& target)
{
    while (!lane.isEmpty()) {
        std::size_t size = lane.bytes.size() - lane.begin;
        const std::optional<std::uint64_t> limit = faults.bytesUntilDrop();
        if (limit)
            size = static_cast<std::size_t>(std::min<std::uint64_t>(size, *limit));
        ssize_t sent = 0;
        if (size > 0) {
            sent = ::send(target.get(), lane.bytes.data() + lane.begin, size, MSG_NOSIGNAL);
            if (sent < 0 && (errno == EAGAIN || errno == EINTR || errno == ENOTCONN))
                return;
        }
        if (sent < 0) {
            c.isDead = &lane == &c.reply;
            lane.bytes.clear();
            lane.begin = 0;
            lane.discards = true;
            return;
        }
        lane.begin += static_cast<std::size_t>(sent);
        c.lastPassed = Clock::now();
        faults.countBytes(static_cast<std::uint64_t>(sent));
        if (limit && static_cast<std::uint64_t>(sent) == *limit) {
            c.isDead = true;
            return;
        }
    }
    if (lane.sourceEnded && !lane.endPassedOn && c.fate != Fate::Silent)
        passEnd(c, lane, target);
}

void ConnectionRelay::Private::passEnd(Connection& c, Lane& lane, const Socket& target)
{
    if (&lane == &c.request && !c.reply.sourceEnded && Clock::now() < c.lastPassed + silence) {
        c.endRequestAt = c.lastPassed + silence;
        return;
    }
    c.endRequestAt.reset();
    ::shutdown(target.get(), SHUT_WR);
    lane.endPassedOn = true;
}

ConnectionRelay::ConnectionRelay(std::unique_ptr<Private> theD) : d(std::move(theD)) { }

ConnectionRelay::~ConnectionRelay() = default;

Result<std::unique_ptr<ConnectionRelay>> ConnectionRelay::start(
    const std::string& host, std::uint16_t port, std::uint16_t serverPort, FaultPlan& faults)
{
    auto listener = listenOn(host, port);
    if (!listener)
        return fail(listener.error());
    return std::unique_ptr<ConnectionRelay>(
        new ConnectionRelay(std::make_unique<Private>(std::move(*listener), serverPort, faults)));
}

std::uint16_t ConnectionRelay::port() const
{
    return localPort(d->listener);
}

void ConnectionRelay::decide(std::uint16_t serverSidePort, Fate fate)
{
    {
        const std::scoped_lock lock(d->mutex);
        d->decided[serverSidePort] = fate;
    }
    d->ring();
}

} // namespace axiscomp::drivecomm
