// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drawing/deviation_canvas.h"

#include "ui/drawing/painted_item.h"
#include "ui/drawing/plot_style.h"
#include "ui/drawing/value_ticker.h"
#include "ui/text/translated_text.h"
#include "ui/text/value_text.h"

#include "ui/drawing/local_plot.h"

#include <algorithm>
#include <cmath>
#include <span>

namespace axiscomp::ui {

namespace {

constexpr std::size_t mostMarkers = 200; ///< of means, as long as they can be told apart
constexpr std::size_t mostDots = 600; ///< of single values
constexpr std::size_t mostMarks = 2000; ///< of values that are excluded or proposed
constexpr std::size_t mostThickPoints = 2000; ///< a wide line through more is slow to paint
constexpr double bracketSpacing = 20.0; // pixels
constexpr int widestLegend = 6; ///< of more, every row has fewer
constexpr int legendColumns = 4;

/// The points within a range of positions, and one on either side.
std::span<const PlacedDeviation> within(
    const std::vector<PlacedDeviation>& curve, const QCPRange& view)
{
    auto first = std::ranges::lower_bound(curve, view.lower, {}, &PlacedDeviation::position);
    auto end = std::ranges::upper_bound(curve, view.upper, {}, &PlacedDeviation::position);
    if (first != curve.begin())
        --first;
    if (end != curve.end())
        ++end;
    return {first, std::max(first, end)};
}

void fill(QCPGraph& graph, std::span<const PlacedDeviation> curve)
{
    QVector<double> keys;
    QVector<double> values;
    keys.reserve(static_cast<qsizetype>(curve.size()));
    values.reserve(keys.capacity());
    for (const PlacedDeviation& one : curve) {
        keys.append(one.position);
        values.append(one.deviation);
    }
    graph.setData(keys, values, true);
}

void paintCross(QCPPainter& painter, const QPointF& at)
{
    constexpr double half = 4.0;
    painter.drawLine(QLineF(at.x() - half, at.y() - half, at.x() + half, at.y() + half));
    painter.drawLine(QLineF(at.x() - half, at.y() + half, at.x() + half, at.y() - half));
}

} // namespace

struct DeviationCanvas::Private {
    explicit Private(QWidget* parent) : plot(new LocalPlot(parent)), inks(parent->palette()) { }

    QCustomPlot* plot;
    MeasurementInks inks;
    QSharedPointer<ValueTicker> ticker{new ValueTicker};
    std::vector<DeviationSeries> series;
    std::optional<DeviationPlace> selected;
    FineUnit unit;
    /// What may be clicked but is in no graph.
    struct Mark {
        PlacedDeviation place;
        bool isExcluded = false; ///< or proposed
    };
    std::vector<Mark> marks;
    QCPRange wholeX;
    QCPRange wholeY;
    bool isDrawn = false; ///< a layer alone can be drawn only after the whole was

    /// Those with all points where few enough of them are in sight.
    [[nodiscard]] const DeviationCurves& curvesOf(std::size_t number) const
    {
        const DeviationSeries& one = series[number];
        const bool isFew = std::ranges::all_of(
            std::initializer_list<const std::vector<PlacedDeviation>*>{&one.curves->up.mean,
                &one.curves->down.mean, &one.curves->up.smallest, &one.curves->down.smallest},
            [&](const auto* curve) {
                return within(*curve, plot->xAxis->range()).size() <= DeviationSeries::mostPoints;
            });
        return isFew ? *one.curves : *one.overview;
    }
    [[nodiscard]] bool isDense() const
    {
        return std::ranges::any_of(series, [](const DeviationSeries& one) {
            return one.measurement->targets.size() > DeviationSeries::mostPoints;
        });
    }
    /// Where there are too many points to draw those that nobody sees.
    [[nodiscard]] std::span<const PlacedDeviation> toDraw(
        const std::vector<PlacedDeviation>& curve) const
    {
        return isDense() ? within(curve, plot->xAxis->range())
                         : std::span<const PlacedDeviation>(curve);
    }
    [[nodiscard]] bool isFirstOfTwo(std::size_t number) const
    {
        return series.size() > 1 && number == 0;
    }
    [[nodiscard]] QPointF pixel(double position, double deviation) const
    {
        return {plot->xAxis->coordToPixel(position), plot->yAxis->coordToPixel(deviation)};
    }
    /// What is excluded and out of sight stands at the border: the picture has the scale of the
    /// values in use.
    [[nodiscard]] QPointF heldInSight(const QPointF& place) const
    {
        constexpr double arrow = 10.0;
        const QRectF sight = plot->axisRect()->rect();
        const double lowest = std::max(sight.top() + arrow, sight.bottom() - arrow);
        return {place.x(), std::clamp(place.y(), sight.top() + arrow, lowest)};
    }
    /// Dashes through many points are slow to paint.
    [[nodiscard]] QPen pen(std::size_t number, const QColor& color, double width) const
    {
        return {color, width, isFirstOfTwo(number) && !isDense() ? Qt::DashLine : Qt::SolidLine};
    }
    [[nodiscard]] QString named(std::size_t number, const QString& text) const
    {
        const QString& name = series[number].name;
        return name.isEmpty() ? text : name + QStringLiteral(": ") + text;
    }

    void paintMarks(QCPPainter& painter) const;
    void paintReversal(QCPPainter& painter) const;
    void paintBrackets(QCPPainter& painter) const;
    void paintBracket(
        QCPPainter& painter, double x, const DeviationRange& range, const QString& text) const;
    void paintSelection(QCPPainter& painter, const QRectF& sight) const;
};

DeviationCanvas::DeviationCanvas(QWidget* parent)
    : QObject(parent)
    , d(std::make_unique<Private>(parent))
{
    QCustomPlot& plot = *d->plot;
    plot.setObjectName(QStringLiteral("deviationPicture"));
    plot.setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    plot.setNoAntialiasingOnDrag(true);
    plot.axisRect()->setupFullAxesBox(true);
    plot.yAxis->setTicker(d->ticker);
    // Below the picture: over it there is no place that is always free.
    plot.axisRect()->insetLayout()->take(plot.legend);
    plot.plotLayout()->addElement(1, 0, plot.legend);
    plot.plotLayout()->setRowStretchFactor(1, 0.001);
    plot.legend->setVisible(true);
    plot.legend->setFillOrder(QCPLegend::foColumnsFirst);
    plot.legend->setMargins(QMargins(4, 0, 4, 4));
    plot.legend->setIconSize(24, 12);
    letLegendBeWide(*plot.legend);
    const auto paint = [&plot](const char* layer, PaintedItem::Paint what, bool isClipped = true) {
        auto* item = new PaintedItem(plot, layer, std::move(what));
        item->setClipToAxisRect(isClipped);
    };
    paint("axes", [this](QCPPainter& painter, const QRectF&) {
        d->paintReversal(painter);
        d->paintMarks(painter);
    });
    paint(
        "axes", [this](QCPPainter& painter, const QRectF&) { d->paintBrackets(painter); }, false);
    paint("overlay",
        [this](QCPPainter& painter, const QRectF& sight) { d->paintSelection(painter, sight); });
    connect(plot.xAxis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this,
        &DeviationCanvas::drawAgainIfDense);
    connect(&plot, &QCustomPlot::afterReplot, this, [this] { d->isDrawn = true; });
    setPalette(parent->palette());
}

DeviationCanvas::~DeviationCanvas() = default;

QCustomPlot& DeviationCanvas::plot()
{
    return *d->plot;
}

const FineUnit& DeviationCanvas::unit() const
{
    return d->unit;
}

void DeviationCanvas::show(const std::vector<DeviationSeries>& series)
{
    d->series = series;
    const bool hasTwo = series.size() > 1;
    const double brackets = series.empty() ? 0.0 : 3.0 * bracketSpacing * (hasTwo ? 2.0 : 1.0);
    d->plot->axisRect()->setMinimumMargins(QMargins(0, 6, static_cast<int>(brackets) + 12, 0));
    fitRanges();
    draw();
    retranslate();
}

void DeviationCanvas::draw()
{
    d->marks.clear();
    d->plot->clearGraphs();
    for (std::size_t number = 0; number < d->series.size(); ++number)
        addSeries(number);
    addLegend();
    d->plot->axisRect()->setVisible(!d->series.empty());
}

void DeviationCanvas::drawAgainIfDense()
{
    if (d->isDense())
        draw();
}

void DeviationCanvas::addSeries(std::size_t number)
{
    const DeviationSeries& series = d->series[number];
    const DeviationCurves& curves = d->curvesOf(number);
    // Smooth lines and areas of many points are slow to paint, above all where they go up and down.
    const bool isDense = series.measurement->targets.size() > mostThickPoints;
    const auto graph = [&](const std::vector<PlacedDeviation>& curve, const QPen& pen) {
        QCPGraph* added = d->plot->addGraph();
        added->removeFromLegend();
        fill(*added, d->toDraw(curve));
        added->setPen(pen);
        added->setAntialiased(!isDense);
        return added;
    };
    const double thin = isDense ? 0.0 : 1.0;
    QCPGraph* high = graph(curves.up.high, d->pen(number, d->inks.up, 0.0));
    QCPGraph* low = graph(curves.up.low, d->pen(number, d->inks.up, 0.0));
    QColor band = d->inks.up;
    constexpr int seeThrough = 40;
    band.setAlpha(seeThrough);
    if (!isDense) {
        high->setBrush(band);
        high->setChannelFillGraph(low);
    }
    for (const auto* limit : {&curves.down.low, &curves.down.high})
        graph(*limit, QPen(d->inks.down, thin, isDense ? Qt::SolidLine : Qt::DotLine));
    addRuns(number);
    const auto mean = [&](const std::vector<PlacedDeviation>& curve, const QColor& color,
                          QCPScatterStyle::ScatterShape shape, const QBrush& brush) {
        QCPGraph* added = graph(curve, d->pen(number, color, isDense ? 0.0 : 1.5));
        if (curve.size() <= mostMarkers)
            added->setScatterStyle(QCPScatterStyle(shape, QPen(color, 1.2), brush, 8));
    };
    graph(curves.mean, d->pen(number, d->inks.text, isDense ? 0.0 : 2.0));
    mean(curves.up.mean, d->inks.up, QCPScatterStyle::ssTriangle, d->inks.up);
    mean(curves.down.mean, d->inks.down, QCPScatterStyle::ssTriangleInverted, d->inks.base);
    for (const PlacedDeviation& place : curves.excluded)
        if (d->marks.size() < mostMarks)
            d->marks.push_back({place, true});
    if (!series.outliers)
        return;
    for (const auto& [direction, outliers] : {std::pair(Approach::Up, &series.outliers->up),
             std::pair(Approach::Down, &series.outliers->down)}) {
        for (const Outlier& outlier : outliers->flagged) {
            if (d->marks.size() >= mostMarks)
                break;
            const RunValue* value =
                findValue(*series.measurement, direction, outlier.target, outlier.run);
            if (value && value->isUsed)
                d->marks.push_back(
                    {{series.measurement->targets[value->target], series.shown(value->deviation)},
                        false});
        }
    }
}

/// Of two measurements none: there would be too many lines to tell what belongs where.
void DeviationCanvas::addRuns(std::size_t number)
{
    if (d->series.size() > 1)
        return;
    const DeviationCurves& curves = d->curvesOf(number);
    const auto add = [&](const std::vector<PlacedDeviation>& curve) {
        QCPGraph* graph = d->plot->addGraph();
        graph->removeFromLegend();
        graph->setPen(QPen(d->inks.run, 0.0));
        graph->setAntialiased(curves.valueCount <= DeviationSeries::mostPoints);
        fill(*graph, d->toDraw(curve));
        return graph;
    };
    if (curves.valueCount > DeviationSeries::mostPoints) {
        for (const DeviationCurves::Direction* direction : {&curves.up, &curves.down}) {
            add(direction->smallest);
            add(direction->largest);
        }
        return;
    }
    for (const DeviationCurves::Run& run : curves.runs) {
        QCPGraph* graph = add(run.values);
        if (curves.valueCount <= mostDots)
            graph->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssDisc, d->inks.run, 3.0));
    }
}

/// A sample of each line: what is drawn has other widths, and there are more lines than kinds.
void DeviationCanvas::addLegend()
{
    const auto add = [this](const QString& text, const QPen& pen, const QCPScatterStyle& shape,
                         const QBrush& brush = Qt::NoBrush) {
        QCPGraph* sample = d->plot->addGraph();
        sample->setName(text);
        sample->setPen(pen);
        sample->setScatterStyle(shape);
        sample->setBrush(brush);
    };
    const auto textOf = [](DeviationLine line) { return translated(deviationLineText(line)); };
    using Shape = QCPScatterStyle;
    QColor band = d->inks.up;
    constexpr int seeThrough = 60;
    band.setAlpha(seeThrough);
    for (std::size_t number = 0; number < d->series.size(); ++number) {
        add(d->named(number, textOf(DeviationLine::MeanUp)), d->pen(number, d->inks.up, 1.5),
            Shape(Shape::ssTriangle, QPen(d->inks.up), d->inks.up, 8));
        add(d->named(number, textOf(DeviationLine::MeanDown)), d->pen(number, d->inks.down, 1.5),
            Shape(Shape::ssTriangleInverted, QPen(d->inks.down), d->inks.base, 8));
        add(d->named(number, textOf(DeviationLine::Mean)), d->pen(number, d->inks.text, 2.0), {});
    }
    if (d->series.empty())
        return;
    add(textOf(DeviationLine::BandUp), QPen(d->inks.up, 0.0), {}, band);
    add(textOf(DeviationLine::BandDown), QPen(d->inks.down, 1.0, Qt::DotLine), {});
    if (d->series.size() == 1)
        add(d->series[0].curves->valueCount > DeviationSeries::mostPoints
                ? tr("smallest and largest value")
                : textOf(DeviationLine::Run),
            QPen(d->inks.run, 0.0), {});
    const auto has = [this](bool isExcluded) {
        return std::ranges::find(d->marks, isExcluded, &Private::Mark::isExcluded)
            != d->marks.end();
    };
    if (has(true))
        add(tr("excluded"), Qt::NoPen,
            Shape(Shape::ssCross, QPen(d->inks.doubtful, 1.5), Qt::NoBrush, 8));
    if (has(false))
        add(tr("proposed for exclusion"), Qt::NoPen,
            Shape(Shape::ssCircle, QPen(d->inks.doubtful, 1.5), Qt::NoBrush, 10));
    QCPLegend* legend = d->plot->legend;
    legend->setWrap(legend->itemCount() > widestLegend ? legendColumns : widestLegend);
    legend->setFillOrder(QCPLegend::foColumnsFirst, true); // what is in it already moves too
}

/// The view stays while it shows the same targets and deviations.
void DeviationCanvas::fitRanges()
{
    std::optional<DeviationRange> all;
    std::optional<DeviationRange> targets;
    bool isAngular = false;
    for (const DeviationSeries& series : d->series) {
        const auto& places = series.measurement->targets;
        const DeviationRange own{places.front(), places.back()};
        targets = targets ? united(*targets, own) : own;
        if (const auto& range = series.curves->all)
            all = all ? united(*all, *range) : *range;
        isAngular = series.measurement->isAngular;
    }
    const DeviationRange shown = all.value_or(DeviationRange{});
    const std::optional<double> limits[] = {shown.low, shown.high};
    d->unit = fineUnit(limits, isAngular);
    d->ticker->setFactor(d->unit.factor);
    const auto padded = [](const DeviationRange& range, double share, double least) {
        const double room = range.high > range.low ? share * (range.high - range.low) : least;
        return QCPRange(range.low - room, range.high + room);
    };
    const QCPRange x = padded(targets.value_or(DeviationRange{}), 0.04, 0.5);
    const QCPRange y = padded(shown, 0.06, 0.5 / d->unit.factor);
    if (x == d->wholeX && y == d->wholeY)
        return;
    d->wholeX = x;
    d->wholeY = y;
    showWhole();
}

void DeviationCanvas::showWhole()
{
    d->plot->xAxis->setRange(d->wholeX);
    d->plot->yAxis->setRange(d->wholeY);
    d->plot->replot(QCustomPlot::rpQueuedReplot);
}

void DeviationCanvas::zoom(double factor)
{
    for (QCPAxis* axis : {d->plot->xAxis, d->plot->yAxis})
        axis->scaleRange(factor, axis->range().center());
    d->plot->replot(QCustomPlot::rpQueuedReplot);
}

void DeviationCanvas::retranslate()
{
    const bool isAngular = !d->series.empty() && d->series[0].measurement->isAngular;
    d->plot->xAxis->setLabel(withUnit(tr("Target"), isAngular ? "°" : "mm"));
    d->plot->yAxis->setLabel(deviationLabel(
        d->unit, d->series.empty() ? std::nullopt : d->series[0].curves->datum, isAngular));
    d->plot->replot(QCustomPlot::rpQueuedReplot);
}

void DeviationCanvas::setPalette(const QPalette& palette)
{
    d->inks = MeasurementInks(palette);
    stylePlot(*d->plot, d->inks);
    show(d->series);
}

void DeviationCanvas::setSelected(const std::optional<DeviationPlace>& place)
{
    d->selected = place;
    paintOverlay();
}

void DeviationCanvas::paintOverlay()
{
    if (d->isDrawn)
        d->plot->layer(QStringLiteral("overlay"))->replot();
}

std::optional<double> DeviationCanvas::positionAt(const QPointF& pixel) const
{
    if (d->series.empty() || !d->plot->axisRect()->rect().contains(pixel.toPoint()))
        return std::nullopt;
    return d->plot->xAxis->pixelToCoord(pixel.x());
}

std::optional<DeviationPlace> DeviationCanvas::placeAt(const QPointF& pixel) const
{
    constexpr double reach = 12.0; // pixels
    constexpr std::size_t mostNear = 500;
    if (!positionAt(pixel))
        return std::nullopt;
    const double from = d->plot->xAxis->pixelToCoord(pixel.x() - reach);
    const double to = d->plot->xAxis->pixelToCoord(pixel.x() + reach);
    std::optional<DeviationPlace> nearest;
    double best = reach;
    const auto offer = [&](const QPointF& place, const DeviationPlace& meant) {
        const double away = std::hypot(place.x() - pixel.x(), place.y() - pixel.y());
        if (away > best)
            return;
        best = away;
        nearest = meant;
    };
    for (std::size_t number = 0; number < d->series.size(); ++number) {
        const DeviationSeries& series = d->series[number];
        const Measurement& measurement = *series.measurement;
        const auto& targets = measurement.targets;
        auto at = std::ranges::lower_bound(targets, from);
        // Where they cannot be told apart it does not matter which ones are near.
        for (std::size_t count = 0; at != targets.end() && *at <= to && count < mostNear;
             ++at, ++count) {
            const auto target = static_cast<std::size_t>(at - targets.begin());
            for (const Approach direction : {Approach::Up, Approach::Down})
                for (const RunValue& value : valuesAt(measurement, direction, target)) {
                    QPointF place = d->pixel(*at, series.shown(value.deviation));
                    if (!value.isUsed)
                        place = d->heldInSight(place);
                    offer(place, {number, {value.direction, value.target + 1, value.run}});
                }
        }
        const auto& figures = series.figures->targets;
        auto figure = std::ranges::lower_bound(figures, from, {}, &TargetFigures::position);
        for (std::size_t count = 0;
             figure != figures.end() && figure->position <= to && count < mostNear;
             ++figure, ++count)
            for (const DirectionFigures* one : {&figure->up, &figure->down})
                if (one->mean)
                    offer(d->pixel(figure->position, series.shown(*one->mean)),
                        {number, {{}, figure->target + 1, {}}});
    }
    return nearest;
}

/// Out of sight, an excluded value has an arrow towards where it is.
void DeviationCanvas::Private::paintMarks(QCPPainter& painter) const
{
    constexpr double ring = 5.5;
    constexpr double arrow = 9.0;
    painter.setPen(QPen(inks.doubtful, 1.5));
    painter.setBrush(Qt::NoBrush);
    for (const Mark& mark : marks) {
        const QPointF at = pixel(mark.place.position, mark.place.deviation);
        if (!mark.isExcluded) {
            painter.drawEllipse(at, ring, ring);
            continue;
        }
        const QPointF held = heldInSight(at);
        paintCross(painter, held);
        if (held.y() == at.y())
            continue;
        const double towards = at.y() < held.y() ? -1.0 : 1.0;
        const QPointF tip = held + QPointF(0.0, towards * arrow);
        painter.drawLine(QLineF(held, tip));
        for (const double side : {-3.0, 3.0})
            painter.drawLine(QLineF(tip, tip + QPointF(side, -3.0 * towards)));
    }
}

void DeviationCanvas::Private::paintReversal(QCPPainter& painter) const
{
    for (const DeviationSeries& one : series) {
        const auto& reversal = one.curves->reversal;
        if (!reversal)
            continue;
        const QPointF up = pixel(reversal->position, reversal->up);
        const QPointF down = pixel(reversal->position, reversal->down);
        painter.setPen(QPen(inks.text, 2.0));
        painter.drawLine(QLineF(up, down));
        const QSizeF size = noteSize(painter, QStringLiteral("B"));
        paintNote(painter,
            QRectF(QPointF(up.x() + 5.0, (up.y() + down.y() - size.height()) / 2.0), size),
            QStringLiteral("B"), plot->axisRect()->rect(), inks.base);
    }
}

void DeviationCanvas::Private::paintBrackets(QCPPainter& painter) const
{
    double x = plot->axisRect()->rect().right() + 10.0;
    for (std::size_t number = 0; number < series.size(); ++number) {
        const DeviationCurves& curves = *series[number].curves;
        const QString& name = series[number].name;
        painter.setPen(pen(number, inks.text, 1.0));
        for (const auto& [symbol, range] : {std::pair("A", curves.accuracy),
                 std::pair("E", curves.systematic), std::pair("M", curves.meanRange)}) {
            if (range)
                paintBracket(painter, x, *range,
                    QLatin1StringView(symbol) + (name.isEmpty() ? QString() : u' ' + name));
            x += bracketSpacing;
        }
    }
}

/// With its letter beside it, or its words along it.
void DeviationCanvas::Private::paintBracket(
    QCPPainter& painter, double x, const DeviationRange& range, const QString& text) const
{
    constexpr double half = 4.0;
    const QRectF sight = plot->axisRect()->rect();
    const auto held = [&](double deviation) {
        return std::clamp(plot->yAxis->coordToPixel(deviation), sight.top(), sight.bottom());
    };
    const double high = held(range.high);
    const double low = held(range.low);
    painter.drawLine(QLineF(x, low, x, high));
    for (const double y : {low, high})
        painter.drawLine(QLineF(x - half, y, x + half, y));
    const QSizeF size = noteSize(painter, text);
    double middle = (low + high) / 2.0;
    constexpr double gap = 6.0;
    const bool isAlong = text.size() > 1;
    if (isAlong
        && low - high < size.width() + 2.0 * gap) // a short one would be hidden by its words
        middle = high - gap - size.width() / 2.0;
    painter.save();
    painter.translate(x, middle);
    QRectF place(QPointF(-size.width() / 2.0, -size.height() / 2.0), size);
    if (isAlong)
        painter.rotate(-90.0);
    painter.fillRect(place, inks.base);
    painter.drawText(place, Qt::AlignCenter, text);
    painter.restore();
}

void DeviationCanvas::Private::paintSelection(QCPPainter& painter, const QRectF& sight) const
{
    if (plot->hasFocus()) {
        painter.setPen(QPen(inks.selected, 2.0));
        painter.setBrush(Qt::NoBrush);
        painter.drawRect(sight.adjusted(1.0, 1.0, -1.0, -1.0));
    }
    if (!selected || selected->series >= series.size())
        return;
    const DeviationSeries& shown = series[selected->series];
    const Measurement& measurement = *shown.measurement;
    const Exclusion& values = selected->values;
    painter.setPen(QPen(inks.text, 1.0, Qt::DashLine));
    if (values.target && *values.target <= measurement.targets.size()) {
        const double x = plot->xAxis->coordToPixel(measurement.targets[*values.target - 1]);
        painter.drawLine(QLineF(x, sight.top(), x, sight.bottom()));
    }
    if (!values.direction || !values.run)
        return;
    const auto& targets = measurement.targets;
    const QCPRange view = plot->xAxis->range();
    std::size_t first = 0;
    std::size_t end = targets.size();
    if (values.target) {
        first = std::min(*values.target - 1, end);
        end = std::min(first + 1, end);
    } else {
        first = static_cast<std::size_t>(
            std::ranges::lower_bound(targets, view.lower) - targets.begin());
        end = static_cast<std::size_t>(
            std::ranges::upper_bound(targets, view.upper) - targets.begin());
    }
    const std::size_t step = 1 + (end - std::min(first, end)) / mostThickPoints;
    QPolygonF line;
    for (std::size_t target = first; target < end; target += step)
        if (const RunValue* value =
                findValue(measurement, *values.direction, target, *values.run)) {
            const QPointF place = pixel(targets[target], shown.shown(value->deviation));
            line.append(value->isUsed ? place : heldInSight(place));
        }
    painter.setPen(QPen(inks.selected, 3.0));
    painter.setBrush(Qt::NoBrush);
    if (line.size() == 1)
        painter.drawEllipse(line.front(), 8.0, 8.0);
    else
        painter.drawPolyline(line);
}

} // namespace axiscomp::ui
