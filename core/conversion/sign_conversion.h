// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/neutral/controller_lookup.h"
#include "core/neutral/neutral_table.h"

#include <optional>

namespace axiscomp {

/// A table whose numbers mean the other convention (docs/formats.md).
struct SignConversion {
    NeutralTable table;
    int iterations = 0; ///< the most that a point needed; 0: every point is solved exactly
    /// The largest |r + f(knot + r)| at a knot, with the source f and the result r; in the unit of
    /// the column.
    double residual = 0.0;
    /// Places beyond the knots were needed, where the source's controller applies nothing. There
    /// the end values were held: at the step no place would belong to the knot.
    bool usesHeldEnds = false;
};

/// At which knots a converted table stands.
enum class ConvertedKnots {
    Same, ///< those of the source: between them the other convention is not quite linear
    Exact, ///< where it is possible z + f(z) for each knot z: linear between these, exactly
    ExactIfEven, ///< those, where they are evenly spaced, and otherwise the same
};

/// The same compensation in the other convention. With the encoder position
/// x + c(x) for a commanded x, c(x) = -e(x + c(x)); so a table f of either kind becomes -f(z),
/// where z + f(z) is the knot.
/// - Every column that acts on a source axis of the table (ownAxis) moves the place z, all of them
///   together. All columns are taken from that place; those of a table that has only cross
///   compensations stay where they are and change their sign.
/// - A direction of motion is converted with the columns of that direction, and those of Both. A
///   column of Both is moved by the mean of an axis's two directions.
/// - With one axis that moves, the places are exact: f is linear between knots. With more, they are
///   the fixed point of z = knot - f(z), which converges because every slope is looked at before.
/// Beyond its knots the table is held, or goes on as in its first and last cell where its
/// controller does that (Outside::Extrapolate). Numbers are those of the table;
/// TableBehaviour::usesFloat does not round them.
/// - Exact knots are possible in 1D, for an axis that is not modulo and columns for both
/// directions. Errors: TargetNotKnown; SignNotConvertible where z + f(z) does not increase
/// strictly, where the corrections of several axes are so steep that one solution is not certain,
/// and where the two ends of a modulo axis differ; InvalidArgument for tables that are not
/// consistent, for two columns on one axis, and for values that are lengths on an axis of angles.
[[nodiscard]] Result<SignConversion> convertSign(const NeutralTable& table, SignConvention to,
    const TableBehaviour& behaviour, ConvertedKnots knots = ConvertedKnots::Same);

/// The point of the largest value in words, so that a person can tell the sign: "where the encoder
/// reads 40 mm the reference says 40.0021 mm: the feedback file says +0.0021 mm". Looks at the
/// columns that act on an axis of the table, or at all where there is none. table: consistent.
/// isComputed: no reference said so, which it is not told to have.
[[nodiscard]] Text examplePoint(const NeutralTable& table, bool isComputed = false);

/// The same for a table in both conventions, with the number of each file at the same knot.
[[nodiscard]] Text examplePoint(
    const NeutralTable& feedback, const NeutralTable& command, bool isComputed = false);

/// The same for a table that the drive looks up at the set position, with the number of its file:
/// the encoder moves by the opposite of that.
[[nodiscard]] Text examplePointAtSet(const NeutralTable& table, bool isComputed = false);

/// How two columns differ in what their controllers make of them, as an error of position in the
/// unit of a's column. Positions are in the units of a's axes.
struct ColumnDifference {
    std::size_t columnA = 0;
    std::size_t columnB = 0;
    double largest = 0.0; ///< its size, anywhere
    std::vector<double> where; ///< empty: there is no difference
    double largestInside = 0.0; ///< where both tables have values
    std::vector<double> whereInside;
};

inline constexpr std::size_t mostComparedPositions = 4'000'000;

struct ConversionDifference {
    std::vector<ColumnDifference> columns; ///< every column of a at least once
    std::size_t positions = 0; ///< so many were looked at
    bool isThinned = false; ///< not all of them, because there are too many
};

/// Compares two tables, each under its own controller's rules and sign. In the same convention the
/// difference is that of the values; otherwise it is c(x) + e(x + c(x)) for commanded positions x.
/// Looked at are all combinations of the knots of both tables, where a difference of two tables
/// that are linear between their knots is largest; a hundredth of a cell and a whole cell beyond
/// the ends of both; three turns of a modulo axis. In different conventions also, along the axis
/// that moves, the places where x + c(x) meets the knots of the feedback table, which makes 1D
/// exact; in 2D and 3D the middles between the knots besides. More than mostPositions are thinned
/// evenly. Axes belong together by their order; columns by target and direction, or by their order
/// when the other table has as many and no such target, or more and the target is not stated. Which
/// axis a column acts on is as a states it, or as b does where a does not. Errors: InvalidArgument
/// for tables that are not consistent or have different axes, and for a column of a that b lacks.
/// columns: only so many of a, its first, are compared; the others move the places.
[[nodiscard]] Result<ConversionDifference> conversionDifference(const NeutralTable& a,
    const TableBehaviour& behaviourA, const NeutralTable& b, const TableBehaviour& behaviourB,
    std::size_t mostPositions = mostComparedPositions, std::optional<std::size_t> columns = {});

} // namespace axiscomp
