// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/fit/fit_parts.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string>
#include <vector>

namespace axiscomp {

using ScatteredNumbers = std::vector<double>;

/// What is fitted onto a grid: values at places, in one or more columns.
struct Scatter {
    std::vector<std::string> axes; ///< of each dimension
    std::vector<ScatteredNumbers> positions; ///< measured, [axis][point]
    struct Column {
        std::string name;
        std::string target;
        std::optional<std::size_t> own; ///< the dimension that it corrects
        ScatteredNumbers values;
        std::vector<ScatteredNumbers> places = {}; ///< where they belong, [axis][point]
        /// reference - encoder as it was read, without a gain and with how the artefact lay.
        ScatteredNumbers read = {};
        ScatteredNumbers body = {}; ///< how the artefact lay, which was taken out of the values
        /// For the zero of its table, with gain 1: at the set position the axis stands without it.
        double removed = 0.0;
    };
    std::vector<Column> columns;
    std::vector<Approach> directions = {}; ///< of each sample of a track

    [[nodiscard]] std::size_t dimensions() const { return axes.size(); }
    [[nodiscard]] std::size_t size() const { return positions.front().size(); }
    [[nodiscard]] bool hasBothDirections() const
    {
        return std::ranges::count(directions, Approach::Up) > 0
            && std::ranges::count(directions, Approach::Down) > 0;
    }
};

[[nodiscard]] Scatter scatterOfTrack(const FitInput& input, const AxisNames& names);
[[nodiscard]] Scatter scatterOfPoints(const FitInput& input);
/// The samples of a track that has its places, in one direction.
[[nodiscard]] Scatter inDirection(const Scatter& track, Approach direction);
/// How the artefact lay, as the settings ask for it, is taken out of the values. Errors:
/// InvalidArgument.
[[nodiscard]] Result<std::optional<RigidBody>> removeBody(const FitInput& input, Scatter& scatter);
/// What a column is merged onto. Errors: those of checkTableOver and findActiveTable.
[[nodiscard]] Result<ActiveTable> ontoOf(
    const FitInput& input, const Scatter::Column& column, std::span<const std::string> axes);
/// The share of the residuals that a gain takes, of a track that is merged onto a table.
void takeShare(const ActiveTable& onto, double gain, Scatter::Column& column);
/// Where the values of each column of points belong, and what they are there. Errors:
/// InvalidArgument.
[[nodiscard]] Result<void> placeColumns(const FitInput& input, Scatter& scatter);
/// The same of a track.
void placeTrack(const FitInput& input, const Scatter& scatter, Scatter::Column& column);

} // namespace axiscomp
