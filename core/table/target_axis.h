// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp {

// Which axis a column of values corrects decides how its sign is converted (docs/cli.md,
// "Tables of other controllers"). It is stated as text, by a file or by a person:
// - the name of an axis, "Z";
// - "#1", "#2", "#3": that source axis of the table, which may have no name;
// - "other": an axis that is none of the sources.
// No text: not stated.

inline constexpr std::string_view otherAxis = "other";
[[nodiscard]] std::string sourceTarget(std::size_t source); ///< "#1" for 0

/// Whether two names are certainly those of different axes: both are letters of machine axes (ISO
/// 841) and these differ, as X and Y, or X1 and Y. X and X1 may be one axis, numbers and other
/// names may be anything.
[[nodiscard]] bool areDifferentAxes(std::string_view one, std::string_view other);

/// Whether values over positions of one axis certainly correct another one: it is stated to be
/// none of the sources, or both are named and differ.
[[nodiscard]] bool correctsAnotherAxis(std::string_view target, std::string_view positions);

/// Whether a name is that of another axis of a drive, in letters of either case, and not that of
/// the axis that is meant: X2 where X1 is meant and the drive has both. A name that no axis has is
/// none.
[[nodiscard]] bool namesAnotherAxis(
    std::string_view name, std::string_view meant, std::span<const std::string> others);

/// What a statement means for a table.
struct TargetAxis {
    std::optional<std::size_t> source; ///< the source axis that is corrected; none: another axis

    friend bool operator==(const TargetAxis&, const TargetAxis&) = default;
};

/// sources: the names of the source axes, as axes are called there; may be empty. Nothing: not
/// stated, or a name that may or may not be that of a source without a name.
[[nodiscard]] std::optional<TargetAxis> targetAxis(
    std::string_view statement, std::span<const std::string> sources);

struct CompensationTable;
/// What the values of a table correct, by the names of its sources.
[[nodiscard]] std::optional<TargetAxis> targetOf(const CompensationTable& table);
/// The same by the name of the axis, also of a source that is stated by its number. What is stated,
/// where that may or may not be a source.
[[nodiscard]] std::string targetName(const CompensationTable& table);
/// A file or a person says that this source (0 for the first) is the axis that is corrected.
[[nodiscard]] bool isStatedSource(const CompensationTable& table, std::size_t source);

/// The axis that a header of positions names: "X" of "X", "X position", "Pos. X", "X-Achse", and
/// "3" of "3". Empty: none, as in "Position" or "Dim 1".
[[nodiscard]] std::string_view axisInHeader(std::string_view header);

/// A statement about a table whose sources are known by headers, which need not be the names of
/// axes: the same statement with the header of the source that it means, or empty where that cannot
/// be told.
[[nodiscard]] std::string targetAmong(
    std::string_view statement, std::span<const std::string> headers);

/// A single A, B or C, which may be the letter that a spreadsheet counts a column by.
[[nodiscard]] bool mayBeCounted(std::string_view header);

/// What the header of a column of values states: "Z" for "Z", "dZ", "Z error", "Z-Abweichung", and
/// the header of the source that it names. Empty: nothing. A single A, B or C is taken for a source
/// only, since columns are also counted by letters.
[[nodiscard]] std::string targetInHeader(
    std::string_view header, std::span<const std::string> sourceHeaders);

/// The statement of a table, or where there is none that of the header of its column.
[[nodiscard]] std::string statedOrInHeader(
    std::string statement, std::string_view header, std::span<const std::string> sourceHeaders);

/// The axis of the machine that the header of a column of values names, whatever its sources are
/// called: "Y" for "Y error". Empty: none, or a single A, B or C, since columns are also counted by
/// letters, or nothing but U, V or W, which are symbols of values.
[[nodiscard]] std::string_view axisOfColumn(std::string_view header);

/// What may be the name of an axis of a drive in a header of positions or of values, whatever axes
/// are called there: "Left" of "Left position" and "Left error", "B" of "B error". Empty: none, as
/// in "Position", "Error 2", "Error B" or "B", or several words of which none is such a word, or a
/// symbol that is none in axisOfColumn.
[[nodiscard]] std::string nameInPositions(std::string_view header);
[[nodiscard]] std::string nameInValues(std::string_view header);

/// The statement, so that a reader who knows only the headers takes it the same way.
[[nodiscard]] std::string portableTarget(
    std::string_view statement, std::span<const std::string> headers);

/// What a comment "target: Z" of a calibration file states, " Z"; nothing: it is another comment.
[[nodiscard]] std::optional<std::string_view> targetInComment(std::string_view comment);

/// "X, Y": the statements of a list, blanks cut off.
[[nodiscard]] std::vector<std::string> targetList(std::string_view text);

} // namespace axiscomp
