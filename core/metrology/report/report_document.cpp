// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/report/report_document.h"

namespace axiscomp {

namespace {

class Translation {
public:
    explicit Translation(const Wording& wording) : m_wording(wording) { }

    void operator()(ReportHeading& heading) const { translate(heading.text); }
    void operator()(ReportParagraph& paragraph) const { translate(paragraph.text); }
    void operator()(ReportFacts& facts) const
    {
        for (ReportFact& fact : facts.facts) {
            translate(fact.name);
            translate(fact.value);
        }
    }
    void operator()(ReportTable& table) const
    {
        for (Text& cell : table.header)
            translate(cell);
        for (std::vector<Text>& row : table.rows)
            for (Text& cell : row)
                translate(cell);
    }
    void operator()(ReportPlots& plots) const
    {
        for (ReportPlot& plot : plots.plots) {
            translate(plot.description);
            for (PlotLabel& label : plot.labels)
                translate(label.text);
        }
    }
    void operator()(ReportPageBreak& /*nothing*/) const { }

    void translate(Text& text) const { text = Verbatim{text.in(m_wording)}; }

private:
    const Wording& m_wording;
};

} // namespace

ReportDocument worded(ReportDocument document, const Wording& wording, const std::string& language)
{
    const Translation translation(wording);
    translation.translate(document.title);
    for (ReportBlock& block : document.blocks)
        std::visit(translation, block);
    document.language = language;
    return document;
}

} // namespace axiscomp
