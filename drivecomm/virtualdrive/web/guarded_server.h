// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/virtualdrive/web/guarded_stream.h"

#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <exception>
#include <functional>
#include <string>
#include <type_traits>
#include <utility>

namespace axiscomp::drivecomm {

/// What a GuardedServer needs beside httplib's own settings.
struct ServerGuard {
    std::chrono::milliseconds patience{}; ///< GuardedStream
    std::chrono::milliseconds keepAlive{}; ///< a connection that says nothing
    std::function<std::string(const HeadFault&)> refusal; ///< the complete reply
};

/// httplib::Server or httplib::SSLServer on a loopback port, with GuardedStream in place of its own
/// connections: those wait for each byte anew, and take any number of header fields.
template <typename Server> class GuardedServer final : public Server {
public:
    template <typename... Arguments>
    explicit GuardedServer(ServerGuard guard, Arguments&&... arguments)
        : Server(std::forward<Arguments>(arguments)...)
        , m_guard(std::move(guard))
    {
    }

    /// The port; 0: there is none.
    int bindToLoopback()
    {
        this->set_tcp_nodelay(true); // accepted sockets have it from the listening one
        const int port = this->bind_to_any_port("127.0.0.1");
        return port > 0 && ::listen(this->svr_sock_, SOMAXCONN) == 0 ? port : 0;
    }

private:
    bool process_and_close_socket(socket_t socket) override
    {
        try {
            serve(socket);
        } catch (const std::exception&) { // no memory: this connection ends, the server goes on
        }
        ::shutdown(socket, SHUT_RDWR);
        ::close(socket);
        return true;
    }

    void serve(socket_t socket)
    {
        SSL_CTX* context = nullptr;
        if constexpr (std::is_same_v<Server, httplib::SSLServer>)
            context = this->ssl_context();
        GuardedStream stream(socket, context, m_guard.patience);
        if (!stream.greet())
            return;
        bool isClosed = false;
        while (!isClosed && stream.waitForRequest(m_guard.keepAlive)) {
            const GuardedStream::Head head = stream.readHead();
            if (head.fault) {
                const std::string reply = m_guard.refusal(*head.fault);
                stream.write(reply.data(), reply.size());
            }
            if (!head.isComplete || !this->process_request(stream, false, isClosed, nullptr))
                return;
        }
    }

    ServerGuard m_guard;
};

} // namespace axiscomp::drivecomm
