// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/surface_view.h"

#include "core/table/contours.h"
#include "core/table/lookup.h"
#include "ui/async/background_job.h"
#include "ui/data/table_view_model.h"
#include "ui/plot/slice_row.h"
#include "ui/plot/surface_image.h"
#include "ui/plot/table_content_combo.h"
#include "ui/plot/table_map.h"
#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QPainter>
#include <QTimer>
#include <QToolButton>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>

namespace axiscomp::ui {

namespace {

constexpr double firstTurn = 30.0;
constexpr double firstTilt = 35.0;
constexpr int samplesWhileTurning = 100;
constexpr int allSamples = 4096;

QString heightText(double factor)
{
    return factor < 1.0 ? numberText(factor) : countText(static_cast<std::size_t>(factor));
}

/// The box around a surface, its axes with ticks and names.
class SurfaceAxes {
public:
    SurfaceAxes(QPainter& painter, const SurfaceSight& sight, const QColor& line)
        : m_painter(painter)
        , m_sight(sight)
        , m_projection(sight)
        , m_line(line)
        , m_x(sight.table->grid.axes[0])
        , m_y(sight.table->grid.axes[1])
    {
        // The two edges of the floor that are nearest to the eye, and the corner farthest left.
        const double quarter = std::fmod(std::fmod(sight.turn, 360.0) + 360.0, 360.0);
        m_frontY = quarter < 90.0 || quarter >= 270.0 ? m_y.start : m_y.last();
        m_frontX = quarter < 180.0 ? m_x.start : m_x.last();
    }

    void drawFloor()
    {
        m_painter.setPen(QPen(m_line, 1.0));
        for (const double x : {m_x.start, m_x.last()})
            line(x, m_y.start, floor(), x, m_y.last(), floor());
        for (const double y : {m_y.start, m_y.last()})
            line(m_x.start, y, floor(), m_x.last(), y, floor());
    }

    void drawScales(const QString& xName, const QString& yName, const QString& valueName)
    {
        m_painter.setPen(QPen(m_line, 1.0));
        const auto [left, leftY] = leftCorner();
        line(left, leftY, floor(), left, leftY, m_sight.heights[1]);
        for (const double x : ticks(m_x.start, m_x.last()))
            tick({x, m_frontY, floor()}, numberText(x));
        for (const double y : ticks(m_y.start, m_y.last()))
            tick({m_frontX, y, floor()}, numberText(y));
        for (const double value : ticks(m_sight.heights[0], m_sight.heights[1]))
            tick({left, leftY, value}, signedNumberText(value), true);
        name({(m_x.start + m_x.last()) / 2.0, m_frontY, floor()}, xName);
        name({m_frontX, (m_y.start + m_y.last()) / 2.0, floor()}, yName);
        const QPointF top = m_projection.pixel(left, leftY, m_sight.heights[1]);
        text(top - QPointF(0.0, 14.0), valueName, Qt::AlignHCenter);
    }

private:
    [[nodiscard]] double floor() const { return m_sight.heights[0]; }
    [[nodiscard]] std::pair<double, double> leftCorner() const
    {
        std::pair<double, double> best{m_x.start, m_y.start};
        double smallest = 1e300;
        for (const double x : {m_x.start, m_x.last()}) {
            for (const double y : {m_y.start, m_y.last()}) {
                const double place = m_projection.pixel(x, y, floor()).x();
                if (place < smallest) {
                    smallest = place;
                    best = {x, y};
                }
            }
        }
        return best;
    }
    static std::vector<double> ticks(double low, double high)
    {
        constexpr int most = 5;
        return roundLevels(low, high, most);
    }
    void line(double x1, double y1, double v1, double x2, double y2, double v2)
    {
        m_painter.drawLine(m_projection.pixel(x1, y1, v1), m_projection.pixel(x2, y2, v2));
    }
    /// Away from the middle of the picture.
    [[nodiscard]] QPointF outwards(const QPointF& pixel, double by) const
    {
        const QPointF middle = m_projection.pixel(
            (m_x.start + m_x.last()) / 2.0, (m_y.start + m_y.last()) / 2.0, floor());
        const QPointF way = pixel - middle;
        const double length = std::max(1.0, std::hypot(way.x(), way.y()));
        return pixel + way * (by / length);
    }
    void tick(const std::array<double, 3>& place, const QString& label, bool isUpright = false)
    {
        const QPointF pixel = m_projection.pixel(place[0], place[1], place[2]);
        const QPointF end = isUpright ? pixel - QPointF(5.0, 0.0) : outwards(pixel, 5.0);
        m_painter.drawLine(pixel, end);
        if (isUpright)
            text(end - QPointF(3.0, 0.0), label, Qt::AlignRight);
        else
            text(outwards(pixel, 16.0), label, Qt::AlignHCenter);
    }
    void name(const std::array<double, 3>& place, const QString& label)
    {
        const QPointF pixel = m_projection.pixel(place[0], place[1], place[2]);
        text(outwards(pixel, 36.0), label,
            pixel.x() < m_sight.size.width() / 2.0 - 20.0       ? Qt::AlignRight
                : pixel.x() > m_sight.size.width() / 2.0 + 20.0 ? Qt::AlignLeft
                                                                : Qt::AlignHCenter);
    }
    void text(const QPointF& at, const QString& label, Qt::Alignment side)
    {
        const QFontMetricsF metrics(m_painter.font());
        const QSizeF size(metrics.horizontalAdvance(label) + 2.0, metrics.height());
        QRectF place({}, size);
        place.moveCenter(at);
        if (side == Qt::AlignRight)
            place.moveRight(at.x());
        else if (side == Qt::AlignLeft)
            place.moveLeft(at.x());
        place.moveLeft(std::clamp(place.left(), 0.0,
            std::max(0.0, static_cast<double>(m_sight.size.width()) - size.width())));
        place.moveTop(std::clamp(place.top(), 0.0,
            std::max(0.0, static_cast<double>(m_sight.size.height()) - size.height())));
        m_painter.drawText(place, Qt::AlignCenter, label);
    }

    QPainter& m_painter;
    const SurfaceSight& m_sight;
    SurfaceProjection m_projection;
    QColor m_line;
    const GridAxis& m_x;
    const GridAxis& m_y;
    double m_frontX = 0.0;
    double m_frontY = 0.0;
};

} // namespace

struct SurfaceView::Private {
    explicit Private(TableViewModel& shownTable) : shown(shownTable) { }

    TableViewModel& shown;
    std::optional<TablePlot::Marker> marker;
    TableContentCombo* contentBox = nullptr;
    QLabel* heightLabel = nullptr;
    QComboBox* height = nullptr; ///< its data: the factor; 0 the one that fits
    QToolButton* reset = nullptr;
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
    connect(d->height, &QComboBox::currentIndexChanged, this, &SurfaceView::sightChanged);
    connect(d->reset, &QToolButton::clicked, this, &SurfaceView::resetSight);
    retranslate();
    showTable();
}

SurfaceView::~SurfaceView() = default;

void SurfaceView::build()
{
    setFocusPolicy(Qt::StrongFocus);
    d->contentBox = new TableContentCombo(d->shown, this);
    d->contentBox->setObjectName(QStringLiteral("surfaceContent"));
    d->heightLabel = new PlainLabel(this);
    d->height = new QComboBox(this);
    d->height->setObjectName(QStringLiteral("surfaceExaggeration"));
    d->height->addItem(QString(), 0.0);
    for (double power = 1.0; power < 1e7; power *= 10.0)
        for (const double factor : {1.0, 2.0, 5.0})
            d->height->addItem(QString(), factor * power);
    d->heightLabel->setBuddy(d->height);
    d->reset = new QToolButton(this);
    d->reset->setObjectName(QStringLiteral("surfaceReset"));
    d->reset->setAutoRaise(true);
    d->reset->setFocusPolicy(Qt::StrongFocus);
    d->space = new QWidget(this);
    d->space->setMinimumSize(260, 90);
    d->space->setAttribute(Qt::WA_TransparentForMouseEvents);
    d->slice = new SliceRow(d->shown, this);
    auto* tools = new QHBoxLayout;
    tools->addWidget(d->contentBox);
    tools->addStretch(1);
    tools->addWidget(d->heightLabel);
    tools->addWidget(d->height);
    tools->addWidget(d->reset);
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
    d->heightLabel->setText(tr("Heights"));
    d->height->setToolTip(
        tr("How many times too high the errors are drawn, compared with the axes (+ and -)"));
    d->height->setAccessibleName(tr("Exaggeration"));
    d->height->setAccessibleDescription(d->height->toolTip());
    d->height->setItemText(0, tr("fitting"));
    for (int n = 1; n < d->height->count(); ++n)
        d->height->setItemText(
            n, QStringLiteral("× %1").arg(heightText(d->height->itemData(n).toDouble())));
    d->reset->setText(tr("First view"));
    d->reset->setToolTip(
        tr("See the surface as at first (Home). Arrow keys and dragging turn it."));
    d->reset->setAccessibleDescription(d->reset->toolTip());
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
    for (QWidget* tool : std::initializer_list<QWidget*>{d->height, d->reset})
        tool->setEnabled(isSurface);
    // All slices of a table stand in the same box.
    if (isSurface) {
        const auto [low, high] = std::ranges::minmax(d->shown.table()->values);
        d->sight.heights = {static_cast<double>(low), static_cast<double>(high)};
        if (!(high > low))
            d->sight.heights = {d->sight.heights[0] - d->scale, d->sight.heights[1] + d->scale};
    }
    setAccessibleDescription(d->shown.description());
    sightChanged();
}

double SurfaceView::exaggeration() const
{
    const double chosen = d->height->currentData().toDouble();
    return chosen > 0.0 || !canDraw() ? chosen
                                      : fittingExaggeration(*d->sight.table, d->sight.heights);
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

void SurfaceView::stepExaggeration(int steps)
{
    const double now = exaggeration();
    int at = d->height->currentIndex();
    for (int n = 1; at == 0 && n < d->height->count(); ++n)
        if (d->height->itemData(n).toDouble() >= now * 0.999)
            at = n;
    d->height->setCurrentIndex(std::clamp(at + steps, 1, d->height->count() - 1));
}

void SurfaceView::resetSight()
{
    d->sight.turn = firstTurn;
    d->sight.tilt = firstTilt;
    d->height->setCurrentIndex(0);
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
    SurfaceSight sight = d->sight;
    sight.size = (QSizeF(sight.size) * ratio).toSize();
    sight.ratio = ratio;
    const QColor line = palette().color(QPalette::Text);
    const bool isDark = palette().color(QPalette::Base).lightness() < 128;
    d->whole->start([sight, line, isDark, ratio, scale = d->scale](const std::stop_token&) {
        QImage image = surfaceImage(
            sight, divergingGradient(isDark), QCPRange(-scale, scale), line, allSamples);
        image.setDevicePixelRatio(ratio);
        return image;
    });
}

void SurfaceView::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.fillRect(d->space->geometry(), palette().color(QPalette::Base));
    if (!canDraw())
        return;
    d->sight.size = d->space->size();
    d->sight.exaggeration = exaggeration();
    const QColor text = palette().color(QPalette::Text);
    const bool isDark = palette().color(QPalette::Base).lightness() < 128;
    if (d->image.isNull())
        d->image = surfaceImage(d->sight, divergingGradient(isDark), QCPRange(-d->scale, d->scale),
            text, samplesWhileTurning);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setClipRect(d->space->geometry());
    painter.translate(d->space->pos());
    SurfaceAxes axes(painter, d->sight, mutedTextColor(palette()));
    axes.drawFloor();
    painter.drawImage(0, 0, d->image);
    const CompensationTable& table = *d->sight.table;
    painter.setPen(text);
    axes.drawScales(withUnit(d->shown.nameOf(0), table.grid.axes[0].unit),
        withUnit(d->shown.nameOf(1), table.grid.axes[1].unit),
        withUnit(
            d->shown.content() == TableContent::Difference ? tr("difference") : tr("compensation"),
            table.unit));
    paintPlaces(painter);
    painter.setPen(text);
    painter.drawText(QRect({}, d->sight.size).adjusted(6, 4, -6, -4), Qt::AlignRight | Qt::AlignTop,
        tr("heights × %1").arg(heightText(d->sight.exaggeration)));
}

/// The point that is looked at, and the axis.
void SurfaceView::paintPlaces(QPainter& painter)
{
    const CompensationTable& table = *d->sight.table;
    const SurfaceProjection projection(d->sight);
    const QColor text = palette().color(QPalette::Text);
    const QColor base = palette().color(QPalette::Base);
    const auto pin = [&](double x, double y) {
        const QPointF place = projection.pixel(x, y, Lookup(table).at(x, y));
        painter.setPen(QPen(text, 1.0, Qt::DashLine));
        painter.drawLine(projection.pixel(x, y, d->sight.heights[0]), place);
        return place;
    };
    if (const auto& current = d->shown.current()) {
        const QPointF place =
            pin(table.grid.axes[0].position(current->i), table.grid.axes[1].position(current->j));
        for (const auto& [color, width] : {std::pair(base, 4.0), std::pair(text, 1.5)}) {
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
    const bool isDark = base.lightness() < 128;
    painter.setPen(QPen(text, 1.5));
    painter.setBrush(isDark ? QColor(255, 200, 60) : QColor(120, 60, 0));
    constexpr double size = 6.0;
    painter.drawPolygon(QPolygonF({place - QPointF(0, size), place + QPointF(size, 0),
        place + QPointF(0, size), place - QPointF(size, 0)}));
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
        return stepExaggeration(1);
    case Qt::Key_Minus:
        return stepExaggeration(-1);
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
        stepExaggeration(event->angleDelta().y() > 0 ? 1 : -1);
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
