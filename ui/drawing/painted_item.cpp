// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drawing/painted_item.h"

#include <algorithm>

namespace axiscomp::ui {

PaintedItem::PaintedItem(QCustomPlot& plot, const char* layer, Paint paint)
    : QCPAbstractItem(&plot)
    , m_paint(std::move(paint))
{
    setLayer(QLatin1StringView(layer));
    setSelectable(false);
    setClipAxisRect(plot.axisRect());
    setClipToAxisRect(true);
}

double PaintedItem::selectTest(const QPointF&, bool, QVariant*) const
{
    return -1.0; // never hit
}

void PaintedItem::draw(QCPPainter* painter)
{
    m_paint(*painter, QRectF(clipRect()));
}

QSizeF noteSize(const QCPPainter& painter, const QString& text)
{
    const QFontMetricsF metrics(painter.font());
    return {metrics.horizontalAdvance(text) + 6.0, metrics.height()};
}

void paintNote(QCPPainter& painter, QRectF place, const QString& text, const QRectF& sight,
    const QColor& background)
{
    const auto held = [](double at, double low, double high) {
        return std::clamp(at, low, std::max(low, high));
    };
    place.moveLeft(held(place.left(), sight.left(), sight.right() - place.width()));
    place.moveTop(held(place.top(), sight.top(), sight.bottom() - place.height()));
    QColor under = background;
    constexpr int almostOpaque = 200;
    under.setAlpha(almostOpaque);
    painter.fillRect(place, under);
    painter.drawText(place, Qt::AlignCenter, text);
}

} // namespace axiscomp::ui
