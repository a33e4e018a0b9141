// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/async/background_job.h"
#include "ui/drawing/plot_export.h"
#include "ui/plot/slice_row.h"
#include "ui/plot/table_content_combo.h"
#include "ui/plot/table_plot_p.h"

#include <QAction>
#include <QApplication>
#include <QBoxLayout>
#include <QClipboard>
#include <QEvent>
#include <QFileInfo>
#include <QKeyEvent>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QToolButton>

#include <algorithm>
#include <limits>
#include <span>

#include "ui/drawing/custom_plot.h"
#include "ui/style/plain_label.h"

namespace axiscomp::ui {

TablePlot::TablePlot(TableViewModel& shown, QWidget* parent)
    : QWidget(parent)
    , d(std::make_unique<Private>(shown))
{
    build();
    connectTools();
    showTable();
}

TablePlot::~TablePlot() = default;

void TablePlot::build()
{
    const auto tool = [this](const char* name) {
        auto* button = new QToolButton(this);
        button->setObjectName(QLatin1StringView(name));
        button->setToolButtonStyle(Qt::ToolButtonTextOnly);
        button->setAutoRaise(true);
        button->setFocusPolicy(Qt::StrongFocus);
        return button;
    };
    d->contentBox = new TableContentCombo(d->shown, this);
    d->contentBox->setObjectName(QStringLiteral("plotContent"));
    d->showButton = tool("plotShow");
    d->showButton->setPopupMode(QToolButton::InstantPopup);
    d->showButton->setMenu(new QMenu(d->showButton));
    d->cursorsButton = tool("plotCursors");
    d->cursorsButton->setCheckable(true);
    d->resetButton = tool("plotResetZoom");
    d->exportButton = tool("plotExport");
    d->tools = new QHBoxLayout;
    d->tools->addWidget(d->contentBox);
    d->tools->addStretch(1);
    for (QToolButton* button : {d->showButton, d->cursorsButton, d->resetButton, d->exportButton})
        d->tools->addWidget(button);

    d->canvas = new PlotCanvas(this);
    QCustomPlot& plot = d->canvas->plot();
    plot.setMinimumSize(260, 90);
    plot.setFocusPolicy(Qt::StrongFocus);
    plot.setMouseTracking(true);
    plot.installEventFilter(this);
    plot.setContextMenuPolicy(Qt::CustomContextMenu);
    connect(&plot, &QWidget::customContextMenuRequested, this, &TablePlot::showMenu);
    addMapActions();
    d->slice = new SliceRow(d->shown, this);
    d->readout = new PlainLabel(this);
    d->readout->setObjectName(QStringLiteral("plotReadout"));
    d->readout->setTextInteractionFlags(Qt::TextSelectableByMouse);
    d->readout->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    layout->addLayout(d->tools);
    layout->addWidget(&plot, 1);
    layout->addWidget(d->slice);
    layout->addWidget(d->readout);
}

void TablePlot::addMapActions()
{
    const auto action = [this](const char* name, Qt::Key key, auto method) {
        QAction* added = d->showButton->menu()->addAction(QString());
        added->setObjectName(QLatin1StringView(name));
        added->setCheckable(true);
        added->setShortcut(key);
        added->setShortcutContext(Qt::WidgetShortcut); // a letter is one everywhere else
        added->setShortcutVisibleInContextMenu(true);
        d->canvas->plot().addAction(added);
        connect(added, &QAction::toggled, d->canvas, method);
        return added;
    };
    d->pointsAction = action("plotPoints", Qt::Key_G, &PlotCanvas::setGridPointsShown);
    d->contoursAction = action("plotContours", Qt::Key_C, &PlotCanvas::setContoursShown);
    d->sectionsAction = action("plotSections", Qt::Key_X, &PlotCanvas::setSectionsShown);
}

void TablePlot::addTool(QWidget* tool)
{
    d->tools->insertWidget(1, tool);
    setTabOrder(d->contentBox, tool);
}

void TablePlot::connectTools()
{
    connect(d->cursorsButton, &QToolButton::toggled, this, &TablePlot::setCursorsShown);
    connect(d->resetButton, &QToolButton::clicked, this, [this] { d->canvas->resetZoom(); });
    connect(d->exportButton, &QToolButton::clicked, this, &TablePlot::askForExport);
    connect(&d->shown, &TableViewModel::changed, this, &TablePlot::showTable);
    connect(&d->shown, &TableViewModel::currentChanged, this, &TablePlot::currentChanged);
}

void TablePlot::showTable()
{
    showTravel();
    d->canvas->setValueScale(d->shown.valueScale());
    d->canvas->show(d->shown.drawn(), d->shown.second(), d->shown.scale());
    for (QToolButton* button : {d->cursorsButton, d->resetButton, d->exportButton})
        button->setEnabled(d->shown.drawn() != nullptr);
    d->showButton->setVisible(d->isMap());
    for (QAction* action : d->showButton->menu()->actions())
        action->setEnabled(d->isMap());
    d->hovered.reset();
    retranslate();
    setCursorsShown(d->hasCursors);
    showProved();
    showMeasured();
    showMarker();
}

void TablePlot::setMarker(const std::optional<Marker>& marker)
{
    d->marker = marker;
    showMarker();
}

void TablePlot::showMarker()
{
    if (!d->marker || !d->shown.drawn()) {
        d->canvas->setMarker(std::nullopt, 0.0);
        return;
    }
    const std::array<double, 2> position{d->marker->positions[d->shown.dimensionOf(0)],
        d->isMap() ? d->marker->positions[d->shown.dimensionOf(1)] : 0.0};
    const Grid& grid = d->shown.table()->grid;
    const bool isInside = isWithin(grid, std::span(d->marker->positions).first(grid.axes.size()));
    d->canvas->setMarker(position, d->marker->output,
        isInside || !holdsEnds() ? QString() : tr("outside the table: end value held"));
}

/// A difference is known on the table's points alone.
bool TablePlot::holdsEnds() const
{
    return d->holdsEnds && d->shown.content() != TableContent::Difference;
}

void TablePlot::setTravel(const std::array<std::optional<Travel>, 3>& travel, bool holdsEnds)
{
    if (travel == d->travel && holdsEnds == d->holdsEnds)
        return;
    d->travel = travel;
    d->holdsEnds = holdsEnds;
    showTravel();
}

void TablePlot::showTravel()
{
    if (!d->shown.drawn())
        return;
    d->canvas->setTravel({d->travel[d->shown.dimensionOf(0)],
                             d->isMap() ? d->travel[d->shown.dimensionOf(1)] : std::nullopt},
        holdsEnds());
}

void TablePlot::setProved(const ProvedPart* part)
{
    const auto count = [](const ProvedPart* proved) { return proved ? proved->seen().size() : 0; };
    if (count(part) == count(d->proved ? &*d->proved : nullptr))
        return;
    d->proved = part ? std::optional(*part) : std::nullopt;
    showProved();
}

/// Of a slice: the cells on both sides of it.
void TablePlot::showProved()
{
    QVector<double> keys;
    QVector<double> values;
    const auto& drawn = d->shown.drawn();
    const bool isOfDrive = drawn && d->proved && d->shown.showsDriveTable()
        && sameSpans(d->proved->grid(), d->shown.table()->grid);
    std::vector<std::size_t> cells = isOfDrive ? d->proved->seen() : std::vector<std::size_t>();
    std::ranges::sort(cells);
    for (const std::size_t cell : cells) {
        const std::array<double, 3> middle = d->proved->middleOf(cell);
        if (d->shown.isCut() && !d->shown.isAtSlice(middle))
            continue;
        if (d->isMap()) {
            keys += middle[d->shown.dimensionOf(0)];
            values += middle[d->shown.dimensionOf(1)];
            continue;
        }
        const GridAxis& axis = drawn->grid.axes[0];
        for (const std::size_t point : {cell, cell + 1}) {
            keys += axis.position(point);
            values += static_cast<double>(drawn->values[point]);
        }
        keys += axis.position(cell + 1);
        values += std::numeric_limits<double>::quiet_NaN();
    }
    d->canvas->setProved(keys, values);
}

void TablePlot::setMeasured(std::vector<std::array<double, 3>> places)
{
    d->measured = std::move(places);
    d->canvas->setFilledHatched(!d->measured.empty());
    showMeasured();
}

/// Of a slice: what lies in the cells on both sides of it.
void TablePlot::showMeasured()
{
    QVector<double> x;
    QVector<double> y;
    for (const std::array<double, 3>& place : d->measured) {
        if (!d->isMap() || (d->shown.isCut() && !d->shown.isAtSlice(place)))
            continue;
        x += place.at(d->shown.dimensionOf(0));
        y += place.at(d->shown.dimensionOf(1));
    }
    d->canvas->setMeasured(x, y);
}

void TablePlot::setOrigin(const PictureOrigin& origin)
{
    d->origin = origin;
}

void TablePlot::setValuesOrigin(ValuesOrigin origin)
{
    d->values = std::move(origin);
}

QFuture<QString> TablePlot::exportTo(const QString& path) const
{
    const auto& shown = d->shown.drawn();
    const bool isValues = QFileInfo(path).suffix().toLower() == u"csv";
    if (!shown || (!isValues && !isPictureName(path)))
        return inBackground<QString>(
            [problem = shown ? tr("The file name must end in .png, .svg, .pdf or .csv.")
                             : tr("There is no table to save.")] { return problem; });
    if (isValues)
        return exportValues(path);
    d->canvas->setPalette(QPalette(Qt::white));
    const PictureDrawing drawing = drawingOf(d->canvas->plot(), shown);
    d->canvas->setPalette(palette());
    d->canvas->replot();
    return savePicture(
        drawing, pictureCaption(d->shown.title(), d->origin, QDateTime::currentDateTime()), path);
}

/// Under the name of the table anything else would be taken for it.
QFuture<QString> TablePlot::exportValues(const QString& path) const
{
    const TableContent content = d->shown.content();
    QString problem;
    if (content == TableContent::Difference)
        problem = tr("A difference is no table for a drive: it can be saved as a picture only.");
    else if (content == TableContent::Selected && !d->values.isOfDrive)
        problem = tr("These are values of another controller: Export for Another Controller "
                     "writes its file.");
    if (!problem.isEmpty())
        return inBackground<QString>([problem] { return problem; });
    return saveValues(d->shown.table(),
        content == TableContent::Drive ? d->values.onDrive : d->values.selected, path);
}

void TablePlot::askForExport()
{
    askForPictureFile(
        *this, proposedPictureName(d->origin, d->isMap() ? tr("map") : tr("curve")), true,
        [this](const QString& path) { return exportTo(path); },
        [this](const QString& sentence) { d->readout->setText(sentence); });
}

void TablePlot::showMenu(const QPoint& place)
{
    if (!d->shown.drawn())
        return;
    auto* menu = new QMenu(this);
    menu->setObjectName(QStringLiteral("plotMenu"));
    menu->setAttribute(Qt::WA_DeleteOnClose);
    const auto pressing = [menu](QToolButton* button) {
        QAction* action = menu->addAction(button->text());
        action->setCheckable(button->isCheckable());
        action->setChecked(button->isChecked());
        connect(action, &QAction::triggered, button, &QToolButton::click);
    };
    pressing(d->resetButton);
    pressing(d->cursorsButton);
    if (d->isMap())
        menu->addActions(d->showButton->menu()->actions());
    menu->addSeparator();
    connect(menu->addAction(tr("Copy picture")), &QAction::triggered, this,
        [this] { QGuiApplication::clipboard()->setPixmap(d->canvas->plot().toPixmap()); });
    pressing(d->exportButton);
    menu->popup(d->canvas->plot().mapToGlobal(place));
}

void TablePlot::changeEvent(QEvent* event)
{
    QWidget::changeEvent(event);
    if (event->type() == QEvent::LanguageChange) {
        retranslate();
        showReadout();
    }
    if (event->type() == QEvent::PaletteChange) {
        d->canvas->setPalette(palette());
        d->canvas->replot();
    }
}

bool TablePlot::eventFilter(QObject* watched, QEvent* event)
{
    switch (event->type()) {
    case QEvent::KeyPress: {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (handleKey(key->key(), key->modifiers()))
            return true;
        break;
    }
    case QEvent::MouseMove:
    case QEvent::MouseButtonPress:
    case QEvent::MouseButtonRelease:
        handleMouse(static_cast<const QMouseEvent&>(*event));
        break;
    case QEvent::MouseButtonDblClick:
        d->canvas->resetZoom();
        return true;
    case QEvent::Leave:
        d->hovered.reset();
        showCurrent();
        break;
    default:
        break;
    }
    return QWidget::eventFilter(watched, event);
}

void TablePlot::handleMouse(const QMouseEvent& mouse)
{
    // Shift draws the rectangle that is zoomed into; without it the picture is dragged.
    const bool hasShift = mouse.modifiers() & Qt::ShiftModifier;
    d->canvas->plot().setSelectionRectMode(hasShift ? QCP::srmZoom : QCP::srmNone);
    if (mouse.type() == QEvent::MouseButtonPress)
        d->pressed = mouse.position();
    const bool isStill =
        (mouse.position() - d->pressed).manhattanLength() < QApplication::startDragDistance();
    d->hovered = d->canvas->pointAt(mouse.position());
    if (mouse.type() == QEvent::MouseButtonRelease && mouse.button() == Qt::LeftButton && !hasShift
        && isStill && d->hovered)
        d->shown.setCurrent(d->hovered);
    showCurrent();
}

} // namespace axiscomp::ui
