// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "core/formats/table_format.h"
#include "core/text/diagnostic.h"
#include "core/text/token_scanner.h"

#include <span>

namespace axiscomp {

/// What a reader of a text has at hand.
struct TextReading {
    std::string_view text; ///< is text, and not empty
    const TableReadOptions& options;
    const SettingValues& settings;
    DiagnosticList& diagnostics;

    [[nodiscard]] bool isStopped() const { return options.stop.stop_requested(); }
    /// An error that the controller has a number for.
    void error(std::string_view number, DiagnosticCode code, std::size_t line, std::size_t column,
        Text found, Text expected);
};

/// A warning for each axis that several tables of a file correct, over different sources or over
/// the same in the same direction, where the controller adds them: one alone is a part of what acts
/// on the machine.
void warnOfAddedTables(std::span<const NeutralTable> tables, DiagnosticList& diagnostics);

/// A warning for a statement that switches tables of the file off, or deletes them.
void warnOfSwitchedOff(const Token& statement, DiagnosticList& diagnostics);

/// Reads a text with a format's own `parse`, whose tables count unless there was an error or a
/// stop. What every reader does round it: settings, binary and oversized files, problems. Errors:
/// InvalidArgument (settings).
[[nodiscard]] Result<TableReading> readText(const FormatFacts& facts, std::string_view text,
    const TableReadOptions& options, std::vector<NeutralTable> (*parse)(TextReading&));

} // namespace axiscomp
