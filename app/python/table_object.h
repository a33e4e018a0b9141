// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/compensation_table.h"

#include <pybind11/pybind11.h>

#include <memory>
#include <string>
#include <vector>

namespace axiscomp::app {

/// Arrays that show its values keep it alive; nothing changes it.
struct TableObject {
    CompensationTable table;
    /// Comments of the file, which say for which side of the compensation a fit made the table.
    std::vector<std::string> notes;
};
using TablePointer = std::shared_ptr<TableObject>;

/// The class Table, and the functions that make tables of a calibration file and back.
void addTables(pybind11::module_& module);

} // namespace axiscomp::app
