// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/report/deviation_plot.h"

#include "core/base/portable_math.h"
#include "core/metrology/fine_quantity.h"
#include "core/metrology/report/report_text.h"

#include <algorithm>
#include <cmath>

namespace axiscomp::report {

namespace {

constexpr double leftMargin = 15.0; // mm, for numbers and the name of the axis
constexpr double rightMargin = 20.0; // for A, E and M beside the curves
constexpr double topMargin = 4.0;
constexpr double bottomMargin = 9.0;
constexpr double smallFont = 2.2;
const std::vector<double> dotted{0.3, 0.7};

/// 1, 2 or 5 times a power of ten: the smallest that gives no more than this many steps.
double niceStep(double range, int most)
{
    const double least = range / most;
    const double power = portable::pow(10.0, std::floor(portable::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least * (1.0 - 1e-9))
            return factor * power;
    return 10.0 * power;
}

int decimalsOfStep(double step)
{
    return std::max(0, -static_cast<int>(std::floor(portable::log10(step) + 1e-9)));
}

/// Values along one side of the plot, from the value at its beginning to that at its end.
struct Scale {
    double low = 0.0;
    double high = 1.0;
    double begin = 0.0; ///< mm
    double end = 1.0;

    [[nodiscard]] double place(double value) const
    {
        return begin + (value - low) / (high - low) * (end - begin);
    }
};

class DeviationPlot {
public:
    DeviationPlot(const Measurement& measurement, const DeviationCurves& curves,
        const PlotRange& range, const PlotSize& size)
        : m_measurement(measurement)
        , m_curves(curves)
        , m_unit(unitOf(range.deviations, measurement.isAngular))
    {
        m_plot.width = size.width;
        m_plot.height = size.height;
        const auto [first, last] = range.positions;
        const double border = last > first ? 0.03 * (last - first) : 0.5;
        m_x = {first - border, last + border, leftMargin, size.width - rightMargin};
        const auto [low, high] = range.deviations;
        const double room = high > low ? 0.06 * (high - low) : 0.5 / m_unit.factor;
        m_y = {(low - room) * m_unit.factor, (high + room) * m_unit.factor,
            size.height - bottomMargin, topMargin};
    }

    ReportPlot drawn()
    {
        drawFrame();
        drawBand();
        drawRuns();
        drawDirection(m_curves.up, PlotInk::Up, PlotMarkerShape::TriangleUp);
        drawDirection(m_curves.down, PlotInk::Down, PlotMarkerShape::TriangleDown);
        drawMean();
        drawReversal();
        drawRanges();
        describe();
        return std::move(m_plot);
    }

private:
    [[nodiscard]] static FineUnit unitOf(const DeviationRange& range, bool isAngular)
    {
        const std::optional<double> shown[] = {range.low, range.high};
        return fineUnit(shown, isAngular);
    }

    [[nodiscard]] PlotPoint place(double position, double deviation) const
    {
        return {m_x.place(position), m_y.place(deviation * m_unit.factor)};
    }

    void line(std::vector<PlotPoint> points, PlotInk ink, double width,
        const std::vector<double>& dashes = {})
    {
        if (points.size() > 1)
            m_plot.lines.push_back({std::move(points), ink, width, dashes});
    }

    void drawFrame()
    {
        const double step = niceStep(m_y.high - m_y.low, 7);
        for (double tick = std::ceil(m_y.low / step); tick * step <= m_y.high; ++tick) {
            const double y = m_y.place(tick * step);
            line({{m_x.begin, y}, {m_x.end, y}}, PlotInk::Grid, tick == 0.0 ? 0.25 : 0.1);
            m_plot.labels.push_back({{m_x.begin - 1.0, y + 0.35 * smallFont},
                numberText(tick * step, decimalsOfStep(step)), PlotLabel::Side::Right, false,
                smallFont});
        }
        const double wide = niceStep(m_x.high - m_x.low, 6);
        for (double tick = std::ceil(m_x.low / wide); tick * wide <= m_x.high; ++tick) {
            const double x = m_x.place(tick * wide);
            line({{x, m_y.begin}, {x, m_y.begin + 0.8}}, PlotInk::Frame, 0.15);
            m_plot.labels.push_back(
                {{x, m_y.begin + 1.2 + smallFont}, numberText(tick * wide, decimalsOfStep(wide)),
                    PlotLabel::Side::Centre, false, smallFont});
        }
        line({{m_x.begin, m_y.end}, {m_x.begin, m_y.begin}, {m_x.end, m_y.begin},
                 {m_x.end, m_y.end}, {m_x.begin, m_y.end}},
            PlotInk::Frame, 0.2);
        m_plot.labels.push_back({{2.6, (m_y.begin + m_y.end) / 2.0},
            AXISCOMP_TEXT("Report", "Deviation in {unit}")
                .with("unit", deviationUnitText(m_unit, m_curves.datum, m_measurement.isAngular)),
            PlotLabel::Side::Centre, true, smallFont});
        m_plot.labels.push_back({{(m_x.begin + m_x.end) / 2.0, m_plot.height - 1.2},
            AXISCOMP_TEXT("Report", "Position in {unit}")
                .with("unit", Verbatim{positionSymbol(m_measurement.isAngular)}),
            PlotLabel::Side::Centre, false, smallFont});
    }

    [[nodiscard]] std::vector<PlotPoint> places(const std::vector<PlacedDeviation>& curve) const
    {
        std::vector<PlotPoint> points;
        for (const PlacedDeviation& one : curve)
            points.push_back(place(one.position, one.deviation));
        return points;
    }

    /// PDF/A-1 has no transparency: one band is an area, the other two lines over it.
    void drawBand()
    {
        auto outline = places(m_curves.up.high);
        const auto low = places(m_curves.up.low);
        outline.insert(outline.end(), low.rbegin(), low.rend());
        if (low.size() > 1)
            m_plot.bands.push_back({std::move(outline), PlotInk::Up});
        for (const auto* limit : {&m_curves.down.low, &m_curves.down.high})
            line(places(*limit), PlotInk::Down, 0.25, dotted);
    }

    void drawRuns()
    {
        if (!hasPlottedRuns(m_measurement))
            return;
        for (const DeviationCurves::Run& run : m_curves.runs)
            line(places(run.values), PlotInk::Run, 0.1);
    }

    void drawDirection(
        const DeviationCurves::Direction& direction, PlotInk ink, PlotMarkerShape shape)
    {
        const auto points = places(direction.mean);
        for (const PlotPoint& point : points)
            m_plot.markers.push_back({point, shape, ink});
        line(points, ink, 0.25);
    }

    void drawMean() { line(places(m_curves.mean), PlotInk::Mean, 0.5); }

    void drawReversal()
    {
        if (!m_curves.reversal)
            return;
        const PlotPoint up = place(m_curves.reversal->position, m_curves.reversal->up);
        const PlotPoint down = place(m_curves.reversal->position, m_curves.reversal->down);
        line({up, down}, PlotInk::Frame, 0.4);
        m_plot.labels.push_back({{up.x + 1.2, (up.y + down.y) / 2.0 + 0.35 * smallFont},
            Verbatim{"B"}, PlotLabel::Side::Left, false, smallFont});
    }

    /// A, E and M from their lowest to their highest place.
    void drawRanges()
    {
        struct Range {
            const char* symbol;
            const std::optional<DeviationRange>& range;
        };
        double x = m_x.end + 3.0;
        for (const Range& range : {Range{"A", m_curves.accuracy}, Range{"E", m_curves.systematic},
                 Range{"M", m_curves.meanRange}}) {
            if (range.range)
                drawRange(x, *range.range, range.symbol);
            x += 6.0;
        }
    }

    void drawRange(double x, const DeviationRange& range, const char* symbol)
    {
        constexpr double half = 1.0;
        const double high = m_y.place(range.high * m_unit.factor);
        const double low = m_y.place(range.low * m_unit.factor);
        line({{x, low}, {x, high}}, PlotInk::Frame, 0.2);
        for (const double y : {low, high})
            line({{x - half, y}, {x + half, y}}, PlotInk::Frame, 0.35);
        m_plot.labels.push_back({{x + 1.4, (low + high) / 2.0 + 0.35 * smallFont}, Verbatim{symbol},
            PlotLabel::Side::Left, false, smallFont});
    }

    void describe()
    {
        m_plot.description = hasPlottedRuns(m_measurement)
            ? AXISCOMP_TEXT("Report",
                "Deviation over position: means of both directions with bands of 2 s, the mean of "
                "both, single runs")
            : AXISCOMP_TEXT(
                "Report", "Deviation over position: means of both directions, the mean of both");
    }

    const Measurement& m_measurement;
    const DeviationCurves& m_curves;
    FineUnit m_unit;
    Scale m_x;
    Scale m_y;
    ReportPlot m_plot;
};

} // namespace

PlotRange plotRange(const Measurement& measurement, const DeviationCurves& curves)
{
    return {*curves.all, {measurement.targets.front(), measurement.targets.back()}};
}

PlotRange united(const PlotRange& a, const PlotRange& b)
{
    return {axiscomp::united(a.deviations, b.deviations),
        {std::min(a.positions.first, b.positions.first),
            std::max(a.positions.last, b.positions.last)}};
}

ReportPlot deviationPlot(const Measurement& measurement, const DeviationCurves& curves,
    const PlotRange& range, const PlotSize& size)
{
    return DeviationPlot(measurement, curves, range, size).drawn();
}

bool hasPlottedRuns(const Measurement& measurement)
{
    return measurement.kind != MeasurementKind::Averages;
}

ReportPlot deviationLegend(double width, bool haveRuns)
{
    constexpr double height = 5.0;
    constexpr double middle = height / 2.0;
    constexpr double sample = 8.0; // mm, length of a piece of line
    ReportPlot legend;
    legend.width = width;
    legend.height = height;
    legend.description = AXISCOMP_TEXT("Report", "What lines and markers mean");
    const double column = width / static_cast<double>(deviationLineCount);
    const auto line = [&](double x, PlotInk ink, double lineWidth,
                          const std::vector<double>& dashes = {}) {
        legend.lines.push_back({{{x, middle}, {x + sample, middle}}, ink, lineWidth, dashes});
    };
    line(0.0, PlotInk::Up, 0.25);
    legend.markers.push_back({{sample / 2.0, middle}, PlotMarkerShape::TriangleUp, PlotInk::Up});
    line(column, PlotInk::Down, 0.25);
    legend.markers.push_back(
        {{column + sample / 2.0, middle}, PlotMarkerShape::TriangleDown, PlotInk::Down});
    line(2.0 * column, PlotInk::Mean, 0.5);
    const double band = 3.0 * column;
    legend.bands.push_back(
        {{{band, 1.2}, {band + sample, 1.2}, {band + sample, height - 1.2}, {band, height - 1.2}},
            PlotInk::Up});
    line(4.0 * column, PlotInk::Down, 0.25, dotted);
    if (haveRuns)
        line(5.0 * column, PlotInk::Run, 0.1);
    for (std::size_t i = 0; i < deviationLineCount - (haveRuns ? 0 : 1); ++i)
        legend.labels.push_back(
            {{static_cast<double>(i) * column + sample + 1.0, middle + 0.35 * smallFont},
                deviationLineText(static_cast<DeviationLine>(i)), PlotLabel::Side::Left, false,
                smallFont});
    return legend;
}

} // namespace axiscomp::report
