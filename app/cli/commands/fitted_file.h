// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "app/cli/input/conversion_options.h"
#include "app/cli/output/environment.h"
#include "app/cli/output/output_file.h"
#include "core/drive/drive_profile.h"
#include "core/metrology/fit/measurement_fit.h"

namespace axiscomp::app {

struct FittedFileOptions {
    Output output;
    std::string to; ///< format; empty: by the name
    std::string table; ///< the one column that is written; empty: all
    bool acceptsLarge = false;
    ConversionOptions conversion; ///< target, sign and settings of the output
    bool isComputed = false; ///< as in ConversionRequest
    std::optional<double> turn; ///< of a modulo axis, which other controllers' tables may be for
};

/// The format that the options name, and that it can be written there. Meant to be asked before the
/// work is done. Errors: UnknownFormat, InvalidArgument.
[[nodiscard]] Result<const TableFormat*> fittedFormat(
    Environment& environment, const FittedFileOptions& options);

/// What the values correct, as a person states it: one statement for all tables or one for each.
/// Errors: those of withTargets.
[[nodiscard]] Result<void> stateTargets(
    const std::vector<std::string>& statements, std::vector<FittedTable>& fitted);

/// Writes the tables, converted as `convert` does it where the format is another controller's.
/// A table for each direction belongs into a format that holds both: FormatCannotHold. Other
/// errors: TableNotFound, InvalidArgument, LargeCorrection, those of convertTables, and
/// FileNotWritable.
[[nodiscard]] Result<void> writeFitted(Environment& environment, const FittedFileOptions& options,
    const TableFormat& format, const DriveProfile& profile, const std::vector<FittedTable>& fitted,
    std::vector<std::string> notes);

} // namespace axiscomp::app
