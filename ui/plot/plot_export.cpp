// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/plot_export.h"

#include "core/base/bytes.h"
#include "core/csv/calibration_csv.h"
#include "core/io/local_file.h"
#include "ui/async/background_job.h"
#include "ui/plot/plot_canvas.h"
#include "ui/text/message_text.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileInfo>
#include <QPageSize>
#include <QPdfWriter>
#include <QPicture>

#include "ui/plot/custom_plot.h"

#include <algorithm>

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
    std::shared_ptr<const CompensationTable> mapped; ///< null: a curve
    QCPColorGradient gradient;
    QCPRange range;
    QRectF mapPlace; ///< in the picture's pixels, half a cell beyond the outer points
    QRect clip;
};

QCPColorMap* visibleMap(QCustomPlot& plot)
{
    for (int i = 0; i < plot.plottableCount(); ++i) {
        auto* map = qobject_cast<QCPColorMap*>(plot.plottable(i));
        if (map && map->visible())
            return map;
    }
    return nullptr;
}

QRectF placeOf(const CompensationTable& table, const QCustomPlot& plot)
{
    const auto edges = [](const GridAxis& axis, const QCPAxis& drawn) {
        const double half = axis.distance / 2.0;
        return std::pair(
            drawn.coordToPixel(axis.start - half), drawn.coordToPixel(axis.last() + half));
    };
    const auto [left, right] = edges(table.grid.axes[0], *plot.xAxis);
    const auto [bottom, top] = edges(table.grid.axes[1], *plot.yAxis);
    return {QPointF(left, top), QPointF(right, bottom)};
}

Drawing drawingOf(QCustomPlot& plot, const std::shared_ptr<const CompensationTable>& shown)
{
    Drawing drawing;
    QCPColorMap* map = visibleMap(plot);
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
    if (map) {
        drawing.mapped = shown;
        drawing.gradient = map->gradient();
        drawing.range = map->dataRange();
        drawing.mapPlace = placeOf(*shown, plot);
        drawing.clip = plot.axisRect()->rect();
    }
    setShown(true);
    plot.setViewport(viewport);
    return drawing;
}

QImage mapImage(Drawing& drawing)
{
    const Grid& grid = drawing.mapped->grid;
    const int width = static_cast<int>(grid.axes[0].size);
    const int height = static_cast<int>(grid.axes[1].size);
    QImage image(width, height, QImage::Format_RGB32);
    std::vector<double> row(grid.axes[0].size);
    const float* values = drawing.mapped->values.data();
    for (int y = 0; y < height; ++y, values += width) {
        std::copy_n(values, width, row.begin());
        auto* pixels = reinterpret_cast<QRgb*>(image.scanLine(height - 1 - y));
        drawing.gradient.colorize(row.data(), drawing.range, pixels, width);
    }
    return image;
}

void paintMap(QPainter& painter, Drawing& drawing)
{
    // Larger than the page shows: readers of documents blur small images.
    constexpr int pixelsPerCell = 3;
    const QImage cells = mapImage(drawing);
    const QSize size(std::max(cells.width(), pictureWidth * pixelsPerCell),
        std::max(cells.height(), pictureHeight * pixelsPerCell));
    painter.save();
    painter.setClipRect(drawing.clip);
    painter.drawImage(drawing.mapPlace, cells.scaled(size));
    painter.restore();
}

QString savePdf(Drawing drawing, const QString& path)
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
        if (drawing.mapped)
            paintMap(painter, drawing);
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
