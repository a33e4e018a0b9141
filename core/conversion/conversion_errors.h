// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/neutral/table_motion.h"

#include <span>
#include <utility>

namespace axiscomp {

inline auto invalidArgument(Text reason)
{
    return fail(ErrorCode::InvalidArgument, {{"reason", std::move(reason)}});
}

inline auto resamplingImpossible(Text reason)
{
    return fail(ErrorCode::ResamplingImpossible, {{"reason", std::move(reason)}});
}

inline auto notConvertible(const NeutralTable& table, std::span<const double> position, Text reason)
{
    return fail(ErrorCode::SignNotConvertible,
        {{"position", positionText(table, position)}, {"reason", std::move(reason)}});
}

} // namespace axiscomp
