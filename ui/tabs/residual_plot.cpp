// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/tabs/residual_plot.h"

#include "ui/drawing/local_plot.h"
#include "ui/drawing/plot_style.h"
#include "ui/drawing/value_ticker.h"
#include "ui/style/contrast.h"
#include "ui/text/fine_scale.h"

#include <QBoxLayout>
#include <QEvent>

#include <algorithm>

namespace axiscomp::ui {

namespace {

bool isDark(const QPalette& palette)
{
    return palette.color(QPalette::Base).lightness() < 128;
}

QColor seenThrough(QColor color)
{
    constexpr int alpha = 60;
    color.setAlpha(alpha);
    return color;
}

/// Rounded outwards a little, so that markers and bands are seen whole.
void widen(QCPAxis& axis)
{
    constexpr double margin = 0.08;
    const QCPRange range = axis.range();
    const double room = range.size() > 0.0 ? margin * range.size() : 1e-6;
    axis.setRange(range.lower - room, range.upper + room);
}

} // namespace

ResidualPlot::ResidualPlot(QWidget* parent)
    : QWidget(parent)
    , m_plot(new LocalPlot)
    , m_ticker(new ValueTicker)
{
    setObjectName(QStringLiteral("residualPlot"));
    build();
    retranslate();
}

void ResidualPlot::build()
{
    m_plot->setFocusPolicy(Qt::NoFocus);
    m_plot->yAxis->setTicker(m_ticker);
    for (Curve* curve : {&m_before, &m_after}) {
        curve->low = m_plot->addGraph();
        curve->high = m_plot->addGraph();
        curve->high->setChannelFillGraph(curve->low);
        for (QCPGraph* edge : {curve->low, curve->high}) {
            edge->setPen(Qt::NoPen);
            edge->removeFromLegend();
        }
        curve->mean = m_plot->addGraph();
    }
    // Above the curves, not over them.
    m_plot->axisRect()->insetLayout()->take(m_plot->legend);
    m_plot->plotLayout()->insertRow(0);
    m_plot->plotLayout()->addElement(0, 0, m_plot->legend);
    m_plot->plotLayout()->setRowStretchFactor(0, 0.001);
    m_plot->legend->setFillOrder(QCPLegend::foColumnsFirst);
    m_plot->legend->setBorderPen(Qt::NoPen);
    m_plot->legend->setVisible(true);
    m_plot->setMinimumHeight(8 * fontMetrics().height());
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->addWidget(m_plot);
    colour();
}

void ResidualPlot::colour()
{
    const QPalette colors = palette();
    const bool dark = isDark(colors);
    const QColor text = colors.color(QPalette::Text);
    const QColor grid = mutedTextColor(colors);
    m_plot->setBackground(colors.color(QPalette::Base));
    for (QCPAxis* axis : {m_plot->xAxis, m_plot->yAxis}) {
        axis->setBasePen(QPen(text));
        axis->setTickPen(QPen(text));
        axis->setSubTickPen(QPen(text));
        axis->setTickLabelColor(text);
        axis->setLabelColor(text);
        axis->setTickLabelFont(font());
        axis->setLabelFont(font());
        axis->grid()->setPen(QPen(grid, 1, Qt::DotLine));
        axis->grid()->setZeroLinePen(QPen(grid, 1, Qt::SolidLine));
    }
    const QColor after = dark ? QColor(110, 185, 255) : QColor(5, 80, 160);
    m_before.mean->setPen(QPen(grid, 1.5, Qt::DashLine));
    m_before.mean->setScatterStyle(QCPScatterStyle(
        QCPScatterStyle::ssSquare, QPen(grid, 1.5), colors.color(QPalette::Base), 7));
    m_before.high->setBrush(seenThrough(grid));
    m_after.mean->setPen(QPen(after, 2.0));
    m_after.mean->setScatterStyle(
        QCPScatterStyle(QCPScatterStyle::ssDisc, QPen(after, 1.5), after, 7));
    m_after.high->setBrush(seenThrough(after));
    m_plot->legend->setFont(font());
    m_plot->legend->setBrush(colors.color(QPalette::Base));
    m_plot->legend->setTextColor(text);
}

void ResidualPlot::fill(const Curve& curve, const std::vector<RemainingError>& errors,
    const std::optional<PlacedDeviation>& datum) const
{
    QVector<double> positions;
    QVector<double> values;
    QVector<double> lows;
    QVector<double> highs;
    for (const RemainingError& error : errors) {
        const double half = error.standardError.value_or(0.0);
        const double value = fromDatum(error.value, datum);
        positions += error.position;
        values += value;
        lows += value - half;
        highs += value + half;
    }
    curve.mean->setData(positions, values, true);
    curve.low->setData(positions, lows, true);
    curve.high->setData(positions, highs, true);
}

void ResidualPlot::show(const ComparisonState& state)
{
    m_state = state;
    const bool isThere = state.comparison != nullptr;
    const std::vector<RemainingError> nothing;
    fill(m_before, isThere ? state.comparison->errorBefore : nothing, state.datums.before);
    fill(m_after, isThere ? state.comparison->residual : nothing, state.datums.after);
    m_ticker->setFactor(state.unit.factor);
    m_plot->yAxis->setNumberFormat(QStringLiteral("gb"));
    m_plot->setVisible(isThere);
    if (isThere) {
        m_plot->rescaleAxes();
        widen(*m_plot->xAxis);
        widen(*m_plot->yAxis);
    }
    nameAxes();
    describe();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void ResidualPlot::nameAxes()
{
    m_before.mean->setName(tr("before"));
    m_after.mean->setName(tr("after, with its standard error"));
    m_plot->xAxis->setLabel(QStringLiteral("%1 [%2]").arg(
        tr("Position"), m_state.isAngular ? QStringLiteral("°") : QStringLiteral("mm")));
    m_plot->yAxis->setLabel(deviationLabel(m_state.unit, m_state.datums.after, m_state.isAngular));
}

/// For those who do not see it; the numbers stand in the tables.
void ResidualPlot::describe()
{
    QString description = tr("There is nothing to compare.");
    if (m_state.comparison && !m_state.comparison->residual.empty()) {
        const auto [low, high] =
            std::ranges::minmax_element(m_state.comparison->residual, {}, &RemainingError::value);
        const FineScale scale(m_state.unit);
        const auto shown = [&](const RemainingError& error) {
            return scale.textWithUnit(fromDatum(error.value, m_state.datums.after));
        };
        description = tr("What is left lies between %1 and %2.").arg(shown(*low), shown(*high));
    }
    setAccessibleName(tr("Mean deviation before and after"));
    setAccessibleDescription(description);
    setToolTip(tr("Dashed, with squares: before. Full line, with dots: after; the band is the "
                  "standard error of the mean."));
}

void ResidualPlot::retranslate()
{
    nameAxes();
    describe();
    m_plot->replot(QCustomPlot::rpQueuedReplot);
}

void ResidualPlot::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange || event->type() == QEvent::FontChange) {
        colour();
        m_plot->replot(QCustomPlot::rpQueuedReplot);
    }
    QWidget::changeEvent(event);
}

} // namespace axiscomp::ui
