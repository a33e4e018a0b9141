// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/table_format.h"
#include "core/text/diagnostic.h"

namespace axiscomp {

// Formats of one axis that corrects itself: nothing in them names an axis, and the position and the
// correction, which the controller adds to it, have one unit, which they do not say either.

/// Reading: the unit is what position-unit or value-unit says, or a warning that nobody says it;
/// a Contradiction when they say different units. stated: the unit that the file itself says; a
/// Contradiction when a setting says another one.
void takeOneUnit(NeutralTable& table, const SettingValues& settings, DiagnosticList& diagnostics,
    std::string_view stated = {});

/// Writing: the table as such a format holds it, without names, in the unit of the settings or
/// else that of its positions, which is added to remarks. Errors: those of checkOwnAxis;
/// InvalidArgument for units that cannot be converted.
[[nodiscard]] Result<NeutralTable> asOwnAxisTable(const FormatFacts& facts,
    const NeutralTable& table, const SettingValues& settings, std::vector<Text>& remarks);

} // namespace axiscomp
