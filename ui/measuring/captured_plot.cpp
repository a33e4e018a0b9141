// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/measuring/captured_plot.h"

#include "ui/drawing/local_plot.h"
#include "ui/drawing/plot_style.h"
#include "ui/drawing/value_ticker.h"
#include "ui/style/contrast.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QEvent>

#include <algorithm>

namespace axiscomp::ui {

CapturedPlot::CapturedPlot(QWidget* parent)
    : QWidget(parent)
    , m_plot(new LocalPlot)
    , m_up(m_plot->addGraph())
    , m_down(m_plot->addGraph())
    , m_ticker(new ValueTicker)
{
    setObjectName(QStringLiteral("capturedPlot"));
    m_plot->setFocusPolicy(Qt::NoFocus);
    m_plot->yAxis->setTicker(m_ticker);
    m_plot->legend->setVisible(true);
    m_plot->axisRect()->insetLayout()->setInsetAlignment(0, Qt::AlignTop | Qt::AlignRight);
    for (QCPGraph* graph : {m_up, m_down})
        graph->setLineStyle(QCPGraph::lsNone);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_plot);
    constexpr int leastHeight = 120;
    setMinimumHeight(leastHeight);
    colour();
    retranslate();
}

void CapturedPlot::show(
    const MeasuringPlan& plan, const std::vector<CapturedValue>& values, const FineUnit& unit)
{
    m_isAngular = plan.isAngular;
    m_unit = unit;
    m_ticker->setFactor(unit.factor);
    for (const auto& [graph, direction] :
        {std::pair(m_up, Approach::Up), std::pair(m_down, Approach::Down)}) {
        QVector<double> positions;
        QVector<double> deviations;
        for (const CapturedValue& value : values)
            if (value.step.direction == direction) {
                positions += value.step.target;
                deviations += value.deviation;
            }
        graph->setData(positions, deviations);
    }
    nameAxes();
    fit(plan, values);
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void CapturedPlot::clear()
{
    m_up->data()->clear();
    m_down->data()->clear();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void CapturedPlot::fit(const MeasuringPlan& plan, const std::vector<CapturedValue>& values)
{
    constexpr double margin = 0.05;
    const auto [first, last] = std::ranges::minmax(plan.steps, {}, &MeasuringStep::target);
    const double width = std::max(last.target - first.target, 1e-3);
    m_plot->xAxis->setRange(first.target - margin * width, last.target + margin * width);
    if (values.empty())
        return m_plot->yAxis->setRange(-0.001, 0.001);
    const auto [lowest, highest] = std::ranges::minmax(values, {}, &CapturedValue::deviation);
    constexpr double least = 1e-6; // a nanometre
    const double height = std::max(highest.deviation - lowest.deviation, least);
    constexpr double roomForLegend = 0.2;
    m_plot->yAxis->setRange(
        lowest.deviation - margin * height, highest.deviation + roomForLegend * height);
}

void CapturedPlot::nameAxes()
{
    m_plot->xAxis->setLabel(withUnit(tr("Position"), m_isAngular ? "°" : "mm"));
    m_plot->yAxis->setLabel(deviationLabel(m_unit, {}, m_isAngular));
}

void CapturedPlot::retranslate()
{
    m_up->setName(tr("up"));
    m_down->setName(tr("down"));
    setAccessibleName(tr("Deviations that were taken"));
    setAccessibleDescription(tr("The same values are in the list of steps"));
    nameAxes();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void CapturedPlot::colour()
{
    const QColor base = palette().color(QPalette::Base);
    const QColor text = palette().color(QPalette::Text);
    const QColor muted = mutedTextColor(palette());
    m_plot->setBackground(base);
    for (QCPAxis* axis : {m_plot->xAxis, m_plot->yAxis}) {
        axis->setBasePen(QPen(muted));
        axis->setTickPen(QPen(muted));
        axis->setSubTickPen(QPen(muted));
        axis->setLabelColor(text);
        axis->setTickLabelColor(text);
        QColor faint = muted;
        constexpr int seeThrough = 70;
        faint.setAlpha(seeThrough);
        axis->grid()->setPen(QPen(faint, 1, Qt::DotLine));
        axis->grid()->setZeroLinePen(QPen(muted));
    }
    constexpr double size = 8.0;
    m_up->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssTriangle,
        QPen(frameColor(Tone::Information, palette()), 1.5), Qt::NoBrush, size));
    m_down->setScatterStyle(QCPScatterStyle(QCPScatterStyle::ssTriangleInverted,
        QPen(frameColor(Tone::Changed, palette()), 1.5), Qt::NoBrush, size));
    m_plot->legend->setBrush(base);
    m_plot->legend->setTextColor(text);
    m_plot->legend->setBorderPen(QPen(muted));
}

void CapturedPlot::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange) {
        colour();
        m_plot->replot(QCustomPlot::rpQueuedReplot);
    }
    QWidget::changeEvent(event);
}

} // namespace axiscomp::ui
