// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grid.h"

#include <QObject>
#include <QPalette>

#include <array>
#include <memory>
#include <optional>

class QCustomPlot;
class QWidget;

namespace axiscomp::ui {

/// A place in the plot, as grid indices of what is drawn (one or two dimensions).
struct PlotPoint {
    std::size_t i = 0;
    std::size_t j = 0;
    friend bool operator==(const PlotPoint&, const PlotPoint&) = default;
};

/// Draws one 1D or 2D table: a curve or a map, with a second curve, a marker, a cross-hair and two
/// cursors on a layer of their own, so that moving them does not draw the map again.
class PlotCanvas : public QObject {
    Q_OBJECT

public:
    explicit PlotCanvas(QWidget* parent);
    ~PlotCanvas() override;
    [[nodiscard]] QCustomPlot& plot();

    /// 1 or 2 dimensions; null clears. second: a muted second curve, 1D only. scale: the symmetric
    /// range of the colours, so that slices of one table share it.
    void show(std::shared_ptr<const CompensationTable> table,
        std::shared_ptr<const CompensationTable> second, double scale);
    [[nodiscard]] const CompensationTable* table() const;
    void setLabels(const QString& x, const QString& y, const QString& value);
    void setNames(const QString& first, const QString& second);
    void setPalette(const QPalette& palette);

    /// In positions of the drawn axes; none hides it.
    void setMarker(const std::optional<std::array<double, 2>>& position, double value);
    void setCrosshair(const std::optional<PlotPoint>& point);
    void setCursor(int which, const std::optional<PlotPoint>& point); ///< 0 = A, 1 = B

    [[nodiscard]] std::optional<PlotPoint> pointAt(const QPointF& pixel) const;
    [[nodiscard]] double valueAt(const PlotPoint& point) const;
    void resetZoom();
    void zoom(double factor);
    void pan(double x, double y); ///< fractions of what is visible
    void replot();

private:
    void showCurve();
    void showMap();
    void paintOverlay();

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace axiscomp::ui
