// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output/formats_text.h"

#include "app/common/number_text.h"
#include "app/common/text_table.h"

namespace axiscomp::app {

namespace {

using Lines = std::vector<std::pair<std::string, std::string>>;

std::string use(const TableFamily& family)
{
    if (family.read && family.write)
        return "read and written";
    return family.read ? "read only" : "written only";
}

std::string extensionsText(const FamilyFacts& facts)
{
    std::string text;
    for (const std::string_view extension : facts.extensions)
        text += (text.empty() ? "" : ", ") + std::string(extension);
    return text;
}

std::string limitsText(const FamilyFacts& facts)
{
    std::string text = std::string(knotRuleName(facts.knots)) + " positions";
    if (facts.mostPoints > 0)
        text += ", at most " + countText(facts.mostPoints) + " points";
    if (facts.mostColumns == 1)
        text += ", one column";
    else if (facts.mostColumns > 1)
        text += ", at most " + std::to_string(facts.mostColumns) + " columns";
    else
        text += ", several columns";
    text += facts.mostTables == 1 ? ", one table in a file" : ", several tables in a file";
    return text;
}

std::string holdsText(const FamilyFacts& facts)
{
    std::string text = std::string(facts.numbers);
    text += facts.holdsNames ? ", names of axes" : "";
    text += facts.holdsUnits ? ", units" : "";
    text += facts.holdsNotes ? ", notes" : "";
    text += facts.holdsDirections ? ", a value for each direction of motion" : "";
    text += facts.holdsWrap ? ", modulo axes" : "";
    text += facts.holdsPersistency ? ", persistency" : "";
    return text;
}

std::string signText(const FamilyFacts& facts)
{
    const std::string words = facts.sign == SignConvention::Feedback
        ? "feedback: x_ref - x_enc, added to the encoder position"
        : "command: an offset added to the commanded position, the opposite sign";
    return words + " (" + std::string(evidenceName(facts.signEvidence)) + ")";
}

Lines factLines(const TableFamily& family)
{
    const FamilyFacts& facts = family.facts;
    Lines lines{{"Controller", std::string(facts.controller)},
        {"File", std::string(facts.description)}, {"Use", use(family)},
        {"Extension", extensionsText(facts)}, {"Dimensions", dimensionsText(facts)},
        {"Holds", holdsText(facts)}, {"Limits", limitsText(facts)}, {"Sign", signText(facts)},
        {"Outside",
            outsideWords(facts) + " (" + std::string(evidenceName(facts.outsideEvidence)) + ")"}};
    return lines;
}

std::string settingText(const FormatSetting& setting)
{
    std::string text(setting.meaning);
    if (!setting.choices.empty())
        text += "; one of " + std::string(setting.choices);
    if (setting.kind == FormatSetting::Kind::YesNo)
        text += "; yes or no";
    if (setting.isNeeded)
        text += "; needed";
    else if (!setting.standard.empty())
        text += "; " + std::string(setting.standard) + " unless given";
    if (setting.forReading != setting.forWriting)
        text += setting.forReading ? "; for reading" : "; for writing";
    return text;
}

Lines settingLines(const FamilyFacts& facts)
{
    Lines lines;
    for (const FormatSetting& setting : facts.settings)
        lines.emplace_back(std::string(setting.key), settingText(setting));
    if (!facts.holdsUnits)
        lines.emplace_back("position-unit, value-unit",
            "units, where neither the file nor the controller says them: mm, um, deg ...");
    return lines;
}

std::string bulletList(std::span<const std::string_view> sentences, std::string_view indent)
{
    std::string text;
    for (const std::string_view sentence : sentences)
        text += std::string(indent) + "- " + std::string(sentence) + "\n";
    return text;
}

std::string section(const TableFamily& family)
{
    const FamilyFacts& facts = family.facts;
    std::string text = "## `" + std::string(facts.name) + "`\n\n| | |\n|---|---|\n";
    for (const auto& [name, value] : factLines(family))
        text += "| " + name + " | " + value + " |\n";
    if (!facts.rules.empty())
        text += "\nWhat its documentation, or public program code, says:\n\n"
            + bulletList(facts.rules, "");
    if (!facts.assumptions.empty())
        text += "\nOur assumptions, where nothing is published:\n\n"
            + bulletList(facts.assumptions, "");
    text += "\n| setting | meaning |\n|---|---|\n";
    for (const auto& [key, meaning] : settingLines(facts))
        text += "| `" + key + "` | " + meaning + " |\n";
    return text + "\n";
}

} // namespace

std::string_view knotRuleName(KnotRule rule)
{
    switch (rule) {
    case KnotRule::Even:
        return "even";
    case KnotRule::SquareCells:
        return "even, in square cells,";
    case KnotRule::Any:
        break;
    }
    return "any ascending";
}

std::string dimensionsText(const FamilyFacts& facts)
{
    return facts.fewestDimensions == facts.mostDimensions
        ? std::to_string(facts.mostDimensions)
        : std::to_string(facts.fewestDimensions) + " to " + std::to_string(facts.mostDimensions);
}

std::string outsideWords(const FamilyFacts& facts)
{
    std::string text = facts.behaviour.outside == Outside::Zero
        ? "no correction outside of the table"
        : "the values at the ends hold outside of the table";
    if (facts.behaviour.startsAtFirst)
        text += "; nothing before every source has reached its first value";
    return text;
}

bool holdsSeveral(const FamilyFacts& facts)
{
    return facts.mostTables != 1 || facts.mostColumns != 1;
}

std::string familyText(const TableFamily& family)
{
    const FamilyFacts& facts = family.facts;
    std::string text = labelled(factLines(family));
    if (!facts.rules.empty())
        text += "\nRules (from documentation, or public program code)\n"
            + bulletList(facts.rules, "  ");
    if (!facts.assumptions.empty())
        text += "\nAssumptions of this program\n" + bulletList(facts.assumptions, "  ");
    const Lines settings = settingLines(facts);
    if (!settings.empty())
        text += "\nSettings (--set-in KEY=VALUE for reading, --set-out for writing)\n"
            + labelled(settings, "  ");
    return text;
}

std::string formatsPage()
{
    std::string text =
        "# Table formats\n\n"
        "This page is made by `axiscomp formats --markdown` from the same data that the programs "
        "work with; a test\ncompares them. `axiscomp formats NAME` prints one section.\n\n"
        "With e = x_ref - x_enc, a *feedback* file holds +e, which the controller adds to the "
        "encoder position, and a\n*command* file holds the offset that is added to the commanded "
        "position: c(x) = -e(x + c(x)).\n`--sign feedback|command` overrules what is known of a "
        "format.\n\n"
        "| format | controller | use | dimensions | sign |\n|---|---|---|---|---|\n";
    for (const TableFamily* family : tableFamilies()) {
        const FamilyFacts& facts = family->facts;
        text += "| [`" + std::string(facts.name) + "`](#" + std::string(facts.name) + ") | "
            + std::string(facts.controller) + " | " + use(*family) + " | " + dimensionsText(facts)
            + " | " + std::string(signName(facts.sign)) + ", "
            + std::string(evidenceName(facts.signEvidence)) + " |\n";
    }
    text += '\n';
    for (const TableFamily* family : tableFamilies())
        text += section(*family);
    text.pop_back();
    return text;
}

} // namespace axiscomp::app
