// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

#include <string>

/// What the tests of writes look for.
namespace axiscomp::test {

inline const QString written =
    QStringLiteral("Written and verified: the drive holds the new state.");
inline const QString oldState = QStringLiteral("The drive holds the complete old state.");
inline const std::string tableX = "Axes[0]/Parameters/Compensations/Axis/Table";

} // namespace axiscomp::test
