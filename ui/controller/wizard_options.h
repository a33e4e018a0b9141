// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/capture/capture_request.h"
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
    /// Opens an instrument on a serial port; empty: there are none. Called on a drive's thread, and
    /// what it gives is used and destroyed there.
    InstrumentFactory instrumentFactory;
    /// By which captured values are timed, see CaptureClock.
    std::function<std::chrono::nanoseconds()> captureClock = timeSinceStart;
    std::chrono::milliseconds captureInterval{50}; ///< between two readings of a capture
    std::filesystem::path storeRoot;
    std::chrono::milliseconds timeout{5000};
    std::chrono::milliseconds liveInterval{100}; ///< 0: live values only on refreshLive()
    std::chrono::milliseconds reconnectInterval{2000};
};

} // namespace axiscomp::ui
