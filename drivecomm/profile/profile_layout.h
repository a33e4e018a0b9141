// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/io/strict_json.h"
#include "core/table/table_layout.h"

namespace axiscomp::drivecomm {

/// The table layout of a profile, not yet checked as a whole (checkLayout). What is wrong is
/// recorded in the node's document.
[[nodiscard]] TableLayout readTableLayout(const JsonNode& node);

} // namespace axiscomp::drivecomm
