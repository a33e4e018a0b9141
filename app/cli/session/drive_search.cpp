// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/session/drive_search.h"

#include "app/cli/input/table_input.h"
#include "app/common/text_table.h"
#include "drivecomm/link/drive_endpoint.h"
#include "drivecomm/link_factory.h"

#include <QFileInfo>
#include <QSettings>

#include <algorithm>

namespace axiscomp::app {

namespace {

constexpr std::size_t mostEndpoints = 64;
constexpr qsizetype longestEndpoint = 4096;

std::string answerText(const Result<DriveIdentity>& drive)
{
    if (!drive)
        return sentence(drive.error());
    return drive->name + ", serial number " + std::to_string(drive->serialNumber)
        + ", axes: " + std::to_string(drive->axes);
}

std::vector<DriveCandidate> candidates(const DriveOptions& options, const SearchedPlaces& places)
{
    std::vector<DriveCandidate> all;
    for (const std::string& endpoint : options.endpoints)
        all.push_back(drivecomm::candidateAt(endpoint, places.rates));
    for (DriveCandidate& port :
        drivecomm::candidatesAt(drivecomm::serialPorts(), options.endpoints, places.rates))
        all.push_back(std::move(port));
    if (places.network)
        std::ranges::move(
            drivecomm::candidatesIn(*places.network, options.endpoints), std::back_inserter(all));
    return all;
}

/// Leaves out the addresses of a network where nothing answers, and says how many they are.
void dropSilent(const std::vector<DriveCandidate>& candidates,
    std::vector<DriveSighting>& sightings, Console& console)
{
    std::vector<DriveSighting> answered;
    for (std::size_t i = 0; i < sightings.size(); ++i) {
        const Result<DriveIdentity>& drive = sightings[i].drive;
        const bool isSilent =
            candidates[i].isUnknown && !drive && isUnreachable(drive.error().code);
        if (!isSilent)
            answered.push_back(std::move(sightings[i]));
    }
    if (const std::size_t silent = sightings.size() - answered.size(); silent > 0)
        console.note("addresses of the network without an answer: " + std::to_string(silent));
    sightings = std::move(answered);
}

} // namespace

std::string shownEndpoint(const std::string& endpoint)
{
    const auto parsed = drivecomm::parseEndpoint(endpoint);
    return parsed ? drivecomm::displayText(*parsed) : "";
}

Result<std::vector<DriveSighting>> lookForDrives(
    Environment& environment, const DriveOptions& options, const SearchedPlaces& searched)
{
    AXISCOMP_TRY(const auto profile, profileOf(options.profile));
    const std::vector<DriveCandidate> places = candidates(options, searched);
    DriveSearch search;
    if (searched.network)
        search.mostAtOnce = drivecomm::addressesAtOnce;
    search.stop = environment.stopToken();
    search.linkFactory = drivecomm::linkFactory(profile, certificateCheck(options));
    std::vector<DriveSighting> sightings = findDrives(places, search);
    if (environment.stopToken().stop_requested())
        return fail(ErrorCode::Cancelled);
    dropSilent(places, sightings, environment.console());
    TextTable table({"address", "port", "answer"});
    for (const DriveSighting& sighting : sightings)
        table.add(
            {shownEndpoint(sighting.endpoint), sighting.description, answerText(sighting.drive)});
    if (!sightings.empty())
        environment.console().note(table.text(""));
    if (std::ranges::none_of(
            sightings, [](const auto& sighting) { return sighting.drive.has_value(); }))
        return fail(ErrorCode::NotConnected,
            {{"endpoint", Verbatim{"any drive"}},
                {"reason",
                    places.empty() ? "this computer has no serial port, and no address was given"
                                   : "none of the places looked at ("
                            + std::to_string(places.size()) + ") has one that answers"}});
    return sightings;
}

WindowSettings windowSettings()
{
    // As the window writes them (tests/app compares).
    const QSettings settings(
        QStringLiteral("axiscomp"), QStringLiteral("axis-compensation-wizard"));
    WindowSettings window{settings.fileName().toStdString(), WindowSettings::State::Missing};
    for (const QString& endpoint :
        settings.value(QStringLiteral("compensationWizard/endpoints")).toStringList())
        if (endpoint.size() <= longestEndpoint && window.drives.size() < mostEndpoints)
            window.drives.push_back(endpoint.toStdString());
    const QFileInfo file(settings.fileName());
    if (!file.exists())
        return window;
    window.state = !file.isFile() || !file.isReadable() ? WindowSettings::State::Unreadable
        : settings.status() == QSettings::FormatError   ? WindowSettings::State::Malformed
                                                        : WindowSettings::State::Readable;
    return window;
}

std::vector<std::string> rememberedDrives()
{
    return windowSettings().drives;
}

} // namespace axiscomp::app
