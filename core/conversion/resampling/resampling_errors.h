// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"

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

} // namespace axiscomp
