// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/input/known_tables.h"

#include "app/cli/input/conversion_options.h"

namespace axiscomp::app {

Result<KnownTables> tablesOfFile(
    Environment& environment, const TableInputOptions& options, const std::string& unit)
{
    AXISCOMP_TRY(const auto profile, profileOf(options.profile));
    AXISCOMP_TRY(const auto input, readInput(environment, options));
    std::vector<CompensationTable> tables;
    if (input.data) {
        tables = input.data->tables;
    } else {
        AXISCOMP_TRY(auto table, driveTable(environment, input, options, {}));
        tables.push_back(std::move(table));
    }
    AXISCOMP_TRY(auto known,
        axiscomp::tablesOfFile(displayName(options.file), std::move(tables), unit, profile.layout));
    noteRemarks(environment, known.remarks);
    return std::move(known.tables);
}

void noteRemarks(Environment& environment, const std::vector<Text>& remarks)
{
    for (const Text& remark : remarks)
        environment.console().note("note: " + remark.english());
}

} // namespace axiscomp::app
