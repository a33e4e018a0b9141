// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_status.h"
#include "core/axis/register_access.h"
#include "core/axis/source_directory.h"
#include "core/axis/state_words.h"

namespace axiscomp {

[[nodiscard]] Result<std::vector<AxisInfo>> readAxes(
    const RegisterAccess& access, const DriveIdentity& drive);

/// unfinishedWrite is left empty. Errors: NoCompensation; ChangedMeanwhile when somebody else keeps
/// changing the axis while it is read.
[[nodiscard]] Result<AxisStatus> readStatus(
    const RegisterAccess& access, const DriveIdentity& drive, int axis, SourceDirectory& sources);

/// What a table that looks up the position of an axis has to fit to.
struct PositionFacts {
    std::string name; ///< of the axis, may be empty
    std::string unit; ///< the drive's PositionUnit; empty: the drive does not say
    std::optional<Travel> travel; ///< none: the drive does not say
};
[[nodiscard]] Result<PositionFacts> readPositionFacts(const RegisterAccess& access, int axis);

/// Of all axes, in their order; "" where an axis has none.
[[nodiscard]] Result<std::vector<std::string>> readAxisNames(
    const RegisterAccess& access, const DriveIdentity& drive);

[[nodiscard]] Error compensationActive(const AxisStatus& status);

/// The same, with more registers that are read at the same instant; those that the drive does not
/// have are left out.
struct StatusReading {
    AxisStatus status;
    Readings readings;
};
[[nodiscard]] Result<StatusReading> readStatusWith(const RegisterAccess& access,
    const DriveIdentity& drive, int axis, SourceDirectory& sources,
    const std::vector<std::string>& more);

/// Table and DimSources of an axis as they are now: what a write switches and a roll-back puts
/// back.
[[nodiscard]] Result<std::vector<RegisterWrite>> readAxisRegisters(
    const RegisterAccess& access, int axis);
/// The same registers with the values that a setup asks for.
[[nodiscard]] std::vector<RegisterWrite> axisRegisters(
    const RegisterAccess& access, int axis, const CompensationSetup& setup);

/// The header of the table in a slot; none when the slot is empty.
[[nodiscard]] std::optional<TableHeader> headerFrom(
    const RegisterAccess& access, const Readings& readings, std::string_view slot);
[[nodiscard]] std::vector<std::string> headerPaths(
    const RegisterAccess& access, std::string_view slot);

} // namespace axiscomp
