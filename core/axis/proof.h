// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_reader.h"

namespace axiscomp {

/// The end-to-end proof (DESIGN.md): the drive's own output and indices against core's lookup in
/// the table that the drive holds, at the sources that the drive reports with them. Finds mistakes
/// of sign, unit and element order. table: as downloaded from the drive, or the one that was to be
/// written.
[[nodiscard]] Result<Proof> proveAxis(const DriveAccess& access, const AxisStatus& status,
    const CompensationTable& table, int samples);

} // namespace axiscomp
