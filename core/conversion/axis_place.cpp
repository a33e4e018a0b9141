// SPDX-License-Identifier: GPL-3.0-or-later
#include "core/conversion/axis_place.h"

namespace axiscomp {

bool dependsOnPlace(const Error& refusal)
{
    return refusal.code == ErrorCode::TargetNotKnown
        || refusal.code == ErrorCode::SignNotConvertible
        || refusal.code == ErrorCode::FormatCannotHold; // uneven knots
}

} // namespace axiscomp
