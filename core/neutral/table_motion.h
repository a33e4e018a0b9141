// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/neutral/controller_lookup.h"

#include <array>
#include <optional>
#include <span>
#include <utility>
#include <vector>

namespace axiscomp {

/// What NeutralTable demands: 1 to 3 axes, ascending finite knots, periods that are not shorter
/// than the knots, a finite value for each point. Errors: InvalidArgument.
[[nodiscard]] Result<void> checkConsistent(const NeutralTable& table);

/// How many `to` one `from` is; units that are not known are taken to be the same. Errors:
/// InvalidArgument when one is a length and the other an angle; what: "values for X".
[[nodiscard]] Result<double> factorBetween(std::string_view from, std::string_view to, Text what);

/// One number for each axis.
using Position = std::array<double, 3>;
/// The position of a point; index: as in CompensationColumn::values.
[[nodiscard]] Position knotPosition(const NeutralTable& table, std::size_t index);
/// "40 mm", "X = 40 mm, Y = 10 mm".
[[nodiscard]] Argument positionText(const NeutralTable& table, std::span<const double> position);
/// "40 mm", with 12 digits.
[[nodiscard]] Quantity quantityOf(double number, const std::string& unit);
/// The stride of an axis in CompensationColumn::values.
[[nodiscard]] std::size_t strideOf(const NeutralTable& table, std::size_t axis);

/// The lines of points along one axis, by their number.
struct TableLines {
    std::size_t stride = 1; ///< from one point of a line to the next
    std::size_t length = 0; ///< points of each
    std::size_t count = 0;

    TableLines(const NeutralTable& table, std::size_t axis);
    /// The index of its first point, as in CompensationColumn::values.
    [[nodiscard]] std::size_t first(std::size_t line) const
    {
        return line / stride * stride * length + line % stride;
    }
    /// How many of them make a part of work that is worth a thread's while.
    [[nodiscard]] std::size_t perPart() const;
    [[nodiscard]] std::size_t parts() const { return (count + perPart() - 1) / perPart(); }
};

/// Whether the knots of a modulo axis cover its whole period: the last is the first again.
[[nodiscard]] bool isFullTurn(const SourceAxis& axis);

/// What moves the place of an axis: the columns that act on it, mostly one.
struct Mover {
    struct Part {
        std::size_t column = 0;
        double factor = 1.0; ///< from the unit of the column to that of the axis
    };
    std::size_t axis = 0;
    std::vector<Part> parts; ///< to be added
};

/// The own axis of each column (ownAxis).
using OwnAxes = std::vector<std::optional<std::size_t>>;
[[nodiscard]] OwnAxes ownAxesOf(const NeutralTable& table);

/// The movers for a direction of motion; Both: the mean of both directions. Errors:
/// InvalidArgument for two columns that act on one axis in the same direction, and for values that
/// are no positions of their axis.
[[nodiscard]] Result<std::vector<Mover>> moversOf(
    const NeutralTable& table, const OwnAxes& ownAxes, Direction direction);

/// Where a table moves a position by the corrections of its own axes. Refers to the table.
class Motion {
public:
    Motion(const NeutralTable& table, const TableBehaviour& behaviour,
        const std::vector<Mover>& movers);

    /// What the table adds to a position, in the units of the axes.
    [[nodiscard]] Position offset(std::span<const double> position) const;

    /// What it adds along one axis, while the positions of the others stay. Refers to the motion,
    /// which must outlive it.
    class Line {
    public:
        [[nodiscard]] double offset(const ControllerLookup::Place& place) const
        {
            double offset = 0.0;
            for (const auto& [column, factor] : m_parts)
                offset += factor * column.at(place);
            return offset;
        }
        void workOut()
        {
            for (auto& [column, factor] : m_parts)
                column.workOut();
        }

    private:
        friend class Motion;
        std::vector<std::pair<ControllerLookup::Line, double>> m_parts; ///< with their factors
    };
    /// position: that of the axis itself does not matter.
    [[nodiscard]] Line along(std::size_t axis, std::span<const double> position) const;

private:
    struct Part {
        ControllerLookup column;
        std::size_t axis;
        double factor;
    };
    std::vector<Part> m_parts;
};

} // namespace axiscomp
