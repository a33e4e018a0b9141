// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/conversion/conversion.h"

namespace axiscomp {

/// Whether a file holds what the drive adds: those of its own formats do, but for values that a
/// person says to be of the command side.
[[nodiscard]] bool isOfDrive(const TableFormat& format, std::optional<SignConvention> stated);

/// Which of the two tables of a conversion the drive looks up at its set position. What it adds
/// there, c where the set position is the knot, is -c as a value of the command side, at the same
/// knot.
struct SetSides {
    bool source = false;
    bool target = false;

    [[nodiscard]] bool isSourceConverted() const { return source && !target; }
    [[nodiscard]] bool isTargetConverted() const { return target && !source; }
};

/// Errors: those of ConversionRequest::lookupAt.
[[nodiscard]] Result<SetSides> setSides(
    const NeutralTable& table, const ConversionRequest& request);

/// What is to be known of the file that is written; nothing where it is no file of the drive, or
/// nobody has to know.
[[nodiscard]] std::optional<LookupAt> lookupOfResult(
    const NeutralTable& table, const ConversionRequest& request);
/// The notes of that file.
[[nodiscard]] std::vector<std::string> notesOfResult(
    const NeutralTable& table, const ConversionRequest& request);

/// What has been assumed of it, or done, for the user. source: as it was taken for the conversion.
[[nodiscard]] std::optional<Text> lookupRemark(
    const NeutralTable& source, SetSides sides, const ConversionRequest& request);

/// The values of the other side: every sign is turned.
[[nodiscard]] NeutralTable withTurnedSigns(NeutralTable table, SignConvention sign);

} // namespace axiscomp
