// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/compensation_table.h"

#include <QImage>

#include "ui/drawing/custom_plot.h"

#include <memory>

namespace axiscomp::ui {

/// Blue below zero, red above, the background's own lightness at zero: equal amounts look equally
/// strong, and the two signs differ for colour-blind eyes too.
[[nodiscard]] QCPColorGradient divergingGradient(bool dark);

/// A 2D table in colours, as the drive interpolates it: each pixel is looked up. Ends where the
/// table ends.
class TableMap : public QCPColorMap {
public:
    explicit TableMap(QCustomPlot& plot);
    void setTable(std::shared_ptr<const CompensationTable> table);

    /// The part of the table that is in sight, in pixels of the plot; empty without one.
    [[nodiscard]] QRectF visiblePlace() const;

protected:
    void draw(QCPPainter* painter) override;

private:
    std::shared_ptr<const CompensationTable> m_table;
};

/// What of a map is in sight, free of the plot: it can be painted on any thread.
struct MapSection {
    std::shared_ptr<const CompensationTable> table;
    QCPColorGradient gradient;
    QCPRange range; ///< of the colours
    QRectF place; ///< in pixels, y downwards
    QCPRange x; ///< positions at the left and the right of it
    QCPRange y; ///< positions at its lower and its upper edge
};
[[nodiscard]] MapSection sectionOf(
    const TableMap& map, const std::shared_ptr<const CompensationTable>& table);
/// size: of the image, which fills the place.
[[nodiscard]] QImage imageOf(MapSection section, const QSize& size);

} // namespace axiscomp::ui
