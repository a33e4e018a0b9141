// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/output/json_output.h"
#include "app/cli/output/judgement_output.h"
#include "app/cli/output/output_file.h"
#include "app/cli/output/report_output.h"
#include "app/common/arguments.h"
#include "app/texts/program_texts.h"
#include "core/io/local_file.h"
#include "core/metrology/report/record_report.h"
#include "core/metrology/report/report_html.h"

#include <algorithm>

namespace axiscomp::app {

namespace {

struct ReportCommandOptions {
    std::string record;
    std::string output;
    std::string language = "en";
    bool wantsLists = false;
};

Result<ReportFormat> formatOf(const std::string& file)
{
    if (const auto format = reportFormatOf(pathFromText(file)))
        return *format;
    return wrongUsage(
        "the report is PDF or HTML: name a file that ends in .pdf or .html", commandName("report"));
}

Result<void> checkLanguage(const std::string& language)
{
    const std::vector<std::string> languages = textLanguages();
    if (std::ranges::find(languages, language) != languages.end())
        return {};
    std::string known;
    for (const std::string& each : languages)
        known += (known.empty() ? "" : ", ") + each;
    return wrongUsage("--language: a report is written in " + known, commandName("report"));
}

Json figuresOrNull(const ReportContent& content, const std::optional<ReportMeasurement>& measured)
{
    return measured && measured->measurement.hasTargets()
        ? axisFiguresJson(figuresBy(content, measured->measurement))
        : Json(nullptr);
}

Json figuresOfAllOrNull(
    const ReportContent& content, const std::optional<ReportMeasurement>& measured)
{
    if (!measured || !measured->measurement.hasTargets())
        return nullptr;
    const auto figures = figuresOfAllValues(content, measured->measurement);
    return figures ? axisFiguresJson(*figures) : Json(nullptr);
}

Json predictedJson(const std::optional<ReportPrediction>& prediction)
{
    if (!prediction)
        return nullptr;
    Iso230Figures figures;
    for (std::size_t i = 0; i < figures.axis.size(); ++i)
        figures.axis[i].value = prediction->figures[i];
    return axisFiguresJson(figures);
}

Json heldOutJson(const std::optional<ReportPrediction>& prediction)
{
    if (!prediction || !prediction->heldOutM)
        return nullptr;
    return {{"rms", *prediction->heldOutRms}, {"largest", *prediction->heldOutLargest},
        {"M", *prediction->heldOutM}};
}

Json reportJson(const ReportCommandOptions& options, const ReportContent& content)
{
    Json sources = Json::array();
    for (const ReportInput& input : content.inputs)
        sources.push_back(
            {{"file", input.file}, {"format", input.format}, {"sha256", input.sha256}});
    const auto& last = content.after ? content.after : content.before;
    const auto verdictJson = [&content](const Iso230Figures& figures) {
        return verdictsJson(verdicts(figures, content.tolerances, content.uncertainty));
    };
    Json verdict = Json::array();
    Json verdictOfAllValues = Json::array();
    if (last && last->measurement.hasTargets()) {
        verdict = verdictJson(figuresBy(content, last->measurement));
        if (const auto ofAllValues = figuresOfAllValues(content, last->measurement))
            verdictOfAllValues = verdictJson(*ofAllValues);
    }
    return {{"record", options.record}, {"output", options.output}, {"language", options.language},
        {"unit", content.isAngular ? "deg" : "mm"},
        {"before", figuresOrNull(content, content.before)},
        {"predicted", predictedJson(content.prediction)},
        {"heldOut", heldOutJson(content.prediction)},
        {"after", figuresOrNull(content, content.after)}, {"verdict", std::move(verdict)},
        {"beforeOfAllValues", figuresOfAllOrNull(content, content.before)},
        {"afterOfAllValues", figuresOfAllOrNull(content, content.after)},
        {"verdictOfAllValues", std::move(verdictOfAllValues)}, {"source", std::move(sources)},
        {"warnings", warningsJson(content.warnings)}};
}

Result<ExitCode> runReport(Environment& environment, const ReportCommandOptions& options)
{
    AXISCOMP_TRY(const auto format, formatOf(options.output));
    AXISCOMP_CHECK(checkLanguage(options.language));
    AXISCOMP_TRY(const auto record, loadRecord(pathFromText(options.record)));
    AXISCOMP_TRY(const auto content, reportContent(record, AXISCOMP_VERSION));
    const ReportDocument document =
        inLanguage(reportDocument(content, {options.wantsLists}), options.language);
    if (format == ReportFormat::Pdf) {
        AXISCOMP_TRY(const auto pdf, drawnAsPdf(document));
        AXISCOMP_CHECK(saveFile(pathFromText(options.output), pdf));
    } else {
        AXISCOMP_CHECK(saveFile(pathFromText(options.output), asBytes(reportHtml(document))));
    }
    environment.print("Report written to " + options.output + "\n");
    environment.document(reportJson(options, content));
    return ExitCode::Done;
}

} // namespace

void addReportCommand(CommandLine& line)
{
    auto options = std::make_shared<ReportCommandOptions>();
    CLI::App* command = line.add("report", fileCommands,
        AXISCOMP_HELP(
            "Help", "Write the report of a record: by how much an axis became better, on one page"),
        [options](Environment& environment) { return runReport(environment, *options); });
    command
        ->add_option(
            "RECORD", options->record, AXISCOMP_HELP("Help", "Record of the compensation (.axcal)"))
        ->required();
    command
        ->add_option("-o,--output", options->output,
            AXISCOMP_HELP("Help", "The report; its extension says whether it is PDF or HTML"))
        ->option_text("FILE")
        ->required();
    command
        ->add_option("--language", options->language,
            AXISCOMP_HELP("Help", "Language of the report: en, de, fr, ja or zh"))
        ->option_text("LANGUAGE");
    command->add_flag("--lists", options->wantsLists,
        AXISCOMP_HELP("Help", "Add pages with every target and every value that is left out"));
    command->footer(AXISCOMP_HELP(
        "Help", "Examples:") "\n  axiscomp report job.axcal -o report.pdf"
                             "\n  axiscomp report job.axcal -o report.html --language de");
}

} // namespace axiscomp::app
