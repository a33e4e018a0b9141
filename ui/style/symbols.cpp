// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/style/symbols.h"

#include <QGuiApplication>
#include <QIconEngine>
#include <QPainter>
#include <QPainterPath>
#include <QPalette>
#include <QPolygonF>

#include <initializer_list>

namespace axiscomp::ui {

namespace {

// All shapes live in a box of 24 x 24 and are drawn with a round pen of 2.
constexpr qreal box = 24.0;
constexpr qreal penWidth = 2.0;

void addLine(QPainterPath& path, std::initializer_list<QPointF> points)
{
    path.addPolygon(QPolygonF(points));
}

QPainterPath folder()
{
    QPainterPath path;
    addLine(path, {{3, 19}, {3, 5}, {9, 5}, {11, 8}, {19, 8}, {19, 11}});
    addLine(path, {{3, 19}, {6.5, 11}, {22, 11}, {18.5, 19}, {3, 19}});
    return path;
}

QPainterPath refreshArrow()
{
    QPainterPath path;
    path.arcMoveTo(QRectF(4, 4, 16, 16), 20);
    path.arcTo(QRectF(4, 4, 16, 16), 20, 310);
    addLine(path, {{19.8, 4}, {19.6, 9.6}, {14, 9.4}});
    return path;
}

QPainterPath revertArrow()
{
    QPainterPath path;
    addLine(path, {{8.5, 4.5}, {4, 9}, {8.5, 13.5}});
    path.moveTo(4, 9);
    path.lineTo(14, 9);
    path.arcTo(QRectF(9, 9, 10, 10), 90, -180);
    path.lineTo(9, 19);
    return path;
}

QPainterPath plug()
{
    QPainterPath path;
    addLine(path, {{8, 3}, {8, 8}});
    addLine(path, {{16, 3}, {16, 8}});
    addLine(path, {{5, 8}, {19, 8}});
    path.moveTo(7, 8);
    path.lineTo(7, 12);
    path.arcTo(QRectF(7, 7, 10, 10), 180, 180);
    path.lineTo(17, 8);
    addLine(path, {{12, 17}, {12, 21}});
    return path;
}

QPainterPath bars(std::initializer_list<QPair<qreal, qreal>> fromTo)
{
    QPainterPath path;
    qreal y = 6;
    for (const auto& [from, to] : fromTo) {
        addLine(path, {{from, y}, {to, y}});
        y += 6;
    }
    return path;
}

QPainterPath cross(qreal margin)
{
    QPainterPath path;
    addLine(path, {{margin, margin}, {box - margin, box - margin}});
    addLine(path, {{margin, box - margin}, {box - margin, margin}});
    return path;
}

QPainterPath sheets()
{
    QPainterPath path;
    path.addRoundedRect(QRectF(9, 8, 11, 13), 1.5, 1.5);
    addLine(path, {{5, 16}, {4, 16}, {4, 3}, {15, 3}, {15, 4}});
    return path;
}

QPainterPath saveArrow()
{
    QPainterPath path;
    addLine(path, {{12, 3}, {12, 14}});
    addLine(path, {{7, 9.5}, {12, 14.5}, {17, 9.5}});
    addLine(path, {{4, 16}, {4, 20}, {20, 20}, {20, 16}});
    return path;
}

QPainterPath plus(bool hasVertical)
{
    QPainterPath path;
    addLine(path, {{5, 12}, {19, 12}});
    if (hasVertical)
        addLine(path, {{12, 5}, {12, 19}});
    return path;
}

QPainterPath pencil()
{
    QPainterPath path;
    addLine(path, {{4, 20}, {5, 15.5}, {16, 4.5}, {19.5, 8}, {8.5, 19}, {4, 20}});
    return path;
}

QPainterPath information()
{
    QPainterPath path;
    path.addEllipse(QRectF(3, 3, 18, 18));
    addLine(path, {{12, 11}, {12, 16.5}});
    addLine(path, {{12, 7.4}, {12, 7.6}});
    return path;
}

QPainterPath warning()
{
    QPainterPath path;
    addLine(path, {{12, 3.5}, {21.5, 20}, {2.5, 20}, {12, 3.5}});
    addLine(path, {{12, 10}, {12, 14}});
    addLine(path, {{12, 16.9}, {12, 17.1}});
    return path;
}

QPainterPath error()
{
    QPainterPath path = cross(8.5);
    addLine(path,
        {{8.3, 3}, {15.7, 3}, {21, 8.3}, {21, 15.7}, {15.7, 21}, {8.3, 21}, {3, 15.7}, {3, 8.3},
            {8.3, 3}});
    return path;
}

QPainterPath success()
{
    QPainterPath path;
    path.addEllipse(QRectF(3, 3, 18, 18));
    addLine(path, {{7.8, 12.2}, {10.8, 15.3}, {16.4, 9}});
    return path;
}

QPainterPath shape(Symbol symbol)
{
    switch (symbol) {
    case Symbol::Open:
        return folder();
    case Symbol::Refresh:
        return refreshArrow();
    case Symbol::Revert:
        return revertArrow();
    case Symbol::Connections:
        return plug();
    case Symbol::Menu:
        return bars({{4, 20}, {4, 20}, {4, 20}});
    case Symbol::Log:
        return bars({{4, 20}, {4, 15}, {4, 18}});
    case Symbol::Close:
        return cross(6.5);
    case Symbol::Copy:
        return sheets();
    case Symbol::Save:
        return saveArrow();
    case Symbol::Add:
        return plus(true);
    case Symbol::Remove:
        return plus(false);
    case Symbol::Edit:
        return pencil();
    case Symbol::Information:
        return information();
    case Symbol::Warning:
        return warning();
    case Symbol::Error:
        return error();
    case Symbol::Success:
        break;
    }
    return success();
}

void draw(QPainter& painter, const QRectF& rect, Symbol symbol, const QColor& color)
{
    const qreal side = qMin(rect.width(), rect.height());
    painter.save();
    painter.setRenderHint(QPainter::Antialiasing);
    painter.translate(rect.center() - QPointF(side / 2, side / 2));
    painter.scale(side / box, side / box);
    painter.setPen(QPen(color, penWidth, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(Qt::NoBrush);
    painter.drawPath(shape(symbol));
    painter.restore();
}

class SymbolEngine final : public QIconEngine {
public:
    explicit SymbolEngine(Symbol symbol) : m_symbol(symbol) { }

    void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override
    {
        const QPalette::ColorGroup group =
            mode == QIcon::Disabled ? QPalette::Disabled : QPalette::Active;
        draw(*painter, rect, m_symbol,
            QGuiApplication::palette().color(group, QPalette::ButtonText));
    }
    QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override
    {
        QPixmap pixmap(size);
        pixmap.fill(Qt::transparent);
        QPainter painter(&pixmap);
        paint(&painter, QRect({}, size), mode, state);
        return pixmap;
    }
    [[nodiscard]] QIconEngine* clone() const override { return new SymbolEngine(m_symbol); }

private:
    Symbol m_symbol;
};

} // namespace

QIcon symbolIcon(Symbol symbol)
{
    return QIcon(new SymbolEngine(symbol));
}

QPixmap symbolPixmap(Symbol symbol, const QColor& color, int size, qreal pixelRatio)
{
    QPixmap pixmap(QSize(size, size) * pixelRatio);
    pixmap.setDevicePixelRatio(pixelRatio);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    draw(painter, QRectF(0, 0, size, size), symbol, color);
    return pixmap;
}

Symbol symbolOf(Tone tone)
{
    switch (tone) {
    case Tone::Error:
        return Symbol::Error;
    case Tone::Warning:
    case Tone::Changed:
        return Symbol::Warning;
    case Tone::Success:
        return Symbol::Success;
    case Tone::Information:
        break;
    }
    return Symbol::Information;
}

QIcon cellIcon(Tone tone)
{
    constexpr int size = 14;
    const Symbol symbol = symbolOf(tone);
    const QPalette colors = QGuiApplication::palette();
    const qreal ratio = qGuiApp->devicePixelRatio();
    QIcon icon(symbolPixmap(symbol, frameColor(tone, colors), size, ratio));
    icon.addPixmap(symbolPixmap(symbol, colors.color(QPalette::HighlightedText), size, ratio),
        QIcon::Selected);
    return icon;
}

} // namespace axiscomp::ui
