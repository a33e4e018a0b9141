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
        std::array<double, 8> found;
        for (std::size_t n = 0; n < found.size(); ++n)
            found[n] = from[m_offsets[n]];
        std::memcpy(&numbers, found.data(), sizeof numbers);
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
