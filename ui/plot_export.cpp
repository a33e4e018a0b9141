// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot_export.h"

#include "core/bytes.h"
#include "core/calibration_csv.h"
#include "core/local_file.h"
#include "ui/error_text.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileInfo>
#include <QTemporaryDir>

#include <qcustomplot.h>

namespace axiscomp::ui {

namespace {

/// A picture of a page's width: readable when printed.
constexpr int pictureWidth = 1000;
constexpr int pictureHeight = 650;

QString savedAs(const QString& path, ByteView bytes)
{
    const auto saved = saveFile(path.toStdString(), bytes);
    return saved ? QString() : errorText(saved.error());
}

QString saveCsv(const CompensationTable& table, const QString& path)
{
    CalibrationData data;
    data.grid = table.grid;
    data.tables = {table};
    return savedAs(path, asBytes(writeCalibrationCsv(data)));
}

QString savePng(QCustomPlot& plot, const QString& path)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    plot.toPixmap(pictureWidth, pictureHeight, 2.0).save(&buffer, "PNG");
    return savedAs(path, asBytes({bytes.constData(), static_cast<std::size_t>(bytes.size())}));
}

QString savePdf(QCustomPlot& plot, const QString& path)
{
    const QTemporaryDir folder;
    const QString draft = folder.filePath(QStringLiteral("plot.pdf"));
    constexpr std::uint64_t largest = 256ULL * 1024 * 1024;
    plot.savePdf(draft, pictureWidth, pictureHeight);
    const auto bytes = loadFile(draft.toStdString(), largest);
    return bytes ? savedAs(path, *bytes) : errorText(bytes.error());
}

} // namespace

QString exportPlot(QCustomPlot& plot, const CompensationTable& shown, const QString& path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    if (ending == u"png")
        return savePng(plot, path);
    if (ending == u"pdf")
        return savePdf(plot, path);
    if (ending == u"csv")
        return saveCsv(shown, path);
    return QCoreApplication::translate("TablePlot",
        "The file's name must end in .png, .pdf or .csv, so that its format is known.");
}

} // namespace axiscomp::ui
