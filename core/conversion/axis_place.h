// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/base/error.h"
#include "core/neutral/lookup_note.h"

#include <optional>
#include <string>

namespace axiscomp {

/// What an axis of the drive is to the sources of its table.
struct AxisPlace {
    std::string target; ///< which of them it is (core/drive/axis_target.h); empty: not known
    std::optional<LookupAt> lookupAt; ///< on which side of the compensation they are

    friend bool operator==(const AxisPlace&, const AxisPlace&) = default;
};

/// What of a place the numbers of tables are made for.
struct UsedPlace {
    bool target = false;
    bool lookupAt = false;

    /// Whether they were others, made for the one place and for the other.
    [[nodiscard]] bool differs(const AxisPlace& one, const AxisPlace& other) const
    {
        return (target && one.target != other.target)
            || (lookupAt && one.lookupAt != other.lookupAt);
    }
};

/// Whether a conversion that was refused may be possible for another place.
[[nodiscard]] bool dependsOnPlace(const Error& refusal);

} // namespace axiscomp
