// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/axis_operations.h"

#include <string>
#include <string_view>

namespace axiscomp::app {

/// "axis 0 (X)"
[[nodiscard]] std::string axisWords(const AxisInfo& axis);
/// "Virtual-1 (serial number 100001)"
[[nodiscard]] std::string driveWords(const DriveIdentity& drive);
/// Table, compensation and sources of an axis, for people.
[[nodiscard]] std::string statusText(const AxisStatus& status, const DriveProfile& profile);
/// "7 operations possible now"
[[nodiscard]] std::string budgetWords(const FlashBudget& budget);
/// What the flash of the drive has gone through, one line.
[[nodiscard]] std::string flashText(const FlashUse& use);
/// What a proof has shown, and over how much of the table; of one that something is proved by
/// (Activation::notProved).
[[nodiscard]] std::string proofSentence(const Proof& proof);
/// The figures of a proof, one line per sample.
[[nodiscard]] std::string proofText(const Proof& proof, const AxisStatus& status);

/// What a step of the compensator (Progress::step) does, in words; an unknown one is its own word.
[[nodiscard]] std::string stepWords(std::string_view step);

/// "Old", "New", "NewUnsaved", "Neither", "Unknown"
[[nodiscard]] std::string_view outcomeName(AxisCompensator::UnfinishedOutcome outcome);
/// "another program is writing to axis 0 (X) at this moment"
[[nodiscard]] std::string beingWritten(const AxisInfo& axis);
/// Sentences for people about it, and about what can be done.
[[nodiscard]] std::string outcomeSentence(const SettledWrite& settled);

} // namespace axiscomp::app
