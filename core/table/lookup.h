// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/compensation_table.h"

#include <array>
#include <cstddef>
#include <limits>
#include <span>

namespace axiscomp {

/// What a lookup answers outside the table. The drive holds the end values (assumption,
/// docs/drive.md).
enum class Outside {
    Hold, ///< the value at the nearest end
    Zero, ///< no compensation
    Wrap, ///< periodic with last - start: the first and the last point are the same place
    Extrapolate, ///< the first or last cell goes on
    Error, ///< quiet NaN
};

/// Linear, bilinear or trilinear lookup in an even table (AN140 3.1). The only interpolation of the
/// program: preview, virtual drive, command line and proof use it. Refers to the table's values and
/// must not outlive them. A NaN position gives NaN;
/// so does an infinite one that is wrapped or extrapolated.
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

    /// The fractional index of a position in dimension 0, 1 or 2, as the drive's Dim1Index to
    /// Dim3Index show it. Within the table 0 .. size - 1, whole exactly at the grid points.
    /// Outside: Hold holds it at the ends, Wrap wraps it, Zero and Extrapolate let it go on, Error
    /// gives NaN.
    [[nodiscard]] double index(int dimension, double position) const;

private:
    /// A dimension that the table lacks has the single position 0.
    struct Axis {
        double start = 0.0;
        double last = 0.0;
        double distance = 0.0;
        double perUnit = 0.0; ///< 1 / distance
        double cellStart = 0.0; ///< start, lower by more than the rounding error of a position
        double lastIndex = 0.0; ///< size - 1
        std::size_t lastPoint = 0; ///< the same
        std::size_t stride = 0;

        [[nodiscard]] bool contains(double position) const
        {
            return position >= start && position <= last;
        }
    };
    /// A grid point, and the way from there to the next one as a fraction of the distance.
    struct Place {
        std::size_t point = 0;
        double fraction = 0.0;
    };
    /// The same, as offsets into the values.
    struct Cell {
        std::size_t offset = 0;
        std::size_t step = 0; ///< to the next point; 0 behind the last one
        double fraction = 0.0;
    };
    [[nodiscard]] static Place heldPlace(const Axis& axis, double position);
    [[nodiscard]] static Cell heldCell(const Axis& axis, double position);
    [[nodiscard]] static Cell extrapolatedCell(const Axis& axis, double position);
    [[nodiscard]] static double wrapped(const Axis& axis, double position);
    [[nodiscard]] double blended(const std::array<Cell, 3>& cells) const;
    [[nodiscard]] double heldAt(double x, double y, double z) const;
    [[nodiscard]] double atOutside(double x, double y, double z) const;

    std::array<Axis, 3> m_axes;
    const float* m_values = nullptr;
    int m_dimensions = 0;
    Outside m_outside = Outside::Hold;
};

} // namespace axiscomp
