// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <chrono>
#include <cstddef>

namespace axiscomp::drivecomm {

/// When the bytes of one direction of a serial line arrive: ten bits each, one after the other.
class LinePace {
public:
    using Clock = std::chrono::steady_clock;

    /// 0: at once
    explicit LinePace(int baud) : m_byteTime(baud == 0 ? 0.0 : 10e9 / baud) { }

    /// Bytes that were ready at `now`. Those that follow without a pause take up the line's time
    /// where the last ones left it, however late somebody looked.
    [[nodiscard]] Clock::time_point arrivalOf(
        std::size_t bytes, bool followsWithoutPause, Clock::time_point now)
    {
        const auto begin = followsWithoutPause ? m_free : std::max(m_free, now);
        const std::chrono::duration<double, std::nano> time(
            m_byteTime * static_cast<double>(bytes));
        m_free = begin + std::chrono::duration_cast<Clock::duration>(time);
        return m_free;
    }

private:
    double m_byteTime; ///< ns
    Clock::time_point m_free;
};

} // namespace axiscomp::drivecomm
