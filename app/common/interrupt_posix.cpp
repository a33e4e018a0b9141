// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/common/interrupt.h"

#include <poll.h>
#include <pthread.h>
#include <sys/eventfd.h>
#include <unistd.h>

#include <atomic>
#include <cerrno>
#include <csignal>
#include <thread>

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

struct Interrupt::System {
    void takeSignals(Interrupt& interrupt) const
    {
        const sigset_t set = watchedSignals();
        int signal = 0;
        while (::sigwait(&set, &signal) == 0 && !done)
            interrupt.request();
    }

    int wake = ::eventfd(0, EFD_CLOEXEC | EFD_NONBLOCK);
    std::atomic<bool> done{false};
    std::jthread thread;
};

Interrupt::Interrupt(Signals signals) : m_system(std::make_unique<System>())
{
    if (signals == Signals::AreLeftAlone)
        return;
    const sigset_t set = watchedSignals();
    ::pthread_sigmask(SIG_BLOCK, &set, nullptr);
    std::signal(SIGPIPE, SIG_IGN);
    m_system->thread = std::jthread([this] { m_system->takeSignals(*this); });
}

Interrupt::~Interrupt()
{
    m_system->done = true;
    if (m_system->thread.joinable()) {
        ::pthread_kill(m_system->thread.native_handle(), SIGTERM);
        m_system->thread.join();
    }
    ::close(m_system->wake);
}

std::intptr_t Interrupt::wakeHandle() const
{
    return m_system->wake;
}

void Interrupt::wait()
{
    pollfd wake{m_system->wake, POLLIN, 0};
    while (!stopped() && (::poll(&wake, 1, -1) >= 0 || errno == EINTR)) { }
}

void Interrupt::wake()
{
    const std::uint64_t one = 1;
    // A full counter is readable too, which is all that matters.
    static_cast<void>(::write(m_system->wake, &one, sizeof one) == sizeof one);
}

} // namespace axiscomp::app
