// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/drive/drive_search.h"

#include "core/base/parallel.h"

#include <mutex>
#include <optional>

namespace axiscomp {

namespace {

Result<DriveIdentity> ask(
    const std::string& endpoint, const DriveCandidate& candidate, const DriveSearch& search)
{
    if (search.stop.stop_requested())
        return fail(ErrorCode::Cancelled);
    AXISCOMP_TRY(const auto link, search.linkFactory(endpoint));
    const Exchange exchange{.timeout = candidate.timeout, .stop = search.stop, .progress = {}};
    if (candidate.isUnknown)
        AXISCOMP_CHECK(link->listFiles(exchange));
    return link->identify(exchange);
}

/// Whether the port may still answer at another speed: it is there and may be used, but what came
/// back was nothing, or nonsense.
bool mayAnswerOtherwise(const Error& error)
{
    return error.code == ErrorCode::Timeout || error.code == ErrorCode::Protocol;
}

DriveSighting look(const DriveCandidate& candidate, const DriveSearch& search)
{
    std::optional<DriveSighting> best;
    for (const std::string& endpoint : candidate.endpoints) {
        DriveSighting sighting{endpoint, candidate.description, ask(endpoint, candidate, search)};
        if (sighting.drive || !mayAnswerOtherwise(sighting.drive.error()))
            return sighting;
        // Nonsense says more than silence: something is there.
        const bool isNonsense = sighting.drive.error().code == ErrorCode::Protocol;
        if (!best || (isNonsense && best->drive.error().code != ErrorCode::Protocol))
            best = std::move(sighting);
    }
    return std::move(*best);
}

} // namespace

std::vector<DriveSighting> findDrives(
    std::span<const DriveCandidate> candidates, const DriveSearch& search)
{
    std::vector<DriveSighting> sightings(
        candidates.size(), DriveSighting{{}, {}, fail(ErrorCode::Cancelled)});
    std::mutex reporting;
    forEachAtOnce(candidates.size(), search.mostAtOnce, [&](std::size_t row) {
        sightings[row] = look(candidates[row], search);
        const std::lock_guard lock(reporting);
        if (search.sighted)
            search.sighted(sightings[row]);
    });
    return sightings;
}

} // namespace axiscomp
