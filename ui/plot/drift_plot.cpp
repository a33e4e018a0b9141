// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/drift_plot.h"

#include "ui/async/background_job.h"
#include "ui/drawing/plot_style.h"
#include "ui/drawing/value_ticker.h"
#include "ui/style/accessible_role.h"
#include "ui/style/plain_label.h"
#include "ui/text/fine_scale.h"
#include "ui/text/translated_text.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>

#include "ui/drawing/local_plot.h"

#include <algorithm>
#include <cmath>

namespace axiscomp::ui {

namespace {

constexpr int mostRunMarkers = 200;

void fill(QCPGraph& graph, const DirectionDrift& drift)
{
    QVector<double> keys;
    QVector<double> values;
    for (std::size_t i = 0; i < drift.runs.size(); ++i) {
        keys.append(drift.runs[i]);
        values.append(drift.offset[i]);
    }
    graph.setData(keys, values, true);
}

} // namespace

DriftPlot::DriftPlot(QWidget* parent)
    : QWidget(parent)
    , m_plot(new LocalPlot(this))
    , m_readout(new PlainLabel)
{
    setObjectName(QStringLiteral("driftPlot"));
    build();
    colour();
    retranslate();
}

void DriftPlot::build()
{
    setAccessibleRole(*m_plot, QAccessible::Chart);
    m_plot->setObjectName(QStringLiteral("driftPicture"));
    m_plot->setMinimumSize(260, 80);
    m_plot->setFocusPolicy(Qt::StrongFocus);
    m_plot->installEventFilter(this);
    m_plot->axisRect()->setupFullAxesBox(true);
    m_plot->axisRect()->setMinimumMargins(QMargins(0, 6, 12, 0));
    // Runs are counted: there is none between two of them.
    QSharedPointer<QCPAxisTickerFixed> runs(new QCPAxisTickerFixed);
    runs->setTickStep(1.0);
    runs->setScaleStrategy(QCPAxisTickerFixed::ssMultiples);
    m_plot->xAxis->setTicker(runs);
    m_plot->xAxis->setSubTicks(false);
    m_plot->yAxis->setTicker(QSharedPointer<QCPAxisTicker>(new ValueTicker));
    m_up = m_plot->addGraph();
    m_down = m_plot->addGraph();
    m_mark = m_plot->addGraph();
    m_mark->removeFromLegend();
    m_mark->setLineStyle(QCPGraph::lsNone);
    m_plot->axisRect()->insetLayout()->take(m_plot->legend);
    m_plot->plotLayout()->addElement(1, 0, m_plot->legend);
    m_plot->plotLayout()->setRowStretchFactor(1, 0.001);
    m_plot->legend->setFillOrder(QCPLegend::foColumnsFirst);
    m_plot->legend->setMargins(QMargins(4, 0, 4, 0));
    m_plot->legend->setVisible(false);
    letLegendBeWide(*m_plot->legend);
    m_plot->axisRect()->setVisible(false);
    m_readout->setObjectName(QStringLiteral("driftReadout"));
    m_readout->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_readout->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(m_plot, 1);
    layout->addWidget(m_readout);
}

void DriftPlot::colour()
{
    const MeasurementInks inks(palette());
    stylePlot(*m_plot, inks);
    using Shape = QCPScatterStyle;
    const bool hasMarkers = m_up->dataCount() + m_down->dataCount() <= mostRunMarkers;
    m_up->setPen(QPen(inks.up, 1.0));
    m_down->setPen(QPen(inks.down, 1.0, Qt::DashLine));
    m_up->setScatterStyle(
        hasMarkers ? Shape(Shape::ssTriangle, QPen(inks.up), inks.up, 8) : Shape());
    m_down->setScatterStyle(hasMarkers
            ? Shape(Shape::ssTriangleInverted, QPen(inks.down, 1.2), inks.base, 8)
            : Shape());
    m_mark->setScatterStyle(Shape(Shape::ssCircle, QPen(inks.selected, 3.0), Qt::NoBrush, 16));
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void DriftPlot::setJudgement(std::shared_ptr<const Judgement> judgement, bool isAngular)
{
    if (judgement == m_judgement)
        return;
    letGo(std::exchange(m_judgement, std::move(judgement)));
    m_isAngular = isAngular;
    fill(*m_up, driftOf(Approach::Up));
    fill(*m_down, driftOf(Approach::Down));
    std::vector<std::optional<double>> shown;
    int lastRun = 1;
    double largest = 0.0;
    for (const Approach direction : {Approach::Up, Approach::Down}) {
        const DirectionDrift& drift = driftOf(direction);
        shown.insert(shown.end(), drift.offset.begin(), drift.offset.end());
        for (const double offset : drift.offset)
            largest = std::max(largest, std::abs(offset));
        if (!drift.runs.empty())
            lastRun = std::max(lastRun, drift.runs.back());
    }
    m_unit = fineUnit(shown, isAngular);
    qSharedPointerCast<ValueTicker>(m_plot->yAxis->ticker())->setFactor(m_unit.factor);
    const double room = largest > 0.0 ? 1.15 * largest : 0.5 / m_unit.factor;
    m_plot->axisRect()->setVisible(m_judgement != nullptr);
    m_plot->legend->setVisible(m_judgement != nullptr);
    m_plot->xAxis->setRange(0.5, lastRun + 0.5);
    m_plot->yAxis->setRange(-room, room);
    colour();
    retranslate();
}

const DirectionDrift& DriftPlot::driftOf(Approach direction) const
{
    static const DirectionDrift none;
    if (!m_judgement)
        return none;
    return direction == Approach::Up ? m_judgement->driftUp : m_judgement->driftDown;
}

std::optional<double> DriftPlot::offsetOf(const Exclusion& run) const
{
    if (!run.direction || !run.run)
        return std::nullopt;
    const DirectionDrift& drift = driftOf(*run.direction);
    const auto found = std::ranges::lower_bound(drift.runs, *run.run);
    if (found == drift.runs.end() || *found != *run.run)
        return std::nullopt;
    return drift.offset[static_cast<std::size_t>(found - drift.runs.begin())];
}

void DriftPlot::select(const std::optional<Exclusion>& run)
{
    m_selected = run && offsetOf(*run) ? std::optional(Exclusion{run->direction, {}, run->run})
                                       : std::nullopt;
    showSelected();
}

void DriftPlot::choose(const std::optional<Exclusion>& run)
{
    if (run == m_selected)
        return;
    select(run);
    Q_EMIT selectionChanged(m_selected);
}

/// "up, run 3: offset -2.10 µm"
void DriftPlot::showSelected()
{
    QString text;
    m_mark->data()->clear();
    if (const auto offset = m_selected ? offsetOf(*m_selected) : std::nullopt) {
        m_mark->addData(*m_selected->run, *offset);
        text = tr("%1, run %2: offset %3")
                   .arg(translated(approachText(*m_selected->direction)))
                   .arg(*m_selected->run)
                   .arg(FineScale(m_unit).textWithUnit(*offset));
    }
    m_readout->setText(text);
    const QString description = text.isEmpty() ? m_plot->toolTip() : text;
    if (m_plot->accessibleDescription() != description)
        m_plot->setAccessibleDescription(description);
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void DriftPlot::retranslate()
{
    m_plot->xAxis->setLabel(tr("Run"));
    m_plot->yAxis->setLabel(withUnit(tr("Offset of the run"), m_unit.symbol));
    m_up->setName(tr("runs ↑"));
    m_down->setName(tr("runs ↓"));
    m_plot->setAccessibleName(tr("Drift: offsets of the runs"));
    m_plot->setToolTip(tr("How far each run lies beside the mean of its direction. A click or the "
                          "arrow keys select a run."));
    select(m_selected);
}

bool DriftPlot::handleKey(int key)
{
    if (key == Qt::Key_Escape && m_selected) {
        choose(std::nullopt);
        return true;
    }
    const bool isVertical = key == Qt::Key_Up || key == Qt::Key_Down;
    if (!isVertical && key != Qt::Key_Left && key != Qt::Key_Right)
        return false;
    Approach direction = m_selected ? *m_selected->direction : Approach::Up;
    if (m_selected && isVertical)
        direction = direction == Approach::Up ? Approach::Down : Approach::Up;
    if (driftOf(direction).runs.empty())
        direction = direction == Approach::Up ? Approach::Down : Approach::Up;
    const auto& runs = driftOf(direction).runs;
    if (runs.empty())
        return true;
    const auto last = static_cast<std::ptrdiff_t>(runs.size()) - 1;
    std::ptrdiff_t at = 0;
    if (m_selected) {
        at = std::ranges::lower_bound(runs, *m_selected->run) - runs.begin();
        at += isVertical ? 0 : key == Qt::Key_Right ? 1 : -1;
    }
    at = std::clamp<std::ptrdiff_t>(at, 0, last);
    choose(Exclusion{direction, {}, runs[static_cast<std::size_t>(at)]});
    return true;
}

std::optional<Exclusion> DriftPlot::runAt(const QPointF& pixel) const
{
    constexpr double reach = 14.0;
    double best = reach;
    std::optional<Exclusion> nearest;
    for (const Approach direction : {Approach::Up, Approach::Down}) {
        const DirectionDrift& drift = driftOf(direction);
        for (std::size_t i = 0; i < drift.runs.size(); ++i) {
            const double away = std::hypot(m_plot->xAxis->coordToPixel(drift.runs[i]) - pixel.x(),
                m_plot->yAxis->coordToPixel(drift.offset[i]) - pixel.y());
            if (away > best)
                continue;
            best = away;
            nearest = {direction, {}, drift.runs[i]};
        }
    }
    return nearest;
}

bool DriftPlot::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::KeyPress) {
        const auto& key = static_cast<const QKeyEvent&>(*event);
        if (!(key.modifiers() & (Qt::ControlModifier | Qt::AltModifier)) && handleKey(key.key()))
            return true;
    }
    if (event->type() == QEvent::MouseButtonRelease)
        choose(runAt(static_cast<const QMouseEvent&>(*event).position()));
    return QWidget::eventFilter(watched, event);
}

void DriftPlot::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        colour();
}

} // namespace axiscomp::ui
