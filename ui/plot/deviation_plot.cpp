// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/deviation_plot.h"

#include "ui/async/background_job.h"
#include "ui/style/accessible_role.h"
#include "ui/style/plain_label.h"
#include "ui/text/fine_scale.h"
#include "ui/text/run_value_text.h"
#include "ui/text/translated_text.h"
#include "ui/text/value_text.h"

#include <QApplication>
#include <QBoxLayout>
#include <QEvent>
#include <QKeyEvent>
#include <QMouseEvent>

#include "ui/drawing/custom_plot.h"

#include <algorithm>
#include <tuple>

namespace axiscomp::ui {

namespace {

constexpr double keyZoom = 0.8;

Exclusion exclusionOf(const RunValue& value)
{
    return {value.direction, value.target + 1, value.run};
}

/// Of a target, from the lowest to the highest.
std::vector<const RunValue*> columnOf(const Measurement& measurement, std::size_t target)
{
    std::vector<const RunValue*> column;
    for (const Approach direction : {Approach::Up, Approach::Down})
        for (const RunValue& value : valuesAt(measurement, direction, target))
            column.push_back(&value);
    std::ranges::sort(column, {}, [](const RunValue* value) {
        return std::tuple(value->deviation, value->direction, value->run);
    });
    return column;
}

/// The value above or below, or the outermost one where none is selected.
std::optional<Exclusion> above(const Measurement& measurement, const Exclusion& from, int step)
{
    const auto column = columnOf(measurement, from.target.value_or(1) - 1);
    if (column.empty())
        return std::nullopt;
    const auto at =
        std::ranges::find(column, from, [](const RunValue* value) { return exclusionOf(*value); });
    const auto last = static_cast<std::ptrdiff_t>(column.size()) - 1;
    const std::ptrdiff_t next =
        at == column.end() ? (step > 0 ? 0 : last) : (at - column.begin()) + step;
    return exclusionOf(
        *column[static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(next, 0, last))]);
}

/// The next target, in the same run where one is selected.
Exclusion beside(const Measurement& measurement, const Exclusion& from, int step)
{
    const auto count = static_cast<std::ptrdiff_t>(measurement.targets.size());
    auto target = static_cast<std::ptrdiff_t>(from.target.value_or(step > 0 ? 0 : count + 1)) - 1;
    for (target += step; target >= 0 && target < count; target += step) {
        const auto index = static_cast<std::size_t>(target);
        if (!from.direction || !from.run)
            return {{}, index + 1, {}};
        if (findValue(measurement, *from.direction, index, *from.run))
            return {from.direction, index + 1, from.run};
    }
    return from;
}

QString signedOrNothing(const FineScale& scale, const std::optional<double>& value)
{
    return value ? scale.text(*value) : QStringLiteral("–");
}

} // namespace

DeviationPlot::DeviationPlot(QWidget* parent)
    : QWidget(parent)
    , m_canvas(new DeviationCanvas(this))
    , m_readout(new PlainLabel)
{
    setObjectName(QStringLiteral("deviationPlot"));
    QCustomPlot& plot = m_canvas->plot();
    setAccessibleRole(plot, QAccessible::Chart);
    plot.setMinimumSize(260, 80);
    plot.setFocusPolicy(Qt::StrongFocus);
    plot.setMouseTracking(true);
    plot.installEventFilter(this);
    m_readout->setObjectName(QStringLiteral("deviationReadout"));
    m_readout->setTextInteractionFlags(Qt::TextSelectableByMouse);
    m_readout->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(4);
    layout->addWidget(&plot, 1);
    layout->addWidget(m_readout);
    retranslate();
}

DeviationPlot::~DeviationPlot() = default;

QWidget& DeviationPlot::picture()
{
    return m_canvas->plot();
}

void DeviationPlot::setSeries(std::vector<DeviationSeries> series)
{
    std::erase_if(series, [](const DeviationSeries& one) { return !one.measurement; });
    if (series == m_series)
        return;
    m_canvas->show(series);
    letGo(std::exchange(m_series, std::move(series)));
    m_hovered.reset();
    select(m_selected);
}

void DeviationPlot::select(const std::optional<DeviationPlace>& place)
{
    m_selected = place && place->series < m_series.size() ? place : std::nullopt;
    m_canvas->setSelected(m_selected);
    showReadout();
}

void DeviationPlot::choose(const std::optional<DeviationPlace>& place)
{
    if (place == m_selected)
        return;
    m_hovered.reset();
    select(place);
    Q_EMIT selectionChanged(m_selected);
}

void DeviationPlot::retranslate()
{
    QCustomPlot& plot = m_canvas->plot();
    plot.setAccessibleName(tr("Deviation over position"));
    plot.setToolTip(tr("A click selects a value; arrow keys go from value to value. The wheel and "
                       "+ and - zoom, dragging moves, Home or a double click shows everything."));
    m_canvas->show(m_series);
    showReadout();
}

void DeviationPlot::showReadout()
{
    QStringList parts;
    if (m_hovered)
        for (const DeviationSeries& series : m_series)
            parts += targetText(series, *m_hovered);
    else if (m_selected)
        parts += placeText(*m_selected);
    m_readout->setText(parts.join(QStringLiteral("     ")));
    m_readout->setToolTip(m_readout->text());
    const QString selected = m_selected ? placeText(*m_selected) : QString();
    QCustomPlot& plot = m_canvas->plot();
    const QString description = selected.isEmpty() ? plot.toolTip() : selected;
    if (plot.accessibleDescription() != description)
        plot.setAccessibleDescription(description);
}

/// "down, target 1, run 1, 93.20 µm, proposed for exclusion"
QString DeviationPlot::placeText(const DeviationPlace& place) const
{
    const DeviationSeries& series = m_series[place.series];
    const QString name = series.name.isEmpty() ? QString() : series.name + QStringLiteral(": ");
    const Exclusion& values = place.values;
    if (isOneValue(values)) {
        const RunValue* value =
            findValue(*series.measurement, *values.direction, *values.target - 1, *values.run);
        if (!value)
            return {};
        RunValue shown = *value;
        shown.deviation = series.shown(value->deviation);
        return name + runValueText(shown, FineScale(m_canvas->unit()), isProposed(series, *value));
    }
    if (values.target) {
        const auto& targets = series.measurement->targets;
        return *values.target <= targets.size() ? targetText(series, targets[*values.target - 1])
                                                : QString();
    }
    return name
        + tr("run %1, %2")
              .arg(values.run.value_or(0))
              .arg(translated(approachText(values.direction.value_or(Approach::Up))));
}

/// "target 45.6 mm, ↑ -9.02, ↓ -7.88 µm, B -1.14 µm"
QString DeviationPlot::targetText(const DeviationSeries& series, double position) const
{
    const auto& figures = series.figures->targets;
    if (figures.empty())
        return {};
    auto nearest = std::ranges::lower_bound(figures, position, {}, &TargetFigures::position);
    if (nearest == figures.end()
        || (nearest != figures.begin()
            && position - std::prev(nearest)->position < nearest->position - position))
        --nearest;
    const FineScale scale(m_canvas->unit());
    const QString unit = series.measurement->isAngular ? QStringLiteral("°") : QStringLiteral("mm");
    QString text = tr("target %1 %2, ↑ %3, ↓ %4 %5, B %6 %5")
                       .arg(numberText(nearest->position), unit,
                           signedOrNothing(scale, series.shown(nearest->up.mean)),
                           signedOrNothing(scale, series.shown(nearest->down.mean)), scale.symbol(),
                           signedOrNothing(scale, nearest->reversal));
    return series.name.isEmpty() ? text : series.name + QStringLiteral(": ") + text;
}

bool DeviationPlot::handleKey(const QKeyEvent& key)
{
    if (m_series.empty() || key.modifiers() & (Qt::ControlModifier | Qt::AltModifier))
        return false;
    // The newest measurement is the one that matters unless the user says otherwise.
    const DeviationPlace from = m_selected.value_or(DeviationPlace{m_series.size() - 1, {}});
    const Measurement& measurement = *m_series[from.series].measurement;
    const auto go = [&](const std::optional<Exclusion>& to) {
        if (to)
            choose(DeviationPlace{from.series, *to});
        return true;
    };
    switch (key.key()) {
    case Qt::Key_Left:
        return go(beside(measurement, from.values, -1));
    case Qt::Key_Right:
        return go(beside(measurement, from.values, 1));
    case Qt::Key_Up:
        return go(above(measurement, from.values, 1));
    case Qt::Key_Down:
        return go(above(measurement, from.values, -1));
    case Qt::Key_Plus:
        m_canvas->zoom(keyZoom);
        return true;
    case Qt::Key_Minus:
        m_canvas->zoom(1.0 / keyZoom);
        return true;
    case Qt::Key_Home:
        m_canvas->showWhole();
        return true;
    case Qt::Key_Space:
        if (m_series.size() < 2)
            return false;
        choose(DeviationPlace{1 - from.series, {{}, std::size_t{1}, {}}});
        return true;
    case Qt::Key_Escape:
        if (!m_selected)
            return false;
        choose(std::nullopt);
        return true;
    default:
        return false;
    }
}

void DeviationPlot::handleMouse(const QMouseEvent& mouse)
{
    // Shift draws the rectangle that is zoomed into; without it the picture is dragged.
    const bool hasShift = mouse.modifiers() & Qt::ShiftModifier;
    m_canvas->plot().setSelectionRectMode(hasShift ? QCP::srmZoom : QCP::srmNone);
    if (mouse.type() == QEvent::MouseButtonPress)
        m_pressed = mouse.position();
    const bool isStill =
        (mouse.position() - m_pressed).manhattanLength() < QApplication::startDragDistance();
    if (mouse.type() == QEvent::MouseButtonRelease && mouse.button() == Qt::LeftButton && !hasShift
        && isStill)
        choose(m_canvas->placeAt(mouse.position()));
    m_hovered =
        mouse.type() == QEvent::MouseMove ? m_canvas->positionAt(mouse.position()) : std::nullopt;
    showReadout();
}

bool DeviationPlot::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::KeyPress:
        if (handleKey(static_cast<const QKeyEvent&>(*event)))
            return true;
        break;
    case QEvent::MouseMove:
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
        handleMouse(static_cast<const QMouseEvent&>(*event));
        break;
    case QEvent::MouseButtonDblClick:
        m_canvas->showWhole();
        return true;
    case QEvent::Leave:
        m_hovered.reset();
        showReadout();
        break;
    case QEvent::FocusIn:
    case QEvent::FocusOut:
        m_canvas->setSelected(m_selected); // the frame of the one that has the keys
        break;
    default:
        break;
    }
    return QWidget::eventFilter(watched, event);
}

void DeviationPlot::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange)
        m_canvas->setPalette(palette());
}

} // namespace axiscomp::ui
