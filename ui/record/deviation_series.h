// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/judge/deviation_curves.h"
#include "core/metrology/judge/outliers.h"

#include <QString>

#include <memory>

namespace axiscomp::ui {

/// A measurement with targets as its plot shows it.
struct DeviationSeries {
    /// Values that are drawn as runs; of more the smallest and the largest at each target are. So
    /// many points of a curve are drawn at once.
    static constexpr std::size_t mostPoints = 2000;

    QString name; ///< "before"; empty where there is but one
    std::shared_ptr<const Measurement> measurement; ///< null: there is none
    std::shared_ptr<const Iso230Figures> figures;
    std::shared_ptr<const Outliers> outliers; ///< proposed for exclusion; null: none
    std::shared_ptr<const DeviationCurves> curves; ///< with all points
    std::shared_ptr<const DeviationCurves> overview; ///< for a view of all of them

    /// A deviation as it was measured, as plot and tables show it. With a measurement.
    [[nodiscard]] double shown(double deviation) const
    {
        return fromDatum(deviation, curves->datum);
    }
    [[nodiscard]] std::optional<double> shown(const std::optional<double>& deviation) const
    {
        return deviation ? std::optional(shown(*deviation)) : std::nullopt;
    }
    /// Whether it is the same, not whether it says the same.
    friend bool operator==(const DeviationSeries&, const DeviationSeries&) = default;
};

/// measurement: with targets; figures: of its values in use; datum: position that was stated. Takes
/// as long as there are values: not for the window's thread.
[[nodiscard]] DeviationSeries deviationSeries(std::shared_ptr<const Measurement> measurement,
    std::shared_ptr<const Iso230Figures> figures, std::shared_ptr<const Outliers> outliers = {},
    const std::optional<double>& datum = {});

/// The same as if nothing were excluded, but for the mark on what is, from the same datum. figures:
/// of all values.
[[nodiscard]] DeviationSeries seriesOfAllValues(
    const DeviationSeries& used, std::shared_ptr<const Iso230Figures> figures);

/// Whether the rule for outliers proposes to leave a value out.
[[nodiscard]] bool isProposed(const DeviationSeries& series, const RunValue& value);

} // namespace axiscomp::ui
