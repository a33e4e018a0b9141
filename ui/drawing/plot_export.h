// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/table/compensation_table.h"
#include "ui/drawing/picture_file.h"

#include <memory>
#include <string>
#include <vector>

class QCustomPlot;

namespace axiscomp::ui {

/// A plot as it is now, for a page. shown: the table of its map, if it has one.
[[nodiscard]] PictureDrawing drawingOf(
    QCustomPlot& plot, const std::shared_ptr<const CompensationTable>& shown);

/// Saves a table as the drive takes it as a calibration file with these notes, on another thread;
/// otherwise as savePicture.
[[nodiscard]] QFuture<QString> saveValues(std::shared_ptr<const CompensationTable> table,
    std::vector<std::string> notes, const QString& path);

} // namespace axiscomp::ui
