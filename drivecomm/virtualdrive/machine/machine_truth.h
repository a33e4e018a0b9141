// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/curve/cubic_curve.h"
#include "drivecomm/virtualdrive/machine/machine_description.h"

#include <span>
#include <vector>

namespace axiscomp::drivecomm {

/// On which side of its backlash an axis is: it must move through the width after a turn before it
/// is on the other one.
class ReversalState {
public:
    /// At a position, as if it had come from below.
    ReversalState(double width, double position);
    /// To a position without a turn on the way.
    void moveTo(double position);
    /// 0.5 after moving up, -0.5 after moving down, linear in between.
    [[nodiscard]] double side() const;

private:
    double m_width;
    double m_position;
    double m_middle; ///< of the backlash: it follows the axis, half of the width behind it
};

/// What one axis is doing when it is measured.
struct MeasuredInstant {
    double side = 0.5; ///< of the reversal
    double temperature = 20.0; ///< of the axis, in deg C
    std::uint64_t approach = 0; ///< the number of the movement
    std::uint64_t reading = 0; ///< the number of the reading, for example of the drive's tick
};

/// The true position of each axis of a machine for its raw positions u:
///     x = u + slope u + sum amplitude sin(2 pi u / period + phase) + map(u) + side * reversal
///       + expansion (T - 20) (u - fixedAt) + zeroPerKelvin (T - 20)
///       + the terms of other axes at their raw positions + noise
/// Everything random is a function of the seed, the axis and the numbers of the instant.
class MachineTruth {
public:
    explicit MachineTruth(MachineDescription description);

    [[nodiscard]] const MachineDescription& description() const { return m_description; }
    /// raw: of all axes, in mm or deg. The true position, without noise of the reading.
    [[nodiscard]] double position(
        std::size_t axis, std::span<const double> raw, const MeasuredInstant& instant) const;
    /// What the instrument says of it, in mm or deg: sign * (position + noise) + zero.
    [[nodiscard]] double reading(
        std::size_t axis, std::span<const double> raw, const MeasuredInstant& instant) const;

private:
    /// Of an axis itself, and of each other one.
    struct Maps {
        std::optional<CubicCurve> own;
        std::vector<std::optional<CubicCurve>> cross;
    };

    MachineDescription m_description;
    std::vector<Maps> m_maps;
};

/// The temperature of an axis that warms up: 20 + rise (1 - exp(-t / minutes)).
[[nodiscard]] double warmedUp(const WarmUp& warmUp, double minutes);

} // namespace axiscomp::drivecomm
