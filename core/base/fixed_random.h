// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/portable_math.h"

#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <numbers>

namespace axiscomp {

/// Random numbers that are the same on every machine and with every compiler, which the
/// distributions of `<random>` are not: SplitMix64 (Steele, Lea and Flood 2014), the upper 53 bits
/// as a fraction, and the method of Box and Muller.
class FixedRandom {
public:
    explicit FixedRandom(std::uint64_t seed) : m_state(seed) { }
    /// A sequence of its own for each list of words, in their order.
    FixedRandom(std::initializer_list<std::uint64_t> words)
    {
        for (const std::uint64_t word : words) {
            m_state ^= word;
            m_state = next();
        }
    }

    [[nodiscard]] std::uint64_t next()
    {
        m_state += 0x9E3779B97F4A7C15U;
        std::uint64_t mixed = m_state;
        mixed = (mixed ^ (mixed >> 30U)) * 0xBF58476D1CE4E5B9U;
        mixed = (mixed ^ (mixed >> 27U)) * 0x94D049BB133111EBU;
        return mixed ^ (mixed >> 31U);
    }
    /// Evenly from 0 to below 1.
    [[nodiscard]] double fraction() { return static_cast<double>(next() >> 11U) * 0x1p-53; }
    /// A whole number, each from least to most as often; most - least is below 2^53.
    [[nodiscard]] std::int64_t between(std::int64_t least, std::int64_t most)
    {
        return least
            + static_cast<std::int64_t>(
                std::floor(fraction() * (static_cast<double>(most - least) + 1.0)));
    }
    /// Normally distributed with mean 0 and standard deviation 1.
    [[nodiscard]] double normal()
    {
        const double radius = std::sqrt(-2.0 * portable::log(1.0 - fraction()));
        return radius * portable::cos(2.0 * std::numbers::pi * fraction());
    }

private:
    std::uint64_t m_state = 0;
};

} // namespace axiscomp
