// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/input/table_input.h"
#include "app/cli/output/environment.h"
#include "core/conversion/conversion.h"

#include <CLI/App.hpp>

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace axiscomp::app {

/// What the user says about a conversion between formats, common to all commands that may need one.
struct ConversionOptions {
    std::string command; ///< "axiscomp convert": for hints
    std::string sign; ///< of the input; empty: as its format says
    std::string toSign; ///< of the output
    std::vector<std::string> targets; ///< what the columns correct; empty: as the file says
    StatedUnits units; ///< of the input, in place of those that it states
    std::optional<LookupAt> lookupAt; ///< of the table of the drive; nothing: as its file says
    std::string direction; ///< mean, positive, negative; empty: as it is
    std::vector<std::size_t> points; ///< of the even grid, one for each source or one for all
    std::vector<double> distances; ///< likewise
    std::optional<double> within; ///< the deviation to keep
    std::string method = "linear";
    std::optional<double> speed; ///< in positions per second
    bool holdsEnds = false; ///< a grid may go beyond the data
    bool dropsWrap = false;
    Adjustment adjustment;
    std::vector<std::string> settings; ///< KEY=VALUE of the output

    [[nodiscard]] bool resamples() const
    {
        return !points.empty() || !distances.empty() || within.has_value();
    }
    /// The options that were given and that not even files of the same format go without, such as
    /// --target; in place of --sign it may be the file that says it.
    [[nodiscard]] std::vector<std::string> given() const;
    [[nodiscard]] bool isAnything() const { return !given().empty(); }
};

void addTargetOption(CLI::App& command, ConversionOptions& options);
/// --target, --sign, --direction, --no-wrap, --scale, --offset, --zero
void addConversionOptions(CLI::App& command, ConversionOptions& options);
/// --points, --distance, --within, --method, --hold
void addResamplingOptions(CLI::App& command, ConversionOptions& options);
/// --to-sign, --set-out
void addOutputOptions(CLI::App& command, ConversionOptions& options);

/// dimensions: of the tables. Errors: InvalidArgument.
[[nodiscard]] Result<ConversionRequest> conversionRequest(const ConversionOptions& options,
    const TableFormat& from, const TableFormat& to, std::size_t dimensions);

/// --lookup-at
CLI::Option* addLookupOption(CLI::App& command, std::string& lookupAt, std::string help);
void addLookupOption(CLI::App& command, std::string& lookupAt); ///< of a conversion

/// With the sign that the file says of itself (core/neutral/sign_note.h). Errors: InvalidArgument
/// where another one is stated.
[[nodiscard]] Result<ConversionOptions> withSignOfFile(
    const TableInput& input, ConversionOptions options);

/// Whether a file holds what the drive adds (core/conversion/lookup_sides.h).
[[nodiscard]] bool isOfDrive(const TableInput& input, const ConversionOptions& options);

/// The table that a drive shall have, from a file of any format.
struct DriveTable {
    CompensationTable table;
    std::optional<LookupAt> lookupAt; ///< where it has to be looked up, as far as that is known
    std::optional<std::int32_t> measuredDrive; ///< as WriteRequest has it
    std::vector<std::string> report; ///< of the conversion, for standard error
};
/// One column, converted where the format is another controller's or something was asked for.
/// Errors: those of the choice and of the conversion.
[[nodiscard]] Result<DriveTable> driveTable(const TableInput& input,
    const TableInputOptions& inputOptions, const ConversionOptions& options);
void noteReport(Environment& environment, const std::vector<std::string>& report);
/// Of a .TAMtbl that is written as it is: what its notes state and such a file does not
/// (core/conversion/unheld_notes.h). before: each of them, such as the name of the file.
[[nodiscard]] Result<void> noteUnheld(
    Environment& environment, std::string_view before, std::span<const std::string> notes);

} // namespace axiscomp::app
