// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/table/target_axis.h"

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

/// What the numbers of a table are, with e = x_ref - x_enc (docs/formats.md).
enum class SignConvention {
    Feedback, ///< +e, added to the encoder position
    Command, ///< c, added to the commanded position: c(x) = -e(x + c(x))
};
[[nodiscard]] std::string_view signName(SignConvention sign); ///< "feedback", "command"

/// The direction of motion that a column holds for.
enum class Direction { Both, Positive, Negative };
[[nodiscard]] std::string_view directionName(Direction direction); ///< "both", "positive", ...
/// Whether there are motions that columns of both directions hold for.
[[nodiscard]] bool sharesDirection(Direction a, Direction b);

/// One input of a table.
struct SourceAxis {
    std::string name; ///< "X" or "1", as the file names it; may be empty
    std::string unit; ///< "mm", "deg"; empty: the file does not say
    std::vector<double> knots; ///< at least 2, finite, strictly ascending
    std::optional<double> wrap; ///< the period of a modulo axis; at least the span of the knots
    double step = 0.0; ///< positions are multiples of this in the file; 0: decimal numbers
    std::optional<double> distance = {}; ///< of even knots, as the file states it

    /// The knots say all that the distance does, but for its last bit.
    friend bool operator==(const SourceAxis& a, const SourceAxis& b)
    {
        return a.name == b.name && a.unit == b.unit && a.knots == b.knots && a.wrap == b.wrap
            && a.step == b.step;
    }
};

/// The values for one target axis.
struct CompensationColumn {
    std::string name; ///< "Table 1": as the file calls the column; may be empty
    std::string target; ///< the axis that is corrected, as stated (target_axis.h); may be empty
    std::string unit; ///< empty: the file does not say
    Direction direction = Direction::Both;
    std::vector<double> values; ///< pointCount() finite values, the first axis fastest
    /// Ascending: the points whose values were made up, not measured (missing_points.h).
    std::vector<std::uint32_t> filled = {};

    friend bool operator==(const CompensationColumn&, const CompensationColumn&) = default;
};

/// What the tables of all controllers have in common: 1 to 3 source axes with knots that are even
/// or not, and one or more columns over them. A file holds one or more of these.
struct NeutralTable {
    std::string name; ///< may be empty
    std::vector<SourceAxis> axes;
    std::vector<CompensationColumn> columns;
    SignConvention sign = SignConvention::Feedback;
    std::vector<std::string> notes;

    [[nodiscard]] std::size_t pointCount() const;
    friend bool operator==(const NeutralTable&, const NeutralTable&) = default;
};

[[nodiscard]] std::vector<std::size_t> knotCounts(const NeutralTable& table); ///< of each axis

/// Whether knots lie on start + i * distance but for the rounding of doubles.
[[nodiscard]] bool isEven(const SourceAxis& axis);
[[nodiscard]] bool isEven(const NeutralTable& table);

/// What a column corrects; nothing: that is not stated.
[[nodiscard]] std::optional<TargetAxis> targetOf(
    const NeutralTable& table, const CompensationColumn& column);

/// The source axis on which a column acts, so that a command offset moves the place where the table
/// is looked up. Nothing for a cross compensation (straightness, squareness), and where the target
/// is not stated: what depends on it calls checkTargets before.
[[nodiscard]] std::optional<std::size_t> ownAxis(
    const NeutralTable& table, const CompensationColumn& column);

/// The name of the axis that a column corrects; empty: it has none, or is not stated.
[[nodiscard]] std::string targetName(const NeutralTable& table, const CompensationColumn& column);

/// That it is stated for each column what it corrects. Errors: TargetNotKnown.
[[nodiscard]] Result<void> checkTargets(const NeutralTable& table);

/// The table with what a person says of its columns: one statement for all, or one for each.
/// areHeaders: the sources are called by headers, which need not be the names of axes. Errors:
/// InvalidArgument, TargetNotKnown for a name that may be that of a source.
[[nodiscard]] Result<NeutralTable> withTargets(
    NeutralTable table, std::span<const std::string> statements, bool areHeaders);

/// The tables with one column each (a pair of directions is one), in the order of the file: what a
/// user chooses from, and what a format with one column can hold. Each says which drive was
/// measured, as its table or else the first one does.
[[nodiscard]] std::vector<NeutralTable> separateColumns(std::span<const NeutralTable> tables);
/// The columns beside the one of this number among the separate ones, in its table, that correct
/// one of its sources: in use together, they move the place where that one is looked up. Null:
/// there are none.
[[nodiscard]] std::shared_ptr<const NeutralTable> sourcesBeside(
    std::span<const NeutralTable> tables, std::size_t separate);

/// Its name, or "source 2".
[[nodiscard]] std::vector<std::string> sourceNames(const NeutralTable& table);
[[nodiscard]] Text axisText(const NeutralTable& table, std::size_t axis);
[[nodiscard]] std::vector<Text> axisTexts(const NeutralTable& table);
/// The axis that a column corrects; nothing: that is not stated.
[[nodiscard]] std::optional<Text> targetText(
    const NeutralTable& table, const CompensationColumn& column);
/// "X, Y to Z, positive": for reports.
[[nodiscard]] Text columnText(const NeutralTable& table, const CompensationColumn& column);

} // namespace axiscomp
