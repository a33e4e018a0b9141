// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drawing/plot_export.h"

#include "core/base/bytes.h"
#include "core/csv/calibration_csv.h"
#include "core/io/local_file.h"
#include "ui/async/background_job.h"
#include "ui/text/message_text.h"

#include "ui/drawing/custom_plot.h"
#include "ui/drawing/table_map.h"

namespace axiscomp::ui {

namespace {

TableMap* visibleMap(QCustomPlot& plot)
{
    for (int i = 0; i < plot.plottableCount(); ++i) {
        auto* map = dynamic_cast<TableMap*>(plot.plottable(i));
        if (map && map->visible())
            return map;
    }
    return nullptr;
}

} // namespace

PictureDrawing drawingOf(QCustomPlot& plot, const std::shared_ptr<const CompensationTable>& shown)
{
    PictureDrawing drawing;
    TableMap* map = visibleMap(plot);
    const QRect viewport = plot.viewport();
    plot.setViewport(QRect(QPoint(), drawnPictureSize));
    plot.setBackground(QBrush(Qt::NoBrush));
    // The map is painted first and the lines over it: its grid would be seen through.
    const auto setShown = [&](bool isShown) {
        if (!map)
            return;
        map->setVisible(isShown);
        plot.xAxis->grid()->setVisible(isShown);
        plot.yAxis->grid()->setVisible(isShown);
    };
    setShown(false);
    {
        QCPPainter painter(&drawing.above);
        plot.toPainter(&painter, drawnPictureSize.width(), drawnPictureSize.height());
    }
    if (map && shown) {
        const MapSection section = sectionOf(*map, shown);
        drawing.place = section.place;
        drawing.image = [section](const QSize& size) { return imageOf(section, size); };
    }
    setShown(true);
    plot.setViewport(viewport);
    return drawing;
}

QFuture<QString> saveValues(std::shared_ptr<const CompensationTable> table,
    std::vector<std::string> notes, const QString& path)
{
    return inBackground<QString>([table = std::move(table), notes = std::move(notes), path] {
        const auto saved = saveFile(path.toStdString(),
            asBytes(writeCalibrationCsv(CalibrationData{table->grid, {*table}, notes})));
        return saved ? QString() : errorText(saved.error());
    });
}

} // namespace axiscomp::ui
