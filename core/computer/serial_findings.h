// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/computer/finding.h"
#include "core/io/device_access.h"

#include <string>
#include <vector>

namespace axiscomp {

struct SerialPortFacts {
    std::string device; ///< "/dev/ttyUSB0"
    std::string description; ///< of its hardware; may be empty
    std::string usbId; ///< "0403:6001"; empty: built in
    DeviceAccess access;
};

[[nodiscard]] FindingSection serialFindings(const std::vector<SerialPortFacts>& ports);

} // namespace axiscomp
