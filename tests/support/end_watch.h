// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QSemaphore>

#include <chrono>
#include <future>

namespace axiscomp::test {

/// Whether something has ended in time: waits for that event on a thread of its own, because the
/// thread of the test is busy with ending it.
class EndWatch {
public:
    explicit EndWatch(std::chrono::milliseconds limit)
        : m_isInTime(std::async(std::launch::async,
            [this, limit] { return m_end.tryAcquire(1, static_cast<int>(limit.count())); }))
    {
    }

    /// It has ended now. True: within the limit.
    [[nodiscard]] bool ended()
    {
        m_end.release();
        return m_isInTime.get();
    }

private:
    QSemaphore m_end;
    std::future<bool> m_isInTime;
};

} // namespace axiscomp::test
