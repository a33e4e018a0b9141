// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/csv/scan.h"

namespace axiscomp::csv {

struct CellFormat {
    char separator = ',';
    char decimal = '\0'; ///< '\0' while no number of the file has decimals
};

/// Reads data lines as programs write them, without quotes and blanks, into scan.rows. Stops before
/// the first line that is anything else, after `until`, before the last characters of the text, or
/// when scan.rows has maximumRows. Returns where it stopped, at the beginning of a line. Reports
/// nothing: what it does not take is for the thorough reader.
[[nodiscard]] const char* readPlainRows(Scan& scan, const CellFormat& format, const char* begin,
    const char* until, const char* end, std::size_t maximumRows);

} // namespace axiscomp::csv
