// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/output/json_output.h"
#include "app/cli/output/status_text.h"
#include "app/cli/session/command_session.h"
#include "app/common/number_text.h"

namespace axiscomp::app {

namespace {

constexpr int proofSamples = 5;

enum class Activation { Evaluate, Activate, Deactivate };

Result<AxisStatus> carryOut(CommandSession& session, Activation activation, int axis)
{
    switch (activation) {
    case Activation::Evaluate:
        return session.compensator().evaluate(axis, session.operation());
    case Activation::Activate:
        return session.compensator().activate(axis, session.operation());
    case Activation::Deactivate:
        break;
    }
    return session.compensator().deactivate(axis, session.operation());
}

Result<ExitCode> runActivation(
    Environment& environment, CommandSession& session, Activation activation, int axis)
{
    const auto before = settledStatus(environment, session, axis);
    if (!before)
        return fail(before.error());
    AXISCOMP_TRY(auto status, carryOut(session, activation, axis));
    environment.print("The compensation of " + axisWords(status.axis) + " of "
        + driveWords(status.drive) + " is " + status.axis.stateWord + ".\n");
    Json json = {{"status", toJson(status)}};
    if (activation != Activation::Deactivate) {
        const auto proof = session.compensator().prove(axis, proofSamples, session.operation());
        if (!proof && activation == Activation::Activate)
            environment.warn(
                "the compensation is on although it is not proved: axiscomp deactivate "
                "switches it off");
        if (!proof)
            return fail(proof.error());
        // Output and indices of a moment in which the compensation works.
        const int dimensions = status.table ? status.table->grid.dimensions() : 0;
        json["proof"] = toJson(*proof, dimensions);
        environment.print(activation == Activation::Activate
                ? "\nProof: what the drive adds is what the table says.\n"
                : "\nProof: the drive looks up where it should; it adds nothing while it "
                  "evaluates.\n");
        environment.print(proofText(*proof, status));
    }
    environment.document(json);
    return ExitCode::Done;
}

void addActivation(CommandLine& line, const std::string& name, const std::string& description,
    Activation activation)
{
    auto options = std::make_shared<DriveOptions>();
    options->command = commandName(name);
    CLI::App* command =
        line.add(name, driveCommands, description, [options, activation](Environment& environment) {
            return withAxis(environment, *options,
                [activation](Environment& sameEnvironment, CommandSession& session, int axis) {
                    return runActivation(sameEnvironment, session, activation, axis);
                });
        });
    addDriveOptions(*command, *options);
    addAxisOption(*command, *options);
}

} // namespace

void addActivationCommands(CommandLine& line)
{
    addActivation(line, "evaluate", "Let the drive look up the table without adding its values",
        Activation::Evaluate);
    addActivation(line, "activate",
        "Activate the compensation, and compare the drive's output with the table",
        Activation::Activate);
    addActivation(line, "deactivate", "Deactivate the compensation", Activation::Deactivate);
}

} // namespace axiscomp::app
