// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <nlohmann/json.hpp>

namespace axiscomp::app {

/// A document of --json: its members stay in the order in which they are written.
using Json = nlohmann::ordered_json;

} // namespace axiscomp::app
