// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/neutral/knot_search.h"
#include "core/neutral/neutral_table.h"
#include "core/table/lookup.h"

#include <array>
#include <limits>
#include <span>
#include <vector>

namespace axiscomp {

/// What a controller makes of a table: the same numbers mean different corrections.
struct TableBehaviour {
    /// Hold, Zero or Extrapolate: dimension by dimension the first and the last cell go on. An axis
    /// with a wrap period wraps first, and is held where it has no knots. Wrap: each axis of a
    /// table of this controller has one; one without is held.
    Outside outside = Outside::Hold;
    bool startsAtFirst = false; ///< nothing until every source has reached its first value
    bool usesFloat = false; ///< values are float32 in the controller
};

/// A column of a table as a controller applies it: linear between the knots of each axis.
/// Refers to the table, which must outlive it.
class ControllerLookup {
public:
    /// column: index of a column of the table, which is consistent.
    ControllerLookup(
        const NeutralTable& table, std::size_t column, const TableBehaviour& behaviour);

    /// position: one number for each source axis, in the units of the axes. The value is in the
    /// unit of the column. A NaN gives NaN; with Extrapolate, so may an infinite position.
    [[nodiscard]] double at(std::span<const double> position) const
    {
        return along(0, position).at(position[0]);
    }

    /// Where a position lies among the knots of one axis.
    struct Place {
        std::size_t knot = 0;
        double fraction = 0.0; ///< of the way to the next knot; 0: there may be none
        bool appliesNothing = false; ///< outside, where the controller does
    };
    /// The same for every table of these axes and this behaviour. A NaN gives a NaN as the
    /// fraction.
    [[nodiscard]] Place placeOf(std::size_t axis, double position) const;

    /// The column along one axis, while the positions of the others stay: what these have to say is
    /// worked out once. Refers to the lookup, which must outlive it.
    class Line {
    public:
        /// What ControllerLookup::at answers there, with the same bits.
        [[nodiscard]] double at(const Place& place) const;
        [[nodiscard]] double at(double position) const
        {
            return at(m_lookup.placeOf(m_axis, position));
        }
        /// Works out the values at all knots: worth it for more positions than knots.
        void workOut();

    private:
        friend class ControllerLookup;
        Line(const ControllerLookup& lookup, std::size_t axis)
            : m_lookup(lookup)
            , m_axis(axis)
            , m_stride(lookup.m_axes[axis].stride)
        {
        }
        /// Points of the other axes, as the offset of their values, that have a part in the value.
        struct Row {
            std::size_t offset = 0;
            double weight = 1.0;
        };
        [[nodiscard]] double valueAt(std::size_t knot) const
        {
            return m_values.empty() ? mixedAt(knot) : m_values[knot];
        }
        [[nodiscard]] double mixedAt(std::size_t knot) const;

        const ControllerLookup& m_lookup;
        std::size_t m_axis;
        std::size_t m_stride;
        std::array<Row, 4> m_rows{};
        std::size_t m_rowCount = 1;
        bool m_isNoNumber = false; ///< another position is none
        bool m_appliesNothing = false; ///< because of another position
        std::vector<double> m_values; ///< at the knots; empty: not worked out
    };
    /// position: as above; that of the axis itself does not matter.
    [[nodiscard]] Line along(std::size_t axis, std::span<const double> position) const;

private:
    struct Axis {
        const SourceAxis& source;
        KnotSearch search;
        std::size_t stride = 0; ///< in the values
        InsideRange inside = {};
    };
    [[nodiscard]] double valueAt(std::size_t index) const
    {
        const double value = m_values[index];
        return m_behaviour.usesFloat ? static_cast<double>(static_cast<float>(value)) : value;
    }

    std::vector<Axis> m_axes;
    const std::vector<double>& m_values;
    TableBehaviour m_behaviour;
};

inline double ControllerLookup::Line::mixedAt(std::size_t knot) const
{
    double sum = 0.0;
    for (std::size_t i = 0; i < m_rowCount; ++i)
        sum += m_rows[i].weight * m_lookup.valueAt(m_rows[i].offset + knot * m_stride);
    return sum;
}

inline double ControllerLookup::Line::at(const Place& place) const
{
    if (m_isNoNumber) [[unlikely]]
        return std::numeric_limits<double>::quiet_NaN();
    if ((m_appliesNothing || place.appliesNothing) && place.fraction == place.fraction) [[unlikely]]
        return 0.0;
    const double value = valueAt(place.knot);
    if (place.fraction == 0.0)
        return value;
    return (1.0 - place.fraction) * value + place.fraction * valueAt(place.knot + 1);
}

} // namespace axiscomp
