// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_canvas.h"

#include "core/table/table_math.h"
#include "ui/style/contrast.h"

#include "ui/plot/custom_plot.h"

#include <algorithm>

namespace axiscomp::ui {

namespace {

/// A table in the plot library's form. Its own way, cell by cell with checks, takes as long as
/// drawing.
class TableMapData final : public QCPColorMapData {
public:
    TableMapData(const CompensationTable& table, double largest)
        : QCPColorMapData(static_cast<int>(table.grid.axes[0].size),
            static_cast<int>(table.grid.axes[1].size),
            QCPRange(table.grid.axes[0].start, table.grid.axes[0].last()),
            QCPRange(table.grid.axes[1].start, table.grid.axes[1].last()))
    {
        std::ranges::transform(
            table.values, mData, [](float value) { return static_cast<double>(value); });
        mDataBounds = QCPRange(-largest, largest);
        mDataModified = true;
    }
};

bool isDark(const QPalette& palette)
{
    return palette.color(QPalette::Base).lightness() < 128;
}

/// Blue below zero, red above, the background's own lightness at zero: equal amounts look equally
/// strong, and the two signs differ for colour-blind eyes too.
QCPColorGradient divergingGradient(bool dark)
{
    QCPColorGradient gradient;
    gradient.clearColorStops();
    gradient.setColorInterpolation(QCPColorGradient::ciRGB);
    const std::array<QColor, 5> light{QColor(5, 70, 140), QColor(90, 155, 205),
        QColor(247, 247, 247), QColor(225, 120, 85), QColor(150, 15, 35)};
    const std::array<QColor, 5> night{QColor(120, 195, 255), QColor(45, 105, 165),
        QColor(38, 38, 40), QColor(175, 75, 50), QColor(255, 165, 130)};
    const std::array<QColor, 5>& colors = dark ? night : light;
    for (std::size_t i = 0; i < colors.size(); ++i)
        gradient.setColorStopAt(static_cast<double>(i) / 4.0, colors[i]);
    return gradient;
}

void stylePen(QCPAxis* axis, const QColor& text, const QColor& grid)
{
    axis->setBasePen(QPen(text));
    axis->setTickPen(QPen(text));
    axis->setSubTickPen(QPen(text));
    axis->setTickLabelColor(text);
    axis->setLabelColor(text);
    axis->grid()->setPen(QPen(grid, 1, Qt::DotLine));
    axis->grid()->setZeroLinePen(QPen(grid, 1, Qt::SolidLine));
}

/// A horizontal and a vertical line through one point, with a ring where they meet.
struct Cross {
    explicit Cross(QCustomPlot& plot)
        : vertical(new QCPItemStraightLine(&plot))
        , horizontal(new QCPItemStraightLine(&plot))
    {
        for (QCPItemStraightLine* line : {vertical, horizontal}) {
            line->setLayer(QStringLiteral("overlay"));
            line->setSelectable(false);
            line->setVisible(false);
        }
    }
    void setPen(const QPen& pen) const
    {
        vertical->setPen(pen);
        horizontal->setPen(pen);
    }
    void hide() const
    {
        vertical->setVisible(false);
        horizontal->setVisible(false);
    }
    void show(double x, double y) const
    {
        vertical->setVisible(true);
        horizontal->setVisible(true);
        vertical->point1->setCoords(x, y);
        vertical->point2->setCoords(x, y + 1.0);
        horizontal->point1->setCoords(x, y);
        horizontal->point2->setCoords(x + 1.0, y);
    }
    QCPItemStraightLine* vertical;
    QCPItemStraightLine* horizontal;
};

} // namespace

struct PlotCanvas::Private {
    explicit Private(QWidget* parent) : plot(new QCustomPlot(parent)) { }

    QCustomPlot* plot;
    QCPGraph* curve = nullptr;
    QCPGraph* secondCurve = nullptr;
    QCPGraph* filled = nullptr; ///< points that were made up, not measured
    QCPGraph* proved = nullptr;
    QCPGraph* marker = nullptr;
    QCPColorMap* map = nullptr;
    QCPColorScale* scale = nullptr;
    std::unique_ptr<Cross> crosshair;
    std::array<std::unique_ptr<Cross>, 2> cursors;
    std::array<QCPItemText*, 2> cursorLabels{};

    std::shared_ptr<const CompensationTable> table;
    std::shared_ptr<const CompensationTable> second;
    double range = 1.0;
    bool isDrawn = false; ///< a layer alone can be drawn only after the whole was

    [[nodiscard]] bool isMap() const { return table && table->grid.dimensions() == 2; }
    [[nodiscard]] double xOf(const GridPoint& point) const
    {
        return table->grid.axes[0].position(point.i);
    }
    [[nodiscard]] double yOf(const GridPoint& point) const
    {
        return isMap() ? table->grid.axes[1].position(point.j)
                       : static_cast<double>(table->values[point.i]);
    }
};

PlotCanvas::PlotCanvas(QWidget* parent) : QObject(parent), d(std::make_unique<Private>(parent))
{
    QCustomPlot& plot = *d->plot;
    plot.setObjectName(QStringLiteral("plotCanvas"));
    plot.setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    plot.setNoAntialiasingOnDrag(true);
    plot.axisRect()->setupFullAxesBox(true);

    d->secondCurve = plot.addGraph();
    d->curve = plot.addGraph();
    d->filled = plot.addGraph();
    d->filled->setLayer(QStringLiteral("axes")); // above the map
    d->filled->setLineStyle(QCPGraph::lsNone);
    d->filled->removeFromLegend();
    d->proved = plot.addGraph();
    d->proved->setObjectName(QStringLiteral("provedPart"));
    d->proved->setLayer(QStringLiteral("overlay"));
    d->proved->removeFromLegend();
    d->marker = plot.addGraph();
    d->marker->setLayer(QStringLiteral("overlay"));
    d->marker->removeFromLegend();
    d->marker->setLineStyle(QCPGraph::lsNone);
    d->map = new QCPColorMap(plot.xAxis, plot.yAxis);
    d->map->removeFromLegend();
    d->map->setInterpolate(false);
    d->map->setTightBoundary(false);
    d->scale = new QCPColorScale(&plot);
    d->scale->setBarWidth(12);
    d->scale->setRangeDrag(false);
    d->scale->setRangeZoom(false);
    d->map->setColorScale(d->scale);
    d->crosshair = std::make_unique<Cross>(plot);
    for (std::size_t which = 0; which < d->cursors.size(); ++which) {
        d->cursors[which] = std::make_unique<Cross>(plot);
        auto* label = new QCPItemText(&plot);
        label->setLayer(QStringLiteral("overlay"));
        label->setText(which == 0 ? QStringLiteral("A") : QStringLiteral("B"));
        label->setPositionAlignment(Qt::AlignLeft | Qt::AlignBottom);
        label->setPadding(QMargins(4, 1, 4, 1));
        label->setVisible(false);
        d->cursorLabels[which] = label;
    }
    plot.legend->setVisible(false);
    plot.legend->setFillOrder(QCPLegend::foColumnsFirst);
    connect(&plot, &QCustomPlot::afterReplot, this, [this] { d->isDrawn = true; });
    setPalette(parent->palette());
}

PlotCanvas::~PlotCanvas() = default;

QCustomPlot& PlotCanvas::plot()
{
    return *d->plot;
}

void PlotCanvas::show(std::shared_ptr<const CompensationTable> table,
    std::shared_ptr<const CompensationTable> second, double scale)
{
    const bool isSameGrid = table && d->table && table->grid.axes == d->table->grid.axes;
    d->table = std::move(table);
    d->second = std::move(second);
    d->range = scale;
    d->crosshair->hide();
    d->curve->data()->clear();
    d->secondCurve->data()->clear();
    d->map->setVisible(d->isMap());
    QCPLayoutGrid* layout = d->plot->plotLayout();
    const bool hasScale = layout->elementCount() > 0 && d->scale->layout() == layout;
    if (d->isMap() && !hasScale)
        layout->addElement(0, 1, d->scale);
    if (!d->isMap() && hasScale) {
        layout->take(d->scale);
        layout->simplify();
    }
    d->scale->setVisible(d->isMap());
    d->plot->legend->setVisible(d->table && !d->isMap() && d->second);
    if (d->isMap())
        showMap();
    else if (d->table)
        showCurve();
    showFilled();
    if (!isSameGrid)
        return resetZoom();
    if (!d->isMap())
        fitValues();
    replot();
}

void PlotCanvas::showCurve()
{
    const auto fill = [](QCPGraph& graph, const CompensationTable& table) {
        QVector<double> x;
        QVector<double> y;
        x.reserve(static_cast<qsizetype>(table.values.size()));
        y.reserve(x.capacity());
        for (std::size_t i = 0; i < table.values.size(); ++i) {
            x.append(table.grid.axes[0].position(i));
            y.append(static_cast<double>(table.values[i]));
        }
        graph.setData(x, y, true);
    };
    fill(*d->curve, *d->table);
    if (d->second)
        fill(*d->secondCurve, *d->second);
    // Points are drawn while they can be told apart. Where several share a pixel, a wide or dashed
    // line is several hundred times slower to paint than a thin one.
    const std::size_t count = d->table->values.size();
    const bool isSparse = count <= 200;
    const bool isDense = count > 2000 || (d->second && d->second->values.size() > 2000);
    d->curve->setPen(QPen(d->curve->pen().color(), isDense ? 1.0 : 2.0));
    d->secondCurve->setPen(QPen(d->secondCurve->pen().color(), isDense ? 1.0 : 1.5,
        isDense ? Qt::SolidLine : Qt::DashLine));
    d->curve->setScatterStyle(isSparse ? QCPScatterStyle(QCPScatterStyle::ssDisc, 5)
                                       : QCPScatterStyle(QCPScatterStyle::ssNone));
}

void PlotCanvas::showMap()
{
    d->map->setData(new TableMapData(*d->table, d->range)); // the map takes it over
    d->map->setDataRange(QCPRange(-d->range, d->range));
}

/// Crosses, as far as they can be told apart.
void PlotCanvas::showFilled()
{
    constexpr std::size_t most = 4000;
    d->filled->data()->clear();
    if (!d->table || d->table->filled.size() > most)
        return;
    const std::size_t width = d->table->grid.axes[0].size;
    for (const std::size_t point : d->table->filled) {
        const GridPoint place{point % width, point / width};
        d->filled->addData(d->xOf(place), d->yOf(place));
    }
}

void PlotCanvas::setLabels(const QString& x, const QString& y, const QString& value)
{
    d->plot->xAxis->setLabel(x);
    d->plot->yAxis->setLabel(d->isMap() ? y : value);
    d->scale->axis()->setLabel(value);
}

void PlotCanvas::setNames(const QString& first, const QString& second)
{
    d->curve->setName(first);
    d->secondCurve->setName(second);
}

void PlotCanvas::setPalette(const QPalette& palette)
{
    QCustomPlot& plot = *d->plot;
    const bool dark = isDark(palette);
    const QColor base = palette.color(QPalette::Base);
    const QColor text = palette.color(QPalette::Text);
    const QColor grid = mutedTextColor(palette);
    plot.setBackground(base);
    for (QCPAxis* axis : {plot.xAxis, plot.yAxis, plot.xAxis2, plot.yAxis2, d->scale->axis()})
        stylePen(axis, text, grid);
    d->map->setGradient(divergingGradient(dark));
    const QColor curve = dark ? QColor(110, 185, 255) : QColor(5, 80, 160);
    const auto recolor = [](QCPGraph& graph, const QColor& color) {
        QPen pen = graph.pen();
        pen.setColor(color);
        graph.setPen(pen);
    };
    recolor(*d->curve, curve);
    recolor(*d->secondCurve, grid);
    plot.legend->setBrush(base);
    plot.legend->setTextColor(text);
    plot.legend->setBorderPen(QPen(grid));
    const QColor marker = dark ? QColor(255, 200, 60) : QColor(120, 60, 0);
    QColor proved = dark ? QColor(90, 220, 130) : QColor(0, 140, 60);
    constexpr int seeThrough = 130;
    proved.setAlpha(seeThrough);
    constexpr double provedWidth = 6.0;
    d->proved->setPen(QPen(proved, provedWidth));
    d->marker->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssDiamond, QPen(text, 1.5), QBrush(marker), 11));
    d->filled->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssCross, QPen(text, 1.0), Qt::NoBrush, 7));
    d->crosshair->setPen(QPen(text, 1, Qt::DotLine));
    const std::array<QColor, 2> cursorColors{text, marker};
    for (std::size_t which = 0; which < d->cursors.size(); ++which) {
        d->cursors[which]->setPen(QPen(cursorColors[which], 1.5));
        d->cursorLabels[which]->setColor(base);
        d->cursorLabels[which]->setBrush(cursorColors[which]);
    }
}

void PlotCanvas::setMarker(const std::optional<std::array<double, 2>>& position, double value)
{
    d->marker->data()->clear();
    if (position)
        d->marker->addData((*position)[0], d->isMap() ? (*position)[1] : value);
    paintOverlay();
}

void PlotCanvas::setProved(const QVector<double>& keys, const QVector<double>& values)
{
    d->proved->setLineStyle(d->isMap() ? QCPGraph::lsNone : QCPGraph::lsLine);
    d->proved->setScatterStyle(d->isMap()
            ? QCPScatterStyle(QCPScatterStyle::ssDisc, d->proved->pen().color(), 4.0)
            : QCPScatterStyle(QCPScatterStyle::ssNone));
    d->proved->setData(keys, values);
    paintOverlay();
}

void PlotCanvas::setCrosshair(const std::optional<GridPoint>& point)
{
    if (point && d->table)
        d->crosshair->show(d->xOf(*point), d->yOf(*point));
    else
        d->crosshair->hide();
    paintOverlay();
}

void PlotCanvas::setCursor(int which, const std::optional<GridPoint>& point)
{
    const auto index = static_cast<std::size_t>(which);
    QCPItemText* label = d->cursorLabels[index];
    label->setVisible(point && d->table);
    if (point && d->table) {
        d->cursors[index]->show(d->xOf(*point), d->yOf(*point));
        label->position->setCoords(d->xOf(*point), d->yOf(*point));
    } else {
        d->cursors[index]->hide();
    }
    paintOverlay();
}

std::optional<GridPoint> PlotCanvas::pointAt(const QPointF& pixel) const
{
    if (!d->table || !d->plot->axisRect()->rect().contains(pixel.toPoint()))
        return std::nullopt;
    GridPoint point;
    point.i = nearestIndex(d->table->grid.axes[0], d->plot->xAxis->pixelToCoord(pixel.x()));
    if (d->isMap())
        point.j = nearestIndex(d->table->grid.axes[1], d->plot->yAxis->pixelToCoord(pixel.y()));
    return point;
}

void PlotCanvas::resetZoom()
{
    if (d->isMap()) {
        // The outer cells whole: their points are in the middle of them.
        const auto& axes = d->table->grid.axes;
        for (const auto& [drawn, axis] :
            {std::pair(d->plot->xAxis, &axes[0]), std::pair(d->plot->yAxis, &axes[1])})
            drawn->setRange(
                axis->start - axis->distance / 2.0, axis->last() + axis->distance / 2.0);
    } else if (d->table) {
        d->plot->xAxis->setRange(d->table->grid.axes[0].start, d->table->grid.axes[0].last());
        d->plot->xAxis->scaleRange(1.04, d->plot->xAxis->range().center());
        fitValues();
    }
    replot();
}

void PlotCanvas::fitValues()
{
    if (!d->table)
        return;
    d->curve->rescaleValueAxis();
    if (d->second)
        d->secondCurve->rescaleValueAxis(true);
    if (d->plot->yAxis->range().size() < d->range * 1e-6)
        d->plot->yAxis->setRange(-d->range, d->range);
    d->plot->yAxis->scaleRange(1.1, d->plot->yAxis->range().center());
    // Room for the legend above the curves.
    if (d->second)
        d->plot->yAxis->setRangeUpper(
            d->plot->yAxis->range().upper + 0.15 * d->plot->yAxis->range().size());
}

void PlotCanvas::reveal(const GridPoint& point)
{
    if (!d->table)
        return;
    const std::array<std::pair<QCPAxis*, double>, 2> places{
        {{d->plot->xAxis, d->xOf(point)}, {d->plot->yAxis, d->yOf(point)}}};
    bool hasMoved = false;
    for (const auto& [axis, place] : places) {
        if (axis->range().contains(place))
            continue;
        axis->moveRange(place - axis->range().center());
        hasMoved = true;
    }
    if (hasMoved)
        replot();
}

void PlotCanvas::zoom(double factor)
{
    for (QCPAxis* axis : {d->plot->xAxis, d->plot->yAxis})
        axis->scaleRange(factor, axis->range().center());
    replot();
}

void PlotCanvas::pan(double x, double y)
{
    d->plot->xAxis->moveRange(x * d->plot->xAxis->range().size());
    d->plot->yAxis->moveRange(y * d->plot->yAxis->range().size());
    replot();
}

void PlotCanvas::replot()
{
    d->plot->replot(QCustomPlot::rpQueuedReplot);
}

void PlotCanvas::paintOverlay()
{
    if (d->isDrawn)
        d->plot->layer(QStringLiteral("overlay"))->replot();
    else
        replot();
}

} // namespace axiscomp::ui
