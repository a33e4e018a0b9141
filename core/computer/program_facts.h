// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/computer/finding.h"
#include "core/computer/system_facts.h"

#include <string>
#include <vector>

namespace axiscomp {

/// What the program is made of, as far as it knows itself.
struct ProgramFacts {
    std::string version; ///< "0.1.0"
    std::string buildType; ///< "Release"
    std::string path; ///< of the program's file
    std::vector<LibraryVersion> libraries;
    std::string tls; ///< what https is spoken with: "OpenSSL 3.0.15"; empty: nothing
    std::string window; ///< path of the program with the window; empty: not installed
    bool drawsPdf = false; ///< what draws the PDF of a report is installed
};

[[nodiscard]] FindingSection programFindings(const ProgramFacts& facts);

} // namespace axiscomp
