// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QFile>
#include <QObject>
#include <QTimer>

#include <algorithm>
#include <chrono>

namespace axiscomp::test {

/// The longest time for which the event loop of this thread did not turn. Time in which the thread
/// was ready but other programs had the processor does not count, where the system tells it.
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
        m_longest = {};
        m_beats = 0;
    }
    [[nodiscard]] std::chrono::microseconds longest() const { return m_longest; }
    [[nodiscard]] int beats() const { return m_beats; }

private:
    using Clock = std::chrono::steady_clock;

    void beat()
    {
        const auto now = Clock::now();
        const auto waited = delay();
        const auto gap = (now - m_last) - (waited - m_lastDelay);
        m_longest = std::max(m_longest, std::chrono::duration_cast<std::chrono::microseconds>(gap));
        m_last = now;
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
    std::chrono::microseconds m_longest{0};
    int m_beats = 0;
};

} // namespace axiscomp::test
