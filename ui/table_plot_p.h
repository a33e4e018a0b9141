// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "ui/plot_canvas.h"
#include "ui/table_plot.h"

class QComboBox;
class QLabel;
class QSlider;
class QToolButton;

namespace axiscomp::ui {

struct TablePlot::Private {
    std::shared_ptr<const CompensationTable> selected;
    std::shared_ptr<const CompensationTable> onDrive;
    std::shared_ptr<const CompensationTable> shown; ///< of the chosen content, all dimensions
    std::shared_ptr<const CompensationTable> drawn; ///< shown, or its slice
    PlotContent content = PlotContent::Selected;
    std::optional<Marker> marker;
    std::size_t cut = 2; ///< dimension that is cut, from 0
    bool hasCursors = false;
    std::size_t activeCursor = 0;
    std::array<PlotPoint, 2> cursors;
    std::optional<PlotPoint> hovered;

    QComboBox* contentBox = nullptr;
    QToolButton* cursorsButton = nullptr;
    QToolButton* resetButton = nullptr;
    QToolButton* exportButton = nullptr;
    PlotCanvas* canvas = nullptr;
    QWidget* sliceRow = nullptr;
    QLabel* sliceLabel = nullptr;
    QComboBox* sliceBox = nullptr;
    QSlider* sliceSlider = nullptr;
    QLabel* sliceValue = nullptr;
    QLabel* readout = nullptr;

    [[nodiscard]] bool isCut() const { return shown && shown->grid.dimensions() == 3; }
    [[nodiscard]] bool isMap() const { return drawn && drawn->grid.dimensions() == 2; }
    /// The table's dimension behind the drawn axis 0 or 1.
    [[nodiscard]] std::size_t dimensionOf(std::size_t drawnAxis) const
    {
        return isCut() && drawnAxis >= cut ? drawnAxis + 1 : drawnAxis;
    }
};

} // namespace axiscomp::ui
