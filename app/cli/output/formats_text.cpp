// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/output/formats_text.h"

#include "app/common/number_text.h"
#include "app/common/text_table.h"

namespace axiscomp::app {

namespace {

using Lines = std::vector<std::pair<std::string, std::string>>;

std::string use(const TableFormat& format)
{
    if (format.read && format.write)
        return "read and written";
    return format.read ? "read only" : "written only";
}

std::string extensionsText(const FormatFacts& facts)
{
    std::string text;
    for (const std::string_view extension : facts.extensions)
        text += (text.empty() ? "" : ", ") + std::string(extension);
    return text;
}

std::string limitsText(const FormatFacts& facts)
{
    std::string text = facts.knots == KnotRule::SquareCells
        ? "even positions in square cells"
        : std::string(knotRuleName(facts.knots)) + " positions";
    if (facts.mostPoints > 0)
        text += ", at most " + countText(facts.mostPoints) + " points";
    if (facts.mostColumns == 1)
        text += ", one column";
    else if (facts.mostColumns > 1)
        text += ", at most " + std::to_string(facts.mostColumns) + " columns";
    else
        text += ", several columns";
    text += facts.mostTables == 1 ? ", one table in a file" : ", several tables in a file";
    text += facts.addsTables ? "; tables for one axis are added" : "";
    return text;
}

std::string holdsText(const FormatFacts& facts)
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

std::string signText(const FormatFacts& facts)
{
    const std::string words = facts.sign == SignConvention::Feedback
        ? "feedback: x_ref - x_enc, added to the encoder position"
        : "command: an offset added to the commanded position, the opposite sign";
    return words + " (" + std::string(evidenceName(facts.signEvidence))
        + (facts.needsSign() ? ": state it with `--sign`, or `--to-sign` for a new file)" : ")");
}

Lines factLines(const TableFormat& format)
{
    const FormatFacts& facts = format.facts;
    Lines lines{{"Controller", std::string(facts.controller)}, {"File", facts.description.words},
        {"Use", use(format)}, {"Extension", extensionsText(facts)},
        {"Dimensions", dimensionsText(facts)}, {"Holds", holdsText(facts)},
        {"Limits", limitsText(facts)}, {"Sign", signText(facts)},
        {"Outside",
            outsideWords(facts) + " (" + std::string(evidenceName(facts.outsideEvidence)) + ")"}};
    return lines;
}

std::string settingText(const FormatSetting& setting)
{
    std::string text = setting.meaning.words;
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

Lines settingLines(const FormatFacts& facts)
{
    Lines lines;
    for (const FormatSetting& setting : facts.settings)
        lines.emplace_back(std::string(setting.key), settingText(setting));
    if (takesAnyUnits(facts))
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

std::string section(const TableFormat& format)
{
    const FormatFacts& facts = format.facts;
    std::string text = "## `" + std::string(facts.name) + "`\n\n| | |\n|---|---|\n";
    for (const auto& [name, value] : factLines(format))
        text += "| " + name + " | " + value + " |\n";
    if (!facts.rules.empty())
        text += "\nWhat its documentation, or public program code, says:\n\n"
            + bulletList(facts.rules, "");
    if (!facts.assumptions.empty())
        text += "\nOur assumptions, where nothing is published:\n\n"
            + bulletList(facts.assumptions, "");
    const Lines settings = settingLines(facts);
    if (!settings.empty())
        text += "\n| setting | meaning |\n|---|---|\n";
    for (const auto& [key, meaning] : settings)
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
        return "square cells";
    case KnotRule::Any:
        break;
    }
    return "any ascending";
}

std::string dimensionsText(const FormatFacts& facts)
{
    return facts.fewestDimensions == facts.mostDimensions
        ? std::to_string(facts.mostDimensions)
        : std::to_string(facts.fewestDimensions) + " to " + std::to_string(facts.mostDimensions);
}

std::string outsideWords(const FormatFacts& facts)
{
    std::string text = "the values at the ends hold outside of the table";
    if (facts.behaviour.outside == Outside::Zero)
        text = "no correction outside of the table";
    if (facts.behaviour.outside == Outside::Extrapolate)
        text = "outside of the table the first and the last cell go on, in each dimension";
    if (facts.behaviour.outside == Outside::Wrap)
        text = "outside of the table the position rolls over to its other end";
    if (facts.behaviour.startsAtFirst)
        text += "; nothing before every source has reached its first value";
    return text;
}

std::string formatText(const TableFormat& format)
{
    const FormatFacts& facts = format.facts;
    std::string text = labelled(factLines(format));
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
        "format. Where the sign is assumed, it must be stated:\n`--sign` for a file that is read, "
        "`--to-sign` for one that is written.\n\n"
        "| format | controller | use | dimensions | sign |\n|---|---|---|---|---|\n";
    for (const TableFormat* format : tableFormats()) {
        const FormatFacts& facts = format->facts;
        text += "| [`" + std::string(facts.name) + "`](#" + std::string(facts.name) + ") | "
            + std::string(facts.controller) + " | " + use(*format) + " | " + dimensionsText(facts)
            + " | " + std::string(signName(facts.sign)) + ", "
            + std::string(evidenceName(facts.signEvidence)) + " |\n";
    }
    text += '\n';
    for (const TableFormat* format : tableFormats())
        text += section(*format);
    text.pop_back();
    return text;
}

} // namespace axiscomp::app
