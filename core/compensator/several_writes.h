// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/axis_compensator.h"

#include <span>

namespace axiscomp {

/// One of several writes that belong together: the columns of one file, each for an axis.
struct AxisWrite {
    int axis = 0;
    WriteRequest request;
};

/// The plan of each, so that nothing is begun that cannot be ended; changes nothing. A plan is made
/// as if it were the only one: two may name the same empty slot, and the second gets another one
/// when its turn comes. Errors: those of AxisCompensator::plan, their context names the axis
/// (`ofAxis`); InvalidArgument when an axis is named twice, and when all together cost more flash
/// operations than are possible now.
[[nodiscard]] Result<std::vector<WritePlan>> planSeveral(AxisCompensator& compensator,
    std::span<const AxisWrite> writes, const OperationOptions& options = {});

} // namespace axiscomp
