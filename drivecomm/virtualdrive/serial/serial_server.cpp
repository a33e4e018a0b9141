// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/serial/serial_server.h"

#include "drivecomm/link/drive_endpoint.h"
#include "drivecomm/virtualdrive/serial/pseudo_terminal.h"
#include "drivecomm/virtualdrive/serial/serial_conversation.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <sys/prctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <chrono>
#include <cstddef>
#include <mutex>
#include <thread>

namespace axiscomp::drivecomm {

namespace {

using Clock = std::chrono::steady_clock;

constexpr std::size_t chunk = 512; ///< what is on the line at one time
constexpr std::size_t mostWaiting = 256 * 1024; ///< of what nobody reads, before requests wait
/// The least between a question and its answer where the line itself takes no time. No real line is
/// quicker, and lrzsz empties its input after each answer that it gives: what comes at once is
/// lost.
constexpr std::chrono::microseconds turnaround{500};

/// When the bytes of one direction of a serial line arrive: ten bits each, one after the other.
class LinePace {
public:
    /// 0: at once
    explicit LinePace(int baud) : m_byteTime(baud == 0 ? 0.0 : 10e9 / baud) { }

    /// Bytes that were ready at `now`. Those that follow without a pause take up the line's time
    /// where the last ones left it, however late somebody looked.
    [[nodiscard]] Clock::time_point arrivalOf(
        std::size_t bytes, bool followsWithoutPause, Clock::time_point now)
    {
        const auto begin = followsWithoutPause ? m_free : std::max(m_free, now);
        const std::chrono::duration<double, std::nano> time(
            m_byteTime * static_cast<double>(bytes));
        m_free = begin + std::chrono::duration_cast<Clock::duration>(time);
        return m_free;
    }

private:
    double m_byteTime; ///< ns
    Clock::time_point m_free;
};

/// Bytes on their way through one direction.
struct Lane {
    explicit Lane(int baud) : pace(baud), leastPause(baud == 0 ? turnaround : turnaround.zero()) { }
    LinePace pace;
    std::chrono::microseconds leastPause;
    std::string bytes;
    Clock::time_point arrival;
    bool wasBusy = false; ///< no pause since the bytes before

    void begin(std::string what, Clock::time_point now)
    {
        bytes = std::move(what);
        arrival = pace.arrivalOf(bytes.size(), wasBusy, now);
        if (!wasBusy)
            arrival = std::max(arrival, now + leastPause);
        wasBusy = true;
    }
};

} // namespace

struct SerialServer::Private {
    Private(VirtualDrive& drive, FaultPlan& theFaults, const SerialServerOptions& theOptions,
        PseudoTerminal theTerminal)
        : faults(theFaults)
        , options(theOptions)
        , terminal(std::move(theTerminal))
        , conversation(drive, faults)
        , incoming(options.baud)
        , outgoing(options.baud)
    {
    }
    ~Private();

    void run();
    void wait();
    void receive(Clock::time_point now);
    void send(Clock::time_point now);
    void unplug();

    FaultPlan& faults;
    SerialServerOptions options;
    mutable std::mutex mutex; ///< of terminal, which others ask for its name
    PseudoTerminal terminal;
    SerialConversation conversation;
    Lane incoming;
    Lane outgoing;
    std::string waiting; ///< for the outgoing lane
    bool isFull = false; ///< the client does not read
    bool isGone = false; ///< there is no terminal any more
    FileDescriptor ending{::eventfd(0, EFD_CLOEXEC)};
    std::thread thread;
};

SerialServer::Private::~Private()
{
    const std::uint64_t one = 1;
    [[maybe_unused]] const ssize_t written = ::write(ending.get(), &one, sizeof one);
    if (thread.joinable())
        thread.join();
}

void SerialServer::Private::unplug()
{
    conversation.hangUp();
    incoming = Lane(options.baud);
    outgoing = Lane(options.baud);
    waiting.clear();
    isFull = false;
    auto fresh = PseudoTerminal::open(options.link);
    const std::scoped_lock lock(mutex);
    isGone = !fresh;
    if (fresh)
        terminal = *std::move(fresh);
}

void SerialServer::Private::receive(Clock::time_point now)
{
    while (!incoming.bytes.empty() && incoming.arrival <= now) {
        const auto left = faults.bytesUntilDrop();
        const std::size_t size = incoming.bytes.size();
        const bool isCut = left && *left <= size;
        const std::size_t whole = isCut ? static_cast<std::size_t>(*left) : size;
        conversation.feed(std::string_view(incoming.bytes).substr(0, whole), now);
        faults.countBytes(whole);
        if (isCut) {
            unplug();
            return;
        }
        incoming.bytes.clear();
    }
    if (!incoming.bytes.empty() || waiting.size() > mostWaiting)
        return;
    std::array<char, chunk> buffer{};
    const ssize_t size = ::read(terminal.master().get(), buffer.data(), buffer.size());
    if (size > 0)
        incoming.begin({buffer.data(), static_cast<std::size_t>(size)}, now);
    else
        incoming.wasBusy = false;
}

void SerialServer::Private::send(Clock::time_point now)
{
    waiting += conversation.output();
    while (true) {
        if (outgoing.bytes.empty()) {
            if (waiting.empty()) {
                outgoing.wasBusy = false;
                return;
            }
            outgoing.begin(waiting.substr(0, chunk), now);
            waiting.erase(0, chunk);
        }
        if (outgoing.arrival > now)
            return;
        const auto carried = faults.carry(outgoing.bytes.size(), [this](std::size_t size) {
            return ::write(terminal.master().get(), outgoing.bytes.data(), size);
        });
        isFull = carried.bytes < 0;
        if (isFull)
            return;
        outgoing.bytes.erase(0, static_cast<std::size_t>(carried.bytes));
        if (carried.isCut) {
            unplug();
            return;
        }
    }
}

void SerialServer::Private::wait()
{
    const bool reads = incoming.bytes.empty() && waiting.size() <= mostWaiting;
    const auto events = static_cast<short>((reads ? POLLIN : 0) | (isFull ? POLLOUT : 0));
    std::array<pollfd, 2> polled{
        {{ending.get(), POLLIN, 0}, {isGone ? -1 : terminal.master().get(), events, 0}}};
    auto until = conversation.wakeAt();
    const auto orEarlier = [&](Clock::time_point other) {
        until = std::min(until.value_or(other), other);
    };
    if (!incoming.bytes.empty())
        orEarlier(incoming.arrival);
    if (!outgoing.bytes.empty() && !isFull)
        orEarlier(outgoing.arrival);
    timespec time{};
    if (until) {
        const auto left = std::max(*until - Clock::now(), Clock::duration::zero());
        const auto seconds = std::chrono::duration_cast<std::chrono::seconds>(left);
        time.tv_sec = seconds.count();
        time.tv_nsec = std::chrono::nanoseconds(left - seconds).count();
    }
    ::ppoll(polled.data(), polled.size(), until ? &time : nullptr, nullptr);
    isFull = isFull && (polled[1].revents & POLLOUT) == 0;
}

void SerialServer::Private::run()
{
    // Timers are otherwise up to 50 us late, half a percent of the time of a block.
    ::prctl(PR_SET_TIMERSLACK, 1UL);
    pollfd ended{ending.get(), POLLIN, 0};
    while (::poll(&ended, 1, 0) <= 0) { // below 0: a signal came
        const auto now = Clock::now();
        if (!isGone) {
            receive(now);
            conversation.tick(now);
            send(now);
        }
        wait();
    }
}

SerialServer::SerialServer(std::unique_ptr<Private> theD) : d(std::move(theD)) { }

SerialServer::~SerialServer() = default;

Result<std::unique_ptr<SerialServer>> SerialServer::start(
    VirtualDrive& drive, FaultPlan& faults, const SerialServerOptions& options)
{
    AXISCOMP_TRY(auto terminal, PseudoTerminal::open(options.link));
    auto made = std::make_unique<Private>(drive, faults, options, std::move(terminal));
    made->thread = std::thread([d = made.get()] { d->run(); });
    return std::unique_ptr<SerialServer>(new SerialServer(std::move(made)));
}

std::string SerialServer::device() const
{
    const std::scoped_lock lock(d->mutex);
    return d->terminal.device();
}

std::string SerialServer::url() const
{
    DriveEndpoint endpoint;
    endpoint.kind = DriveEndpoint::Kind::Serial;
    endpoint.device = d->options.link.empty() ? device() : d->options.link;
    if (d->options.baud != 0)
        endpoint.baud = d->options.baud;
    return displayText(endpoint);
}

} // namespace axiscomp::drivecomm
