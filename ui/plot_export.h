// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/grid.h"

#include <QString>

class QCustomPlot;

namespace axiscomp::ui {

/// Saves the picture (png, pdf) or the values shown (csv, a calibration file). The file is whole or
/// the old one stays. Empty: done; otherwise a translated sentence.
[[nodiscard]] QString exportPlot(
    QCustomPlot& plot, const CompensationTable& shown, const QString& path);

} // namespace axiscomp::ui
