// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QImage>
#include <QPainter>
#include <QRegion>
#include <QWidget>

#include <algorithm>
#include <map>

namespace axiscomp::test {

/// What an eye takes for orange, whatever its lightness.
[[nodiscard]] inline bool isOrange(const QColor& color)
{
    return color.hsvHue() >= 15 && color.hsvHue() <= 45 && color.hsvSaturationF() > 0.6F
        && color.valueF() > 0.35F;
}

/// A widget as it is painted at a device pixel ratio. Coordinates are the widget's own.
class Picture {
public:
    explicit Picture(QWidget& widget, int scale = 1) : m_scale(scale)
    {
        m_image = QImage(widget.size() * scale, QImage::Format_ARGB32);
        m_image.setDevicePixelRatio(scale);
        m_image.fill(widget.palette().color(QPalette::Window));
        widget.render(&m_image);
    }

    [[nodiscard]] int orangePixels(const QRect& rect) const
    {
        int count = 0;
        eachPixel(rect, [&](const QColor& color) { count += isOrange(color) ? 1 : 0; });
        return count;
    }
    [[nodiscard]] int orangePixels(const QRegion& region) const
    {
        int count = 0;
        for (const QRect& rect : region)
            count += orangePixels(rect);
        return count;
    }

    /// How much of the four sides of a rectangle has orange near the edge, the side with least: 1
    /// is a whole frame.
    [[nodiscard]] double frameCoverage(const QRect& rect) const
    {
        constexpr int depth = 4;
        double least = 1.0;
        for (const bool isHorizontal : {true, false}) {
            for (const bool isFirst : {true, false}) {
                const int length = isHorizontal ? rect.width() : rect.height();
                int covered = 0;
                for (int along = 0; along < length; ++along)
                    covered += hasOrange(rect, isHorizontal, isFirst, along, depth) ? 1 : 0;
                least = std::min(least, static_cast<double>(covered) / length);
            }
        }
        return least;
    }

    /// The colours met on the way from outside through a side into the rectangle; where letters
    /// are in the way, what most of the side has.
    struct Section {
        QColor outside;
        QColor frame; ///< the strongest orange; invalid: there is none
        QColor inside; ///< beside the frame
    };
    enum class Side { Top, Bottom, Left, Right };
    [[nodiscard]] Section section(const QRect& rect, Side side) const
    {
        const bool isVertical = side == Side::Left || side == Side::Right;
        const int length = (isVertical ? rect.height() : rect.width()) * m_scale;
        std::map<QRgb, int> outside;
        std::map<QRgb, int> inside;
        Section section;
        for (int along = length / 4; along < length * 3 / 4; ++along) {
            const Section here = sectionAt(rect, side, along);
            ++outside[here.outside.rgb()];
            if (!here.frame.isValid())
                return {};
            ++inside[here.inside.rgb()];
            if (!section.frame.isValid()
                || here.frame.hsvSaturationF() > section.frame.hsvSaturationF())
                section.frame = here.frame;
        }
        section.outside = mostOf(outside);
        section.inside = mostOf(inside);
        return section;
    }

    [[nodiscard]] const QImage& image() const { return m_image; }

private:
    [[nodiscard]] static QColor mostOf(const std::map<QRgb, int>& counts)
    {
        return std::ranges::max_element(counts, {}, [](const auto& entry) {
            return entry.second;
        })->first;
    }
    [[nodiscard]] Section sectionAt(const QRect& rect, Side side, int along) const
    {
        constexpr int deepest = 6;
        const QRect area(rect.topLeft() * m_scale, rect.size() * m_scale);
        const auto at = [&](int depth) {
            switch (side) {
            case Side::Top:
                return m_image.pixelColor(area.left() + along, area.top() + depth);
            case Side::Bottom:
                return m_image.pixelColor(area.left() + along, area.bottom() - depth);
            case Side::Left:
                return m_image.pixelColor(area.left() + depth, area.top() + along);
            case Side::Right:
                break;
            }
            return m_image.pixelColor(area.right() - depth, area.top() + along);
        };
        Section section;
        section.outside = at(-3 * m_scale);
        int lastOrange = 0;
        for (int depth = 0; depth < deepest * m_scale; ++depth) {
            const QColor color = at(depth);
            if (!isOrange(color))
                continue;
            lastOrange = depth;
            if (!section.frame.isValid() || color.hsvSaturationF() > section.frame.hsvSaturationF())
                section.frame = color;
        }
        section.inside = at(lastOrange + 1);
        return section;
    }
    template <typename Use> void eachPixel(const QRect& rect, const Use& use) const
    {
        const QRect inside = QRect(rect.topLeft() * m_scale, rect.size() * m_scale)
                                 .intersected(QRect({0, 0}, m_image.size()));
        for (int y = inside.top(); y <= inside.bottom(); ++y) {
            const auto* line = reinterpret_cast<const QRgb*>(m_image.constScanLine(y));
            for (int x = inside.left(); x <= inside.right(); ++x) {
                // Most of a page is grey: that is told without a conversion.
                if (qRed(line[x]) - qBlue(line[x]) > 40)
                    use(QColor(line[x]));
            }
        }
    }
    [[nodiscard]] bool hasOrange(
        const QRect& rect, bool isHorizontal, bool isFirst, int along, int depth) const
    {
        const int size = isHorizontal ? rect.height() : rect.width();
        const int from = isFirst ? 0 : size - depth;
        const QRect strip = isHorizontal ? QRect(rect.x() + along, rect.y() + from, 1, depth)
                                         : QRect(rect.x() + from, rect.y() + along, depth, 1);
        return orangePixels(strip) > 0;
    }

    int m_scale;
    QImage m_image;
};

} // namespace axiscomp::test
