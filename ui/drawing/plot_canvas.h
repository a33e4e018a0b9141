// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/travel_coverage.h"
#include "ui/data/table_view_model.h"

#include <QObject>
#include <QPalette>

#include <array>
#include <memory>
#include <optional>

class QCustomPlot;
class QWidget;

namespace axiscomp::ui {

/// Draws one 1D or 2D table: a curve or a map, with a second curve, a marker, a cross-hair and two
/// cursors on a layer of their own, so that moving them does not draw the map again.
class PlotCanvas : public QObject {
    Q_OBJECT

public:
    explicit PlotCanvas(QWidget* parent);
    ~PlotCanvas() override;
    [[nodiscard]] QCustomPlot& plot();

    /// 1 or 2 dimensions; null clears. second: a muted second curve, 1D only. scale: the symmetric
    /// range of the colours, so that slices of one table share it. The zoom stays as long as the
    /// grid does.
    void show(std::shared_ptr<const CompensationTable> table,
        std::shared_ptr<const CompensationTable> second, double scale);
    void setLabels(const QString& x, const QString& y, const QString& value);
    /// The unit of the numbers beside curve, scale of colours, cross-sections and contours.
    void setValueScale(const ValueScale& scale);
    void setNames(const QString& first, const QString& second);
    void setPalette(const QPalette& palette);
    /// The grid points of a map, where they can be told apart.
    void setGridPointsShown(bool isShown);
    /// Lines of equal value over a map.
    void setContoursShown(bool isShown);
    /// Curves along both axes of a map, through the place of setSectionPoint.
    void setSectionsShown(bool isShown);
    /// None: through the marker, or through the middle without one.
    void setSectionPoint(const std::optional<GridPoint>& point);

    /// In positions of the drawn axes; none hides it. note: what is said beside it, mostly empty.
    void setMarker(const std::optional<std::array<double, 2>>& position, double value,
        const QString& note = {});
    /// How far the axis travels along the drawn axes, in positions of the table; see TravelMark.
    void setTravel(const std::array<std::optional<Travel>, 2>& travel, bool holdsEnds);
    void setTravelTexts(const QString& travel, const QString& table, const QString& held);
    /// Marks what has been proved: the curve between grid points, or the middles of cells of a map.
    /// NaN interrupts a curve. Same sizes; empty hides it.
    void setProved(const QVector<double>& keys, const QVector<double>& values);
    /// Whether points of a map that were made up are hatched, instead of crossed.
    void setFilledHatched(bool isHatched);
    /// Where something was measured, over a map. Same sizes; empty hides it.
    void setMeasured(const QVector<double>& x, const QVector<double>& y);
    void setCrosshair(const std::optional<GridPoint>& point);
    void setCursor(int which, const std::optional<GridPoint>& point); ///< 0 = A, 1 = B

    [[nodiscard]] std::optional<GridPoint> pointAt(const QPointF& pixel) const;
    void resetZoom();
    void zoom(double factor);
    void pan(double x, double y); ///< fractions of what is visible
    /// Moves what is visible, if need be, so that a point is.
    void reveal(const GridPoint& point);
    void replot();

private:
    void showCurve();
    void showMap();
    void showFilled();
    void layOut();
    void showSections();
    void fitValues();
    void placeNote();
    void paintOverlay();

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace axiscomp::ui
