// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <cstddef>
#include <cstring>

namespace axiscomp {

/// A number of each of eight lines, which are worked out beside each other: the compiler makes
/// vectors of what every processor has that the program is built for. Such numbers are handed on by
/// reference, since how they would be by value depends on the processor.
using Eight = double __attribute__((vector_size(64)));

/// Where the numbers of eight lines stand.
class EightPlaces {
public:
    explicit EightPlaces(const std::array<std::size_t, 8>& offsets) : m_offsets(offsets)
    {
        for (std::size_t n = 1; n < offsets.size(); ++n)
            m_areNeighbours = m_areNeighbours && offsets[n] == offsets[0] + n;
    }

    void load(const double* from, Eight& numbers) const
    {
        if (m_areNeighbours) {
            std::memcpy(&numbers, from + m_offsets[0], sizeof numbers);
            return;
        }
        // One by one into memory and back as vectors, each would be waited for.
        const auto at = [&](std::size_t n) { return from[m_offsets[n]]; };
        numbers = Eight{at(0), at(1), at(2), at(3), at(4), at(5), at(6), at(7)};
    }
    void store(const Eight& numbers, double* to) const
    {
        if (m_areNeighbours) {
            std::memcpy(to + m_offsets[0], &numbers, sizeof numbers);
            return;
        }
        for (std::size_t n = 0; n < m_offsets.size(); ++n)
            to[m_offsets[n]] = numbers[n];
    }

private:
    std::array<std::size_t, 8> m_offsets;
    bool m_areNeighbours = true;
};

} // namespace axiscomp
