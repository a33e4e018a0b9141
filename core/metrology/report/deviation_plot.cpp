// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/report/deviation_plot.h"

#include "core/metrology/fine_quantity.h"
#include "core/metrology/report/report_text.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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
    const double power = std::pow(10.0, std::floor(std::log10(least)));
    for (const double factor : {1.0, 2.0, 5.0})
        if (factor * power >= least * (1.0 - 1e-9))
            return factor * power;
    return 10.0 * power;
}

int decimalsOfStep(double step)
{
    return std::max(0, -static_cast<int>(std::floor(std::log10(step) + 1e-9)));
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
    DeviationPlot(const Measurement& measurement, const Iso230Figures& figures,
        const DeviationRange& range, const PlotSize& size)
        : m_measurement(measurement)
        , m_figures(figures)
        , m_unit(unitOf(range, measurement.isAngular))
    {
        m_plot.width = size.width;
        m_plot.height = size.height;
        const double first = measurement.targets.front();
        const double last = measurement.targets.back();
        const double border = last > first ? 0.03 * (last - first) : 0.5;
        m_x = {first - border, last + border, leftMargin, size.width - rightMargin};
        const double height = range.high - range.low;
        const double room = height > 0.0 ? 0.06 * height : 0.5 / m_unit.factor;
        m_y = {(range.low - room) * m_unit.factor, (range.high + room) * m_unit.factor,
            size.height - bottomMargin, topMargin};
    }

    ReportPlot drawn()
    {
        drawFrame();
        drawBand();
        drawRuns();
        drawDirection(&TargetFigures::up, PlotInk::Up, PlotMarkerShape::TriangleUp);
        drawDirection(&TargetFigures::down, PlotInk::Down, PlotMarkerShape::TriangleDown);
        drawMean();
        drawReversal();
        drawRanges();
        describe();
        return std::move(m_plot);
    }

private:
    using Direction = DirectionFigures TargetFigures::*;

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
            AXISCOMP_TEXT("Report", "Deviation in {unit}").with("unit", Verbatim{m_unit.symbol}),
            PlotLabel::Side::Centre, true, smallFont});
        m_plot.labels.push_back({{(m_x.begin + m_x.end) / 2.0, m_plot.height - 1.2},
            AXISCOMP_TEXT("Report", "Position in {unit}")
                .with("unit", Verbatim{positionSymbol(m_measurement.isAngular)}),
            PlotLabel::Side::Centre, false, smallFont});
    }

    [[nodiscard]] std::vector<PlotPoint> limit(
        Direction direction, std::optional<double> DirectionFigures::*which) const
    {
        std::vector<PlotPoint> points;
        for (const TargetFigures& target : m_figures.targets)
            if (const auto& value = target.*direction.*which)
                points.push_back(place(target.position, *value));
        return points;
    }

    /// PDF/A-1 has no transparency: one band is an area, the other two lines over it.
    void drawBand()
    {
        auto outline = limit(&TargetFigures::up, &DirectionFigures::high);
        const auto low = limit(&TargetFigures::up, &DirectionFigures::low);
        outline.insert(outline.end(), low.rbegin(), low.rend());
        if (low.size() > 1)
            m_plot.bands.push_back({std::move(outline), PlotInk::Up});
        for (const auto which : {&DirectionFigures::low, &DirectionFigures::high})
            line(limit(&TargetFigures::down, which), PlotInk::Down, 0.25, dotted);
    }

    void drawRuns()
    {
        for (const Approach direction : {Approach::Up, Approach::Down}) {
            const int runs = m_measurement.runCount(direction);
            for (int run = 1; run <= runs; ++run) {
                std::vector<PlotPoint> points;
                for (const RunValue& value : m_measurement.values)
                    if (value.direction == direction && value.run == run && value.isUsed)
                        points.push_back(
                            place(m_measurement.targets[value.target], value.deviation));
                line(std::move(points), PlotInk::Run, 0.1);
            }
        }
    }

    void drawDirection(Direction direction, PlotInk ink, PlotMarkerShape shape)
    {
        const auto points = limit(direction, &DirectionFigures::mean);
        for (const PlotPoint& point : points)
            m_plot.markers.push_back({point, shape, ink});
        line(points, ink, 0.25);
    }

    void drawMean()
    {
        std::vector<PlotPoint> points;
        for (const TargetFigures& target : m_figures.targets)
            if (target.mean)
                points.push_back(place(target.position, *target.mean));
        line(std::move(points), PlotInk::Mean, 0.5);
    }

    void drawReversal()
    {
        const AxisFigure& reversal = m_figures[Iso230Figure::B];
        if (!reversal.value)
            return;
        const TargetFigures& target = m_figures.targets[reversal.high];
        const PlotPoint up = place(target.position, *target.up.mean);
        const PlotPoint down = place(target.position, *target.down.mean);
        line({up, down}, PlotInk::Frame, 0.4);
        m_plot.labels.push_back({{up.x + 1.2, (up.y + down.y) / 2.0 + 0.35 * smallFont},
            Verbatim{"B"}, PlotLabel::Side::Left, false, smallFont});
    }

    /// A, E and M from their lowest to their highest place.
    void drawRanges()
    {
        struct Range {
            Iso230Figure figure;
            const char* symbol;
            DeviationRange range;
        };
        constexpr double infinity = std::numeric_limits<double>::infinity();
        DeviationRange accuracy{infinity, -infinity};
        DeviationRange systematic = accuracy;
        DeviationRange mean = accuracy;
        const auto widen = [](DeviationRange& range, const std::optional<double>& value) {
            range.low = std::min(range.low, value.value_or(range.low));
            range.high = std::max(range.high, value.value_or(range.high));
        };
        for (const TargetFigures& target : m_figures.targets) {
            for (const DirectionFigures* one : {&target.up, &target.down}) {
                widen(accuracy, one->low);
                widen(accuracy, one->high);
                widen(systematic, one->mean);
            }
            widen(mean, target.mean);
        }
        double x = m_x.end + 3.0;
        for (const Range& range : {Range{Iso230Figure::A, "A", accuracy},
                 Range{Iso230Figure::E, "E", systematic}, Range{Iso230Figure::M, "M", mean}}) {
            if (m_figures[range.figure].value)
                drawRange(x, range.range, range.symbol);
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
        m_plot.description = AXISCOMP_TEXT("Report",
            "Deviation over position: means of both directions with bands of 2 s, the mean of "
            "both, single runs");
    }

    const Measurement& m_measurement;
    const Iso230Figures& m_figures;
    FineUnit m_unit;
    Scale m_x;
    Scale m_y;
    ReportPlot m_plot;
};

} // namespace

DeviationRange deviationRange(const Measurement& measurement, const Iso230Figures& figures)
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    DeviationRange range{infinity, -infinity};
    const auto widen = [&range](double value) {
        range.low = std::min(range.low, value);
        range.high = std::max(range.high, value);
    };
    for (const RunValue& value : measurement.values)
        if (value.isUsed)
            widen(value.deviation);
    for (const TargetFigures& target : figures.targets)
        for (const DirectionFigures* one : {&target.up, &target.down})
            for (const auto& limit : {one->low, one->high})
                if (limit)
                    widen(*limit);
    return range;
}

DeviationRange united(const DeviationRange& a, const DeviationRange& b)
{
    return {std::min(a.low, b.low), std::max(a.high, b.high)};
}

ReportPlot deviationPlot(const Measurement& measurement, const Iso230Figures& figures,
    const DeviationRange& range, const PlotSize& size)
{
    return DeviationPlot(measurement, figures, range, size).drawn();
}

ReportPlot deviationLegend(double width)
{
    constexpr double height = 5.0;
    constexpr double middle = height / 2.0;
    constexpr double sample = 8.0; // mm, length of a piece of line
    ReportPlot legend;
    legend.width = width;
    legend.height = height;
    legend.description = AXISCOMP_TEXT("Report", "What lines and markers mean");
    const std::array<Text, 6> words{AXISCOMP_TEXT("Report", "mean ↑"),
        AXISCOMP_TEXT("Report", "mean ↓"), AXISCOMP_TEXT("Report", "mean of both"),
        AXISCOMP_TEXT("Report", "mean ↑ ± 2 s"), AXISCOMP_TEXT("Report", "mean ↓ ± 2 s"),
        AXISCOMP_TEXT("Report", "single run")};
    const double column = width / static_cast<double>(words.size());
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
    line(5.0 * column, PlotInk::Run, 0.1);
    for (std::size_t i = 0; i < words.size(); ++i)
        legend.labels.push_back(
            {{static_cast<double>(i) * column + sample + 1.0, middle + 0.35 * smallFont}, words[i],
                PlotLabel::Side::Left, false, smallFont});
    return legend;
}

} // namespace axiscomp::report
