// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>

namespace axiscomp {

/// Finds positions among ascending knots. Those of most tables are even, so that it looks first
/// where an even one would be. Refers to the knots.
class KnotSearch {
public:
    /// knots: at least 2, strictly ascending.
    explicit KnotSearch(std::span<const double> knots)
        : m_knots(knots)
        , m_lastIndex(static_cast<double>(knots.size() - 1))
        , m_perPosition(m_lastIndex / (knots.back() - knots.front()))
    {
    }

    /// How many knots are at or below the position, which is a number: the index of the first one
    /// above it.
    [[nodiscard]] std::size_t firstAbove(double position) const
    {
        const double index = (position - m_knots.front()) * m_perPosition;
        // The order of the comparisons holds what is no number at the end.
        const double held = index < m_lastIndex ? index : m_lastIndex;
        const std::size_t guess = held > 0.0 ? static_cast<std::size_t>(held) + 1 : 0;
        if (isFirstAbove(guess, position)) [[likely]]
            return guess;
        if (isFirstAbove(guess - 1, position)) // by rounding; -1 is none
            return guess - 1;
        return static_cast<std::size_t>(
            std::ranges::upper_bound(m_knots, position) - m_knots.begin());
    }

private:
    [[nodiscard]] bool isFirstAbove(std::size_t i, double position) const
    {
        return i <= m_knots.size() && (i == m_knots.size() || position < m_knots[i])
            && (i == 0 || m_knots[i - 1] <= position);
    }

    std::span<const double> m_knots;
    double m_lastIndex;
    double m_perPosition;
};

} // namespace axiscomp
