// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_link.h"

#include <chrono>
#include <functional>
#include <memory>
#include <span>
#include <stop_token>
#include <string>
#include <vector>

namespace axiscomp {

/// Makes a link from an endpoint ("http://192.168.1.20", "demo:"). Called on the thread that will
/// use the link.
using LinkFactory = std::function<Result<std::unique_ptr<DriveLink>>(const std::string& endpoint)>;

/// A place where a drive may be: a remembered address, or a port of this machine.
struct DriveCandidate {
    /// Tried one after the other until one answers: the same port at several speeds. Not empty.
    std::vector<std::string> endpoints;
    /// Of the port's hardware with its serial number: "FT232R USB UART, FTDI, A50285BI". May be
    /// empty.
    std::string description;
    std::chrono::milliseconds timeout{1000}; ///< for each endpoint
    /// Anything may answer there: it is asked for the list of its files first, and nothing else
    /// when it does not have one as a drive has it.
    bool isUnknown = false;

    friend bool operator==(const DriveCandidate&, const DriveCandidate&) = default;
};

/// What a candidate turned out to be.
struct DriveSighting {
    std::string endpoint; ///< the one that answered, or the one that the error is about
    std::string description; ///< as the candidate's
    Result<DriveIdentity> drive; ///< or why there is none
};

struct DriveSearch {
    LinkFactory linkFactory;
    std::stop_token stop; ///< what has not been asked by then is Cancelled
    std::size_t mostAtOnce = 16; ///< a computer may have dozens of ports
    /// Called for each sighting as it is made, from the searching threads, one call at a time.
    std::function<void(const DriveSighting&)> sighted;
};

/// Asks every candidate who it is, several at once, and sends nothing else than isUnknown says. One
/// sighting for each candidate, in their order.
[[nodiscard]] std::vector<DriveSighting> findDrives(
    std::span<const DriveCandidate> candidates, const DriveSearch& search);

} // namespace axiscomp
