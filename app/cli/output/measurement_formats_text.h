// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/output/json.h"
#include "core/metrology/formats/measurement_format.h"

#include <string>

namespace axiscomp::app {

// The facts of the measurement formats in words, for `axiscomp formats --measurements` and
// docs/measurement-formats.md.

[[nodiscard]] std::string measurementFormatsList();
[[nodiscard]] std::string measurementFormatText(const MeasurementFormat& format);
/// The page docs/measurement-formats.md.
[[nodiscard]] std::string measurementFormatsPage();
[[nodiscard]] Json measurementFormatJson(const MeasurementFormat& format);

} // namespace axiscomp::app
