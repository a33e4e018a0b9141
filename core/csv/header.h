// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/csv/scan.h"

namespace axiscomp::csv {

struct Header {
    char separator = ',';
    std::vector<ColumnName> columns; ///< tables have a name, each its own
};

/// The name and the unit of a column: a text in brackets at its end, or a unit of length, angle or
/// temperature elsewhere: "X error (um)", "X error [um] (mean)", "x / mm", "X error in um"; the
/// brackets may be full-width.
[[nodiscard]] ColumnName columnName(std::string_view header);

/// The names and units of the columns of a header line as they stand there. None: it cannot be
/// used, and diagnostics say why.
[[nodiscard]] std::optional<Header> readColumnNames(
    std::string_view line, std::size_t lineNumber, Encoding encoding, DiagnosticList& diagnostics);

/// Reads the header line of a calibration file. None: it cannot be used, and diagnostics say why.
[[nodiscard]] std::optional<Header> readHeader(std::string_view line, std::size_t lineNumber,
    int dimensions, Encoding encoding, DiagnosticList& diagnostics);

/// With " (or is the dimensionality 2?)" behind it when there is such a dimensionality.
[[nodiscard]] Text withDimensionalityHint(Text expected, int dimensions);

} // namespace axiscomp::csv
