// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>

namespace axiscomp {

/// Deviations of positions in a plane or in space, as an artefact shows them. All in one unit.
struct VectorDeviations {
    std::size_t dimensions = 2; ///< 2 or 3
    std::array<std::span<const double>, 3> positions;
    std::array<std::span<const double>, 3> deviations;
};

/// How an artefact lay: what of its deviations is no error of the machine. Small angles in rad.
///     d = translation + rotation x p + scale p        (2D: dx = tx - q y, dy = ty + q x)
struct RigidBody {
    std::array<double, 3> translation{};
    std::array<double, 3> rotation{}; ///< about X, Y, Z; in 2D only q, about Z
    double scale = 0.0; ///< 0 unless it was asked for
    /// By which the angle between the axes XY, XZ, YZ is below 90 degrees: slope of the first's
    /// deviation over the second and of the second's over the first, added. Whatever the rotation.
    std::array<double, 3> squareness{};

    /// d at a position; a third number of 0 in 2D.
    [[nodiscard]] std::array<double, 3> at(const std::array<double, 3>& position) const;
};

struct RigidBodyRequest {
    /// The axis (0, 1, 2) along which lines keep no slope, so that squareness stays in the tables
    /// of the others; none: least squares, by which it is shared out among both.
    std::optional<std::size_t> alongAxis = {};
    /// The artefact's scale is taken out as well, and with it the mean scale error of the axes.
    bool fitsScale = false;
};

/// By least squares over all points. Errors: InvalidArgument, also for points that lie on a line,
/// or in 3D on a plane.
[[nodiscard]] Result<RigidBody> fitRigidBody(
    const VectorDeviations& vectors, const RigidBodyRequest& request = {});

} // namespace axiscomp
