// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/table/grid.h"

#include <string>

namespace axiscomp {

/// Whether a drive shows a table over these positions in its header registers. They may be of
/// single precision, and what the drive does not show (NaN, the size 0) is not compared.
[[nodiscard]] bool isShownAs(const Grid& shown, const Grid& grid);

/// That the drive reads the table in a slot as the layout of the profile has it: CRCs and bytes fit
/// where two fields of the layout are exchanged, too. byLayout: what was written, or decoded.
/// Errors: the code, with `layout`, slot, dimension, found, expected.
[[nodiscard]] Result<void> checkShownGrid(
    ErrorCode code, const std::string& slot, const Grid& shown, const Grid& byLayout);

} // namespace axiscomp
