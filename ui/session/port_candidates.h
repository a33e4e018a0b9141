// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_search.h"
#include "core/drive/network_range.h"

#include <functional>
#include <string>
#include <vector>

namespace axiscomp::ui {

/// The serial ports of this computer that none of the addresses names; at several baud rates when
/// asked for. Called on any thread.
using PortCandidates = std::function<std::vector<DriveCandidate>(
    const std::vector<std::string>& otherThan, bool anyBaudRate)>;

/// The search of a network; nothing is sent before the user has confirmed a range. Called on any
/// thread.
struct NetworkPlaces {
    /// Of this computer's own networks, as parseNetworkRange() takes them.
    std::function<std::vector<std::string>()> ownNetworks;
    /// Those of a range that none of the addresses names. Empty: networks are not searched.
    std::function<std::vector<DriveCandidate>(
        const NetworkRange& range, const std::vector<std::string>& otherThan)>
        candidates;
    std::size_t mostAtOnce = 32; ///< addresses that are asked at the same time
};

} // namespace axiscomp::ui
