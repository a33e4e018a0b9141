// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/drawing/plot_canvas.h"
#include "ui/plot/table_plot.h"

#include <QPointF>

class QAction;
class QHBoxLayout;
class QLabel;
class QToolButton;

namespace axiscomp::ui {

class TableContentCombo;
class SliceRow;

struct TablePlot::Private {
    explicit Private(TableViewModel& shownTable) : shown(shownTable) { }

    TableViewModel& shown;
    PictureOrigin origin;
    ValuesOrigin values;
    std::optional<Marker> marker;
    std::array<std::optional<Travel>, 3> travel;
    bool holdsEnds = true;
    std::optional<ProvedPart> proved; ///< of the table on the drive
    std::vector<std::array<double, 3>> measured;
    bool hasCursors = false;
    std::size_t activeCursor = 0;
    std::array<GridPoint, 2> cursors;
    std::optional<GridPoint> hovered;
    QPointF pressed; ///< where the mouse button went down

    TableContentCombo* contentBox = nullptr;
    QHBoxLayout* tools = nullptr;
    QToolButton* showButton = nullptr; ///< its menu has what a map can show besides
    QAction* pointsAction = nullptr;
    QAction* contoursAction = nullptr;
    QAction* sectionsAction = nullptr;
    QToolButton* cursorsButton = nullptr;
    QToolButton* resetButton = nullptr;
    QToolButton* exportButton = nullptr;
    PlotCanvas* canvas = nullptr;
    SliceRow* slice = nullptr;
    QLabel* readout = nullptr;

    [[nodiscard]] bool isMap() const
    {
        return shown.drawn() && shown.drawn()->grid.dimensions() == 2;
    }
};

} // namespace axiscomp::ui
