// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/output/output_file.h"
#include "app/common/arguments.h"
#include "app/common/number_text.h"
#include "core/io/local_file.h"
#include "core/metrology/gcode.h"

namespace axiscomp::app {

namespace {

struct TargetsOptions {
    MeasuringPlanRequest request;
    std::string unit = "mm";
    std::string dialect; ///< empty: the plan as CSV
    std::string output;
};

std::string summary(const MeasuringPlan& plan, const std::string& file)
{
    const std::string unit = plan.isAngular ? "deg" : "mm";
    const std::vector<double> targets = targetsOf(plan);
    const PlanTravel travel = planTravel(plan);
    return "Wrote " + file + ": " + plural(targets.size(), "target", "targets") + ", "
        + plural(plan.steps.size(), "position", "positions") + ". Axis " + plan.axis
        + " moves from " + planPosition(travel.lowest) + " to " + planPosition(travel.highest) + " "
        + unit + ": check that this is within its travel, and free.\n";
}

Json documentOf(const MeasuringPlan& plan, const TargetsOptions& options)
{
    return {{"output", options.output},
        {"format", options.dialect.empty() ? Json("plan") : Json(options.dialect)},
        {"axis", plan.axis}, {"unit", plan.isAngular ? "deg" : "mm"}, {"targets", targetsOf(plan)},
        {"cycles", options.request.cycles}, {"steps", plan.steps.size()}, {"overrun", plan.overrun},
        {"feed", plan.feedPerMinute}, {"dwell", plan.dwellSeconds}, {"seed", plan.seed}};
}

Result<ExitCode> runTargets(Environment& environment, TargetsOptions& options)
{
    const Output output{options.output, commandName("targets")};
    AXISCOMP_CHECK(checkOutput(environment, output, true));
    if (options.dialect.empty() && isProgramFile(pathFromText(options.output)))
        return wrongUsage("a program for a control needs --dialect linuxcnc, fanuc or siemens; for "
                          "the plan name a file .csv",
            commandName("targets"));
    options.request.isAngular = options.unit == "deg";
    AXISCOMP_TRY(const auto plan, makeMeasuringPlan(options.request));
    std::string text = measuringPlanCsv(plan);
    if (const auto dialect = gcodeDialectNamed(options.dialect)) {
        AXISCOMP_TRY(text, gcodeProgram(plan, *dialect));
    }
    AXISCOMP_CHECK(writeOutput(environment, output, asBytes(text)));
    if (!output.isStandardOutput())
        environment.print(summary(plan, options.output));
    environment.document(documentOf(plan, options));
    return ExitCode::Done;
}

void addTargetOptions(CLI::App& command, MeasuringPlanRequest& request)
{
    command.add_option("--from", request.from, AXISCOMP_HELP("Help", "First target"))
        ->option_text("A (required)")
        ->required();
    command.add_option("--to", request.to, AXISCOMP_HELP("Help", "Last target, above the first"))
        ->option_text("B (required)")
        ->required();
    command.add_option("--count", request.count, AXISCOMP_HELP("Help", "Number of targets"))
        ->option_text("M");
    command
        .add_option("--spacing", request.spacing,
            AXISCOMP_HELP("Help", "Mean distance of targets, instead of --count"))
        ->option_text("P");
    command
        .add_option("--period", request.period,
            AXISCOMP_HELP("Help",
                "Known period of the axis, such as the lead of its screw: targets are spread over "
                "it"))
        ->option_text("P");
    command
        .add_option("--cycles", request.cycles,
            AXISCOMP_HELP("Help", "Runs in each direction (5 unless given)"))
        ->option_text("N")
        ->check(CLI::Range(1, 1000));
    command
        .add_option("--seed", request.seed,
            AXISCOMP_HELP("Help",
                "Another number gives other targets, the same number the same (1 unless given)"))
        ->option_text("N");
    command
        .add_option("--overrun", request.overrun,
            AXISCOMP_HELP("Help",
                "How far the axis moves in the direction of a run before its first target (1 % of "
                "the "
                "range unless given, at most a third of the spacing)"))
        ->option_text("D");
    command
        .add_option("--feed", request.feedPerMinute,
            AXISCOMP_HELP("Help", "Feed in mm or deg per minute (1000 unless given)"))
        ->option_text("F");
    command
        .add_option("--dwell", request.dwellSeconds,
            AXISCOMP_HELP("Help",
                "Seconds at each target (5 unless given): time to stand still and be measured"))
        ->option_text("S");
}

/// One below the other, as they are typed.
constexpr const char* targetsExamples =
    "\n  axiscomp targets --from 0 --to 500 --count 51 --period 10 -o plan.csv"
    "\n  axiscomp targets --from 0 --to 500 --count 51 --period 10 --dialect siemens -o plan.mpf";

} // namespace

void addTargetsCommand(CommandLine& line)
{
    auto options = std::make_shared<TargetsOptions>();
    CLI::App* command = line.add("targets", fileCommands,
        AXISCOMP_HELP("Help",
            "Choose the targets of a measurement: a plan, or a program for the machine's control"),
        [options](Environment& environment) { return runTargets(environment, *options); });
    addTargetOptions(*command, options->request);
    command
        ->add_option("--axis", options->request.axis,
            AXISCOMP_HELP("Help", "Name of the axis (X unless given)"))
        ->option_text("AXIS");
    command
        ->add_option("--unit", options->unit,
            AXISCOMP_HELP("Help", "Unit of all positions: mm (the default) or deg"))
        ->option_text("UNIT")
        ->check(CLI::IsMember(std::vector<std::string>{"mm", "deg"}));
    const auto names = gcodeDialectNames();
    command
        ->add_option("--dialect", options->dialect,
            AXISCOMP_HELP("Help", "Write G-code for this control: linuxcnc, fanuc or siemens"))
        ->option_text("DIALECT")
        ->check(CLI::IsMember(std::vector<std::string>(names.begin(), names.end())));
    command
        ->add_option("-o,--output", options->output,
            AXISCOMP_HELP("Help", "File to write; standard output without it, or with -"))
        ->option_text("FILE");
    command->footer(std::string(AXISCOMP_HELP("Help",
                        "axiscomp never moves an axis: the machine's control or a person does."))
        + "\n\n" + AXISCOMP_HELP("Help", "Examples:") + targetsExamples);
}

} // namespace axiscomp::app
