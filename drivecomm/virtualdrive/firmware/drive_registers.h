// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <string_view>

/// Registers and enum values that the virtual drive has and a DriveProfile does not name, since the
/// program finds them by itself (DimSource candidates) or never uses them. The only place where
/// they are spelled.
namespace axiscomp::drivecomm::registers {

inline constexpr std::string_view masterPosition =
    "Axes[{axis}]/Signals/PositionController/MasterPosition";
inline constexpr std::string_view encoderPosition =
    "Axes[{axis}]/Signals/PositionController/Encoders[{n}]/Position";
/// With the output of the compensation: what the position loop holds. This project's own.
inline constexpr std::string_view actualPosition =
    "Axes[{axis}]/Signals/PositionController/ActualPosition";
inline constexpr std::string_view setPosition = "Axes[{axis}]/Signals/PathPlanner/Position";
inline constexpr std::string_view motorTemperature =
    "Axes[{axis}]/Signals/General/MotorTemperature";
inline constexpr std::string_view applicationVariables = "Application/Variables/Floats[{n}]";
inline constexpr std::string_view applicationParameters = "Application/Parameters/Floats[{n}]";
inline constexpr int applicationFloats = 256;

/// This project's own: after a reboot somebody must be able to home an axis.
inline constexpr std::string_view homingCommand = "Axes[{axis}]/Commands/Homing/Command";
inline constexpr std::string_view homingStart = "Start";

/// Of a virtual machine: what the measuring instrument says of the axis's true position, and the
/// program of the machine's control. This project's own.
inline constexpr std::string_view referencePosition = "Machine/Axes[{axis}]/ReferencePosition";
inline constexpr std::string_view programCommand = "Machine/Program/Command";
inline constexpr std::string_view programStart = "Start";

inline constexpr std::string_view idle = "Idle";

} // namespace axiscomp::drivecomm::registers
