// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output/measurement_formats_text.h"

#include "app/common/text_table.h"

namespace axiscomp::app {

namespace {

std::string extensionList(const MeasurementFacts& facts)
{
    std::string text;
    for (const std::string_view extension : facts.extensions)
        text += (text.empty() ? "" : ", ") + std::string(extension);
    return text;
}

std::string kindList(const MeasurementFacts& facts)
{
    std::string text;
    for (const MeasurementKind kind : facts.kinds)
        text += (text.empty() ? "" : ", ") + std::string(measurementKindName(kind));
    return text;
}

std::string sentences(std::span<const std::string_view> list, std::string_view indent)
{
    std::string text;
    for (const std::string_view sentence : list)
        text += std::string(indent) + "- " + std::string(sentence) + "\n";
    return text;
}

} // namespace

std::string measurementFormatsList()
{
    TextTable table({"name", "extensions", "holds", "what it is"});
    for (const MeasurementFormat* format : measurementFormats())
        table.add(
            {std::string(format->facts.name), extensionList(format->facts), kindList(format->facts),
                std::string(format->facts.origin) + ": " + format->facts.description.words});
    return table.text("");
}

std::string measurementFormatText(const MeasurementFormat& format)
{
    const MeasurementFacts& facts = format.facts;
    std::string text =
        labelled({{"From", std::string(facts.origin)}, {"File", facts.description.words},
            {"Extensions", extensionList(facts)}, {"Holds", kindList(facts)}});
    text += "\nRules (from documentation, public files or public program code)\n"
        + sentences(facts.rules, "  ");
    if (!facts.assumptions.empty())
        text += "\nAssumptions of this program\n" + sentences(facts.assumptions, "  ");
    return text;
}

std::string measurementFormatsPage()
{
    std::string text =
        "# Measurement formats\n\n"
        "This page is made by `axiscomp formats --measurements --markdown` from the same data that "
        "the programs work\nwith; a test compares them. What the figures of a measurement mean is "
        "in [Measurements](metrology.md).\n\n"
        "Four kinds come out: *runs* over targets in both directions, *averages* (means of such "
        "runs), a *track* of\nencoder and reference positions without targets, and *points* of a "
        "plane or space. A format is recognised by its\ncontent; `--from` names it where that "
        "leaves it open.\n\n"
        "| format | from | extensions | holds |\n|---|---|---|---|\n";
    for (const MeasurementFormat* format : measurementFormats()) {
        const std::string name(format->facts.name);
        text += "| [`" + name + "`](#" + name + ") | " + std::string(format->facts.origin) + " | "
            + extensionList(format->facts) + " | " + kindList(format->facts) + " |\n";
    }
    for (const MeasurementFormat* format : measurementFormats()) {
        const MeasurementFacts& facts = format->facts;
        text += "\n## `" + std::string(facts.name) + "`\n\n" + std::string(facts.description.words)
            + ".\n\n" + sentences(facts.rules, "");
        if (!facts.assumptions.empty())
            text += "\nOur assumptions, where nothing is published:\n\n"
                + sentences(facts.assumptions, "");
    }
    return text;
}

Json measurementFormatJson(const MeasurementFormat& format)
{
    const MeasurementFacts& facts = format.facts;
    Json kinds = Json::array();
    for (const MeasurementKind kind : facts.kinds)
        kinds.push_back(measurementKindName(kind));
    return {{"name", facts.name}, {"origin", facts.origin},
        {"description", facts.description.words}, {"extensions", facts.extensions},
        {"kinds", std::move(kinds)}, {"rules", facts.rules}, {"assumptions", facts.assumptions}};
}

} // namespace axiscomp::app
