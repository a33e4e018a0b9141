// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drawing/travel_mark.h"

#include "ui/drawing/painted_item.h"

#include <algorithm>

namespace axiscomp::ui {

TravelMark::TravelMark(QCustomPlot& plot) : m_plot(plot)
{
    // Tinted below curve and map, outlined above them.
    new PaintedItem(plot, "grid",
        [this](QCPPainter& painter, const QRectF& sight) { paintTint(painter, sight); });
    new PaintedItem(plot, "axes",
        [this](QCPPainter& painter, const QRectF& sight) { paintLines(painter, sight); });
}

void TravelMark::setTable(std::shared_ptr<const CompensationTable> table)
{
    m_table = std::move(table);
}

void TravelMark::setTravel(const Spans& travel, bool holdsEnds)
{
    m_travel = travel;
    m_holdsEnds = holdsEnds;
}

void TravelMark::setTexts(const QString& travel, const QString& table, const QString& held)
{
    m_travelText = travel;
    m_tableText = table;
    m_heldText = held;
}

void TravelMark::setColors(
    const QColor& tint, const QColor& line, const QColor& text, const QColor& base)
{
    m_tint = tint;
    m_line = line;
    m_text = text;
    m_base = base;
}

bool TravelMark::isShown() const
{
    return m_table && (m_travel[0] || (isMap() && m_travel[1]));
}

QCPRange TravelMark::wholeRange(std::size_t drawnAxis) const
{
    const GridAxis& axis = m_table->grid.axes.at(drawnAxis);
    QCPRange range(axis.start, axis.last());
    if (const auto& travel = m_travel.at(drawnAxis)) {
        const double most = range.size();
        range = QCPRange(std::clamp(travel->low, range.lower - most, range.lower),
            std::clamp(travel->high, range.upper, range.upper + most));
    }
    return range;
}

/// Along an axis whose travel is not known: all that is in sight.
QRectF TravelMark::placeOfTravel(const QRectF& sight) const
{
    QRectF place = sight;
    if (m_travel[0]) {
        place.setLeft(m_plot.xAxis->coordToPixel(m_travel[0]->low));
        place.setRight(m_plot.xAxis->coordToPixel(m_travel[0]->high));
    }
    if (isMap() && m_travel[1]) {
        place.setTop(m_plot.yAxis->coordToPixel(m_travel[1]->high));
        place.setBottom(m_plot.yAxis->coordToPixel(m_travel[1]->low));
    }
    return place;
}

void TravelMark::paintTint(QCPPainter& painter, const QRectF& sight) const
{
    if (!isShown())
        return;
    QPainterPath tinted;
    tinted.addRect(placeOfTravel(sight) & sight);
    // Not below the map: on saved pages it is below the lines.
    if (isMap()) {
        QPainterPath map;
        map.addRect(placeOfMap());
        tinted -= map;
    }
    painter.fillPath(tinted, m_tint);
}

QRectF TravelMark::placeOfMap() const
{
    const GridAxis& x = m_table->grid.axes[0];
    const GridAxis& y = m_table->grid.axes[1];
    return {QPointF(m_plot.xAxis->coordToPixel(x.start), m_plot.yAxis->coordToPixel(y.last())),
        QPointF(m_plot.xAxis->coordToPixel(x.last()), m_plot.yAxis->coordToPixel(y.start))};
}

void TravelMark::paintLines(QCPPainter& painter, const QRectF& sight) const
{
    if (!isShown())
        return;
    const QRectF travel = placeOfTravel(sight);
    painter.setAntialiasing(false);
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(m_line, 1.0, isMap() ? Qt::DashLine : Qt::SolidLine));
    // What goes beyond the sight has no end there.
    constexpr double beyond = 2.0;
    painter.drawRect(travel & sight.adjusted(-beyond, -beyond, beyond, beyond));
    painter.setPen(m_text);
    const QSizeF size = noteSize(painter, m_travelText);
    paintNote(painter, QRectF((travel & sight).topLeft() + QPointF(2.0, 2.0), size), m_travelText,
        sight, m_base);
    if (isMap()) {
        paintHeldNote(painter, travel & sight, sight);
        return;
    }
    paintBracket(painter, sight);
    if (m_holdsEnds)
        paintHeldEnds(painter, sight);
}

/// At the foot of the plot, its ends upwards.
void TravelMark::paintBracket(QCPPainter& painter, const QRectF& sight) const
{
    const GridAxis& axis = m_table->grid.axes[0];
    const double left = m_plot.xAxis->coordToPixel(axis.start);
    const double right = m_plot.xAxis->coordToPixel(axis.last());
    constexpr double above = 4.0;
    constexpr double ends = 6.0;
    const double y = sight.bottom() - above;
    painter.setPen(QPen(m_text, 1.0));
    painter.drawPolyline(QPolygonF({{left, y - ends}, {left, y}, {right, y}, {right, y - ends}}));
    const double middle = (std::max(left, sight.left()) + std::min(right, sight.right())) / 2.0;
    QRectF note(QPointF(), noteSize(painter, m_tableText));
    note.moveCenter(QPointF(middle, 0.0));
    note.moveBottom(y - 2.0);
    paintNote(painter, note, m_tableText, sight, m_base);
}

/// The longer side is always named, the other where the words fit.
void TravelMark::paintHeldEnds(QCPPainter& painter, const QRectF& sight) const
{
    const GridAxis& axis = m_table->grid.axes[0];
    struct Side {
        double table; ///< pixels
        double travel;
        double y;
    };
    const auto x = [this](double position) { return m_plot.xAxis->coordToPixel(position); };
    const auto y = [this](float value) {
        return m_plot.yAxis->coordToPixel(static_cast<double>(value));
    };
    std::array<Side, 2> sides{{{x(axis.start), x(m_travel[0]->low), y(m_table->values.front())},
        {x(axis.last()), x(m_travel[0]->high), y(m_table->values.back())}}};
    const auto length = [](const Side& side, double direction) {
        return std::max(0.0, (side.travel - side.table) * direction);
    };
    const std::array<double, 2> lengths{length(sides[0], -1.0), length(sides[1], 1.0)};
    for (std::size_t n = 0; n < sides.size(); ++n) {
        if (lengths[n] < 1.0)
            continue;
        painter.setPen(QPen(m_text, 1.0, Qt::DashLine));
        painter.drawLine(QPointF(sides[n].table, sides[n].y), QPointF(sides[n].travel, sides[n].y));
        painter.setPen(m_text);
        QRectF note(QPointF(), noteSize(painter, m_heldText));
        if (lengths[n] < note.width() && lengths[n] < lengths[1 - n])
            continue;
        const QRectF seen(
            QPointF(std::max(std::min(sides[n].table, sides[n].travel), sight.left()), sight.top()),
            QPointF(std::min(std::max(sides[n].table, sides[n].travel), sight.right()),
                sight.bottom()));
        note.moveCenter(QPointF(seen.center().x(), 0.0));
        note.moveBottom(sides[n].y - 2.0);
        paintNote(painter, note, m_heldText, sight, m_base);
    }
}

/// In the widest strip between map and travel, where the words fit.
void TravelMark::paintHeldNote(QCPPainter& painter, const QRectF& travel, const QRectF& sight) const
{
    const QRectF map = placeOfMap();
    const QSizeF size = noteSize(painter, m_heldText);
    const std::array<QRectF, 4> strips{
        QRectF(QPointF(travel.left(), map.bottom()), travel.bottomRight()),
        QRectF(travel.topLeft(), QPointF(travel.right(), map.top())),
        QRectF(QPointF(map.right(), travel.top()), travel.bottomRight()),
        QRectF(travel.topLeft(), QPointF(map.left(), travel.bottom()))};
    for (const QRectF& strip : strips) {
        if (!m_holdsEnds || strip.width() < size.width() || strip.height() < size.height())
            continue;
        QRectF note(QPointF(), size);
        note.moveCenter(strip.center());
        paintNote(painter, note, m_heldText, sight, m_base);
        return;
    }
}

} // namespace axiscomp::ui
