// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/output/drive_json.h"
#include "app/cli/output/status_text.h"
#include "app/cli/session/command_session.h"
#include "core/compensator/axis_compensator.h"
#include "core/compensator/drive_record.h"
#include "core/io/local_file.h"

namespace axiscomp::app {

namespace {

/// What the drive does now that the proof has failed.
void noteState(Environment& environment, const Activation& activation)
{
    if (!activation.isPutBack)
        environment.warn("the compensation is on although it is not proved: axiscomp deactivate "
                         "switches it off");
    else if (activation.status.isOn())
        environment.console().note("note: the drive evaluates again, as before");
    else
        environment.console().note("note: the compensation was switched off again");
}

/// The drive may have switched before it was lost.
void noteUnknown(Environment& environment, const Error& error)
{
    if (!error.context.contains("compensation"))
        return;
    environment.console().clearProgress();
    environment.warn("the compensation may be on, and is not proved: `axiscomp status` says what "
                     "it does, `axiscomp deactivate` switches it off");
}

void printProof(Environment& environment, const Activation& activation)
{
    if (const auto why = activation.notProved()) {
        environment.print("\nNot proved.\n");
        environment.warn("nothing is proved: " + why->english());
    } else {
        environment.print("\n" + proofSentence(**activation.proof) + "\n");
    }
}

struct ActivationOptions {
    DriveOptions drive;
    std::string record; ///< that notes the proof
};

Result<ExitCode> runActivation(Environment& environment, CommandSession& session, Switch wanted,
    const std::string& recordFile, int axis)
{
    const auto before = wanted == Switch::Deactivate ? shownStatus(environment, session, axis)
                                                     : settledStatus(environment, session, axis);
    if (!before)
        return fail(before.error());
    if (wanted == Switch::Activate)
        AXISCOMP_CHECK(checkMayActivate(*before));
    CalibrationRecord record;
    if (!recordFile.empty()) {
        AXISCOMP_TRY(record, loadRecord(pathFromText(recordFile)));
        AXISCOMP_CHECK(checkRecordTable(record, before->status, session.profile()));
    }
    const auto switched =
        session.compensator().switchTo(axis, wanted, proofSamples, session.operation());
    if (!switched) {
        noteUnknown(environment, switched.error());
        return fail(switched.error());
    }
    const Activation& activation = *switched;
    const AxisStatus& status = activation.status;
    environment.console().clearProgress();
    if (activation.proof && !*activation.proof) {
        noteState(environment, activation);
        return fail(activation.proof->error());
    }
    environment.report("The compensation of " + axisWords(status.axis) + " of "
        + driveWords(status.drive) + " is " + status.axis.stateWord + ".\n");
    Json json = {{"status", toJson(status)}};
    if (activation.proof) {
        const Proof& proof = **activation.proof;
        // Output and indices of a moment in which the compensation works.
        const int dimensions = status.table ? status.table->grid.dimensions() : 0;
        json["proof"] = toJson(proof, dimensions);
        printProof(environment, activation);
        environment.print(proofText(proof, status));
        if (!recordFile.empty()) {
            AXISCOMP_CHECK(recordProof(record, status, proof, session.profile()));
            AXISCOMP_CHECK(saveRecord(pathFromText(recordFile), record));
            if (!record.write->proof)
                environment.console().note("note: the record has no proof yet");
        }
    }
    environment.document(json);
    return ExitCode::Done;
}

void addActivation(
    CommandLine& line, const std::string& name, const std::string& description, Switch wanted)
{
    auto options = std::make_shared<ActivationOptions>();
    options->drive.command = commandName(name);
    CLI::App* command =
        line.add(name, driveCommands, description, [options, wanted](Environment& environment) {
            return withAxis(environment, options->drive,
                [options, wanted](Environment& sameEnvironment, CommandSession& session, int axis) {
                    return runActivation(sameEnvironment, session, wanted, options->record, axis);
                });
        });
    addDriveOptions(*command, options->drive);
    addAxisOption(*command, options->drive);
    if (wanted == Switch::Activate)
        command
            ->add_option("--record", options->record,
                AXISCOMP_HELP("Help",
                    "Record of the compensation (axiscomp write --record), which notes the proof"))
            ->option_text("FILE.axcal");
}

} // namespace

void addActivationCommands(CommandLine& line)
{
    addActivation(line, "evaluate",
        AXISCOMP_HELP("Help", "Let the drive look up the table without adding its values"),
        Switch::Evaluate);
    addActivation(line, "activate",
        AXISCOMP_HELP(
            "Help", "Activate the compensation, and compare the drive's output with the table"),
        Switch::Activate);
    addActivation(line, "deactivate", AXISCOMP_HELP("Help", "Deactivate the compensation"),
        Switch::Deactivate);
}

} // namespace axiscomp::app
