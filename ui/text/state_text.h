// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/axis/axis_status.h"
#include "ui/style/contrast.h"

#include <QDateTime>
#include <QString>

namespace axiscomp::ui {

// The words for the state of an axis, wherever it is shown.

/// "ACTIVE"; a word of the drive that its profile does not have is shown as it is.
[[nodiscard]] QString stateWord(const AxisInfo& axis);
/// "NOT CONNECTED"
[[nodiscard]] QString notConnectedWord();
[[nodiscard]] Tone stateTone(CompensationState state);
/// "14:03:12"
[[nodiscard]] QString clockText(const QDateTime& time);
/// "since 14:03:12"
[[nodiscard]] QString sinceText(const QDateTime& time);
/// "as read at 14:03:12"
[[nodiscard]] QString asReadText(const QDateTime& time);
/// "no table"
[[nodiscard]] QString noTableText();
/// "first, CRC 1A2B3C4D"
[[nodiscard]] QString tableWithCrc(const QString& name, std::uint32_t crc);

} // namespace axiscomp::ui
