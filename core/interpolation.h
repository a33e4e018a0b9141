// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grid.h"

#include <array>
#include <limits>
#include <span>

namespace axiscomp {

/// What a lookup answers outside the table. The drive holds the end values (assumption,
/// docs/protocol.md).
enum class Outside {
    Hold, ///< the value at the nearest end
    Zero, ///< no compensation
    Wrap, ///< periodic with last - start: the first and the last point are the same place
    Extrapolate, ///< the first or last cell goes on
    Error, ///< quiet NaN
};

/// Linear, bilinear or trilinear lookup in an even table (AN140 3.1). The only interpolation of the
/// program: preview, virtual drive, command line and proof use it. Refers to the table's values and
/// must not outlive them. A NaN position gives NaN.
class Lookup {
public:
    /// table: consistent (values.size() == grid.pointCount(), 1 to 3 dimensions, sizes >= 2).
    explicit Lookup(const CompensationTable& table, Outside outside = Outside::Hold);

    [[nodiscard]] int dimensions() const { return m_dimensions; }
    [[nodiscard]] double at(double x) const;
    [[nodiscard]] double at(double x, double y) const;
    [[nodiscard]] double at(double x, double y, double z) const;
    /// positions.size() == dimensions()
    [[nodiscard]] double at(std::span<const double> positions) const;

    /// The fractional index of a position in dimension 0, 1 or 2, as the drive's Dim1Index ..
    /// Dim3Index show it: 0 .. size - 1, held at the ends when outside is Hold.
    [[nodiscard]] double index(int dimension, double position) const;

private:
    struct Axis {
        double start = 0.0;
        double last = 0.0;
        double perUnit = 1.0; ///< 1 / distance
        std::uint32_t size = 2;
        std::size_t stride = 1;
    };
    std::array<Axis, 3> m_axes;
    const float* m_values = nullptr;
    int m_dimensions = 0;
    Outside m_outside = Outside::Hold;
};

} // namespace axiscomp
