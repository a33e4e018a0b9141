// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/conversion/conversion.h"

namespace axiscomp {

/// Which of the two tables of a conversion the drive looks up at its set position. Not both: then
/// nothing has to be converted. What it adds there, c where the set position is the knot, is -c as
/// a value of the command side, at the same knot.
struct SetSides {
    bool source = false;
    bool target = false;
};

/// Errors: those of ConversionRequest::lookupAt.
[[nodiscard]] Result<SetSides> setSides(
    const NeutralTable& table, const ConversionRequest& request);

/// What the file that is written says of it; nothing where it is no file of the drive, or nobody
/// has to know.
[[nodiscard]] std::optional<LookupAt> lookupOfResult(
    const NeutralTable& table, const ConversionRequest& request);

/// What has been assumed of it, or done, for the user. source: as it was taken for the conversion.
[[nodiscard]] std::optional<Text> lookupRemark(
    const NeutralTable& source, SetSides sides, const ConversionRequest& request);

/// The values of the other side: every sign is turned.
[[nodiscard]] NeutralTable withTurnedSigns(NeutralTable table, SignConvention sign);

} // namespace axiscomp
