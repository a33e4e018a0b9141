// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace axiscomp::app {

/// The class Table, and the functions that make tables of a calibration file and back.
void addTables(pybind11::module_& module);

} // namespace axiscomp::app
