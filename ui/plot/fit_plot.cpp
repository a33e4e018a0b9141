// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/fit_plot.h"

#include "ui/drawing/local_plot.h"
#include "ui/drawing/plot_style.h"
#include "ui/drawing/value_ticker.h"
#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"
#include "ui/text/fine_scale.h"
#include "ui/text/translated_text.h"
#include "ui/text/value_text.h"

#include <QApplication>
#include <QBoxLayout>
#include <QKeyEvent>

#include <algorithm>
#include <cmath>

namespace axiscomp::ui {

namespace {

constexpr std::size_t mostBars = 300; ///< that can be told apart

FineUnit unitOf(const std::vector<double>& values, bool isAngular)
{
    double largest = 0.0;
    for (const double value : values)
        largest = std::max(largest, std::abs(value));
    const std::optional<double> shown[] = {largest};
    return fineUnit(shown, isAngular);
}

} // namespace

struct FitPlot::Private {
    std::shared_ptr<const FitOutcome> outcome;
    bool isOutdated = false;
    std::optional<std::size_t> chosen; ///< of the points that are drawn
    FineUnit unit;
    FineUnit residualUnit;

    QCustomPlot* plot = nullptr;
    QCPAxisRect* above = nullptr;
    QCPAxisRect* below = nullptr;
    QCPGraph* curve = nullptr;
    QCPGraph* means = nullptr;
    QCPErrorBars* bars = nullptr;
    QCPGraph* residuals = nullptr;
    QCPErrorBars* residualBars = nullptr;
    QCPGraph* heldOut = nullptr;
    QCPGraph* mark = nullptr; ///< the chosen point
    QSharedPointer<ValueTicker> ticker{new ValueTicker};
    QSharedPointer<ValueTicker> residualTicker{new ValueTicker};
    QLabel* readout = nullptr;
    QPointF pressed; ///< where the mouse button went down

    [[nodiscard]] bool isAngular() const { return outcome->request.measurement->isAngular; }
    [[nodiscard]] QCPAxis* x() const { return above->axis(QCPAxis::atBottom); }
    [[nodiscard]] QCPAxis* y() const { return above->axis(QCPAxis::atLeft); }
    [[nodiscard]] QCPAxis* xBelow() const { return below->axis(QCPAxis::atBottom); }
    [[nodiscard]] QCPAxis* yBelow() const { return below->axis(QCPAxis::atLeft); }
};

FitPlot::FitPlot(QWidget* parent) : QWidget(parent), d(std::make_unique<Private>())
{
    build();
    addGraphs();
    colour();
    retranslate();
}

FitPlot::~FitPlot() = default;

void FitPlot::build()
{
    d->plot = new LocalPlot(this);
    d->plot->setObjectName(QStringLiteral("fitPlot"));
    d->plot->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    d->plot->setNoAntialiasingOnDrag(true);
    d->plot->setFocusPolicy(Qt::StrongFocus);
    d->plot->setMouseTracking(true);
    d->plot->setMinimumSize(260, 110);
    d->plot->installEventFilter(this);
    d->above = d->plot->axisRect();
    d->below = new QCPAxisRect(d->plot);
    d->plot->plotLayout()->addElement(1, 0, d->below);
    d->plot->plotLayout()->setRowStretchFactor(0, 2.0);
    d->plot->plotLayout()->setRowStretchFactor(1, 1.0);
    auto* columns = new QCPMarginGroup(d->plot);
    for (QCPAxisRect* rect : {d->above, d->below}) {
        rect->setupFullAxesBox(true);
        rect->setMarginGroup(QCP::msLeft | QCP::msRight, columns);
    }
    d->y()->setTicker(d->ticker);
    d->yBelow()->setTicker(d->residualTicker);
    constexpr int fewTicks = 3;
    d->residualTicker->setTickCount(fewTicks);
    d->x()->setTickLabels(false);
    for (QCPAxis* axis : d->below->axes())
        axis->setLayer(QStringLiteral("axes"));
    const auto share = [](QCPAxis* from, QCPAxis* to) {
        connect(from, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), to,
            [to](const QCPRange& range) { to->setRange(range); });
    };
    share(d->x(), d->xBelow());
    share(d->xBelow(), d->x());
    d->plot->legend->setVisible(true);
    d->plot->legend->setFillOrder(QCPLegend::foColumnsFirst);
    d->plot->plotLayout()->setRowSpacing(2);
    d->plot->plotLayout()->insertRow(0);
    d->plot->plotLayout()->addElement(0, 0, d->plot->legend);
    d->plot->plotLayout()->setRowStretchFactor(0, 0.001);
    d->plot->plotLayout()->setRowStretchFactor(1, 2.0);
    d->plot->plotLayout()->setRowStretchFactor(2, 1.0);
    d->readout = new PlainLabel;
    d->readout->setObjectName(QStringLiteral("fitReadout"));
    d->readout->setTextInteractionFlags(Qt::TextSelectableByMouse);
    d->readout->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    layout->addWidget(d->plot, 1);
    layout->addWidget(d->readout);
}

void FitPlot::addGraphs()
{
    d->curve = d->plot->addGraph(d->x(), d->y());
    d->means = d->plot->addGraph(d->x(), d->y());
    d->residuals = d->plot->addGraph(d->xBelow(), d->yBelow());
    d->heldOut = d->plot->addGraph(d->xBelow(), d->yBelow());
    d->mark = d->plot->addGraph(d->x(), d->y());
    for (QCPGraph* graph : {d->means, d->residuals, d->heldOut, d->mark})
        graph->setLineStyle(QCPGraph::lsNone);
    d->residuals->removeFromLegend();
    d->mark->removeFromLegend();
    d->mark->setLayer(QStringLiteral("overlay"));
    const auto addBars = [](QCPGraph* graph) {
        auto* bars = new QCPErrorBars(graph->keyAxis(), graph->valueAxis());
        bars->setDataPlottable(graph);
        bars->setSymbolGap(7.0);
        bars->removeFromLegend();
        return bars;
    };
    d->bars = addBars(d->means);
    d->residualBars = addBars(d->residuals);
}

void FitPlot::show(std::shared_ptr<const FitOutcome> outcome)
{
    d->outcome = std::move(outcome);
    d->chosen.reset();
    fill();
    resetZoom();
    nameAxes();
    sayPoint();
    d->plot->replot(QCustomPlot::rpQueuedReplot);
}

void FitPlot::fill()
{
    for (QCPGraph* graph : {d->curve, d->means, d->residuals, d->heldOut, d->mark})
        graph->data()->clear();
    for (QCPErrorBars* bars : {d->bars, d->residualBars})
        bars->data()->clear();
    d->plot->legend->setVisible(d->outcome != nullptr);
    if (!d->outcome)
        return;
    const FitDrawing& drawing = d->outcome->drawing;
    std::vector<double> shown;
    QVector<double> x;
    QVector<double> y;
    for (const auto& [position, value] : drawing.curve) {
        x += position;
        y += value;
        shown.push_back(value);
    }
    d->curve->setData(x, y, true);
    const bool isSparse = drawing.curve.size() <= 200;
    d->curve->setScatterStyle(QCPScatterStyle(
        isSparse ? QCPScatterStyle::ssDot : QCPScatterStyle::ssNone, isSparse ? 4.0 : 0.0));
    x.clear();
    y.clear();
    QVector<double> errors;
    for (const FittedPoint& point : drawing.points) {
        x += point.position;
        y += point.value;
        errors += point.standardError.value_or(0.0);
        shown.push_back(point.value);
    }
    d->means->setData(x, y, true);
    d->unit = unitOf(shown, d->isAngular());
    d->ticker->setFactor(d->unit.factor);
    const bool hasBars = drawing.points.size() <= mostBars
        && std::ranges::any_of(drawing.points,
            [](const FittedPoint& point) { return point.standardError.has_value(); });
    if (hasBars) {
        d->bars->setData(errors);
        d->residualBars->setData(errors);
    }
    fillResiduals();
}

void FitPlot::fillResiduals()
{
    const FitDrawing& drawing = d->outcome->drawing;
    std::vector<double> shown;
    QVector<double> x;
    QVector<double> y;
    for (const FittedPoint& point : drawing.points) {
        x += point.position;
        y += point.residual;
        shown.push_back(point.residual);
    }
    d->residuals->setData(x, y, true);
    x.clear();
    y.clear();
    for (const HeldOut::Residual& residual : drawing.heldOut) {
        x += residual.target;
        y += residual.value;
        shown.push_back(residual.value);
    }
    d->heldOut->setData(x, y);
    if (drawing.heldOut.empty())
        d->heldOut->removeFromLegend();
    else
        d->heldOut->addToLegend();
    d->residualUnit = unitOf(shown, d->isAngular());
    d->residualTicker->setFactor(d->residualUnit.factor);
}

void FitPlot::resetZoom()
{
    if (!d->outcome)
        return;
    const auto widen = [](QCPAxis* axis, double smallest, double margin) {
        if (!(axis->range().size() > smallest))
            axis->setRange(axis->range().center() - smallest, axis->range().center() + smallest);
        axis->scaleRange(margin, axis->range().center());
    };
    d->curve->rescaleAxes();
    d->means->rescaleAxes(true);
    d->bars->rescaleValueAxis(true);
    d->residuals->rescaleValueAxis();
    d->residualBars->rescaleValueAxis(true);
    d->heldOut->rescaleValueAxis(true);
    constexpr double nothing = 1e-8; // far below what an instrument resolves, in mm or deg
    widen(d->x(), nothing, 1.04);
    widen(d->y(), nothing, 1.12);
    widen(d->yBelow(), nothing, 1.3); // it is low, and its marks are as large
}

void FitPlot::setOutdated(bool isOutdated)
{
    if (isOutdated == d->isOutdated)
        return;
    d->isOutdated = isOutdated;
    colour();
    d->plot->replot(QCustomPlot::rpQueuedReplot);
}

void FitPlot::colour()
{
    const bool isDark = palette().color(QPalette::Base).lightness() < 128;
    const QColor base = palette().color(QPalette::Base);
    const QColor muted = mutedTextColor(palette());
    const QColor text = d->isOutdated ? muted : palette().color(QPalette::Text);
    const QColor curve = d->isOutdated ? muted
        : isDark                       ? QColor(110, 185, 255)
                                       : QColor(5, 80, 160);
    const QColor other = d->isOutdated ? muted : isDark ? QColor(255, 190, 90) : QColor(150, 70, 0);
    d->plot->setBackground(base);
    for (QCPAxisRect* rect : {d->above, d->below})
        for (QCPAxis* axis : rect->axes())
            stylePlotAxis(*axis, text, muted);
    d->curve->setPen(QPen(curve, d->isOutdated ? 1.0 : 1.5));
    const QCPScatterStyle disc(QCPScatterStyle::ssCircle, QPen(text, 1.2), QBrush(base), 7.0);
    d->means->setScatterStyle(disc);
    d->residuals->setScatterStyle(disc);
    d->heldOut->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssTriangle, QPen(other, 1.5), Qt::NoBrush, 9.0));
    d->mark->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssSquare, QPen(other, 2.0), Qt::NoBrush, 13.0));
    for (QCPErrorBars* bars : {d->bars, d->residualBars})
        bars->setPen(QPen(text, 1.0));
    d->plot->legend->setBrush(base);
    d->plot->legend->setBorderPen(Qt::NoPen);
    d->plot->legend->setTextColor(text);
}

void FitPlot::nameAxes()
{
    if (!d->outcome)
        return;
    const GridAxis& axis = d->outcome->tables.front().table->grid.axes.front();
    d->xBelow()->setLabel(withUnit(qString(axis.name), axis.unit));
    d->y()->setLabel(tr("compensation [%1]").arg(FineScale(d->unit).symbol()));
    d->yBelow()->setLabel(tr("remains [%1]").arg(FineScale(d->residualUnit).symbol()));
}

void FitPlot::retranslate()
{
    d->curve->setName(tr("table"));
    d->means->setName(tr("measured, with its standard error"));
    d->heldOut->setName(tr("foretold without the target"));
    d->plot->setAccessibleName(tr("Picture of the fit"));
    d->plot->setAccessibleDescription(
        tr("The table over what was measured, and what remains. Left and right go from point to "
           "point; the wheel and + and - zoom, Home shows all."));
    nameAxes();
    sayPoint();
    d->plot->replot(QCustomPlot::rpQueuedReplot);
}

void FitPlot::choose(std::optional<std::size_t> point)
{
    d->chosen = point;
    d->mark->data()->clear();
    if (point) {
        const FittedPoint& chosen = d->outcome->drawing.points[*point];
        d->mark->addData(chosen.position, chosen.value);
        if (!d->x()->range().contains(chosen.position))
            d->x()->moveRange(chosen.position - d->x()->range().center());
    }
    sayPoint();
    d->plot->replot(QCustomPlot::rpQueuedReplot);
}

void FitPlot::sayPoint()
{
    if (!d->outcome || !d->chosen)
        return d->readout->setText({});
    const FittedPoint& point = d->outcome->drawing.points[*d->chosen];
    const auto fine = [this](double value) { return fineText(value, d->isAngular()); };
    const QString place = translated(placeOf(point.position, d->isAngular()));
    const QString said = point.standardError
        ? tr("%1: measured %2 ± %3, %4 remains")
              .arg(place, fine(point.value), fine(*point.standardError), fine(point.residual))
        : tr("%1: measured %2, %3 remains").arg(place, fine(point.value), fine(point.residual));
    d->readout->setText(said);
    d->readout->setAccessibleName(said);
}

bool FitPlot::handleKey(int key)
{
    const std::size_t count = d->outcome ? d->outcome->drawing.points.size() : 0;
    if (count == 0)
        return false;
    switch (key) {
    case Qt::Key_Left:
        choose(d->chosen ? (*d->chosen > 0 ? *d->chosen - 1 : 0) : count - 1);
        return true;
    case Qt::Key_Right:
        choose(d->chosen ? std::min(*d->chosen + 1, count - 1) : 0);
        return true;
    case Qt::Key_Escape:
        if (!d->chosen)
            return false;
        choose(std::nullopt);
        return true;
    case Qt::Key_Home:
        resetZoom();
        break;
    case Qt::Key_Plus:
        d->x()->scaleRange(0.8, d->x()->range().center());
        break;
    case Qt::Key_Minus:
        d->x()->scaleRange(1.25, d->x()->range().center());
        break;
    default:
        return false;
    }
    d->plot->replot(QCustomPlot::rpQueuedReplot);
    return true;
}

bool FitPlot::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::KeyPress && handleKey(static_cast<QKeyEvent*>(event)->key()))
        return true;
    if (event->type() == QEvent::MouseButtonDblClick) {
        resetZoom();
        d->plot->replot(QCustomPlot::rpQueuedReplot);
        return true;
    }
    if (event->type() == QEvent::MouseButtonPress)
        d->pressed = static_cast<QMouseEvent*>(event)->position();
    if (event->type() == QEvent::MouseButtonRelease && d->outcome
        && !d->outcome->drawing.points.empty()
        && (static_cast<QMouseEvent*>(event)->position() - d->pressed).manhattanLength()
            < QApplication::startDragDistance()) {
        const double x = d->x()->pixelToCoord(static_cast<QMouseEvent*>(event)->position().x());
        const auto& points = d->outcome->drawing.points;
        const auto nearest = std::ranges::min_element(
            points, {}, [x](const FittedPoint& point) { return std::abs(point.position - x); });
        choose(static_cast<std::size_t>(nearest - points.begin()));
    }
    return QWidget::eventFilter(watched, event);
}

void FitPlot::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange) {
        colour();
        d->plot->replot(QCustomPlot::rpQueuedReplot);
    }
}

} // namespace axiscomp::ui
