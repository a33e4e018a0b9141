// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/table_plot_p.h"

#include "ui/plot_export.h"
#include "ui/plot_values.h"
#include "ui/value_text.h"

#include <QBoxLayout>
#include <QComboBox>
#include <QEvent>
#include <QFileDialog>
#include <QKeyEvent>
#include <QLabel>
#include <QMouseEvent>
#include <QSlider>
#include <QToolButton>

#include <qcustomplot.h>

#include <QStandardItemModel>

#include <algorithm>

namespace axiscomp::ui {

TablePlot::TablePlot(QWidget* parent) : QWidget(parent), d(std::make_unique<Private>())
{
    build();
    connectTools();
    retranslate();
    showTables();
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
    d->contentBox = new QComboBox(this);
    d->contentBox->setObjectName(QStringLiteral("plotContent"));
    for (const PlotContent content :
        {PlotContent::Selected, PlotContent::Drive, PlotContent::Difference})
        d->contentBox->addItem(QString(), static_cast<int>(content));
    d->cursorsButton = tool("plotCursors");
    d->cursorsButton->setCheckable(true);
    d->resetButton = tool("plotResetZoom");
    d->exportButton = tool("plotExport");
    auto* tools = new QHBoxLayout;
    tools->addWidget(d->contentBox);
    tools->addStretch(1);
    for (QToolButton* button : {d->cursorsButton, d->resetButton, d->exportButton})
        tools->addWidget(button);

    d->canvas = new PlotCanvas(this);
    QCustomPlot& plot = d->canvas->plot();
    plot.setMinimumSize(260, 160);
    plot.setFocusPolicy(Qt::StrongFocus);
    plot.setMouseTracking(true);
    plot.installEventFilter(this);

    d->sliceRow = new QWidget(this);
    d->sliceLabel = new QLabel(d->sliceRow);
    d->sliceBox = new QComboBox(d->sliceRow);
    d->sliceBox->setObjectName(QStringLiteral("sliceDimension"));
    d->sliceSlider = new QSlider(Qt::Horizontal, d->sliceRow);
    d->sliceSlider->setObjectName(QStringLiteral("sliceIndex"));
    d->sliceValue = new QLabel(d->sliceRow);
    d->sliceLabel->setBuddy(d->sliceBox);
    auto* slice = new QHBoxLayout(d->sliceRow);
    slice->setContentsMargins(0, 0, 0, 0);
    slice->addWidget(d->sliceLabel);
    slice->addWidget(d->sliceBox);
    slice->addWidget(d->sliceSlider, 1);
    slice->addWidget(d->sliceValue);

    d->readout = new QLabel(this);
    d->readout->setObjectName(QStringLiteral("plotReadout"));
    d->readout->setTextInteractionFlags(Qt::TextSelectableByMouse);
    d->readout->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(4, 4, 4, 4);
    layout->setSpacing(4);
    layout->addLayout(tools);
    layout->addWidget(&plot, 1);
    layout->addWidget(d->sliceRow);
    layout->addWidget(d->readout);
}

void TablePlot::connectTools()
{
    connect(d->contentBox, &QComboBox::activated, this, [this](int index) {
        setContent(static_cast<PlotContent>(d->contentBox->itemData(index).toInt()));
    });
    connect(d->cursorsButton, &QToolButton::toggled, this, &TablePlot::setCursorsShown);
    connect(d->resetButton, &QToolButton::clicked, this, [this] { d->canvas->resetZoom(); });
    connect(d->exportButton, &QToolButton::clicked, this, &TablePlot::askForExport);
    connect(d->sliceBox, &QComboBox::activated, this,
        [this](int index) { setSlice(index + 1, d->sliceSlider->value()); });
    connect(d->sliceSlider, &QSlider::valueChanged, this, &TablePlot::showSlice);
}

void TablePlot::setTables(std::shared_ptr<const CompensationTable> selected,
    std::shared_ptr<const CompensationTable> onDrive)
{
    if (selected == d->selected && onDrive == d->onDrive)
        return;
    d->selected = std::move(selected);
    d->onDrive = std::move(onDrive);
    if (!canShow(d->content))
        d->content = PlotContent::Selected;
    showTables();
}

bool TablePlot::canShow(PlotContent content) const
{
    switch (content) {
    case PlotContent::Selected:
        return true;
    case PlotContent::Drive:
        return d->onDrive != nullptr;
    case PlotContent::Difference:
        return d->selected && d->onDrive && d->selected != d->onDrive
            && d->selected->grid.dimensions() == d->onDrive->grid.dimensions();
    }
    return false;
}

void TablePlot::setContent(PlotContent content)
{
    if (!canShow(content) || content == d->content)
        return;
    d->content = content;
    showTables();
}

PlotContent TablePlot::content() const
{
    return d->content;
}

void TablePlot::showTables()
{
    d->shown = d->content == PlotContent::Drive ? d->onDrive : d->selected;
    if (d->content == PlotContent::Difference)
        d->shown =
            std::make_shared<const CompensationTable>(*tableDifference(*d->selected, *d->onDrive));
    for (int i = 0; i < d->contentBox->count(); ++i) {
        auto* model = qobject_cast<QStandardItemModel*>(d->contentBox->model());
        const auto content = static_cast<PlotContent>(d->contentBox->itemData(i).toInt());
        model->item(i)->setEnabled(canShow(content));
    }
    d->contentBox->setCurrentIndex(d->contentBox->findData(static_cast<int>(d->content)));
    d->cursors = {};
    d->hovered.reset();
    d->cut = std::min<std::size_t>(d->cut, 2);
    d->sliceRow->setVisible(d->isCut());
    if (d->isCut())
        setSlice(
            static_cast<int>(d->cut) + 1, static_cast<int>(d->shown->grid.axes[d->cut].size / 2));
    else
        showSlice();
}

void TablePlot::setSlice(int dimension, int index)
{
    if (!d->isCut())
        return;
    d->cut = static_cast<std::size_t>(std::clamp(dimension, 1, 3) - 1);
    const QSignalBlocker blockBox(d->sliceBox);
    const QSignalBlocker blockSlider(d->sliceSlider);
    d->sliceBox->clear();
    for (std::size_t n = 0; n < 3; ++n)
        d->sliceBox->addItem(dimensionName(d->shown->grid, n));
    d->sliceBox->setCurrentIndex(static_cast<int>(d->cut));
    d->sliceSlider->setMaximum(static_cast<int>(d->shown->grid.axes[d->cut].size) - 1);
    d->sliceSlider->setValue(index);
    showSlice();
}

int TablePlot::sliceDimension() const
{
    return static_cast<int>(d->cut) + 1;
}

int TablePlot::sliceIndex() const
{
    return d->sliceSlider->value();
}

void TablePlot::showSlice()
{
    d->drawn = d->shown;
    if (d->isCut()) {
        const auto index = static_cast<std::size_t>(d->sliceSlider->value());
        const GridAxis& axis = d->shown->grid.axes[d->cut];
        d->drawn = std::make_shared<const CompensationTable>(tableSlice(*d->shown, d->cut, index));
        d->sliceValue->setText(
            numberText(axis.position(index)) + u' ' + QString::fromStdString(axis.unit));
    }
    const bool comparesCurves = d->content == PlotContent::Selected && d->onDrive
        && d->onDrive != d->selected && d->selected && d->selected->grid.dimensions() == 1
        && d->onDrive->grid.dimensions() == 1;
    d->canvas->show(d->drawn, comparesCurves ? d->onDrive : nullptr,
        d->shown ? largestMagnitude(*d->shown) : 1.0);
    for (QToolButton* button : {d->cursorsButton, d->resetButton, d->exportButton})
        button->setEnabled(d->drawn != nullptr);
    retranslate();
    setCursorsShown(d->hasCursors);
    showMarker();
}

void TablePlot::setMarker(const std::optional<Marker>& marker)
{
    d->marker = marker;
    showMarker();
}

void TablePlot::showMarker()
{
    if (!d->marker || !d->drawn) {
        d->canvas->setMarker(std::nullopt, 0.0);
        return;
    }
    const std::array<double, 2> position{d->marker->positions[d->dimensionOf(0)],
        d->isMap() ? d->marker->positions[d->dimensionOf(1)] : 0.0};
    d->canvas->setMarker(position, d->marker->output);
}

QString TablePlot::exportTo(const QString& path) const
{
    if (!d->drawn)
        return tr("There is no table to save.");
    return exportPlot(d->canvas->plot(), *d->drawn, path);
}

void TablePlot::askForExport()
{
    auto* dialog = new QFileDialog(this, tr("Save the picture or its values"));
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    dialog->setAcceptMode(QFileDialog::AcceptSave);
    dialog->setNameFilters({tr("Picture (*.png)"), tr("Document (*.pdf)"), tr("Values (*.csv)")});
    dialog->setDefaultSuffix(QStringLiteral("png"));
    connect(dialog, &QFileDialog::filterSelected, dialog, [dialog](const QString& filter) {
        dialog->setDefaultSuffix(filter.section(u'.', -1).chopped(1));
    });
    connect(dialog, &QFileDialog::fileSelected, this, [this](const QString& path) {
        const QString problem = exportTo(path);
        d->readout->setText(problem.isEmpty() ? tr("Saved as %1").arg(path) : problem);
    });
    dialog->open();
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
    if (event->type() == QEvent::KeyPress) {
        const auto* key = static_cast<QKeyEvent*>(event);
        if (handleKey(key->key(), key->modifiers()))
            return true;
    } else if (event->type() == QEvent::MouseMove || event->type() == QEvent::MouseButtonPress) {
        const auto* mouse = static_cast<QMouseEvent*>(event);
        const bool isPress = event->type() == QEvent::MouseButtonPress;
        // Shift draws the rectangle that is zoomed into; without it the picture is dragged.
        d->canvas->plot().setSelectionRectMode(
            mouse->modifiers() & Qt::ShiftModifier ? QCP::srmZoom : QCP::srmNone);
        if (isPress && d->hasCursors && mouse->button() == Qt::LeftButton
            && mouse->modifiers() == Qt::NoModifier)
            placeCursor(mouse->position());
        d->hovered = d->canvas->pointAt(mouse->position());
        d->canvas->setCrosshair(d->hasCursors ? std::nullopt : d->hovered);
        showReadout();
    } else if (event->type() == QEvent::Leave) {
        d->hovered.reset();
        d->canvas->setCrosshair(std::nullopt);
        showReadout();
    }
    return QWidget::eventFilter(watched, event);
}

} // namespace axiscomp::ui
