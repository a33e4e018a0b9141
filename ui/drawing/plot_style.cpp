// SPDX-License-Identifier: GPL-3.0-or-later
#include "ui/drawing/plot_style.h"

#include "core/metrology/report/plot_ink.h"
#include "ui/style/contrast.h"
#include "ui/text/translated_text.h"
#include "ui/text/value_text.h"

#include "ui/drawing/custom_plot.h"

#include <QCoreApplication>

namespace axiscomp::ui {

namespace {

struct PlotStyle {
    Q_DECLARE_TR_FUNCTIONS(axiscomp::ui::PlotStyle)
};

QColor inkOn(const QColor& base, PlotInk ink, double ratio)
{
    const std::string_view name = report::inkColour(ink);
    const QColor color(QLatin1StringView(name.data(), static_cast<qsizetype>(name.size())));
    const QColor backgrounds[] = {base};
    return withContrast(color, backgrounds, ratio);
}

} // namespace

void stylePlotAxis(QCPAxis& axis, const QColor& text, const QColor& grid)
{
    axis.setBasePen(QPen(text));
    axis.setTickPen(QPen(text));
    axis.setSubTickPen(QPen(text));
    axis.setTickLabelColor(text);
    axis.setLabelColor(text);
    axis.grid()->setPen(QPen(grid, 1, Qt::DotLine));
    axis.grid()->setZeroLinePen(QPen(grid, 1, Qt::SolidLine));
}

MeasurementInks::MeasurementInks(const QPalette& palette)
    : base(palette.color(QPalette::Base))
    , text(palette.color(QPalette::Text))
    , grid(mutedTextColor(palette))
    , run(inkOn(base, PlotInk::Run, 3.0))
    , up(inkOn(base, PlotInk::Up, 4.5))
    , down(inkOn(base, PlotInk::Down, 4.5))
    , doubtful(textColor(Tone::Error, palette))
    , selected(palette.color(QPalette::Highlight))
{
}

void letLegendBeWide(QCPLegend& legend)
{
    constexpr int beyondAnyScreen = 100'000; // pixels
    legend.setMaximumSize(QSize(beyondAnyScreen, beyondAnyScreen));
}

void stylePlot(QCustomPlot& plot, const MeasurementInks& inks)
{
    plot.setBackground(inks.base);
    for (QCPAxis* axis : {plot.xAxis, plot.yAxis, plot.xAxis2, plot.yAxis2})
        stylePlotAxis(*axis, inks.text, inks.grid);
    plot.legend->setBrush(Qt::NoBrush);
    plot.legend->setBorderPen(Qt::NoPen);
    plot.legend->setTextColor(inks.text);
}

QString deviationLabel(
    const FineUnit& unit, const std::optional<PlacedDeviation>& datum, bool isAngular)
{
    const QString name = withUnit(PlotStyle::tr("Deviation"), unit.symbol);
    return datum ? name + u'\n' + translated(datumText(*datum, isAngular)) : name;
}

} // namespace axiscomp::ui
