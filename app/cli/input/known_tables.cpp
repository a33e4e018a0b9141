// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/input/known_tables.h"

#include "app/cli/input/conversion_options.h"
#include "app/common/arguments.h"

namespace axiscomp::app {

namespace {

/// What was active has one value for both directions, as a drive has.
Result<void> checkOneValue(const TableInputOptions& options, const TableInput& input)
{
    if (input.data)
        return {};
    for (const NeutralTable& table : neutralColumns(input))
        for (const CompensationColumn& column : table.columns)
            if (column.direction != Direction::Both)
                return wrongUsage(displayName(options.file)
                        + " has a value for each direction, and residuals are merged onto a table "
                          "with one for both: write that into a file (axiscomp convert "
                        + displayName(options.file) + " mean.csv --direction mean), and take it",
                    options.command);
    return {};
}

} // namespace

Result<KnownTables> tablesOfFile(Environment& environment, const TableInputOptions& options,
    const std::string& unit, std::optional<LookupAt> lookupAt)
{
    AXISCOMP_TRY(const auto profile, profileOf(options.profile));
    AXISCOMP_TRY(const auto input, readInput(environment, options));
    AXISCOMP_CHECK(checkOneValue(options, input));
    CalibrationData data;
    if (input.data) {
        data = *input.data;
    } else {
        ConversionOptions conversion;
        conversion.lookupAt = lookupAt;
        AXISCOMP_TRY(auto made, driveTable(input, options, conversion));
        noteReport(environment, made.report);
        data = {made.table.grid, {made.table}, {}};
    }
    const std::string name =
        displayName(environment.nameOf(options.file)); // notes and records keep it
    AXISCOMP_TRY(auto known, axiscomp::tablesOfFile(name, data, unit, profile.layout, lookupAt));
    noteRemarks(environment, known.remarks);
    return std::move(known.tables);
}

void noteRemarks(Environment& environment, const std::vector<Text>& remarks)
{
    for (const Text& remark : remarks)
        environment.console().note("note: " + remark.english());
}

} // namespace axiscomp::app
