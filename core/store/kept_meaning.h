// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/table_units.h"

#include <optional>
#include <string>

namespace axiscomp {

/// What the numbers of a table mean beside themselves: in which units they are, and of which axis.
/// Of what is empty nothing is known.
struct KeptMeaning {
    TableUnits units;
    std::string axisName;
};

/// Why numbers no longer mean what they meant when they were kept.
struct MeaningChange {
    bool isOtherAxis = false; ///< by the names (areDifferentAxes)
    std::optional<UnitChange> unit = {};
};
[[nodiscard]] MeaningChange changedMeaning(const KeptMeaning& kept, const KeptMeaning& now);
[[nodiscard]] bool isMeantAsKept(const KeptMeaning& kept, const KeptMeaning& now);

} // namespace axiscomp
