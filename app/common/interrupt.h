// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <atomic>
#include <functional>
#include <mutex>
#include <stop_token>
#include <thread>

namespace axiscomp::app {

/// Turns SIGINT (Ctrl-C), SIGTERM and SIGHUP into a stop token while it lives, and makes a closed
/// pipe an error of write() instead of a signal. Must be made before any other thread: it blocks
/// the signals for all of them and takes them on a thread of its own, so no code runs in a signal
/// handler.
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
    /// Becomes readable with the first signal: for poll().
    [[nodiscard]] int wakeDescriptor() const { return m_wake; }

    /// As a signal does it; may be called on any thread.
    void request();

    /// Called with 1 for the first signal, 2 for the second, ..., on the
    /// thread of this object, or that of request().
    void setListener(std::function<void(int count)> listener);
    /// Until the first signal.
    void wait();

private:
    void takeSignals();

    std::stop_source m_source;
    int m_wake = -1;
    std::mutex m_mutex;
    int m_requests = 0;
    std::function<void(int)> m_listener;
    std::atomic<bool> m_done{false};
    std::jthread m_thread;
};

} // namespace axiscomp::app
