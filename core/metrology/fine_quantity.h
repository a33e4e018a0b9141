// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/text.h"

namespace axiscomp {

/// A value in mm or deg as people see it: in um or arcsec, with 3 digits behind the point.
[[nodiscard]] Quantity fineQuantity(double value, bool isAngular);
/// A position in mm or deg, to a nanometre, or 1e-7 deg.
[[nodiscard]] Quantity placeOf(double position, bool isAngular);

} // namespace axiscomp
