// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/computer/finding.h"
#include "core/computer/folder_facts.h"
#include "core/computer/system_facts.h"

#include <optional>
#include <string>
#include <vector>

namespace axiscomp {

/// All that is looked at beside the state folder, the ports and the drives.
struct ComputerFacts {
    SystemFacts system;
    ClockFacts clock;
    DisplayFacts display;
    LocaleFacts locale;
    FolderFacts temporary;
    std::optional<FolderFacts> runtime{}; ///< none: XDG_RUNTIME_DIR is not set
    std::vector<std::string> proxies{}; ///< names of variables
};
[[nodiscard]] ComputerFacts computerFacts();

[[nodiscard]] FindingSection systemFindings(const ComputerFacts& facts);
/// languages: those that the program has, "en", "de"
[[nodiscard]] FindingSection languageFindings(
    const LocaleFacts& facts, const std::vector<std::string>& languages);

/// What keeps this user from using a folder that should be there, or soon will; nothing: it can be
/// used. variable: the one that can name another folder.
[[nodiscard]] std::optional<Finding> folderObstacle(
    const Text& name, const FolderFacts& facts, const std::string& variable);

} // namespace axiscomp
