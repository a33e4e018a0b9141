// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/serial/instrument_server.h"

#include "drivecomm/virtualdrive/serial/pseudo_terminal.h"

#include <poll.h>
#include <sys/eventfd.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <chrono>
#include <thread>

namespace axiscomp::drivecomm {

namespace {

using InstrumentClock = std::chrono::steady_clock;

std::string lineOf(double value, const std::string& unit)
{
    constexpr int decimals = 7;
    std::array<char, 64> digits{};
    const auto end = std::to_chars(
        digits.data(), digits.data() + digits.size(), value, std::chars_format::fixed, decimals);
    const std::string number(digits.data(), end.ptr);
    return (number.starts_with('-') ? "" : "+") + number + " " + unit + "\r\n";
}

} // namespace

struct InstrumentServer::Private {
    Private(std::function<double()> theReading, const InstrumentServerOptions& theOptions,
        PseudoTerminal theTerminal)
        : reading(std::move(theReading))
        , options(theOptions)
        , terminal(std::move(theTerminal))
        , device(terminal.device())
    {
    }
    ~Private()
    {
        const std::uint64_t one = 1;
        [[maybe_unused]] const ssize_t written = ::write(ending.get(), &one, sizeof one);
        if (thread.joinable())
            thread.join();
    }

    void run();
    void say();
    [[nodiscard]] bool wasAsked();

    std::function<double()> reading;
    InstrumentServerOptions options;
    PseudoTerminal terminal;
    std::string device;
    FileDescriptor ending{::eventfd(0, EFD_CLOEXEC)};
    std::thread thread;
};

/// The whole line or, where a client does not read, nothing.
void InstrumentServer::Private::say()
{
    const std::string line = lineOf(reading() * options.unitsPerPosition, options.unit);
    terminal.discardUnread();
    [[maybe_unused]] const ssize_t written =
        ::write(terminal.master().get(), line.data(), line.size());
}

bool InstrumentServer::Private::wasAsked()
{
    std::array<char, 256> request{};
    bool asked = false;
    while (true) {
        const ssize_t size = ::read(terminal.master().get(), request.data(), request.size());
        if (size <= 0)
            return asked;
        const std::string_view bytes(request.data(), static_cast<std::size_t>(size));
        asked = asked || bytes.find_first_of("\r\n") != std::string_view::npos;
    }
}

void InstrumentServer::Private::run()
{
    const auto period = std::chrono::nanoseconds(std::chrono::seconds(1)) / options.linesPerSecond;
    auto due = InstrumentClock::now();
    while (true) {
        const auto now = InstrumentClock::now();
        if (now >= due) {
            say();
            due = std::max(due + period, now);
        }
        std::array<pollfd, 2> polled{
            {{ending.get(), POLLIN, 0}, {terminal.master().get(), POLLIN, 0}}};
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(due - now);
        ::poll(polled.data(), polled.size(),
            static_cast<int>(std::max<std::int64_t>(0, left.count())));
        if (polled[0].revents != 0)
            return;
        if ((polled[1].revents & POLLIN) != 0 && wasAsked())
            say();
    }
}

InstrumentServer::InstrumentServer(std::unique_ptr<Private> theD) : d(std::move(theD)) { }

InstrumentServer::~InstrumentServer() = default;

Result<std::unique_ptr<InstrumentServer>> InstrumentServer::start(
    std::function<double()> reading, const InstrumentServerOptions& options)
{
    AXISCOMP_TRY(auto terminal, PseudoTerminal::open(options.link));
    auto made = std::make_unique<Private>(std::move(reading), options, std::move(terminal));
    made->thread = std::thread([d = made.get()] { d->run(); });
    return std::unique_ptr<InstrumentServer>(new InstrumentServer(std::move(made)));
}

const std::string& InstrumentServer::device() const
{
    return d->device;
}

} // namespace axiscomp::drivecomm
