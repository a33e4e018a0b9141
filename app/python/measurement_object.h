// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <pybind11/pybind11.h>

namespace axiscomp::app {

/// Functions that make arrays of a measurement's CSV and back.
void addMeasurements(pybind11::module_& module);

} // namespace axiscomp::app
