// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/even_spacing.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <vector>

namespace axiscomp::csv {

/// The positions of one dimension from the smallest to the largest.
class SortedPositions {
public:
    struct Place {
        double value;
        std::uint32_t id;
    };

    /// By id, which all are there from 0 on.
    explicit SortedPositions(std::vector<Place> places);

    /// Equal ones by their ids.
    [[nodiscard]] const std::vector<Place>& places() const { return m_places; }

private:
    std::vector<Place> m_places;
};

/// The distinct positions of one dimension.
struct GridLines {
    std::vector<double> positions; ///< increasing; closer ones are merged
    std::vector<double> reach; ///< by which the merged ones lie to both sides of it
    std::vector<std::uint32_t> lineOf; ///< by the id of a position
};

/// snap: how far a position may be off its line; closer than twice that is the same one. 0: only
/// what is the same but for rounding.
[[nodiscard]] GridLines gridLines(const SortedPositions& sorted, double snap);

/// An even line that keeps within the tolerance of all positions: by the roundest numbers, or else
/// the least-squares line.
[[nodiscard]] std::optional<EvenSpacing> spacingWithin(const GridLines& lines, double tolerance);

/// The tolerance with which positions that scatter would become a grid; 0: none does. mayMerge:
/// several positions may be on one grid line, which in a table of one dimension would be points
/// that occur twice.
[[nodiscard]] double suggestedSnap(const SortedPositions& sorted, bool mayMerge);

} // namespace axiscomp::csv
