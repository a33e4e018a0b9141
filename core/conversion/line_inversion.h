// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/neutral/knot_search.h"
#include "core/neutral/table_motion.h"

#include <optional>

namespace axiscomp {

/// z + f(z) along one line of knots, and the z that belongs to a given sum: exact, since f is
/// linear between the knots. Beyond the knots f is held, or goes on as in the first and the last
/// cell (Outside::Extrapolate); on a modulo axis it repeats. Refers to the table.
class LineInversion {
public:
    struct Place {
        std::size_t knot = 0; ///< at or before the place
        /// Of the way to the next one; extrapolated it may be below 0 or above 1.
        double fraction = 0.0;
        double position = 0.0; ///< z, on a modulo axis within its period
    };

    /// first: the index of the line's first point, as in CompensationColumn::values.
    LineInversion(const NeutralTable& table, const Mover& mover, std::size_t first,
        Outside outside = Outside::Hold);
    LineInversion(const LineInversion&) = delete;
    LineInversion& operator=(const LineInversion&) = delete;

    /// The knot behind which the sum does not increase.
    [[nodiscard]] std::optional<std::size_t> fault() const;
    /// z + f(z) at a knot.
    [[nodiscard]] double sum(std::size_t knot) const { return m_sums[knot]; }
    /// What the axis is moved by at a knot, in the unit of its positions.
    [[nodiscard]] double offset(std::size_t knot) const { return m_offsets[knot]; }

    /// Without a fault, and the same at both ends of a modulo axis.
    [[nodiscard]] Place placeOf(double sum) const;
    [[nodiscard]] double valueAt(const std::vector<double>& values, const Place& place) const;

private:
    const SourceAxis& m_axis;
    std::size_t m_first;
    std::size_t m_stride;
    bool m_goesOn; ///< beyond the knots
    std::vector<double> m_offsets; ///< f at the knots
    std::vector<double> m_places; ///< the knots; a modulo axis ends with the first one again
    std::vector<double> m_sums; ///< z + f(z) at these
    std::optional<KnotSearch> m_search; ///< among the sums
};

/// Whether every sum along the axis that moves has one place. Errors: SignNotConvertible.
[[nodiscard]] Result<void> checkInvertible(const NeutralTable& table, const Mover& mover);

/// The largest sizes of df_n / dx_m; 0 for an axis that does not move.
using SlopeMatrix = std::array<std::array<double, 3>, 3>;

/// Whether z = knot - f(z) has one solution, which the iteration finds, with several axes that
/// move. The slopes df_n / dx_m of a table that is linear between knots are largest along the edges
/// of its cells; with their sizes as a matrix M the differences of two iterations shrink as the
/// powers of M do, whatever the units. They vanish when the principal minors of 1 - M are positive.
/// A table that goes on beyond its knots (Outside::Extrapolate) becomes steeper there: looked at is
/// as much of that as a place can need. Answers M. Errors: SignNotConvertible.
[[nodiscard]] Result<SlopeMatrix> checkContraction(
    const NeutralTable& table, const std::vector<Mover>& movers, Outside outside = Outside::Hold);

} // namespace axiscomp
