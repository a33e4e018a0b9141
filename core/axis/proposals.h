// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_status.h"
#include "core/base/error.h"
#include "core/base/text.h"
#include "core/drive/drive_profile.h"
#include "core/table/compensation_table.h"

#include <functional>
#include <optional>
#include <span>
#include <vector>

/// What the names and units in a file propose for a drive, and what they speak against. A proposal
/// is for a person to accept: nothing is written because of one.
namespace axiscomp {

/// What there is to propose on a drive.
struct DriveRegisters {
    const DriveProfile& profile;
    std::span<const DimSource> sources; ///< the profile's shortlist, those that the drive has
    std::span<const AxisInfo> axes;
};

/// The register by which a table is looked up at the position of an axis: the first one of the
/// shortlist that is a position of it, and not one after the compensation. Unset: there is none.
[[nodiscard]] DimSource positionSource(const DriveRegisters& drive, int axis);

/// One per dimension of the grid of a table for an axis, unset where nothing speaks for a register:
/// the position of the axis that the column is named after, where their units suit; a temperature
/// for a column of temperatures, that of the axis itself before others; in 1D, where the column is
/// named after no axis, the position of the axis itself. No register is proposed twice.
[[nodiscard]] std::vector<DimSource> proposedSources(
    const DriveRegisters& drive, int axis, const Grid& grid);

struct SourceDoubt {
    Text text; ///< a sentence
    std::optional<Error> refusal = {}; ///< SourceMismatch; none: it may be right all the same
};

/// What speaks against looking a column of positions up by this source: positions by a temperature,
/// temperatures by a position, the column of one axis by the position of another one. dimension
/// 1, 2, 3; isStated: a person says that the column is right, whatever it is called; nameOf: the
/// name of an axis, which may be empty; othersOf: the names of all axes but this, asked for only
/// where a name may be among them. Nothing: as far as one can tell it is right.
[[nodiscard]] std::optional<SourceDoubt> sourceDoubt(const DriveProfile& profile,
    const GridAxis& column, std::size_t dimension, const DimSource& source, bool isStated,
    const std::function<std::string(int axis)>& nameOf,
    const std::function<std::vector<std::string>(int axis)>& othersOf);

/// An index on the drive; none: the column is not written.
using AxisChoice = std::optional<int>;

/// One choice per table. A table is proposed for the axis whose name it has, or that name and
/// "error" ("X error"), whatever the letters' case; an axis is proposed once, and the exact name
/// comes first. An axis whose name another one has too is not proposed.
[[nodiscard]] std::vector<AxisChoice> proposedAxes(
    std::span<const CompensationTable> tables, std::span<const AxisInfo> axes);

/// The table that is proposed for an axis; none: no name says so.
[[nodiscard]] std::optional<std::size_t> proposedTable(
    std::span<const CompensationTable> tables, std::span<const AxisInfo> axes, int axis);

} // namespace axiscomp
