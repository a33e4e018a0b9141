// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/neutral/lookup_note.h"
#include "core/table/compensation_table.h"
#include "core/table/lookup.h"

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <vector>

namespace axiscomp {

/// A table that was active while it was measured.
struct ActiveTable {
    const CompensationTable* table = nullptr; ///< null: none; consistent; must live as long as the
                                              ///< frame
    double factor = 1.0; ///< from the unit of its values to that of the positions
    Outside outside = Outside::Hold; ///< Wrap on a modulo axis
};

/// Where a measured value belongs in a table, and what it is there; not in first order, but exact.
/// With P the target, r the deviation (reference - P) that was measured there, c what the active
/// tables add, and u the raw position:
///
///     lookup at | raw position          | knot                           | value
///     encoder   | u with u + c(u) = P   | u                              | c(u) + r
///     set       | u = P - c(P)          | P + r, the reference position  | c(P) + r
///
/// With raw readings on file, whatever was active: the knot is the reading (encoder) or the
/// reference position (set), the value is reference - reading.
/// With several axes u, P, r and c are vectors: a cross table moves with every axis whose table was
/// active. All positions and values in one unit.
class LookupFrame {
public:
    struct Point {
        std::array<double, 3> knot{}; ///< one number for each dimension
        double value = 0.0;
    };

    /// movers: for each dimension of the table that is made, the table that was active for that
    /// axis itself; corrected: the one for the axis that the values correct, which may be one of
    /// the same. All of them have these dimensions as their sources. Errors: InvalidArgument;
    /// SignNotConvertible where u + c(u) does not increase, so that a target has no one place.
    [[nodiscard]] static Result<LookupFrame> make(
        LookupAt lookupAt, std::vector<ActiveTable> movers, ActiveTable corrected);

    /// target: a number for each dimension. deviation: of the axis that is corrected. moved: the
    /// deviations of the dimensions themselves, for Set; 0 where they were not measured. Errors:
    /// NotConverged.
    [[nodiscard]] Result<Point> atTarget(
        std::span<const double> target, double deviation, std::span<const double> moved) const;

    /// One dimension, its own axis corrected.
    [[nodiscard]] Result<Point> atTarget(double target, double deviation) const
    {
        return atTarget({&target, 1}, deviation, {&deviation, 1});
    }

    /// The raw position at which the axes stand on a target. Errors: NotConverged.
    [[nodiscard]] Result<std::array<double, 3>> rawPosition(std::span<const double> target) const;

private:
    struct Correction {
        std::optional<Lookup> lookup;
        double factor = 1.0;
        double lowest = 0.0; ///< of all values, times factor
        double highest = 0.0;

        explicit Correction(const ActiveTable& active);
        [[nodiscard]] double at(std::span<const double> position) const
        {
            return lookup ? factor * lookup->at(position) : 0.0;
        }
    };
    LookupFrame(
        LookupAt lookupAt, const std::vector<ActiveTable>& movers, const ActiveTable& corrected);
    void settle(std::span<double> position, std::size_t axis, double target) const;

    LookupAt m_lookupAt;
    std::vector<Correction> m_movers;
    Correction m_corrected;
};

/// The same by a raw reading. reading, reference: of the table's dimensions.
[[nodiscard]] LookupFrame::Point pointOfReading(LookupAt lookupAt, std::span<const double> reading,
    std::span<const double> reference, double value);

} // namespace axiscomp
