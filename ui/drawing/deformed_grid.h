// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/compensation_table.h"
#include "core/table/contours.h"

#include <array>
#include <cstddef>
#include <memory>
#include <vector>

namespace axiscomp::ui {

/// A plane of errors: where the axes really are when their encoders read the points of a grid. The
/// compensation value is reference - encoder, so it is the way from the point to there.
struct ErrorPlane {
    using Table = std::shared_ptr<const CompensationTable>;
    std::array<Table, 2> errors; ///< along dimension 1 and 2, both 2D and on one grid
    std::array<double, 2> perValue{1.0, 1.0}; ///< positions of that dimension per unit of values

    [[nodiscard]] bool isValid() const { return errors[0] && errors[1]; }
    [[nodiscard]] const Grid& grid() const { return errors[0]->grid; }
    /// Where a grid point really is, in positions, its error so many times too large.
    [[nodiscard]] ContourPoint at(std::size_t i, std::size_t j, double exaggeration) const;
    /// The same of any place; beyond the grid the errors at its border hold.
    [[nodiscard]] ContourPoint at(const ContourPoint& place, double exaggeration) const;
    /// The largest error along a dimension, in its positions.
    [[nodiscard]] double largest(std::size_t dimension) const;
};

/// Which points of one dimension are drawn: every so many, the last one too.
struct DrawnLines {
    std::vector<std::size_t> lines; ///< of which a line is drawn
    std::vector<std::size_t> points; ///< of which lines across are made
    std::size_t step = 1;
};
/// from, to: what is in sight, in positions; most: of lines in sight.
[[nodiscard]] DrawnLines drawnLines(const GridAxis& axis, double from, double to, int most);

/// With this factor the largest error is about a tenth of the grid's extent.
[[nodiscard]] double fittingExaggeration(const ErrorPlane& plane);

} // namespace axiscomp::ui
