// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drawing/cross_sections.h"

#include "core/table/lookup.h"

#include <algorithm>

namespace axiscomp::ui {

CrossSections::CrossSections(QCustomPlot& plot)
    : QObject(&plot)
    , m_plot(plot)
    , m_beside(new QCPAxisRect(&plot))
    , m_below(new QCPAxisRect(&plot))
{
    constexpr int width = 90;
    constexpr int height = 75;
    m_beside->setupFullAxesBox(true);
    m_beside->setMinimumSize(width, 0);
    m_beside->setMaximumSize(width, QWIDGETSIZE_MAX);
    m_below->setupFullAxesBox(true);
    m_below->setMinimumSize(0, height);
    m_below->setMaximumSize(QWIDGETSIZE_MAX, height);
    m_beside->axis(QCPAxis::atLeft)->setTickLabels(false);
    const std::array<std::pair<QCPAxis*, int>, 2> values{
        {{m_beside->axis(QCPAxis::atBottom), 2}, {m_below->axis(QCPAxis::atLeft), 3}}};
    for (std::size_t n = 0; n < values.size(); ++n) {
        m_tickers[n].reset(new ValueTicker);
        m_tickers[n]->setTickCount(values[n].second);
        values[n].first->setTicker(m_tickers[n]);
    }
    // Only what they share with the map can be dragged and zoomed.
    QCPAxis* x = m_below->axis(QCPAxis::atBottom);
    QCPAxis* y = m_beside->axis(QCPAxis::atLeft);
    m_below->setRangeDragAxes(x, nullptr);
    m_below->setRangeZoomAxes(x, nullptr);
    m_beside->setRangeDragAxes(nullptr, y);
    m_beside->setRangeZoomAxes(nullptr, y);
    share(x, plot.xAxis);
    share(y, plot.yAxis);
    m_alongX = plot.addGraph(x, m_below->axis(QCPAxis::atLeft));
    m_alongY = new QCPCurve(m_beside->axis(QCPAxis::atBottom), y);
    for (QCPAbstractPlottable* curve : {static_cast<QCPAbstractPlottable*>(m_alongX),
             static_cast<QCPAbstractPlottable*>(m_alongY)}) {
        curve->setLayer(QStringLiteral("overlay")); // they move with the cross-hair
        curve->removeFromLegend();
    }
    auto* columns = new QCPMarginGroup(&plot);
    auto* rows = new QCPMarginGroup(&plot);
    for (QCPAxisRect* rect : {plot.axisRect(), m_below})
        rect->setMarginGroup(QCP::msLeft | QCP::msRight, columns);
    for (QCPAxisRect* rect : {plot.axisRect(), m_beside})
        rect->setMarginGroup(QCP::msTop | QCP::msBottom, rows);
    setVisible(false);
}

void CrossSections::share(QCPAxis* own, QCPAxis* ofMap)
{
    const auto follow = [](QCPAxis* from, QCPAxis* to) {
        connect(from, qOverload<const QCPRange&>(&QCPAxis::rangeChanged), to,
            [to](const QCPRange& range) { to->setRange(range); });
    };
    follow(own, ofMap);
    follow(ofMap, own);
}

void CrossSections::setVisible(bool isVisible)
{
    m_beside->setVisible(isVisible);
    m_below->setVisible(isVisible);
}

void CrossSections::setTable(std::shared_ptr<const CompensationTable> table)
{
    m_table = std::move(table);
    m_alongX->data()->clear();
    m_alongY->data()->clear();
    if (!m_table)
        return;
    // The same for every place: what moves is the curve.
    const auto [low, high] = std::ranges::minmax(m_table->values);
    QCPRange range(static_cast<double>(low), static_cast<double>(high));
    if (!(range.size() > 0.0))
        range = QCPRange(range.lower - 1e-9, range.upper + 1e-9);
    for (QCPAxis* axis : {m_beside->axis(QCPAxis::atBottom), m_below->axis(QCPAxis::atLeft)}) {
        axis->setRange(range);
        axis->scaleRange(1.15, range.center());
    }
}

void CrossSections::setPlace(const std::array<double, 2>& place)
{
    if (!m_table)
        return;
    const Lookup lookup(*m_table);
    const auto& axes = m_table->grid.axes;
    // Straight from grid point to grid point, as the lookup is.
    QVector<QCPGraphData> alongX;
    for (std::size_t i = 0; i < axes[0].size; ++i)
        alongX.append({axes[0].position(i), lookup.at(axes[0].position(i), place[1])});
    QVector<QCPCurveData> alongY;
    for (std::size_t j = 0; j < axes[1].size; ++j)
        alongY.append({static_cast<double>(j), lookup.at(place[0], axes[1].position(j)),
            axes[1].position(j)});
    m_alongX->data()->set(alongX, true);
    m_alongY->data()->set(alongY, true);
}

void CrossSections::setLabels(const QString& x)
{
    m_below->axis(QCPAxis::atBottom)->setLabel(x);
}

void CrossSections::setValueFactor(double factor)
{
    for (const auto& ticker : m_tickers)
        ticker->setFactor(factor);
}

QList<QCPAxis*> CrossSections::axes() const
{
    return m_beside->axes() + m_below->axes();
}

void CrossSections::setPen(const QPen& pen)
{
    m_alongX->setPen(pen);
    m_alongY->setPen(pen);
}

} // namespace axiscomp::ui
