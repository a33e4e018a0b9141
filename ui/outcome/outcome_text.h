// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/axis_operations.h"

#include <QString>

namespace axiscomp::ui {

/// What an operation has come to, in a translated sentence that says what the drive holds now.
struct Outcome {
    QString text;
    bool isError = false;
    QString detail; ///< for the log
    bool isWarning = false; ///< nothing has failed, but the axis is not as it should be
};

[[nodiscard]] Outcome writeOutcome(const Result<WriteReport>& report);
[[nodiscard]] Outcome activationOutcome(Switch wanted, const Result<Activation>& activation);
/// What the proof of an axis that was switched has shown, or that it has shown nothing, and why
/// (Activation::notProved); empty: there is none, or it has failed.
[[nodiscard]] QString proofText(const Activation& activation);
[[nodiscard]] Outcome restorationOutcome(const Result<Restoration>& restoration);
[[nodiscard]] Outcome settledOutcome(const SettledWrite& settled);
/// Of finishing or undoing a write that did not end.
[[nodiscard]] Outcome recoveryOutcome(bool finishes, const Result<WriteReport>& report);
/// Of a drive that does not add what its table says, while it is active.
[[nodiscard]] Outcome movingProofFailure(const Error& error);
/// Of an operation that changes nothing.
[[nodiscard]] Outcome errorOutcome(const Error& error);

} // namespace axiscomp::ui
