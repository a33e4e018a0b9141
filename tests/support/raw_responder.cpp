// SPDX-License-Identifier: GPL-3.0-or-later
#include "tests/support/raw_responder.h"

#include <netinet/in.h>
#include <poll.h>
#include <sys/eventfd.h>
#include <sys/socket.h>
#include <unistd.h>

#include <atomic>
#include <cstdlib>
#include <thread>

namespace axiscomp::test {

namespace {

std::size_t contentLength(const std::string& head)
{
    for (const char* name : {"Content-Length: ", "content-length: "}) {
        const std::size_t place = head.find(name);
        if (place != std::string::npos)
            return std::strtoul(head.c_str() + place + 16, nullptr, 10);
    }
    return 0;
}

enum class Waited { Ready, TimeIsOver, ResponderEnds };

} // namespace

struct RawResponder::Private {
    std::function<void(RawConnection&)> serve;
    int listener = -1;
    int ending = ::eventfd(0, EFD_CLOEXEC);
    std::atomic<int> requests = 0;
    std::thread thread;

    Waited waitFor(int socket, short events, int milliseconds = -1) const
    {
        pollfd polled[] = {{socket, events, 0}, {ending, POLLIN, 0}};
        const int count = ::poll(polled, 2, milliseconds);
        if (count == 0)
            return Waited::TimeIsOver;
        return count > 0 && polled[1].revents == 0 ? Waited::Ready : Waited::ResponderEnds;
    }
    void run();
};

namespace {

class Connection final : public RawConnection {
public:
    using Wait = std::function<Waited(int, short, int)>;
    Connection(int socket, Wait wait, std::atomic<int>& requests)
        : m_socket(socket)
        , m_wait(std::move(wait))
        , m_requests(requests)
    {
    }
    ~Connection() override { ::close(m_socket); }

    std::string readRequest() override
    {
        while (true) {
            const std::size_t end = m_received.find("\r\n\r\n");
            if (end != std::string::npos) {
                const std::size_t size = end + 4 + contentLength(m_received.substr(0, end + 2));
                if (m_received.size() >= size) {
                    std::string request = m_received.substr(0, size);
                    m_received.erase(0, size);
                    ++m_requests;
                    return request;
                }
            }
            if (!receive(-1))
                return {};
        }
    }

    bool send(std::string_view bytes) override
    {
        while (!bytes.empty()) {
            if (m_wait(m_socket, POLLOUT, -1) != Waited::Ready)
                return false;
            const ssize_t sent =
                ::send(m_socket, bytes.data(), bytes.size(), MSG_NOSIGNAL | MSG_DONTWAIT);
            if (sent < 0)
                return false;
            bytes.remove_prefix(static_cast<std::size_t>(sent));
        }
        return true;
    }

    bool isStillThereAfter(std::chrono::milliseconds time) override
    {
        return m_wait(m_socket, POLLIN, static_cast<int>(time.count())) == Waited::TimeIsOver;
    }

    void waitUntilGone() override
    {
        while (receive(-1))
            m_received.clear();
    }

    void reset() override
    {
        const linger now{1, 0};
        ::setsockopt(m_socket, SOL_SOCKET, SO_LINGER, &now, sizeof now);
    }

private:
    bool receive(int milliseconds)
    {
        if (m_wait(m_socket, POLLIN, milliseconds) != Waited::Ready)
            return false;
        char buffer[65536];
        const ssize_t count = ::recv(m_socket, buffer, sizeof buffer, 0);
        if (count <= 0)
            return false;
        m_received.append(buffer, static_cast<std::size_t>(count));
        return true;
    }

    int m_socket;
    Wait m_wait;
    std::atomic<int>& m_requests;
    std::string m_received;
};

} // namespace

void RawResponder::Private::run()
{
    while (waitFor(listener, POLLIN) == Waited::Ready) {
        const int socket = ::accept4(listener, nullptr, nullptr, SOCK_CLOEXEC);
        if (socket < 0)
            continue;
        Connection connection(
            socket,
            [this](
                int s, short events, int milliseconds) { return waitFor(s, events, milliseconds); },
            requests);
        serve(connection);
    }
}

RawResponder::RawResponder(std::function<void(RawConnection&)> serve)
    : d(std::make_unique<Private>())
{
    d->serve = std::move(serve);
    d->listener = ::socket(AF_INET, SOCK_STREAM | SOCK_CLOEXEC, 0);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    ::bind(d->listener, reinterpret_cast<const sockaddr*>(&address), sizeof address);
    ::listen(d->listener, 64);
    d->thread = std::thread([this] { d->run(); });
}

RawResponder::~RawResponder()
{
    const std::uint64_t one = 1;
    [[maybe_unused]] const ssize_t written = ::write(d->ending, &one, sizeof one);
    d->thread.join();
    ::close(d->listener);
    ::close(d->ending);
}

std::uint16_t RawResponder::port() const
{
    sockaddr_in address{};
    socklen_t size = sizeof address;
    ::getsockname(d->listener, reinterpret_cast<sockaddr*>(&address), &size);
    return ntohs(address.sin_port);
}

std::string RawResponder::url() const
{
    return "http://127.0.0.1:" + std::to_string(port());
}

int RawResponder::requests() const
{
    return d->requests;
}

void neverAnswer(RawConnection& connection)
{
    connection.readRequest();
    connection.waitUntilGone();
}

std::string httpReply(
    std::string_view statusLine, std::string_view contentType, std::string_view body)
{
    return "HTTP/1.1 " + std::string(statusLine) + "\r\nContent-Type: " + std::string(contentType)
        + "\r\nContent-Length: " + std::to_string(body.size()) + "\r\n\r\n" + std::string(body);
}

} // namespace axiscomp::test
