// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/fine_quantity.h"
#include "core/metrology/judge/iso230.h"

namespace axiscomp {

// What the plot of ISO 230-2 shows of a measurement, for any device. Positions and deviations are
// in mm or deg.

/// From a lowest to a highest deviation.
struct DeviationRange {
    double low = 0.0;
    double high = 0.0;

    friend bool operator==(const DeviationRange&, const DeviationRange&) = default;
};
[[nodiscard]] DeviationRange united(const DeviationRange& a, const DeviationRange& b);

/// A deviation at a position.
struct PlacedDeviation {
    double position = 0.0;
    double deviation = 0.0;

    friend bool operator==(const PlacedDeviation&, const PlacedDeviation&) = default;
};

/// What a picture or a list takes for zero, since that of an instrument is arbitrary: the mean
/// deviation at a position, of both directions or of the one that there is. Without a position it
/// is that of the first target. A position is held within the targets; between two of them the mean
/// is on the line through theirs. Nothing: there are no targets.
[[nodiscard]] std::optional<PlacedDeviation> deviationDatum(
    const Iso230Figures& figures, const std::optional<double>& position = {});

/// One of two measurements that are read side by side.
struct DatumSide {
    const Iso230Figures& figures; ///< may be without targets
    std::optional<double> stated = {}; ///< position that a person has stated for it (statedDatum)
};
struct TwoDatums {
    std::optional<PlacedDeviation> before;
    std::optional<PlacedDeviation> after;
};
/// At one position, as far as both have it: that which was stated for the first one, else for the
/// second one, else the first target of the first one that has any.
[[nodiscard]] TwoDatums deviationDatums(const DatumSide& before, const DatumSide& after);

/// A deviation as it is shown; without a datum as it was measured.
[[nodiscard]] double fromDatum(double deviation, const std::optional<PlacedDeviation>& datum);
/// The means of all targets and their limits as they are shown; what is a range or a difference is
/// the same.
[[nodiscard]] Iso230Figures fromDatum(
    Iso230Figures figures, const std::optional<PlacedDeviation>& datum);
/// "0 = mean at 15 mm"
[[nodiscard]] Text datumText(
    const PlacedDeviation& datum, bool isAngular, UnitLetters letters = UnitLetters::Page);

/// The lines of the plot.
enum class DeviationLine { MeanUp, MeanDown, Mean, BandUp, BandDown, Run };
inline constexpr std::size_t deviationLineCount = 6;
/// What a legend says of it: "mean ↑ ± 2 s".
[[nodiscard]] TextPattern deviationLineText(DeviationLine line);

/// Curves over the targets, ascending; each has the targets for which it is defined.
struct DeviationCurves {
    /// Of the runs of one direction.
    struct Direction {
        std::vector<PlacedDeviation> mean; ///< xm_i
        std::vector<PlacedDeviation> low; ///< xm_i - 2 s_i
        std::vector<PlacedDeviation> high; ///< xm_i + 2 s_i
        std::vector<PlacedDeviation> smallest; ///< of the values in use at a target
        std::vector<PlacedDeviation> largest;
    };
    /// The values in use of one run.
    struct Run {
        Approach direction = Approach::Up;
        int number = 1;
        std::vector<PlacedDeviation> values;
    };
    /// B, where it arises.
    struct Reversal {
        double position = 0.0;
        double up = 0.0; ///< xm_i of both directions there
        double down = 0.0;
    };

    Direction up;
    Direction down;
    std::vector<PlacedDeviation> mean; ///< of both directions
    std::vector<Run> runs; ///< by direction and number
    std::size_t valueCount = 0; ///< of all runs
    std::vector<PlacedDeviation> excluded; ///< values that are not used
    // From the lowest to the highest place of A, E and M. Nothing: the figure is not defined.
    std::optional<DeviationRange> accuracy;
    std::optional<DeviationRange> systematic;
    std::optional<DeviationRange> meanRange;
    std::optional<Reversal> reversal;
    std::optional<DeviationRange> all; ///< values and limits of 2 s; nothing without a value in use
    std::optional<PlacedDeviation> datum; ///< from which all of these are (fromDatum)
};

/// measurement: with targets. figures: of its values in use, as they were measured.
[[nodiscard]] DeviationCurves deviationCurves(const Measurement& measurement,
    const Iso230Figures& figures, const std::optional<PlacedDeviation>& datum = {});

/// At most this many points of each curve over the targets: of neighbours the lowest and the
/// highest ones, so that in a picture of fewer columns nothing is missed. Without runs where there
/// are more values than that.
[[nodiscard]] DeviationCurves thinned(DeviationCurves curves, std::size_t most);

} // namespace axiscomp
