// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/metrology/report/report_document.h"

#include <string_view>

namespace axiscomp::report {

/// "#1f4e8c". What can touch differs in lightness too.
[[nodiscard]] std::string_view inkColour(PlotInk ink);
/// Of an area of this ink, light enough for lines over it.
[[nodiscard]] std::string_view bandColour(PlotInk ink);

/// The corners of a marker.
[[nodiscard]] std::vector<PlotPoint> markerOutline(const PlotMarker& marker);

} // namespace axiscomp::report
