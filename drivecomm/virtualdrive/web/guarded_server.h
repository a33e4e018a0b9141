// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "drivecomm/virtualdrive/web/guarded_stream.h"

#include <httplib.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <string>
#include <system_error>
#include <thread>
#include <type_traits>
#include <utility>
#include <vector>

namespace axiscomp::drivecomm {

/// Threads for the connections of a server. httplib keeps one for each open connection; here they
/// are made when they are needed, so that many idle clients and a hanging one do not keep others
/// waiting and a server costs nothing before its first client.
class ConnectionThreads final : public httplib::TaskQueue {
public:
    explicit ConnectionThreads(std::size_t most) : m_most(most) { }

    void enqueue(std::function<void()> task) override
    {
        const std::scoped_lock lock(m_mutex);
        m_tasks.push_back(std::move(task));
        if (m_idle < m_tasks.size() && m_threads.size() < m_most)
            addThread();
        m_changed.notify_one();
    }

    void shutdown() override
    {
        {
            const std::scoped_lock lock(m_mutex);
            m_ending = true;
        }
        m_changed.notify_all();
        for (std::thread& thread : m_threads)
            thread.join();
    }

private:
    /// Without one the task waits for a thread that there is already, or for better times.
    void addThread()
    {
        try {
            m_threads.emplace_back([this] { work(); });
        } catch (const std::system_error&) {
        }
    }

    void work()
    {
        std::unique_lock lock(m_mutex);
        while (true) {
            ++m_idle;
            m_changed.wait(lock, [this] { return !m_tasks.empty() || m_ending; });
            --m_idle;
            if (m_tasks.empty())
                return;
            const std::function<void()> task = std::move(m_tasks.front());
            m_tasks.pop_front();
            lock.unlock();
            task();
            lock.lock();
        }
    }

    std::size_t m_most;
    std::mutex m_mutex;
    std::condition_variable m_changed;
    std::deque<std::function<void()>> m_tasks;
    std::vector<std::thread> m_threads;
    std::size_t m_idle = 0;
    bool m_ending = false;
};

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
