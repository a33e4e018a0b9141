// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drawing/plot_canvas.h"

#include "core/table/table_math.h"
#include "ui/style/contrast.h"

#include "ui/drawing/cross_sections.h"
#include "ui/drawing/filled_hatch.h"
#include "ui/drawing/local_plot.h"
#include "ui/drawing/map_contours.h"
#include "ui/drawing/map_points.h"
#include "ui/drawing/plot_style.h"
#include "ui/drawing/table_map.h"
#include "ui/drawing/travel_mark.h"
#include "ui/drawing/value_ticker.h"

#include <algorithm>

namespace axiscomp::ui {

namespace {

bool isDark(const QPalette& palette)
{
    return palette.color(QPalette::Base).lightness() < 128;
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
    explicit Private(QWidget* parent) : plot(new LocalPlot(parent)) { }

    QCustomPlot* plot;
    QCPGraph* curve = nullptr;
    QCPGraph* secondCurve = nullptr;
    QCPGraph* filled = nullptr; ///< points that were made up, not measured
    QCPGraph* measured = nullptr; ///< places of a map
    FilledHatch* hatch = nullptr;
    bool isHatched = false;
    QCPGraph* proved = nullptr;
    QCPGraph* marker = nullptr;
    TableMap* map = nullptr;
    MapPoints* points = nullptr;
    MapContours* contours = nullptr;
    CrossSections* sections = nullptr;
    bool hasPoints = false;
    bool hasContours = false;
    bool hasSections = false;
    std::optional<GridPoint> sectionPoint;
    QCPColorScale* scale = nullptr;
    QSharedPointer<ValueTicker> ticker{new ValueTicker}; ///< of all axes of values
    QSharedPointer<QCPAxisTicker> positions; ///< of the vertical axis of a map
    std::unique_ptr<TravelMark> travel;
    QCPItemText* note = nullptr; ///< beside the marker
    std::array<QCPRange, 2> whole; ///< what the whole view showed of both axes
    std::unique_ptr<Cross> crosshair;
    std::unique_ptr<Cross> sectionCross; ///< where nothing else says where the sections are
    std::array<std::unique_ptr<Cross>, 2> cursors;
    std::array<QCPItemText*, 2> cursorLabels{};

    std::shared_ptr<const CompensationTable> table;
    std::shared_ptr<const CompensationTable> second;
    double range = 1.0;
    QString xLabel;
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
    d->measured = plot.addGraph();
    d->measured->setObjectName(QStringLiteral("measuredPlaces"));
    d->measured->setLayer(QStringLiteral("axes"));
    d->measured->setLineStyle(QCPGraph::lsNone);
    d->measured->removeFromLegend();
    d->proved = plot.addGraph();
    d->proved->setObjectName(QStringLiteral("provedPart"));
    d->proved->setLayer(QStringLiteral("overlay"));
    d->proved->removeFromLegend();
    d->marker = plot.addGraph();
    d->marker->setLayer(QStringLiteral("overlay"));
    d->marker->removeFromLegend();
    d->marker->setLineStyle(QCPGraph::lsNone);
    d->map = new TableMap(plot);
    d->map->removeFromLegend();
    d->hatch = new FilledHatch(plot);
    d->points = new MapPoints(plot);
    d->contours = new MapContours(plot); // its labels are above the points
    d->travel = std::make_unique<TravelMark>(plot);
    d->scale = new QCPColorScale(&plot);
    d->scale->setBarWidth(12);
    d->scale->setRangeDrag(false);
    d->scale->setRangeZoom(false);
    d->map->setColorScale(d->scale);
    d->positions = plot.yAxis->ticker();
    d->scale->axis()->setTicker(d->ticker);
    d->sections = new CrossSections(plot);
    d->crosshair = std::make_unique<Cross>(plot);
    d->sectionCross = std::make_unique<Cross>(plot);
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
    d->note = new QCPItemText(&plot);
    d->note->setLayer(QStringLiteral("overlay"));
    d->note->setPadding(QMargins(4, 1, 4, 1));
    d->note->setPositionAlignment(Qt::AlignLeft | Qt::AlignTop);
    d->note->setVisible(false);
    for (QCPAxis* axis : {plot.xAxis, plot.yAxis})
        connect(
            axis, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), this, &PlotCanvas::placeNote);
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
    d->sectionPoint.reset();
    d->curve->data()->clear();
    d->secondCurve->data()->clear();
    d->map->setVisible(d->isMap());
    if (d->isMap())
        d->plot->yAxis->setTicker(d->positions);
    else
        d->plot->yAxis->setTicker(d->ticker);
    layOut();
    d->plot->legend->setVisible(d->table && !d->isMap() && d->second);
    if (d->isMap())
        showMap();
    else if (d->table)
        showCurve();
    showFilled();
    d->travel->setTable(d->table);
    setGridPointsShown(d->hasPoints);
    setContoursShown(d->hasContours);
    d->sections->setTable(d->isMap() ? d->table : nullptr);
    showSections();
    if (!isSameGrid)
        return resetZoom();
    if (!d->isMap())
        fitValues();
    replot();
}

/// The map's curves beside and below it, its scale at the right of all.
void PlotCanvas::layOut()
{
    const bool hasSections = d->hasSections && d->isMap();
    QCPLayoutGrid* layout = d->plot->plotLayout();
    for (QCPLayoutElement* element : std::initializer_list<QCPLayoutElement*>{
             d->scale, d->sections->beside(), d->sections->below()})
        if (element->layout() == layout)
            layout->take(element);
    layout->simplify();
    if (hasSections) {
        layout->addElement(0, 1, d->sections->beside());
        layout->addElement(1, 0, d->sections->below());
    }
    if (d->isMap())
        layout->addElement(0, hasSections ? 2 : 1, d->scale);
    d->scale->setVisible(d->isMap());
    d->sections->setVisible(hasSections);
    // The curve below has them. Without a table there is nothing that they are the scale of.
    d->plot->xAxis->setTickLabels(d->table && !hasSections);
    d->plot->yAxis->setTickLabels(d->table != nullptr);
    d->plot->xAxis->setLabel(hasSections ? QString() : d->xLabel);
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
    d->map->setTable(d->table);
    d->map->setDataRange(QCPRange(-d->range, d->range));
}

void PlotCanvas::setGridPointsShown(bool isShown)
{
    d->hasPoints = isShown;
    d->points->setTable(isShown && d->isMap() ? d->table : nullptr);
    replot();
}

void PlotCanvas::setContoursShown(bool isShown)
{
    d->hasContours = isShown;
    d->contours->setTable(isShown && d->isMap() ? d->table : nullptr);
    replot();
}

void PlotCanvas::setSectionsShown(bool isShown)
{
    d->hasSections = isShown;
    layOut();
    showSections();
    replot();
}

void PlotCanvas::setSectionPoint(const std::optional<GridPoint>& point)
{
    d->sectionPoint = point;
    showSections();
}

void PlotCanvas::showSections()
{
    d->sectionCross->hide();
    if (!d->hasSections || !d->isMap())
        return;
    const auto& axes = d->table->grid.axes;
    std::array<double, 2> place{
        (axes[0].start + axes[0].last()) / 2.0, (axes[1].start + axes[1].last()) / 2.0};
    if (d->sectionPoint)
        place = {d->xOf(*d->sectionPoint), d->yOf(*d->sectionPoint)};
    else if (!d->marker->data()->isEmpty())
        place = {d->marker->dataMainKey(0), d->marker->dataMainValue(0)};
    if (!d->sectionPoint)
        d->sectionCross->show(place[0], place[1]);
    d->sections->setPlace(place);
}

/// Crosses, as far as they can be told apart.
void PlotCanvas::showFilled()
{
    constexpr std::size_t most = 4000;
    d->filled->data()->clear();
    const bool isHatched = d->isHatched && d->isMap();
    d->hatch->setTable(isHatched ? d->table : nullptr);
    if (!d->table || d->table->filled.size() > most || isHatched)
        return;
    const std::size_t width = d->table->grid.axes[0].size;
    for (const std::size_t point : d->table->filled) {
        const GridPoint place{point % width, point / width};
        d->filled->addData(d->xOf(place), d->yOf(place));
    }
}

void PlotCanvas::setFilledHatched(bool isHatched)
{
    d->isHatched = isHatched;
    showFilled();
    replot();
}

void PlotCanvas::setMeasured(const QVector<double>& x, const QVector<double>& y)
{
    d->measured->setData(x, y);
    replot();
}

void PlotCanvas::setLabels(const QString& x, const QString& y, const QString& value)
{
    d->xLabel = x;
    d->plot->xAxis->setLabel(d->hasSections && d->isMap() ? QString() : x);
    d->plot->yAxis->setLabel(d->isMap() ? y : value);
    d->sections->setLabels(x);
    d->scale->axis()->setLabel(value);
}

void PlotCanvas::setValueScale(const ValueScale& scale)
{
    d->ticker->setFactor(scale.factor());
    d->sections->setValueFactor(scale.factor());
    d->contours->setValueScale(scale);
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
        stylePlotAxis(*axis, text, grid);
    for (QCPAxis* axis : d->sections->axes())
        stylePlotAxis(*axis, text, grid);
    d->map->setGradient(divergingGradient(dark));
    d->contours->setColors(text, base);
    const QColor curve = dark ? QColor(110, 185, 255) : QColor(5, 80, 160);
    const auto recolor = [](QCPGraph& graph, const QColor& color) {
        QPen pen = graph.pen();
        pen.setColor(color);
        graph.setPen(pen);
    };
    recolor(*d->curve, curve);
    d->sections->setPen(QPen(curve, 1.5));
    d->sectionCross->setPen(QPen(grid, 1, Qt::DashLine));
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
    QColor tint = dark ? QColor(120, 160, 200) : QColor(60, 110, 160);
    constexpr int faint = 36;
    tint.setAlpha(faint);
    d->travel->setColors(tint, grid, text, base);
    d->note->setColor(text);
    d->note->setBrush(base);
    d->note->setPen(QPen(grid));
    d->marker->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssDiamond, QPen(text, 1.5), QBrush(marker), 11));
    d->filled->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssCross, QPen(text, 1.0), Qt::NoBrush, 7));
    d->hatch->setColor(text);
    d->measured->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssCircle, QPen(text, 1.0), QBrush(base), 4.0));
    d->points->setColors(text, base);
    d->crosshair->setPen(QPen(text, 1, Qt::DotLine));
    const std::array<QColor, 2> cursorColors{text, marker};
    for (std::size_t which = 0; which < d->cursors.size(); ++which) {
        d->cursors[which]->setPen(QPen(cursorColors[which], 1.5));
        d->cursorLabels[which]->setColor(base);
        d->cursorLabels[which]->setBrush(cursorColors[which]);
    }
}

void PlotCanvas::setMarker(
    const std::optional<std::array<double, 2>>& position, double value, const QString& note)
{
    d->marker->data()->clear();
    if (position)
        d->marker->addData((*position)[0], d->isMap() ? (*position)[1] : value);
    d->note->setVisible(position && !note.isEmpty());
    d->note->setText(note);
    placeNote();
    showSections();
    paintOverlay();
}

/// Above or below the marker, towards the middle; at the border while it is out of sight.
void PlotCanvas::placeNote()
{
    if (d->marker->data()->isEmpty())
        return;
    const QCPRange& x = d->plot->xAxis->range();
    const QCPRange& y = d->plot->yAxis->range();
    const double atX = std::clamp(d->marker->dataMainKey(0), x.lower, x.upper);
    const double atY = std::clamp(d->marker->dataMainValue(0), y.lower, y.upper);
    const QFontMetricsF metrics(d->note->font());
    const QMargins padding = d->note->padding();
    QRectF place(0.0, 0.0,
        metrics.horizontalAdvance(d->note->text()) + padding.left() + padding.right() + 2.0,
        metrics.height() + padding.top() + padding.bottom());
    constexpr double away = 9.0;
    place.moveCenter(QPointF(d->plot->xAxis->coordToPixel(atX),
        d->plot->yAxis->coordToPixel(atY)
            + (atY < y.center() ? -1.0 : 1.0) * (away + place.height() / 2.0)));
    const QRectF sight = QRectF(d->plot->axisRect()->rect()).adjusted(2.0, 2.0, -2.0, -2.0);
    const double left = std::clamp(
        place.left(), sight.left(), std::max(sight.left(), sight.right() - place.width()));
    const double top = std::clamp(
        place.top(), sight.top(), std::max(sight.top(), sight.bottom() - place.height()));
    d->note->position->setPixelPosition({left, top});
}

void PlotCanvas::setTravel(const std::array<std::optional<Travel>, 2>& travel, bool holdsEnds)
{
    const bool hasMoved = travel != d->travel->travel();
    const bool isWhole = d->plot->xAxis->range() == d->whole[0]
        && (!d->isMap() || d->plot->yAxis->range() == d->whole[1]);
    d->travel->setTravel(travel, holdsEnds);
    if (hasMoved && isWhole)
        resetZoom();
    else
        replot();
}

void PlotCanvas::setTravelTexts(const QString& travel, const QString& table, const QString& held)
{
    d->travel->setTexts(travel, table, held);
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
    if (!d->table)
        return replot();
    // A little more than the table: the points at its ends are seen whole.
    constexpr double margin = 1.04;
    const auto show = [this](QCPAxis* axis, std::size_t drawnAxis) {
        axis->setRange(d->travel->wholeRange(drawnAxis));
        axis->scaleRange(margin, axis->range().center());
        d->whole.at(drawnAxis) = axis->range();
    };
    show(d->plot->xAxis, 0);
    if (d->isMap())
        show(d->plot->yAxis, 1);
    else
        fitValues();
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
