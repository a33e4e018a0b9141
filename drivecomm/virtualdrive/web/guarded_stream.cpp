// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/web/guarded_stream.h"

#include <openssl/err.h>

#include <arpa/inet.h>
#include <fcntl.h>
#include <netinet/in.h>
#include <poll.h>
#include <sys/socket.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <climits>
#include <cstring>

namespace axiscomp::drivecomm {

namespace {

/// A client that is slower than this for longer than the patience is not worth a connection.
constexpr std::uint64_t leastBytesPerSecond = 8 * 1024;
constexpr std::string_view emptyLine = "\r\n\r\n";

/// Both ends of every connection here are on the loopback interface (ConnectionRelay).
void describe(int (*ask)(int, sockaddr*, socklen_t*), int socket, std::string& ip, int& port)
{
    sockaddr_in address{};
    socklen_t size = sizeof address;
    if (ask(socket, reinterpret_cast<sockaddr*>(&address), &size) != 0
        || address.sin_family != AF_INET)
        return;
    std::array<char, INET_ADDRSTRLEN> text{};
    ::inet_ntop(AF_INET, &address.sin_addr, text.data(), text.size());
    ip = text.data();
    port = ntohs(address.sin_port);
}

} // namespace

GuardedStream::GuardedStream(int socket, SSL_CTX* context, std::chrono::milliseconds patience)
    : m_socket(socket)
    , m_patience(patience)
    , m_tls(context ? SSL_new(context) : nullptr, &SSL_free)
{
    ::fcntl(socket, F_SETFL, ::fcntl(socket, F_GETFL) | O_NONBLOCK);
    if (!m_tls)
        return;
    SSL_set_fd(m_tls.get(), socket);
    SSL_set_mode(m_tls.get(), SSL_MODE_ENABLE_PARTIAL_WRITE | SSL_MODE_ACCEPT_MOVING_WRITE_BUFFER);
}

GuardedStream::~GuardedStream()
{
    if (m_tls && SSL_is_init_finished(m_tls.get()) == 1) {
        ERR_clear_error();
        SSL_shutdown(m_tls.get());
    }
}

bool GuardedStream::greet()
{
    if (!m_tls)
        return true;
    const auto until = Clock::now() + m_patience;
    while (true) {
        ERR_clear_error();
        const int result = SSL_accept(m_tls.get());
        if (result == 1)
            return true;
        const Outcome outcome = outcomeOfTls(result);
        if (outcome.event == 0 || !waitFor(outcome.event, until))
            return false;
    }
}

bool GuardedStream::waitForRequest(std::chrono::milliseconds time)
{
    if (m_begin == m_buffer.size()) {
        m_buffer.clear();
        m_begin = 0;
        // TLS may hold bytes that poll does not know of.
        const bool isWaiting = m_tls && SSL_pending(m_tls.get()) > 0;
        if (!isWaiting && !waitFor(POLLIN, Clock::now() + time))
            return false;
    }
    m_request = {Clock::now()};
    m_reply.reset();
    return true;
}

GuardedStream::Head GuardedStream::readHead()
{
    m_buffer.erase(0, m_begin);
    m_begin = 0;
    std::size_t seen = 0;
    while (true) {
        const std::size_t end =
            m_buffer.find(emptyLine, seen - std::min(seen, emptyLine.size() - 1));
        const bool isComplete = end != std::string::npos;
        const std::size_t known = isComplete ? end + 2 : m_buffer.size();
        // A line's end that came in two pieces is looked at as a whole.
        const std::size_t from = seen - std::min<std::size_t>(seen, 2);
        const std::size_t first = from > 0 && m_buffer[from] == '\n' ? from - 1 : from;
        if (first < known)
            if (auto fault = illegalByte(std::string_view(m_buffer).substr(first, known - first)))
                return {false, std::move(fault)};
        if (isComplete) {
            auto fault = headFault(std::string_view(m_buffer).substr(0, end));
            const bool isGood = !fault;
            return {isGood, std::move(fault)};
        }
        if (m_buffer.size() >= mostHeadBytes)
            return {false, endlessHead(m_buffer)};
        seen = m_buffer.size();
        std::array<char, 4096> bytes{};
        const ssize_t count = readSome(bytes.data(), bytes.size());
        if (count <= 0)
            return {};
        m_buffer.append(bytes.data(), static_cast<std::size_t>(count));
    }
}

ssize_t GuardedStream::read(char* data, size_t size)
{
    if (m_begin == m_buffer.size())
        return readSome(data, size);
    const std::size_t count = std::min(size, m_buffer.size() - m_begin);
    std::memcpy(data, m_buffer.data() + m_begin, count);
    m_begin += count;
    return static_cast<ssize_t>(count);
}

ssize_t GuardedStream::readSome(char* data, std::size_t size)
{
    while (true) {
        // Also a client that always has one more byte must come to an end.
        if (Clock::now() >= deadline(m_request))
            return -1;
        const Outcome outcome = tryRead(data, size);
        if (outcome.count > 0)
            m_request.bytes += static_cast<std::uint64_t>(outcome.count);
        if (outcome.event == 0)
            return outcome.count;
        if (!waitFor(outcome.event, deadline(m_request)))
            return -1;
    }
}

ssize_t GuardedStream::write(const char* data, size_t size)
{
    if (!m_reply)
        m_reply = Progress{Clock::now()};
    std::size_t written = 0;
    while (written < size) {
        const Outcome outcome = tryWrite(data + written, size - written);
        if (outcome.count > 0) {
            written += static_cast<std::size_t>(outcome.count);
            m_reply->bytes += static_cast<std::uint64_t>(outcome.count);
        } else if (outcome.event == 0 || !waitFor(outcome.event, deadline(*m_reply))) {
            return -1;
        }
    }
    return static_cast<ssize_t>(written);
}

GuardedStream::Outcome GuardedStream::tryRead(char* data, std::size_t size)
{
    if (m_tls) {
        ERR_clear_error();
        const int count =
            SSL_read(m_tls.get(), data, static_cast<int>(std::min<std::size_t>(size, INT_MAX)));
        return count > 0 ? Outcome{count} : outcomeOfTls(count);
    }
    const ssize_t count = ::recv(m_socket, data, size, 0);
    const bool isEmpty = count < 0 && (errno == EAGAIN || errno == EINTR);
    return {count, static_cast<short>(isEmpty ? POLLIN : 0)};
}

GuardedStream::Outcome GuardedStream::tryWrite(const char* data, std::size_t size)
{
    if (m_tls) {
        ERR_clear_error();
        const int count =
            SSL_write(m_tls.get(), data, static_cast<int>(std::min<std::size_t>(size, INT_MAX)));
        return count > 0 ? Outcome{count} : outcomeOfTls(count);
    }
    const ssize_t count = ::send(m_socket, data, size, MSG_NOSIGNAL);
    const bool isFull = count < 0 && (errno == EAGAIN || errno == EINTR);
    return {count, static_cast<short>(isFull ? POLLOUT : 0)};
}

GuardedStream::Outcome GuardedStream::outcomeOfTls(int result) const
{
    switch (SSL_get_error(m_tls.get(), result)) {
    case SSL_ERROR_WANT_READ:
        return {-1, POLLIN};
    case SSL_ERROR_WANT_WRITE:
        return {-1, POLLOUT};
    case SSL_ERROR_ZERO_RETURN:
        return {0};
    default:
        return {-1};
    }
}

bool GuardedStream::waitFor(short event, Clock::time_point until) const
{
    while (true) {
        const auto left = std::chrono::ceil<std::chrono::milliseconds>(until - Clock::now());
        pollfd polled{m_socket, event, 0};
        const int ready = ::poll(
            &polled, 1, static_cast<int>(std::clamp<std::int64_t>(left.count(), 0, INT_MAX)));
        if (ready > 0 || (ready < 0 && errno != EINTR) || left.count() <= 0)
            return ready > 0;
    }
}

GuardedStream::Clock::time_point GuardedStream::deadline(const Progress& progress) const
{
    return progress.start + m_patience
        + std::chrono::milliseconds(progress.bytes * 1000 / leastBytesPerSecond);
}

void GuardedStream::get_remote_ip_and_port(std::string& ip, int& port) const
{
    describe(::getpeername, m_socket, ip, port);
}

void GuardedStream::get_local_ip_and_port(std::string& ip, int& port) const
{
    describe(::getsockname, m_socket, ip, port);
}

} // namespace axiscomp::drivecomm
