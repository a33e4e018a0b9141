// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/standard_streams.h"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstring>

namespace axiscomp::app {

namespace {

constexpr std::size_t chunkSize = 256 * 1024;

} // namespace

Result<bool> readMore(int descriptor, Interrupt& interrupt, std::string& text)
{
    // Signals do not interrupt a read here (they are taken by another thread), so wait for both.
    std::array<pollfd, 2> both{
        pollfd{descriptor, POLLIN, 0}, pollfd{interrupt.wakeDescriptor(), POLLIN, 0}};
    while (::poll(both.data(), both.size(), -1) < 0 && errno == EINTR) { }
    if (interrupt.stopped())
        return fail(ErrorCode::Cancelled);
    const std::size_t before = text.size();
    text.resize(before + chunkSize);
    ssize_t count = 0;
    do {
        count = ::read(descriptor, text.data() + before, chunkSize);
    } while (count < 0 && errno == EINTR);
    const int reason = errno;
    text.resize(before + static_cast<std::size_t>(count < 0 ? 0 : count));
    if (count < 0)
        return fail(ErrorCode::FileNotReadable,
            {{"file", Verbatim{"standard input"}}, {"reason", Verbatim{std::strerror(reason)}}});
    return count > 0;
}

Result<Input> waitForInput(Interrupt& interrupt, bool reads,
    std::chrono::steady_clock::time_point until, std::string& text)
{
    std::array<pollfd, 2> both{
        pollfd{interrupt.wakeDescriptor(), POLLIN, 0}, pollfd{STDIN_FILENO, POLLIN, 0}};
    while (!interrupt.stopped()) {
        const auto left =
            std::chrono::ceil<std::chrono::milliseconds>(until - std::chrono::steady_clock::now());
        const int timeout = static_cast<int>(std::max<std::int64_t>(left.count(), 0));
        const int ready = ::poll(both.data(), reads ? both.size() : 1, timeout);
        if (ready == 0)
            return Input::None;
        if (ready > 0 && reads && both[1].revents != 0 && !interrupt.stopped()) {
            AXISCOMP_TRY(const auto more, readMore(STDIN_FILENO, interrupt, text));
            return more ? Input::Some : Input::Ended;
        }
    }
    return fail(ErrorCode::Cancelled);
}

bool standardInputIsTerminal()
{
    return ::isatty(STDIN_FILENO) == 1;
}

Result<std::string> readStandardInput(Interrupt& interrupt, std::uint64_t maximumSize)
{
    std::string text;
    while (true) {
        AXISCOMP_TRY(const auto more, readMore(STDIN_FILENO, interrupt, text));
        if (!more)
            return text;
        if (text.size() > maximumSize)
            return fail(ErrorCode::FileTooLarge,
                {{"file", Verbatim{"standard input"}},
                    {"size", "more than " + std::to_string(maximumSize)},
                    {"limit", std::to_string(maximumSize)}});
    }
}

} // namespace axiscomp::app
