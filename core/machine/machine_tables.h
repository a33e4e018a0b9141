// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/conversion/axis_place.h"
#include "core/machine/machine_file.h"
#include "core/metrology/fit/lookup_frame.h"
#include "core/table/compensation_table.h"
#include "core/table/table_layout.h"

#include <cstdint>
#include <filesystem>
#include <optional>
#include <stop_token>
#include <vector>

namespace axiscomp {

/// The table of one axis of a machine, from its file.
struct MachineTable {
    std::filesystem::path file;
    /// As WriteRequest has it. none: the axis shall have no table, or `isOpen`.
    std::optional<CompensationTable> table;
    /// Its sources have to be known first, which the drive says: read again with its place.
    bool isOpen = false;
    std::optional<LookupAt> lookupAt = {}; ///< as WriteRequest has it
    std::optional<std::int32_t> measuredDrive = {}; ///< likewise
    std::vector<Diagnostic> problems; ///< of the file, warnings too
    std::vector<Text> report; ///< of its conversion
    std::optional<Error> problem; ///< why there is no table
};

/// Reads the file of an axis and takes the column that the axis names. folder: of the machine
/// file. place: nothing: not known yet. Takes long.
[[nodiscard]] MachineTable readMachineTable(const MachineAxis& axis,
    const std::filesystem::path& folder, const TableLayout& layout,
    const std::optional<AxisPlace>& place, const std::stop_token& stop = {});

/// The same for every axis of every drive of a machine, in their order, several at the same time;
/// the places of the axes are not known yet. Takes long.
[[nodiscard]] std::vector<std::vector<MachineTable>> readMachineTables(const MachineFile& machine,
    const std::filesystem::path& folder, const TableLayout& layout,
    const std::stop_token& stop = {});

} // namespace axiscomp
