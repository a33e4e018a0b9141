// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/conversion/resampling/resampling_errors.h"
#include "core/neutral/table_motion.h"

#include <span>
#include <utility>

namespace axiscomp {

inline auto notConvertible(const NeutralTable& table, std::span<const double> position, Text reason)
{
    return fail(ErrorCode::SignNotConvertible,
        {{"position", positionText(table, position)}, {"reason", std::move(reason)}});
}

} // namespace axiscomp
