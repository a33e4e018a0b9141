// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/compensation_table.h"

#include <vector>

namespace axiscomp {

/// A place in the positions of a 2D table's two dimensions.
struct ContourPoint {
    double x = 0.0;
    double y = 0.0;
    friend bool operator==(const ContourPoint&, const ContourPoint&) = default;
};

/// Where a table has one value, in one piece: it ends at the border of the table, or is a ring
/// whose last point is its first.
struct ContourLine {
    std::vector<ContourPoint> points; ///< 2 or more
    [[nodiscard]] bool isRing() const
    {
        return points.size() > 2 && points.front() == points.back();
    }
};

struct Contour {
    double level = 0.0;
    std::vector<ContourLine> lines;
};

/// Multiples of 1, 2 or 5 times a power of ten that are above low and below high, as many as there
/// are up to most; none when there is nothing between.
[[nodiscard]] std::vector<double> roundLevels(double low, double high, int most);

/// About eight round levels within the values; none of a table with one value only.
[[nodiscard]] std::vector<double> contourLevels(const CompensationTable& table);

/// The contours of a 2D table as the drive interpolates it, a contour for each level; levels
/// ascending, at most 255 of them. A point with the level's very value counts as above. A coarse
/// table's lines have points between the grid lines too, since they are curved there. Finite
/// values. Takes a moment for large rough tables: not for the window's thread.
[[nodiscard]] std::vector<Contour> contours(
    const CompensationTable& table, const std::vector<double>& levels);

} // namespace axiscomp
