// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/interrupt.h"

#include <poll.h>
#include <pthread.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdint>

namespace axiscomp::app {

namespace {

sigset_t watchedSignals()
{
    sigset_t set;
    ::sigemptyset(&set);
    ::sigaddset(&set, SIGINT);
    ::sigaddset(&set, SIGTERM);
    // nohup ignores it on purpose.
    struct sigaction hangUp { };
    if (::sigaction(SIGHUP, nullptr, &hangUp) == 0 && hangUp.sa_handler != SIG_IGN)
        ::sigaddset(&set, SIGHUP);
    return set;
}

} // namespace

Interrupt::Interrupt() : Interrupt(Signals::AreTaken) { }

Interrupt::Interrupt(Signals signals) : m_wake(::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK))
{
    if (signals == Signals::AreLeftAlone)
        return;
    const sigset_t set = watchedSignals();
    ::pthread_sigmask(SIG_BLOCK, &set, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
    m_thread = std::jthread([this] { takeSignals(); });
}

Interrupt::~Interrupt()
{
    m_done = true;
    if (m_thread.joinable()) {
        ::pthread_kill(m_thread.native_handle(), SIGTERM);
        m_thread.join();
    }
    ::close(m_wake);
}

void Interrupt::setListener(std::function<void(int count)> listener)
{
    const std::lock_guard lock(m_mutex);
    m_listener = std::move(listener);
}

void Interrupt::wait()
{
    pollfd wake{m_wake, POLLIN, 0};
    while (!stopped() && (::poll(&wake, 1, -1) >= 0 || errno == EINTR)) { }
}

void Interrupt::takeSignals()
{
    const sigset_t set = watchedSignals();
    int signal = 0;
    while (::sigwait(&set, &signal) == 0 && !m_done)
        request();
}

void Interrupt::request()
{
    m_source.request_stop();
    const std::uint64_t one = 1;
    // A full counter is readable too, which is all that matters.
    static_cast<void>(::write(m_wake, &one, sizeof one) == sizeof one);
    const std::lock_guard lock(m_mutex);
    ++m_requests;
    if (m_listener)
        m_listener(m_requests);
}

} // namespace axiscomp::app
