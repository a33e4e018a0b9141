// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/compensation_table.h"

#include <QFuture>
#include <QString>

#include <memory>

namespace axiscomp::ui {

class PlotCanvas;

/// Saves the picture (png, pdf; on white, as it goes into a report) or the values shown (csv, a
/// calibration file). The file is whole or the old one stays. The picture is drawn at once, coded
/// and written on another thread. Empty: done; otherwise a translated sentence.
[[nodiscard]] QFuture<QString> exportPlot(
    PlotCanvas& canvas, std::shared_ptr<const CompensationTable> shown, const QString& path);

} // namespace axiscomp::ui
