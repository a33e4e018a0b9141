// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drawing/plot_export.h"

#include "core/base/bytes.h"
#include "core/csv/calibration_csv.h"
#include "core/io/local_file.h"
#include "ui/async/background_job.h"
#include "ui/drawing/plot_canvas.h"
#include "ui/text/message_text.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileInfo>
#include <QPageSize>
#include <QPdfWriter>
#include <QPicture>

#include "ui/drawing/custom_plot.h"
#include "ui/drawing/table_map.h"

namespace axiscomp::ui {

namespace {

/// A picture of a page's width: readable when printed.
constexpr int pictureWidth = 1000;
constexpr int pictureHeight = 650;
constexpr double pixelsPerInch = 96.0;

QString savedAs(const QString& path, ByteView bytes)
{
    const auto saved = saveFile(path.toStdString(), bytes);
    return saved ? QString() : errorText(saved.error());
}

QString savedAs(const QString& path, const QByteArray& bytes)
{
    return savedAs(path, asBytes({bytes.constData(), static_cast<std::size_t>(bytes.size())}));
}

QString saveCsv(const CompensationTable& table, const QString& path)
{
    CalibrationData data;
    data.grid = table.grid;
    data.tables = {table};
    return savedAs(path, asBytes(writeCalibrationCsv(data)));
}

QString savePng(const QImage& image, const QString& path)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    image.save(&buffer, "PNG");
    return savedAs(path, bytes);
}

/// A picture in lines and letters; the map apart from it, because coding its cells takes long.
struct Drawing {
    QPicture lines;
    MapSection map; ///< without a table: a curve
};

TableMap* visibleMap(QCustomPlot& plot)
{
    for (int i = 0; i < plot.plottableCount(); ++i) {
        auto* map = dynamic_cast<TableMap*>(plot.plottable(i));
        if (map && map->visible())
            return map;
    }
    return nullptr;
}

Drawing drawingOf(QCustomPlot& plot, const std::shared_ptr<const CompensationTable>& shown)
{
    Drawing drawing;
    TableMap* map = visibleMap(plot);
    const QRect viewport = plot.viewport();
    plot.setViewport(QRect(0, 0, pictureWidth, pictureHeight));
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
        QCPPainter painter(&drawing.lines);
        plot.toPainter(&painter, pictureWidth, pictureHeight);
    }
    if (map)
        drawing.map = sectionOf(*map, shown);
    setShown(true);
    plot.setViewport(viewport);
    return drawing;
}

void paintMap(QPainter& painter, const MapSection& map)
{
    // Larger than the page shows: readers of documents blur small images.
    constexpr double pixelsPerPixel = 3.0;
    if (map.place.isEmpty())
        return;
    painter.drawImage(map.place, imageOf(map, (map.place.size() * pixelsPerPixel).toSize()));
}

QString savePdf(const Drawing& drawing, const QString& path)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    {
        QPdfWriter writer(&buffer);
        constexpr double pointsPerPixel = 72.0 / pixelsPerInch;
        writer.setResolution(static_cast<int>(pixelsPerInch));
        writer.setPageMargins(QMarginsF());
        writer.setPageSize(QPageSize(QSizeF(pictureWidth, pictureHeight) * pointsPerPixel,
            QPageSize::Point, QString(), QPageSize::ExactMatch));
        QPainter painter(&writer);
        if (drawing.map.table)
            paintMap(painter, drawing.map);
        painter.drawPicture(0, 0, drawing.lines);
    }
    return savedAs(path, bytes);
}

} // namespace

QFuture<QString> exportPlot(
    PlotCanvas& canvas, std::shared_ptr<const CompensationTable> shown, const QString& path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    const bool isPicture = ending == u"png" || ending == u"pdf";
    if (!shown || (!isPicture && ending != u"csv"))
        return inBackground<QString>(
            [problem = shown ? QCoreApplication::translate(
                           "TablePlot", "The file name must end in .png, .pdf or .csv.")
                             : QCoreApplication::translate(
                                 "TablePlot", "There is no table to save.")] { return problem; });
    if (!isPicture)
        return inBackground<QString>([shown, path] { return saveCsv(*shown, path); });
    QCustomPlot& plot = canvas.plot();
    canvas.setPalette(QPalette(Qt::white));
    QImage image;
    Drawing drawing;
    if (ending == u"png")
        image = plot.toPixmap(pictureWidth, pictureHeight, 2.0).toImage();
    else
        drawing = drawingOf(plot, shown);
    canvas.setPalette(plot.palette());
    canvas.replot();
    return inBackground<QString>([image, drawing, path] {
        return image.isNull() ? savePdf(drawing, path) : savePng(image, path);
    });
}

} // namespace axiscomp::ui
