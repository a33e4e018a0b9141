// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/output/drive_json.h"
#include "app/cli/output/machine_output.h"
#include "app/cli/output/status_text.h"
#include "app/cli/output/write_text.h"
#include "app/cli/session/machine_run.h"
#include "app/common/number_text.h"
#include "app/common/text_table.h"
#include "core/machine/machine_texts.h"

#include <algorithm>
#include <memory>
#include <span>

namespace axiscomp::app {

namespace {

std::string placeOf(const MachineDriveRun& drive)
{
    return drive.endpoint + " (serial number " + std::to_string(drive.wanted.serialNumber) + ")";
}

/// None where there is no plan.
std::span<const AxisPlan> plannedAxes(const MachineDriveRun& drive)
{
    return drive.plan ? std::span<const AxisPlan>(drive.plan->axes) : std::span<const AxisPlan>();
}

/// One line of its own for each thing that stands in the way; the code of the first is the
/// program's.
class Problems {
public:
    explicit Problems(Environment& environment) : m_environment(environment) { }

    void add(const std::string& place, const Error& error) { m_environment.tell(error, place); }
    [[nodiscard]] ExitCode code() const
    {
        const auto& first = m_environment.told();
        return first ? exitCode(first->code) : ExitCode::Done;
    }

private:
    Environment& m_environment;
};

/// What differs, drive by drive, and all axes in one table.
void printPlans(Environment& environment, const MachineRun& run)
{
    TextTable table({"drive", ">serial number", "axis", "state", "address"});
    for (const MachineDriveRun& drive : run.drives) {
        if (!drive.plan) {
            table.add({"", std::to_string(drive.wanted.serialNumber), "",
                drive.isMissing() ? "does not answer" : "problem", drive.endpoint});
            continue;
        }
        for (const AxisPlan& axis : drive.plan->axes) {
            if (!axis.problem && !axis.plan.changes.empty())
                environment.print(planText(axis.plan, axis.before.axis) + "\n");
            table.add({drive.plan->drive.name, std::to_string(drive.plan->drive.serialNumber),
                axis.name, differenceText(axis).english(), drive.endpoint});
        }
    }
    environment.print(table.text(""));
}

void noteWarnings(Environment& environment, const MachineRun& run)
{
    for (const MachineDriveRun& drive : run.drives)
        for (const AxisPlan& axis : plannedAxes(drive)) {
            const std::string place = placeOf(drive) + ", axis " + axis.name + ": ";
            if (!axis.isWarned())
                continue;
            for (const Text& remark : axis.plan.unitRemarks)
                environment.console().note("note: " + place + remark.english());
            for (const Text& warning : axis.plan.warnings)
                environment.warn(place + warning.english());
            for (const Text& large : axis.plan.largeCorrections)
                environment.warn(place + large.english());
        }
}

std::string placeOf(const MachineDriveRun& drive, const PlanProblem& problem)
{
    return placeOf(drive)
        + (problem.axis ? ", axis " + drive.plan->axes[*problem.axis].name : std::string());
}

/// Drives and axes of which nothing is known.
void addProblems(Environment& environment, const MachineOptions& options, const MachineRun& run,
    Problems& problems)
{
    std::vector<const DriveLook*> looks;
    for (const MachineDriveRun& drive : run.drives)
        looks.push_back(&drive);
    const bool allowsMissing = options.allowsMissing && doesAnyAnswer(looks);
    for (const MachineDriveRun& drive : run.drives) {
        if (drive.isMissing() && allowsMissing)
            environment.warn(
                placeOf(drive) + " is left out: " + singleLine(sentence(*drive.problem)));
        for (const PlanProblem& problem : drive.problems(allowsMissing))
            if (!problem.isObstacle)
                problems.add(placeOf(drive, problem), problem.error);
    }
}

/// What is known to differ and cannot be written now.
template <typename Report> void forEachObstacle(const MachineRun& run, Report report)
{
    for (const MachineDriveRun& drive : run.drives)
        for (const PlanProblem& problem : drive.problems(true))
            if (problem.isObstacle)
                report(placeOf(drive, problem), problem.error);
}

void planAndShow(
    Environment& environment, const MachineOptions& options, MachineRun& run, Problems& problems)
{
    planMachine(environment, options, run);
    printPlans(environment, run);
    noteWarnings(environment, run);
    addProblems(environment, options, run, problems);
}

Json runJson(const MachineOptions& options, const MachineRun& run)
{
    Json drives = Json::array();
    for (const MachineDriveRun& drive : run.drives) {
        Json axes = Json::array();
        for (std::size_t n = 0; drive.plan && n < drive.plan->axes.size(); ++n) {
            axes.push_back(toJson(drive.plan->axes[n]));
            if (n < drive.outcomes.size())
                axes.back()["outcome"] = toJson(drive.outcomes[n]);
        }
        drives.push_back({{"endpoint", drive.endpoint}, {"serialNumber", drive.wanted.serialNumber},
            {"drive", drive.plan ? Json(drive.plan->drive.name) : Json(nullptr)},
            {"axes", std::move(axes)},
            {"problem", drive.problem ? toJson(*drive.problem, Json::array()) : Json(nullptr)}});
    }
    return {{"file", options.file}, {"name", run.name}, {"differs", run.differs()},
        {"drives", std::move(drives)}};
}

Result<ExitCode> runPlan(Environment& environment, const MachineOptions& options)
{
    AXISCOMP_TRY(auto run, beginMachineRun(environment, options));
    const QtRuntime runtime;
    Problems problems(environment);
    planAndShow(environment, options, run, problems);
    forEachObstacle(run, [&](const std::string& place, const Error& error) {
        environment.warn(place + ": this cannot be written now: " + sentence(error));
    });
    environment.document(runJson(options, run));
    if (problems.code() != ExitCode::Done)
        return problems.code();
    return run.differs() ? ExitCode::Differs : ExitCode::Done;
}

void printOutcomes(Environment& environment, const MachineRun& run)
{
    TextTable table({"drive", ">serial number", "axis", "outcome", "table", "compensation"});
    for (const MachineDriveRun& drive : run.drives)
        for (std::size_t n = 0; n < drive.outcomes.size(); ++n) {
            const AxisOutcome& outcome = drive.outcomes[n];
            table.add({drive.plan->drive.name, std::to_string(drive.plan->drive.serialNumber),
                drive.plan->axes[n].name, outcomeText(outcome).english(),
                outcome.now ? heldText(*outcome.now).english() : "not known",
                outcome.now ? outcome.now->axis.stateWord : "not known"});
        }
    environment.report("\n" + table.text(""));
}

/// As `activate` says it of one axis.
void tellProofs(Environment& environment, const MachineRun& run)
{
    for (const MachineDriveRun& drive : run.drives)
        for (std::size_t n = 0; n < drive.outcomes.size(); ++n) {
            const auto& activation = drive.outcomes[n].activation;
            if (!activation || !activation->proof || !*activation->proof)
                continue;
            const std::string place = placeOf(drive) + ", axis " + drive.plan->axes[n].name + ": ";
            if (const auto why = activation->notProved())
                environment.warn(place + "nothing is proved: " + why->english());
            else
                environment.print(place + proofSentence(**activation->proof) + "\n");
        }
}

void addFailures(const MachineRun& run, Problems& problems)
{
    for (const MachineDriveRun& drive : run.drives) {
        if (drive.plan && drive.problem)
            problems.add(placeOf(drive), *drive.problem);
        for (std::size_t n = 0; n < drive.outcomes.size(); ++n)
            if (drive.outcomes[n].problem)
                problems.add(placeOf(drive) + ", axis " + drive.plan->axes[n].name,
                    *drive.outcomes[n].problem);
    }
}

Result<ExitCode> runApply(Environment& environment, const MachineOptions& options)
{
    AXISCOMP_TRY(auto run, beginMachineRun(environment, options));
    const QtRuntime runtime;
    Problems problems(environment);
    planAndShow(environment, options, run, problems);
    forEachObstacle(
        run, [&](const std::string& place, const Error& error) { problems.add(place, error); });
    if (problems.code() != ExitCode::Done) {
        environment.console().note("note: nothing was written");
        environment.document(runJson(options, run));
        return problems.code();
    }
    // Whoever watches reads the plan before it is carried out.
    static_cast<void>(environment.console().flush());
    applyMachine(environment, options, run);
    printOutcomes(environment, run);
    tellProofs(environment, run);
    addFailures(run, problems);
    environment.document(runJson(options, run));
    if (problems.code() != ExitCode::Done)
        environment.console().note(
            "note: the same command does again what failed, and continues with what was not "
            "written; the rest is there already");
    return problems.code();
}

void addMachineOptions(CLI::App& command, MachineOptions& options)
{
    command.add_option("FILE", options.file, AXISCOMP_HELP("Help", "Machine file (.toml)"))
        ->required();
    addConnectionOptions(command, options.drive);
    command
        .add_option("--only", options.only,
            AXISCOMP_HELP("Help",
                "Only this axis, as the file names it, or SERIAL/AXIS for that of one drive; may "
                "be "
                "given several times"))
        ->option_text("AXIS");
    constexpr int mostJobs = 256;
    command
        .add_option("--jobs", options.jobs,
            AXISCOMP_HELP("Help", "Drives at the same time (16 unless given)"))
        ->option_text("N")
        ->check(CLI::Range(1, mostJobs));
    command.add_flag("--allow-missing", options.allowsMissing,
        AXISCOMP_HELP("Help", "Leave drives out that do not answer, which is an error otherwise"));
}

} // namespace

void addMachineCommands(CommandLine& line)
{
    auto plan = std::make_shared<MachineOptions>();
    plan->drive.command = commandName("plan");
    CLI::App* command = line.add("plan", driveCommands,
        AXISCOMP_HELP(
            "Help", "Compare the drives of a machine with its machine file, and change nothing"),
        [plan](Environment& environment) { return runPlan(environment, *plan); });
    addMachineOptions(*command, *plan);
    command->footer(AXISCOMP_HELP("Help",
        "The exit code is 0 when all drives have what the file says, and 9 when something "
        "differs.") "\n\n" AXISCOMP_HELP("Help", "Example:") "\n  axiscomp plan machine.toml");

    auto apply = std::make_shared<MachineOptions>();
    apply->drive.command = commandName("apply");
    command = line.add("apply", driveCommands,
        AXISCOMP_HELP("Help",
            "Write what a machine file says to the drives of the machine, where they differ"),
        [apply](Environment& environment) { return runApply(environment, *apply); });
    addMachineOptions(*command, *apply);
    command->add_flag("--activate", apply->activates,
        AXISCOMP_HELP("Help",
            "Switch the compensation of axes on and off where the file says so (active), and prove "
            "it"));
    command->footer(AXISCOMP_HELP("Help",
        "All drives are planned first, and nothing is written unless all of it is "
        "possible. Each write is safe as that of `axiscomp write`. A second apply finds "
        "nothing to do.") "\n\n" AXISCOMP_HELP("Help",
        "Example:") "\n  axiscomp apply machine.toml --activate");
}

} // namespace axiscomp::app
