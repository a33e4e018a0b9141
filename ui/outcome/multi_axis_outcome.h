// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/compensator/multi_axis_write.h"
#include "ui/outcome/outcome_text.h"
#include "ui/session/axis_entry.h"

#include <span>

namespace axiscomp::ui {

/// What writing to several axes has come to: which of them were written, or, where one has failed,
/// which hold the new state and which the old one. axes: in the order of the writes.
[[nodiscard]] Outcome multiAxisOutcome(
    std::span<const AxisEntry> axes, const Result<MultiAxisReport>& report);

/// Why several writes cannot be planned or begun; begins with the name of the axis that it is
/// about. axes: entries of the drive.
[[nodiscard]] QString multiAxisErrorText(const Error& error, std::span<const AxisEntry> axes);

} // namespace axiscomp::ui
