// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/metrology/report/report_document.h"

namespace axiscomp {

namespace {

/// Every text of a block, which may be constant.
template <typename Block, typename Visit> void visitTexts(Block& block, const Visit& visit)
{
    if constexpr (requires { block.text; }) {
        visit(block.text);
    } else if constexpr (requires { block.facts; }) {
        for (auto& fact : block.facts) {
            visit(fact.name);
            visit(fact.value);
        }
    } else if constexpr (requires { block.header; }) {
        for (auto& cell : block.header)
            visit(cell);
        for (auto& row : block.rows)
            for (auto& cell : row)
                visit(cell);
    } else if constexpr (requires { block.plots; }) {
        for (auto& plot : block.plots) {
            visit(plot.description);
            for (auto& label : plot.labels)
                visit(label.text);
        }
    }
}

template <typename Document, typename Visit>
void visitTextsOf(Document& document, const Visit& visit)
{
    visit(document.title);
    for (auto& block : document.blocks)
        std::visit([&visit](auto& one) { visitTexts(one, visit); }, block);
}

} // namespace

ReportDocument worded(ReportDocument document, const Wording& wording, const std::string& language)
{
    visitTextsOf(document, [&wording](Text& text) { text = Verbatim{text.in(wording)}; });
    document.language = language;
    return document;
}

std::string wordsOf(const ReportDocument& document)
{
    std::string words;
    visitTextsOf(document, [&words](const Text& text) { words += text.english() + '\n'; });
    return words;
}

} // namespace axiscomp
