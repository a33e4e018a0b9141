// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/slice_row.h"
#include "ui/plot/table_content_combo.h"
#include "ui/plot/table_plot_p.h"
#include "ui/text/value_text.h"

#include <QAction>
#include <QLabel>
#include <QToolButton>

#include "ui/drawing/custom_plot.h"

#include <algorithm>

namespace axiscomp::ui {

namespace {

std::size_t moved(std::size_t index, int step, std::uint32_t size)
{
    const auto last = static_cast<long long>(size) - 1;
    return static_cast<std::size_t>(std::clamp(static_cast<long long>(index) + step, 0LL, last));
}

/// The way from a to b: "X +20 mm, Y -10 mm, "
QString distanceText(const TableViewModel& shown, const GridPoint& a, const GridPoint& b)
{
    const Grid& grid = shown.drawn()->grid;
    const std::array<double, 2> steps{static_cast<double>(b.i) - static_cast<double>(a.i),
        static_cast<double>(b.j) - static_cast<double>(a.j)};
    QString text;
    for (std::size_t n = 0; n < grid.axes.size(); ++n)
        text += shown.nameOf(n) + u' ' + signedNumberText(steps[n] * grid.axes[n].distance)
            + unitSuffix(grid.axes[n].unit) + QStringLiteral(", ");
    return text;
}

} // namespace

void TablePlot::retranslate()
{
    d->contentBox->retranslate();
    d->slice->retranslate();
    d->showButton->setText(tr("Show"));
    constexpr int arrow = 14; // the style draws it over the text
    d->showButton->setMinimumWidth(d->showButton->sizeHint().width() + arrow);
    d->showButton->setToolTip(tr("What is drawn over the map"));
    d->pointsAction->setText(tr("&Grid points"));
    d->pointsAction->setToolTip(tr("The points of the table, where they are far enough apart"));
    d->contoursAction->setText(tr("&Contours"));
    d->contoursAction->setToolTip(tr("Lines of equal value"));
    d->sectionsAction->setText(tr("Cross-&sections"));
    d->sectionsAction->setToolTip(tr("The values along both axes through the cross-hair or the "
                                     "cursor, or else through the position of the axis"));
    d->cursorsButton->setText(tr("C&ursors"));
    d->cursorsButton->setToolTip(tr("Two cursors and their difference. Arrow keys move the cursor, "
                                    "Space changes between A and B, a click sets it."));
    d->resetButton->setText(tr("W&hole view"));
    d->resetButton->setToolTip(tr("Show the whole table again (Home or a double click). The wheel "
                                  "and + and - zoom, Shift and drag zooms into a rectangle, "
                                  "dragging moves."));
    d->exportButton->setText(tr("Save picture…"));
    d->exportButton->setToolTip(tr("Save as PNG, SVG or PDF, or the values shown as CSV"));
    for (QToolButton* button : {d->showButton, d->cursorsButton, d->resetButton, d->exportButton})
        button->setAccessibleDescription(button->toolTip());
    d->canvas->setNames(tr("selected"), tr("on the drive"));
    d->canvas->setTravelTexts(tr("travel"), tr("table"), tr("end value held"));
    QCustomPlot& plot = d->canvas->plot();
    plot.setAccessibleName(tr("Picture of the table"));
    plot.setAccessibleDescription(d->shown.description());
    const auto& table = d->shown.drawn();
    if (!table) {
        d->canvas->setLabels({}, {}, {});
        return;
    }
    const auto axisTitle = [this](std::size_t drawnAxis) {
        return withUnit(d->shown.nameOf(drawnAxis), d->shown.drawn()->grid.axes[drawnAxis].unit);
    };
    const QString value =
        d->shown.content() == TableContent::Difference ? tr("difference") : tr("compensation");
    d->canvas->setLabels(axisTitle(0), d->isMap() ? axisTitle(1) : QString(),
        withUnit(value, d->shown.valueScale().unit()));
}

void TablePlot::showCurrent()
{
    const std::optional<GridPoint>& current = d->shown.current();
    if (d->hasCursors && current && *current != d->cursors[d->activeCursor]) {
        d->cursors[d->activeCursor] = *current;
        d->canvas->setCursor(static_cast<int>(d->activeCursor), current);
    }
    d->canvas->setSectionPoint(d->hasCursors ? std::optional(d->cursors[d->activeCursor])
            : d->hovered                     ? d->hovered
                                             : current);
    d->canvas->setCrosshair(d->hasCursors ? std::nullopt : d->hovered ? d->hovered : current);
    showReadout();
}

void TablePlot::currentChanged()
{
    showCurrent();
    if (d->shown.current() && !d->hovered)
        d->canvas->reveal(*d->shown.current());
}

void TablePlot::showReadout()
{
    QString text;
    const auto& table = d->shown.drawn();
    const auto place = d->hovered ? d->hovered : d->shown.current();
    if (table && d->hasCursors) {
        const auto [a, b] = d->cursors;
        const double difference =
            static_cast<double>(d->shown.valueAt(b)) - static_cast<double>(d->shown.valueAt(a));
        text =
            tr("A: %1     B: %2\nB - A: %3")
                .arg(d->shown.pointText(a), d->shown.pointText(b),
                    distanceText(d->shown, a, b) + d->shown.valueScale().textWithUnit(difference));
    } else if (table && place) {
        text = d->shown.pointText(*place);
    }
    d->readout->setText(text);
    d->readout->setToolTip(text);
    d->readout->setAccessibleName(text);
}

void TablePlot::setCursorsShown(bool isShown)
{
    d->hasCursors = isShown;
    d->cursorsButton->setChecked(isShown);
    const auto& table = d->shown.drawn();
    if (isShown && table) {
        const std::uint32_t sizeI = table->grid.axes[0].size;
        const std::uint32_t sizeJ = d->isMap() ? table->grid.axes[1].size : 1;
        for (GridPoint& cursor : d->cursors)
            cursor = {moved(cursor.i, 0, sizeI), moved(cursor.j, 0, sizeJ)};
        if (d->cursors[0] == d->cursors[1])
            d->cursors = {GridPoint{sizeI / 4, sizeJ / 4}, GridPoint{sizeI * 3 / 4, sizeJ * 3 / 4}};
    }
    for (std::size_t which = 0; which < d->cursors.size(); ++which)
        d->canvas->setCursor(static_cast<int>(which),
            isShown && table ? std::optional(d->cursors[which]) : std::nullopt);
    showCurrent();
}

void TablePlot::moveCursor(int stepI, int stepJ)
{
    GridPoint cursor = d->cursors[d->activeCursor];
    const Grid& grid = d->shown.drawn()->grid;
    cursor.i = moved(cursor.i, stepI, grid.axes[0].size);
    if (d->isMap())
        cursor.j = moved(cursor.j, stepJ, grid.axes[1].size);
    d->hovered.reset();
    d->shown.setCurrent(cursor);
}

bool TablePlot::handleKey(int key, Qt::KeyboardModifiers modifiers)
{
    if (!d->shown.drawn() || modifiers & (Qt::ControlModifier | Qt::AltModifier))
        return false;
    constexpr double zoomStep = 0.8;
    constexpr double panStep = 0.1;
    const auto arrow = [&](int x, int y) {
        if (d->hasCursors)
            moveCursor(x, y);
        else
            d->canvas->pan(x * panStep, y * panStep);
        return true;
    };
    switch (key) {
    case Qt::Key_Left:
        return arrow(-1, 0);
    case Qt::Key_Right:
        return arrow(1, 0);
    case Qt::Key_Up:
        return arrow(0, 1);
    case Qt::Key_Down:
        return arrow(0, -1);
    case Qt::Key_Plus:
        d->canvas->zoom(zoomStep);
        return true;
    case Qt::Key_Minus:
        d->canvas->zoom(1.0 / zoomStep);
        return true;
    case Qt::Key_Home:
        d->canvas->resetZoom();
        return true;
    case Qt::Key_Space:
        if (!d->hasCursors)
            return false;
        d->activeCursor = 1 - d->activeCursor;
        d->shown.setCurrent(d->cursors[d->activeCursor]);
        return true;
    case Qt::Key_Escape:
        if (!d->shown.current())
            return false;
        d->shown.setCurrent(std::nullopt);
        return true;
    default:
        return false;
    }
}

} // namespace axiscomp::ui
