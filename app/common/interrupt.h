// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <functional>
#include <memory>
#include <mutex>
#include <stop_token>

namespace axiscomp::app {

/// Turns SIGINT (Ctrl-C), SIGTERM and SIGHUP into a stop token while it lives, and makes a closed
/// pipe an error of write() instead of a signal. Must be made before any other thread: it blocks
/// the signals for all of them and takes them on a thread of its own, so no code runs in a signal
/// handler. On Windows: Ctrl-C, Ctrl-Break, and what closes the console or ends the session, for
/// which the system waits some seconds only.
class Interrupt {
public:
    Interrupt();
    /// Of a program inside of another one, to which the signals belong: only request() stops.
    enum class Signals { AreTaken, AreLeftAlone };
    explicit Interrupt(Signals signals);
    Interrupt(const Interrupt&) = delete;
    Interrupt& operator=(const Interrupt&) = delete;
    ~Interrupt();

    [[nodiscard]] std::stop_token token() const { return m_source.get_token(); }
    [[nodiscard]] bool stopped() const { return m_source.stop_requested(); }
    /// What the system waits for, ready with the first signal: a descriptor to be read by poll(),
    /// on Windows the handle of an event.
    [[nodiscard]] std::intptr_t wakeHandle() const;

    /// As a signal does it; may be called on any thread.
    void request();

    /// Called with 1 for the first signal, 2 for the second, ..., on the
    /// thread of this object, or that of request().
    void setListener(std::function<void(int count)> listener);
    /// Until the first signal.
    void wait();

private:
    struct System; ///< interrupt_posix.cpp, interrupt_windows.cpp
    void wake();

    std::stop_source m_source;
    std::mutex m_mutex;
    int m_requests = 0;
    std::function<void(int)> m_listener;
    std::unique_ptr<System> m_system;
};

} // namespace axiscomp::app
