// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <QString>

namespace axiscomp {
struct MeasurementFormat;
struct TableFormat;
} // namespace axiscomp

namespace axiscomp::ui {

/// For a file dialog: everything that can be read, one entry for each format, and all files.
[[nodiscard]] QString openFilter();
/// The same for the files of measurements.
[[nodiscard]] QString measurementFilter();
/// "runs: CSV with a line for each value", in the language of the window.
[[nodiscard]] QString measurementFormatText(const MeasurementFormat& format);
/// The one entry of a format that is written.
[[nodiscard]] QString saveFilter(const TableFormat& format);
/// "softMC (Danaher, Servotronix, Kollmorgen): text table ...", in the language of the window.
[[nodiscard]] QString formatText(const TableFormat& format);
/// ".txt": the usual extension of a format.
[[nodiscard]] QString extensionOf(const TableFormat& format);

} // namespace axiscomp::ui
