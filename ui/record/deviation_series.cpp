// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/record/deviation_series.h"

#include <algorithm>

namespace axiscomp::ui {

namespace {

void setCurves(DeviationSeries& series, DeviationCurves curves)
{
    series.overview =
        std::make_shared<const DeviationCurves>(thinned(curves, DeviationSeries::mostPoints));
    series.curves = std::make_shared<const DeviationCurves>(std::move(curves));
}

} // namespace

DeviationSeries deviationSeries(std::shared_ptr<const Measurement> measurement,
    std::shared_ptr<const Iso230Figures> figures, std::shared_ptr<const Outliers> outliers,
    const std::optional<double>& datum)
{
    DeviationSeries series;
    setCurves(series, deviationCurves(*measurement, *figures, deviationDatum(*figures, datum)));
    series.measurement = std::move(measurement);
    series.figures = std::move(figures);
    series.outliers = std::move(outliers);
    return series;
}

DeviationSeries seriesOfAllValues(
    const DeviationSeries& used, std::shared_ptr<const Iso230Figures> figures)
{
    DeviationCurves curves =
        deviationCurves(withAllValues(*used.measurement), *figures, used.curves->datum);
    curves.excluded = used.curves->excluded;
    DeviationSeries all = used;
    setCurves(all, std::move(curves));
    all.figures = std::move(figures);
    return all;
}

bool isProposed(const DeviationSeries& series, const RunValue& value)
{
    if (!series.outliers || !value.isUsed)
        return false;
    const DirectionOutliers& outliers =
        value.direction == Approach::Up ? series.outliers->up : series.outliers->down;
    return std::ranges::any_of(outliers.flagged, [&](const Outlier& outlier) {
        return outlier.target == value.target && outlier.run == value.run;
    });
}

} // namespace axiscomp::ui
