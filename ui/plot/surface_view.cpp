// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/surface_view.h"

#include "core/table/lookup.h"
#include "ui/async/background_job.h"
#include "ui/data/table_view_model.h"
#include "ui/drawing/surface_axes.h"
#include "ui/drawing/surface_image.h"
#include "ui/drawing/table_map.h"
#include "ui/plot/exaggeration_combo.h"
#include "ui/plot/slice_row.h"
#include "ui/plot/table_content_combo.h"
#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>
#include <QTimer>
#include <QToolButton>
#include <QToolTip>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace axiscomp::ui {

namespace {

constexpr double firstTurn = 30.0;
constexpr double firstTilt = 35.0;
constexpr int samplesWhileTurning = 100;
constexpr int allSamples = 4096;
constexpr double zoomStep = 1.25;

SurfaceSight finer(SurfaceSight sight, double ratio)
{
    sight.size = (QSizeF(sight.size) * ratio).toSize();
    sight.ratio = ratio;
    return sight;
}

} // namespace

struct SurfaceColors {
    explicit SurfaceColors(const QPalette& palette)
        : isDark(palette.color(QPalette::Base).lightness() < 128)
        , text(palette.color(QPalette::Text))
        , muted(mutedTextColor(palette))
        , base(palette.color(QPalette::Base))
        , marker(isDark ? QColor(255, 200, 60) : QColor(120, 60, 0))
    {
    }

    bool isDark;
    QColor text;
    QColor muted;
    QColor base;
    QColor marker;
};

namespace {

QImage imageOf(const SurfaceSight& sight, const SurfaceColors& colors, double scale, int samples)
{
    return surfaceImage(
        sight, divergingGradient(colors.isDark), QCPRange(-scale, scale), colors.text, samples);
}

} // namespace

struct SurfaceView::Private {
    explicit Private(TableViewModel& shownTable) : shown(shownTable) { }

    TableViewModel& shown;
    std::optional<TablePlot::Marker> marker;
    TableContentCombo* contentBox = nullptr;
    QLabel* heightLabel = nullptr;
    ExaggerationCombo* height = nullptr;
    QToolButton* reset = nullptr;
    QToolButton* save = nullptr;
    PictureOrigin origin;
    QWidget* space = nullptr; ///< where the surface is drawn
    SliceRow* slice = nullptr;
    QTimer pause; ///< after the last turn
    SurfaceSight sight;
    double scale = 1.0; ///< of the colours
    QPointF dragged;
    QImage image;
    bool isWhole = false;
    std::unique_ptr<NewestJob<QImage>> whole;
};

SurfaceView::SurfaceView(TableViewModel& shown, QWidget* parent)
    : QWidget(parent)
    , d(std::make_unique<Private>(shown))
{
    build();
    d->whole = std::make_unique<NewestJob<QImage>>([this](const QImage& image) {
        d->image = image;
        d->isWhole = true;
        update();
    });
    d->pause.setSingleShot(true);
    constexpr int pauseMs = 30;
    d->pause.setInterval(pauseMs);
    connect(&d->pause, &QTimer::timeout, this, &SurfaceView::drawWhole);
    connect(&d->shown, &TableViewModel::changed, this, &SurfaceView::showTable);
    connect(&d->shown, &TableViewModel::currentChanged, this, qOverload<>(&QWidget::update));
    connect(d->height, &ExaggerationCombo::factorChanged, this, &SurfaceView::sightChanged);
    connect(d->reset, &QToolButton::clicked, this, &SurfaceView::resetSight);
    connect(d->save, &QToolButton::clicked, this, &SurfaceView::askForExport);
    retranslate();
    showTable();
}

SurfaceView::~SurfaceView() = default;

void SurfaceView::build()
{
    setFocusPolicy(Qt::StrongFocus);
    d->contentBox = new TableContentCombo(d->shown, this);
    d->contentBox->setObjectName(QStringLiteral("surfaceContent"));
    constexpr int letters = 5; // as narrow as the page may be
    d->contentBox->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
    d->contentBox->setMinimumContentsLength(letters);
    d->contentBox->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
    constexpr int widest = 160;
    d->contentBox->setMaximumWidth(widest);
    d->heightLabel = new PlainLabel(this);
    d->height = new ExaggerationCombo(this);
    d->height->setObjectName(QStringLiteral("surfaceExaggeration"));
    d->heightLabel->setBuddy(d->height);
    d->reset = new QToolButton(this);
    d->reset->setObjectName(QStringLiteral("surfaceReset"));
    d->save = new QToolButton(this);
    d->save->setObjectName(QStringLiteral("surfaceExport"));
    for (QToolButton* button : {d->reset, d->save}) {
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::StrongFocus);
    }
    d->space = new QWidget(this);
    d->space->setMinimumSize(260, 90);
    d->space->setAttribute(Qt::WA_TransparentForMouseEvents);
    d->slice = new SliceRow(d->shown, this);
    auto* tools = new QHBoxLayout;
    constexpr int share = 100; // what room there is goes to the names of the tables first
    tools->addWidget(d->contentBox, share);
    tools->addStretch(1);
    tools->addWidget(d->heightLabel);
    tools->addWidget(d->height);
    tools->addWidget(d->reset);
    tools->addWidget(d->save);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    layout->addLayout(tools);
    layout->addWidget(d->space, 1);
    layout->addWidget(d->slice);
}

void SurfaceView::retranslate()
{
    d->contentBox->retranslate();
    d->slice->retranslate();
    d->height->retranslate();
    d->heightLabel->setText(tr("Heights"));
    showHeights();
    d->reset->setText(tr("First view"));
    d->reset->setToolTip(
        tr("See the surface as at first (Home or a double click). Arrow keys and dragging turn it, "
           "the wheel, Page Up and Page Down zoom."));
    d->save->setText(tr("Save picture…"));
    d->save->setToolTip(tr("Save as PNG, SVG or PDF"));
    for (QToolButton* button : {d->reset, d->save})
        button->setAccessibleDescription(button->toolTip());
    setAccessibleName(tr("Surface of the table"));
    setAccessibleDescription(d->shown.description());
    update();
}

bool SurfaceView::canDraw() const
{
    return d->sight.table != nullptr;
}

void SurfaceView::showTable()
{
    const auto& drawn = d->shown.drawn();
    const bool isSurface = drawn && drawn->grid.dimensions() == 2;
    d->sight.table = isSurface ? drawn : nullptr;
    d->scale = d->shown.scale();
    for (QToolButton* button : {d->reset, d->save})
        button->setEnabled(isSurface);
    // All slices of a table stand in the same box.
    if (isSurface) {
        const auto [low, high] = std::ranges::minmax(d->shown.table()->values);
        d->sight.heights = {static_cast<double>(low), static_cast<double>(high)};
        if (!(high > low))
            d->sight.heights = {d->sight.heights[0] - d->scale, d->sight.heights[1] + d->scale};
        d->height->setFitting(fittingExaggeration(*drawn, d->sight.heights));
    }
    showHeights();
    setAccessibleDescription(d->shown.description());
    sightChanged();
}

/// Lengths are not so many times as high as angles are wide.
void SurfaceView::showHeights()
{
    const bool isOneScale = canDraw() && hasOneScale(*d->sight.table);
    if (canDraw() && !isOneScale)
        d->height->showFitting();
    d->height->setEnabled(isOneScale);
    d->height->setToolTip(!canDraw() || isOneScale
            ? tr("How many times too high the errors are drawn, compared with the axes (+ and -)")
            : tr("The units of the table have no common scale; the heights are drawn as they fit"));
    d->height->setAccessibleDescription(d->height->toolTip());
}

double SurfaceView::exaggeration() const
{
    return d->height->factor();
}

bool SurfaceView::isWhole() const
{
    return d->isWhole;
}

void SurfaceView::setMarker(const std::optional<TablePlot::Marker>& marker)
{
    d->marker = marker;
    update();
}

void SurfaceView::turn(double byTurn, double byTilt)
{
    constexpr double flattest = 5.0;
    d->sight.turn = std::remainder(d->sight.turn + byTurn, 360.0);
    d->sight.tilt = std::clamp(d->sight.tilt + byTilt, flattest, 90.0);
    sightChanged();
}

void SurfaceView::zoom(double factor)
{
    constexpr double largest = 20.0;
    d->sight.zoom = std::clamp(d->sight.zoom * factor, 1.0, largest);
    sightChanged();
}

void SurfaceView::resetSight()
{
    d->sight.turn = firstTurn;
    d->sight.tilt = firstTilt;
    d->sight.zoom = 1.0;
    d->height->showFitting();
    sightChanged();
}

void SurfaceView::sightChanged()
{
    d->whole->cancel();
    d->isWhole = false;
    d->image = QImage();
    d->pause.start();
    update();
}

void SurfaceView::drawWhole()
{
    if (!canDraw() || d->sight.size.isEmpty())
        return;
    d->sight.exaggeration = exaggeration();
    const double ratio = devicePixelRatioF();
    const SurfaceSight sight = finer(d->sight, ratio);
    const SurfaceColors colors(palette());
    d->whole->start([sight, colors, ratio, scale = d->scale](const std::stop_token&) {
        QImage image = imageOf(sight, colors, scale, allSamples);
        image.setDevicePixelRatio(ratio);
        return image;
    });
}

void SurfaceView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    const SurfaceColors colors(palette());
    painter.fillRect(d->space->geometry(), colors.base);
    if (!canDraw())
        return;
    d->sight.size = d->space->size();
    d->sight.exaggeration = exaggeration();
    if (d->image.isNull())
        d->image = imageOf(d->sight, colors, d->scale, samplesWhileTurning);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(d->space->geometry());
    painter.translate(d->space->pos());
    SurfaceAxes(painter, d->sight, d->shown.valueScale(), colors.muted).drawFloor();
    painter.drawImage(0, 0, d->image);
    paintAbove(painter, d->sight, colors);
}

/// Scales, marks and the factor of the heights, if there is one.
void SurfaceView::paintAbove(
    QPainter& painter, const SurfaceSight& sight, const SurfaceColors& colors) const
{
    const CompensationTable& table = *sight.table;
    const ValueScale& values = d->shown.valueScale();
    SurfaceAxes(painter, sight, values, colors.muted)
        .drawScales(
            {withUnit(d->shown.nameOf(0), table.grid.axes[0].unit),
                withUnit(d->shown.nameOf(1), table.grid.axes[1].unit),
                withUnit(d->shown.content() == TableContent::Difference ? tr("difference")
                                                                        : tr("compensation"),
                    values.unit())},
            colors.text);
    paintPlaces(painter, sight, colors);
    if (!hasOneScale(table))
        return;
    painter.setPen(colors.text);
    painter.drawText(QRect({}, sight.size).adjusted(6, 4, -6, -4), Qt::AlignRight | Qt::AlignTop,
        tr("heights × %1").arg(factorText(sight.exaggeration)));
}

/// The point that is looked at, and the axis.
void SurfaceView::paintPlaces(
    QPainter& painter, const SurfaceSight& sight, const SurfaceColors& colors) const
{
    const CompensationTable& table = *sight.table;
    const SurfaceProjection projection(sight);
    const auto pin = [&](double x, double y) {
        const QPointF place = projection.pixel(x, y, Lookup(table).at(x, y));
        painter.setPen(QPen(colors.text, 1.0, Qt::DashLine));
        painter.drawLine(projection.pixel(x, y, sight.heights[0]), place);
        return place;
    };
    if (const auto& current = d->shown.current()) {
        const QPointF place =
            pin(table.grid.axes[0].position(current->i), table.grid.axes[1].position(current->j));
        for (const auto& [color, width] :
            {std::pair(colors.base, 4.0), std::pair(colors.text, 1.5)}) {
            painter.setPen(QPen(color, width));
            painter.setBrush(Qt::NoBrush);
            painter.drawEllipse(place, 5.0, 5.0);
        }
    }
    if (!d->marker)
        return;
    const auto held = [&](std::size_t axis) {
        const GridAxis& drawn = table.grid.axes[axis];
        return std::clamp(
            d->marker->positions.at(d->shown.dimensionOf(axis)), drawn.start, drawn.last());
    };
    const QPointF place = pin(held(0), held(1));
    painter.setPen(QPen(colors.text, 1.5));
    painter.setBrush(colors.marker);
    constexpr double size = 6.0;
    painter.drawPolygon(QPolygonF({place - QPointF(0, size), place + QPointF(size, 0),
        place + QPointF(0, size), place - QPointF(size, 0)}));
}

void SurfaceView::setOrigin(const PictureOrigin& origin)
{
    d->origin = origin;
}

QFuture<QString> SurfaceView::exportTo(const QString& path) const
{
    if (!canDraw())
        return inBackground<QString>(
            [problem = tr("There is no table to save.")] { return problem; });
    SurfaceSight sight = d->sight;
    sight.size = drawnPictureSize;
    sight.exaggeration = exaggeration();
    const SurfaceColors colors{QPalette(Qt::white)};
    PictureDrawing drawing;
    const auto painted = [](QPicture& picture, const auto& paint) {
        QPainter painter(&picture);
        painter.setRenderHint(QPainter::Antialiasing);
        paint(painter);
    };
    painted(drawing.below, [&](QPainter& painter) {
        SurfaceAxes(painter, sight, d->shown.valueScale(), colors.muted).drawFloor();
    });
    drawing.place = QRectF(QPointF(), drawnPictureSize);
    drawing.image = [sight, colors, scale = d->scale](const QSize& size) {
        const double ratio = static_cast<double>(size.width()) / drawnPictureSize.width();
        return imageOf(finer(sight, ratio), colors, scale, allSamples);
    };
    painted(drawing.above, [&](QPainter& painter) { paintAbove(painter, sight, colors); });
    return savePicture(
        drawing, pictureCaption(d->shown.title(), d->origin, QDateTime::currentDateTime()), path);
}

void SurfaceView::askForExport()
{
    askForPictureFile(
        *this, proposedPictureName(d->origin, tr("surface")), false,
        [this](const QString& path) { return exportTo(path); },
        [this](const QString& sentence) {
            QToolTip::showText(
                d->save->mapToGlobal(d->save->rect().bottomLeft()), sentence, d->save);
        });
}

void SurfaceView::contextMenuEvent(QContextMenuEvent* event)
{
    if (!canDraw())
        return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    connect(menu->addAction(d->reset->text()), &QAction::triggered, this, &SurfaceView::resetSight);
    connect(menu->addAction(tr("Copy picture")), &QAction::triggered, this,
        [this] { QGuiApplication::clipboard()->setPixmap(grab(d->space->geometry())); });
    connect(
        menu->addAction(d->save->text()), &QAction::triggered, this, &SurfaceView::askForExport);
    menu->popup(event->globalPos());
}

void SurfaceView::resizeEvent(QResizeEvent* event)
{
    QWidget::resizeEvent(event);
    sightChanged();
}

void SurfaceView::keyPressEvent(QKeyEvent* event)
{
    constexpr double step = 5.0;
    switch (event->key()) {
    case Qt::Key_Left:
        return turn(-step, 0.0);
    case Qt::Key_Right:
        return turn(step, 0.0);
    case Qt::Key_Up:
        return turn(0.0, -step);
    case Qt::Key_Down:
        return turn(0.0, step);
    case Qt::Key_Plus:
    case Qt::Key_Minus:
        if (d->height->isEnabled())
            d->height->step(event->key() == Qt::Key_Plus ? 1 : -1);
        return;
    case Qt::Key_PageUp:
        return zoom(zoomStep);
    case Qt::Key_PageDown:
        return zoom(1.0 / zoomStep);
    case Qt::Key_Home:
        return resetSight();
    default:
        QWidget::keyPressEvent(event);
    }
}

void SurfaceView::mousePressEvent(QMouseEvent* event)
{
    d->dragged = event->position();
}

void SurfaceView::mouseMoveEvent(QMouseEvent* event)
{
    if (!(event->buttons() & Qt::LeftButton))
        return;
    constexpr double degreesPerPixel = 0.4;
    const QPointF way = event->position() - d->dragged;
    d->dragged = event->position();
    turn(way.x() * degreesPerPixel, way.y() * degreesPerPixel);
}

void SurfaceView::wheelEvent(QWheelEvent* event)
{
    if (event->angleDelta().y() != 0)
        zoom(event->angleDelta().y() > 0 ? zoomStep : 1.0 / zoomStep);
}

void SurfaceView::mouseDoubleClickEvent(QMouseEvent*)
{
    resetSight();
}

void SurfaceView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::PaletteChange)
        sightChanged();
}

} // namespace axiscomp::ui
