// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/command_line.h"
#include "app/cli/output/drive_json.h"
#include "app/cli/output/status_text.h"
#include "app/cli/session/command_session.h"
#include "app/cli/session/drive_search.h"
#include "app/common/arguments.h"
#include "app/common/text_table.h"
#include "core/base/parallel.h"

namespace axiscomp::app {

namespace {

struct AxesOfDrive {
    std::string endpoint; ///< without a password
    DriveIdentity drive;
    Result<std::vector<AxisInfo>> axes;
};

AxesOfDrive ask(Environment& environment, const DriveOptions& options, const std::string& endpoint)
{
    AxesOfDrive answer{shownEndpoint(endpoint), {}, {}};
    auto session = CommandSession::open(environment, options, endpoint);
    if (!session) {
        answer.axes = fail(session.error());
        return answer;
    }
    const auto drive = (*session)->compensator().identify((*session)->operation());
    if (!drive) {
        answer.axes = fail(drive.error());
        return answer;
    }
    answer.drive = *drive;
    answer.axes = (*session)->compensator().axes((*session)->operation());
    return answer;
}

/// All drives at once: one that does not answer must not make the others wait. Each session lives
/// on a thread of its own.
std::vector<AxesOfDrive> askAll(Environment& environment, const DriveOptions& options)
{
    std::vector<AxesOfDrive> answers(options.endpoints.size());
    forEachAtOnce(answers.size(), answers.size(),
        [&](std::size_t i) { answers[i] = ask(environment, options, options.endpoints[i]); });
    return answers;
}

std::string axesText(const std::vector<AxesOfDrive>& answers)
{
    TextTable table(
        {"drive", ">serial number", ">axis", "name", "unit", "homing", "compensation", "address"});
    for (const AxesOfDrive& answer : answers) {
        if (!answer.axes)
            continue;
        for (const AxisInfo& axis : *answer.axes)
            table.add({answer.drive.name, std::to_string(answer.drive.serialNumber),
                std::to_string(axis.index), axis.name, axis.unit, axis.homingWord,
                axis.stateWord.empty() ? "not available" : axis.stateWord, answer.endpoint});
    }
    return table.text("");
}

Json axesJson(const std::vector<AxesOfDrive>& answers)
{
    Json drives = Json::array();
    for (const AxesOfDrive& answer : answers) {
        Json json = {{"endpoint", answer.endpoint}};
        if (answer.axes) {
            json["drive"] = answer.drive.name;
            json["serialNumber"] = answer.drive.serialNumber;
            json["axes"] = Json::array();
            for (const AxisInfo& axis : *answer.axes)
                json["axes"].push_back(toJson(axis));
        } else {
            json["error"] = toJson(answer.axes.error(), Json::array());
        }
        drives.push_back(std::move(json));
    }
    return {{"drives", std::move(drives)}};
}

struct AxesOptions {
    DriveOptions drives;
    bool find = false;
    bool anyBaudRate = false;
    std::string network;
};

/// Asks the drives that the options name for their axes and prints them; silent: where a search
/// found none.
Result<ExitCode> listAxes(Environment& environment, const DriveOptions& options,
    const std::vector<AxesOfDrive>& silent = {})
{
    const std::vector<AxesOfDrive> answers = askAll(environment, options);
    environment.console().clearProgress();
    if (answers.size() == 1 && !answers.front().axes)
        return fail(answers.front().axes.error());

    environment.print(axesText(answers));
    Json json = axesJson(answers);
    Json places = axesJson(silent);
    for (Json& place : places["drives"])
        json["drives"].push_back(std::move(place));
    environment.document(json);
    ExitCode code = ExitCode::Done;
    for (const AxesOfDrive& answer : answers) {
        if (answer.axes)
            continue;
        environment.tell(answer.axes.error());
        code = exitCode(environment.told()->code);
    }
    return environment.interrupt().stopped() ? ExitCode::Stopped : code;
}

/// Those given, or else those of the window.
std::vector<std::string> namedDrives(const AxesOptions& options)
{
    return options.drives.endpoints.empty() ? rememberedDrives() : options.drives.endpoints;
}

Result<ExitCode> runAxes(Environment& environment, const AxesOptions& options)
{
    DriveOptions drives = options.drives;
    drives.endpoints = namedDrives(options);
    SearchedPlaces places;
    if (options.anyBaudRate)
        places.rates = drivecomm::BaudRates::Usual;
    if (!options.network.empty()) {
        auto range = parseNetworkRange(options.network);
        if (!range)
            return wrongUsage(sentence(range.error()), options.drives.command);
        places.network = *range;
    }
    const QtRuntime runtime;
    if (options.find) {
        AXISCOMP_TRY(const auto sightings, lookForDrives(environment, drives, places));
        drives.endpoints.clear();
        std::vector<AxesOfDrive> silent;
        for (const DriveSighting& sighting : sightings) {
            if (sighting.drive)
                drives.endpoints.push_back(sighting.endpoint);
            else
                silent.push_back(
                    {shownEndpoint(sighting.endpoint), {}, fail(sighting.drive.error())});
        }
        return listAxes(environment, drives, silent);
    }
    if (drives.endpoints.empty())
        return wrongUsage("the drive is missing: give --drive http://host, set AXISCOMP_DRIVE, or "
                          "look for drives with --find",
            options.drives.command);
    return listAxes(environment, drives);
}

} // namespace

void addAxesCommand(CommandLine& line)
{
    auto options = std::make_shared<AxesOptions>();
    options->drives.command = commandName("axes");
    CLI::App* command = line.add("axes", driveCommands,
        AXISCOMP_HELP("Help", "List the axes of one or several drives"),
        [options](Environment& environment) { return runAxes(environment, *options); });
    addDriveOptions(*command, options->drives, DriveCount::Several);
    CLI::Option* find = command->add_flag("--find", options->find,
        AXISCOMP_HELP("Help",
            "Also try all serial ports of this computer; without --drive, the connections of the "
            "window too"));
    command
        ->add_flag("--any-baud", options->anyBaudRate,
            AXISCOMP_HELP("Help", "Try the usual baud rates at every serial port"))
        ->needs(find);
    command
        ->add_option("--network", options->network,
            AXISCOMP_HELP("Help",
                "Also ask these addresses over http: 192.168.1.0/24, 192.168.1.10-40 or one "
                "address, "
                "at most 1024, with :PORT for another port than 80"))
        ->option_text("RANGE")
        ->needs(find);
}

} // namespace axiscomp::app
