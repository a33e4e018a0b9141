// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace axiscomp::test {

/// A public measurement, with figures and outliers that are known (docs/metrology.md):
/// "ess_mcu1025" ...
[[nodiscard]] inline QString publicMeasurement(const char* name)
{
    return QStringLiteral(AXISCOMP_SOURCE_FOLDER "/tests/data/metrology/%1.csv")
        .arg(QLatin1StringView(name));
}

} // namespace axiscomp::test
