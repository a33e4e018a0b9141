// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot/table_plot.h"

#include <QWidget>

#include <memory>
#include <optional>

namespace axiscomp::ui {

class TableViewModel;
struct SurfaceColors;
struct SurfaceSight;

/// A 2D table, or the slice of a 3D one, as a surface that is turned by mouse and arrow keys. The
/// errors are drawn larger than they are, by a factor that is shown and can be chosen. Coarser
/// while it turns; the whole table follows from another thread.
class SurfaceView : public QWidget {
    Q_OBJECT

public:
    /// shown must outlive the view.
    explicit SurfaceView(TableViewModel& shown, QWidget* parent = nullptr);
    ~SurfaceView() override;

    /// Where the axis is; none hides it.
    void setMarker(const std::optional<TablePlot::Marker>& marker);
    void setOrigin(const PictureOrigin& origin);
    /// As TablePlot::exportTo, without values.
    [[nodiscard]] QFuture<QString> exportTo(const QString& path) const;
    /// How many times too high heights are drawn.
    [[nodiscard]] double exaggeration() const;
    /// True when what is seen has every grid point.
    [[nodiscard]] bool isWhole() const;
    void retranslate();

protected:
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;
    void changeEvent(QEvent* event) override; ///< palette and language

private:
    void build();
    void showTable();
    void showHeights();
    void turn(double byTurn, double byTilt);
    void zoom(double factor);
    void resetSight();
    void sightChanged();
    void drawWhole();
    void paintAbove(
        QPainter& painter, const SurfaceSight& sight, const SurfaceColors& colors) const;
    void paintPlaces(
        QPainter& painter, const SurfaceSight& sight, const SurfaceColors& colors) const;
    void askForExport();
    [[nodiscard]] bool canDraw() const;

    struct Private;
    std::unique_ptr<Private> d;
};

} // namespace axiscomp::ui
