// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/neutral/neutral_table.h"

namespace axiscomp {

/// What one value for both directions of motion is made of.
enum class DirectionChoice { Mean, Positive, Negative };
[[nodiscard]] TextPattern choiceText(DirectionChoice choice); ///< "mean", "positive", ...

/// What is lost for one target: half the difference of the two directions. With the mean an axis
/// is off by that much in either direction; with one of them it is exact there, and off by twice as
/// much in the other.
struct DirectionLoss {
    std::size_t column = 0; ///< of the merged table
    double largestHalfDifference = 0.0; ///< in the unit of the column
    std::vector<double> position; ///< of the largest; empty: the directions are the same
};

struct MergedDirections {
    NeutralTable table; ///< with columns of Both only
    std::vector<DirectionLoss> losses; ///< one for each pair, in the order of the columns
    std::vector<std::size_t> columns; ///< of each column that was merged: where it is in the table
};

/// One column for both directions in place of each pair of a positive and a negative one with the
/// same target; it stands where the first of the pair stood and keeps its name and unit. Columns of
/// Both stay. Of a column without its counterpart nothing is lost when its direction is chosen.
/// Errors: InvalidArgument for a direction that the choice needs and a target lacks, for two
/// columns of one target in the same direction, for pairs in units of different kinds, and for
/// tables that are not consistent.
[[nodiscard]] Result<MergedDirections> mergeDirections(
    const NeutralTable& table, DirectionChoice choice);

} // namespace axiscomp
