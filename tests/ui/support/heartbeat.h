// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QObject>
#include <QTimer>

#include <algorithm>
#include <chrono>
#include <ctime>

namespace axiscomp::test {

/// The longest time for which the event loop of this thread did not turn: by the clock, without the
/// time in which the thread was ready but other programs had the processor (where the system tells
/// it), and by the processor time that the thread itself used.
class Heartbeat : public QObject {
public:
    Heartbeat()
    {
        m_timer.setTimerType(Qt::PreciseTimer);
        m_timer.setInterval(1);
        connect(&m_timer, &QTimer::timeout, this, [this] { beat(); });
        restart();
        m_timer.start();
    }

    void restart()
    {
        m_last = Clock::now();
        m_lastDelay = delay();
        m_lastBusy = busy();
        m_longest = {};
        m_longestBusy = {};
        m_beats = 0;
    }
    [[nodiscard]] std::chrono::microseconds longest() const { return m_longest; }
    [[nodiscard]] std::chrono::microseconds longestBusy() const { return m_longestBusy; }
    [[nodiscard]] int beats() const { return m_beats; }

    /// The processor time that this thread has used.
    static std::chrono::microseconds busy()
    {
        timespec time{};
        ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
        return std::chrono::duration_cast<std::chrono::microseconds>(
            std::chrono::seconds(time.tv_sec) + std::chrono::nanoseconds(time.tv_nsec));
    }

private:
    using Clock = std::chrono::steady_clock;

    void beat()
    {
        const auto now = Clock::now();
        const auto waited = delay();
        const auto used = busy();
        const auto gap = (now - m_last) - (waited - m_lastDelay);
        m_longest = std::max(m_longest, std::chrono::duration_cast<std::chrono::microseconds>(gap));
        m_longestBusy = std::max(m_longestBusy, used - m_lastBusy);
        m_last = now;
        m_lastBusy = used;
        m_lastDelay = waited;
        ++m_beats;
    }

    /// How long this thread has waited for a processor (Linux schedstat).
    static std::chrono::nanoseconds delay()
    {
        QFile file(QStringLiteral("/proc/thread-self/schedstat"));
        if (!file.open(QIODevice::ReadOnly))
            return {};
        const QList<QByteArray> fields = file.readAll().simplified().split(' ');
        return std::chrono::nanoseconds(fields.size() > 1 ? fields[1].toLongLong() : 0);
    }

    QTimer m_timer;
    Clock::time_point m_last;
    std::chrono::nanoseconds m_lastDelay{0};
    std::chrono::microseconds m_lastBusy{0};
    std::chrono::microseconds m_longest{0};
    std::chrono::microseconds m_longestBusy{0};
    int m_beats = 0;
};

} // namespace axiscomp::test
