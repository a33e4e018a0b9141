// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/plot/table_thumbnail.h"

#include "ui/drawing/custom_plot.h"
#include "ui/drawing/plot_canvas.h"
#include "ui/style/plain_label.h"
#include "ui/text/value_scale.h"
#include "ui/text/value_text.h"

#include <QBoxLayout>
#include <QEvent>

#include <algorithm>

namespace axiscomp::ui {

namespace {

constexpr int fewTicks = 3;
constexpr int linesOfText = 8; // the height of a picture
constexpr double smallestScale = 1e-9; // a table of zeros has a picture, too

/// The scale of colours has no room here: the line below says the largest value.
void removeColorScale(QCustomPlot& plot)
{
    QCPLayoutGrid* layout = plot.plotLayout();
    if (!layout->hasElement(0, 1))
        return;
    QCPLayoutElement* scale = layout->element(0, 1);
    layout->take(scale);
    layout->simplify();
    scale->setVisible(false);
}

} // namespace

TableThumbnail::TableThumbnail(QWidget* parent)
    : QWidget(parent)
    , m_title(new PlainLabel)
    , m_canvas(new PlotCanvas(this))
    , m_line(new PlainLabel)
{
    m_title->setObjectName(QStringLiteral("thumbnailTitle"));
    QFont bold = m_title->font();
    bold.setBold(true);
    m_title->setFont(bold);
    m_line->setObjectName(QStringLiteral("thumbnailLine"));
    for (QLabel* label : {m_title, m_line}) {
        label->setWordWrap(true);
        label->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
    }
    m_line->setAlignment(Qt::AlignLeft | Qt::AlignTop);
    QCustomPlot& plot = m_canvas->plot();
    plot.setInteractions(QCP::Interactions());
    plot.setFocusPolicy(Qt::NoFocus);
    // The wheel scrolls what the picture is in.
    plot.setAttribute(Qt::WA_TransparentForMouseEvents);
    plot.setFixedHeight(linesOfText * fontMetrics().lineSpacing());
    QFont smaller = font();
    smaller.setPointSizeF(smaller.pointSizeF() * 0.85);
    for (QCPAxis* axis : {plot.xAxis, plot.yAxis}) {
        axis->setTickLabelFont(smaller);
        axis->ticker()->setTickCount(fewTicks);
    }
    auto* layout = new QVBoxLayout(this);
    layout->setContentsMargins(0, 0, 0, 0);
    layout->setSpacing(2);
    layout->addWidget(m_title);
    layout->addWidget(&plot);
    layout->addWidget(m_line);
    layout->addStretch(1);
}

TableThumbnail::~TableThumbnail() = default;

void TableThumbnail::setPicture(
    const std::shared_ptr<const CompensationTable>& drawn, double scale, const std::string& unit)
{
    const double half = std::max(scale, smallestScale);
    const std::array<float, 1> largest{static_cast<float>(half)};
    const ValueScale values(unit, largest);
    m_canvas->setValueScale(values);
    m_canvas->show(drawn, nullptr, half);
    m_canvas->setLabels({}, {}, qString(values.unit())); // after it: which axis has the values
    QCustomPlot& plot = m_canvas->plot();
    removeColorScale(plot);
    if (drawn && drawn->grid.dimensions() == 1)
        plot.yAxis->setRange(-1.1 * half, 1.1 * half);
    m_canvas->replot();
}

void TableThumbnail::setTexts(const QString& title, const QString& line)
{
    m_title->setText(title);
    m_line->setText(line);
    m_canvas->plot().setAccessibleName(title);
    m_canvas->plot().setAccessibleDescription(line);
}

void TableThumbnail::changeEvent(QEvent* event)
{
    if (event->type() == QEvent::PaletteChange) {
        m_canvas->setPalette(palette());
        m_canvas->replot();
    }
    QWidget::changeEvent(event);
}

} // namespace axiscomp::ui
