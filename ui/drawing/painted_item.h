// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <functional>

#include "ui/drawing/custom_plot.h"

namespace axiscomp::ui {

/// Something of a plot's own that a function paints, in pixels of the plot and within its axes.
class PaintedItem : public QCPAbstractItem {
public:
    using Paint = std::function<void(QCPPainter&, const QRectF& sight)>;

    /// paint: refers to nothing that goes before the plot does. layer: one of the plot's.
    PaintedItem(QCustomPlot& plot, const char* layer, Paint paint);
    double selectTest(const QPointF& pos, bool onlySelectable, QVariant* details) const override;

protected:
    void draw(QCPPainter* painter) override;

private:
    Paint m_paint;
};

/// Words on a background of their own, so that they can be read on whatever is under them. place:
/// of all of it, which is moved into sight.
void paintNote(QCPPainter& painter, QRectF place, const QString& text, const QRectF& sight,
    const QColor& background);
/// The size that paintNote needs.
[[nodiscard]] QSizeF noteSize(const QCPPainter& painter, const QString& text);

} // namespace axiscomp::ui
