// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/judge/iso230.h"
#include "core/metrology/report/report_document.h"

namespace axiscomp::report {

/// From the lowest to the highest deviation that a plot has room for, in mm or deg.
struct DeviationRange {
    double low = 0.0;
    double high = 0.0;
};

/// Everything that is drawn of a measurement: its values, and its means with 2 s on either side.
[[nodiscard]] DeviationRange deviationRange(
    const Measurement& measurement, const Iso230Figures& figures);
[[nodiscard]] DeviationRange united(const DeviationRange& a, const DeviationRange& b);

struct PlotSize {
    double width = 0.0; ///< mm
    double height = 0.0; ///< mm
};

/// The plot of ISO 230-2: deviation over position, the means of both directions with their bands of
/// 2 s, the mean of both, every run, and A, E, M and B where they arise. measurement: with targets
/// and at least one value in use. Two plots of one range have the same scale.
[[nodiscard]] ReportPlot deviationPlot(const Measurement& measurement, const Iso230Figures& figures,
    const DeviationRange& range, const PlotSize& size);

/// What the lines and markers mean.
[[nodiscard]] ReportPlot deviationLegend(double width);

} // namespace axiscomp::report
