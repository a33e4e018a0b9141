// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/computer/finding.h"
#include "core/computer/folder_facts.h"
#include "core/store/store_condition.h"

#include <optional>
#include <string>
#include <vector>

namespace axiscomp {

/// The state folder, and what is in it. condition: none where it could not be looked at, for want
/// of a folder for the copy.
[[nodiscard]] FindingSection storeFindings(
    const FolderFacts& folder, const std::optional<StoreCondition>& condition, WallTime now);

} // namespace axiscomp
