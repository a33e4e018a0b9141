// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/output/output_file.h"
#include "core/csv/calibration_csv.h"

namespace axiscomp::app {

namespace {

constexpr int mostTables = 100;

struct ExampleOptions {
    int dimensions = 1;
    int tables = 2;
    std::string output;
};

Result<ExitCode> runExample(Environment& environment, const ExampleOptions& options)
{
    const Output output{options.output, commandName("example")};
    AXISCOMP_CHECK(checkOutput(environment, output, true));
    const std::string text = exampleCalibrationCsv(options.dimensions, options.tables);
    AXISCOMP_CHECK(writeOutput(environment, output, asBytes(text)));
    if (!output.isStandardOutput())
        environment.print("Wrote " + options.output + ".\n");
    environment.document({{"output", options.output}, {"dimensions", options.dimensions},
        {"tables", options.tables}});
    return ExitCode::Done;
}

} // namespace

void addExampleCommand(CommandLine& line)
{
    auto options = std::make_shared<ExampleOptions>();
    CLI::App* command = line.add("example", fileCommands,
        AXISCOMP_HELP("Help", "Write an example calibration file (CSV)"),
        [options](Environment& environment) { return runExample(environment, *options); });
    command
        ->add_option(
            "--dims", options->dimensions, AXISCOMP_HELP("Help", "Number of dimensions: 1, 2 or 3"))
        ->option_text("D (required)")
        ->required()
        ->check(CLI::IsMember({1, 2, 3}));
    command
        ->add_option(
            "--tables", options->tables, AXISCOMP_HELP("Help", "Number of tables (2 unless given)"))
        ->option_text("N")
        ->check(CLI::Range(1, mostTables));
    command
        ->add_option("-o,--output", options->output,
            AXISCOMP_HELP("Help", "File to write; standard output without it, or with -"))
        ->option_text("FILE");
    command->footer(
        AXISCOMP_HELP("Help", "Example:") "\n  axiscomp example --dims 2 -o example.csv");
}

} // namespace axiscomp::app
