// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/input_stream.h"

#include "core/io/local_file.h"

#include <fcntl.h>
#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <utility>

namespace axiscomp::app {

namespace {

constexpr std::size_t chunkSize = 256 * 1024;

std::error_code codeOf(int errorNumber)
{
    return {errorNumber, std::generic_category()};
}

} // namespace

struct InputStream::Source {
    explicit Source(int opened) : descriptor(opened) { }
    Source(const Source&) = delete;
    Source& operator=(const Source&) = delete;
    ~Source()
    {
        if (descriptor != STDIN_FILENO)
            ::close(descriptor);
    }

    int descriptor;
};

InputStream::InputStream(std::string name, std::shared_ptr<Source> source)
    : m_name(std::move(name))
    , m_source(std::move(source))
{
}

InputStream::InputStream(InputStream&& other) noexcept = default;
InputStream& InputStream::operator=(InputStream&& other) noexcept = default;
InputStream::~InputStream() = default;

InputStream InputStream::standardInput()
{
    return {"standard input", std::make_shared<Source>(STDIN_FILENO)};
}

Result<InputStream> InputStream::open(const std::string& file)
{
    const int descriptor = ::open(file.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
        return fail(ErrorCode::FileNotReadable,
            {{"file", file}, {"reason", fileErrorReason(codeOf(errno))}});
    return InputStream(file, std::make_shared<Source>(descriptor));
}

tl::unexpected<Error> InputStream::notReadable(const std::error_code& error) const
{
    return fail(ErrorCode::FileNotReadable,
        {{"file", Verbatim{m_name}}, {"reason", fileErrorReason(error)}});
}

Result<bool> InputStream::readMore(Interrupt& interrupt, std::string& text)
{
    // Signals do not interrupt a read here (they are taken by another thread), so wait for both.
    std::array<pollfd, 2> both{pollfd{m_source->descriptor, POLLIN, 0},
        pollfd{static_cast<int>(interrupt.wakeHandle()), POLLIN, 0}};
    while (::poll(both.data(), both.size(), -1) < 0 && errno == EINTR) { }
    if (interrupt.stopped())
        return fail(ErrorCode::Cancelled);
    const std::size_t before = text.size();
    text.resize(before + chunkSize);
    ssize_t count = 0;
    do {
        count = ::read(m_source->descriptor, text.data() + before, chunkSize);
    } while (count < 0 && errno == EINTR);
    const int reason = errno;
    text.resize(before + static_cast<std::size_t>(count < 0 ? 0 : count));
    if (count < 0)
        return notReadable(codeOf(reason));
    return count > 0;
}

Result<Input> InputStream::waitForInput(Interrupt& interrupt, bool reads,
    std::chrono::steady_clock::time_point until, std::string& text)
{
    std::array<pollfd, 2> both{pollfd{static_cast<int>(interrupt.wakeHandle()), POLLIN, 0},
        pollfd{m_source->descriptor, POLLIN, 0}};
    while (!interrupt.stopped()) {
        const auto left =
            std::chrono::ceil<std::chrono::milliseconds>(until - std::chrono::steady_clock::now());
        const int timeout = static_cast<int>(std::max<std::int64_t>(left.count(), 0));
        const int ready = ::poll(both.data(), reads ? both.size() : 1, timeout);
        if (ready == 0)
            return Input::None;
        if (ready > 0 && reads && both[1].revents != 0 && !interrupt.stopped()) {
            AXISCOMP_TRY(const auto more, readMore(interrupt, text));
            return more ? Input::Some : Input::Ended;
        }
    }
    return fail(ErrorCode::Cancelled);
}

} // namespace axiscomp::app
