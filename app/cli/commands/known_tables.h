// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/input/table_input.h"
#include "app/cli/session/command_session.h"
#include "core/compensator/known_tables.h"

namespace axiscomp::app {

/// The tables of a file in the unit of the measurement, mm or deg. Notes say what is assumed of
/// units. Errors: those of reading the file, UnitMismatch.
[[nodiscard]] Result<KnownTables> tablesOfFile(
    Environment& environment, const TableInputOptions& options, const std::string& unit);

/// What an axis of a drive has to say of a measurement of it. Errors: NoTable, UnitMismatch, those
/// of the link.
[[nodiscard]] Result<AxisTables> tablesOfAxis(
    Environment& environment, CommandSession& session, int axis, const std::string& unit);

} // namespace axiscomp::app
