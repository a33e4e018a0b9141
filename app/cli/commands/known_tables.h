// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/input/table_input.h"
#include "app/cli/session/command_session.h"
#include "core/metrology/fit/lookup_frame.h"
#include "core/metrology/fit/measured_state.h"

namespace axiscomp::app {

/// The tables of a file in the unit of the measurement, mm or deg. Notes say what is assumed of
/// units. Errors: those of reading the file, UnitMismatch.
[[nodiscard]] Result<KnownTables> tablesOfFile(
    Environment& environment, const TableInputOptions& options, const std::string& unit);

/// What an axis of a drive has to say of a measurement of it.
struct AxisTables {
    KnownTables active; ///< the table that the axis uses
    std::optional<LookupAt> lookupAt; ///< nothing: its source is no position that the profile knows
    std::string source; ///< the path of it
    std::vector<KnownTables> backups; ///< tables that it had before, newest first
};
/// Errors: NoTable, UnitMismatch, those of the link.
[[nodiscard]] Result<AxisTables> tablesOfAxis(
    Environment& environment, CommandSession& session, int axis, const std::string& unit);

} // namespace axiscomp::app
