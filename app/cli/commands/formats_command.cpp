// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/output/formats_text.h"
#include "app/cli/output/measurement_formats_text.h"
#include "app/common/arguments.h"
#include "app/common/text_table.h"
#include "core/formats/table_format.h"

namespace axiscomp::app {

namespace {

struct FormatsOptions {
    std::string name;
    bool markdown = false;
    bool measurements = false;
};

Json settingsJson(const FormatFacts& facts)
{
    Json list = Json::array();
    for (const FormatSetting& setting : facts.settings)
        list.push_back({{"key", setting.key}, {"meaning", setting.meaning.words},
            {"standard", setting.standard}, {"choices", setting.choices},
            {"reading", setting.forReading}, {"writing", setting.forWriting},
            {"needed", setting.isNeeded}});
    return list;
}

Json formatJson(const TableFormat& format)
{
    const FormatFacts& facts = format.facts;
    Json dimensions = Json::array();
    for (int d = facts.fewestDimensions; d <= facts.mostDimensions; ++d)
        dimensions.push_back(d);
    return {{"name", facts.name}, {"controller", facts.controller},
        {"extension", facts.extensions.front()}, {"description", facts.description.words},
        {"reads", format.read != nullptr}, {"writes", format.write != nullptr},
        {"dimensions", std::move(dimensions)}, {"knots", knotRuleName(facts.knots)},
        {"mostPoints", facts.mostPoints}, {"severalColumns", facts.mostColumns != 1},
        {"severalTables", facts.mostTables != 1}, {"addsTables", facts.addsTables},
        {"directions", facts.holdsDirections}, {"modulo", facts.holdsWrap},
        {"names", facts.holdsNames}, {"units", facts.holdsUnits}, {"notes", facts.holdsNotes},
        {"persistency", facts.holdsPersistency}, {"values", facts.numbers},
        {"sign", signName(facts.sign)}, {"signEvidence", evidenceName(facts.signEvidence)},
        {"outside", outsideWords(facts)}, {"outsideEvidence", evidenceName(facts.outsideEvidence)},
        {"rules", facts.rules}, {"assumptions", facts.assumptions},
        {"settings", settingsJson(facts)}};
}

std::string listText()
{
    TextTable table({"name", "extension", "reads", "writes", "dimensions", "sign", "what it is"});
    for (const TableFormat* format : tableFormats()) {
        const FormatFacts& facts = format->facts;
        table.add({std::string(facts.name), std::string(facts.extensions.front()),
            format->read ? "yes" : "-", format->write ? "yes" : "-", dimensionsText(facts),
            std::string(signName(facts.sign)),
            std::string(facts.controller) + ": " + facts.description.words});
    }
    return table.text("");
}

Result<ExitCode> describeMeasurements(Environment& environment, const FormatsOptions& options)
{
    if (!options.name.empty()) {
        AXISCOMP_TRY(const auto format, measurementFormatNamed(options.name));
        environment.print(measurementFormatText(*format));
        environment.document(measurementFormatJson(*format));
        return ExitCode::Done;
    }
    Json list = Json::array();
    for (const MeasurementFormat* format : measurementFormats())
        list.push_back(measurementFormatJson(*format));
    environment.print(options.markdown ? measurementFormatsPage() : measurementFormatsList());
    environment.document({{"formats", std::move(list)}});
    return ExitCode::Done;
}

Result<ExitCode> runFormats(Environment& environment, const FormatsOptions& options)
{
    if (options.measurements)
        return describeMeasurements(environment, options);
    if (!options.name.empty()) {
        AXISCOMP_TRY(const auto format, formatNamed(options.name));
        environment.print(formatText(*format));
        environment.document(formatJson(*format));
        return ExitCode::Done;
    }
    Json list = Json::array();
    for (const TableFormat* format : tableFormats())
        list.push_back(formatJson(*format));
    environment.print(options.markdown ? formatsPage() : listText());
    environment.document({{"formats", std::move(list)}});
    return ExitCode::Done;
}

} // namespace

void addFormatsCommand(CommandLine& line)
{
    auto options = std::make_shared<FormatsOptions>();
    CLI::App* command = line.add("formats", fileCommands,
        AXISCOMP_HELP(
            "Help", "List the table formats, or describe one: its limits, rules and settings"),
        [options](Environment& environment) { return runFormats(environment, *options); });
    command->add_option(
        "NAME", options->name, AXISCOMP_HELP("Help", "One format: its rules, limits and settings"));
    command->add_flag("--markdown", options->markdown,
        AXISCOMP_HELP("Help", "All of them, as the page docs/formats.md"));
    command->add_flag("--measurements", options->measurements,
        AXISCOMP_HELP("Help", "The formats of measurements instead of those of tables"));
}

} // namespace axiscomp::app
