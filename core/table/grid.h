// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

namespace axiscomp {

/// One dimension of an even grid: position(i) = start + i * distance, i = 0 .. size - 1.
struct GridAxis {
    std::string name; ///< the column's header without its unit, may be empty
    std::string unit; ///< "mm" of "X [mm]", shown and never converted; may be empty
    double start = 0.0; ///< finite
    double distance = 1.0; ///< > 0
    std::uint32_t size = 2; ///< >= 2

    [[nodiscard]] double position(std::size_t index) const
    {
        return start + static_cast<double>(index) * distance;
    }
    [[nodiscard]] double last() const { return position(size - 1); }
    friend bool operator==(const GridAxis&, const GridAxis&) = default;
};

/// 1 to 3 grid axes. Element order: dimension 1 fastest (spec/tamtbl.md).
struct Grid {
    std::vector<GridAxis> axes;

    [[nodiscard]] int dimensions() const { return static_cast<int>(axes.size()); }
    [[nodiscard]] std::size_t pointCount() const
    {
        std::size_t count = axes.empty() ? 0 : 1;
        for (const GridAxis& axis : axes)
            count *= axis.size;
        return count;
    }
    friend bool operator==(const Grid&, const Grid&) = default;
};

/// The same sizes, starts and distances, whatever the names and units.
[[nodiscard]] bool sameSpans(const Grid& a, const Grid& b);

/// One compensation value x_ref - x_enc per grid point, added to the encoder position (AN140 3.1).
struct CompensationTable {
    std::string name;
    std::string unit; ///< of the values, "um" of "Table 1 [um]"; may be empty
    Grid grid;
    std::vector<float> values; ///< grid.pointCount() finite values, dimension 1 fastest

    friend bool operator==(const CompensationTable&, const CompensationTable&) = default;
};

struct TableStatistics {
    double minimum = 0.0;
    double maximum = 0.0;
    double rms = 0.0;
};
[[nodiscard]] TableStatistics statistics(const CompensationTable& table);
[[nodiscard]] TableStatistics statisticsOf(std::span<const double> values);

} // namespace axiscomp
