// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/report/report_html.h"

#include "core/metrology/report/plot_ink.h"
#include "core/text/number_text.h"
#include "core/text/xml_tags.h"

#include <algorithm>

namespace axiscomp {

namespace {

constexpr std::string_view style = R"(
@page { size: A4; margin: 15mm; }
body { font: 8pt/1.3 "DejaVu Sans", Verdana, sans-serif; color: #000; background: #fff;
  width: 180mm; margin: 8mm auto; }
@media print { body { margin: 0; } }
h1 { font-size: 13pt; margin: 0 0 1mm; }
h2 { font-size: 9pt; margin: 2.5mm 0 0.5mm; border-bottom: 0.2mm solid #888; break-after: avoid; }
p { margin: 0.5mm 0; overflow-wrap: anywhere; }
p.strong { font-size: 10pt; font-weight: bold; }
dl { display: grid; column-gap: 4mm; margin: 0.5mm 0; }
dl.one { grid-template-columns: auto 1fr; }
dl.two { grid-template-columns: auto 1fr auto 1fr; }
dt { color: #444; }
dd { margin: 0; overflow-wrap: anywhere; }
table { border-collapse: collapse; width: 100%; }
th, td { text-align: left; vertical-align: top; padding: 0.1mm 2mm 0.1mm 0; font-weight: normal;
  overflow-wrap: anywhere; }
thead th { color: #444; border-bottom: 0.1mm solid #bbb; }
table.numbers th:not(:first-child), table.numbers td { text-align: right;
  font-variant-numeric: tabular-nums; }
.plots { display: flex; justify-content: space-between; }
.page { break-before: page; }
)";

std::string escaped(const Text& text)
{
    return xmlEscaped(text.english());
}

std::string millimetres(double value)
{
    return fixedDigits(value, 3);
}

std::string points(const std::vector<PlotPoint>& list)
{
    std::string text;
    for (const PlotPoint& point : list)
        text.append(text.empty() ? "" : " ")
            .append(millimetres(point.x) + ',' + millimetres(point.y));
    return text;
}

std::string lineSvg(const PlotLine& line)
{
    std::string dashes;
    for (const double length : line.dashes)
        dashes.append(dashes.empty() ? "" : " ").append(millimetres(length));
    return "<polyline points=\"" + points(line.points) + "\" fill=\"none\" stroke=\""
        + std::string(report::inkColour(line.ink)) + "\" stroke-width=\"" + millimetres(line.width)
        + (dashes.empty() ? "" : "\" stroke-dasharray=\"" + dashes) + "\"/>\n";
}

std::string markerSvg(const PlotMarker& marker)
{
    const std::string colour(report::inkColour(marker.ink));
    const bool isFilled = marker.shape == PlotMarkerShape::TriangleUp;
    return "<polygon points=\"" + points(report::markerOutline(marker)) + "\" fill=\""
        + (isFilled ? colour : "#ffffff") + "\" stroke=\"" + colour
        + "\" stroke-width=\"0.200\"/>\n";
}

std::string labelSvg(const PlotLabel& label)
{
    const char* const anchor = label.side == PlotLabel::Side::Left ? "start"
        : label.side == PlotLabel::Side::Right                     ? "end"
                                                                   : "middle";
    const std::string x = millimetres(label.place.x);
    const std::string y = millimetres(label.place.y);
    return "<text x=\"" + x + "\" y=\"" + y + "\" font-size=\"" + millimetres(label.size)
        + "\" text-anchor=\"" + anchor
        + (label.isVertical ? "\" transform=\"rotate(-90 " + x + ' ' + y + ')' : std::string())
        + "\">" + escaped(label.text) + "</text>\n";
}

std::string plotSvg(const ReportPlot& plot)
{
    const std::string width = millimetres(plot.width);
    const std::string height = millimetres(plot.height);
    std::string svg = "<svg width=\"" + width + "mm\" height=\"" + height + "mm\" viewBox=\"0 0 "
        + width + ' ' + height + "\" role=\"img\" aria-label=\"" + escaped(plot.description)
        + "\">\n";
    for (const PlotBand& band : plot.bands)
        svg += "<polygon points=\"" + points(band.outline) + "\" fill=\""
            + std::string(report::bandColour(band.ink)) + "\"/>\n";
    for (const PlotLine& line : plot.lines)
        svg += lineSvg(line);
    for (const PlotMarker& marker : plot.markers)
        svg += markerSvg(marker);
    for (const PlotLabel& label : plot.labels)
        svg += labelSvg(label);
    return svg + "</svg>\n";
}

class HtmlWriter {
public:
    explicit HtmlWriter(std::string& html) : m_html(html) { }

    void operator()(const ReportHeading& heading) const
    {
        m_html += "<h2>" + escaped(heading.text) + "</h2>\n";
    }
    void operator()(const ReportParagraph& paragraph) const
    {
        m_html += (paragraph.isStrong ? "<p class=\"strong\">" : "<p>") + escaped(paragraph.text)
            + "</p>\n";
    }
    void operator()(const ReportFacts& facts) const
    {
        m_html += facts.columns == 2 ? "<dl class=\"two\">\n" : "<dl class=\"one\">\n";
        for (const ReportFact& fact : facts.facts)
            m_html += "<dt>" + escaped(fact.name) + "</dt><dd>" + escaped(fact.value) + "</dd>\n";
        m_html += "</dl>\n";
    }
    void operator()(const ReportTable& table) const
    {
        m_html +=
            table.hasNumbers ? "<table class=\"numbers\">\n<thead><tr>" : "<table>\n<thead><tr>";
        // A heading without words heads nothing.
        for (const Text& cell : table.header)
            m_html += cell.isEmpty() ? "<td></td>" : "<th scope=\"col\">" + escaped(cell) + "</th>";
        m_html += "</tr></thead>\n<tbody>\n";
        for (const std::vector<Text>& row : table.rows) {
            m_html += "<tr>";
            for (std::size_t i = 0; i < row.size(); ++i)
                m_html += i == 0 ? "<th scope=\"row\">" + escaped(row[i]) + "</th>"
                                 : "<td>" + escaped(row[i]) + "</td>";
            m_html += "</tr>\n";
        }
        m_html += "</tbody>\n</table>\n";
    }
    void operator()(const ReportPlots& plots) const
    {
        m_html += "<div class=\"plots\">\n";
        for (const ReportPlot& plot : plots.plots)
            m_html += plotSvg(plot);
        m_html += "</div>\n";
    }
    void operator()(const ReportPageBreak& /*nothing*/) const
    {
        m_html += "<div class=\"page\"></div>\n";
    }

private:
    std::string& m_html;
};

} // namespace

std::string reportHtml(const ReportDocument& document)
{
    std::string html = "<!DOCTYPE html>\n<html lang=\"" + xmlEscaped(document.language)
        + "\">\n<head>\n<meta charset=\"utf-8\">\n<title>" + escaped(document.title)
        + "</title>\n<style>" + std::string(style) + "</style>\n</head>\n<body>\n<h1>"
        + escaped(document.title) + "</h1>\n";
    for (const ReportBlock& block : document.blocks)
        std::visit(HtmlWriter(html), block);
    return html + "</body>\n</html>\n";
}

} // namespace axiscomp
