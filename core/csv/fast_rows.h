// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/csv/cells.h"
#include "core/csv/columns.h"

namespace axiscomp::csv {

/// Reads data lines as programs write them, without quotes and blanks, into the piece. Stops before
/// the first line that is anything else, after `until`, before the last characters of the text
/// (end), or when the piece has maximumRows. Returns where it stopped, at the beginning of a line.
/// Reports nothing: what it does not take is for the thorough reader.
[[nodiscard]] const char* readPlainRows(Piece& piece, const CellFormat& format, const char* begin,
    const char* until, const char* end, std::size_t maximumRows);

} // namespace axiscomp::csv
