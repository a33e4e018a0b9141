// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_search.h"

#include <functional>
#include <string>
#include <vector>

namespace axiscomp::ui {

/// The serial ports of this computer that none of the addresses names; at several baud rates when
/// asked for. Called on any thread.
using PortCandidates = std::function<std::vector<DriveCandidate>(
    const std::vector<std::string>& otherThan, bool anyBaudRate)>;

} // namespace axiscomp::ui
