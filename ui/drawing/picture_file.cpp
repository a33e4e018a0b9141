// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drawing/picture_file.h"

#include "core/base/bytes.h"
#include "core/io/local_file.h"
#include "ui/async/background_job.h"
#include "ui/style/contrast.h"
#include "ui/text/message_text.h"

#include <QBuffer>
#include <QCoreApplication>
#include <QFileDialog>
#include <QFileInfo>
#include <QLocale>
#include <QPageSize>
#include <QPainter>
#include <QPdfWriter>
#include <QSvgGenerator>

#include <cmath>

namespace axiscomp::ui {

namespace {

constexpr double pixelsPerInch = 96.0;
constexpr int captionHeight = 50;
constexpr QSize pageSize(drawnPictureSize.width(), drawnPictureSize.height() + captionHeight);

QString words(const char* text)
{
    return QCoreApplication::translate("PictureFile", text);
}

void paintCaption(QPainter& painter, const PictureCaption& caption)
{
    const QRectF place(14.0, 6.0, pageSize.width() - 28.0, captionHeight - 6.0);
    QFont font = painter.font();
    constexpr int titlePixels = 17;
    constexpr int linePixels = 13;
    font.setPixelSize(titlePixels);
    font.setBold(true);
    painter.setFont(font);
    painter.setPen(Qt::black);
    const auto shown = [&](const QString& text) {
        return QFontMetricsF(painter.font()).elidedText(text, Qt::ElideMiddle, place.width());
    };
    painter.drawText(place, Qt::AlignLeft | Qt::AlignTop, shown(caption.title));
    font.setPixelSize(linePixels);
    font.setBold(false);
    painter.setFont(font);
    painter.drawText(place, Qt::AlignLeft | Qt::AlignBottom, shown(caption.line));
}

/// pixelsPerPixel: of the image, which may be finer than the page.
void paintPage(QPainter& painter, const PictureDrawing& drawing, const PictureCaption& caption,
    double pixelsPerPixel)
{
    painter.fillRect(QRect(QPoint(), pageSize), Qt::white);
    painter.setRenderHint(QPainter::Antialiasing);
    paintCaption(painter, caption);
    painter.translate(0.0, captionHeight);
    painter.drawPicture(0, 0, drawing.below);
    if (drawing.image && !drawing.place.isEmpty())
        painter.drawImage(
            drawing.place, drawing.image((drawing.place.size() * pixelsPerPixel).toSize()));
    painter.drawPicture(0, 0, drawing.above);
}

// Larger than the page shows: readers of documents blur small images.
constexpr double documentPixels = 3.0;

QByteArray pdf(const PictureDrawing& drawing, const PictureCaption& caption)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    QPdfWriter writer(&buffer);
    constexpr double pointsPerPixel = 72.0 / pixelsPerInch;
    writer.setResolution(static_cast<int>(pixelsPerInch));
    writer.setPageMargins(QMarginsF());
    writer.setPageSize(QPageSize(
        QSizeF(pageSize) * pointsPerPixel, QPageSize::Point, QString(), QPageSize::ExactMatch));
    writer.setTitle(caption.title);
    QPainter painter(&writer);
    paintPage(painter, drawing, caption, documentPixels);
    painter.end();
    return bytes;
}

QByteArray svg(const PictureDrawing& drawing, const PictureCaption& caption)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    QSvgGenerator generator;
    generator.setOutputDevice(&buffer);
    generator.setResolution(static_cast<int>(pixelsPerInch));
    generator.setSize(pageSize);
    generator.setViewBox(QRect(QPoint(), pageSize));
    generator.setTitle(caption.title);
    generator.setDescription(caption.line);
    QPainter painter(&generator);
    paintPage(painter, drawing, caption, documentPixels);
    painter.end();
    return bytes;
}

QByteArray png(const PictureDrawing& drawing, const PictureCaption& caption)
{
    constexpr double pixels = 2.0;
    constexpr double inchesPerMetre = 1.0 / 0.0254;
    QImage image(pageSize * pixels, QImage::Format_RGB32);
    const int dots = static_cast<int>(std::round(pixelsPerInch * inchesPerMetre));
    image.setDotsPerMeterX(dots);
    image.setDotsPerMeterY(dots);
    QPainter painter(&image);
    painter.scale(pixels, pixels);
    paintPage(painter, drawing, caption, pixels);
    painter.end();
    image.setText(QStringLiteral("Title"), caption.title);
    image.setText(QStringLiteral("Description"), caption.line);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    image.save(&buffer, "PNG");
    return bytes;
}

QString savedAs(const QString& path, const QByteArray& bytes)
{
    const auto saved = saveFile(
        path.toStdString(), asBytes({bytes.constData(), static_cast<std::size_t>(bytes.size())}));
    return saved ? QString() : errorText(saved.error());
}

} // namespace

PictureCaption pictureCaption(
    const QString& title, const PictureOrigin& origin, const QDateTime& now)
{
    QStringList parts{origin.drive,
        origin.axis.isEmpty() ? QString()
                              : words(QT_TRANSLATE_NOOP("PictureFile", "axis %1")).arg(origin.axis),
        origin.file, QLocale().toString(now, QLocale::ShortFormat)};
    parts.removeAll(QString());
    return {title, parts.join(QStringLiteral(" · "))};
}

QString proposedPictureName(const PictureOrigin& origin, const QString& kind)
{
    QStringList parts{origin.drive, origin.axis, QFileInfo(origin.file).completeBaseName(), kind};
    parts.removeAll(QString());
    QString name = parts.join(u' ');
    for (QChar& letter : name)
        if (!letter.isPrint() || QStringView(u"/\\:*?\"<>|").contains(letter))
            letter = u'_';
    constexpr qsizetype longest = 100;
    name = name.left(longest).trimmed();
    return (name.isEmpty() ? words(QT_TRANSLATE_NOOP("PictureFile", "picture")) : name)
        + QStringLiteral(".png");
}

bool isPictureName(const QString& path)
{
    const QString ending = QFileInfo(path).suffix().toLower();
    return ending == u"png" || ending == u"svg" || ending == u"pdf";
}

QFuture<QString> savePicture(
    const PictureDrawing& drawing, const PictureCaption& caption, const QString& path)
{
    if (!isPictureName(path))
        return inBackground<QString>(
            [problem = words(QT_TRANSLATE_NOOP("PictureFile",
                 "The file name must end in .png, .svg or .pdf."))] { return problem; });
    return inBackground<QString>([drawing, caption, path] {
        const QString ending = QFileInfo(path).suffix().toLower();
        const auto coded = ending == u"pdf" ? pdf : ending == u"svg" ? svg : png;
        return savedAs(path, coded(drawing, caption));
    });
}

void askForPictureFile(QWidget& parent, const QString& proposal, bool hasValues,
    const std::function<QFuture<QString>(const QString& path)>& save,
    const std::function<void(const QString& sentence)>& say)
{
    auto* dialog = new QFileDialog(&parent,
        hasValues ? words(QT_TRANSLATE_NOOP("PictureFile", "Save picture or values"))
                  : words(QT_TRANSLATE_NOOP("PictureFile", "Save picture")));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    QStringList filters{words(QT_TRANSLATE_NOOP("PictureFile", "Picture (*.png)")),
        words(QT_TRANSLATE_NOOP("PictureFile", "Drawing (*.svg)")),
        words(QT_TRANSLATE_NOOP("PictureFile", "Document (*.pdf)"))};
    if (hasValues)
        filters += words(QT_TRANSLATE_NOOP("PictureFile", "Values (*.csv)"));
    dialog->setNameFilters(filters);
    dialog->setDefaultSuffix(QStringLiteral("png"));
    dialog->selectFile(proposal);
    QObject::connect(
        dialog, &QFileDialog::filterSelected, dialog, [dialog, proposal](const QString& filter) {
            const QString ending = filter.section(u'.', -1).chopped(1);
            dialog->setDefaultSuffix(ending);
            dialog->selectFile(QFileInfo(proposal).completeBaseName() + u'.' + ending);
        });
    QObject::connect(
        dialog, &QFileDialog::fileSelected, &parent, [&parent, save, say](const QString& path) {
            whenDone(save(path), &parent, [say, path](const QString& problem) {
                say(problem.isEmpty()
                        ? words(QT_TRANSLATE_NOOP("PictureFile", "Saved as %1")).arg(path)
                        : problem);
            });
        });
    dialog->open();
}

} // namespace axiscomp::ui
