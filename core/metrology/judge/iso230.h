// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/measurement.h"

#include <array>
#include <optional>
#include <span>
#include <string_view>
#include <vector>

namespace axiscomp {

// The figures of ISO 230-2:2014 for one axis, in its symbols. x_ij is the deviation at target i in
// run j of one direction, n_i the number of its values there, m the number of targets.

/// The figures of the whole axis. Up is the positive direction of approach.
enum class Iso230Figure {
    B, ///< reversal value: max |B_i|
    MeanReversal, ///< mean of B_i over all targets, with its sign
    M, ///< range of the mean bidirectional deviation: max xm_i - min xm_i
    EUp, ///< systematic deviation of one direction: max xm_i - min xm_i
    EDown,
    E, ///< the same over both directions together
    RUp, ///< repeatability of one direction: max R_i
    RDown,
    R, ///< bidirectional repeatability: max R_i
    AUp, ///< accuracy of one direction: max(xm_i + 2 s_i) - min(xm_i - 2 s_i)
    ADown,
    A, ///< the same over both directions together
};
inline constexpr std::size_t iso230FigureCount = 12;
[[nodiscard]] std::span<const Iso230Figure> allIso230Figures();
/// "B", "Bmean", "M", "EUp" ... as JSON has them.
[[nodiscard]] std::string_view figureName(Iso230Figure figure);
/// By that name in capital or small letters; "E+" and "E-" are EUp and EDown.
[[nodiscard]] std::optional<Iso230Figure> figureNamed(std::string_view name);
/// In the order in which people read them: A, R, E, B, its mean and M, each with its directions.
[[nodiscard]] std::span<const Iso230Figure> shownIso230Figures();
/// "A", "A↑", "B", "Bm" for its mean: as the standard's formulas have it.
[[nodiscard]] std::string_view figureSymbol(Iso230Figure figure);
/// "accuracy A"
[[nodiscard]] TextPattern figureText(Iso230Figure figure);

/// One target approached in one direction. In mm or deg.
struct DirectionFigures {
    std::size_t n = 0;
    std::optional<double> mean; ///< xm_i = sum x_ij / n_i
    std::optional<double> s; ///< sqrt(sum (x_ij - xm_i)^2 / (n_i - 1)); not with one value
    std::optional<double> repeatability; ///< R_i = 4 s_i
    std::optional<double> low; ///< xm_i - 2 s_i
    std::optional<double> high; ///< xm_i + 2 s_i
};

struct TargetFigures {
    std::size_t target = 0; ///< index into the measurement's targets
    double position = 0.0;
    DirectionFigures up;
    DirectionFigures down;
    std::optional<double> mean; ///< of both directions: (xm_i up + xm_i down) / 2
    std::optional<double> reversal; ///< B_i = xm_i up - xm_i down
    std::optional<double> repeatability; ///< max(2 s up + 2 s down + |B_i|, R up, R down)
};

struct AxisFigure {
    std::optional<double> value; ///< nothing: not defined
    /// Where it arises, as indices into Iso230Figures::targets: the highest and the lowest place
    /// for a range, the same twice for a maximum. Meaningless without a value and for MeanReversal.
    std::size_t high = 0;
    std::size_t low = 0;
};

struct Iso230Figures {
    std::vector<TargetFigures> targets; ///< those that have a value in use, ascending
    std::array<AxisFigure, iso230FigureCount> axis;

    [[nodiscard]] const AxisFigure& operator[](Iso230Figure figure) const
    {
        return axis[static_cast<std::size_t>(figure)];
    }
};

/// Whether a figure reaches from a highest to a lowest place: A, E and M, also of one direction.
[[nodiscard]] bool isRange(Iso230Figure figure);
/// What stands for a figure in those of runs of one direction alone, where it is not defined: A, R
/// or E of that direction, and its E for M, since the mean of one direction is all that there is.
/// Else, and of the other figures, the figure itself.
[[nodiscard]] Iso230Figure figureStandingFor(Iso230Figure figure, const Iso230Figures& figures);
/// A, R, E, B and M; of runs of one direction those that stand for them.
[[nodiscard]] std::vector<Iso230Figure> figuresInShort(const Iso230Figures& figures);
/// The positions where a figure arises: of a range the highest and the lowest place, where these
/// are not the same. None where it is not defined, and for MeanReversal.
[[nodiscard]] std::vector<double> placesOf(const Iso230Figures& figures, Iso230Figure figure);

/// Of the values in use of a measurement with targets. A figure that needs values that are not
/// there is not defined: with a single value somewhere s, R and A; with one direction alone B, its
/// mean, M, E, R and A; of a direction that lacks a target everything, so that with a target that
/// was planned and never measured there are none.
[[nodiscard]] Iso230Figures iso230Figures(const Measurement& measurement);

/// The figures of an axis alone. Nothing: not defined.
struct FigureValues {
    std::array<std::optional<double>, iso230FigureCount> values{};

    [[nodiscard]] const std::optional<double>& operator[](Iso230Figure figure) const
    {
        return values[static_cast<std::size_t>(figure)];
    }
    friend bool operator==(const FigureValues&, const FigureValues&) = default;
};
[[nodiscard]] FigureValues figureValues(const Iso230Figures& figures);

/// The mean at a target: of both directions, or of the one that there is.
[[nodiscard]] std::optional<double> meanInUse(const TargetFigures& target);

/// Of a mean of one direction: s_i / sqrt(n_i). Nothing with a single value.
[[nodiscard]] std::optional<double> standardError(const DirectionFigures& figures);
/// Of the mean of both directions, or of the one that there is: half of the root of both squares.
/// Nothing where one of them is not known.
[[nodiscard]] std::optional<double> standardError(const TargetFigures& target);

/// Means, s, B_i and R_i of all targets, as they stand in one table.
[[nodiscard]] std::vector<std::optional<double>> valuesOfTargets(const Iso230Figures& figures);

} // namespace axiscomp
