// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot_values.h"
#include "ui/table_plot_p.h"
#include "ui/value_text.h"

#include <QComboBox>
#include <QLabel>
#include <QSlider>
#include <QToolButton>

#include <qcustomplot.h>

#include <algorithm>

namespace axiscomp::ui {

namespace {

QString unitOf(const std::string& unit)
{
    return unit.empty() ? QString() : u' ' + QString::fromStdString(unit);
}

QString axisTitle(const Grid& grid, std::size_t dimension)
{
    const QString unit = QString::fromStdString(grid.axes[dimension].unit);
    const QString name = dimensionName(grid, dimension);
    return unit.isEmpty() ? name : name + QStringLiteral(" [") + unit + u']';
}

std::size_t moved(std::size_t index, int step, std::uint32_t size)
{
    const auto last = static_cast<long long>(size) - 1;
    return static_cast<std::size_t>(std::clamp(static_cast<long long>(index) + step, 0LL, last));
}

} // namespace

void TablePlot::retranslate()
{
    d->contentBox->setItemText(0, tr("Selected table"));
    d->contentBox->setItemText(1, tr("Table on the drive"));
    d->contentBox->setItemText(2, tr("Selected - drive"));
    d->contentBox->setToolTip(tr("Which values are shown"));
    d->contentBox->setAccessibleName(tr("Values shown"));
    d->cursorsButton->setText(tr("C&ursors"));
    d->cursorsButton->setToolTip(tr("Two cursors and their difference. Arrow keys move the cursor, "
                                    "Space changes between A and B, a click sets it."));
    d->resetButton->setText(tr("Whole &view"));
    d->resetButton->setToolTip(tr("Show the whole table again (Home). The wheel and + and - zoom, "
                                  "Shift and drag zooms into a rectangle, dragging moves."));
    d->exportButton->setText(tr("Sa&ve picture..."));
    d->exportButton->setToolTip(tr("Save as PNG or PDF, or the values shown as CSV"));
    d->sliceLabel->setText(tr("Cut at"));
    d->sliceSlider->setToolTip(tr("Which slice of the three dimensions is shown"));
    d->sliceSlider->setAccessibleName(tr("Slice"));
    d->sliceBox->setAccessibleName(tr("Dimension that is cut"));
    for (QWidget* widget : std::initializer_list<QWidget*>{d->contentBox, d->cursorsButton,
             d->resetButton, d->exportButton, d->sliceSlider, d->sliceBox})
        widget->setAccessibleDescription(widget->toolTip());
    d->canvas->setNames(tr("selected"), tr("on the drive"));
    QCustomPlot& plot = d->canvas->plot();
    plot.setAccessibleName(tr("Picture of the table"));
    plot.setAccessibleDescription(description());
    if (!d->drawn) {
        d->canvas->setLabels({}, {}, {});
        return;
    }
    const QString value =
        d->content == PlotContent::Difference ? tr("difference") : tr("compensation");
    const Grid& grid = d->drawn->grid;
    d->canvas->setLabels(axisTitle(grid, 0),
        grid.dimensions() == 2 ? axisTitle(grid, 1) : QString(),
        d->drawn->unit.empty()
            ? value
            : value + QStringLiteral(" [") + QString::fromStdString(d->drawn->unit) + u']');
}

QString TablePlot::description() const
{
    if (!d->shown)
        return tr("No table");
    const TableStatistics numbers = statistics(*d->shown);
    const QString unit = unitOf(d->shown->unit);
    QString steps;
    for (std::size_t n = 0; n < d->shown->grid.axes.size(); ++n)
        steps += (n == 0 ? QString() : QStringLiteral(" / "))
            + numberText(d->shown->grid.axes[n].distance);
    return tr("%1, step %2 · min %3, max %4, rms %5")
        .arg(gridText(d->shown->grid), steps, signedNumberText(numbers.minimum) + unit,
            signedNumberText(numbers.maximum) + unit, numberText(numbers.rms) + unit);
}

QString TablePlot::pointText(const CompensationTable& table, std::size_t i, std::size_t j) const
{
    const std::array<std::size_t, 2> index{i, j};
    QString text;
    for (std::size_t n = 0; n < table.grid.axes.size(); ++n)
        text += dimensionName(table.grid, n) + u' '
            + numberText(table.grid.axes[n].position(index[n])) + unitOf(table.grid.axes[n].unit)
            + QStringLiteral(", ");
    return text + signedNumberText(d->canvas->valueAt({i, j})) + unitOf(table.unit);
}

void TablePlot::showReadout()
{
    QString text;
    if (d->drawn && d->hasCursors) {
        const PlotPoint& a = d->cursors[0];
        const PlotPoint& b = d->cursors[1];
        text = tr("A: %1     B: %2     B - A: %3")
                   .arg(pointText(*d->drawn, a.i, a.j), pointText(*d->drawn, b.i, b.j),
                       signedNumberText(d->canvas->valueAt(b) - d->canvas->valueAt(a))
                           + unitOf(d->drawn->unit));
    } else if (d->drawn && d->hovered) {
        text = pointText(*d->drawn, d->hovered->i, d->hovered->j);
    }
    d->readout->setText(text);
    d->readout->setAccessibleName(text);
}

void TablePlot::setCursorsShown(bool isShown)
{
    const bool isFirst = isShown && d->cursors[0] == d->cursors[1];
    d->hasCursors = isShown;
    d->cursorsButton->setChecked(isShown);
    if (isFirst && d->drawn) {
        const Grid& grid = d->drawn->grid;
        const bool isMap = grid.dimensions() == 2;
        d->cursors[0] = {grid.axes[0].size / 4, isMap ? grid.axes[1].size / 4 : 0};
        d->cursors[1] = {grid.axes[0].size * 3 / 4, isMap ? grid.axes[1].size * 3 / 4 : 0};
    }
    for (std::size_t which = 0; which < d->cursors.size(); ++which)
        d->canvas->setCursor(static_cast<int>(which),
            isShown && d->drawn ? std::optional(d->cursors[which]) : std::nullopt);
    showReadout();
}

void TablePlot::toggleCursor()
{
    d->activeCursor = 1 - d->activeCursor;
}

void TablePlot::placeCursor(const QPointF& pixel)
{
    const auto point = d->canvas->pointAt(pixel);
    if (!point)
        return;
    d->cursors[d->activeCursor] = *point;
    setCursorsShown(true);
}

void TablePlot::moveCursor(int stepI, int stepJ)
{
    PlotPoint& cursor = d->cursors[d->activeCursor];
    cursor.i = moved(cursor.i, stepI, d->drawn->grid.axes[0].size);
    if (d->isMap())
        cursor.j = moved(cursor.j, stepJ, d->drawn->grid.axes[1].size);
    d->canvas->setCursor(static_cast<int>(d->activeCursor), cursor);
    showReadout();
}

bool TablePlot::handleKey(int key, Qt::KeyboardModifiers modifiers)
{
    if (!d->drawn || modifiers & (Qt::ControlModifier | Qt::AltModifier))
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
        toggleCursor();
        return d->hasCursors;
    default:
        return false;
    }
}

} // namespace axiscomp::ui
