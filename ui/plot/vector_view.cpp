// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/vector_view.h"

#include "core/table/position_unit.h"
#include "core/table/table_math.h"
#include "ui/async/background_job.h"
#include "ui/data/table_view_model.h"
#include "ui/data/vector_columns.h"
#include "ui/drawing/deformed_grid.h"
#include "ui/drawing/local_plot.h"
#include "ui/drawing/painted_item.h"
#include "ui/drawing/plot_export.h"
#include "ui/plot/exaggeration_combo.h"
#include "ui/plot/slice_row.h"
#include "ui/style/contrast.h"
#include "ui/style/plain_label.h"
#include "ui/text/value_scale.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QClipboard>
#include <QComboBox>
#include <QEvent>
#include <QGuiApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QToolButton>

#include <algorithm>
#include <cmath>

namespace axiscomp::ui {

namespace {

/// Lengths of two axes are drawn to one scale, but for grids that would be a thin strip.
constexpr double narrowest = 0.25;

struct Pens {
    QPen read; ///< the grid as the encoders read it
    QPen real; ///< and as it is
    QColor text;
    QColor base;
    QColor marker;
};

Pens pensFor(const QPalette& palette)
{
    const bool isDark = palette.color(QPalette::Base).lightness() < 128;
    return {QPen(mutedTextColor(palette), 1.0),
        QPen(isDark ? QColor(110, 185, 255) : QColor(5, 80, 160), 1.6),
        palette.color(QPalette::Text), palette.color(QPalette::Base),
        isDark ? QColor(255, 200, 60) : QColor(120, 60, 0)};
}

/// How long an error of a round size is drawn.
struct ScaleArrow {
    QString text;
    double length = 0.0; ///< pixels; 0: none
};

/// Paints a plane of errors into a plot's axes.
class PlanePainter {
public:
    PlanePainter(QCPPainter& painter, const QCustomPlot& plot, const ErrorPlane& plane,
        double exaggeration, const Pens& pens)
        : m_painter(painter)
        , m_plot(plot)
        , m_plane(plane)
        , m_exaggeration(exaggeration)
        , m_pens(pens)
    {
    }

    void paintGrids()
    {
        constexpr int mostLines = 24;
        const DrawnLines x = drawnLines(m_plane.grid().axes[0], m_plot.xAxis->range().lower,
            m_plot.xAxis->range().upper, mostLines);
        const DrawnLines y = drawnLines(m_plane.grid().axes[1], m_plot.yAxis->range().lower,
            m_plot.yAxis->range().upper, mostLines);
        m_painter.setAntialiasing(true);
        m_painter.setBrush(Qt::NoBrush);
        for (const auto& [pen, factor] :
            {std::pair(m_pens.read, 0.0), std::pair(m_pens.real, m_exaggeration)}) {
            m_painter.setPen(pen);
            for (const std::size_t j : y.lines)
                line(x.points, [&, shown = factor](std::size_t i) { return pixel(i, j, shown); });
            for (const std::size_t i : x.lines)
                line(y.points, [&, shown = factor](std::size_t j) { return pixel(i, j, shown); });
        }
    }

    /// From where the encoders are to where the axes are.
    void paintMarker(const ContourPoint& place)
    {
        const GridAxis& x = m_plane.grid().axes[0];
        const GridAxis& y = m_plane.grid().axes[1];
        const ContourPoint held{
            std::clamp(place.x, x.start, x.last()), std::clamp(place.y, y.start, y.last())};
        const ContourPoint error = m_plane.at(held, m_exaggeration);
        const QPointF read = pixel(place);
        const QPointF real = pixel({place.x + error.x - held.x, place.y + error.y - held.y});
        constexpr double size = 6.0;
        m_painter.setAntialiasing(true);
        m_painter.setPen(QPen(m_pens.text, 1.5));
        m_painter.drawLine(read, real);
        m_painter.setBrush(m_pens.marker);
        m_painter.drawPolygon(QPolygonF({real - QPointF(0, size), real + QPointF(size, 0),
            real + QPointF(0, size), real - QPointF(size, 0)}));
    }

    /// One arrow where both axes have one scale.
    void paintScale(const QRectF& sight, const std::array<ScaleArrow, 2>& arrows)
    {
        constexpr double away = 14.0;
        const QPointF corner(sight.left() + away, sight.bottom() - away);
        const QSizeF words = noteSize(m_painter, arrows[0].text);
        QColor under = m_pens.base;
        constexpr int almostOpaque = 210;
        under.setAlpha(almostOpaque);
        const double height = words.height() + away + arrows[1].length;
        m_painter.fillRect(
            QRectF(corner.x() - away / 2.0, corner.y() - height,
                std::max(arrows[0].length, words.width()) + away, height + away / 2.0),
            under);
        m_painter.setAntialiasing(true);
        paintArrow(corner, corner + QPointF(arrows[0].length, 0.0));
        m_painter.drawText(QRectF(corner - QPointF(0.0, 4.0 + words.height()), words),
            Qt::AlignLeft | Qt::AlignVCenter, arrows[0].text);
        if (arrows[1].length <= 0.0)
            return;
        paintArrow(corner, corner - QPointF(0.0, arrows[1].length));
        m_painter.drawText(
            QRectF(corner + QPointF(6.0, -arrows[1].length), noteSize(m_painter, arrows[1].text)),
            Qt::AlignLeft | Qt::AlignTop, arrows[1].text);
    }

private:
    [[nodiscard]] QPointF pixel(const ContourPoint& place) const
    {
        return {m_plot.xAxis->coordToPixel(place.x), m_plot.yAxis->coordToPixel(place.y)};
    }
    [[nodiscard]] QPointF pixel(std::size_t i, std::size_t j, double factor) const
    {
        return pixel(m_plane.at(i, j, factor));
    }
    template <typename PixelOf>
    void line(const std::vector<std::size_t>& points, const PixelOf& pixelOf)
    {
        QPolygonF drawn;
        for (const std::size_t point : points)
            drawn.append(pixelOf(point));
        m_painter.drawPolyline(drawn);
    }
    void paintArrow(const QPointF& from, const QPointF& to)
    {
        const QPointF way =
            (to - from) / std::max(1.0, std::hypot(to.x() - from.x(), to.y() - from.y()));
        const QPointF across(-way.y(), way.x());
        constexpr double head = 7.0;
        m_painter.setPen(QPen(m_pens.text, 2.0));
        m_painter.setBrush(m_pens.text);
        m_painter.drawLine(from, to - way * head);
        m_painter.setPen(Qt::NoPen);
        m_painter.drawPolygon(QPolygonF(
            {to, to - way * head + across * head / 2.0, to - way * head - across * head / 2.0}));
        m_painter.setPen(m_pens.text);
    }

    QCPPainter& m_painter;
    const QCustomPlot& m_plot;
    const ErrorPlane& m_plane;
    double m_exaggeration;
    const Pens& m_pens;
};

QString columnText(const CompensationTable& table, std::size_t index)
{
    return table.name.empty() ? VectorView::tr("column %1").arg(index + 1)
                              : QString::fromStdString(table.name);
}

} // namespace

struct VectorView::Private {
    explicit Private(TableViewModel& shownTable) : shown(shownTable) { }

    TableViewModel& shown;
    Data data;
    VectorColumns columns;
    ErrorPlane plane;
    std::array<std::size_t, 2> drawn{0, 1}; ///< the file's dimensions behind the axes
    std::optional<std::array<double, 3>> marker;
    PictureOrigin origin;
    Pens pens;
    QCPRange wholeX; ///< what the whole view shows
    QCPRange wholeY;
    QRect laidOut; ///< the axes' place for which that is
    bool isWhole = true;

    std::array<QLabel*, 2> labels{};
    std::array<QComboBox*, 2> boxes{}; ///< their data: the column
    QLabel* factorLabel = nullptr;
    ExaggerationCombo* factor = nullptr;
    QToolButton* reset = nullptr;
    QToolButton* save = nullptr;
    QCustomPlot* plot = nullptr;
    SliceRow* slice = nullptr;
    QLabel* note = nullptr;

    void paint(QCPPainter& painter, const QRectF& sight) const;
    [[nodiscard]] ScaleArrow arrow(std::size_t n, double seen) const;
    [[nodiscard]] bool hasOneScale() const
    {
        const auto& axes = plane.grid().axes;
        return commonUnitFactor(axes[1].unit, axes[0].unit).has_value();
    }
    /// How many of dimension 1's units one unit of dimension 2 is.
    [[nodiscard]] double unitRatio() const
    {
        const auto& axes = plane.grid().axes;
        return commonUnitFactor(axes[1].unit, axes[0].unit).value_or(1.0);
    }
};

void VectorView::Private::paint(QCPPainter& painter, const QRectF& sight) const
{
    if (!plane.isValid())
        return;
    PlanePainter planePainter(painter, *plot, plane, factor->factor(), pens);
    planePainter.paintGrids();
    if (marker)
        planePainter.paintMarker({(*marker)[drawn[0]], (*marker)[drawn[1]]});
    std::array<ScaleArrow, 2> arrows{arrow(0, sight.width()), arrow(1, sight.height())};
    const double pixelsX = sight.width() / plot->xAxis->range().size();
    const double pixelsY = sight.height() / plot->yAxis->range().size() / unitRatio();
    constexpr double same = 0.02;
    if (hasOneScale() && std::abs(pixelsX / pixelsY - 1.0) < same)
        arrows[1].length = 0.0;
    planePainter.paintScale(sight, arrows);
}

/// An error of a round size, about an eighth of the picture long.
ScaleArrow VectorView::Private::arrow(std::size_t n, double seen) const
{
    constexpr double part = 8.0;
    const double range = (n == 0 ? plot->xAxis : plot->yAxis)->range().size();
    const double perValue = factor->factor() * plane.perValue.at(n);
    const std::string& unit = plane.errors.at(n)->unit;
    const std::array<float, 1> wanted{static_cast<float>(range / part / perValue)};
    const double perUnit = ValueScale(unit, wanted).factor();
    const double value = roundFactor(static_cast<double>(wanted[0]) * perUnit) / perUnit;
    const std::array<float, 1> rounded{static_cast<float>(value)};
    return {ValueScale(unit, rounded).sizeWithUnit(value), value * perValue / range * seen};
}

VectorView::VectorView(TableViewModel& shown, QWidget* parent)
    : QWidget(parent)
    , d(std::make_unique<Private>(shown))
{
    build();
    connectTools();
    showPalette(palette());
    retranslate();
}

VectorView::~VectorView() = default;

void VectorView::build()
{
    auto* tools = new QHBoxLayout;
    for (std::size_t n = 0; n < d->boxes.size(); ++n) {
        d->labels[n] = new PlainLabel(this);
        d->boxes[n] = new QComboBox(this);
        d->boxes[n]->setObjectName(
            n == 0 ? QStringLiteral("vectorColumn1") : QStringLiteral("vectorColumn2"));
        constexpr int letters = 3; // as narrow as the page may be
        d->boxes[n]->setSizeAdjustPolicy(QComboBox::AdjustToMinimumContentsLengthWithIcon);
        d->boxes[n]->setMinimumContentsLength(letters);
        d->boxes[n]->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Fixed);
        constexpr int widest = 160;
        d->boxes[n]->setMaximumWidth(widest);
        d->labels[n]->setBuddy(d->boxes[n]);
        tools->addWidget(d->labels[n]);
        tools->addWidget(d->boxes[n]);
    }
    tools->addStretch(1);
    d->factorLabel = new PlainLabel(this);
    d->factor = new ExaggerationCombo(this);
    d->factor->setObjectName(QStringLiteral("vectorExaggeration"));
    d->factorLabel->setBuddy(d->factor);
    tools->addWidget(d->factorLabel);
    tools->addWidget(d->factor);
    const auto tool = [&](const char* name) {
        auto* button = new QToolButton(this);
        button->setObjectName(QLatin1StringView(name));
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::StrongFocus);
        tools->addWidget(button);
        return button;
    };
    d->reset = tool("vectorReset");
    d->save = tool("vectorExport");
    d->plot = new LocalPlot(this);
    d->plot->setObjectName(QStringLiteral("vectorCanvas"));
    d->plot->setMinimumSize(260, 160);
    d->plot->setFocusPolicy(Qt::StrongFocus);
    d->plot->setInteractions(QCP::iRangeDrag | QCP::iRangeZoom);
    d->plot->axisRect()->setupFullAxesBox(true);
    d->plot->setContextMenuPolicy(Qt::CustomContextMenu);
    d->plot->installEventFilter(this);
    new PaintedItem(*d->plot, "main",
        [this](QCPPainter& painter, const QRectF& sight) { d->paint(painter, sight); });
    d->slice = new SliceRow(d->shown, this);
    d->note = new PlainLabel(this);
    d->note->setObjectName(QStringLiteral("vectorNote"));
    d->note->setWordWrap(true);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    layout->addLayout(tools);
    layout->addWidget(d->plot, 1);
    layout->addWidget(d->slice);
    layout->addWidget(d->note);
}

void VectorView::connectTools()
{
    for (QComboBox* box : d->boxes)
        connect(box, &QComboBox::activated, this, &VectorView::showPlane);
    connect(d->factor, &ExaggerationCombo::factorChanged, this, [this] {
        showTexts();
        showWhole();
    });
    connect(d->reset, &QToolButton::clicked, this, [this] {
        d->factor->showFitting();
        showWhole();
    });
    connect(d->save, &QToolButton::clicked, this, &VectorView::askForExport);
    connect(d->plot, &QWidget::customContextMenuRequested, this, &VectorView::showMenu);
    connect(d->plot, &QCustomPlot::afterLayout, this, &VectorView::followLayout);
    connect(&d->shown, &TableViewModel::changed, this, &VectorView::chooseColumns);
}

bool VectorView::canShow(const Data& data)
{
    return data && vectorColumns(data->tables).hasAnyPlane();
}

void VectorView::setData(const Data& now)
{
    if (now == d->data)
        return;
    d->data = now;
    d->columns = now ? vectorColumns(now->tables) : VectorColumns{};
    d->factor->showFitting();
    chooseColumns();
}

/// Those of the dimensions that are drawn; what was chosen stays as long as it can.
void VectorView::chooseColumns()
{
    const bool isVolume = d->data && d->data->grid.dimensions() == 3;
    const bool isSame = isVolume && d->shown.isCut();
    d->drawn = {0, 1};
    if (isSame)
        d->drawn = {d->shown.dimensionOf(0), d->shown.dimensionOf(1)};
    for (std::size_t n = 0; n < d->boxes.size(); ++n) {
        QComboBox* box = d->boxes[n];
        const QVariant before = box->currentData();
        box->clear();
        for (const std::size_t column : d->columns.ofDimension.at(d->drawn[n]))
            box->addItem(columnText(d->data->tables[column], column),
                QVariant::fromValue(static_cast<qulonglong>(column)));
        box->setCurrentIndex(std::max(0, box->findData(before)));
        box->setEnabled(box->count() > 0);
    }
    showPlane();
}

void VectorView::showPlane()
{
    const bool wasValid = d->plane.isValid();
    const std::vector<GridAxis> before = wasValid ? d->plane.grid().axes : std::vector<GridAxis>();
    d->plane = {};
    const bool isVolume = d->data && d->data->grid.dimensions() == 3;
    for (std::size_t n = 0;
         n < d->boxes.size() && d->boxes[0]->count() > 0 && d->boxes[1]->count() > 0; ++n) {
        const auto column = static_cast<std::size_t>(d->boxes[n]->currentData().toULongLong());
        const CompensationTable& table = d->data->tables[column];
        d->plane.perValue[n] = positionsPerValue(table, d->drawn[n]);
        if (!isVolume) {
            d->plane.errors[n] = ErrorPlane::Table(d->data, &table);
            continue;
        }
        const std::size_t cut = 3 - d->drawn[0] - d->drawn[1];
        const std::size_t last = table.grid.axes[cut].size - 1;
        const std::size_t at = d->shown.isCut()
            ? std::min(static_cast<std::size_t>(d->shown.sliceIndex()), last)
            : last / 2;
        d->plane.errors[n] = std::make_shared<const CompensationTable>(tableSlice(table, cut, at));
    }
    for (QWidget* tool : std::initializer_list<QWidget*>{d->factor, d->reset, d->save})
        tool->setEnabled(d->plane.isValid());
    if (d->plane.isValid())
        d->factor->setFitting(fittingExaggeration(d->plane));
    showTexts();
    if (d->plane.isValid() && d->plane.grid().axes == before)
        d->plot->replot(QCustomPlot::rpQueuedReplot);
    else
        showWhole();
}

double VectorView::exaggeration() const
{
    return d->factor->factor();
}

void VectorView::setMarker(const std::optional<std::array<double, 3>>& positions)
{
    if (positions == d->marker)
        return;
    d->marker = positions;
    if (isVisible())
        d->plot->replot(QCustomPlot::rpQueuedReplot);
}

void VectorView::setOrigin(const PictureOrigin& origin)
{
    d->origin = origin;
}

/// Grid and errors, lengths of both axes to one scale.
void VectorView::showWhole()
{
    d->isWhole = true;
    d->laidOut = {};
    if (d->plane.isValid()) {
        const auto rangeOf = [this](std::size_t n) {
            const GridAxis& axis = d->plane.grid().axes[n];
            constexpr double margin = 1.06;
            const double beyond = d->factor->factor() * d->plane.largest(n);
            QCPRange range(axis.start - beyond, axis.last() + beyond);
            const double more = range.size() * (margin - 1.0) / 2.0;
            return QCPRange(range.lower - more, range.upper + more);
        };
        d->wholeX = rangeOf(0);
        d->wholeY = rangeOf(1);
        followLayout();
    }
    d->plot->replot(QCustomPlot::rpQueuedReplot);
}

/// The shorter axis shows more than it needs, so that a millimetre is as long on both.
void VectorView::followLayout()
{
    const QRect place = d->plot->axisRect()->rect();
    if (!d->plane.isValid() || !d->isWhole || place == d->laidOut || place.isEmpty())
        return;
    d->laidOut = place;
    QCPRange x = d->wholeX;
    QCPRange y = d->wholeY;
    const double ratio = d->unitRatio();
    const double strip =
        std::min(x.size(), y.size() * ratio) / std::max(x.size(), y.size() * ratio);
    if (d->hasOneScale() && strip > narrowest) {
        const double perPixel =
            std::max(x.size() / place.width(), y.size() * ratio / place.height());
        const double spanX = perPixel * place.width() / 2.0;
        const double spanY = perPixel * place.height() / ratio / 2.0;
        x = QCPRange(x.center() - spanX, x.center() + spanX);
        y = QCPRange(y.center() - spanY, y.center() + spanY);
    }
    d->plot->xAxis->setRange(x);
    d->plot->yAxis->setRange(y);
}

void VectorView::showPalette(const QPalette& palette) const
{
    d->pens = pensFor(palette);
    d->plot->setBackground(d->pens.base);
    for (QCPAxis* axis : {d->plot->xAxis, d->plot->yAxis, d->plot->xAxis2, d->plot->yAxis2}) {
        for (const auto setPen :
            {&QCPAxis::setBasePen, &QCPAxis::setTickPen, &QCPAxis::setSubTickPen})
            (axis->*setPen)(QPen(d->pens.text));
        axis->setTickLabelColor(d->pens.text);
        axis->setLabelColor(d->pens.text);
        axis->grid()->setVisible(false); // the picture is a grid
    }
}

void VectorView::retranslate()
{
    d->slice->retranslate();
    d->factor->retranslate();
    d->factorLabel->setText(tr("Errors"));
    d->factor->setToolTip(tr("How many times too large errors are drawn (+ and -)"));
    d->factor->setAccessibleDescription(d->factor->toolTip());
    d->reset->setText(tr("W&hole view"));
    d->reset->setToolTip(
        tr("Show the whole grid again (Home or a double click). The wheel, Page Up "
           "and Page Down zoom, dragging and the arrow keys move."));
    d->save->setText(tr("Save picture…"));
    d->save->setToolTip(tr("Save as PNG, SVG or PDF"));
    for (QToolButton* button : {d->reset, d->save})
        button->setAccessibleDescription(button->toolTip());
    d->plot->setAccessibleName(tr("Grid with the errors of two axes"));
    showTexts();
}

void VectorView::showTexts()
{
    for (std::size_t n = 0; n < d->boxes.size(); ++n) {
        const QString name = d->data ? dimensionName(d->data->grid, d->drawn[n]) : QString();
        d->labels[n]->setText(name);
        d->boxes[n]->setToolTip(tr("The column with the errors along %1").arg(name));
        d->boxes[n]->setAccessibleName(d->boxes[n]->toolTip());
        if (d->plane.isValid())
            (n == 0 ? d->plot->xAxis : d->plot->yAxis)
                ->setLabel(withUnit(name, d->plane.grid().axes[n].unit));
    }
    d->note->setText(d->plane.isValid()
            ? tr("Thin: the grid as the encoders read it. Bold: where the axes really are, errors "
                 "× %1.")
                  .arg(factorText(d->factor->factor()))
            : tr("The file has no errors of both axes of this slice: cut another dimension."));
    d->plot->setAccessibleDescription(d->note->text());
}

QFuture<QString> VectorView::exportTo(const QString& path) const
{
    showPalette(QPalette(Qt::white));
    const PictureDrawing drawing = drawingOf(*d->plot, nullptr);
    showPalette(palette());
    d->plot->replot(QCustomPlot::rpQueuedReplot);
    const QString title = tr("%1 and %2, errors × %3")
                              .arg(d->boxes[0]->currentText(), d->boxes[1]->currentText(),
                                  factorText(d->factor->factor()));
    return savePicture(
        drawing, pictureCaption(title, d->origin, QDateTime::currentDateTime()), path);
}

void VectorView::askForExport()
{
    askForPictureFile(
        *this, proposedPictureName(d->origin, tr("errors of two axes")), false,
        [this](const QString& path) { return exportTo(path); },
        [this](const QString& sentence) { d->note->setText(sentence); });
}

void VectorView::showMenu(const QPoint& place)
{
    if (!d->plane.isValid())
        return;
    auto* menu = new QMenu(this);
    menu->setAttribute(Qt::WA_DeleteOnClose);
    connect(menu->addAction(d->reset->text()), &QAction::triggered, d->reset, &QToolButton::click);
    connect(menu->addAction(tr("Copy picture")), &QAction::triggered, this,
        [this] { QGuiApplication::clipboard()->setPixmap(d->plot->toPixmap()); });
    connect(menu->addAction(d->save->text()), &QAction::triggered, d->save, &QToolButton::click);
    menu->popup(d->plot->mapToGlobal(place));
}

bool VectorView::handleKey(int key)
{
    const auto pan = [this](double x, double y) {
        constexpr double part = 0.1;
        d->plot->xAxis->moveRange(x * part * d->plot->xAxis->range().size());
        d->plot->yAxis->moveRange(y * part * d->plot->yAxis->range().size());
        d->isWhole = false;
        d->plot->replot(QCustomPlot::rpQueuedReplot);
        return true;
    };
    const auto zoom = [this](double factor) {
        for (QCPAxis* axis : {d->plot->xAxis, d->plot->yAxis})
            axis->scaleRange(factor, axis->range().center());
        d->isWhole = false;
        d->plot->replot(QCustomPlot::rpQueuedReplot);
        return true;
    };
    constexpr double zoomStep = 0.8;
    switch (key) {
    case Qt::Key_Left:
        return pan(-1.0, 0.0);
    case Qt::Key_Right:
        return pan(1.0, 0.0);
    case Qt::Key_Up:
        return pan(0.0, 1.0);
    case Qt::Key_Down:
        return pan(0.0, -1.0);
    case Qt::Key_PageUp:
        return zoom(zoomStep);
    case Qt::Key_PageDown:
        return zoom(1.0 / zoomStep);
    case Qt::Key_Plus:
        d->factor->step(1);
        return true;
    case Qt::Key_Minus:
        d->factor->step(-1);
        return true;
    case Qt::Key_Home:
        d->reset->click();
        return true;
    default:
        return false;
    }
}

bool VectorView::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::KeyPress: {
        const auto* key = static_cast<QKeyEvent*>(event);
        const bool isPlain = !(key->modifiers() & (Qt::ControlModifier | Qt::AltModifier));
        if (d->plane.isValid() && isPlain && handleKey(key->key()))
            return true;
        break;
    }
    case QEvent::MouseButtonDblClick:
        d->reset->click();
        return true;
    case QEvent::Wheel:
        d->isWhole = false;
        break;
    case QEvent::MouseMove:
        if (static_cast<QMouseEvent*>(event)->buttons() & Qt::LeftButton)
            d->isWhole = false;
        break;
    default:
        break;
    }
    return QWidget::eventFilter(watched, event);
}

void VectorView::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange)
        retranslate();
    if (event->type() == QEvent::PaletteChange) {
        showPalette(palette());
        d->plot->replot(QCustomPlot::rpQueuedReplot);
    }
}

} // namespace axiscomp::ui
