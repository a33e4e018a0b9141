// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_profile.h"
#include "core/drive/drive_search.h"
#include "ui/session/port_candidates.h"

#include <chrono>
#include <filesystem>

namespace axiscomp::ui {

/// What the program around the wizard gives it.
struct WizardOptions {
    LinkFactory linkFactory;
    PortCandidates portCandidates; ///< empty: drives are not looked for
    NetworkPlaces network;
    const DriveProfile* profile = nullptr; ///< must outlive the controller
    std::filesystem::path storeRoot;
    std::chrono::milliseconds timeout{5000};
    std::chrono::milliseconds liveInterval{100}; ///< 0: live values only on refreshLive()
    std::chrono::milliseconds reconnectInterval{2000};
};

} // namespace axiscomp::ui
