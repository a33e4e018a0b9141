// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/judge/deviation_curves.h"
#include "core/metrology/report/report_document.h"

namespace axiscomp::report {

struct PlotSize {
    double width = 0.0; ///< mm
    double height = 0.0; ///< mm
};

/// What two plots that are read side by side have in common.
struct PlotRange {
    DeviationRange deviations;
    MeasuredRange positions;
};
/// measurement: with targets and at least one value in use; curves: its own.
[[nodiscard]] PlotRange plotRange(const Measurement& measurement, const DeviationCurves& curves);
[[nodiscard]] PlotRange united(const PlotRange& a, const PlotRange& b);

/// The plot of ISO 230-2: deviation over position, the means of both directions with their bands of
/// 2 s, the mean of both, every run, and A, E, M and B where they arise. measurement: with targets
/// and at least one value in use; curves: its own. Two plots of one range have the same scale.
[[nodiscard]] ReportPlot deviationPlot(const Measurement& measurement,
    const DeviationCurves& curves, const PlotRange& range, const PlotSize& size);

/// Whether its plot has single runs: a mean is none.
[[nodiscard]] bool hasPlottedRuns(const Measurement& measurement);

/// What the lines and markers mean. haveRuns: of a plot beside it.
[[nodiscard]] ReportPlot deviationLegend(double width, bool haveRuns);

} // namespace axiscomp::report
