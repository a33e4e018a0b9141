// SPDX-License-Identifier: GPL-3.0-or-later
#include "drivecomm/virtualdrive/web/socket.h"

#include <arpa/inet.h>
#include <netdb.h>
#include <netinet/in.h>
#include <netinet/tcp.h>
#include <sys/socket.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <memory>

namespace axiscomp::drivecomm {

namespace {

constexpr int backlog = SOMAXCONN; // a burst of clients, not a second for each that is dropped

void setOption(const Socket& socket, int level, int option)
{
    const int on = 1;
    ::setsockopt(socket.get(), level, option, &on, sizeof on);
}

std::string reasonOf(int error, std::uint16_t port)
{
    if (error == EADDRINUSE)
        return "port " + std::to_string(port)
            + " is in use; choose another one, or 0 for a free one";
    if (error == EACCES)
        return "ports below 1024 need privileges; choose a higher one";
    if (error == EADDRNOTAVAIL)
        return "this computer does not have that address";
    return std::strerror(error); // NOLINT(concurrency-mt-unsafe): glibc's is thread-safe
}

sockaddr_storage localAddress(const Socket& socket)
{
    sockaddr_storage address{};
    socklen_t size = sizeof address;
    if (::getsockname(socket.get(), reinterpret_cast<sockaddr*>(&address), &size) != 0)
        return {};
    return address;
}

} // namespace

std::string hostAndPort(const std::string& host, std::uint16_t port)
{
    const bool isIPv6 = host.find(':') != std::string::npos;
    return (isIPv6 ? "[" + host + "]" : host) + ":" + std::to_string(port);
}

Result<Socket> listenOn(const std::string& host, std::uint16_t port)
{
    const auto refused = [&](std::string reason) {
        return fail(ErrorCode::InvalidEndpoint,
            {{"endpoint", hostAndPort(host, port)}, {"reason", std::move(reason)}});
    };
    addrinfo hints{};
    hints.ai_socktype = SOCK_STREAM;
    hints.ai_flags = AI_PASSIVE | AI_NUMERICSERV;
    addrinfo* found = nullptr;
    if (const int code = ::getaddrinfo(host.c_str(), std::to_string(port).c_str(), &hints, &found))
        return refused(::gai_strerror(code));
    const std::unique_ptr<addrinfo, decltype(&::freeaddrinfo)> addresses(found, &::freeaddrinfo);
    int error = EADDRNOTAVAIL;
    for (const addrinfo* each = addresses.get(); each; each = each->ai_next) {
        Socket socket(::socket(each->ai_family, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
        if (!socket.isOpen()) {
            error = errno;
            continue;
        }
        setOption(socket, SOL_SOCKET, SO_REUSEADDR);
        if (::bind(socket.get(), each->ai_addr, each->ai_addrlen) == 0
            && ::listen(socket.get(), backlog) == 0)
            return socket;
        error = errno;
    }
    return refused(reasonOf(error, port));
}

Socket acceptFrom(const Socket& listener)
{
    Socket socket(::accept4(listener.get(), nullptr, nullptr, SOCK_NONBLOCK | SOCK_CLOEXEC));
    if (socket.isOpen())
        setOption(socket, IPPROTO_TCP, TCP_NODELAY);
    return socket;
}

Socket connectToLoopback(std::uint16_t port)
{
    Socket socket(::socket(AF_INET, SOCK_STREAM | SOCK_NONBLOCK | SOCK_CLOEXEC, 0));
    if (!socket.isOpen())
        return socket;
    setOption(socket, IPPROTO_TCP, TCP_NODELAY);
    sockaddr_in address{};
    address.sin_family = AF_INET;
    address.sin_port = htons(port);
    address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
    const int result =
        ::connect(socket.get(), reinterpret_cast<const sockaddr*>(&address), sizeof address);
    if (result != 0 && errno != EINPROGRESS)
        socket.close();
    return socket;
}

std::uint16_t localPort(const Socket& socket)
{
    const sockaddr_storage address = localAddress(socket);
    return ntohs(address.ss_family == AF_INET6
            ? reinterpret_cast<const sockaddr_in6&>(address).sin6_port
            : reinterpret_cast<const sockaddr_in&>(address).sin_port);
}

bool isOnLoopback(const Socket& socket)
{
    const sockaddr_storage address = localAddress(socket);
    if (address.ss_family == AF_INET6)
        return IN6_IS_ADDR_LOOPBACK(&reinterpret_cast<const sockaddr_in6&>(address).sin6_addr) != 0;
    const in_addr_t host = ntohl(reinterpret_cast<const sockaddr_in&>(address).sin_addr.s_addr);
    return host >> IN_CLASSA_NSHIFT == IN_LOOPBACKNET;
}

} // namespace axiscomp::drivecomm
