// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QDateTime>
#include <QFuture>
#include <QImage>
#include <QPicture>
#include <QRectF>
#include <QString>

#include <functional>

class QWidget;

namespace axiscomp::ui {

/// Of what a picture is, as people name it; what is not known is empty.
struct PictureOrigin {
    QString drive;
    QString axis;
    QString file;
};

/// What stands above a saved picture.
struct PictureCaption {
    QString title;
    QString line; ///< "Gantry · axis X · grid.csv · 24.11.2026 14:05"
};
[[nodiscard]] PictureCaption pictureCaption(
    const QString& title, const PictureOrigin& origin, const QDateTime& now);

/// "Gantry X grid.png", without what file names cannot have. kind: what is seen, may be empty.
[[nodiscard]] QString proposedPictureName(const PictureOrigin& origin, const QString& kind);

/// A drawing for a page: lines and letters stay such in documents, what has a colour for each pixel
/// is an image between them.
struct PictureDrawing {
    QPicture below;
    /// Made on another thread, of that many pixels; it refers to nothing that may go away. Empty:
    /// there is no image.
    std::function<QImage(const QSize&)> image;
    QRectF place; ///< of the image
    QPicture above;
};

/// What is drawn has this size, in pixels at 96 to an inch; the caption stands above it.
inline constexpr QSize drawnPictureSize(1000, 600);

/// Whether a picture can be saved under this name: png, svg or pdf.
[[nodiscard]] bool isPictureName(const QString& path);

/// The file is whole or the old one stays; coded and written on another thread. An empty text is
/// success, otherwise a translated sentence.
[[nodiscard]] QFuture<QString> savePicture(
    const PictureDrawing& drawing, const PictureCaption& caption, const QString& path);

/// Asks where to save, then calls save(path) and says what has become of it. proposal: a name
/// without a folder. hasValues: a calibration file is among the choices.
void askForPictureFile(QWidget& parent, const QString& proposal, bool hasValues,
    const std::function<QFuture<QString>(const QString& path)>& save,
    const std::function<void(const QString& sentence)>& say);

} // namespace axiscomp::ui
