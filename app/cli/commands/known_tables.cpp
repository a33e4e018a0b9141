// SPDX-License-Identifier: GPL-3.0-or-later
#include "app/cli/commands/known_tables.h"

#include "app/cli/input/conversion_options.h"
#include "app/cli/output/status_text.h"
#include "app/common/number_text.h"
#include "core/store/drive_store.h"

namespace axiscomp::app {

namespace {

void note(Environment& environment, const std::vector<Text>& remarks)
{
    for (const Text& remark : remarks)
        environment.console().note("note: " + remark.english());
}

} // namespace

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
    note(environment, known.remarks);
    return std::move(known.tables);
}

Result<AxisTables> tablesOfAxis(
    Environment& environment, CommandSession& session, int axis, const std::string& unit)
{
    AXISCOMP_TRY(const auto settled, settledStatus(environment, session, axis));
    AXISCOMP_TRY(auto table, session.compensator().readTable(axis, session.operation()));
    const DriveStore store(session.storeRoot());
    AXISCOMP_TRY(auto tables,
        axiscomp::tablesOfAxis(
            axisOfDrive(settled.status), std::move(table), session.profile(), store, unit));
    note(environment, tables.remarks);
    for (const Error& error : tables.unreadable)
        environment.warn(sentence(error));
    return tables;
}

} // namespace axiscomp::app
