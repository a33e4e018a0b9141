// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/grid.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <string>
#include <vector>

namespace axiscomp {

/// One compensation value x_ref - x_enc per grid point, added to the encoder position (AN140 3.1).
struct CompensationTable {
    std::string name;
    std::string unit; ///< of the values, "um" of "Table 1 [um]"; may be empty
    Grid grid;
    std::vector<float> values; ///< grid.pointCount() finite values, dimension 1 fastest
    std::string target = {}; ///< the axis that is corrected, as stated (target_axis.h)
    /// Ascending: the points whose values were made up, not measured (missing_points.h).
    std::vector<std::uint32_t> filled = {};
    /// The axis that the file names where its headers do not tell whether that is a source.
    std::string statedAxis = {};
    /// The target is neither the file's nor a person's: it is what the drive suggests.
    bool isTargetOfDrive = false;

    friend bool operator==(const CompensationTable&, const CompensationTable&) = default;
};

struct TableStatistics {
    double minimum = 0.0;
    double maximum = 0.0;
    double rms = 0.0;
};
[[nodiscard]] TableStatistics statistics(const CompensationTable& table);
[[nodiscard]] TableStatistics statisticsOf(std::span<const double> values);

/// A table, and what can only be found out by looking at all of its values: found out once, on the
/// thread that has read the table.
struct LoadedTable {
    std::shared_ptr<const CompensationTable> table; ///< may be null
    std::size_t largestElement = 0; ///< index of the largest |value|, the first of several
};

[[nodiscard]] LoadedTable loaded(std::shared_ptr<const CompensationTable> table);

} // namespace axiscomp
