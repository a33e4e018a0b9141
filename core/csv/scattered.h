// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/csv/scan.h"

namespace axiscomp::csv {

/// Whether the positions of the rows so far make more points than a file may have rows: whatever
/// follows, a grid would miss some. Never of one dimension, nor where a tolerance would make them a
/// grid. That is reported.
[[nodiscard]] bool isScattered(
    const Scan& scan, double snap, std::size_t maximumRows, DiagnosticList& diagnostics);

} // namespace axiscomp::csv
