// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/result.h"
#include "core/text/number_text.h"

#include <string>
#include <utility>

namespace axiscomp {

inline auto badCurve(Text reason)
{
    return fail(ErrorCode::InvalidArgument, {{"reason", std::move(reason)}});
}

inline Quantity placeQuantity(double position, const std::string& unit)
{
    return {roundedText(position), unit};
}

} // namespace axiscomp
