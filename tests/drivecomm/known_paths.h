// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/drive/drive_link.h"

#include <chrono>
#include <string>

namespace axiscomp::test {

/// Registers and files of the generic profile, spelled out: a test sees it when one changes.
inline const std::string tableOfX = "Axes[0]/Parameters/Compensations/Axis/Table";
inline const std::string source1OfX = "Axes[0]/Parameters/Compensations/Axis/Dim1Source";
inline const std::string activationOfX = "Axes[0]/Commands/Compensations/Axis/Activation";
inline const std::string stateOfX = "Axes[0]/Signals/Compensations/Axis/State";
inline const std::string stateOfY = "Axes[1]/Signals/Compensations/Axis/State";
inline const std::string masterX = "Axes[0]/Signals/PositionController/MasterPosition";
inline const std::string variable0 = "Application/Variables/Floats[0]";
inline const std::string variable1 = "Application/Variables/Floats[1]";
inline const std::string small1 = "tables/small1.TAMtbl";
inline const std::string large1 = "tables/large1.TAMtbl";

inline Exchange within(std::chrono::milliseconds timeout)
{
    Exchange exchange;
    exchange.timeout = timeout;
    return exchange;
}

} // namespace axiscomp::test
