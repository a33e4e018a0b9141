// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/web/connection_relay.h"

#include "drivecomm/virtualdrive/web/socket.h"

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
#include <set>
#include <thread>
#include <utility>
#include <vector>

namespace axiscomp::drivecomm {

namespace {

using Clock = std::chrono::steady_clock;
using Fate = ConnectionRelay::Fate;

/// After file descriptors ran out, so long no more connections than there were.
constexpr std::chrono::seconds shortage{1};
/// For a client to read the end of a reply before bytes of its own, unread, reset the connection.
constexpr std::chrono::seconds farewell{2};
/// httplib takes a client that has said all it wants to say for one that is gone, and does not
/// answer it: it learns of that only when nothing was said on either side for this time.
constexpr std::chrono::milliseconds silence{250};
constexpr std::size_t bufferSize = 64 * 1024;

/// Bytes on their way from one socket to the other.
struct RelayLane {
    std::vector<char> bytes;
    std::size_t begin = 0;
    bool sourceEnded = false;
    bool endPassedOn = false;
    bool discards = false;

    [[nodiscard]] bool isEmpty() const { return begin == bytes.size(); }
    [[nodiscard]] bool wantsToRead() const { return !sourceEnded && isEmpty(); }
};

/// A client, and the connection by which the server is asked for it.
struct Connection {
    Socket client;
    Socket server;
    std::uint16_t serverSidePort = 0;
    RelayLane request;
    RelayLane reply;
    std::optional<Fate> fate;
    Clock::time_point lastPassed = Clock::now();
    std::optional<Clock::time_point> endRequestAt;
    std::optional<Clock::time_point> closeAt;
    std::optional<Clock::time_point> replyWaitsSince; ///< the client does not take it
    Clock::time_point waitsSince = Clock::now(); ///< for a request that is complete
    bool answersRequest = false; ///< the server has it
    bool hasReplied = false; ///< and nothing was asked since
    bool isDead = false;

    /// A client has this time for its request before another one may take its place.
    static constexpr std::chrono::milliseconds protection{250};

    [[nodiscard]] Clock::time_point replaceableAt() const { return waitsSince + protection; }
};

/// What poll shall wait for at socket. One of which nothing is wanted is left out: its hang-up
/// would wake poll again and again.
pollfd watch(const Socket& socket, const RelayLane& readFrom, const RelayLane& writtenTo)
{
    const int events = (readFrom.wantsToRead() ? POLLIN : 0) | (writtenTo.isEmpty() ? 0 : POLLOUT);
    return {events == 0 ? -1 : socket.get(), static_cast<short>(events), 0};
}

/// False when the connection is broken.
bool readInto(RelayLane& lane, const Socket& source)
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
    Private(Socket theListener, std::uint16_t theServerPort, FaultPlan& theFaults,
        std::chrono::milliseconds thePatience)
        : listener(std::move(theListener))
        , wake(::eventfd(0, EFD_NONBLOCK | EFD_CLOEXEC))
        , serverPort(theServerPort)
        , faults(theFaults)
        , patience(thePatience)
        , thread([this] { run(); })
    {
    }
    ~Private() { stop(); }

    void stop()
    {
        stopping = true;
        ring();
        if (thread.joinable())
            thread.join();
        connections.clear();
    }

    void ring() const
    {
        const std::uint64_t one = 1;
        [[maybe_unused]] const ssize_t written = ::write(wake.get(), &one, sizeof one);
    }

    void run();
    void handle(Connection& connection, short clientEvents, short serverEvents);
    void applyFates();
    [[nodiscard]] std::optional<Clock::time_point> roomAt() const;
    [[nodiscard]] std::list<Connection>::const_iterator longestWaiting() const;
    bool makeRoom();
    void accept();
    void noteShortage(int error);
    [[nodiscard]] std::size_t mostNow() const
    {
        return Clock::now() < shortageEnds ? capacity : mostConnections;
    }
    void pass(Connection& connection, RelayLane& lane, const Socket& target);
    void passReply(Connection& connection);
    static void passEnd(Connection& connection, RelayLane& lane, const Socket& target);
    [[nodiscard]] int timeUntilNextAction(std::optional<Clock::time_point> next) const;

    Socket listener;
    Socket wake;
    std::uint16_t serverPort;
    FaultPlan& faults;
    std::chrono::milliseconds patience;
    std::size_t capacity = mostConnections;
    Clock::time_point shortageEnds{};
    std::list<Connection> connections;
    std::mutex mutex;
    std::map<std::uint16_t, Fate> decided;
    std::set<std::uint16_t> kept; ///< until their replies
    std::atomic<bool> stopping = false;
    std::thread thread;
};

void ConnectionRelay::Private::run()
{
    std::vector<pollfd> polled;
    while (!stopping) {
        polled.clear();
        polled.push_back({wake.get(), POLLIN, 0});
        const auto room = roomAt();
        const bool hasRoom = room && *room <= Clock::now();
        polled.push_back({hasRoom ? listener.get() : -1, POLLIN, 0});
        for (const Connection& each : connections) {
            polled.push_back(watch(each.client, each.request, each.reply));
            polled.push_back(watch(each.server, each.reply, each.request));
        }
        if (::poll(polled.data(), polled.size(), timeUntilNextAction(hasRoom ? std::nullopt : room))
            < 0)
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

/// When another client can be taken; nullopt: not before a reply has been sent.
std::optional<Clock::time_point> ConnectionRelay::Private::roomAt() const
{
    if (connections.size() < mostNow())
        return Clock::now();
    if (connections.empty())
        return shortageEnds;
    const auto next = longestWaiting();
    return next == connections.end() ? std::nullopt : std::optional(next->replaceableAt());
}

std::list<Connection>::const_iterator ConnectionRelay::Private::longestWaiting() const
{
    auto found = connections.end();
    for (auto each = connections.begin(); each != connections.end(); ++each)
        if (!each->answersRequest
            && (found == connections.end() || each->waitsSince < found->waitsSince))
            found = each;
    return found;
}

/// Ends the connection that has waited longest, if one has waited long enough.
bool ConnectionRelay::Private::makeRoom()
{
    const auto next = longestWaiting();
    if (next == connections.end() || next->replaceableAt() > Clock::now())
        return false;
    connections.erase(next);
    return true;
}

/// With fewer connections there are descriptors for the next client.
void ConnectionRelay::Private::noteShortage(int error)
{
    if (error != EMFILE && error != ENFILE && error != ENOBUFS && error != ENOMEM)
        return;
    capacity = connections.size();
    shortageEnds = Clock::now() + shortage;
}

void ConnectionRelay::Private::accept()
{
    if (connections.size() >= mostNow() && !makeRoom())
        return;
    Connection connection;
    connection.client = acceptFrom(listener);
    if (!connection.client.isOpen()) {
        noteShortage(errno);
        return;
    }
    connection.server = connectToLoopback(serverPort);
    if (!connection.server.isOpen()) {
        noteShortage(errno);
        if (!makeRoom())
            return;
        connection.server = connectToLoopback(serverPort);
        if (!connection.server.isOpen())
            return;
    }
    connection.serverSidePort = localPort(connection.server);
    connections.push_back(std::move(connection));
}

/// next: what there is to do beside the connections.
int ConnectionRelay::Private::timeUntilNextAction(std::optional<Clock::time_point> next) const
{
    const auto orEarlier = [&next](const std::optional<Clock::time_point>& time) {
        if (time && (!next || *time < *next))
            next = time;
    };
    for (const Connection& each : connections) {
        orEarlier(each.closeAt);
        orEarlier(each.endRequestAt);
        if (each.replyWaitsSince)
            orEarlier(*each.replyWaitsSince + patience);
    }
    if (!next)
        return -1;
    const auto wait = std::chrono::ceil<std::chrono::milliseconds>(*next - Clock::now());
    return static_cast<int>(std::max<std::int64_t>(wait.count(), 0));
}

/// Decisions are made before the server replies, so whatever is read from it after this knows them.
void ConnectionRelay::Private::applyFates()
{
    const std::scoped_lock lock(mutex);
    if (decided.empty() && kept.empty())
        return;
    for (Connection& each : connections) {
        each.answersRequest = each.answersRequest || kept.contains(each.serverSidePort);
        const auto place = decided.find(each.serverSidePort);
        if (place == decided.end())
            continue;
        each.fate = place->second;
        each.isDead = each.fate == Fate::Cut;
        each.answersRequest = each.answersRequest && each.fate != Fate::Silent;
        each.request.discards = each.reply.discards = each.fate == Fate::Silent;
    }
    // What is left is about connections that have ended; their ports will be used again.
    decided.clear();
    kept.clear();
}

void ConnectionRelay::Private::handle(Connection& c, short clientEvents, short serverEvents)
{
    constexpr short readable = POLLIN | POLLHUP | POLLERR;
    if (c.isDead)
        return;
    if ((clientEvents & readable) != 0 && c.request.wantsToRead()) {
        if (std::exchange(c.hasReplied, false))
            c.waitsSince = Clock::now();
        if (!readInto(c.request, c.client)) {
            c.isDead = true;
            return;
        }
    }
    if ((serverEvents & readable) != 0 && c.reply.wantsToRead()) {
        applyFates();
        if (c.isDead || !readInto(c.reply, c.server)) {
            // What the server still wanted to say is lost with it; the client must notice.
            c.isDead = c.fate != Fate::Silent;
            c.reply.sourceEnded = true;
            return;
        }
        c.answersRequest = false;
        c.hasReplied = true;
        c.waitsSince = Clock::now();
        if (c.fate == Fate::GarbledHead && !c.reply.isEmpty()) {
            for (std::size_t i = 0; i < std::min<std::size_t>(c.reply.bytes.size(), 8); i += 3)
                c.reply.bytes[i] = static_cast<char>(c.reply.bytes[i] ^ 0x15);
            c.fate.reset();
        }
    }
    pass(c, c.request, c.server);
    if (!c.isDead)
        passReply(c);
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

void ConnectionRelay::Private::pass(Connection& c, RelayLane& lane, const Socket& target)
{
    while (!lane.isEmpty()) {
        const auto carried = faults.carry(lane.bytes.size() - lane.begin, [&](std::size_t size) {
            return ::send(target.get(), lane.bytes.data() + lane.begin, size, MSG_NOSIGNAL);
        });
        if (carried.bytes < 0 && (errno == EAGAIN || errno == EINTR || errno == ENOTCONN))
            return;
        if (carried.bytes < 0) {
            c.isDead = &lane == &c.reply;
            lane.bytes.clear();
            lane.begin = 0;
            lane.discards = true;
            return;
        }
        lane.begin += static_cast<std::size_t>(carried.bytes);
        c.lastPassed = Clock::now();
        if (carried.isCut) {
            c.isDead = true;
            return;
        }
    }
    if (lane.sourceEnded && !lane.endPassedOn && c.fate != Fate::Silent)
        passEnd(c, lane, target);
}

/// Also a client that takes a byte now and then must come to an end.
void ConnectionRelay::Private::passReply(Connection& c)
{
    pass(c, c.reply, c.client);
    if (c.reply.isEmpty())
        c.replyWaitsSince.reset();
    else if (!c.replyWaitsSince)
        c.replyWaitsSince = Clock::now();
    else if (Clock::now() >= *c.replyWaitsSince + patience)
        c.isDead = true;
}

void ConnectionRelay::Private::passEnd(Connection& c, RelayLane& lane, const Socket& target)
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

Result<std::unique_ptr<ConnectionRelay>> ConnectionRelay::start(const std::string& host,
    std::uint16_t port, std::uint16_t serverPort, FaultPlan& faults,
    std::chrono::milliseconds patience)
{
    AXISCOMP_TRY(auto listener, listenOn(host, port));
    return std::unique_ptr<ConnectionRelay>(new ConnectionRelay(
        std::make_unique<Private>(std::move(listener), serverPort, faults, patience)));
}

std::uint16_t ConnectionRelay::port() const
{
    return localPort(d->listener);
}

bool ConnectionRelay::isOnLoopback() const
{
    return drivecomm::isOnLoopback(d->listener);
}

void ConnectionRelay::keepUntilReply(std::uint16_t serverSidePort)
{
    {
        const std::scoped_lock lock(d->mutex);
        d->kept.insert(serverSidePort);
    }
    d->ring();
}

void ConnectionRelay::stop()
{
    d->stop();
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
