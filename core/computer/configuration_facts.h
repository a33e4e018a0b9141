// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/computer/finding.h"

#include <optional>
#include <string>
#include <vector>

namespace axiscomp {

/// The settings of the window, which are a file.
struct WindowSettings {
    std::string file;
    enum class State {
        Missing, ///< the window was never used
        Readable,
        Unreadable, ///< for this user, or no file
        Malformed,
    };
    State state = State::Missing;
    std::vector<std::string> drives{}; ///< addresses as they stand there
};

/// What decides how drives are asked, and which.
struct ConfigurationFacts {
    WindowSettings window;
    std::string profileFile; ///< empty: the built-in one
    std::string profile; ///< its name; empty: it is wrong
    std::optional<Error> profileError{};
    std::vector<std::string> certificates{}; ///< addresses whose certificates are trusted
};

[[nodiscard]] FindingSection configurationFindings(const ConfigurationFacts& facts);

} // namespace axiscomp
