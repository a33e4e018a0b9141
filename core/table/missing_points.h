// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/text/diagnostic.h"

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

/// What becomes of the points of a grid that have no value: unprobed corners, round beds.
/// Distances are those of the positions where all dimensions have the same unit, otherwise they
/// count in mean grid spacings.
enum class MissingPoints {
    Refuse,
    Nearest, ///< the value of the nearest measured point; of several, of one of them
    Plane, ///< the least-squares plane (in 1D: line) through all measured points
    Smooth, ///< the values that bend least: the smallest sum of squared second differences
    Crop, ///< the grid is cut to the most points that form a full grid
};

/// Tables over one grid whose points need not all have a value.
struct IncompleteGrid {
    std::vector<std::vector<double>> knots; ///< per dimension, at least 2, ascending
    std::vector<Text> names; ///< of the dimensions, for the warnings
    std::vector<std::string> units; ///< of the dimensions
    std::vector<std::vector<double>> tables; ///< dimension 1 fastest; NaN: no value
    std::vector<Text> tableNames;
    std::vector<std::string> valueUnits; ///< of the tables
};

struct CompletedGrid {
    std::vector<std::vector<double>> knots; ///< all of them, or those of a part
    std::array<std::size_t, 3> first{}; ///< of each dimension: where the part begins
    std::vector<std::vector<double>> tables; ///< finite
    std::vector<std::vector<std::uint32_t>> filled; ///< per table, ascending: made, not measured
};

/// "12 of 121 points of Z are filled, not measured": as files keep it.
[[nodiscard]] std::string filledNote(std::string_view table, std::size_t filled, std::size_t all);

/// With warnings FilledPoints or CroppedGrid that say what was done, and with which numbers.
/// Nothing: that is not possible, and an error MissingPoint says why. A grid without gaps stays as
/// it is.
[[nodiscard]] std::optional<CompletedGrid> completeGrid(
    IncompleteGrid grid, MissingPoints choice, DiagnosticList& diagnostics);

} // namespace axiscomp
